"""Meshes and spheres as data."""

import numpy as np
import pytest

from engine.scene.shape import HIDDEN, make_mesh, skin_directions, sphere_mesh


@pytest.mark.parametrize("gradient", [2, 3, 8, 24])
def test_a_sphere_is_closed_and_watertight(gradient):
    mesh = sphere_mesh(gradient)
    directed = {}
    for a, b, c in mesh.triangles:
        for edge in ((a, b), (b, c), (c, a)):
            directed[edge] = directed.get(edge, 0) + 1
    assert all(count == 1 for count in directed.values())
    assert all((b, a) in directed for a, b in directed)
    assert (mesh.edges[:, 3] != HIDDEN).all()
    vertices, edges, faces = len(mesh.positions), len(mesh.edges), len(mesh.face_normals)
    assert vertices - edges + faces == 2


def test_a_spheres_faces_look_outward():
    mesh = sphere_mesh(9)
    assert ((mesh.face_normals * mesh.face_centres).sum(axis=1) > 0.9).all()
    assert np.linalg.norm(mesh.positions, axis=1) == pytest.approx(np.ones(len(mesh.positions)))


def test_edges_are_unique_and_know_both_faces():
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]], float)
    mesh = make_mesh(square, [(0, 1, 2, 3), (1, 4, 5, 2)], (1, 2, 3), kind="sheet")
    assert len(mesh.edges) == 7
    shared = [e for e in mesh.edges.tolist() if e[3] != HIDDEN]
    assert shared == [[1, 2, 0, 1]]
    assert mesh.face_normals == pytest.approx(np.array([[0, 0, 1], [0, 0, 1]], float))


def test_the_planes_of_a_hull_hold_all_its_points():
    mesh = sphere_mesh(5)
    over = mesh.positions.astype(float) @ mesh.planes[:, :3].T - mesh.planes[:, 3]
    assert over.max() < 1e-6


def test_a_polygon_with_two_corners_is_refused():
    with pytest.raises(ValueError, match="three corners"):
        make_mesh(np.zeros((2, 3)), [(0, 1)], (0, 0, 0))


def test_skin_directions_cover_the_sphere_evenly():
    own = skin_directions(32).reshape(-1, 3)
    assert np.linalg.norm(own, axis=1) == pytest.approx(np.ones(len(own)))
    assert np.abs(own.mean(axis=0)).max() < 1e-9
    assert (own[:, 2] < 0).sum() == (own[:, 2] > 0).sum()
