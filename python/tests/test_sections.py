"""Sections of polyhedra by planes."""
import numpy as np
import pytest
import sunder
from sunder import solid

from helpers import proved, statements

CUBE = solid.ConvexPolyhedron([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])


def test_one_plane():
    found = solid.polyhedron_plane_section(CUBE, [0, 0, 1], 0.5)
    assert found.kind == "polygon" and len(found) == 4
    assert sorted(map(tuple, found.corners)) == [(0, 0, .5), (0, 1, .5), (1, 0, .5), (1, 1, .5)]
    assert (CUBE.vertices[found.features[:, 0], 2] == 1).all() and (CUBE.vertices[found.features[:, 1], 2] == 0).all()
    assert statements(found.certificate()) == [("hull", "solid"), ("section", "measured")]
    proved(found.certificate())
    assert found.area[0] <= 1 <= found.area[1] < 1 + 1e-12


def test_kinds():
    kinds = [solid.polyhedron_plane_section(CUBE, [1, 1, 1], offset).kind for offset in (-1, 0, 1, 3, 4)]
    assert kinds == ["nothing", "point", "polygon", "point", "nothing"]
    assert solid.polyhedron_plane_section(CUBE, [1, 1, 0], 0).kind == "segment"


def test_a_stack():
    lifted = solid.Pose.from_matrix(np.eye(3), [0, 0, 5])
    stack = solid.polyhedron_plane_sections(CUBE, [0, 0, 1], [4, 5, 5.25, 7], lifted)
    assert [len(found) for found in stack] == [0, 4, 4, 0]
    for found in stack:
        proved(found.certificate())


def test_bad_planes():
    with pytest.raises(sunder.Error):
        solid.polyhedron_plane_section(CUBE, [0, 0, 0], 1)
    with pytest.raises(sunder.Error):
        solid.polyhedron_plane_sections(CUBE, [0, 0, 1], [np.nan])
