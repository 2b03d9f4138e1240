"""Statements about two meshes as they are, forced: solids of unit cells, and surfaces, whose truth is known by the cells."""
import copy
import itertools
import os
import unittest
from fractions import Fraction

import files
from files import FORCED, MUTANT, Twins, dice_of, fraction, hexadecimal, lacking
from mesh_cells import cover, direction, divided, inside, pieces, some_pair, tables_of, told_point

def statement(verdict, a, b, *claims, **says):
    return {"question": "meshes", "a": a, "b": b, "verdict": verdict, **says, "claims": list(claims)}


def wanted():
    """The verdicts of which too few have been tried, or none has been accepted yet."""
    return [verdict for verdict in files.QUESTIONS["meshes"][-1]
            if verdict in lacking(FORCED, "meshes") or not files.TRIED["accepted"]["meshes", verdict]]


class MeshPairs(unittest.TestCase):
    def setUp(self):
        self.dice, self.twins = dice_of(4001), Twins(self)

    def ask(self, tables, said, is_true):
        """What is said of a statement that is true, or must not be accepted."""
        top = files.file_of(tables, said)
        found = self.twins.force(top)
        if is_true is not None:
            self.assertEqual(found == "accepted", is_true, (found, top))
        return top, found

    def test_apart_and_within(self):
        dice = self.dice
        for _ in range(files.some(20000) + 2000):
            still = {*wanted()}
            if not still:
                break
            a, b = some_pair(self.dice)
            tables, i, j = tables_of(a, b)
            found = cover(a, b, dice) if still & {"apart", "a_inside_b", "b_inside_a"} else None
            if found and "apart" in still:
                self.ask_apart(tables, i, j, a, b, found)
            if found and still & {"a_inside_b", "b_inside_a"}:
                self.ask_nested(tables, i, j, a, b, found)
            if still & {"meet", "overlapping", "a_within", "b_within"}:
                self.ask_points(tables, i, j, a, b)
            if still & {"touching", "a_part_of_b", "b_part_of_a", "equal"}:
                self.ask_relations(tables, i, j, a, b)
        self.twins.compare()
        self.assertEqual(wanted(), [])

    def ask_apart(self, tables, i, j, a, b, found):
        dice = self.dice
        rays_a = [[t, direction(dice)] for t in pieces(a)]
        rays_b = [[t, direction(dice)] for t in pieces(b)]
        is_nested = any(b.is_in(a.places()[a.triangles[t][0]]) for t, _ in rays_a) or any(
            a.is_in(b.places()[b.triangles[t][0]]) for t, _ in rays_b)
        claim = {"claim": "covered", "cuts": found[0], "directions": found[1], "rays_a": rays_a, "rays_b": rays_b}
        top, said = self.ask(tables, statement("apart", i, j, claim), None)
        if is_nested:
            self.assertNotEqual(said, "accepted", top)
            for rays in ([], rays_a), ([], rays_b):  # a piece that is not asked about
                claim = {**claim, "rays_a": rays[0], "rays_b": rays[1]}
                self.ask(tables, statement("apart", i, j, claim), False if len(found[0]) > 1 else None)
            return
        for _ in range(9):
            if said == "accepted":
                break
            self.assertEqual(said, "covered")  # a ray met an edge: others do not
            for ray in rays_a + rays_b:
                ray[1] = direction(dice)
            top, said = self.ask(tables, statement("apart", i, j, claim), None)
        self.assertEqual(said, "accepted", top)
        for _ in range(2):
            worse = copy.deepcopy(claim)
            if dice.random() < .5:
                k = dice.randrange(len(worse["cuts"]))
                worse["cuts"][k:k + 1] = dice.choice(([], [0], [1], [-1], [worse["cuts"][k], 0], [-worse["cuts"][k]]))
            else:
                k = dice.randrange(len(worse["directions"]))
                worse["directions"][k] = dice.choice((["0", "0", "0"], direction(dice), [
                    str(-int(x)) for x in worse["directions"][k]]))
            self.ask(tables, statement("apart", i, j, worse), None)  # the twins agree

    def ask_until_rays_miss_edges(self, tables, make, is_true):
        """What is true is accepted, but where a ray meets an edge: then others are taken."""
        for _ in range(30):
            top, found = self.ask(tables, make(), None)
            if found == "accepted":
                self.assertTrue(is_true, top)
                return
        self.assertFalse(is_true, top)

    def ask_nested(self, tables, i, j, a, b, found):
        dice = self.dice
        for verdict, of, other in ("a_inside_b", a, b), ("b_inside_a", b, a):
            cuts, directions = found
            if of is b:  # the walk of the other order
                cuts, directions = [-k for k in cuts], [[str(-int(x)) for x in d] for d in directions]
            inner = [[t, None] for t in pieces(of)]
            outer = [[t, None] for t in pieces(other)]
            is_true = all(other.is_in(of.places()[of.triangles[t][0]]) for t, _ in inner) and not any(
                of.is_in(other.places()[other.triangles[t][0]]) for t, _ in outer)

            def make(inner=inner, outer=outer, cuts=cuts, directions=directions, verdict=verdict):
                rays = [[[t, direction(dice)] for t, _ in those] for those in (inner, outer)]
                return statement(verdict, i, j, {"claim": "covered_within", "cuts": cuts, "directions": directions,
                                                 "rays_inner": rays[0], "rays_outer": rays[1]})
            if is_true:
                self.ask_until_rays_miss_edges(tables, make, True)
                for missing in ("rays_inner", "rays_outer"):
                    said = make()
                    said["claims"][0][missing].pop()
                    self.ask(tables, said, False if missing == "rays_inner" else None)
            else:
                self.ask(tables, make(), False)

    def ask_relations(self, tables, i, j, a, b):
        dice = self.dice
        found = divided(a, b, dice, 12 if dice.random() < .98 else 10 ** 6)
        if found is None:
            return
        tree, truth = found
        common = next((p for p in a.places() if p in b.places()), None)
        told = {"touching": ("insides_apart", not any(x and y for x, y in truth) and common is not None),
                "a_part_of_b": ("part_of", not any(x and not y for x, y in truth)),
                "b_part_of_a": ("part_of", not any(y and not x for x, y in truth)),
                "equal": ("equal_insides", all(x == y for x, y in truth))}
        for verdict in [verdict for verdict in wanted() if verdict in told]:
            rule, is_true = told[verdict]
            needed = [{"touching": [not x, not y and x], "a_part_of_b": [not x, x], "b_part_of_a": [y, not y],
                       "equal": [True, True]}[verdict] for x, y in truth]

            def make(verdict=verdict, rule=rule, needed=needed):
                rays = [[[k, direction(dice)] for k, need in enumerate(needed) if need[which]] for which in (0, 1)]
                if verdict == "b_part_of_a":
                    rays = rays[::-1]
                claim = {"claim": rule, **copy.deepcopy(tree), "rays_first": rays[0], "rays_second": rays[1]}
                if verdict != "touching":
                    return statement(verdict, i, j, claim)
                point = common or a.places()[0]
                on = [{"claim": "on_triangle", "triangle": next(n for n, t in enumerate(of.triangles) if v in t),
                       "weights": [[v, "1"]]} for of in (a, b)
                      for v in [next((k for k, p in enumerate(of.places()) if p == point), 0)]]
                return statement(verdict, i, j, *on, claim, point=told_point(point))
            if is_true:
                self.ask_until_rays_miss_edges(tables, make, True)
                self.ask_worse(tables, make())
            else:
                self.ask(tables, make(), False)

    def ask_worse(self, tables, said):
        """With one thing wrong: a ray left out is always missed; of other changes the twins say the same."""
        dice, claim = self.dice, said["claims"][-1]
        throw, key = dice.random(), dice.choice(("rays_first", "rays_second"))
        if throw < .3 and claim[key]:
            claim[key].pop(dice.randrange(len(claim[key])))
            self.ask(tables, said, False)
        elif throw < .5 and claim["planes"]:
            plane = dice.choice(claim["planes"])
            plane[3] = fraction(Fraction(plane[3]) + Fraction(dice.choice((-1, 1)), 2 ** dice.choice((1, 70))))
            self.ask(tables, said, None)
        elif throw < .7:
            claim["cells"].reverse()
            self.ask(tables, said, None)
        else:
            k = dice.randrange(len(claim["cuts"]))
            claim["cuts"][k:k + 1] = dice.choice(([], [0, 0], [1, 1], [2], [-1], [1 - claim["cuts"][k]]))
            self.ask(tables, said, False)

    def ask_points(self, tables, i, j, a, b):
        dice = self.dice
        for verdict, of, other in ("a_within", a, b), ("b_within", b, a):
            point, claim = inside(of, dice)
            claims = [claim, {"claim": "encloses", "direction": direction(dice)}]
            told = told_point(point)
            said = statement(verdict, i, j, *(claims if verdict[0] == "a" else claims[::-1]), point=told)
            top, found = self.ask(tables, said, None)
            if found == "accepted":
                self.assertTrue(other.is_in(point), top)
            # A point anywhere in a cell of one.
            cell = dice.choice([*of.cells])
            place = [of.step * (x + s + Fraction(dice.randint(0, 3), 8)) for x, s in zip(cell, of.shift)]
            both = [{"claim": "encloses", "direction": direction(dice)} for _ in range(2)]
            top, found = self.ask(tables, statement("overlapping", i, j, *both, point=told_point(place)), None)
            if found == "accepted":
                self.assertTrue(a.is_in(place) and b.is_in(place), top)
            # Two triangles that hold one point.
            back, claim_too = inside(other, dice)
            both = [claim, claim_too] if verdict[0] == "a" else [claim_too, claim]
            self.ask(tables, statement("meet", i, j, *both, point=told), True if back == point else False)
        self.ask_common_corner(tables, i, j, a, b)

    def ask_common_corner(self, tables, i, j, a, b):
        corners = {tuple(p): k for k, p in enumerate(a.places())}
        for k, p in enumerate(b.places()):
            if tuple(p) not in corners:
                continue
            claims = [{"claim": "on_triangle", "triangle": next(n for n, t in enumerate(of.triangles) if v in t),
                       "weights": [[v, "1"]]} for of, v in ((a, corners[tuple(p)]), (b, k))]
            self.ask(tables, statement("meet", i, j, *claims, point=told_point(p)), True)
            off = [fraction(Fraction(x) + Fraction(1, 2 ** 90)) for x in p]
            self.ask(tables, statement("meet", i, j, *claims, point=off), False)
            return

    def test_mutants(self):
        dice = dice_of(4002)
        while lacking(MUTANT, "meshes"):
            a, b = some_pair(self.dice)
            if len(a.triangles) + len(b.triangles) > 150:
                continue
            tables, i, j = tables_of(a, b)
            found = cover(a, b, dice)
            says = []
            if found:
                rays = [[[t, direction(dice)] for t in pieces(of)] for of in (a, b)]
                says.append(statement("apart", i, j, {"claim": "covered", "cuts": found[0], "directions": found[1],
                                                      "rays_a": rays[0], "rays_b": rays[1]}))
            point, claim = inside(a, dice)
            back, claim_too = inside(b, dice)
            ray = {"claim": "encloses", "direction": direction(dice)}
            says += [statement("meet", i, j, claim, claim_too, point=told_point(point)),
                     statement("overlapping", i, j, ray, ray, point=told_point(back)),
                     statement("a_within", i, j, claim, ray, point=told_point(point)),
                     statement("b_within", i, j, ray, claim_too, point=told_point(back))]
            says += self.spoilable_relations(i, j, a, b, claim, claim_too, point)
            for said in says:
                self.twins.spoil(files.file_of(tables, said), dice)
        self.twins.compare()


    def spoilable_relations(self, i, j, a, b, claim, claim_too, point):
        dice = self.dice
        tree, truth = divided(a, b, dice, 10 ** 6)
        if len(truth) > 30:
            return []
        rays = [[[k, direction(dice)] for k in range(len(truth))] for _ in (0, 1)]
        parts = {"rays_first": rays[0], "rays_second": rays[1]}
        rays = [[[t, direction(dice)] for t in pieces(of)] for of in (a, b)]
        nested = {"claim": "covered_within", "cuts": [0], "directions": [direction(dice)], "rays_inner": rays[0],
                  "rays_outer": rays[1]}
        return [statement("touching", i, j, claim, claim_too, {"claim": "insides_apart", **tree, **parts},
                          point=told_point(point)),
                statement("a_part_of_b", i, j, {"claim": "part_of", **tree, **parts}),
                statement("b_part_of_a", i, j, {"claim": "part_of", **tree, **parts}),
                statement("equal", i, j, {"claim": "equal_insides", **tree, **parts}),
                statement("a_inside_b", i, j, nested), statement("b_inside_a", i, j, nested)]


