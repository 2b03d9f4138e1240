"""Bodies around boxes: as entries of a file, with claims about them, and what is true of them by the boxes."""
import itertools
from fractions import Fraction
from math import inf

from files import fraction, hexadecimal
from mesh_cells import box_gap, told_point
from test_mesh_distances import below
from test_rounds import root


def square(v):
    return sum(x * x for x in v)


def box_around(boxes):
    return [[min(low for low, _ in side), max(high for _, high in side)] for side in zip(*boxes)]


class Around:
    """What is within a radius of a box, which may be flat, or go on for ever; of a cylinder, across its axis."""

    def __init__(self, kind, box, radius, dice, step):
        self.kind, self.box, self.radius, self.dice, self.step = kind, box, radius, dice, step
        self.axis = next(c for c, (low, high) in enumerate(box) if low < high) if kind == "cylinder" else None
        ends = [[x for x in dict.fromkeys(side) if abs(x) < inf] for side in box]
        self.ends = [side or [step * dice.randint(-4, 4)] for side in ends]
        self.core = [*itertools.product(*self.ends)]
        dice.shuffle(self.core)
        self.ways = [(c, way) for c, side in enumerate(box) for x, way in zip(side, (-1, 1)) if abs(x) == inf]
        self.unit, self.moved = step * Fraction(2) ** dice.randint(-1, 1), [step * dice.randint(-2, 2) for _ in range(3)]
        self.is_image = dice.random() < .5

    def unplaced(self, p, moved):
        """Where it is in what this is an image of, if it is one: x, y, z there are y, z, x here."""
        x, y, z = [(x - t) / self.unit for x, t in zip(p, moved)]
        return [y, z, x] if self.is_image else p

    def entries(self):
        def shown(p):
            return [hexadecimal(Fraction(x)) for x in p]
        body = {"name": "b", "points": [shown(self.unplaced(p, self.moved)) for p in self.core]}
        if self.kind:
            body[self.kind] = hexadecimal(self.radius / (self.unit if self.is_image and self.kind == "ellipsoid" else 1))
        for c, way in self.ways:
            to = self.unplaced([way * self.step * (c == k) for k in range(3)], [0] * 3)
            body.setdefault("ways", []).append(shown(to) if self.dice.random() < .5 else shown(to) + shown(2 * x for x in to))
        turn = [hexadecimal(self.unit * n) for n in (0, 0, 1, 1, 0, 0, 0, 1, 0)]
        return [body, {"name": "i", "of": 0, "linear": turn, "translation": shown(self.moved)}] if self.is_image else [body]

    def of_core(self, p):
        """The nearest point of the core."""
        return [min(max(x, low), high) for x, (low, high) in zip(p, self.box)]

    def beyond_core(self, p):
        return [0 if c == self.axis else x - y for c, (x, y) in enumerate(zip(p, self.of_core(p)))]

    def has(self, p):
        is_level = self.axis is None or p[self.axis] == self.of_core(p)[self.axis]
        return is_level and square(self.beyond_core(p)) <= self.radius ** 2

    def toward(self, p):
        """A point of it that is as near to another one as any; or nearly, where roots are not rational."""
        way, share = self.beyond_core(p), Fraction(1)
        if square(way) > self.radius ** 2:
            share = self.radius ** 2 / square(way)
            share = below(share, Fraction(1)) if root(share) is None else root(share)
        return [y + share * x for x, y in zip(way, self.of_core(p))]

    def holds(self, point):
        """The claim, which is true if it has the point."""
        y, weights = self.of_core(point), []
        for k, corner in enumerate(self.core):
            weight = Fraction(1)
            for x, z, ends in zip(y, corner, self.ends):
                weight *= 1 if len(ends) == 1 else 1 - abs(x - z) / (ends[1] - ends[0])
            weights.append([k, fraction(weight)])
        far = [max(way * (y[c] - self.core[0][c]) / self.step, Fraction(0)) for c, way in self.ways]
        weights += [[k, fraction(x)] for k, x in enumerate(far, len(self.core))]
        given = {"from": told_point(self.unplaced(point, self.moved))} if self.kind == "ellipsoid" else {}
        return {"claim": "holds", "weights": weights, **given}

    def way_from(self, box, least):
        """A direction from a box along which it is that far away, or, of 0, apart; None: it is not; []: none is rational."""
        gaps, r = [box_gap(x, y) for x, y in zip(box, self.box)], self.radius
        along, out = (gaps[self.axis], self.beyond_axis(gaps)) if self.axis is not None else (0, gaps)
        across, rest = square(out), least ** 2 - along ** 2
        if along and rest <= 0:  # beyond an end of a cylinder
            return [x - y for x, y in zip(gaps, out)]
        if not along:
            return out if across >= (r + least) ** 2 and across > (0 if least else r * r) else None
        more = across - r * r - rest
        if across <= r * r or more < 0 or more ** 2 < 4 * r * r * rest:  # the root of across less r, against that of rest
            return None
        far = root(Fraction(across))
        return [x * (1 if c == self.axis else 1 - r / far) for c, x in enumerate(gaps)] if far else []

    def beyond_axis(self, gaps):
        return [0 if c == self.axis else x for c, x in enumerate(gaps)]
