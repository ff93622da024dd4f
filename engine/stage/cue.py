"""The cue: a tapered stick with tip, ferrule, shaft and butt, laid against a ball."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.scene import GameObject
from engine.scene.shape import make_mesh

if TYPE_CHECKING:
    from engine.scene.camera import Vector
    from engine.scene.shape import Mesh, Rgb

SIDES = 14
SECTIONS: tuple[tuple[float, float, float, float, Rgb], ...] = (
    (0.000, 0.006, 0.0052, 0.0064, (72, 124, 178)),
    (0.006, 0.026, 0.0064, 0.0065, (240, 236, 222)),
    (0.026, 0.780, 0.0065, 0.0105, (222, 184, 126)),
    (0.780, 0.800, 0.0105, 0.0108, (30, 30, 32)),
    (0.800, 1.080, 0.0108, 0.0128, (96, 42, 24)),
    (0.800 + 0.28, 1.380, 0.0128, 0.0145, (44, 26, 22)),
    (1.380, 1.450, 0.0145, 0.0148, (24, 24, 26)),
)
"""From and to along the stick, radius there (m), colour."""
LENGTH = SECTIONS[-1][1]


@dataclass(frozen=True, slots=True)
class CuePose:
    """How the cue lies: at a ball's centre (m), with angles in rad and offsets in radii.

    `gap` (m) is the way from the tip to the ball; `side` is right as the player sees it.
    """

    ball: Vector
    radius: float
    heading: float
    elevation: float = 0.0
    side: float = 0.0
    follow: float = 0.0
    gap: float = 0.02


def radius_at(along: float) -> float:
    """Return the radius (m) of the cue so far from its tip, that of its ends beyond them."""
    for near, far, r0, r1, _ in SECTIONS:
        if along <= far:
            return r0 + (r1 - r0) * max(along - near, 0.0) / (far - near)
    return SECTIONS[-1][3]


def cue_meshes() -> tuple[Mesh, ...]:
    """Return the sections of a cue that points along +x with its tip at the origin."""
    last = len(SECTIONS) - 1
    return tuple(_section(*s, front=i == 0, rear=i == last) for i, s in enumerate(SECTIONS))


def _section(
    near: float, far: float, r0: float, r1: float, colour: Rgb, *, front: bool, rear: bool
) -> Mesh:
    turns = np.arange(SIDES) * (2.0 * np.pi / SIDES)
    ring = np.stack([np.zeros(SIDES), np.cos(turns), np.sin(turns)], axis=1)
    points = np.concatenate([ring * r0 - [near, 0.0, 0.0], ring * r1 - [far, 0.0, 0.0]])
    after = [(k + 1) % SIDES for k in range(SIDES)]
    shown: list[tuple[int, ...]] = [
        (k, SIDES + k, SIDES + after[k], after[k])[::-1] for k in range(SIDES)
    ]
    caps: list[tuple[int, ...]] = [tuple(range(SIDES)), tuple(reversed(range(SIDES, 2 * SIDES)))]
    hidden: list[tuple[int, ...]] = []
    for cap, seen in zip(caps, (front, rear), strict=True):
        (shown if seen else hidden).append(cap)
    return make_mesh(points, shown, colour, hidden=hidden, gloss=0.5, smooth=True)


def place_cue(meshes: tuple[Mesh, ...], pose: CuePose) -> GameObject:
    """Return the cue as it lies for a stroke."""
    ahead = np.array([cos(pose.heading), sin(pose.heading), 0.0])
    way = ahead * cos(pose.elevation) - np.array([0.0, 0.0, sin(pose.elevation)])
    right = np.array([ahead[1], -ahead[0], 0.0])
    top = np.cross(right, way)
    depth = sqrt(max(1.0 - pose.side**2 - pose.follow**2, 0.0))
    contact = pose.side * right + pose.follow * top - depth * way
    tip = np.array(pose.ball) + pose.radius * contact - pose.gap * way
    rotation = np.stack([way, -right, top], axis=1)
    return GameObject(meshes, (float(tip[0]), float(tip[1]), float(tip[2])), rotation)
