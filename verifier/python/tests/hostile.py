"""Hostile certificates of about 1 MB, by name: each makes a checker work as long as so few letters can."""
import math
import random

ZEROS = ["0x0p0"] * 3
UNIT = ["0x1p0", "0x0p0", "0x0p0"] + ["0x0p0", "0x1p0", "0x0p0"] + ["0x0p0", "0x0p0", "0x1p0"]
EXTREME = ["0x1p-1074", "0x1p1023", "0x1p1023"]  # long integers out of few letters
EXPONENTS = ["0x1p20000", "0x1p-20000", "0x1p3"]
RANDOM = random.Random(1)


def digits(n):
    return "1" + "".join(RANDOM.choices("0123456789", k=n - 1))


def fraction(n):
    return "%s/%s" % (digits(n // 2), digits(n // 2))


def claimed(table, rows, *statements):
    return {"sunder_certificate": 3, "inputs": [], "call": [], "left_out": [], "tables": {table: rows}, "statements": list(statements)}


def bodies(points, statements, name="a", linear=None):
    """A body and an image of it, which the statements are about."""
    return claimed("bodies", [{"name": "a", "points": points},
                              {"name": name, "of": 0, "linear": linear or UNIT, "translation": ZEROS}], *statements)


def apart(direction):
    return {"question": "pair", "a": 1, "b": 1, "verdict": "apart", "claims": [{"claim": "parted", "direction": direction}]}


def meet(count, length):
    holds = {"claim": "holds", "weights": [[i, fraction(length)] for i in range(count)]}
    return {"question": "pair", "a": 1, "b": 1, "verdict": "meet", "point": ["1", "1", "1"], "claims": [holds, holds]}


def parabola(n):
    return [["0x%xp0" % i, "0x%xp0" % (i * i)] for i in range(n)]


def some_of(table, point, count, **more):
    """The statement that two entries have this point in common, so many times."""
    kind = {} if table == "polygons" else more
    return [{"question": table, "allowed": "nothing", "verdict": "some", "i": 0, "j": 1, "point": point, **kind,
             "claims": [{"claim": "common_point" if table == "polygons" else "contact"}]}] * count


def common_discs(rows, claim, count=1, **said):
    return claimed("circles", rows, *[{"question": "circles_common_part", **said, "claims": [{"claim": "in_discs"}, claim]}]
                   * count)


def region(rows, arcs, point=("0", "0"), count=1):
    return common_discs(rows, {"claim": "arcs", "parts": [list(range(i, min(i + 8, len(rows)))) for i in range(0, len(rows), 8)]
                               if len(rows) > 8 else []}, count, verdict="region", point=list(point), arcs=arcs)


def powers(rows, weights, count):
    return common_discs(rows, {"claim": "powers", "weights": weights}, count, verdict="point", point=["0", "0"])


def ring_of_discs(n):
    angles = [2 * math.pi * i / n for i in range(n)]
    discs = [[math.cos(a).hex(), math.sin(a).hex(), "0x1.4p0"] for a in angles]
    return region(discs, list(range(n)))


def unbounded(point):
    return {"question": "linear_program", "objective": ["-0x1p0", "0x0p0"], "verdict": "unbounded", "point": point,
            "claims": [{"claim": "feasible"}, {"claim": "goes_on", "direction": ["-1", "0"]}]}


def far_corner(half_plane, n):
    rows = [["-0x1p-1074", "0x0p0", "0x0p0"], ["0x0p0", "-0x1p1023", "0x0p0"]] + [half_plane] * n
    return claimed("half_planes", rows, {"question": "half_planes", "verdict": "unbounded", "sides": [0, 1],
                                         "claims": [{"claim": "cones", "cones": [0] * (n + 2)}]})


def swept(rows, events, **more):
    return claimed("segments", rows, {"question": "segments", "allowed": "nothing", "verdict": "none", **more,
                                      "claims": [{"claim": "none_counts", "events": events}]})


def claimed_program(claims, **more):
    return {"question": "linear_program", "objective": ["-0x1p0", "0x0p0"], **more, "claims": claims}


def hatch(n):
    """n lines one way, n the other, of long integers: their crossings, in no order."""
    rows = [["0x1p-1074", "0x%xp0" % (2 * i), "0x1p900", "0x%xp0" % (4 * n - 2 * i)] for i in range(n)]
    events = [[2 * i, i - 1, i] for i in range(n)] + [[-1, -1, n - 1 - i % n, i % (n - 1)] for i in range(30000)]
    return swept(rows, events, groups=[1] * n)


def one_crossing(n):
    rows = [["0x0p0", "0x0p0", "0x1p1023", "0x1p1023"], ["0x0p0", "0x1p1023", "0x1p1023", "0x1p-1074"]]
    return swept(rows, [[0, -1, 0], [2, 0, 1]] + [[-1, -1, 1, 0]] * n + [[1, -1], [3, -1]], groups=[1, 1])


def fan(n):
    """n long segments through one point, which is an event for each of them."""
    rows = [["-0x1p1000", "-0x%xp900" % (i + 1), "0x1p1000", "0x%xp900" % (i + 1)] for i in range(n)]
    first = [[2 * i, -1, i] for i in reversed(range(n))]
    return swept(rows, first + [[-1, -1, *range(n)]] + [[2 * i + 1, -1] for i in range(n)], groups=[1] * n)


def parts_in_turns(n, count, parts=([0], [0, 1]), far=()):
    """Short statements about parts that are long, each other one about others; a far point makes all integers long."""
    return claimed("polygons", [[parabola(n) + [*far], [["0x0p0", "0x0p0"]]], [[["0x0p0", "0x0p0"]]]],
                   *[{"question": "valid", "parts": parts[k % len(parts)], "rule": "valid", "verdict": "too_few_points", "ring": 1,
                      "claims": [{"claim": "too_few_points"}]} for k in range(count)])


def beside_rings(n, point, count):
    rings = [[["0x0p0", "0x0p0"], ["0x1p0", "0x1p0"], ["0x0p0", "0x1p0"]]] + [[["0x%xp0" % (k + 2), "0x0p0"]] for k in range(n)]
    return claimed("polygons", [rings], *[{"question": "valid", "parts": [0], "rule": "valid", "verdict": "misplaced", "ring": 0,
                                           "point": point, "claims": [{"claim": "misplaced"}]}] * count)


def hulls(n, count, point=("0x1p-3", "0x1p-3", "0x1p-3")):
    """A tetrahedron around one point, n times."""
    corners = [["0x0p0"] * 3, ["0x1p1023", "0x0p0", "0x0p0"], ["0x0p0", "0x1p1023", "0x0p0"], ["0x0p0", "0x0p0", "0x1p1023"]]
    homes = [None] * 4 + [[0, 1]] * n
    return claimed("bodies", [{"name": "a", "points": corners + [list(point)] * n}], *[
        {"question": "hull", "body": 0, "verdict": "segment", "i": 0, "j": 1, "claims": [{"claim": "between"}]}] * count,
        {"question": "hull", "body": 0, "verdict": "solid", "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
         "claims": [{"claim": "surface", "homes": homes}]})


def circle_in_space(n):
    return [["0x%xp0" % (i * i), "0x%xp0" % i, "0x0p0"] for i in range(n)]


def simplex(d, n, size, point, count):
    """A simplex of d dimensions around one point, n times."""
    corners = [["0x0p0"] * d] + [[size if r == c else "0x0p0" for c in range(d)] for r in range(d)]
    facets = []
    for i in range(d + 1):
        those = [v for v in range(d + 1) if v != i]
        facets.append([those if i % 2 else those[1::-1] + those[2:]])
    return claimed("bodies", [{"name": "a", "points": corners + [[point] * d] * n}], *[
        {"question": "polytope_hull", "body": 0, "verdict": "facets", "facets": facets,
         "claims": [{"claim": "boundary", "simplices": [None] * (d + 1) + [1] * n}]}] * count)


def drum(n, cut):
    """A prism over n points of a parabola, without some of its caps."""
    points = [["0x%xp0" % i, "0x%xp0" % (i * i), "0x%xp0" % z] for z in (0, 1) for i in range(n)]
    caps = [[[0, i, i + 1][::step] for i in range(1, n - 1)] for step in (-1, 1)]
    facets = [caps[0], [[v + n for v in s] for s in caps[1]]]
    for i in range(n):
        j = (i + 1) % n
        facets.append([[i, j, j + n], [i, j + n, i + n]])
    return claimed("bodies", [{"name": "a", "points": points}], {
        "question": "polytope_hull", "body": 0, "verdict": "facets", "facets": facets[cut:],
        "claims": [{"claim": "boundary", "simplices": [None] * 2 * n}]})


def all_pairs(n, groups):
    return {"question": "bodies", "members": list(range(n)), "allowed": "nothing", "groups": list(groups), "except": [],
            "verdict": "these", "contacts": [], "claims": [{"claim": "each_pair"}]}


def around(kind, *placed):
    """Two bodies with a radius of extreme numbers, placed by such, and statements about them."""
    core = [EXTREME, ["-0x1p1000", "0x1.8p-1070", "0x0p0"]][:1 if kind == "ellipsoid" else 2]
    item = {"name": "a", "points": core, kind: "0x1.ffffffffffffep-1023"}
    image = {"name": "b", "of": 0, "linear": EXTREME[::-1] + UNIT[3:], "translation": EXTREME}
    return claimed("bodies", [item, image, {**item, kind: "0x1.fffffffffffffp1023"}], *placed)


def kept(direction):
    return {"question": "clearance", "a": 1, "b": 2, "least": "0x1p1023", "verdict": "kept",
            "claims": [{"claim": "clear", "direction": direction}]}


def held(point, origin=None, weight="1"):
    first, second = ({"claim": "holds", "weights": [[0, weight]], **({"from": v} if v else {})}
                     for v in (origin, origin and ["0"] * 3))
    return {"question": "pair", "a": 1, "b": 2, "verdict": "meet", "point": point, "claims": [first, second]}


def broken(long):
    holds = {"claim": "holds", "weights": [[0, "1"]]}
    return {"question": "clearance", "a": 1, "b": 1, "least": "0x1p0", "verdict": "broken", "from_a": ["1/" + long, "0", "0"],
            "to_b": ["0", "1/" + long, "1"], "claims": [holds, holds, {"claim": "nearer"}]}


TETRAHEDRON = {"question": "hull", "body": 0, "verdict": "solid", "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
               "claims": [{"claim": "surface", "homes": [None] * 4}]}


def tree_of_planes(corner, planes, points=4, times=1):
    """Two tetrahedra, with more points in their table; and each plane cuts what is above the last one."""
    rows = [ZEROS, corner, ["0x1p0", "0x0p0", "0x0p0"], ["0x0p0", "0x1p0", "0x0p0"]]
    rows += [["0x%xp4" % (k + 1), "0x0p0", "0x0p0"] for k in range(points - 4)]
    mesh = {"points": rows, "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}
    tree = {"claim": "equal_insides", "cuts": [1] * len(planes) + [0] * (len(planes) + 1), "planes": planes,
            "cells": [["0"] * 3] * (len(planes) + 1), "rays_first": [], "rays_second": []}
    return claimed("meshes", [{"name": name, **mesh} for name in "ab"], *[
        {"question": "meshes", "a": 0, "b": 1, "verdict": "equal", "claims": [tree]}] * times)


def mesh_on(*meshes, size="0x1p0"):
    """Faces of meshes upon the first of a tetrahedron."""
    corners = [ZEROS, [size, "0x0p0", "0x1p-30"], ["0x0p0", size, "0x1p-30"], ["0x0p0", "0x0p0", size]]
    return claimed("bodies", [{"name": "a", "points": corners}], TETRAHEDRON, *[
        {"question": "mesh", "body": 0, "mesh_faces": mesh, "verdict": "convex",
         "claims": [{"claim": "bounds_hull", "beneath": [0] * len(mesh)}]} for mesh in meshes])


def measured(size, count):
    """Sections of a tetrahedron in a triangle."""
    corners = [ZEROS, [size, "0x0p0", "0x1p-1070"], ["0x0p0", size, "0x0p0"], ["0x0p0", "0x0p0", size]]
    return claimed("bodies", [{"name": "a", "points": corners}], TETRAHEDRON, *[
        {"question": "section", "of": 0, "plane": ["0x0p0", "0x0p0", "0x1p0", "0x0p0", "0x0p0", "0x0p0", "0x1p-1"],
         "verdict": "measured", "corners": [[3, 0], [3, 1], [3, 2]], "area_from": "0x0p0", "area_to": "0x1p1000",
         "claims": [{"claim": "outlined", "along": [1, 2, 3]}, {"claim": "area"}]}] * count)


def ring_of_ends():
    return [["0x0p0", "0x0p0"], ["0x1p0", "0x0p0"], ["0x0p0", "0x1p0"]]


HOSTILE = {  # about 1 MB each, but for those that need less
    "many pairs of a large body": lambda: bodies([ZEROS] * 18000, [apart(["1", "0", "0"])] * 5500),
    "the same, long integers": lambda: bodies([EXTREME] * 12000, [apart(["1", "0", "0"])] * 4500),
    "long directions": lambda: bodies([EXTREME] * 11000, [apart([digits(20000), digits(20000), "1"])] * 8),
    "exponents": lambda: bodies([EXTREME] * 1000, [apart(EXPONENTS)] * 7000),
    "exponents, one vertex": lambda: bodies([EXTREME], [apart(EXPONENTS)] * 9000, linear=EXTREME + UNIT[3:]),
    "16 long weights": lambda: bodies([EXTREME] * 16, [meet(16, 19990)]),
    "16 weights, often": lambda: bodies([EXTREME] * 16, [meet(16, 1000)] * 31),
    "4 long weights": lambda: bodies([EXTREME] * 16, [meet(4, 9000)] * 13),
    "a long name": lambda: bodies([ZEROS], [apart(["1", "0", "0"])] * 6000, name="n" * 400000),
    "a name, often": lambda: bodies([ZEROS], [apart(["1", "0", "0"])] * 9000, name="n" * 4000),
    "convex polygons, often": lambda: claimed(
        "convex_polygons", [[["0x%xp0" % i, "0x0p0"], ["0x%xp0" % (i + 1), "0x0p0"], ["0x0p0", "0x1p0"]] for i in range(9000)],
        *[{"question": "convex_polygons_common_part", "verdict": "empty",
           "claims": [{"claim": "contradict", "weights": [[0, "1"], [1, "1"]]}]}] * 4000),
    "discs, often": lambda: region([["0x0p0", "0x0p0", "0x1p0"]] * 15000, [0], count=3),
    "arcs": lambda: ring_of_discs(900),
    "many arcs": lambda: ring_of_discs(9000),
    "arcs of long integers": lambda: region([["0x1p-1074", "0x%xp0" % i, "0x1p900"] for i in range(3000)], list(range(3000))),
    "a point of discs, often": lambda: powers([ZEROS] * 16000, [[0, "1"]], 3000),
    "a long weight of a disc": lambda: powers([ZEROS] * 20000, [[0, digits(19000)]], 10),
    "a point in large polygons, often": lambda: claimed(
        "polygons", [[parabola(12000)]] * 2, *some_of("polygons", ["0", "0"], 3500)),
    "a long point in large polygons": lambda: claimed(
        "polygons", [[parabola(14000)]] * 2, *some_of("polygons", ["1/" + digits(19000), "0"], 10)),
    "a long point in edges that go to and fro": lambda: claimed(
        "polygons", [[[["0x%xp0" % (i % 2), "0x%xp0" % i] for i in range(20000)]]] * 2,
        *some_of("polygons", ["1/" + digits(19000), "0"], 2)),
    "a long point in discs": lambda: region([["0x0p0", "0x0p0", "0x1p0"]] * 30000, [0], ("1/" + digits(19000), "0"), 2),
    "long points in two discs": lambda: claimed(
        "circles", [["0x0p0", "0x0p0", "0x1p0"]] * 2,
        *[some_of("circles", ["1/" + digits(900), "0"], 1, kind="inside")[0] for _ in range(900)]),
    "parts of a large polygon, in turns": lambda: parts_in_turns(12000, 5000),
    "parts of a large polygon, in one way": lambda: parts_in_turns(12000, 5000, [[0]]),
    "many members": lambda: claimed("bodies", [{"name": "a", "points": [ZEROS]}] * 12000,
                                    *[all_pairs(12000, range(12000))] * 3),
    "members of few groups": lambda: claimed("bodies", [{"name": "a", "points": [ZEROS]}] * 12000,
                                             *[all_pairs(12000, [i % 2 for i in range(12000)])] * 4),
    "cones of extreme numbers": lambda: around("cone", *[kept(EXPONENTS)] * 8000),
    "cylinders of extreme numbers": lambda: around("cylinder", *[kept(["1", "0", "1"])] * 8000),
    "cones, long directions": lambda: around("cone", *[kept(["0x" + "f" * 19000 + "p0", "1", "1"])] * 50),
    "ellipsoids, longer directions": lambda: around("ellipsoid", *[kept([fraction(19990)] * 3)] * 16),
    "balls, often": lambda: around("radius", *[held(["0x1p-20000", "0x1p20000", "0"])] * 6000),
    "long points of cylinders": lambda: around("cylinder", *[held([fraction(6000)] * 3)] * 50),
    "long points of cones": lambda: around("cone", *[held([fraction(19000), "0", "1"], weight="2/2")] * 50),
    "long points of ellipsoids": lambda: around("ellipsoid", *[held(["1"] * 3, [fraction(19000)] * 3)] * 8),
    "clearances of long points": lambda: bodies([EXTREME] * 2, [broken(digits(9000))] * 25),
    "a hull of many points, often": lambda: hulls(9000, 1500),
    "hulls of long integers": lambda: hulls(8000, 200, EXTREME),
    "one point, often": lambda: claimed("bodies", [{"name": "a", "points": [["0x1p1023"] * 3] * 10999 + [["0x1p-1074"] * 3]}], *[
        {"question": "hull", "body": 0, "verdict": "point", "claims": [{"claim": "one_point"}]}] * 4500),
    "a ring around many points": lambda: claimed("bodies", [{"name": "a", "points": circle_in_space(6000)}], {
        "question": "hull", "body": 0, "verdict": "flat", "outline": list(range(6000)),
        "claims": [{"claim": "outline", "sectors": [None] * 6000}]}),
    "a simplex around many points": lambda: simplex(6, 18000, "0x1p10", "0x1p0", 1),
    "a simplex around a point, often": lambda: simplex(6, 1, "0x1p10", "0x1p0", 4000),
    "a simplex of long integers": lambda: simplex(6, 4000, "0x1p1023", "0x1p-1074", 1),
    "a drum": lambda: drum(5000, 0),
    "a drum without a cap": lambda: drum(5000, 1),
    "a circle of far points": lambda: claimed(
        "polygons", [[[["0x1p0", "0x0p0"], ["0x1p0", "0x1p0"]]] * 12000],
        {"question": "valid", "parts": [0], "rule": "valid", "verdict": "circle", "rings": list(range(12000)),
         "points": [["1", "0x%xp-20000" % (k + 1)] for k in range(12000)], "claims": [{"claim": "circle"}]}),
    "a point beside many rings": lambda: beside_rings(14000, ["2/7", "4/14"], 308),
    "a long point beside many rings": lambda: beside_rings(17000, [digits(9990) + "/" + digits(9990)] * 2, 2),
    "linear programs": lambda: claimed("half_planes", [["0x1p0", "0x0p0", "0x0p0"]] * 18000,
                                       *[unbounded(["0", "0"])] * 2500),
    "linear programs with long points": lambda: claimed(
        "half_planes", [["0x1p0", "0x0p0", "0x0p0"]] * 18000, *[unbounded(["-" + fraction(19900), "0"])] * 20),
    "linear programs of long integers": lambda: claimed(
        "half_planes", [["0x1p1000", "0x1p-1074", "0x0p0"]] * 15000, *[unbounded(["0", "0"])] * 2500),
    "long half-planes": lambda: far_corner(["-0x1p-1074", "-0x1p1023", "0x1p0"], 24000),
    "long arrows": lambda: far_corner(["0x0p0", "0x1p1023", "0x1p1023", "-0x1p-1074"], 17000),
    "16 long weights": lambda: claimed("bodies", [{"name": "a", "points": [EXTREME] * 16}], {
        "question": "pair", "a": 0, "b": 0, "verdict": "meet", "point": ["1", "1", "1"],
        "claims": [{"claim": "holds", "weights": [[i, fraction(19000)] for i in range(16)]}] * 2}),
    "a sweep over long integers": lambda: swept(
        [["0x1p-1074", "0x%xp0" % i, "0x1p1023", "0x%xp0" % i] for i in range(9000)],
        [[2 * i, i - 1, i] for i in range(9000)] + [[2 * i + 1, -1] for i in range(9000)]),
    "a fan": lambda: fan(7000),
    "crossings in no order": lambda: hatch(2000),
    "one crossing, often": lambda: one_crossing(70000),
    "few segments, often": lambda: claimed(
        "segments", [["0x0p0", "0x0p0", "0x1p0", "0x0p0"]] * 12000,
        *[{"question": "segments", "allowed": "nothing", "verdict": "none",
           "claims": [{"claim": "none_counts", "events": []}]}] * 5000),
    "a long point, often": lambda: claimed(
        "segments", [["0x1p-1074", "0x0p0", "0x1p1023", "0x0p0"]] * 2,
        *[{"question": "segments", "allowed": "nothing", "verdict": "some", "i": 0, "j": 1, "kind": "overlap",
           "point": EXPONENTS[:2], "claims": [{"claim": "contact"}]}] * 7000),
    "long weights of half-planes": lambda: claimed(
        "half_planes", [["0x1p0", "0x%xp0" % (i + 1), "0x0p0"] for i in range(16)],
        *[claimed_program([{"claim": "contradict", "weights": [[i, fraction(3000)] for i in range(16)]}],
                          verdict="infeasible")] * 20),
    "ends of long integers": lambda: claimed(
        "half_planes", [["-0x1p0", "0x0p0", "0x0p0"]] * 15000,
        *[claimed_program([{"claim": "feasible"}, {"claim": "bounds", "weights": [[0, "1"]]},
                           {"claim": "ends", "ends": [[["0", digits(9000)], 0], None]}],
                          verdict="many", point=["0", "0"])] * 40),
    "ways across a direction, often": lambda: claimed(
        "bodies", [{"name": "a", "points": [ZEROS]},
                   {"name": "b", "points": [ZEROS], "ways": [["0x%xp0" % i, "0x1p0", "0x0p0"] for i in range(12000)]}],
        *[{"question": "nearest", "a": 0, "b": 1, "verdict": "point", "i": 0,
           "claims": [{"claim": "first_along", "direction": ["0", "0", "1"]}]}] * 4000),
    "a line of many points, often": lambda: claimed(
        "bodies", [{"name": "a", "points": [ZEROS]}, {"name": "b", "points": [["0x%xp0" % i, "0x0p0", "0x0p0"] for i in range(14000)]}],
        *[{"question": "common_part", "a": 0, "b": 1, "verdict": "between", "first": ["0"] * 3, "last": ["0"] * 3,
           "claims": [{"claim": "holds", "weights": [[0, "1"]]}] * 4 + [
               {"claim": "no_further", "before": ["-1", "0", "0"], "after": ["1", "0", "0"]}]}] * 1500),
    "a deep tree of planes": lambda: tree_of_planes(["0x1p0"] * 3, [["1", "0", "0", str(-k)] for k in range(1, 22000)]),
    "trees of planes of long integers": lambda: tree_of_planes(["0x1p0"] * 3, [
        [digits(9000)] * 4, *[["1", "2", str(k), "1"] for k in range(400)]]),
    "trees of planes, often": lambda: tree_of_planes(["0x1p0", "0x3p0", "0x5p0"], [["1", "0", "0", "9"]], points=9000, times=2000),
    "a mesh on one face": lambda: mesh_on([[0, 1, 2]] * 55000),
    "a mesh on one face, often": lambda: mesh_on(*[[[0, 1, 2]] * 3] * 7000),
    "a mesh on one face of long integers": lambda: mesh_on([[0, 1, 2]] * 55000, size="0x1p1000"),
    "areas, often": lambda: measured("0x1p0", 4500),
    "areas of long integers": lambda: measured("0x1.8p1000", 4500),
    "rings, often": lambda: claimed("rings", [parabola(12000)], *[
        {"question": "ring", "ring": 0, "verdict": "simple", "claims": [{"claim": "valid", "events": []}]}] * 5000),
    "two polygons, in turns": lambda: claimed("polygons", [[parabola(9000)], [ring_of_ends()], [ring_of_ends()]], *[
        {"question": "two_polygons", "pair": [0, 1 + k % 2], "verdict": "apart",
         "claims": [{"claim": "how_two_meet", "events": []}]} for k in range(4000)]),
    "many keys": lambda: {"sunder_certificate": 3, **{"k%d" % i: 0 for i in range(80000)}},
    "strings that do not end": lambda: "[" + '"\\' * 499000,
    "backslashes": lambda: '["' + "\\\\" * 499000 + '"]',
    "surrogates": lambda: '["' + "\\ud800" * 160000 + '"]',
    "brackets": lambda: "[" * 500 + "[],{}," * 160000 + "1" + "]" * 500,
}
