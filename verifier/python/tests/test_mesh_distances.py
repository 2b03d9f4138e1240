"""Statements about how far apart two meshes are, forced: of solids of unit cells, whose distance is that of their cells."""
import itertools
import unittest
from fractions import Fraction

import files
from files import FORCED, MUTANT, Twins, dice_of, fraction, hexadecimal, lacking
from mesh_cells import box_gap, cover, direction, inside, pieces, some_pair, tables_of, told_point


def sizes_of(given):
    """The boxes of its cells."""
    return [[[given.step * (x + s), given.step * (x + s + 1)] for x, s in zip(cell, given.shift)] for cell in given.cells]


def nearest(a, b):
    """The square of the distance, and two points that are so near."""
    def told(pair):
        of_a, of_b = pair
        return sum(box_gap(x, y) ** 2 for x, y in zip(of_a, of_b))

    of_a, of_b = min(itertools.product(sizes_of(a), sizes_of(b)), key=told)
    p, q = [], []
    for x, y in zip(of_a, of_b):
        if box_gap(x, y):
            p.append(x[1] if x[1] < y[0] else x[0])
            q.append(y[0] if x[1] < y[0] else y[1])
        else:
            p.append(max(x[0], y[0]))
            q.append(p[-1])
    return told((of_a, of_b)), p, q


def on_surface(given, point):
    """The claim that a point is on a triangle: those are right-angled, and across an axis."""
    places = given.places()
    for n, triangle in enumerate(given.triangles):
        corners = [places[k] for k in triangle]
        for turn in range(3):
            origin, u, v = (corners[(turn + k) % 3] for k in range(3))
            e, f, d = ([y - x for x, y in zip(origin, other)] for other in (u, v, point))
            if sum(x * y for x, y in zip(e, f)):
                continue  # no right angle there
            s, t = (Fraction(sum(x * y for x, y in zip(d, way)), sum(x * x for x in way)) for way in (e, f))
            if min(s, t, 1 - s - t) < 0 or any(x * s + y * t != z for x, y, z in zip(e, f, d)):
                continue
            names = [triangle[(turn + k) % 3] for k in range(3)]
            return {"claim": "on_triangle", "triangle": n,
                    "weights": [[k, fraction(w)] for k, w in zip(names, (1 - s - t, s, t))]}
    return None


def below(square, step):
    """A double that is not more than the root, by a thousandth or less."""
    low, high = Fraction(0), step * 64
    while high - low > low / 1000:
        middle = (low + high) / 2
        low, high = (middle, high) if middle ** 2 <= square else (low, middle)
    return low


def statement(question, verdict, i, j, *claims, **says):
    return {"question": question, "a": i, "b": j, "verdict": verdict, **says, "claims": list(claims)}


def covered(rule, found, a, b, dice):
    rays = [[[t, direction(dice)] for t in pieces(of)] for of in (a, b)]
    return {"claim": rule, "cuts": found[0], "directions": found[1], "rays_a": rays[0], "rays_b": rays[1]}


