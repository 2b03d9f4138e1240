#!/usr/bin/env python3
"""Tests of statements about bodies with a radius: python3 verifier/python/tests/test_rounds.py.

What is expected is found in another way than the checkers go: supports with 300 digits instead of squares, members by
the distance from an axis or a box instead of by weights, and points of the bodies that are tried one against the other.
"""
import decimal
import itertools
import operator
import unittest
from decimal import Decimal
from fractions import Fraction
from math import isqrt, lcm

from files import FORCED, MUTANT, TRIED, Twins, dice_of, file_of, fraction, main, some, spoilt_in_statements

decimal.getcontext().prec = 300
ZERO = Decimal(10) ** -200  # roots of the numbers here are no closer to each other
KINDS = ["radius", "cylinder", "cone", "ellipsoid", None]
TURNS = [(1, 0, 0, 0, 1, 0, 0, 0, 1), (0, 0, -1, 0, 1, 0, 1, 0, 0), (2, -1, 2, 2, 2, -1, -1, 2, 2), (2, 3, 6, 3, -6, 2, 6, 2, -3)]
WAYS = [(1, 0, 0), (0, 0, 1), (3, 4, 0), (0, 3, -4), (1, 2, 2), (3, 4, 5), (3, 4, 12), (-4, 3, 6), (2, 3, 6), (1, 1, 0), (1, 1, 1)]


def dot(u, v):
    return sum(map(operator.mul, u, v))


def less(u, v):
    return list(map(operator.sub, u, v))


def times(matrix, v):
    return [dot(matrix[r:r + 3], v) for r in (0, 3, 6)]


def double(x):
    x = Fraction(x)
    power = x.denominator.bit_length() - 1
    assert x.denominator == 1 << power
    return "%s0x%xp-%d" % ("-" if x < 0 else "", abs(x.numerator), power)


def value(text):
    """Of a number of a file; whole ones as such, which is faster."""
    if "x" not in text:
        result = Fraction(text)
    else:
        digits, power = text.split("p")
        whole, _, after = digits.replace("0x", "").partition(".")
        n, e = int(whole + after, 16), int(power) - 4 * len(after)
        result = n << e if e >= 0 else Fraction(n, 1 << -e)
    return int(result) if result.denominator == 1 else result


def decimal_of(x):
    return Decimal(x.numerator) / Decimal(x.denominator)


def root(x):
    """Of a fraction that is a square, else None."""
    p, q = isqrt(x.numerator), isqrt(x.denominator)
    return Fraction(p, q) if (p * p, q * q) == (x.numerator, x.denominator) else None


def rank(points):
    """The dimension of what they span: by the products of their ways."""
    ways = [less(p, points[0]) for p in points]
    if any(dot(u, cross(v, w)) for u, v, w in itertools.combinations(ways, 3)):
        return 3
    return 2 if any(any(cross(u, v)) for u, v in itertools.combinations(ways, 2)) else int(any(map(any, ways)))