def box(low, size, outwards=True):
    """Its corners, and two triangles a face."""
    corners = [[a + k * size for a, k in zip(low, ks)] for ks in itertools.product((0, 1), repeat=3)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    triangles = [t for a, b, c, d in faces for t in ([a, b, c], [a, c, d])]
    return corners, [t if outwards else t[::-1] for t in triangles]


def mesh(name, *boxes):
    points, triangles = [], []
    for corners, some in boxes:
        triangles += [[k + len(points) for k in t] for t in some]
        points += corners
    return {"name": name, "points": [[hexadecimal(Fraction(x)) for x in p] for p in points], "triangles": triangles}


class Covers(unittest.TestCase):
    """Walks and rays, each with one thing wrong."""

    def tell(self, wanted, said, *meshes):
        twins = Twins(self)
        self.assertEqual(twins.look(files.file_of({"meshes": list(meshes)}, said)), wanted, said)
        twins.compare()

    def covered(self, wanted, meshes, cuts, directions, rays_a=(), rays_b=()):
        self.tell(wanted, statement("apart", 0, 1, {"claim": "covered", "cuts": cuts, "directions": directions,
                                                    "rays_a": list(rays_a), "rays_b": list(rays_b)}), *meshes)

    RAYS = [[0, ["17", "29", "41"]]], [[0, ["17", "29", "41"]]]

    def test_a_walk(self):
        near, far, right = mesh("a", box([0, 0, 0], 1)), mesh("b", box([3, 0, 0], 1)), ["1", "0", "0"]
        self.covered("accepted", (near, far), [0], [right])
        self.covered("accepted", (near, far), [5, 0, -3, 0, 0], [right] * 3, *self.RAYS)
        self.covered("accepted", (near, far), [5, 2, 0, 0, 0], [right] * 3, *self.RAYS)
        for cuts, count in (([], 0), ([0], 2), ([0], 0), ([0, 0], 2), ([5, 0], 1), ([5, 0, 0], 3), ([12, 0, 0], 2),
                            ([-12, 0, 0], 2), ([13, 0, 0], 2), ([5, 5, 0, 0, 0], 3), ([5, 6, 0, 0, 0], 3),
                            ([5, 0, 5, 0, 0], 3), ([-5, -5, 0, 0, 0], 3)):
            self.covered("covered", (near, far), cuts, [right] * count, *self.RAYS)
        for way in ["-1", "0", "0"], ["0", "0", "0"], ["0", "1", "0"]:
            self.covered("covered", (near, far), [0], [way])
        self.covered("covered", (near, mesh("b", box([1, 0, 0], 1))), [0], [right])

    def test_the_order_of_a_walk(self):
        """What is before a cut comes first: of two boxes of A, one on either side of B."""
        sides, middle = mesh("a", box([0, 0, 0], 1), box([6, 0, 0], 1)), mesh("b", box([3, 0, 0], 1))
        right, left, ray = ["1", "0", "0"], ["-1", "0", "0"], ["17", "29", "41"]
        both = [[0, ray], [12, ray]], [[0, ray]]
        self.covered("accepted", (sides, middle), [12, 0, 0], [right, left], *both)
        self.covered("covered", (sides, middle), [12, 0, 0], [left, right], *both)
        self.covered("accepted", (middle, sides), [-12, 0, 0], [left, right], *both[::-1])
        self.covered("covered", (middle, sides), [-12, 0, 0], [right, left], *both[::-1])

    def test_each_corner_of_a_small_part_counts(self):
        """Of a mesh with many points one triangle, which reaches beyond B along one direction with one corner alone."""
        corners, far = [[0, 5, 0], [0, 6, 0], [4, 5, 0]], mesh("b", box([3, 0, 0], 1))
        right, down, ray = ["1", "0", "0"], ["0", "-1", "0"], [[0, ["17", "29", "41"]]]
        for turn in range(3):
            many = mesh("a", *(box([-2 * k, 0, 0], 1) for k in range(5)), (corners[turn:] + corners[:turn], [[0, 1, 2]]))
            for way, wanted in (down, "accepted"), (right, "covered"):
                self.covered(wanted, (many, far), [60, 0, 0], [right, way], (), ray)
                back = [[str(-int(x)) for x in d] for d in (right, way)]
                self.covered(wanted, (far, many), [-60, 0, 0], back, ray, ())

    def test_each_piece_is_asked_about(self):
        """Of two boxes of A one is inside of B; and of two in a shell, both are outside."""
        ray = ["17", "29", "41"]
        shell = box([0, 0, 0], 16), box([2, 2, 2], 12, False)
        small = [box([x, 7, 7], 1) for x in (7, 10, 99, Fraction(1, 2))]
        found = {}
        for name, boxes in (("inside", (small[3], small[2])), ("inside_last", (small[2], small[3])), ("in_the_hole", (small[0], small[1]))):
            walk, directions, left = [], [], [((0, 24), (0, 24))]
            triangles = [[[corners[k] for k in t] for corners, some in those for t in some] for those in (boxes, shell)]
            while left:
                parts = left.pop()
                points = [[p for t in triangles[n][slice(*parts[n])] for p in t] for n in (0, 1)]
                fits = [(c, w) for c in range(3) for w in (1, -1)
                        if max(w * p[c] for p in points[0]) < min(w * p[c] for p in points[1])]
                if fits:
                    c, w = fits[0]
                    walk.append(0)
                    directions.append([str(w * (k == c)) for k in range(3)])
                    continue
                n = int(parts[1][1] - parts[1][0] >= parts[0][1] - parts[0][0])
                first, end = parts[n]
                middle = (first + end) // 2
                walk.append(-middle if n else middle)
                for half in (middle, end), (first, middle):
                    left.append((parts[0], half) if n else (half, parts[1]))
            found[name] = mesh("a", *boxes), walk, directions
        b = mesh("b", *shell)
        for name, rays in itertools.product(("inside", "inside_last"), ([], [[0, ray]], [[12, ray]], [[0, ray], [12, ray]], [[12, ray], [13, ray]])):
            inside, walk, directions = found[name]
            self.covered("covered", (inside, b), walk, directions, rays, [[0, ray], [12, ray]])
        holes, walk, directions = found["in_the_hole"]
        self.covered("accepted", (holes, b), walk, directions, [[0, ray], [12, ray]], [[0, ray], [12, ray]])
        for rays_a, rays_b in (([[0, ray]], [[0, ray], [12, ray]]), ([[0, ray], [12, ray]], [[12, ray]]), ([], [])):
            self.covered("covered", (holes, b), walk, directions, rays_a, rays_b)

    def encloses(self, wanted, of, point, way, verdict="overlapping"):
        claim = {"claim": "encloses", "direction": way}
        self.tell(wanted, statement(verdict, 0, 0, claim, claim, point=point), of)

    def test_rays(self):
        one = mesh("a", box([0, 0, 0], 4))
        self.encloses("accepted", one, ["1", "3/2", "2"], ["17", "29", "41"])
        behind = mesh("a", box([0, 0, 0], 9), box([-5, -5, -5], 1))
        self.encloses("accepted", behind, ["1", "2", "3"], ["5", "6", "7"])  # a corner is behind
        for way in ["1", "1", "0"], ["1", "1", "1"], ["0", "0", "0"]:  # to an edge, a corner, the diagonal of a face
            self.encloses("encloses", one, ["1", "1", "1"], way)
        self.encloses("encloses", one, ["1", "1", "2"], ["0", "0", "1"])
        for point in ["0", "1", "2"], ["0", "0", "0"], ["0", "0", "1"]:  # on a face, a corner, an edge
            self.encloses("encloses", one, point, ["17", "29", "41"])
        for point in ["-1", "1", "2"], ["5", "1", "2"], ["1", "9", "2"]:
            for way in ["17", "29", "41"], ["-17", "3", "4"]:
                self.encloses("encloses", one, point, way)

    def test_how_often_it_winds(self):
        twice = mesh("a", box([0, 0, 0], 9), box([2, 2, 2], 3))
        hole = mesh("a", box([0, 0, 0], 9), box([2, 2, 2], 3, False))
        turned = mesh("a", box([0, 0, 0], 9), box([2, 2, 2], 3))
        turned["triangles"][0].reverse()
        for of, inner, outer in (twice, "accepted", "accepted"), (hole, "encloses", "accepted"), (turned, "encloses", "accepted"):
            self.encloses(inner, of, ["3", "7/2", "4"], ["17", "29", "41"])
            self.encloses(outer, of, ["1", "3/2", "8"], ["17", "29", "41"])

    def test_points_are_different(self):
        double = mesh("a", box([0, 0, 0], 1))
        double["points"].append(double["points"][0])
        self.covered("F", (double, mesh("b", box([3, 0, 0], 1))), [0], [["1", "0", "0"]])


class Trees(unittest.TestCase):
    """Trees of planes, each with one thing wrong."""
    RAY = ["17", "29", "41"]

    def touching(self, wanted, tree, a, b, corner):
        """A tree is a plane with what is above and below it, or a cell: its point, and the meshes shown not to be there."""
        claim = {"claim": "insides_apart", "cuts": [], "planes": [], "cells": [], "rays_first": [], "rays_second": []}

        def tell(node):
            claim["cuts"].append(len(node) - 2)
            if len(node) == 3:
                claim["planes"].append([fraction(Fraction(x)) for x in node[0]])
                tell(node[1])
                tell(node[2])
                return
            for key in node[1]:
                claim[key].append([len(claim["cells"]), self.RAY])
            claim["cells"].append(told_point(node[0]))
        tell(tree)
        on = [{"claim": "on_triangle", "triangle": next(n for n, t in enumerate(of["triangles"]) if k in t), "weights": [[k, "1"]]}
              for of in (a, b) for k in [of["points"].index([hexadecimal(Fraction(x)) for x in corner])]]
        twins = Twins(self)
        said = statement("touching", 0, 1, *on, claim, point=told_point(corner))
        self.assertEqual(twins.look(files.file_of({"meshes": [a, b]}, said)), wanted, said)
        twins.compare()

    def test_points_of_cells(self):
        """Two boxes that touch; the point of a cell is strictly within it."""
        a, b, half = mesh("a", box([0, 0, 0], 1)), mesh("b", box([1, 0, 0], 1)), Fraction(1, 2)
        for x, wanted in ((2, "accepted"), (1, "insides_apart"), (half, "insides_apart")):
            above, below = ([x, 5, half], ["rays_first"]), ([half, half, half], ["rays_second"])
            self.touching(wanted, ([1, 0, 0, 1], above, below), a, b, [1, 0, 0])
            self.touching(wanted, ([-1, 0, 0, -1], below, above), a, b, [1, 0, 0])

    def test_a_corner_on_a_plane_belongs_to_both_sides(self):
        """A plane goes through a corner of triangles and cuts them. Beside it, under the top of A, is a box of B; another
        one touches A, so that nothing but the top of A refuses the tree."""
        b = mesh("b", box([-1, 0, 0], 1), box([Fraction(1, 2), Fraction(11, 8), Fraction(5, 4)], Fraction(1, 16)))
        for top, wanted in ((2, "insides_apart"), (Fraction(1, 4), "accepted")):
            a = mesh("a", ([[x, y, top if z else 0] for x in (0, 2) for y in (0, 2) for z in (0, 1)], box([0, 0, 0], 2)[1]))
            for way in 1, -1:
                around = ([0, -1, 0, Fraction(-19, 10)], ([Fraction(1, 2), Fraction(3, 2), 3], ["rays_first"]),
                          ([Fraction(1, 2), 3, 3], ["rays_second"]))
                beside = ([1, 0, 0, Fraction(1, 4)], ([0, 0, 1, 1], around, ([Fraction(1, 2), Fraction(3, 2), Fraction(1, 2)], ["rays_second"])),
                          ([Fraction(1, 8), 1, Fraction(1, 2)], ["rays_second"]))
                rest = [1, 1, 1], ["rays_second"]
                halves = (beside, rest) if way > 0 else (rest, beside)
                tree = ([1, 0, 0, 0], ([-2 * way, way, 0, 0], *halves), ([Fraction(-1, 2), 5, Fraction(1, 2)], ["rays_first"]))
                self.touching(wanted, tree, a, b, [0, 0, 0])


class Pieces(unittest.TestCase):
    """Which triangles bound an inside, as sentences tell."""

    def sentence(self, points, triangles):
        mesh = {"name": "m", "points": [[hexadecimal(Fraction(x)) for x in p] for p in points], "triangles": triangles}
        far = {"name": "f", "points": [["0x1p+9"] * 3], "triangles": [[0, 0, 0]]}
        claim = {"claim": "covered", "cuts": [0], "directions": [["1", "1", "1"]], "rays_a": [], "rays_b": []}
        top = files.file_of({"meshes": [mesh, far]}, statement("apart", 0, 1, claim))
        twins = Twins(self)
        self.assertEqual(twins.look(top), "accepted")
        twins.compare()
        return files.told(files.json.dumps(top))[1][0].partition(" of \"m\"")[0]

    TETRAHEDRON = [[0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]

    def test_a_tetrahedron(self):
        points, faces = self.TETRAHEDRON
        self.assertEqual(self.sentence(points, faces), "the solid of 4 triangles")
        self.assertEqual(self.sentence(points, faces[:3]), "the surface of 3 triangles")
        self.assertEqual(self.sentence(points, faces[:3] + [faces[3][::-1]]), "the solid, by parity, of 4 triangles")
        self.assertEqual(self.sentence(points + [[9, 9, 9], [9, 9, 8], [9, 8, 9]], faces + [[4, 5, 6]]),
                         "the solid of 4 triangles and the surface of 1 triangle")
        self.assertEqual(self.sentence(points + [[9, 9, 9], [9, 9, 8]], faces + [[0, 4, 5]]), "the surface of 5 triangles")

    def test_edges_that_end_within_others(self):
        """One face as two, cut at the middle of an edge of the face beside it."""
        points, faces = self.TETRAHEDRON
        cut = points + [[3, 3, 0]]  # on the edge from 1 to 2
        halves = [[1, 4, 3], [4, 2, 3]]
        self.assertEqual(self.sentence(cut, faces[:3] + halves), "the solid of 5 triangles")
        self.assertEqual(self.sentence(points + [[3, 3, 1]], faces[:3] + halves), "the surface of 5 triangles")
        twice = points + [[3, 3, 0], [2, 4, 0]]
        self.assertEqual(self.sentence(twice, faces[:3] + [[1, 4, 3], [4, 5, 3], [5, 2, 3]]), "the solid of 6 triangles")
        # The halves overlap: one part of the edge is there twice, another not at all.
        self.assertEqual(self.sentence(twice, faces[:3] + [[1, 5, 3], [4, 2, 3]]), "the surface of 5 triangles")

    def test_pieces_that_share_a_part_of_an_edge_alone_are_one(self):
        """A loose triangle whose edge lies on one that is open."""
        points, faces = self.TETRAHEDRON
        loose = points + [[1, 5, 0], [4, 2, 0], [7, 7, 0]]
        self.assertEqual(self.sentence(loose, faces + [[4, 5, 6]]), "the solid of 4 triangles and the surface of 1 triangle")
        inner = points + [[1, 5, 0], [2, 4, 0], [7, 7, 0], [3, 3, 0]]  # within one half of the cut edge
        self.assertEqual(self.sentence(inner, faces[:3] + [[1, 7, 3], [7, 2, 3], [4, 5, 6]]), "the surface of 6 triangles")
        cut = loose + [[3, 3, 0]]
        self.assertEqual(self.sentence(cut, faces[:3] + [[1, 7, 3], [7, 2, 3], [4, 5, 6]]), "the surface of 6 triangles")


if __name__ == "__main__":
    if os.environ.get("SUNDER_PROGRAM") is None:
        print("without sunder verify")
    files.main()
