"""Hulls, vertices, regions and linear programs of any dimension, as fractions."""
import sys
from fractions import Fraction

import numpy as np
import pytest
from sunder import polytope

from helpers import proved, refused, statements

Polytope = polytope.Polytope
THIRD = Fraction(1, 3)
PYRAMID = Polytope.from_half_spaces([[0, 0, -1, 0], [3, 0, 1, 1], [-3, 0, 1, 1], [0, 3, 1, 1], [0, -3, 1, 1]])
QUADRANT = Polytope.from_half_spaces([[-1, 0, 0], [0, -1, 0]])
NOTHING = Polytope.from_half_spaces([[1, 0, -1], [-1, 0, -1], [0, 1, 5]])


def product(u, v):
    return sum(x * Fraction(y) for x, y in zip(u, v))


def keeps(rows, point):
    return all(product(point, row) <= Fraction(row[-1]) for row in rows)


def test_hull():
    for d in (2, 3, 4, 5):
        points = np.random.default_rng(d).integers(-3, 4, size=(12, d)).astype(float)
        hull = polytope.convex_hull(Polytope.from_points(points))
        assert hull.dimension == d and hull.equations == [] and hull.vertices.dtype == np.uint32
        assert len(hull.facets) == len(hull.half_spaces)
        for facet, row in zip(hull.facets, hull.half_spaces):
            assert isinstance(row[0], Fraction) and len(row) == d + 1
            heights = [product(row, p) for p in points]
            assert max(heights) == row[-1]
            assert {k for k in hull.vertices if heights[k] == row[-1]} == set(facet.tolist())
        assert statements(hull.certificate()) == [("polytope_hull", "facets")]
        proved(hull.certificate())
    line = polytope.convex_hull(Polytope.from_points([[0, 0, .1], [1, 1, .1], [3, 3, .1]]))
    assert (line.dimension, line.vertices.tolist(), len(line.facets), len(line.equations)) == (1, [0, 2], 2, 2)
    assert all(product(row, (1, 1, .1)) == row[-1] for row in line.equations)
    place = polytope.convex_hull(Polytope.from_points([[1, 2], [1, 2]]))
    assert (place.dimension, place.vertices.tolist(), place.facets) == (0, [0], [])


def test_vertices():
    found = polytope.region_vertices(PYRAMID)
    assert (len(found), found.dimension, found.bounding.tolist()) == (5, 3, [0, 1, 2, 3, 4])
    assert set(found.vertices) == {(x, y, 0) for x in (THIRD, -THIRD) for y in (THIRD, -THIRD)} | {(0, 0, 1)}
    assert all(isinstance(x, Fraction) for vertex in found.vertices for x in vertex)
    for vertex, on in zip(found.vertices, found.half_spaces):
        assert [k for k, row in enumerate(PYRAMID.rows) if product(vertex, row) == Fraction(row[-1])] == on.tolist()
    assert statements(found.certificate()) == [("half_spaces_vertices", "vertices")]
    proved(found.certificate())
    flat = polytope.region_vertices(Polytope.from_half_spaces([[1, 1, 1], [-1, -1, -1], [-1, 0, 0], [0, -1, 0]]))
    assert (flat.dimension, sorted(flat.vertices)) == (1, [(0, 1), (1, 0)])
    proved(flat.certificate())
    nothing = polytope.region_vertices(NOTHING)
    assert (len(nothing), nothing.dimension, nothing.vertices) == (0, None, [])
    assert statements(nothing.certificate()) == [("half_spaces", "empty")]


def test_there_and_back():
    """The vertices of the facets of a hull are its own."""
    for d in (2, 3, 4):
        points = np.random.default_rng(10 + d).integers(-4, 5, size=(10, d)).astype(float)
        hull = polytope.convex_hull(Polytope.from_points(points))
        rows = [[float(x) for x in row] for row in hull.half_spaces]
        assert all(Fraction(x) == y for row, exact in zip(rows, hull.half_spaces) for x, y in zip(row, exact))
        back = polytope.region_vertices(Polytope.from_half_spaces(rows))
        assert set(back.vertices) == {tuple(map(Fraction, points[k])) for k in hull.vertices}