class Body:
    """A body of a file: placed core, kind and radius, as fractions."""

    def __init__(self, tables, k):
        item = tables[k]
        own = tables[item["of"]] if "of" in item else item
        self.given = [[value(x) for x in p] for p in own["points"]]
        self.linear = [value(x) for x in item["linear"]] if "of" in item else TURNS[0]
        self.moved = [value(x) for x in item["translation"]] if "of" in item else [0] * 3
        self.core = [[x + t for x, t in zip(times(self.linear, p), self.moved)] for p in self.given]
        self.kind = next((kind for kind in KINDS[:4] if kind in own), None)
        self.radius = value(own[self.kind]) if self.kind else 0
        self.axis = less(self.core[1], self.core[0]) if self.kind in ("cylinder", "cone") else None

    def square(self, d):
        """Of the length of that part of a direction along which it reaches out from its core."""
        if self.kind == "ellipsoid":
            return sum(dot(self.linear[c::3], d) ** 2 for c in range(3))
        return dot(d, d) - (Fraction(dot(d, self.axis) ** 2) / dot(self.axis, self.axis) if self.axis else 0)

    def support(self, d):
        reach = decimal_of(self.radius) * decimal_of(Fraction(self.square(d))).sqrt()
        far = [decimal_of(Fraction(dot(d, p))) for p in self.core]
        return max(far[0] + reach, far[1]) if self.kind == "cone" else max(far) + reach

    def is_flat(self, d):
        return abs(self.support(d) + self.support([-x for x in d])) < ZERO

    def made(self, claim, point):
        """Do the weights of a claim make a point of the body; and is it in the relative interior, by these weights?"""
        weights = {k: value(w) for k, w in claim["weights"]}
        if min(weights.values()) < 0 or sum(weights.values()) != 1:
            return False, False
        if self.kind == "ellipsoid":
            v = [value(x) for x in claim["from"]]
            out, reach = less(v, self.given[0]), self.radius
            is_there = [x + t for x, t in zip(times(self.linear, v), self.moved)] == point
        else:
            y = [sum(w * self.core[k][axis] for k, w in weights.items()) for axis in range(3)]
            out, is_there = less(point, y), not self.axis or dot(less(point, y), self.axis) == 0
            reach = self.radius * weights.get(0, 0) if self.kind == "cone" else self.radius
        holds = is_there and dot(out, out) <= reach ** 2
        if self.radius == 0 or not self.kind:
            inside = rank([self.given[k] for k, w in weights.items() if w > 0]) == rank(self.given)
        else:
            inside = dot(out, out) < reach ** 2 and (not self.axis or min(weights.get(0, 0), weights.get(1, 0)) > 0)
        return holds, holds and inside

    def within(self, x):
        """-1: outside; 0: on the boundary; 1: inside, as seen in its span if the radius is zero. None: not known. By no
        weights."""
        r, sign = self.radius ** 2, lambda n: (n > 0) - (n < 0)
        if self.kind == "ellipsoid":
            a, b, c = self.linear[::3], self.linear[1::3], self.linear[2::3]
            whole = dot(a, cross(b, c))
            if not whole:
                return None
            y = less(x, self.moved)
            v = [Fraction(n) / whole for n in (dot(y, cross(b, c)), dot(a, cross(y, c)), dot(a, cross(b, y)))]
            out = less(v, self.given[0])
            return sign(r - dot(out, out)) if r else 1 if not any(out) else -1
        if self.axis:
            t = Fraction(dot(less(x, self.core[0]), self.axis)) / dot(self.axis, self.axis)
            out = [p - q - t * a for p, q, a in zip(x, self.core[0], self.axis)]
            ends = min(sign(t), sign(1 - t))
            reach = r * (1 - t) ** 2 if self.kind == "cone" else r
            if not r:
                return ends if not any(out) else -1
            return min(ends, sign(reach - dot(out, out))) if reach or ends else 0 if not any(out) and ends == 0 else -1
        if len(self.core) == 2 and self.core[0] != self.core[1]:
            a = less(self.core[1], self.core[0])
            t = min(max(Fraction(dot(less(x, self.core[0]), a)) / dot(a, a), 0), 1)
            near, ends = [q + t * n for q, n in zip(self.core[0], a)], min(sign(t), sign(1 - t))
        elif {tuple(p) for p in self.core} == set(itertools.product(*({p[axis] for p in self.core} for axis in range(3)))):
            spans = [(min(p[axis] for p in self.core), max(p[axis] for p in self.core)) for axis in range(3)]
            near = [min(max(n, low), high) for n, (low, high) in zip(x, spans)]
            ends = min(sign(n - low) * sign(high - n) if low < high else 1 for n, (low, high) in zip(near, spans))
        else:
            return None
        out = less(x, near)
        return sign(r - dot(out, out)) if r else ends if not any(out) else -1

    def points(self, dice):
        """Some of it, by its definition."""
        for _ in range(7):
            parts = [dice.choice([0, 0, 1, 3]) for _ in self.core]
            parts[dice.randrange(len(parts))] += 1
            weights = [Fraction(n, sum(parts)) for n in parts]
            v = [dice.randint(-9, 9) for _ in range(3)]
            if self.axis:
                v = cross(v, self.axis)
            length = isqrt(int(dot(v, v)) * 10 ** 12) + 1  # not less than the length times 10^6
            reach = Fraction(self.radius * 10 ** 6, length) * (weights[0] if self.kind == "cone" else 1)
            v = [reach * Fraction(n) for n in v]
            y = [sum(w * p[axis] for w, p in zip(weights, self.core)) for axis in range(3)]
            yield [p + q for p, q in zip(y, times(self.linear, v) if self.kind == "ellipsoid" else v)]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def expected(top):
    """Is the last statement, whose form is right, what its claims prove?"""
    one = top["statements"][-1]
    a, b = (Body(top["tables"]["bodies"], one[key]) for key in "ab")
    claims = {claim["claim"]: claim for claim in one["claims"]}
    point = {key: [value(x) for x in one[key]] for key in ("point", "from_a", "to_b") if key in one}
    made = []
    for body, key, claim in zip((a, b), (("point", "point") if "point" in one else ("from_a", "to_b")), one["claims"]):
        if "weights" in claim:
            made.append(body.made(claim, point[key])[claim["claim"] == "inside"])
    for claim in claims.values():
        if "direction" in claim:
            d = [value(x) for x in claim["direction"]]
            least = decimal_of(value(one.get("least", "0"))) * decimal_of(dot(d, d)).sqrt()
            gap = -b.support([-x for x in d]) - a.support(d) - least
            weak = claim["claim"] != "parted"
            made.append(any(d) and (gap > ZERO or (weak and abs(gap) < ZERO and not (
                claim["claim"] == "parted_weakly" and a.is_flat(d) and b.is_flat(d)))))
        elif claim["claim"] == "nearer":
            way = less(point["to_b"], point["from_a"])
            made.append(dot(way, way) < value(one["least"]) ** 2)
    return all(made)


