"""Sets of segments, discs and polygons; regions and linear programs."""
from fractions import Fraction

import numpy as np
import pytest
import sunder
from sunder import planar

from helpers import proved, refused, statements

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]


def moved(ring, x, y):
    return (np.asarray(ring, dtype=float) + [x, y]).tolist()


SETS = [  # the set, its questions, pairs that meet with kinds, those that count where touching is allowed
    (planar.Segments([[0, 0, 4, 0], [1, -1, 1, 1], [4, 0, 4, 3], [9, 9, 9, 9]]),
     (planar.segments_any, planar.segments_all, planar.segments_count), "segments",
     {(0, 1): "crossing", (0, 2): "shared-endpoint"}, {(0, 1)}),
    (planar.Discs([[0, 0, 2], [4, 0, 2], [0, 1, 0.5], [9, 9, 1]]),
     (planar.discs_any, planar.discs_all, planar.discs_count), "circles",
     {(0, 1): "touching", (0, 2): "inside"}, {(0, 2)}),
    (planar.Polygons([SQUARE, [moved(SQUARE, 4, 0)], [moved(SQUARE, 1, 1), moved([[1, 1], [2, 1], [2, 2]], 1, 1)],
                      moved(SQUARE, 30, 0)]),
     (planar.polygons_any, planar.polygons_all, planar.polygons_count), "polygons",
     {(0, 1): "touching", (0, 2): "overlapping", (1, 2): "overlapping"}, {(0, 2), (1, 2)}),
]
each = pytest.mark.parametrize("members, questions, name, pairs, overlapping", SETS, ids=[s[2] for s in SETS])


@each
def test_any_all_count(members, questions, name, pairs, overlapping):
    ask_any, ask_all, ask_count = questions
    found = ask_any(members)
    assert found and found.found[:2] in pairs and pairs[found.found[:2]] == found.found[2]
    every = ask_all(members)
    assert dict(zip(map(tuple, every.pairs.tolist()), every.kinds)) == pairs
    assert every.pairs.tolist() == sorted(every.pairs.tolist())
    assert ask_count(members).count == len(pairs) == len(every)
    for answer, verdict in ((found, "some"), (every, "these"), (ask_count(members), "count")):
        verdict += "_kinds" if name == "polygons" and verdict != "some" else ""
        of_polygons = {"some": [("two_polygons", found.found[2])], "these_kinds": [(name, "some")] * len(pairs)}
        more = of_polygons.get(verdict, []) if name == "polygons" else []
        assert statements(answer.certificate()) == [(name, verdict), *more]
        proved(answer.certificate())


@each
def test_what_is_allowed(members, questions, name, pairs, overlapping):
    ask_any, ask_all, ask_count = questions
    assert set(map(tuple, ask_all(members, allowed="touch").pairs.tolist())) == overlapping
    assert ask_count(members, allowed="touch").count == len(overlapping)
    for groups in (["net"] * 4, [5] * 4, np.zeros(4, np.uint8), [-(2**40)] * 4, [True] * 4):
        nothing = ask_any(members, groups=groups)
        assert not nothing and nothing.found is None and ask_all(members, groups=groups).pairs.shape == (0, 2)
    assert statements(nothing.certificate()) == [(name, "none")]
    for answer in (nothing, ask_any(members, "touch", ["a", "a", "a", "b"]), ask_all(members, "touch"),
                   ask_all(members, groups=[1, 1, 2, 2]), ask_count(members, "touch", [3, 1, 2, 0])):
        proved(answer.certificate())
    assert {tuple(p) for p in ask_all(members, groups=["a", "b", "a", "c"]).pairs.tolist()} == \
        {p for p in pairs if p != (0, 2)}


@each
def test_wrong_options(members, questions, name, pairs, overlapping):
    for ask in questions:
        assert "nothing" in refused("bad-call", "allowed", ask, members, "everything")
        if name == "circles":
            refused("bad-call", "allowed", ask, members, "shared-endpoint")
        refused("bad-shape", "groups", ask, members, groups=[1, 2, 3])
        refused("bad-shape", "groups", ask, members, groups=[[1, 2, 3, 4]])
        refused("bad-shape", "groups", ask, members, groups=7)
        for wrong in ([1.5, 2, 3, 4], [None] * 4, [object()] * 4, np.ma.array([1, 2, 3, 4], mask=[1, 0, 0, 0])):
            refused("bad-value", "groups", ask, members, groups=wrong)
    assert len(members) == 4


def test_convex_polygons():
    plates = [planar.ConvexPolygon.from_vertices(moved(SQUARE, x, 0)) for x in (0, 4, 9)]
    some, none = planar.convex_polygons_any(plates), planar.convex_polygons_any(plates, allowed="touch")
    assert some.found == (0, 1, "touching") and not none
    for answer in (some, none, planar.convex_polygons_any(plates, groups=[1, 1, 2])):
        proved(answer.certificate())
    common = planar.convex_polygon_intersection(plates[:2])
    assert common.kind == "segment" and sorted(map(tuple, common.corners)) == [(4, 0), (4, 4)]
    for part in (common, planar.convex_polygon_intersection(plates)):
        proved(part.certificate())
    assert planar.convex_polygon_intersection(plates).kind == "empty"


