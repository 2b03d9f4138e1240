#!/usr/bin/env python3
"""Tests of statements about validity against fractions and brute force: python3 verifier/python/tests/test_valid.py."""
import functools
import itertools
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, lacking, main, some
from test_polygons import edges_of, holds, parts_of, table_of
from test_segments import factor_of, forced, is_on, kind_of, stretched, sweep

SELF_TOUCH = "valid-with-self-touch"
RULES = ["valid", "simple", SELF_TOUCH]
TOUCHING = [  # rings that come to a point again
    [(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)],                          # a corner on an edge
    [(0, 0), (4, 0), (4, 4), (2, 4), (3, 2), (1, 2), (2, 4), (0, 4)],  # a pocket
    [(0, 0), (4, 0), (4, 4), (2, 4), (1, 2), (3, 2), (2, 4), (0, 4)],  # a loop inside that is crossed into
    [(0, 0), (2, 1), (4, 0), (4, 2), (2, 1), (0, 2)],                  # side by side
    [(0, 0), (2, 1), (4, 2), (4, 0), (2, 1), (0, 2)],                  # the same, crossed
    [(0, 0), (4, 0), (4, 4), (2, 4), (3, 3), (2, 2), (1, 3), (2, 4), (1, 3), (2, 2), (2, 1), (0, 4)],
    [(0, 0), (6, 0), (3, 2), (2, 1), (4, 1), (3, 2), (3, 3), (4, 4), (2, 4), (3, 3), (0, 6)],
    [(0, 0), (6, 0), (6, 2), (3, 2), (3, 3), (6, 2), (6, 6), (0, 6), (0, 3), (3, 3), (3, 2), (0, 3)],
    [(0, 0), (6, 0), (6, 6), (0, 6), (0, 3), (2, 4), (4, 3), (2, 2), (0, 3)],
    [(0, 0), (6, 0), (6, 6), (3, 6), (1, 3), (3, 0), (5, 3), (3, 6), (0, 6)],
    [(0, 0), (6, 0), (6, 6), (3, 6), (2, 4), (3, 2), (4, 4), (3, 6), (5, 4), (3, 1), (1, 4), (3, 6), (0, 6)],
]


def ordinate(edge, x):
    (ax, ay), (bx, by) = edge
    return ay + (by - ay) * Fraction(x - ax) / (bx - ax)