def is_so(top, dice):
    """Nothing that can be seen of the bodies themselves is against an accepted statement."""
    one = top["statements"][-1]
    a, b = (Body(top["tables"]["bodies"], one[key]) for key in "ab")
    verdict = one["verdict"]
    where = [a.within([value(x) for x in one[key]]) for a, key in
             ((a, "point"), (b, "point"), (a, "from_a"), (b, "to_b")) if key in one]
    known = [k for k in where if k is not None]
    if any(k < 0 for k in known) or (verdict == "overlapping" and any(k < 1 for k in known)):
        return False
    if verdict in ("apart", "kept", "touching"):
        d = next([value(x) for x in claim["direction"]] for claim in one["claims"] if "direction" in claim)
        points = [list(body.points(dice)) for body in (a, b)]
        scale = lcm(*(x.denominator for x in itertools.chain(d, *points[0], *points[1])))  # whole numbers are faster
        d, points = [int(scale * x) for x in d], [[[int(scale * x) for x in p] for p in those] for those in points]
        least = (scale * value(one["least"])) ** 2 if verdict == "kept" else 0
        for x, y in itertools.product(*points):
            way = less(y, x)
            if dot(way, d) < 0 or dot(way, way) < least or (verdict == "apart" and dot(way, d) == 0):
                return False
    return True


# ---- Bodies that touch, as far apart as is wanted, or with a common point.

def some_body(dice, kind):
    """An entry of the table, with small numbers, and the matrix and radius that go with it."""
    size = {"cylinder": 2, "cone": 2, "ellipsoid": 1}.get(kind) or dice.choice([1, 2, 8])
    core = [[dice.randint(-3, 3) for _ in range(3)]]
    if size == 2:
        core.append([p + q for p, q in zip(core[0], dice.choice([(0, 0, 2), (0, 0, -5), (0, 0, 12), (3, 4, 0), (1, 2, 2)]))])
    if size == 8:
        core = [list(p) for p in itertools.product(*((p, p + dice.choice([0, 1, 2])) for p in core[0]))]
    linear = list(dice.choice(TURNS[:2] if size == 8 else TURNS))
    if kind == "ellipsoid":
        scale = [dice.choice([0, 1, 1, 2, 3, Fraction(1, 2)]) for _ in range(3)]
        linear = [n * scale[k % 3] for k, n in enumerate(linear)]
    radius = dice.choice([0, 1, 5, 15, 105, 105]) if kind else 0
    item = {"name": "body", "points": [list(map(double, p)) for p in core]}
    if kind:
        item[kind] = double(radius)
    return item, linear


def put(entries, item, linear, translation):
    """As an entry and its image, or as one entry if it is where it is; returns its index."""
    entries.append(item)
    if linear == list(TURNS[0]) and not any(translation):
        return len(entries) - 1
    entries.append({"name": "placed", "of": len(entries) - 1, "linear": list(map(double, linear)),
                    "translation": list(map(double, translation))})
    return len(entries) - 1


