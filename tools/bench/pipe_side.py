"""The other side of the renderers' speed table: the same scene by OpenGL on the processor.

One idea: the same triangles, light and highlights at every pixel, and soft shadows go through
Mesa's llvmpipe with two threads, without a window; a frame ends when its pixels are finished. Balls
are triangles of one colour, without numbers or stripes, which is less than our renderers draw.
It prints JSON lines; where OpenGL or moderngl is missing, one line that says what.
"""

from __future__ import annotations

import json
import os
import sys
from importlib import import_module
from time import perf_counter
from typing import Any

import numpy as np

from engine.scene.shape import Mesh, sphere_mesh
from tools.bench.table_scene import GRADIENT, RADIUS, SIZES, TableScene

FRAMES, LEAD = 120, 8
FAR = 50.0
VERTEX = """
#version 330
uniform mat4 to_screen;
in vec3 place; in vec3 normal; in vec3 colour; in float gloss;
out vec3 at; out vec3 across; out vec3 shade; out float shine;
void main() {
    at = place; across = normal; shade = colour; shine = gloss;
    gl_Position = to_screen * vec4(place, 1.0);
}
"""
FRAGMENT = """
#version 330
const int LAMPS = %d;
uniform vec4 lamps[LAMPS]; uniform vec3 eye; uniform float ambient;
in vec3 at; in vec3 across; in vec3 shade; in float shine;
out vec4 pixel;
void main() {
    vec3 n = normalize(across), v = normalize(eye - at);
    float light = ambient * (0.76 + 0.24 * n.z), white = 0.0;
    for (int k = 0; k < LAMPS; k++) {
        vec3 l = lamps[k].xyz - at;
        float square = dot(l, l), toward = dot(l, n);
        if (toward <= 0.0) continue;
        light += lamps[k].w * toward / square;
        if (shine > 0.0) {
            vec3 h = normalize(l * inversesqrt(square) + v);
            float half_ = max(dot(h, n), 0.0);
            half_ *= half_; half_ *= half_; half_ *= half_;
            half_ *= half_; half_ *= half_; half_ *= half_;
            white += shine * half_;
        }
    }
    pixel = vec4(shade * light + white, 1.0);
}
"""
DISC_VERTEX = """
#version 330
uniform mat4 to_screen;
in vec3 place; in vec2 way; in vec2 strength;
out vec2 off; out vec2 how;
void main() { off = way; how = strength; gl_Position = to_screen * vec4(place, 1.0); }
"""
DISC_FRAGMENT = """
#version 330
in vec2 off; in vec2 how;
out vec4 pixel;
void main() {
    float part = clamp((1.0 - length(off)) / how.y, 0.0, 1.0);
    pixel = vec4(0.0, 0.0, 0.0, how.x * part * part * (3.0 - 2.0 * part));
}
"""


def main() -> int:
    """Measure every size, or say what is missing."""
    os.environ.setdefault("LP_NUM_THREADS", "2")
    os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
    os.environ.setdefault("GALLIUM_DRIVER", "llvmpipe")
    try:
        context = import_module("moderngl").create_context(standalone=True, backend="egl")
    except ImportError:
        return _missing("moderngl is not installed (pip install moderngl)")
    except Exception as trouble:  # noqa: BLE001  whatever a driver raises
        return _missing(f"no OpenGL by EGL: {trouble}")
    name = context.info["GL_RENDERER"]
    if "llvmpipe" not in name:
        return _missing(f"OpenGL is drawn by {name}, not by llvmpipe")
    for size in SIZES:
        times = _measure(context, size)
        print(json.dumps({"name": name, "size": size, "draw": times}), flush=True)
    return 0


def _missing(what: str) -> int:
    print(json.dumps({"missing": what}))
    return 0


