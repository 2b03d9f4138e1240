#!/usr/bin/env python3
"""Statements about all pairs of bodies of which some stand for meshes: of boxes, so that it is known how they lie."""
import itertools
import unittest
from fractions import Fraction

import files
from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main

ALL, FAR = "bodies", "clearances"
FACES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]


def corners_of(box):
    return [list(p) for p in itertools.product(*box)]


def told_point(p):
    return [fraction(Fraction(x)) for x in p]


def determinant(rows):
    if len(rows) == 2:
        (a, b), (c, d) = rows
        return a * d - b * c
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def sides(corners, p):
    """The determinants of a tetrahedron, or of a triangle in the plane, and of it with the point in place of each corner."""
    def whole(those):
        return determinant([[x - y for x, y in zip(q, those[0])] for q in those[1:]])
    return whole(corners), [whole(corners[:k] + [p] + corners[k + 1:]) for k in range(len(corners))]


def is_in(corners, p):
    if len(corners) == 1:
        return corners[0] == p
    if len(corners) == 3:
        if determinant([[x - y for x, y in zip(q, p)] for q in corners]):
            return False
        axis = next((c for c in range(3) if sides([q[:c] + q[c + 1:] for q in corners], [0, 0])[0]), 0)
        corners, p = [q[:axis] + q[axis + 1:] for q in corners], p[:axis] + p[axis + 1:]
    all_, parts = sides(corners, p)
    return all_ != 0 and all(part * all_ >= 0 for part in parts)


class Thing:
    """A box as a mesh, and one around it as a body, both placed alike."""

    def __init__(self, dice, tables):
        start, size = [dice.randint(-2, 2) for _ in range(3)], [dice.randint(1, 3) for _ in range(3)]
        self.mesh = [(x, x + w) for x, w in zip(start, size)]
        self.body = [(x - dice.randint(0, 1), y + dice.randint(0, 1)) for x, y in self.mesh] if dice.random() < .5 else self.mesh
        self.scale, self.move = [dice.choice((1, 1, 2, -1)) for _ in range(3)], [dice.randint(-4, 4) for _ in range(3)]
        self.is_placed = dice.random() < .7
        if not self.is_placed:
            self.scale, self.move = [1] * 3, [0] * 3
        self.base = len(tables["meshes"]), len(tables["bodies"])
        rows = [[[hexadecimal(x) for x in p] for p in corners_of(box)] for box in (self.mesh, self.body)]
        tables["meshes"].append({"name": "m", "points": rows[0], "triangles": [list(t) for t in FACES]})
        tables["bodies"].append({"name": "b", "points": rows[1]})
        for key, base in zip(("meshes", "bodies"), self.base):
            if self.is_placed:
                linear = [hexadecimal(self.scale[r] * (r == c)) for r in range(3) for c in range(3)]
                tables[key].append({"name": key, "of": base, "linear": linear, "translation": [hexadecimal(x) for x in self.move]})
        self.at = len(tables["meshes"]) - 1, len(tables["bodies"]) - 1

    def world(self, box):
        return [sorted(s * x + t for x in ends) for ends, s, t in zip(box, self.scale, self.move)]

    def placed(self, p):
        return [s * x + t for s, x, t in zip(self.scale, p, self.move)]

    def around(self, dice, is_wrong=False):
        points, holders, held = corners_of(self.body), [], []

        def one_that(p, holds):
            while True:
                those = dice.sample(range(8), dice.choice((1, 3, 4, 4)))
                if is_in([points[k] for k in those], p) == holds:
                    return those
        wrong = dice.randrange(8) if is_wrong else None
        for k, p in enumerate(corners_of(self.mesh)):
            holders.append(one_that(p, k != wrong))
            held.append(k)
        return {"question": "around", "a": self.base[0], "b": self.base[1], "verdict": "around",
                "claims": [{"claim": "around", "holders": holders, "held": held}]}

    def on_triangle(self, p):
        """The claim that a point is on the surface of the mesh, or None."""
        points = [self.placed(q) for q in corners_of(self.mesh)]
        for t, triangle in enumerate(FACES):
            corners = [points[k] for k in triangle]
            if is_in(corners, p):
                axis = next(c for c in range(3) if len({q[c] for q in corners}) == 1)
                all_, parts = sides([q[:axis] + q[axis + 1:] for q in corners], p[:axis] + p[axis + 1:])
                return {"claim": "on_triangle", "triangle": t,
                        "weights": [[k, fraction(Fraction(part) / all_)] for k, part in zip(triangle, parts)]}
        return None

    def holds(self, p):
        weights = []
        for k, corner in enumerate(itertools.product((0, 1), repeat=3)):
            weight = Fraction(1)
            for c, end in enumerate(corner):
                low, high = (self.scale[c] * x + self.move[c] for x in self.body[c])
                along = Fraction(p[c] - low) / (high - low)
                weight *= along if end else 1 - along
            weights.append([k, fraction(weight)])
        return {"claim": "holds", "weights": weights}