def placed(item, linear, translation):
    entries = []
    return Body(entries, put(entries, item, linear, translation))


def furthest(body, d, dice):
    """A point that is as far along d as any of the body, and the claim for it; body.square(d) is a square."""
    length = root(Fraction(body.square(d)))
    far = [dot(d, p) for p in body.core]
    if body.kind == "cone":
        far[0] += body.radius * length
    ends = [k for k, n in enumerate(far) if n == max(far)]
    weights = {k: 1 for k in dice.sample(ends, dice.randint(1, len(ends)))}
    out = [0] * 3
    if length and body.radius:
        across = [sum(m * x for m, x in zip(body.linear[c::3], d)) for c in range(3)] if body.kind == "ellipsoid" else d
        if body.axis:
            along = Fraction(dot(d, body.axis)) / dot(body.axis, body.axis)
            across = [x - along * n for x, n in zip(d, body.axis)]
        out = [body.radius * Fraction(x) / length for x in across]
    total = sum(weights.values())
    claim = {"claim": "holds", "weights": [[k, fraction(Fraction(w, total))] for k, w in weights.items()]}
    if body.kind == "ellipsoid":
        v = [p + q for p, q in zip(body.given[0], out)]
        claim["from"] = list(map(fraction, v))
        return [p + t for p, t in zip(times(body.linear, v), body.moved)], claim
    share = Fraction(weights.get(0, 0), total) if body.kind == "cone" else 1
    return [sum(Fraction(w, total) * body.core[k][axis] for k, w in weights.items()) + share * out[axis]
            for axis in range(3)], claim


def is_double(v):
    return all(x.denominator & (x.denominator - 1) == 0 for x in v)


def some_touch(dice, kinds):
    """Two bodies that touch, where they do, and a direction from one to the other: entries of the second to be moved."""
    while True:
        (item_a, turn_a), (item_b, turn_b) = (some_body(dice, kind) for kind in kinds)
        shift = [dice.choice([0, dice.randint(-4, 4)])] * 3
        a, b = placed(item_a, turn_a, shift), placed(item_b, turn_b, [0] * 3)
        for way in dice.sample(WAYS, len(WAYS)):
            d = times(dice.choice((TURNS[0], turn_a)), way)
            if any(d) and all(root(Fraction(body.square(d))) is not None for body in (a, b)):
                (x, claim_a), (y, claim_b) = furthest(a, d, dice), furthest(b, [-x for x in d], dice)
                if is_double(less(x, y)):
                    return (item_a, turn_a, shift), (item_b, turn_b, less(x, y)), d, x, [claim_a, claim_b]


def statement_of(verdict, first, second, claims, **more):
    entries = []
    a = put(entries, *first)
    b = put(entries, *second)
    question = "clearance" if "least" in more else "pair"
    return file_of({"bodies": entries}, {"question": question, "a": a, "b": b, "verdict": verdict, **more, "claims": claims})


def some_apart(dice, kinds):
    """Statements about what is along a direction: true ones, some only just, and such as are not, some only just."""
    first, second, d, x, claims = some_touch(dice, kinds)
    length = root(Fraction(dot(d, d)))
    times_it = dice.choice([1, Fraction(2, 3), Fraction(2 ** 40)])
    direction = [fraction(times_it * n) for n in d]
    little = dice.choice([1, Fraction(1, 2), Fraction(1, 2 ** 40), 0, 0, 0, Fraction(-1, 2 ** 40), -1, -40, -200])
    axis = max(range(3), key=lambda k: abs(d[k]))
    moved = list(second[2])
    moved[axis] += little if d[axis] > 0 else -little
    second = (*second[:2], moved)
    verdict = dice.choice(["apart", "touching", "kept"])
    if verdict == "apart":
        return statement_of("apart", first, second, [{"claim": "parted", "direction": direction}])
    if verdict == "touching":
        claims = claims + [{"claim": "parted_weakly", "direction": direction}]
        return statement_of("touching", first, second, claims, point=list(map(fraction, x)))
    least = dice.choice([1, 15, 105])
    if length:
        by = [n * least / Fraction(length) for n in d]
        if is_double(by):
            second = (*second[:2], [p + q for p, q in zip(second[2], by)])
    return statement_of("kept", first, second, [{"claim": "clear", "direction": direction}], least=double(least))


