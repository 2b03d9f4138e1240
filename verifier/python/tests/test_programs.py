#!/usr/bin/env python3
"""Tests of statements about linear programs against brute force: python3 verifier/python/tests/test_programs.py."""
import itertools
import unittest
from fractions import Fraction

from files import (FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking,
                   main, some, spoilt_in_statements)
from test_pairs import solution_or_proof


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def turn(u, v):
    return u[0] * v[1] - u[1] * v[0]


def candidates(given):
    """Corners, and of each line the point next to (0, 0): where there are common points, some are among these."""
    yield Fraction(0), Fraction(0)
    for a, b, c in given:
        yield Fraction(a * c, a * a + b * b), Fraction(b * c, a * a + b * b)
    for g, h in itertools.combinations(given, 2):
        if turn(g, h):
            yield Fraction(g[2] * h[1] - h[2] * g[1], turn(g, h)), Fraction(g[0] * h[2] - h[0] * g[2], turn(g, h))


def is_in(given, point):
    return all(dot(h, point) <= h[2] for h in given)


def weights_of(given, tight, objective, is_only):
    """Weights of tight half-planes for the objective; of two directions at least, where is_only."""
    if not is_only:
        parallel = [k for k in tight if turn(given[k], objective) == 0]
        found, _ = solution_or_proof([given[k][:2] for k in parallel], objective)
        return {k: w for k, w in zip(parallel, found) if w}
    few = Fraction(1, 1024)
    for i, j in itertools.combinations(tight, 2):
        if turn(given[i], given[j]):
            rest = [u - few * (p + q) for u, p, q in zip(objective, given[i], given[j])]
            found, _ = solution_or_proof([given[k][:2] for k in tight], rest)
            if found:
                return {k: w + (few if k in (i, j) else 0) for k, w in zip(tight, found) if w or k in (i, j)}
    raise AssertionError("no weights")


def truth(given, objective):
    """The verdict, the point, and the ends of `many`: points, or None."""
    inside = [p for p in candidates(given) if is_in(given, p)]
    if not inside:
        return "infeasible", None, None
    if objective == (0, 0):
        return "all", inside[0], None
    _, way = solution_or_proof([h[:2] for h in given], objective)
    if way:
        return "unbounded", inside[0], way
    best = max(dot(objective, p) for p in inside)
    furthest = sorted({p for p in inside if dot(objective, p) == best}, key=lambda p: turn(objective, p))
    ends = []
    for sign, end in ((1, furthest[0]), (-1, furthest[-1])):
        along = sign * objective[1], -sign * objective[0]
        ends.append(end if any(dot(h, along) > 0 and dot(h, end) == h[2] for h in given) else None)
    if ends[0] is not None and ends[0] == ends[1]:
        return "one", furthest[0], None
    return "many", furthest[0], ends


def honest(given, objective):
    verdict, point, more = truth(given, objective)
    statement = {"question": "linear_program", "objective": [hexadecimal(x) for x in objective], "verdict": verdict}

    def listed(weights):
        return [[k, fraction(w)] for k, w in weights.items()]
    if verdict == "infeasible":
        weights, _ = solution_or_proof(given, (0, 0, -1))
        named = {k: w for k, w in enumerate(weights) if w}
        return {**statement, "claims": [{"claim": "contradict", "weights": listed(named)}]}
    statement.update(point=[fraction(x) for x in point], claims=[{"claim": "feasible"}])
    tight = [k for k, h in enumerate(given) if dot(h, point) == h[2]]
    if verdict == "all":
        statement["claims"].append({"claim": "no_objective"})
    elif verdict == "unbounded":
        statement["claims"].append({"claim": "goes_on", "direction": [fraction(x) for x in more]})
    elif verdict == "one":
        weights = weights_of(given, tight, objective, True)
        statement["claims"].append({"claim": "bounds_only", "weights": listed(weights)})
    else:
        weights = weights_of(given, tight, objective, False)
        ends = []
        for sign, end in zip((1, -1), more):
            along = sign * objective[1], -sign * objective[0]
            k = end and next(k for k, h in enumerate(given) if dot(h, along) > 0 and dot(h, end) == h[2])
            ends.append(end and [[fraction(x) for x in end], k])
        statement["claims"] += [{"claim": "bounds", "weights": listed(weights)}, {"claim": "ends", "ends": ends}]
    return statement


def some_program(dice):
    most = dice.choice([1, 2, 3])
    given = []
    for _ in range(dice.randint(1, 5)):
        a, b = 0, 0
        while not (a or b):
            a, b = dice.randint(-most, most), dice.randint(-most, most)
        given.append((a, b, dice.randint(-3, 3)))
    return given, (dice.randint(-2, 2), dice.randint(-2, 2))


def file_about(given, statement):
    return file_of({"half_planes": [[hexadecimal(x) for x in h] for h in given]}, statement)


def value(text):
    """A number of any form, as the tests write them."""
    if "x" not in text:
        return Fraction(text)
    digits, exponent = text.split("p")
    return int(digits, 16) * Fraction(2) ** int(exponent)