def gap(one, other):
    """Along an axis and a way of it the second box begins behind the first; the furthest such, or nothing."""
    ways = [(way * (other[c][way < 0] - one[c][way > 0]), c, way) for c in range(3) for way in (1, -1)]
    far, axis, way = max(ways)
    return far, [str(way * (c == axis)) for c in range(3)]


def common(one, other):
    return [(max(x[0], y[0]), min(x[1], y[1])) for x, y in zip(one, other)]


def stated(one, other, as_meshes, least, dice):
    """A statement about two members, and what it tells: True where they count, False where they do not, None where it does not
    fit; and, of ones that count, whether insides are known to meet, of others whether they touch."""
    kinds = [of.mesh if is_mesh else of.body for of, is_mesh in zip((one, other), as_meshes)]
    boxes = [of.world(box) for of, box in zip((one, other), kinds)]
    far, direction = gap(*boxes)
    hulls_far, hulls_way = gap(one.world(one.body), other.world(other.body))
    more, which = {"least": hexadecimal(least)} if least else {}, any(as_meshes) + all(as_meshes)
    if as_meshes == (False, True) and not (hulls_far >= least > 0 or hulls_far > 0 == least):
        return stated(other, one, (True, False), least, dice)  # a mesh stands before a body
    question = (("pair", "mesh_body", "meshes"), ("clearance", "mesh_body_clearance", "mesh_clearance"))[bool(least)][which]
    ends = {"a": one.at[0 if as_meshes[0] else 1], "b": other.at[0 if as_meshes[1] else 1]}
    start = {"question": question, **ends, **more}
    if any(as_meshes) and (hulls_far >= least > 0 or hulls_far > 0 == least) and dice.random() < .6 or as_meshes == (False, True):
        start = {"question": ("pair", "clearance")[bool(least)], "a": one.at[1], "b": other.at[1], **more}
        return {**start, "verdict": ("apart", "kept")[bool(least)],
                "claims": [{"claim": ("parted", "clear")[bool(least)], "direction": hulls_way}]}, False, False
    if far >= least > 0 or far > 0 == least:
        cover = {"cuts": [0], "directions": [direction], "rays_a": [], "rays_b": []}
        brings = ({"direction": direction}, {"until": [12], "directions": [direction], "away": []}, cover)[which]
        rule = (("parted", "beside", "covered"), ("clear", "clear_beside", "covered_clear"))[bool(least)][which]
        return {**start, "verdict": ("apart", "kept")[bool(least)], "claims": [{"claim": rule, **brings}]}, False, False
    shared = common(*boxes)
    if far > 0:
        return None  # nearer, but how is not told here
    for p in corners_of(shared) + [[Fraction(x + y, 2) for x, y in shared]]:
        claims = [of.on_triangle(p) if is_mesh else of.holds(p) for of, is_mesh in zip((one, other), as_meshes)]
        if None in claims:
            continue
        if least:
            return {**start, "verdict": "broken", "from_a": told_point(p), "to_b": told_point(p),
                    "claims": claims + [{"claim": "nearer"}]}, True, False
        if far == 0 and which == 2 and dice.random() < .7:
            axis = next(c for c in range(3) if direction[c] != "0")
            way, level = int(direction[axis]), boxes[0][axis][int(direction[axis]) > 0]
            spots = [[level + s * (c == axis) for c in range(3)] for s in (1, -1)]  # above the plane, below
            spots = [[s[c] if c == axis else 0 for c in range(3)] for s in spots]
            rays = [[[k, [str(s * (c == axis)) for c in range(3)]]] for k, s in ((0, 1), (1, -1))][::way]
            tree = {"cuts": [1, 0, 0], "planes": [[*(str(int(c == axis)) for c in range(3)), str(level)]],
                    "cells": [told_point(s) for s in spots], "rays_first": rays[0], "rays_second": rays[1]}
            return {**start, "verdict": "touching", "point": told_point(p),
                    "claims": claims + [{"claim": "insides_apart", **tree}]}, True, None
        if far == 0 or which != 2 or dice.random() < .3:
            return {**start, "verdict": "meet", "point": told_point(p), "claims": claims}, True, False
        break
    if least:
        return None
    if which != 2:
        return None
    p = [Fraction(3 * x + 4 * y, 7) + Fraction(y - x, 100 + c) for c, (x, y) in enumerate(shared)]
    rays = [{"claim": "encloses", "direction": [fraction(Fraction(dice.randint(-99, 99), 7 + c)) for c in range(3)]} for _ in range(2)]
    return {**start, "verdict": "overlapping", "point": told_point(p), "claims": rays}, True, True