class MeshDistances(unittest.TestCase):
    def setUp(self):
        self.dice, self.twins = dice_of(4003), Twins(self)

    def ask(self, tables, make, is_true):
        """What is true is accepted, but where a ray meets an edge: then others are taken."""
        for _ in range(30 if is_true else 1):
            top = files.file_of(tables, make())
            found = self.twins.force(top)
            if found == "accepted":
                break
        self.assertEqual(found == "accepted", is_true, (found, top))

    def some_pair_apart(self):
        while True:
            a, b = some_pair(self.dice)
            square, p, q = nearest(a, b)
            if len(a.triangles) * len(b.triangles) > 3000:
                continue
            nested = any(b.is_in(a.places()[a.triangles[t][0]]) for t in pieces(a)) or any(
                a.is_in(b.places()[b.triangles[t][0]]) for t in pieces(b))
            if square and not nested:
                return a, b, square, p, q

    def test_distances(self):
        dice = self.dice
        while lacking(FORCED, "mesh_distance"):
            a, b, square, p, q = self.some_pair_apart()
            tables, i, j = tables_of(a, b)
            ends = on_surface(a, p), on_surface(b, q)
            found = cover(a, b, dice, square)

            def make(ends=ends, found=found, points=(p, q)):
                return statement("mesh_distance", "closest", i, j, *ends, covered("covered_apart", found, a, b, dice),
                                 from_a=told_point(points[0]), to_b=told_point(points[1]))
            self.ask(tables, make, True)
            # Two other points: not accepted, unless they are as near. And less of a cover.
            (r, of_a), (s, of_b) = inside(a, dice), inside(b, dice)
            is_near = sum((x - y) ** 2 for x, y in zip(r, s)) == square
            self.ask(tables, lambda: make((of_a, of_b), points=(r, s)), is_near)
            less = cover(a, b, dice, square * dice.choice((Fraction(1, 4), Fraction(99, 100), 0)))
            of_less = statement("mesh_distance", "closest", i, j, *ends, covered("covered_apart", less, a, b, dice),
                                from_a=told_point(p), to_b=told_point(q))
            self.twins.force(files.file_of(tables, of_less))
        self.twins.compare()

    def test_clearances(self):
        dice = self.dice
        while lacking(FORCED, "mesh_clearance"):
            a, b, square, p, q = self.some_pair_apart()
            tables, i, j = tables_of(a, b)
            low = below(square, a.step)
            if low.denominator & (low.denominator - 1):
                continue
            found, (r, of_a), (s, of_b) = cover(a, b, dice, low ** 2), inside(a, dice), inside(b, dice)
            for least in low, low * Fraction(9, 8), low / 2:
                def kept(least=least):
                    return statement("mesh_clearance", "kept", i, j, covered("covered_clear", found, a, b, dice),
                                     least=hexadecimal(least))
                if least > low:
                    self.ask(tables, kept, False)
                else:
                    self.ask(tables, kept, True)
            self.ask_within(tables, i, j, a, b)
            for points, ends in ((p, q), (on_surface(a, p), on_surface(b, q))), ((r, s), (of_a, of_b)):
                far = sum((x - y) ** 2 for x, y in zip(*points))
                for least in low, 4 * low, below(far, a.step):
                    if least == 0 or least.denominator & (least.denominator - 1):
                        continue
                    said = statement("mesh_clearance", "broken", i, j, *ends, {"claim": "nearer"}, least=hexadecimal(least),
                                     from_a=told_point(points[0]), to_b=told_point(points[1]))
                    self.ask(tables, lambda said=said: said, far < least ** 2)
        self.twins.compare()

    def ask_within(self, tables, i, j, a, b):
        """Of two that are apart; and of two that may be in one another, where it is as of their cells."""
        for k in range(2):
            if k:
                a, b = some_pair(self.dice)
                tables, i, j = tables_of(a, b)
            for verdict, of, other in ("a_within", a, b), ("b_within", b, a):
                point, claim = inside(of, self.dice)
                claims = [claim, {"claim": "encloses", "direction": direction(self.dice)}]
                said = statement("mesh_clearance", verdict, i, j, *(claims if verdict[0] == "a" else claims[::-1]),
                                 point=told_point(point), least="0x1p0")
                found = self.twins.force(files.file_of(tables, said))
                if found == "accepted":
                    self.assertTrue(k and other.is_in(point), said)

    def test_crossings(self):
        """Two triangles through a point, which is inside of one, on its edge, or at a corner."""
        dice = self.dice
        while "two" in lacking(FORCED, "mesh_crossing"):
            def corner():
                return [Fraction(dice.randint(-8, 8)) for _ in range(3)]

            def share(count):
                weights = [Fraction(dice.randint(1, 3)) for _ in range(count)] + [Fraction(0)] * (3 - count)
                return [w / sum(weights) for w in weights]

            of_t, of_u = share(dice.choice((1, 2, 2, 3))), share(dice.choice((1, 2, 2, 3)))
            t, u = [corner() for _ in range(3)], [corner() for _ in range(2)]
            point = [sum(w * p[c] for w, p in zip(of_t, t)) for c in range(3)]
            # The first corner of the other one, which has weight, so that it has the point.
            first = [(point[c] - of_u[1] * u[0][c] - of_u[2] * u[1][c]) / of_u[0] for c in range(3)]
            scale = 1
            for x in first:
                scale *= x.denominator
            points = [[x * scale for x in p] for p in t + [first] + u]
            if len({tuple(p) for p in points}) < 6:
                continue
            mesh = {"name": "m", "points": [[hexadecimal(x) for x in p] for p in points], "triangles": [[0, 1, 2], [3, 4, 5]]}
            at = [x * scale for x in point]
            claim = {"claim": "triangles_cross", "triangle": 0, "weights": [[k, fraction(w)] for k, w in enumerate(of_t)],
                     "other_triangle": 1, "other_weights": [[k + 3, fraction(w)] for k, w in enumerate(of_u)]}

            def way(p, q):
                return [y - x for x, y in zip(p, q)]

            def across(a, b):
                return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            sizes = sum(map(bool, of_t)), sum(map(bool, of_u))
            areas = [any(across(way(a, b), way(a, c))) for a, b, c in (points[:3], points[3:])]
            is_true = all(areas) and (3 in sizes or sizes == (2, 2) and any(
                across(way(points[0], points[1]), way(points[3], points[4]))))
            tables = {"meshes": [mesh]}
            for said, truth in ((claim, is_true), ({**claim, "other_triangle": 0}, False), (
                    {**claim, "weights": claim["weights"][::-1]}, None)):
                top = files.file_of(tables, {"question": "mesh_crossing", "a": 0, "verdict": "two", "point": told_point(at),
                                             "claims": [said]})
                found = self.twins.force(top)
                if truth is not None:
                    self.assertEqual(found == "accepted", truth, (found, top))
            image = {"name": "n", "of": 0, "linear": ["0x0p0"] * 9, "translation": told_point(at)}  # is not asked about
            self.twins.force(files.file_of({"meshes": [mesh, image]}, {
                "question": "mesh_crossing", "a": 1, "verdict": "two", "point": told_point(at), "claims": [claim]}))
            if is_true and "two" in lacking(MUTANT, "mesh_crossing"):
                self.twins.spoil(files.file_of(tables, {"question": "mesh_crossing", "a": 0, "verdict": "two",
                                                        "point": told_point(at), "claims": [claim]}), dice)
        self.twins.compare()

    def test_mutants(self):
        dice = dice_of(4004)
        while lacking(MUTANT, "mesh_distance") or lacking(MUTANT, "mesh_clearance"):
            a, b, square, p, q = self.some_pair_apart()
            if len(a.triangles) + len(b.triangles) > 100:
                continue
            tables, i, j = tables_of(a, b)
            ends, points = (on_surface(a, p), on_surface(b, q)), {"from_a": told_point(p), "to_b": told_point(q)}
            found = cover(a, b, dice, square)
            least = hexadecimal(a.step / 2 ** 20)
            for said in (statement("mesh_distance", "closest", i, j, *ends, covered("covered_apart", found, a, b, dice), **points),
                         statement("mesh_clearance", "kept", i, j, covered("covered_clear", found, a, b, dice), least=least),
                         statement("mesh_clearance", "broken", i, j, *ends, {"claim": "nearer"}, least=least, **points),
                         statement("mesh_clearance", "a_within", i, j, ends[0], {"claim": "encloses", "direction": direction(dice)},
                                   least=least, point=told_point(p)),
                         statement("mesh_clearance", "b_within", i, j, {"claim": "encloses", "direction": direction(dice)}, ends[1],
                                   least=least, point=told_point(q))):
                self.twins.spoil(files.file_of(tables, said), dice)
        self.twins.compare()


if __name__ == "__main__":
    files.main()
