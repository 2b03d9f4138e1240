"""Which arcs bound the common part of discs: docs/claims.md, "Arcs".

All numbers are integers, or p + q sqrt(r) of them. A corner is where an arc of one circle ends and one of the next
begins: of the two points where they cross, that at which the way around the first, counter-clockwise, leaves the disc
of the second.
"""
from .linear import sign_of
from .reader import bits, projective, require
from .tables import around, dot, turn


class Way:
    """A direction even + odd sqrt(root)."""

    def __init__(self, even, odd, root):
        self.even, self.odd, self.root = even, odd, root
        x, y = (sign_of((p, q), root) for p, q in zip(even, odd))
        self.is_upper = (y or x) > 0  # its bearing is less than half a turn

    def turn_to(self, other):
        of_other = ((turn(self.even, way), turn(self.odd, way)) for way in (other.even, other.odd))
        return sign_of(tuple(of_other), self.root, other.root)

    def __lt__(self, other):
        """Is its bearing less, from 0 up to a full turn?"""
        return self.turn_to(other) > 0 if self.is_upper == other.is_upper else self.is_upper


class Corner:
    """With u from centre to centre it is (along u + sqrt(root) u turned left) / (2 square) from the centre of a."""

    def __init__(self, a, b):
        self.a, self.u = a, (b[0] - a[0], b[1] - a[1])
        self.square = self.u[0] ** 2 + self.u[1] ** 2
        self.along = self.square + a[2] ** 2 - b[2] ** 2
        self.root = 4 * a[2] ** 2 * self.square - self.along ** 2  # positive where the circles cross

    def seen_from(self, x, y, w):
        """The way from the point (x / w, y / w)."""
        (ux, uy), twice, along = self.u, 2 * self.square, self.along * w
        even = twice * (self.a[0] * w - x) + along * ux, twice * (self.a[1] * w - y) + along * uy
        return Way(even, (-uy * w, ux * w), self.root)

    def power(self, disc):
        """1: it is outside of the disc; 0: on its circle."""
        # The powers of a point for two discs differ by a linear function of it; that for the first disc is zero here.
        v = disc[0] - self.a[0], disc[1] - self.a[1]
        even = (dot(v, v) + self.a[2] ** 2 - disc[2] ** 2) * self.square - self.along * dot(self.u, v)
        return sign_of((even, turn(v, self.u)), self.root)


def is_within(c, d):
    """Does disc d hold disc c?"""
    return d[2] >= c[2] and (c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2 <= (d[2] - c[2]) ** 2


def furthest(c, d, place):
    """From the point (place), the way to the point of disc c that is furthest from the centre of d."""
    away, w = (c[0] - d[0], c[1] - d[1]), place[2]
    square = dot(away, away)
    return Way([square * (p * w - q) for p, q in zip(c[:2], place)], [c[2] * w * n for n in away], square)


class Chain:
    """Arcs of named discs, counter-clockwise around a point (place) inside of all discs, once round."""

    def __init__(self, steps, discs, named, place):
        self.discs, self.place = discs, place
        self.bits = 4 * discs.bits + 2 * bits(place)
        steps.take(6 * len(named), self.bits, self.bits)
        corners = [Corner(discs[a], discs[b]) for a, b in around(named)] if len(named) > 1 else []
        require(all(corner.root > 0 for corner in corners), "arcs", "circles do not cross in two points")
        ends = [(corner.seen_from(*place), corner) for corner in corners]
        starts = [m for m, end in enumerate(ends) if not ends[m - 1][0] < end[0]]  # past the bearing 0
        require(len(starts) == min(len(ends), 1), "arcs", "the corners do not go once around the point")
        first = sum(starts)
        self.ends, self.named = ends[first:] + ends[:first], named[first:] + named[:first]

    def require_within(self, steps, other):
        """Seen from the point, no arc is further than the other chain in that direction."""
        steps.take(6 * (len(self.ends) + len(other.ends) + 1), self.bits, self.bits)
        ends = sorted([(*end, 0) for end in self.ends] + [(*end, 1) for end in other.ends], key=lambda end: end[0])
        chains, at = (self, other), [0, 0]  # the arcs in the direction looked at
        for m, (way, corner, which) in enumerate(ends):
            c, d = (self.discs[chain.named[k % len(chain.named)]] for chain, k in zip(chains, at))
            if not is_within(c, d):
                last, far = ends[m - 1][0], furthest(c, d, self.place)
                is_between = last < far < way if m > 0 else last < far or far < way
                require(not is_between, "arcs", "an arc is not all in a circle")
            require(corner.power(c) >= 0 if which else corner.power(d) <= 0, "arcs", "a corner is not in a circle")
            at[which] += 1
        require(ends or is_within(*(self.discs[chain.named[0]] for chain in chains)), "arcs",
                "a circle does not hold another one")


def arcs(steps, parts, discs, point, named):
    """The arcs of the named discs, counter-clockwise, bound the common part; the point is inside of it."""
    place, parts = projective(point, discs.exponent), iter(parts)

    def chain_of(first, last, named):
        """What bounds the common part of a range of discs."""
        half = (first + last) // 2
        if last - first > 8:
            within = [chain_of(first, half, None), chain_of(half, last, None)]
        else:
            within = [Chain(steps, discs, [k], place) for k in range(first, last)]
        named = named or next(parts, None)
        require(named, "arcs", "there are not as many parts as there are ranges of discs")
        chain = Chain(steps, discs, named, place)
        for other in within:
            chain.require_within(steps, other)
        return chain
    chain_of(0, len(discs), named)
    require(next(parts, None) is None, "arcs", "there are more parts than ranges of discs")
