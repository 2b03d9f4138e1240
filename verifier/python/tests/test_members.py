#!/usr/bin/env python3
"""Tests of statements about members of a set, discs and boxes: python3 verifier/python/tests/test_members.py.

Against brute force.
"""
import itertools
import unittest
from decimal import Decimal
from fractions import Fraction

from files import (FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some,
                   spoilt_in_statements)
from sunder_verify import reader, rules, tables

ALLOWED = ("nothing", "shared-endpoint", "touch")
KINDS = ("touching", "overlapping", "inside")


class Circles:
    name = "circles"

    @staticmethod
    def kind_of(c, d):
        """By the distance itself: a square root, which is exact where it is a whole number."""
        apart = Decimal((c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2).sqrt()
        if apart > c[2] + d[2]:
            return None
        if apart == c[2] + d[2]:
            return "touching"
        return "inside" if apart <= abs(c[2] - d[2]) else "overlapping"

    @staticmethod
    def one(size, dice):
        return dice.randint(0, size), dice.randint(0, size), dice.choice([0, 1, 1, 2, 3])

    @staticmethod
    def points(c, d):
        """Often of both."""
        (a, b, r), (x, y, s) = c, d
        along = Fraction(r, r + s) if r + s else 0
        return [(a + along * (x - a), b + along * (y - b))] * 5 + [(Fraction(a), Fraction(y)), (x + s, y)]

    @staticmethod
    def holds(c, p):
        return (p[0] - c[0]) ** 2 + (p[1] - c[1]) ** 2 <= c[2] ** 2


class Boxes:
    name = "boxes"

    @staticmethod
    def kind_of(a, b):
        """By the points in the middle of the edges of a lattice, and at its corners."""
        def closed(box):
            return set(itertools.product(range(2 * box[0], 2 * box[2] + 1), range(2 * box[1], 2 * box[3] + 1)))

        def inside(box):
            return set(itertools.product(*(range(2 * low + 1, 2 * high) or [2 * low]
                                           for low, high in ((box[0], box[2]), (box[1], box[3])))))
        p, q = closed(a), closed(b)
        if not p & q:
            return None
        if not inside(a) & inside(b):
            return "touching"
        return "inside" if p <= q or q <= p else "overlapping"

    @staticmethod
    def one(size, dice):
        x, y = dice.randint(0, size), dice.randint(0, size)
        return x, y, x + dice.choice([0, 1, 2, 3]), y + dice.choice([0, 1, 2, 3])

    @staticmethod
    def points(a, b):
        corner = Fraction(max(a[0], b[0])), Fraction(max(a[1], b[1]))
        return [corner] * 4 + [(Fraction(a[0] + b[2], 2), corner[1]), (b[0], b[3])]

    @staticmethod
    def holds(box, p):
        return box[0] <= p[0] <= box[2] and box[1] <= p[1] <= box[3]


SETS = Circles, Boxes


def contacts_of(of, members, allowed, groups):
    kinds = [[i, j, of.kind_of(members[i], members[j])] for i, j in itertools.combinations(range(len(members)), 2)]
    return [[i, j, kind] for i, j, kind in kinds if kind and (allowed == "nothing" or kind != "touching")
            and (groups is None or groups[i] != groups[j])]


def some_members(of, dice):
    size = dice.choice([2, 4, 8, 20])
    return [of.one(size, dice) for _ in range(dice.randint(1, 7))]


def some_groups(members, dice):
    return dice.choice([None, None, [dice.randint(-1, 1) for _ in members], [7] * len(members)])


def certificate(of, members, allowed, groups, said):
    statement = {"question": of.name, "allowed": allowed, **said}
    if groups is not None:
        statement["groups"] = groups
    return file_of({of.name: [[hexadecimal(x) for x in row] for row in members]}, statement)


def covers(of, members, allowed, groups, dice):
    """What is true of them, as said by covers of any order."""
    order, contacts = list(range(len(members))), contacts_of(of, members, allowed, groups)
    dice.shuffle(order)
    claims = [{"claim": "cover", "order": order}]
    result = [{"verdict": "these", "contacts": contacts, "claims": claims},
              {"verdict": "count", "number": len(contacts), "claims": claims}]
    return result + ([] if contacts else [{"verdict": "none", "claims": claims}])


def some_of(of, members, dice):
    """That two of them meet, which may be so; and whether it is."""
    groups, allowed = some_groups(members, dice), dice.choice(ALLOWED)
    i, j = dice.randrange(len(members)), dice.randrange(len(members))
    kind = of.kind_of(members[i], members[j]) if dice.random() < .8 else dice.choice(KINDS)
    point = dice.choice(of.points(members[i], members[j]))
    holds = of.holds(members[i], point) and of.holds(members[j], point)
    truth = holds and [*sorted((i, j)), kind] in contacts_of(of, members, allowed, groups)
    said = {"verdict": "some", "i": i, "j": j, "kind": kind or "touching", "point": [fraction(x) for x in point]}
    return certificate(of, members, allowed, groups, {**said, "claims": [{"claim": "contact"}]}), truth


def is_true(of, top):
    """Of a file that a checker accepted, its table as it was made."""
    (statement,) = top["statements"]
    members = [tuple(int(x.split("p")[0], 16) for x in row) for row in top["tables"][of.name]]
    contacts = contacts_of(of, members, statement["allowed"], statement.get("groups"))
    if statement["verdict"] == "some":
        return [*sorted((statement["i"], statement["j"])), statement["kind"]] in contacts
    return contacts == statement["contacts"] if "contacts" in statement else len(contacts) == statement.get("number", 0)


class MembersTest(unittest.TestCase):
    def test_what_is_true_is_accepted_and_nothing_else(self):
        for of in SETS:
            dice, twins = dice_of(31), Twins(self)
            while twins.count < some(2000):
                members = some_members(of, dice)
                groups = some_groups(members, dice)
                for allowed in ALLOWED:
                    for said in covers(of, members, allowed, groups, dice):
                        top = certificate(of, members, allowed, groups, said)
                        self.assertEqual(twins.look(top), "accepted", twins.last)
                        for forced in (dice.choice(ALLOWED), groups), (allowed, some_groups(members, dice)):
                            top = certificate(of, members, *forced, said)
                            self.assertEqual(twins.look(top), "accepted" if is_true(of, top) else "cover", top)
            twins.compare()
            self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 20)

    def test_a_contact_is_accepted_where_it_counts_and_is_as_stated(self):
        for of in SETS:
            dice, twins = dice_of(32), Twins(self)
            while "some" in lacking(FORCED, of.name):
                members = some_members(of, dice)
                if len(members) > 1:
                    top, truth = some_of(of, members, dice)
                    self.assertEqual(twins.force(top), "accepted" if truth else "contact", top)
            twins.compare()
            self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 20)

    def test_no_forced_certificate_proves_what_is_not_so(self):
        """What is true with changes; and covers, of which there is one for each order, of what is not so."""
        for of in SETS:
            dice, twins, accepted = dice_of(33), Twins(self), 0
            while set(lacking(FORCED, of.name)) - {"some"}:
                members = some_members(of, dice)
                groups, allowed = some_groups(members, dice), dice.choice(ALLOWED)
                said = covers(of, members, allowed, groups, dice)
                forced = [spoilt_in_statements(certificate(of, members, allowed, groups, one), dice)
                          for one in said * 2]
                contacts = [c for c in said[0]["contacts"] if dice.random() < .8]
                for more in ({"verdict": "none"}, {"verdict": "count", "number": len(contacts)},
                             {"verdict": "these", "contacts": contacts}):
                    forced.append(certificate(of, members, allowed, groups, {**more, "claims": said[0]["claims"]}))
                for top in forced:
                    if twins.force(top) == "accepted":
                        self.assertTrue(is_true(of, top), top)
                        accepted += 1
            twins.compare()
            self.assertTrue(some(100) < 100 or accepted > twins.count / 50)  # another order, another rule

    def test_the_twins_agree_on_spoilt_files(self):
        for of in SETS:
            dice, twins = dice_of(34), Twins(self)
            while lacking(MUTANT, of.name):
                members = some_members(of, dice)
                groups, allowed = some_groups(members, dice), dice.choice(ALLOWED)
                for said in covers(of, members, allowed, groups, dice):
                    twins.spoil(certificate(of, members, allowed, groups, said), dice)
                if len(members) > 1:
                    twins.spoil(some_of(of, members, dice)[0], dice)
            twins.compare()

    def test_how_much_is_looked_at(self):
        """Nodes that are apart, and nodes of one group, are not gone into."""
        def looks(members, order, groups=range(1024)):
            steps = reader.Steps(0)
            table = tables.TABLES["circles"]([[hexadecimal(x) for x in row] for row in members], "circles")
            most = steps.left
            for _ in rules.contacts_by_cover(steps, order, table, groups, ()):
                pass
            return (most - steps.left) // 17  # one look is 16 and 1 steps
        row, one_place, order = [(3 * k, 0, 1) for k in range(1024)], [(0, 0, 1)] * 1024, list(range(1024))
        self.assertLess(looks(row, order), 5 * 1024)
        self.assertGreater(looks(row, [k * 509 % 1024 for k in order]), 100 * 1024)
        self.assertEqual(looks(one_place, order, [0] * 1024), 1)
        self.assertEqual(looks(one_place, order, [k // 512 for k in order]), 3 + 2 * 512 ** 2 - 1)
        self.assertEqual(looks([], []), 0)


if __name__ == "__main__":
    main()
