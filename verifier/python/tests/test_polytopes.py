#!/usr/bin/env python3
"""Tests of statements about polytopes of any dimension against an exact simplex method, and of both checkers against
each other: python3 verifier/python/tests/test_polytopes.py."""
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some
from test_pairs import product, solution_or_proof, value_of


class Body:
    """Points, or half-spaces a1, .., ad, b, of small integers in one unit; and where it is: a matrix and a shift, of
    small integers in units of their own."""

    def __init__(self, dice, d, of_points, is_image):
        self.d, self.of_points, self.is_image = d, of_points, is_image
        size = dice.choice([1, 2])
        count = dice.randint(1, d + 2) if of_points else dice.randint(0, d + 3)
        unit, turned, moved = dice.choice([(1, 1, 1), (1, 1, 1), (Fraction(1, 4), 4, 1),
                                           (8, Fraction(1, 8), Fraction(1, 2))])
        self.rows = [[dice.randint(-size, size) * unit for _ in range(d + (not of_points))] for _ in range(count)]
        self.linear = [[int(r == c) for c in range(d)] for r in range(d)]
        self.shift = [0] * d
        if is_image:  # also one that is flattened
            self.linear = [[dice.randint(-2, 2) * turned for _ in range(d)] for _ in range(d)]
            self.shift = [dice.randint(-2, 2) * moved for _ in range(d)]

    def entries(self, name, at):
        rows = [[hexadecimal(x) for x in row] for row in self.rows]
        result = [{"name": name, "dimension": self.d, "points" if self.of_points else "half_spaces": rows}]
        if self.is_image:
            result.append({"name": name, "of": at, "linear": [hexadecimal(x) for row in self.linear for x in row],
                           "translation": [hexadecimal(x) for x in self.shift]})
        return result

    def image(self, v):
        return [product(row, v) + t for row, t in zip(self.linear, self.shift)]

    # As a part of a linear program: columns with an entry for each coordinate and each row of its own.
    def columns(self):
        if self.of_points:
            return [[product(row, p) for row in self.linear] + [1] for p in self.rows]
        own = [[row[c] for row in self.linear] + [row[c] for row in self.rows] for c in range(self.d)]
        slack = [[0] * self.d + [int(i == k) for i in range(len(self.rows))] for k in range(len(self.rows))]
        return own + [[-x for x in column] for column in own] + slack

    def wanted(self):
        return [1] if self.of_points else [row[-1] for row in self.rows]

    def claim(self, x):
        """That the body holds a point, by a solution; and the point."""
        if self.of_points:
            place = [sum(w * p[c] for w, p in zip(x, self.rows)) for c in range(self.d)]
            return {"claim": "keeps", "weights": [[k, fraction(w)] for k, w in enumerate(x) if w], "at": []}, self.image(place)
        place = [p - n for p, n in zip(x[:self.d], x[self.d:])]
        return {"claim": "keeps", "weights": [], "at": [fraction(p) for p in place]}, self.image(place)

    def multipliers(self, proof):
        return [] if self.of_points else [[k, fraction(-y)] for k, y in enumerate(proof) if y]


def around(body, direction, proof, dice):
    """Planes around a body of points, in its frame, and multipliers that make the direction: by that alone, or by two
    that sum to it, among others that nothing is made of. And how far it goes along the direction, by these."""
    shift = product(direction, body.shift)
    if not body.of_points:
        multipliers = body.multipliers(proof)
        return [], multipliers, shift + sum(Fraction(m) * body.rows[k][-1] for k, m in multipliers)
    pulled = [product(direction, [row[c] for row in body.linear]) for c in range(body.d)]
    part = [dice.randint(-1, 1) if dice.random() < .3 else 0 for _ in pulled]
    normals = [pulled] if not any(part) else [part, [x - y for x, y in zip(pulled, part)]]
    planes = []
    for normal in normals:
        factor = dice.choice([Fraction(1), Fraction(2), Fraction(1, 3)])
        planes.append(([factor * x for x in normal + [max(product(normal, p) for p in body.rows)]], 1 / factor))
    limit = shift + sum(m * plane[-1] for plane, m in planes)
    for _ in range(dice.randint(0, 3)):
        normal = [dice.randint(-2, 2) for _ in range(body.d)]
        planes.append((normal + [max(product(normal, p) for p in body.rows) + dice.randint(0, 1)], 0))
    dice.shuffle(planes)
    return ([fraction(x) for plane, _ in planes for x in plane],
            [[k, fraction(m)] for k, (_, m) in enumerate(planes) if m or dice.random() < .2], limit)