def test_region():
    bounded = polytope.half_space_region(PYRAMID)
    assert bounded and (bounded.kind, bounded.dimension, bounded.direction, bounded.flat) == ("bounded", 3, None, {})
    assert len(bounded.points) == 4 and all(keeps(PYRAMID.rows, p) for p in bounded.points)
    assert bounded.extents == [(-1 / 3, 1 / 3), (-1 / 3, 1 / 3), (0, 1)]
    unbounded = polytope.half_space_region(QUADRANT)
    assert (unbounded.kind, unbounded.extents) == ("unbounded", [(0, None), (0, None)])
    assert all(product(unbounded.direction, row) <= 0 for row in QUADRANT.rows) and any(unbounded.direction)
    empty = polytope.half_space_region(NOTHING)
    assert not empty and (empty.kind, empty.dimension, empty.points, empty.extents) == ("empty", None, [], [])
    sums = [sum(m * Fraction(NOTHING.rows[k][c]) for k, m in empty.contradiction.items()) for c in range(3)]
    assert sums[:2] == [0, 0] and sums[2] < 0
    line = Polytope.from_half_spaces([[1, 2, 3], [-1, -2, -3]])
    assert set(polytope.half_space_region(line).flat) == {0, 1}
    for given in (PYRAMID, QUADRANT, NOTHING, line):
        proved(polytope.half_space_region(given).certificate())


@pytest.mark.parametrize("method", ["automatic", "seidel", "scan"])
def test_linear_programs(method):
    one = polytope.linear_program(PYRAMID, [1, .5, .25], method)
    assert one and (one.outcome, one.point, one.value) == ("one", (THIRD, THIRD, 0), Fraction(1, 2))
    assert [sum(m * Fraction(PYRAMID.rows[k][c]) for k, m in one.multipliers.items()) for c in range(4)] == [
        1, Fraction(1, 2), Fraction(1, 4), one.value]
    many = polytope.linear_program(PYRAMID, [0, 0, -1], method)
    assert (many.outcome, many.value) == ("many", 0) and many.point != many.other and many.point[2] == many.other[2] == 0
    every = polytope.linear_program(PYRAMID, [0, 0, 0], method)
    assert (every.outcome, every.value) == ("all", 0) and keeps(PYRAMID.rows, every.point)
    far = polytope.linear_program(QUADRANT, [1, 0], method)
    assert far and (far.outcome, far.value) == ("unbounded", None) and far.direction[0] > 0
    none = polytope.linear_program(NOTHING, [1, 1], method)
    assert not none and (none.outcome, none.point, none.value, len(none.multipliers)) == ("infeasible", None, None, 2)
    for answer in (one, many, every, far, none):
        proved(answer.certificate())


def test_fractions_of_any_length():
    """Of doubles of all sizes: numbers of more digits than Python reads of a text unless told to."""
    d, some = 6, np.random.default_rng(6).uniform(.5, 1, (7, 7))
    sizes = np.full((d, d + 1), -1020)
    sizes[range(d), range(d)] = sizes[1::2, d] = 1023
    rows = np.vstack([np.ldexp(some[:d], sizes), [-1] * d + [1]])
    up = np.ldexp(some[d, :d], [1020 if c % 2 else -1020 for c in range(d)])
    limit = getattr(sys, "get_int_max_str_digits", int)()
    if limit == 0 and hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(4300)  # as Python begins; sunder_verify lifts it
    try:
        best = polytope.linear_program(Polytope.from_half_spaces(rows), up)
        assert best.outcome == "one" and best.value == product(best.point, up)
        assert best.value.numerator.bit_length() > 14300
    finally:
        if hasattr(sys, "set_int_max_str_digits"):
            sys.set_int_max_str_digits(limit)


def test_programs_against_vertices():
    rng = np.random.default_rng(3)
    for d in (2, 3, 4):
        rows = np.vstack([np.column_stack([np.eye(d), np.ones(d)]), np.column_stack([-np.eye(d), np.ones(d)]),
                          np.column_stack([rng.integers(-2, 3, size=(4, d)), np.ones(4)])])
        given = Polytope.from_half_spaces(rows)
        vertices = polytope.region_vertices(given).vertices
        for up in rng.integers(-3, 4, size=(6, d)):
            best = polytope.linear_program(given, up)
            values = [product(v, up) for v in vertices]
            assert best.value == max(values)
            assert (best.outcome == "one") == (values.count(max(values)) == 1)


def test_what_is_refused():
    points = Polytope.from_points([[0, 0], [1, 0]])
    for ask in (polytope.half_space_region, polytope.region_vertices):
        assert "give a polytope of half-spaces" in refused("bad-call", "half_spaces", ask, points)
    refused("bad-call", "half_spaces", polytope.linear_program, points, [1, 0])
    assert "give a polytope of points" in refused("bad-call", "points", polytope.convex_hull, QUADRANT)
    assert "give bounded ones" in refused("bad-shape", "half_spaces", polytope.region_vertices, QUADRANT)
    refused("bad-shape", "objective", polytope.linear_program, QUADRANT, [1, 2, 3])
    refused("bad-value", "objective", polytope.linear_program, QUADRANT, [1, float("nan")])
    refused("bad-value", "method", polytope.linear_program, QUADRANT, [1, 2], "frob")
    refused("bad-shape", "half_spaces", Polytope.from_half_spaces, np.zeros((1, 8)))
    refused("bad-shape", "half_spaces", Polytope.from_half_spaces, [[1, 2, 3], [1, 2]])