VERDICTS = ("one", "many", "all", "unbounded", "infeasible")


def forced_statement(given, objective, true_one, verdict, dice):
    """What another verdict would need, of the true one's and of random numbers."""
    claims = {claim["claim"]: claim for claim in true_one["claims"]}
    near = list(candidates(given))
    vector = [str(dice.randint(-2, 2)) for _ in range(2)]
    point = dice.choice([true_one.get("point", vector), [fraction(x) for x in dice.choice(near)]])
    known = [claim["weights"] for claim in true_one["claims"] if "weights" in claim]
    weights = [[k, dice.choice(["1", "2", "1/3"])] for k in dice.sample(range(len(given)), dice.randint(1, min(3, len(given))))]
    weights = dice.choice(known + [weights])

    as_far = []  # of the best points
    if true_one["verdict"] in ("one", "many"):
        best = tuple(map(value, true_one["point"]))
        as_far = [p for p in near if is_in(given, p) and dot(objective, p) == dot(objective, best)]
        as_far += [((p[0] + q[0]) / 2, (p[1] + q[1]) / 2) for p, q in zip(as_far, as_far[1:])]

    def end():
        return dice.choice([None, [[fraction(x) for x in dice.choice(as_far or near)], dice.randrange(len(given))]])
    of_ends = {"claim": "ends", "ends": [end(), end()]}
    along = dice.choice([vector, [str(x) for x in objective], [str(-objective[1]), str(objective[0])]])
    needed = {
        "one": [{"claim": "bounds_only", "weights": weights}],
        "many": [{"claim": "bounds", "weights": weights}, dice.choice([of_ends, claims.get("ends", of_ends)])],
        "all": [{"claim": "no_objective"}],
        "unbounded": [{"claim": "goes_on", "direction": along}],
        "infeasible": [{"claim": "contradict", "weights": weights}]}[verdict]
    statement = {**{key: true_one[key] for key in ("question", "objective")}, "verdict": verdict}
    if verdict == "infeasible":
        return {**statement, "claims": needed}
    return {**statement, "point": point, "claims": [{"claim": "feasible"}] + needed}


class ProgramsTest(unittest.TestCase):
    def test_each_program_is_proved(self):
        dice, twins, verdicts = dice_of(21), Twins(self), []
        for _ in range(some(800)):
            given, objective = some_program(dice)
            statement = honest(given, objective)
            verdicts.append(statement["verdict"])
            self.assertEqual(twins.look(file_about(given, statement)), "accepted", twins.last)
        twins.compare()
        for verdict in VERDICTS:
            self.assertTrue(some(100) < 100 or verdicts.count(verdict) > 0)

    def test_arrows(self):
        """The same half-planes, as what is left of arrows: the weights are another multiple of them."""
        dice, twins = dice_of(22), Twins(self)
        for _ in range(some(200)):
            arrows, (given, objective) = [], ([], some_program(dice)[1])
            while len(arrows) < 4:
                px, py, qx, qy = (dice.randint(-3, 3) for _ in range(4))
                if (px, py) != (qx, qy):
                    arrows.append([hexadecimal(x) for x in (px, py, qx, qy)])
                    given.append((qy - py, px - qx, px * qy - py * qx))
            self.assertEqual(twins.look(file_of({"half_planes": arrows}, honest(given, objective))), "accepted")
        twins.compare()

    def look(self, given, top):
        """Whether a file is accepted; if so, it says what is true."""
        if self.twins.force(top) != "accepted":
            return False
        for statement in top["statements"]:
            said = tuple(64 * value(x) for x in statement["objective"])
            verdict, point, more = truth(given, tuple(map(int, said)))
            self.assertEqual(statement["verdict"], verdict, top)
            if verdict == "one":
                self.assertEqual(tuple(map(value, statement["point"])), point, top)
            if verdict == "many":
                ends = [end and tuple(map(value, end[0])) for end in statement["claims"][2]["ends"]]
                self.assertEqual(ends, more, top)
        return True

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, self.twins, accepted = dice_of(23), Twins(self), 0
        while lacking(FORCED, "linear_program"):
            given, objective = some_program(dice)
            true_one = honest(given, objective)
            for _ in range(2):
                accepted += self.look(given, spoilt_in_statements(file_about(given, true_one), dice))
            for verdict in lacking(FORCED, "linear_program"):
                accepted += self.look(given, file_about(given, forced_statement(given, objective, true_one, verdict, dice)))
        self.twins.compare()
        self.assertTrue(some(100) < 100 or accepted > self.twins.count / 50)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(24), Twins(self)
        while lacking(MUTANT, "linear_program"):
            given, objective = some_program(dice)
            top = file_about(given, honest(given, objective))
            if top["statements"][0]["verdict"] in lacking(MUTANT, "linear_program"):
                twins.spoil(top, dice)
        twins.compare()


if __name__ == "__main__":
    main()