def by_hyperplanes(statement, direction, a, b, proof_a, proof_b, dice):
    """The same by planes, if these suffice."""
    planes_a, by_a, limit_a = around(a, direction, proof_a, dice)
    planes_b, by_b, limit_b = around(b, [-x for x in direction], proof_b, dice)
    if limit_a + limit_b >= 0:
        return None
    return {**statement, "verdict": "apart_by_hyperplanes", "claims": [
        {"claim": "parted_by_hyperplanes", "direction": [fraction(x) for x in direction], "planes_a": planes_a,
         "by_a": by_a, "planes_b": planes_b, "by_b": by_b}]}


def honest(a, b, i, j, dice=None):
    d, first, second = a.d, a.columns(), b.columns()
    rows_a, rows_b = len(a.wanted()), len(b.wanted())
    columns = [c + [0] * rows_b for c in first] + [[-x for x in c[:d]] + [0] * rows_a + c[d:] for c in second]
    weights, proof = solution_or_proof(columns, [t - s for s, t in zip(a.shift, b.shift)] + a.wanted() + b.wanted())
    statement = {"question": "polytopes", "a": i, "b": j}
    if weights is None:
        proof_a, proof_b = proof[d:d + rows_a], proof[d + rows_a:]
        by = dice and dice.random() < .5 and by_hyperplanes(statement, proof[:d], a, b, proof_a, proof_b, dice)
        if by:
            return by
        return {**statement, "verdict": "apart", "claims": [
            {"claim": "parted_by", "direction": [fraction(y) for y in proof[:d]],
             "of_a": a.multipliers(proof[d:d + rows_a]), "of_b": b.multipliers(proof[d + rows_a:])}]}
    (of_a, point), (of_b, same) = a.claim(weights[:len(first)]), b.claim(weights[len(first):])
    assert point == same
    return {**statement, "verdict": "meet", "point": [fraction(x) for x in point], "claims": [of_a, of_b]}


def some_file(dice):
    d = dice.choice([2, 3, 4, 4, 5, 6])
    a, b = (Body(dice, d, dice.random() < .4, dice.random() < .5) for _ in range(2))
    entries = a.entries("a", 0)
    i, at = len(entries) - 1, len(entries)
    entries += b.entries("b", at)
    return file_of({"polytopes": entries}, honest(a, b, i, len(entries) - 1, dice))


def holds(entries, k, point, claim):
    """Is what `keeps` says true? By fractions, in another way than the checkers."""
    entry = entries[k]
    of = entries[entry["of"]] if "of" in entry else entry
    d, rows = of["dimension"], [list(map(value_of, row)) for row in of.get("points", of.get("half_spaces"))]
    linear = list(map(value_of, entry["linear"])) if "of" in entry else [int(r == c) for r in range(d) for c in range(d)]
    shift = list(map(value_of, entry["translation"])) if "of" in entry else [0] * d
    if "points" in of:
        weights = [(k, Fraction(w)) for k, w in claim["weights"]]
        v = [sum(w * rows[k][c] for k, w in weights) for c in range(d)]
        kept = sum(w for _, w in weights) == 1 and all(w >= 0 for _, w in weights)
    else:
        v = [Fraction(x) for x in claim["at"]]
        kept = all(product(row[:d], v) <= row[d] for row in rows)
    return kept and [product(linear[r * d:r * d + d], v) + shift[r] for r in range(d)] == [Fraction(x) for x in point]


def changed(number, dice):
    return fraction(Fraction(number) + dice.choice([Fraction(1, 7), -Fraction(1, 7), 1, -1]))


