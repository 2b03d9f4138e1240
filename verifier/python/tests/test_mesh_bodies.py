"""Statements about a mesh and a convex body, forced: of solids of unit cells, and bodies around boxes, as far apart as these."""
import itertools
import unittest
from fractions import Fraction
from math import inf

import files
from box_bodies import Around, box_around, square
from files import FORCED, MUTANT, Twins, dice_of, hexadecimal, lacking
from mesh_cells import Given, box_gap, direction, inside, some_cells, told_point
from test_mesh_distances import below, on_surface, sizes_of, statement
from test_rounds import KINDS, TURNS, WAYS, cross, double, furthest, is_double, placed, put, root, some_body as some_kind, times

ALONE, FAR = "mesh_body", "mesh_body_clearance"


def parts_of(boxes, body, least, dice):
    """Where parts of a mesh end, and directions from there to the body; and are they right, where there are such?"""
    until, directions, waiting, is_exact = [], [], [(0, len(boxes))], True
    while waiting:
        first, end = waiting.pop()
        box = box_around(boxes[first:end])
        way = body.way_from(box, least)
        if end - first > 1 and not (way and dice.random() < .8):
            middle = dice.randint(first + 1, end - 1)
            waiting += [(middle, end), (first, middle)]
            continue
        until.append(end)
        is_exact = is_exact and way != []
        way = way or [box_gap(x, y) for x, y in zip(box, body.box)]  # too short, by little
        scale = dice.choice((1, Fraction(1, 3), Fraction(2) ** 70))
        directions.append(told_point(scale * x for x in way) if any(way) else direction(dice))
    return until, directions, is_exact


def some_body(given, boxes, dice):
    """Beside a solid, or about one of its cells, or of its holes; a point of a triangle that is near; how far apart they are."""
    step, kind, is_beside = given.step, dice.choice((None, None, "radius", "ellipsoid", "cylinder")), dice.random() < .5
    gap, whole, axes = dice.choice(((0, 0, 1), (0, 3, 4), (1, 2, 2), (2, 3, 6), (0, 1, 1))), box_around(boxes), dice.sample(range(3), 3)
    cube = {*itertools.product(*(range(int((high - low) / step)) for low, high in whole))}
    least_cell = [min(cell[c] for cell in given.cells) for c in range(3)]
    holes = cube - {tuple(x - y for x, y in zip(cell, least_cell)) for cell in given.cells}
    spot, box = dice.choice(sorted(holes if holes and dice.random() < .6 else cube)), []
    for c, (low, high) in enumerate(whole):
        size = step * dice.choice((0, Fraction(1, 8), Fraction(1, 8), 2)) if kind != "ellipsoid" else 0
        if kind == "cylinder":
            size = step * dice.choice((Fraction(1, 8), 2)) * (c == axes[0])
        at, far = low + step * (spot[c] + Fraction(dice.randint(0, 7), 8)), step * Fraction(gap[axes[c]], 8)
        if is_beside and far:
            at = dice.choice((high + far, low - far - size))
        ends = [at, at + size]
        box.append(dice.choice(([at, inf], [-inf, at + size], [-inf, inf])) if not kind and dice.random() < .3 else ends)
    gaps, nearest = min(((square(map(box_gap, one, box)), one) for one in boxes), key=lambda told: told[0])
    point = [min(max(ends[0], low), high) for ends, (low, high) in zip(box, nearest)]
    far, little = root(Fraction(gaps)), step / 2 ** 20
    far = below(gaps, step) if far is None or far.denominator & (far.denominator - 1) else far
    radius = Fraction(dice.choice((0, far, far / 2, far / 4, max(far - little, 0), far + little)) if kind else 0)
    rest = far - radius  # where it is not above 0, and they meet, nothing is kept
    return Around(kind, box, radius, dice, step), point, dice.choice((rest, rest, rest / 2, rest + little)) if rest > 0 else step