def test_polygons_must_be_valid():
    hourglass = [[0, 0], [4, 4], [4, 0], [0, 4]]
    assert "crossing" in refused("bad-shape", "polygons[1]", planar.Polygons, [SQUARE, hourglass])
    assert "polygon" in str(pytest.raises(sunder.Error, planar.Polygons, [[[0, 0], [1, 1]]]).value)
    assert refused("bad-value", "polygons[0]", planar.Polygons, [[[0, 0], [1, 1], [2, np.nan]]])
    touching_itself = [[0, 0], [6, 0], [6, 6], [3, 6], [4, 3], [2, 3], [3, 6], [0, 6]]
    assert len(planar.Polygons([touching_itself])) == 1


def test_defects():
    good = planar.polygon_defects([SQUARE, moved([[1, 1], [2, 1], [1, 2]], 0, 0)])
    assert good.valid and statements(good.certificate()) == [("polygon", "valid")] or proved(good.certificate())
    bad = planar.polygon_defects([[0, 0], [4, 4], [4, 0], [0, 4]])
    assert not bad.valid and bad.defects == [("crossing", (0, 0, 0), (0, 0, 2), (2.0, 2.0))]
    proved(bad.certificate())
    repeated = [[0, 0], [4, 0], [4, 0], [0, 4]]
    assert planar.polygon_defects(repeated).valid and not planar.polygon_defects(repeated, rule="simple").valid
    parts = planar.polygon_defects([[SQUARE], [moved(SQUARE, 1, 1)]])
    assert not parts.valid and {part for _, a, b, _ in parts.defects for part in (a[0], b[0])} == {0, 1}
    refused("bad-call", "rule", planar.polygon_defects, SQUARE, rule="strict")


def test_half_planes():
    given = planar.Constraints([[-1, 0, 0], [0, -1, 0], [3, 1, 10], [1, 3, 12], [1, 1, 100]])
    region = planar.half_plane_intersection(given)
    assert region.kind == "bounded" and sorted(region.sides.tolist()) == [0, 1, 2, 3]
    assert (Fraction(9, 4), Fraction(13, 4)) in region.exact_corners() and [2.25, 3.25] in region.corners.tolist()
    assert region.cost.probes > 0
    empty = planar.half_plane_intersection(planar.Constraints([[1, 0, 0], [-1, 0, -1]]))
    assert empty.kind == "empty" and len(empty.corners) == 0 and sorted(empty.sides.tolist()) == [0, 1]
    for part in (region, empty):
        proved(part.certificate())
    refused("bad-shape", "half-plane 1", planar.Constraints, [[1, 0, 0], [0, 0, 1]])


def test_linear_programs():
    given = planar.Constraints([[-1, 0, 0], [0, -1, 0], [3, 1, 10], [1, 3, 12]])
    for objective, outcome, point in (((1, 2), "one", (Fraction(9, 4), Fraction(13, 4))), ((0, 0), "all", None),
                                      ((3, 1), "many", None)):
        best = planar.linear_program(given, objective)
        assert best.outcome == outcome and best.feasible and (point is None or best.exact_point() == point)
        proved(best.certificate())
    assert planar.linear_program(given, (1, 2)).point == (2.25, 3.25)
    third = planar.linear_program(planar.Constraints([[3, 0, 1], [0, 1, 0]]), (1, 1))
    assert third.exact_point() == (Fraction(1, 3), 0) and third.point == (1 / 3, 0)
    none = planar.linear_program(planar.Constraints([[1, 0, 0], [-1, 0, -1]]), (1, 1))
    assert none.outcome == "infeasible" and none.point is None and none.exact_point() is None
    far = planar.linear_program(planar.Constraints([[-1, 0, 0]]), (1, 0))
    assert far.outcome == "unbounded" and far.point[0] >= 0
    for program in (none, far):
        proved(program.certificate())


def test_kernels_and_discs():
    star = [[0, 0], [4, 1], [8, 0], [7, 4], [8, 8], [4, 7], [0, 8], [1, 4]]
    kernel = planar.kernel(star)
    assert kernel.kind == "bounded" and planar.kernel(np.array(star)[::-1]).kind == "bounded"
    proved(kernel.certificate())
    refused("bad-shape", "ring", planar.kernel, [[0, 0], [4, 4], [4, 0], [0, 4]])
    pytest.raises(sunder.Error, planar.kernel, [star, moved(star, 0, 0)])
    for discs, kind in (([[0, 0, 2], [1, 0, 2]], "region"), ([[0, 0, 1], [2, 0, 1]], "point"),
                        ([[0, 0, 1], [3, 0, 1]], "empty")):
        part = planar.disc_intersection(planar.Discs(discs))
        assert part.kind == kind and len(part.sides) == (2 if kind == "region" else 0)
        proved(part.certificate())