class Polytopes(unittest.TestCase):
    def setUp(self):
        self.twins = Twins(self)

    def tearDown(self):
        self.twins.compare()

    def test_honest_ones_are_accepted(self):
        dice, count = dice_of(2026), {"apart": 0, "apart_by_hyperplanes": 0, "meet": 0}
        for _ in range(some(400)):
            top = some_file(dice)
            self.assertEqual(self.twins.force(top), "accepted", top)
            count[top["statements"][0]["verdict"]] += 1
        self.assertGreater(min(count.values()), some(400) // 10)

    def test_untrue_ones_are_refused(self):
        """A number of the claims is another one; what is then true is told by fractions, or no more is known of it."""
        dice, refused = dice_of(2027), {"keeps": 0, "parted_by": 0, "parted_by_hyperplanes": 0}
        tries = 0
        while tries < some(300) or lacking(FORCED, "polytopes"):
            tries += 1
            top = some_file(dice)
            one = top["statements"][0]
            if one["verdict"] == "meet":
                claim = dice.choice(one["claims"])
                numbers = [one["point"], claim["at"], *([claim["weights"][0]] if claim["weights"] else [])]
                those = dice.choice([n for n in numbers if n])
                k = len(those) - 1 if those in claim["weights"] else dice.randrange(len(those))
                those[k] = changed(those[k], dice)
                is_true = all(holds(top["tables"]["polytopes"], one[key], one["point"], c)
                              for key, c in zip("ab", one["claims"]))
                said = self.twins.force(top)
                self.assertEqual(said, "accepted" if is_true else "keeps", top)
                refused["keeps"] += not is_true
            elif one["verdict"] == "apart_by_hyperplanes":
                claim, change = one["claims"][0], dice.randrange(3)
                sides = [side for side in "ab" if claim["planes_" + side]]
                multiplied = [side for side in "ab" if any(Fraction(m) for _, m in claim["by_" + side])]
                if change == 0 and sides:  # a plane that does not hold all
                    side = dice.choice(sides)
                    k, planes = one[side], claim["planes_" + side]
                    entry = top["tables"]["polytopes"][k]
                    rows = top["tables"]["polytopes"][entry.get("of", k)]["points"]
                    last = len(rows[0]) + dice.randrange(len(planes) // (len(rows[0]) + 1)) * (len(rows[0]) + 1)
                    normal = [Fraction(x) for x in planes[last - len(rows[0]):last]]
                    furthest = max(product(normal, list(map(value_of, p))) for p in rows)
                    planes[last] = fraction(furthest - Fraction(1, dice.choice([1, 10 ** 9])))
                elif change == 1 and multiplied:  # another multiplier: of another direction, or of normals that are zero
                    row = dice.choice([row for row in claim["by_" + dice.choice(multiplied)] if Fraction(row[1])])
                    row[1] = fraction(-Fraction(row[1]))
                elif not multiplied:  # the direction alone parts them
                    continue
                else:
                    for key in ("by_a", "by_b"):
                        claim[key] = [[k, "0"] for k, _ in claim[key]]
                self.assertEqual(self.twins.force(top), "parted_by_hyperplanes", top)
                refused["parted_by_hyperplanes"] += 1
            else:
                claim = one["claims"][0]
                lists = [claim[key] for key in ("of_a", "of_b") if claim[key]]
                if not lists:  # of points: the opposite direction never parts them
                    claim["direction"] = [fraction(-Fraction(x)) for x in claim["direction"]]
                else:  # a multiplier less than zero, or one that is missing
                    those = dice.choice(lists)
                    row = dice.choice(those)
                    row[1] = fraction(-Fraction(row[1]))
                self.assertEqual(self.twins.force(top), "parted_by", top)
                refused["parted_by"] += 1
        self.assertGreater(min(refused.values()), some(300) // 8)

    def test_spoilt_ones(self):
        """Both checkers say the same of them."""
        dice = dice_of(2028)
        tries = 0
        while tries < some(300) or lacking(MUTANT, "polytopes"):
            tries += 1
            self.twins.spoil(some_file(dice), dice)
        self.assertGreater(self.twins.tally()["F"], 0)

    def test_the_form(self):
        dice = dice_of(2029)
        for change in (
                lambda e: e.update(dimension=7), lambda e: e.update(dimension=1), lambda e: e.update(dimension="4"),
                lambda e: e.update(points=[]), lambda e: e.update(half_spaces=[]),
                lambda e: e["points"].append(["0x0p+0"]), lambda e: e.pop("dimension")):
            top = some_file(dice)
            while "points" not in top["tables"]["polytopes"][0]:
                top = some_file(dice)
            change(top["tables"]["polytopes"][0])
            self.assertEqual(self.twins.look(top), "F")

    def test_pairs_of_bodies_of_any_dimension(self):
        """Of points the question `pair` has all dimensions, too."""
        dice, count = dice_of(2030), {"apart": 0, "meet": 0}
        for _ in range(max(40, some(200))):
            d = dice.choice([4, 5, 6])
            a, b = (Body(dice, d, True, False) for _ in range(2))
            statement = honest(a, b, 0, 1)
            verdict = statement["verdict"]
            claims = [{"claim": "holds", "weights": c["weights"]} if verdict == "meet" else
                      {"claim": "parted", "direction": c["direction"]} for c in statement["claims"]]
            top = file_of({"bodies": [{k: v for k, v in x.entries("body", 0)[0].items() if k != "dimension"} for x in (a, b)]},
                          {**statement, "question": "pair", "claims": claims})
            self.assertEqual(self.twins.look(top), "accepted")
            count[verdict] += 1
            if verdict == "apart":
                claims[0]["direction"] = [fraction(-Fraction(x)) for x in claims[0]["direction"]]
                self.assertEqual(self.twins.look(top), "parted")
        self.assertGreater(min(count.values()), 0)


if __name__ == "__main__":
    main()
