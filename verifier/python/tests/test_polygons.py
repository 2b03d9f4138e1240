#!/usr/bin/env python3
"""Tests of statements about polygons against fractions and brute force: python3 verifier/python/tests/test_polygons.py."""
import itertools
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some
from test_segments import above, crossings, factor_of, forced, is_on, stretched, sweep

RULES = ("nothing", "shared-endpoint", "touch")


def edges_of(rings):
    return [tuple(sorted(edge)) for ring in rings for edge in zip(ring, ring[1:] + ring[:1])]


def parts_of(edges):
    """The ends of edges and their crossings, and the middles between those that follow each other on an edge; of edges that
    are stretched enough."""
    points = {end for edge in edges for end in edge}
    points |= {(x + p * ux // across, y + p * uy // across) for (x, y), (ux, uy), p, across in crossings(edges)}
    middles = set()
    for edge in edges:
        along = sorted(p for p in points if is_on(edge, p))
        middles |= {((px + qx) // 2, (py + qy) // 2) for (px, py), (qx, qy) in zip(along, along[1:])}
    return points, middles


def sides(edges, p):
    """Is it inside just below the point, and just above it? Of a point that is no end of an edge."""
    below = sum(a < p < b and above((a, b), p) > 0 for a, b in edges) % 2 == 1
    return below, (sum(a < p < b and above((a, b), p) >= 0 for a, b in edges) % 2 == 1)


def holds(edges, p):
    return any(is_on(edge, p) for edge in edges) or sum(a <= p < b and above((a, b), p) > 0 for a, b in edges) % 2 == 1


def is_flat(edges):
    return len(edges) < 3


def is_within(edges, p):
    """Is it inside? Of a segment: not an end."""
    on = [edge for edge in edges if is_on(edge, p)]
    return (is_flat(edges) and any(p not in edge or edge[0] == edge[1] for edge in on)) or (not on and holds(edges, p))


def point_counts(a, b, p, allowed):
    """Is the point common to both, and does it count?"""
    if not (holds(a, p) and holds(b, p)):
        return False
    on = [[edge for edge in edges if is_on(edge, p)] for edges in (a, b)]
    if allowed == "touch":
        return is_within(a, p) and is_within(b, p)
    return allowed == "nothing" or not on[0] or not on[1] or any(p not in edge for edge in on[0] + on[1])


def meet(a, b, allowed):
    """Have two polygons a common point that counts? By their edges."""
    factor = factor_of(a + b)
    a, b = stretched(a, factor), stretched(b, factor)
    points, middles = parts_of(a + b)
    if allowed == "touch":
        if any(p and q for m in middles for p, q in zip(sides(a, m), sides(b, m))):
            return True
    return any(point_counts(a, b, p, allowed) for p in points | middles)


def pairs_that_meet(polygons, allowed, groups):
    edges = [edges_of(rings) for rings in polygons]
    return [[i, j] for i, j in itertools.combinations(range(len(polygons)), 2)
            if (groups is None or groups[i] != groups[j]) and meet(edges[i], edges[j], allowed)]


def table_of(polygons):
    return {"polygons": [[[[hexadecimal(x), hexadecimal(y)] for x, y in ring] for ring in rings] for rings in polygons]}


def statement_of(allowed, groups, verdict, claim, **more):
    statement = {"question": "polygons", "allowed": allowed, "verdict": verdict, **more, "claims": [claim]}
    if groups is not None:
        statement["groups"] = groups
    return statement


def none_of(polygons, allowed, groups, events):
    return file_of(table_of(polygons), statement_of(allowed, groups, "none", {"claim": "none_counts", "events": events}))


def these_of(polygons, allowed, groups, events, contacts):
    claim = {"claim": "these_count", "events": events}
    return file_of(table_of(polygons), statement_of(allowed, groups, "these", claim, contacts=contacts))


def number_of(polygons, allowed, groups, events, number):
    claim = {"claim": "number_counts", "events": events}
    return file_of(table_of(polygons), statement_of(allowed, groups, "count", claim, number=number))


def kinds_of(polygons, allowed, groups, events, pairs, inside):
    """Each pair and how it meets, if those of `inside` overlap."""
    claim = {"claim": "these_kinds", "events": events}
    kinds = [[*pair, "overlapping" if pair in inside else "touching"] for pair in pairs]
    return file_of(table_of(polygons), statement_of(allowed, groups, "these_kinds", claim, kinds=kinds))


def numbers_of(polygons, allowed, groups, events, overlapping, touching):
    claim = {"claim": "kinds_count", "events": events}
    return file_of(table_of(polygons), statement_of(allowed, groups, "count_kinds", claim, overlapping=overlapping, touching=touching))


def two_of(polygons, i, j, verdict, events):
    return file_of(table_of(polygons), {"question": "two_polygons", "pair": [i, j], "verdict": verdict,
                                        "claims": [{"claim": "how_two_meet", "events": events}]})


def some_of(polygons, dice):
    """That two of them have a common point, which may be so; and whether it is."""
    i, j = dice.sample(range(len(polygons)), 2) if dice.random() < .95 else (0, 0)
    groups, allowed = some_groups(polygons, dice), dice.choice(RULES)
    a, b = edges_of(polygons[i]), edges_of(polygons[j])
    factor = factor_of(a + b)
    points, middles = parts_of(stretched(a + b, factor))
    near = dice.choice(sorted(points | middles))
    point = tuple(Fraction(x, factor) + dice.choice([0, 0, 0, 0, Fraction(1, 7), Fraction(-1, 9)]) for x in near)
    truth = i != j and (groups is None or groups[i] != groups[j]) and point_counts(a, b, point, allowed)
    return file_of(table_of(polygons), statement_of(allowed, groups, "some", {"claim": "common_point"}, i=i, j=j,
                                                    point=[fraction(x) for x in point])), truth


def events_of(polygons):
    return sweep([edge for rings in polygons for edge in edges_of(rings)])


def some_ring(dice, at, size):
    x, y = at
    if dice.random() < .3:
        w, h = dice.randint(1, 2), dice.randint(1, 2)
        return [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
    return [(x + dice.randint(0, size), y + dice.randint(0, size)) for _ in range(dice.choice([1, 2, 3, 3, 3, 4, 4, 5]))]


def some_polygons(dice):
    """Rings of few points near some places; equal ones, and with vertices, spikes and borders in common."""
    size, spread = dice.choice([2, 3]), dice.choice([1, 3, 5])
    polygons = []
    for _ in range(dice.randint(1, 4)):
        at = dice.randint(0, spread), dice.randint(0, spread)
        polygons.append([some_ring(dice, at, size) for _ in range(dice.choice([1, 1, 1, 2]))])
        throw = dice.random()
        if throw < .15:
            polygons.append([list(reversed(ring)) for ring in dice.choice(polygons)])
        elif throw < .3:  # around it
            x, y = at
            polygons.append([[(x - 1, y - 1), (x + size + 2, y - 1), (x + size + 2, y + size + 1), (x - 1, y + size + 1)]])
        elif throw < .45:  # from vertex to vertex
            vertices = [p for rings in polygons for ring in rings for p in ring]
            polygons.append([[dice.choice(vertices) for _ in range(dice.choice([2, 3]))]])
    return polygons


def some_groups(polygons, dice):
    return dice.choice([None, None, [dice.randint(0, 1) for _ in polygons]])


class PolygonsTest(unittest.TestCase):
    def test_none_these_and_counts_are_accepted_where_they_are_so_and_only_there(self):
        dice, twins = dice_of(1), Twins(self)
        for _ in range(some(200)):
            polygons = some_polygons(dice)
            groups, events = some_groups(polygons, dice), events_of(polygons)
            for allowed in RULES:
                pairs = pairs_that_meet(polygons, allowed, groups)
                inside = [pair for pair in pairs_that_meet(polygons, "touch", groups) if pair in pairs]
                others = [pair for pair in pairs if dice.random() < .7 or pair in inside]
                changed = [list(pair) for pair in itertools.combinations(range(len(polygons)), 2) if dice.random() < .5]
                number = dice.choice([len(pairs), max(0, len(pairs) - 1), len(pairs) + 1])
                for top, truth, rule in (
                        (none_of(polygons, allowed, groups, events), not pairs, "none_counts"),
                        (these_of(polygons, allowed, groups, events, pairs), True, "these_count"),
                        (these_of(polygons, allowed, groups, events, changed), changed == pairs, "these_count"),
                        (number_of(polygons, allowed, groups, events, number), number == len(pairs), "number_counts"),
                        (kinds_of(polygons, allowed, groups, events, pairs, inside), True, "these_kinds"),
                        (kinds_of(polygons, allowed, groups, events, pairs, others), others == inside, "these_kinds"),
                        (kinds_of(polygons, allowed, groups, events, others, inside), others == pairs, "these_kinds"),
                        (numbers_of(polygons, allowed, groups, events, len(inside), number - len(inside)
                                    if number >= len(inside) else 0),
                         max(number, len(inside)) == len(pairs), "kinds_count")):
                    self.assertEqual(twins.look(top), "accepted" if truth else rule, (polygons, groups, allowed, pairs))
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 30)

    def test_a_point_is_accepted_where_it_is_common_and_counts(self):
        dice, twins = dice_of(4), Twins(self)
        while "some" in lacking(FORCED, "polygons"):
            polygons = some_polygons(dice)
            if len(polygons) > 1:
                top, truth = some_of(polygons, dice)
                self.assertEqual(twins.force(top), "accepted" if truth else "common_point", top)
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 50)

    def test_how_two_meet(self):
        dice, twins, kinds = dice_of(5), Twins(self), ("apart", "touching", "overlapping")
        while lacking(FORCED, "two_polygons") or lacking(MUTANT, "two_polygons"):
            polygons = some_polygons(dice)
            if len(polygons) < 2:
                continue
            i, j = dice.sample(range(len(polygons)), 2)
            pair = [polygons[i], polygons[j]]
            truth = kinds[sum(bool(pairs_that_meet(pair, allowed, None)) for allowed in ("nothing", "touch"))]
            edges, events = [edge for rings in pair for edge in edges_of(rings)], events_of(pair)
            for verdict in kinds:
                said = twins.force(two_of(polygons, i, j, verdict, events))
                self.assertEqual(said, "accepted" if verdict == truth else "how_two_meet", twins.last)
                said = twins.force(two_of(polygons, i, j, verdict, forced(events, edges, dice)))
                self.assertTrue(verdict == truth or said != "accepted", twins.last)
                if verdict in lacking(MUTANT, "two_polygons"):
                    twins.spoil(two_of(polygons, i, j, verdict, events), dice)
        twins.compare()

    def test_no_forced_sweep_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while set(lacking(FORCED, "polygons")) - {"some"}:
            polygons = some_polygons(dice)
            edges = [edge for rings in polygons for edge in edges_of(rings)]
            groups, allowed, events = some_groups(polygons, dice), dice.choice(RULES), events_of(polygons)
            pairs = pairs_that_meet(polygons, allowed, groups)
            inside = [pair for pair in pairs_that_meet(polygons, "touch", groups) if pair in pairs]
            for _ in range(6):
                others = [pair for pair in pairs if (pair in inside) ^ (dice.random() < .1)]
                false = forced(events, edges, dice)
                number = dice.choice([len(pairs), len(pairs), max(len(pairs) - 1, 0)])
                for top, truth in ((none_of(polygons, allowed, groups, false), not pairs),
                                   (these_of(polygons, allowed, groups, false, pairs[:number]), number == len(pairs)),
                                   (number_of(polygons, allowed, groups, false, number), number == len(pairs)),
                                   (kinds_of(polygons, allowed, groups, false, pairs[:number], others),
                                    number == len(pairs) and others == inside),
                                   (numbers_of(polygons, allowed, groups, false, len(others), len(pairs) - len(others)),
                                    len(others) == len(inside))):
                    said = twins.force(top)
                    self.assertTrue(truth or said != "accepted", top)
                    accepted += said == "accepted"
        twins.compare()
        self.assertTrue(some(100) < 100 or 0 < accepted < twins.count / 2, accepted)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, "polygons"):
            polygons = some_polygons(dice)
            groups, allowed, events = some_groups(polygons, dice), dice.choice(RULES), events_of(polygons)
            pairs = pairs_that_meet(polygons, allowed, groups)
            tops = {"none": none_of(polygons, allowed, groups, events),
                    "these": these_of(polygons, allowed, groups, events, pairs),
                    "count": number_of(polygons, allowed, groups, events, len(pairs)),
                    "these_kinds": kinds_of(polygons, allowed, groups, events, pairs, pairs),
                    "count_kinds": numbers_of(polygons, allowed, groups, events, len(pairs), 0)}
            if len(polygons) > 1:
                tops["some"], _ = some_of(polygons, dice)
            for verdict in lacking(MUTANT, "polygons"):
                if verdict in tops:
                    twins.spoil(tops[verdict], dice)
        twins.compare()


if __name__ == "__main__":
    main()