def some_scene(dice, question):
    """Boxes, statements about their pairs, and is known what is said of all of them?"""
    tables = {"meshes": [], "bodies": []}
    things = [Thing(dice, tables) for _ in range(dice.randint(2, 4))]
    as_meshes = [dice.random() < .6 for _ in things]
    as_meshes[0] = as_meshes[0] or not any(as_meshes)
    allowed = dice.choice(("nothing", "touch")) if question == ALL else "nothing"
    least = dice.choice((1, 2, Fraction(1, 2))) if question == FAR else 0
    known_around = [dice.random() < .9 for _ in things]
    statements = [of.around(dice) for of, is_known in zip(things, known_around) if is_known]
    besides, counting = [], []
    is_known = all(known for known, is_mesh in zip(known_around, as_meshes) if is_mesh)  # that bodies hold their meshes
    for i, j in itertools.combinations(range(len(things)), 2):
        told = stated(things[i], things[j], (as_meshes[i], as_meshes[j]), least, dice)
        if told is None or dice.random() < .05:
            besides.append([i, j])
            continue
        statement, counts, inside = told
        if dice.random() < .97:
            statements.append(statement)
        else:
            is_known = False
        if allowed == "touch" and counts and inside is not True:
            is_known, counts = is_known and inside is None, False  # that they touch is told, or not
        if counts:
            counting.append([i, j])
    dice.shuffle(statements)
    one = {"question": question, "members": [of.at[1] for of in things], "except": besides,
           "as_meshes": [of.at[0] if is_mesh else None for of, is_mesh in zip(things, as_meshes)]}
    if question == ALL:
        one.update(allowed=allowed, verdict="these", contacts=counting, claims=[{"claim": "each_pair"}])
    else:
        one.update(least=hexadecimal(least), verdict="broken" if counting else "kept", claims=[{"claim": "each_clearance"}])
        one.update({"nearer": counting} if counting else {})
    return file_of(tables, *statements, one), is_known, things


class MeshMembers(unittest.TestCase):
    def test_all_is_accepted_where_each_pair_is_proved_and_only_there(self):
        """A ray may meet an edge: then the statement of its pair is refused, and so is that of all."""
        dice, twins, count = dice_of(4201), Twins(self), 0
        for _ in range(files.some(150)):
            for question in (ALL, FAR):
                top, is_known, _ = some_scene(dice, question)
                said = twins.force(top)
                self.assertIn(said, ("accepted",) if is_known else ("each_pair", "each_clearance"), top)
                count += is_known
        twins.compare()
        self.assertGreater(count, files.some(150))

    def test_what_is_not_so_is_not_accepted(self):
        dice, twins = dice_of(4202), Twins(self)
        while lacking(FORCED, "around") or lacking(MUTANT, "around"):
            question = dice.choice((ALL, FAR))
            top, is_known, things = some_scene(dice, question)
            *pairs, one = top["statements"]
            of = dice.choice(things)
            wrong = of.around(dice, True)
            self.assertEqual(twins.force({**top, "statements": [wrong]}), "around", twins.last)
            self.assertEqual(twins.force({**top, "statements": [of.around(dice)]}), "accepted", twins.last)
            twins.spoil({**top, "statements": [of.around(dice)]}, dice)
            twins.spoil(top, dice)
            if not is_known:
                continue
            key = "contacts" if question == ALL else "nearer"
            pair = sorted(dice.sample(range(len(things)), 2))
            changed = [c for c in one.get(key, []) if c != pair] if pair in one.get(key, []) else sorted(one.get(key, []) + [pair])
            if pair not in one["except"] and (question == ALL or changed):
                more = {"verdict": "broken"} if question == FAR else {}
                self.assertNotEqual(twins.force({**top, "statements": pairs + [{**one, key: changed, **more}]}), "accepted", twins.last)
            if any(mesh is not None for mesh in one["as_meshes"]):
                kept = [s for s in pairs if s["question"] != "around"]
                self.assertNotEqual(twins.force({**top, "statements": kept + [one]}), "accepted", twins.last)
        twins.compare()

    def test_form(self):
        dice, twins = dice_of(4203), Twins(self)
        for _ in range(files.some(40)):
            top, _, things = some_scene(dice, dice.choice((ALL, FAR)))
            *pairs, one = top["statements"]
            those = one["as_meshes"]
            k = next(k for k, mesh in enumerate(those) if mesh is not None)
            for wrong in (those[:-1], those + [None], those[:k] + [len(top["tables"]["meshes"])] + those[k + 1:], [True] + those[1:], {}):
                self.assertEqual(twins.look({**top, "statements": pairs + [{**one, "as_meshes": wrong}]}), "F", wrong)
            of = things[k]
            if of.is_placed and (of.move != [0] * 3 or of.scale != [1] * 3):
                elsewhere = those[:k] + [of.base[0]] + those[k + 1:]
                self.assertEqual(twins.look({**top, "statements": pairs + [{**one, "as_meshes": elsewhere}]}), "F", elsewhere)
                moved = {**of.around(dice), "a": of.at[0]}
                self.assertEqual(twins.look({**top, "statements": [moved]}), "F")
        twins.compare()


if __name__ == "__main__":
    main()