def _measure(context: Any, size: tuple[int, int]) -> list[float]:
    """Return the ms of every frame."""
    table = TableScene()
    first = table.at(0, resting=False)
    program = context.program(VERTEX, FRAGMENT % len(first.lights))
    marks = context.program(DISC_VERTEX, DISC_FRAGMENT)
    program["lamps"].value = [(*lamp.position, lamp.power) for lamp in first.lights]
    program["ambient"].value = first.ambient
    layout = "3f 3f 3f 1f", "place", "normal", "colour", "gloss"
    still = context.buffer(_furniture(table).tobytes())
    balls = context.buffer(_balls(table).tobytes())
    solid = [context.vertex_array(program, [(one, *layout)]) for one in (still, balls)]
    pictures = [context.renderbuffer(size, 4)], context.depth_renderbuffer(size)
    target = context.framebuffer(*pictures)
    times = []
    for frame in range(FRAMES + LEAD):
        scene = table.at(frame, resting=False)
        start = perf_counter()
        matrix = _to_screen(scene.camera, size).T.astype(np.float32).tobytes()
        target.use()
        target.clear(0.1, 0.1, 0.12)
        context.enable_only(context.DEPTH_TEST | context.CULL_FACE)
        program["to_screen"].write(matrix)
        program["eye"].value = scene.camera.eye
        for one in solid:
            one.render()
        context.enable_only(context.DEPTH_TEST | context.BLEND)
        marks["to_screen"].write(matrix)
        discs = context.buffer(_discs(scene.shadows).tobytes())
        drawn = context.vertex_array(marks, [(discs, "3f 2f 2f", "place", "way", "strength")])
        drawn.render()
        context.finish()
        times.append(1000.0 * (perf_counter() - start))
        drawn.release()
        discs.release()
    return times[LEAD:]


def _furniture(table: TableScene) -> np.ndarray[Any, np.dtype[np.float32]]:
    meshes = [shape for shape in table.stage.furniture.shapes if isinstance(shape, Mesh)]
    rows = [
        np.concatenate(
            [
                mesh.positions[mesh.triangles].reshape(-1, 3),
                np.repeat(mesh.face_normals[mesh.faces], 3, axis=0),
                np.repeat(mesh.colours[mesh.faces] / 255.0, 3, axis=0),
                np.full((3 * len(mesh.triangles), 1), mesh.gloss),
            ],
            axis=1,
        )
        for mesh in meshes
        if mesh.alpha >= 1.0
    ]
    return np.concatenate(rows).astype(np.float32)


def _balls(table: TableScene) -> np.ndarray[Any, np.dtype[np.float32]]:
    unit = sphere_mesh(GRADIENT)
    corners = unit.positions[unit.triangles].reshape(-1, 3)
    rows = []
    for ball, place in table.places.items():
        colour = np.array(table.stage.spheres[ball].colour) / 255.0
        shade, gloss = np.tile(colour, (len(corners), 1)), np.ones((len(corners), 1))
        placed = corners * RADIUS + np.array(place)
        rows.append(np.concatenate([placed, corners, shade, gloss], axis=1))
    return np.concatenate(rows).astype(np.float32)


def _discs(shadows: Any) -> np.ndarray[Any, np.dtype[np.float32]]:
    ways = np.array([(-1, -1), (1, -1), (1, 1), (-1, -1), (1, 1), (-1, 1)], dtype=np.float64)
    rows = np.zeros((len(shadows), 6, 7), np.float32)
    for row, disc in zip(rows, shadows, strict=True):
        row[:, :2] = ways * disc.radius + np.array(disc.centre[:2])
        row[:, 2], row[:, 3:5] = disc.centre[2] + 0.001, ways
        row[:, 5:] = disc.alpha, max(disc.softness / disc.radius, 1e-3)
    return rows


def _to_screen(camera: Any, size: tuple[int, int]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return the matrix from the world to OpenGL's clip coordinates."""
    basis, near = camera.basis(), camera.near
    turn = np.eye(4)
    turn[:3, :3] = basis * np.array([[1.0], [-1.0], [-1.0]])
    turn[:3, 3] = -turn[:3, :3] @ np.array(camera.eye)
    focal = 2.0 * camera.focal(size[1])
    lens = np.zeros((4, 4))
    lens[0, 0], lens[1, 1] = focal / size[0], focal / size[1]
    lens[2, 2], lens[2, 3] = -(FAR + near) / (FAR - near), -2.0 * FAR * near / (FAR - near)
    lens[3, 2] = -1.0
    return lens @ turn


if __name__ == "__main__":
    sys.exit(main())