def some_point(dice, kind):
    """A body, a point of it, mostly on its boundary or near it, and the claim for it."""
    item, linear = some_body(dice, kind)
    body = placed(item, linear, [0] * 3)
    parts = [dice.choice([0, 1, 2, 4]) for _ in body.core]
    parts[dice.randrange(len(parts))] += 1
    total = 1 << (sum(parts) - 1).bit_length()
    parts[parts.index(max(parts))] += total - sum(parts)
    weights = [Fraction(n, total) for n in parts]
    reach = body.radius * (weights[0] if body.kind == "cone" else 1)
    ways = [(1, 0, 0), (0, 0, 1), (3, 4, 0), (0, -3, 4), (1, 2, 2), (2, 3, 6), (0, 0, 0)]
    ways += [tuple(times(turn, way)) for turn in TURNS for way in ways]
    if body.axis and dice.random() < .95:
        ways = [way for way in ways if dot(way, body.axis) == 0]
    out = dice.choice(ways)
    length = root(Fraction(dot(out, out))) or 1
    share = dice.choice([1, 1, 1, 1, Fraction(1, 2), 1 - Fraction(1, 2 ** 40), 1 + Fraction(1, 2 ** 40), 0])
    out = [share * reach * Fraction(n) / length for n in out]
    written = dice.choice((fraction, double))
    claim = {"claim": "holds", "weights": [[k, written(w)] for k, w in enumerate(weights) if w or dice.random() < .5]}
    if body.kind == "ellipsoid":
        v = [p + q for p, q in zip(body.given[0], out)]
        claim["from"] = list(map(fraction, v))
        return (item, linear), times(body.linear, v), claim
    y = [sum(w * p[axis] for w, p in zip(weights, body.core)) for axis in range(3)]
    return (item, linear), [p + q for p, q in zip(y, out)], claim


def some_common(dice, kinds):
    """Statements about a point of both, or about points of each that are near."""
    while True:
        (first, x, claim_a), (second, y, claim_b) = (some_point(dice, kind) for kind in kinds)
        verdict = dice.choice(["meet", "overlapping", "broken"])
        by = [dice.choice([0, 1, 3, 4]) for _ in x] if verdict == "broken" else [0] * 3
        moved = [p + t - q for p, q, t in zip(x, y, by)]
        if len(claim_a["weights"]) > 16 or len(claim_b["weights"]) > 16 or not is_double(moved):
            continue
        first, second, there = (*first, [0] * 3), (*second, moved), list(map(fraction, [p + q for p, q in zip(y, moved)]))
        if verdict == "broken":
            return statement_of("broken", first, second, [claim_a, claim_b, {"claim": "nearer"}], least=double(5),
                                from_a=list(map(fraction, x)), to_b=there)
        if verdict == "overlapping":
            claim_a, claim_b = ({**claim, "claim": "inside"} for claim in (claim_a, claim_b))
        return statement_of(verdict, first, second, [claim_a, claim_b], point=there)


PAIRS = [pair for pair in itertools.product(KINDS, KINDS) if any(pair)]