def trapezoids(edges, points):
    """The plane in columns between the abscissas of points; a column is the middles of what edges part it into, and the
    ends of these on its left and right."""
    xs = sorted({x for x, _ in points})
    columns = []
    for left, right in zip(xs, xs[1:]):
        over = sorted({(ordinate(e, (left + right) // 2), ordinate(e, left), ordinate(e, right))
                       for e in edges if e[0][0] <= left and e[1][0] >= right and e[0][0] < e[1][0]})
        columns.append([((left + right) // 2, (a[0] + b[0]) / 2, (a[1], b[1]), (a[2], b[2]))
                        for a, b in zip(over, over[1:])])
    return xs, columns


def upright(edges, x, low, high):
    """Is there an upright edge between two ordinates?"""
    return any(a[0] == b[0] == x and a[1] < high and b[1] > low for a, b in edges)


def pieces_of(columns, xs, is_inside, edges):
    """So many pieces hang together."""
    inside = {(c, k) for c, column in enumerate(columns) for k, (x, y, _, _) in enumerate(column) if is_inside((x, y))}
    leader = {cell: cell for cell in inside}

    def find(cell):
        while leader[cell] != cell:
            cell = leader[cell]
        return cell
    for c, k in inside:
        for m in range(len(columns[c + 1]) if c + 1 < len(columns) else 0):
            low = max(columns[c][k][3][0], columns[c + 1][m][2][0])
            high = min(columns[c][k][3][1], columns[c + 1][m][2][1])
            # An upright edge with a gap between others parts only a part of what is common: look at each part.
            cuts = sorted({low, high} | {y for e in edges for x, y in e if x == xs[c + 1] and low < y < high})
            if (c + 1, m) in inside and low < high and any(
                    not upright(edges, xs[c + 1], p, q) for p, q in zip(cuts, cuts[1:])):
                leader[find((c, k))] = find((c + 1, m))
    return len({find(cell) for cell in inside})


def order_around(ways):
    """Directions counter-clockwise, those alike together."""
    def is_lower(u):
        return u[1] < 0 or (u[1] == 0 and u[0] < 0)

    def compare(u, v):
        return is_lower(u) - is_lower(v) or v[0] * u[1] - v[1] * u[0]
    return sorted(ways, key=functools.cmp_to_key(compare))


def crosses_itself(vertices, points):
    """Do two ways of a ring, whose vertices differ from the ones before, cross in one of its points?"""
    for p in points:
        ways = []
        for k, q in enumerate(vertices):
            before, after = vertices[k - 1], vertices[(k + 1) % len(vertices)]
            if q == p:
                ways.append((before, after))
            elif after != p and is_on(tuple(sorted((q, after))), p):
                ways.append((q, after))
        ways = [tuple((x - p[0], y - p[1]) for x, y in way) for way in ways]
        order = order_around([end for way in ways for end in way])
        for a, b in itertools.combinations(ways, 2):
            (i, k), between = sorted(map(order.index, a)), [order.index(end) for end in b]
            if sum(i < m < k for m in between) == 1:
                return True
    return False


def is_valid(parts, rule):
    """By definition: rings simple, or touching themselves, no pieces in common, each part its shell without its holes,
    which are side by side; parts hang together, and are side by side."""
    if not all(parts):
        return False
    rings = [[edges_of([ring]) for ring in part] for part in parts]
    for part, given in zip(rings, parts):
        for ring, vertices in zip(part, given):
            if rule == "simple" and any(a == b for a, b in ring):
                return False
            kept = [p for k, p in enumerate(vertices) if p != vertices[k - 1]]
            if len(set(kept)) < 3 or (len(set(kept)) < len(kept) and rule != SELF_TOUCH):
                return False
            edges = list(zip(kept, kept[1:] + kept[:1]))
            if rule == SELF_TOUCH:
                if any(kind_of(tuple(sorted(s)), tuple(sorted(t))) in ("overlap", "crossing")
                       for s, t in itertools.combinations(edges, 2)) or crosses_itself(kept, set(kept)):
                    return False
                continue
            for (k, s), (m, t) in itertools.combinations(enumerate(edges), 2):
                kind = kind_of(tuple(sorted(s)), tuple(sorted(t)))
                if kind and not (kind == "shared-endpoint" and (m == k + 1 or (k == 0 and m == len(edges) - 1))):
                    return False
    factor = factor_of([edge for part in rings for ring in part for edge in ring])
    rings = [[stretched(ring, factor) for ring in part] for part in rings]
    edges = [edge for part in rings for ring in part for edge in ring if edge[0] != edge[1]]
    for (i, s), (j, t) in itertools.combinations([(i, s) for i, part in enumerate(rings) for ring in part for s in ring], 2):
        if kind_of(s, t) in ("overlap", "crossing"):
            return False
    if rule == "simple" and any(kind_of(s, t) for part in rings for r, q in itertools.combinations(part, 2)
                                for s in r for t in q):
        return False
    points, _ = parts_of(edges)
    xs, columns = trapezoids(edges, points)
    for x, y, _, _ in itertools.chain.from_iterable(columns):
        filled = 0
        for part in rings:
            inside = [holds(ring, (x, y)) for ring in part]
            if sum(inside[1:]) > 1 or (any(inside[1:]) and not inside[0]):
                return False
            filled += inside[0] and not any(inside[1:])
        if filled > 1:
            return False
    for part in rings:
        own = [edge for ring in part for edge in ring]

        def is_inside(p, own=own):
            return not any(is_on(e, p) for e in own) and holds(own, p)
        if pieces_of(columns, xs, is_inside, own) != 1:
            return False
    return True


def some_ring(dice, x, y, size):
    throw = dice.random()
    if throw < .12:
        ring = [(x + p, y + q) for p, q in dice.choice(TOUCHING)]
        if dice.random() < .3:
            k = dice.randrange(len(ring))
            ring[k] = (x + dice.randint(0, 4), y + dice.randint(0, 4))
    elif throw < .3:
        w, h = dice.randint(1, size), dice.randint(1, size)
        ring = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
    elif throw < .5:
        ring = [(x, y), (x + dice.randint(1, 2), y), (x, y + dice.randint(1, 2))]
    else:
        ring = [(x + dice.randint(0, size), y + dice.randint(0, size)) for _ in range(dice.choice([2, 3, 3, 4, 5]))]
    if dice.random() < .15:
        k = dice.randrange(len(ring))
        ring.insert(k, ring[k])
    return ring if dice.random() < .5 else ring[::-1]


def some_parts(dice):
    """Shells with holes that touch them, or each other, and parts beside and within each other."""
    parts = []
    for _ in range(dice.choice([1, 1, 1, 2, 2, 3])):
        x, y, size = dice.randint(0, 6), dice.randint(0, 6), dice.choice([2, 4, 6, 6])
        shell = [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]
        if dice.random() < .3:
            shell = some_ring(dice, x, y, size)
        elif dice.random() < .3:  # with a corner in the middle of a side
            shell.insert(1, (x + size // 2, y))
        holes = [some_ring(dice, x + dice.randint(0, size - 1), y + dice.randint(0, size - 1), 2)
                 for _ in range(dice.choice([0, 0, 1, 1, 2, 3]))]
        if holes and dice.random() < .2:  # around the middle, from corner to corner
            m = [(x + 1, y + 1), (x + 2, y + 1), (x + 2, y + 2), (x + 1, y + 2)]
            holes = [[m[0], (m[0][0], m[0][1] + 1), m[0]][:2] + [m[2]], [m[0], m[1], m[2]]][:dice.randint(1, 2)]
        if size == 6 and dice.random() < .15:  # a hole in a hole
            holes = [[(x + 1, y + 1), (x + 5, y + 1), (x + 1, y + 5)], [(x + 2, y + 2), (x + 3, y + 2), (x + 2, y + 3)]]
        parts.append([shell] + holes if dice.random() < .97 else [])
    return parts


def statement_of(parts, rule, events):
    top = file_of(table_of(parts), {"question": "valid", "parts": list(range(len(parts))), "rule": rule,
                                    "verdict": "valid", "claims": [{"claim": "valid", "events": events}]})
    return top


def defect_of(parts, rule, verdict, **says):
    claim = "contact" if verdict == "edges_meet" else verdict
    brings = {"events": sweep(edges_in(parts))} if verdict == "falls_apart" else {}
    return file_of(table_of(parts), {"question": "valid", "parts": list(range(len(parts))), "rule": rule,
                                     "verdict": verdict, **says, "claims": [{"claim": claim, **brings}]})


def circles_of(rings, of_part, touching):
    """Ways from ring to ring of a part over points in which two touch, each once, back to the first."""
    def ways(way, points):
        for (r, q), places in touching.items():
            if r != way[-1]:
                continue
            for point in places:
                if point in points:
                    continue
                if q == way[0] and len(way) > 1:
                    yield way, points + [point]
                elif q not in way and of_part[q] == of_part[r]:
                    yield from ways(way + [q], points + [point])
    for r in range(len(rings)):
        yield from itertools.islice(ways([r], []), 3)


def defects(parts, rule):
    """Statements of defects: all that are true, and some that are not."""
    rings = [edges_of([ring]) for part in parts for ring in part]
    of_part = [i for i, part in enumerate(parts) for _ in part]
    factor = factor_of([edge for ring in rings for edge in ring])
    rings = [stretched(ring, factor) for ring in rings]
    edges = [edge for ring in rings for edge in ring]

    def text_of(point):
        return [fraction(Fraction(x, factor)) for x in point]
    points, middles = parts_of([edge for edge in edges if edge[0] != edge[1]])
    for r, ring in enumerate(rings):
        yield defect_of(parts, rule, "too_few_points", ring=r)
        for point in points:
            if any(is_on(edge, point) for edge in ring):
                yield defect_of(parts, rule, "comes_twice", ring=r, point=text_of(point))
        for point in middles:
            if any(is_on(edge, point) for edge in ring):
                yield defect_of(parts, rule, "misplaced", ring=r, point=text_of(point))
        for point in points:
            if any(is_on(edge, point) for edge in ring):
                yield defect_of(parts, rule, "crosses", ring=r, point=text_of(point))
    yield defect_of(parts, rule, "falls_apart")
    for (i, s), (j, t) in itertools.combinations(enumerate(edges), 2):
        kind, on_both = kind_of(s, t), [p for p in points if is_on(s, p) and is_on(t, p)]
        if kind and on_both:
            yield defect_of(parts, rule, "edges_meet", i=i, j=j, kind=kind, point=text_of(on_both[0]))
    touching = {}
    for r, q in itertools.permutations(range(len(rings)), 2):
        common = [p for p in points if any(is_on(s, p) for s in rings[r]) and any(is_on(s, p) for s in rings[q])]
        if common and of_part[r] == of_part[q]:
            touching[r, q] = common[:3]
        if common:  # in one point, and rings of two parts, close no circle
            twice = [text_of(common[0]), text_of(common[-1])]
            if len(common) == 1 or of_part[r] != of_part[q]:
                yield defect_of(parts, rule, "circle", rings=[r, q], points=twice)
            yield defect_of(parts, rule, "rings_touch", ring=r, other=q, point=text_of(common[0]))
    for way, places in circles_of(rings, of_part, touching):
        yield defect_of(parts, rule, "circle", rings=way, points=[text_of(p) for p in places])
        if len(rings) > len(way):  # a ring of another part, or one that does not touch, or that does
            other = next(r for r in range(len(rings)) if r not in way)
            yield defect_of(parts, rule, "circle", rings=way[1:] + [other], points=[text_of(p) for p in places])
        yield defect_of(parts, rule, "circle", rings=way, points=[text_of(p) for p in places[1:] + places[-1:]])
    for k in range(len(edges)):
        yield defect_of(parts, rule, "repeated", edge=k)


def edges_in(parts):
    return [edge for part in parts for edge in edges_of(part)]


DEFECTS = {"too_few_points", "edges_meet", "comes_twice", "crosses", "misplaced", "circle", "falls_apart", "repeated",
           "rings_touch"}


class ValidTest(unittest.TestCase):
    def test_it_is_accepted_where_it_is_so_and_only_there(self):
        dice, twins = dice_of(1), Twins(self)
        while twins.count < some(2000):
            parts = some_parts(dice)
            events = sweep(edges_in(parts))
            for rule in RULES:
                wanted = "accepted" if is_valid(parts, rule) else "valid"
                self.assertEqual(twins.look(statement_of(parts, rule, events)), wanted, (parts, rule))
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 16)

    def test_each_defect_is_proved_and_none_that_is_not_there(self):
        dice, twins, accepted = dice_of(4), Twins(self), set()
        while DEFECTS & set(lacking(FORCED, "valid")) or twins.count < some(8000):
            parts, rule = some_parts(dice), dice.choice(RULES)
            if not all(parts):
                continue
            truth, found, are_all = is_valid(parts, rule), False, twins.count < some(8000)
            wanted = lacking(FORCED, "valid")
            for top in defects(parts, rule):
                if not are_all and top["statements"][0]["verdict"] not in wanted:
                    continue
                said = twins.force(top)
                self.assertFalse(truth and said == "accepted", top)
                if said == "accepted":
                    found = True
                    accepted.add(top["statements"][0]["verdict"])
            self.assertTrue(found != truth or not are_all, (parts, rule))
        twins.compare()
        self.assertTrue(some(100) < 30 or accepted == DEFECTS, accepted)

    def test_rings_of_two_parts_close_no_circle(self):
        around = [[(0, 0), (6, 0), (6, 6), (5, 6), (5, 1), (1, 1), (1, 6), (0, 6)]]
        between, twins = [[(1, 3), (3, 2), (5, 3), (3, 4)]], Twins(self)
        self.assertTrue(is_valid([around, between], "valid"))
        points = [["1", "3"], ["5", "3"]]
        said = [twins.look(defect_of(parts, "valid", "circle", rings=[0, 1], points=points))
                for parts in ([around, between], [around + between])]
        self.assertEqual(said, ["circle", "accepted"])
        twins.compare()

    def test_no_forced_sweep_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while "valid" in lacking(FORCED, "valid") or twins.count < some(2000):
            parts, rule = some_parts(dice), dice.choice(RULES)
            truth, events = is_valid(parts, rule), sweep(edges_in(parts))
            if not events:
                continue
            for _ in range(6):
                said = twins.force(statement_of(parts, rule, forced(events, edges_in(parts), dice)))
                self.assertTrue(truth or said != "accepted", twins.last)
                accepted += said == "accepted"
        twins.compare()
        self.assertTrue(some(100) < 30 or 0 < accepted < twins.count / 2, accepted)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, "valid"):
            parts, rule = some_parts(dice), dice.choice(RULES)
            if "valid" in lacking(MUTANT, "valid"):
                twins.spoil(statement_of(parts, rule, sweep(edges_in(parts))), dice)
            for top in defects(parts, rule):
                if top["statements"][0]["verdict"] in lacking(MUTANT, "valid"):
                    twins.spoil(top, dice)
        twins.compare()


if __name__ == "__main__":
    main()