class MeshBodies(unittest.TestCase):
    def setUp(self):
        self.dice, self.twins = dice_of(4101), Twins(self)

    def statements(self, kind, size):
        """Of each verdict of which too few were tried a maker of statements, and are they true and proved? Or None."""
        dice, step = self.dice, Fraction(2) ** self.dice.choice((-60, -1, 0, 0, 40))
        given = Given("a", some_cells(dice, dice.randint(1, size)), [dice.randint(-2, 2) for _ in range(3)], dice, step)
        boxes, cells = given.triangle_boxes(), sizes_of(given)
        body, near, least = some_body(given, boxes, dice)
        tables = {"meshes": given.entries(0), "bodies": body.entries()}

        def said(question, verdict, *claims, **says):
            more = {"least": hexadecimal(least)} if question == FAR else {}
            return files.file_of(tables, statement(question, verdict, len(tables["meshes"]) - 1, len(tables["bodies"]) - 1,
                                                   *claims, **says, **more))
        for question, verdict, rule, far in ((ALONE, "apart", "beside", 0), (FAR, "kept", "clear_beside", least)):
            if verdict not in lacking(kind, question):
                continue
            is_true, count = None not in [body.way_from(cell, far) for cell in cells], len(boxes)
            until, ways, is_exact = parts_of(boxes, body, far, dice)

            def made(until, ways, rays):
                return said(question, verdict, {"claim": rule, "until": until, "directions": ways,
                                                "away": [direction(dice) for _ in range(rays)]})
            yield lambda: made(until, ways, len(until) > 1 or dice.random() < .5), None if is_true and not is_exact else is_true
            k, wrong = dice.randrange(len(until)), dice.choice((0, -1, -10 ** 15 + 1))
            back = dice.choice((["0"] * 3, told_point(-Fraction(x) for x in ways[k])))
            turned, most = ways[:k] + [back] + ways[k + 1:], dice.choice((count - 1, count + 1, 10 ** 15 - 1))
            for those in dice.sample(((until, ways, 2), (until, ways, 0) if len(until) > 1 else ([], [], 1), (until, turned, 1),
                                      (until[:-1] + [most], ways, 1), (until[:-1], ways[:-1], 1), (until, ways + ways[:1], 1),
                                      (until[:k + 1] + until[k:], ways[:k + 1] + ways[k:], 1),
                                      (until[:k] + [wrong] + until[k:], ways[:k + 1] + ways[k:], 1)), 1):
                yield lambda: made(*those), False
        for p, of_p in ((near, on_surface(given, near)), inside(given, dice)):
            if "meet" in lacking(kind, ALONE):
                yield lambda: said(ALONE, "meet", of_p, body.holds(p), point=told_point(p)), body.has(p)
            for q in (body.toward(p), body.core[0]) if "broken" in lacking(kind, FAR) else ():
                q = dice.choice((q, q, [x + step / 8 for x in q]))
                yield (lambda: said(FAR, "broken", of_p, body.holds(q), {"claim": "nearer"}, from_a=told_point(p), to_b=told_point(q)),
                       body.has(q) and square(x - y for x, y in zip(p, q)) < least ** 2)
        middle = [(low + high) / 2 for low, high in dice.choice(cells)]
        for p, question in itertools.product((middle, body.toward(middle)), (ALONE, FAR)):
            if "b_within" in lacking(kind, question):
                yield (lambda: said(question, "b_within", {"claim": "encloses", "direction": direction(dice)}, body.holds(p),
                                    point=told_point(p)), body.has(p) and given.is_in(p) and on_surface(given, p) is None)

    def test_statements(self):
        """What is true is accepted, but where a ray meets an edge: then others are taken. What is not is refused."""
        while lacking(FORCED, ALONE) or lacking(FORCED, FAR):
            for make, is_true in self.statements(FORCED, 3):
                tops = (make() for _ in range(30 if is_true else 1))
                found = next((top for top in tops if self.twins.force(top) == "accepted"), None)
                if is_true is not None:
                    self.assertEqual(found is not None, is_true, self.twins.last)
        self.twins.compare()

    def test_form(self):
        """The body is of a table that the statement is not about: that may be missing, or of bodies in other dimensions."""
        mesh = {"name": "a", "points": [["0x0p0"] * 3], "triangles": [[0, 0, 0]]}
        far = [{"name": "b", "points": [["0x1p0"] * n]} for n in (3, 2)]
        beside = {"until": [1], "directions": [["1", "1", "1"]], "away": []}
        for question, verdict, rule, more in ((ALONE, "apart", "beside", {}), (FAR, "kept", "clear_beside", {"least": "0x1p0"})):
            for bodies, b, found in ((far, 0, "accepted"), (far, 1, "F"), (far, 2, "F"), ([], 0, "F"), (None, 0, "F")):
                tables = {"meshes": [mesh], **({"bodies": bodies} if bodies is not None else {})}
                one = statement(question, verdict, 0, b, {"claim": rule, **beside}, **more)
                self.assertEqual(self.twins.look(files.file_of(tables, one)), found, (bodies, b))
            self.assertEqual(self.twins.look(files.file_of({"bodies": far}, one)), "F")
        self.twins.compare()

    def test_turned(self):
        """A triangle across a direction, so far before the first point of a body along it, which is of any kind, and turned."""
        dice, accepted, wanted = self.dice, set(), files.some(400)
        for tries in range(wanted + 1000):
            if tries >= wanted and accepted == {False, *KINDS}:
                break
            kind, gap, bodies = dice.choice(KINDS), dice.choice((0, 1, Fraction(3, 2))), []
            item, linear = some_kind(dice, kind)
            body, d = placed(item, linear, [0, 1, 2]), times(dice.choice((TURNS[0], linear)), dice.choice(WAYS))
            far = root(Fraction(square(d)))
            if not far or root(Fraction(body.square(d))) is None:
                continue
            at = [x - gap * y / far for x, y in zip(furthest(body, [-x for x in d], dice)[0], d)]
            corners = [[x + y for x, y in zip(at, cross(d, v))] for v in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
            if not is_double(at) or len({*map(tuple, corners)}) < 3:
                continue
            mesh = {"name": "a", "points": [[double(x) for x in p] for p in corners], "triangles": [[0, 1, 2]]}
            claim, b = {"until": [1], "directions": [told_point(map(Fraction, d))], "away": []}, put(bodies, item, linear, [0, 1, 2])
            for least in (0, gap or 1, gap + Fraction(1, 2 ** 40)):
                one = statement(FAR, "kept", 0, b, {"claim": "clear_beside", **claim}, least=double(least)) if least else statement(
                    ALONE, "apart", 0, b, {"claim": "beside", **claim})
                found = self.twins.force(files.file_of({"meshes": [mesh], "bodies": bodies}, one))
                self.assertEqual(found == "accepted", 0 < gap >= least, self.twins.last)
                accepted.add(found == "accepted" and kind)
        self.twins.compare()
        self.assertEqual(accepted, {False, *KINDS})

    def test_mutants(self):
        while lacking(MUTANT, ALONE) or lacking(MUTANT, FAR):
            for make, is_true in self.statements(MUTANT, 1):
                if is_true:
                    self.twins.spoil(make(), self.dice)
        self.twins.compare()


if __name__ == "__main__":
    files.main()