class RoundsTest(unittest.TestCase):
    def force(self, make, count):
        dice, twins, true = dice_of(count), Twins(self), {pair: [0, 0] for pair in PAIRS}
        for k in range(some(count)):
            pair = PAIRS[k % len(PAIRS)]
            top = make(dice, pair)
            is_true = expected(top)
            said = twins.force(top)
            self.assertEqual(said == "accepted", is_true, (said, top))
            self.assertNotEqual(said, "F", top)
            self.assertTrue(not is_true or is_so(top, dice), top)
            true[pair][is_true] += 1
        twins.compare()
        if some(count) >= count:
            self.assertGreater(min(map(min, true.values())), count // 400, true)

    def test_along_a_direction(self):
        self.force(some_apart, 2400)

    def test_by_points(self):
        self.force(some_common, 2400)

    def test_spoilt_ones_are_refused_or_true(self):
        dice, twins, seen = dice_of(3), Twins(self), 0
        for k in range(some(2000)):
            top = (some_apart, some_common)[k % 2](dice, PAIRS[k // 2 % len(PAIRS)])
            key = top["statements"][-1]["question"], top["statements"][-1]["verdict"]
            TRIED[MUTANT][key] += 1
            twins.spoil(top, dice)
            changed = spoilt_in_statements(top, dice)
            said = twins.look(changed)
            if said not in ("F", "not checked"):
                seen += 1
                self.assertEqual(said == "accepted", expected(changed), changed)
                self.assertTrue(said != "accepted" or is_so(changed, dice), changed)
        twins.compare()
        self.assertGreater(seen, some(2000) // 8)

    def test_three_roots(self):
        """Balls of squared radii and a clearance: sums of roots that are equal, and one in the last place."""
        twins = Twins(self)
        for d in ((1, 0, 0), (1, 1, 0), (1, 1, 1), (-2, 5, 1)):
            for r, s, least in itertools.product((0, 1, 2), (0, 3, 1), (1, 5)):
                for little in (-1, 0, 1):
                    # Each along d by its radius in units of the length of d, which is a root: a gap of as many of these.
                    at = [(r + s + least) * n for n in d]
                    bodies = [{"name": "a", "points": [["0x0p+0"] * 3], "radius": double(r)},
                              {"name": "b", "points": [list(map(double, at))], "radius": double(s)}]
                    square = dot(d, d)
                    # Of radii r: the gap is (r + s + least) d d, the roots r sqrt(d d), ..: more, if d d > 1.
                    wide = double(Fraction(least) + Fraction(little, 2 ** 40)) if square == 1 else double(least)
                    one = {"question": "clearance", "a": 0, "b": 1, "least": wide, "verdict": "kept",
                           "claims": [{"claim": "clear", "direction": list(map(str, d))}]}
                    top = file_of({"bodies": bodies}, one)
                    self.assertEqual(twins.look(top), "accepted" if expected(top) else "clear", top)
                    self.assertEqual(expected(top), square > 1 or little <= 0)
        twins.compare()

    def test_form(self):
        twins, ball = Twins(self), {"name": "x", "points": [["0x0p+0"] * 3], "radius": "0x1p+0"}
        point = {"name": "y", "points": [["0x1p+1", "0x0p+0", "0x0p+0"]]}
        two = {"name": "x", "points": [["0x0p+0"] * 3, ["0x0p+0", "0x1p+0", "0x0p+0"]]}
        apart = {"question": "pair", "a": 0, "b": 1, "verdict": "apart",
                 "claims": [{"claim": "parted", "direction": ["1", "0", "0"]}]}
        good = [ball, {**ball, "ways": []}, {**ball, "radius": "-0x0p+0"}, {**two, "cylinder": "0x1p+0"},
                {**two, "cone": "0x0p+0"}, {**two, "radius": "0x1p-1074"}, {**point, "points": [["0x0p+0"] * 3], "ellipsoid": "0x1p+0"}]
        bad = [{**ball, "radius": "1"}, {**ball, "radius": "-0x1p+0"}, {**ball, "radius": None}, {**ball, "radius": 1},
               {**ball, "radius": "0x1p+1024"}, {**ball, "cone": "0x1p+0"}, {**two, "ellipsoid": "0x1p+0"},
               {**two, "cone": "0x1p+0", "cylinder": "0x1p+0"}, {"name": "x", "points": ball["points"], "cylinder": "0x1p+0"},
               {"name": "x", "points": two["points"][:1] * 2, "cylinder": "0x1p+0"},
               {"name": "x", "points": two["points"][:1] * 2, "cone": "0x1p+0"},
               {"name": "x", "points": two["points"] + two["points"][:1], "cone": "0x1p+0"},
               {**ball, "ways": [["0x0p+0"] * 3]}, {**ball, "sphere": "0x1p+0"}]
        for item in good:
            self.assertEqual(twins.look(file_of({"bodies": [item, point]}, apart)), "accepted", item)
        for item in bad:
            self.assertEqual(twins.look(file_of({"bodies": [item, point]}, apart)), "F", item)
        flat = {"name": "x", "points": [["0x0p+0"] * 2], "radius": "0x1p+0"}
        self.assertEqual(twins.look(file_of({"bodies": [flat, point], "segments": []}, apart)), "F")
        identity = [double(n) for n in TURNS[0]]
        for linear, said in ((identity, "accepted"), (["0x0p+0"] * 4 + identity[4:], "accepted"), (["0x0p+0"] * 9, "F")):
            image = {"name": "i", "of": 0, "linear": linear, "translation": ["0x0p+0"] * 3}
            for kind in ("cylinder", "cone"):
                top = file_of({"bodies": [{**two, kind: "0x1p+0"}, point, image]}, {**apart, "a": 2})
                self.assertEqual(twins.look(top), said, top)
        away = {"name": "z", "points": [["0x1p+2", "0x0p+0", "0x0p+0"]]}
        holds = [{"claim": "holds", "weights": [[0, "1"]]}] * 2
        claims = [*holds, {"claim": "slab"}]
        distance = {"question": "distance", "a": 0, "b": 1, "verdict": "closest", "from_a": ["0"] * 3,
                    "to_b": ["4", "0", "0"], "claims": claims}
        hull = {"question": "hull", "body": 0, "verdict": "point", "claims": [{"claim": "one_point"}]}
        section = {"question": "section", "of": 0, "plane": ["0x1p+0"] * 7, "verdict": "nothing", "claims": [{"claim": "beyond"}]}
        plain = {"name": "x", "points": ball["points"]}
        image = {"name": "i", "of": 1, "linear": identity, "translation": ["0x0p+0"] * 3}
        for one in (distance, hull, section):
            self.assertEqual(twins.look(file_of({"bodies": [plain, away]}, one)), "accepted", one)
            self.assertEqual(twins.look(file_of({"bodies": [{**plain, "radius": "0x0p+0"}, away]}, one)), "F", one)
        self.assertEqual(twins.look(file_of({"bodies": [plain, {**away, "radius": "0x0p+0"}]}, distance)), "F")
        self.assertEqual(twins.look(file_of({"bodies": [plain, {**away, "radius": "0x0p+0"}, image]}, {**distance, "b": 2})), "F")
        meet = {"question": "pair", "a": 0, "b": 1, "verdict": "meet", "point": ["0"] * 3, "claims": holds}
        origin = {**holds[0], "from": ["0"] * 3}
        ellipsoid = {**plain, "ellipsoid": "0x0p+0"}
        for bodies, claims, said in (
                ([ball, plain], holds, "accepted"), ([ball, plain], [origin, holds[1]], "F"),
                ([plain, plain], [origin, holds[1]], "F"), ([ellipsoid, plain], holds, "F"),
                ([ellipsoid, plain], [origin, holds[1]], "accepted"), ([plain, ellipsoid], [origin, holds[1]], "F"),
                ([ellipsoid, ellipsoid], [origin, origin], "accepted"),
                ([ellipsoid, plain], [{**origin, "from": ["0"] * 2}, holds[1]], "F")):
            self.assertEqual(twins.look(file_of({"bodies": bodies}, {**meet, "claims": claims})), said, (bodies, claims))
        twins.compare()

    def test_sentences(self):
        twins, apart = Twins(self), {"question": "pair", "a": 0, "b": 1, "verdict": "apart",
                                     "claims": [{"claim": "parted", "direction": ["1", "0", "0"]}]}
        point = {"name": "p", "points": [["0x1p+4", "0x0p+0", "0x0p+0"]]}
        core = [["0x0p+0"] * 3, ["0x0p+0", "0x1p+0", "0x0p+0"], ["0x0p+0", "0x0p+0", "0x1p+0"]]
        from files import told
        import json
        for size, kind, word in (
                (1, "radius", "ball of radius 0x1p+0 of the 1 point"), (2, "radius", "capsule of radius 0x1p+0 of the 2 points"),
                (3, "radius", "rounded hull of radius 0x1p+0 of the 3 points"), (2, "cone", "cone of radius 0x1p+0 of the 2 points"),
                (2, "cylinder", "cylinder of radius 0x1p+0 of the 2 points"), (3, "", "convex hull of the 3 points"),
                (1, "ellipsoid", "ball of radius 0x1p+0 of the 1 point")):
            item = {"name": "x", "points": core[:size], **({kind: "0x1p+0"} if kind else {})}
            top = file_of({"bodies": [item, point]}, apart)
            self.assertEqual(told(json.dumps(top)), (
                "accepted", ['the %s of "x" and the convex hull of the 1 point of "p" are apart' % word]))
            twins.look(top)
        twins.compare()


if __name__ == "__main__":
    main()
