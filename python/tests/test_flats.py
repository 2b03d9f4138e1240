"""Planes, lines, rays and segments of space."""
from fractions import Fraction

import numpy as np
import pytest
import sunder
from sunder import solid

from helpers import proved, refused

CUBE = solid.ConvexPolyhedron([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
HERE = solid.Pose()


def test_planes():
    for offset, side, contact in ((2, "below", "none"), (1, None, "touching"), (0.5, None, "overlapping"),
                                  (np.nextafter(0, -1), "above", "none")):
        answer = sunder.intersect(CUBE, HERE, solid.Plane.at([0, 0, 1], offset))
        assert answer.side == side and answer.contact == contact and answer.meet == bool(answer) == (side is None)
        assert answer.cost.probes > 0 and answer.decided_by in ("filter", "evidence")
        assert proved(answer.certificate())
    plane = solid.Plane.through([1, 2, 3], [0, 0, -2])
    assert list(plane.normal) == [0, 0, -2] and list(plane.point) == [1, 2, 3] and plane.offset == 0
    assert solid.polyhedron_plane(CUBE, HERE, plane).side == "above"
    assert not sunder.intersect(CUBE, plane)
    with pytest.raises(sunder.Error):
        sunder.intersect(CUBE, solid.Plane.at([3, 0, 0], 1)).certificate()
    refused("bad-shape", "plane", solid.Plane.at, [0, 0, 0], 1)
    refused("bad-value", "plane", solid.Plane.at, [0, 0, 1], np.inf)


def test_lines():
    line = solid.Line.through([-1, 0.25, 0.5], [2, 0.25, 0.5])
    cut = sunder.intersect(CUBE, line)
    assert cut and cut.kind == "across" and cut.contact == "overlapping"
    assert np.array_equal(cut.points, [[0, 0.25, 0.5], [1, 0.25, 0.5]])
    assert cut.along_line == [Fraction(1, 3), Fraction(2, 3)]
    assert proved(cut.certificate())
    ray = solid.polyhedron_line(CUBE, HERE, solid.Ray.through([0.5, 0.5, 0.5], [0.5, 0.5, 2]))
    assert ray.along_line == [0, Fraction(1, 3)] and proved(ray.certificate())
    edge = solid.polyhedron_line(CUBE, HERE, solid.Segment.between([0, 0, -1], [0, 0, 0.5]))
    assert edge.kind == "along" and edge.contact == "touching" and proved(edge.certificate())
    past = sunder.intersect(CUBE, HERE, solid.Ray.through([2, 0.5, 0.5], [3, 0.5, 0.5]))
    assert not past and past.kind == "nothing" and past.points.shape == (0, 3) and past.along_line == []
    assert proved(past.certificate())
    assert list(line.a) == [-1, 0.25, 0.5]
    refused("bad-shape", "line", solid.Line.through, [1, 2, 3], [1, 2, 3])


def test_supports():
    beside = solid.polyhedron_line_support(CUBE, HERE, solid.Line.through([3, 0.5, 0], [3, 0.5, 1]))
    assert not beside and beside.kind == "two planes" and list(map(len, beside.touches)) == [2, 2]
    in_side = solid.polyhedron_line_support(CUBE, HERE, solid.Line.through([3, 0, 0], [3, 0, 1]))  # in the plane y = 0
    assert list(map(len, in_side.touches)) == [2, 4] and proved(in_side.certificate())
    assert beside.decided_by and proved(beside.certificate())
    through = solid.polyhedron_line_support(CUBE, HERE, solid.Line.through([0.5, 0.5, 0.5], [3, 1, 1]))
    assert through and through.kind == "none" and through.touches == [] and proved(through.certificate())
    flat = solid.ConvexPolyhedron([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    refused("bad-shape", "body", solid.polyhedron_line_support, flat, HERE, solid.Line.through([0, 0, 0], [1, 2, 3]))


def test_flats():
    floor, wall = solid.Plane.at([0, 0, 1], 0), solid.Plane.at([1, 0, 0], 2)
    edge = solid.flat_flat(floor, wall)
    assert edge.kind == "line" and edge.point[0] == 2 and edge.point[2] == 0 and proved(edge.certificate())
    assert solid.flat_flat(floor, solid.Plane.at([0, 0, 2], 1)).kind == "nothing"
    x, over = solid.Line.through([0, 0, 0], [1, 0, 0]), solid.Line.through([0, -1, 1], [0, 1, 1])
    assert solid.flat_flat(x, over).point is None and proved(solid.flat_flat(x, over).certificate())
    touch = solid.flat_flat(x, solid.Segment.between([5, 0, 0], [5, 1, 0]))
    assert touch.contact == "touching" and list(touch.point) == [5, 0, 0] and proved(touch.certificate())
    assert solid.flat_flat(solid.Ray.through([0, 0, 1], [0, 0, 0]), floor).contact == "overlapping"
