"""Checks which arcs bound the common part of discs: a part of sunder_verify_circles.py.

The format and the checks are those of docs/certificates-sets.md, "circles", B1 to B4; no code is shared with the
library.
All numbers are integers. A corner is where an arc of one circle ends and one of the next begins: of the two points where
they cross, that at which the way around the first leaves the disc of the second.
"""
from sunder_verify import require


def sign(n):
    return (n > 0) - (n < 0)


def sign_of_root(p, q, r):
    """The sign of p + q sqrt(r)."""
    a, b = sign(p), sign(q) if r else 0
    return (a or b) if a * b >= 0 else a * sign(p * p - q * q * r)


def sign_of_roots(p, q, r, s, u, t):
    """The sign of p + q sqrt(r) + (s + u sqrt(r)) sqrt(t)."""
    a, b = sign_of_root(p, q, r), sign_of_root(s, u, r) if t else 0
    if a * b >= 0:
        return a or b
    return a * sign_of_root(p * p + q * q * r - t * (s * s + u * u * r), 2 * (p * q - t * s * u), r)


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


class Way:
    """A direction, as a vector with square roots: even + odd sqrt(root)."""

    def __init__(self, even, odd, root):
        self.even, self.odd, self.root = even, odd, root

    def turn(self, w):
        """The sign of the cross product with a vector of integers."""
        return sign_of_root(cross(self.even, w), cross(self.odd, w), self.root)

    def turn_to(self, other):
        return sign_of_roots(cross(self.even, other.even), cross(self.odd, other.even), self.root,
                             cross(self.even, other.odd), cross(self.odd, other.odd), other.root)

    def is_upper(self):
        """Is its bearing less than half a turn?"""
        y = sign_of_root(self.even[1], self.odd[1], self.root)
        return y > 0 or (y == 0 and sign_of_root(self.even[0], self.odd[0], self.root) > 0)


class Corner:
    """With u from centre to centre it is (along u + sqrt(root) u turned left) / (2 distance_squared) from that of a."""

    def __init__(self, a, b):
        self.a, self.b = a, b
        self.ux, self.uy = b[0] - a[0], b[1] - a[1]
        self.distance_squared = self.ux * self.ux + self.uy * self.uy
        self.along = self.distance_squared + a[2] * a[2] - b[2] * b[2]
        self.root = 4 * a[2] * a[2] * self.distance_squared - self.along * self.along  # positive where the circles cross

    def seen_from(self, x, y, unit=1):
        """The way from a point, in a unit of which `unit` make one of the discs."""
        twice = 2 * self.distance_squared
        return Way((twice * (self.a[0] * unit - x) + self.along * self.ux * unit,
                    twice * (self.a[1] * unit - y) + self.along * self.uy * unit),
                   (-self.uy * unit, self.ux * unit), self.root)

    def is_in(self, disc):
        # The powers of a point for two discs differ by a linear function of it; that for the first disc is zero here.
        vx, vy = disc[0] - self.a[0], disc[1] - self.a[1]
        even = (vx * vx + vy * vy + self.a[2] * self.a[2] - disc[2] * disc[2]) * self.distance_squared \
            - self.along * (self.ux * vx + self.uy * vy)
        return sign_of_root(even, self.uy * vx - self.ux * vy, self.root) <= 0


def holds(outer, inner):
    dx, dy, dr = outer[0] - inner[0], outer[1] - inner[1], outer[2] - inner[2]
    return dr >= 0 and dx * dx + dy * dy <= dr * dr


def is_between(w, begin, end, turn):
    """Is a vector inside of the angle from one way counter-clockwise to another, to which the first turns as said?"""
    if turn > 0:
        return begin.turn(w) > 0 and end.turn(w) < 0
    if turn < 0:
        return begin.turn(w) > 0 or end.turn(w) < 0
    return begin.turn(w) > 0


def go_round_once(ways):
    """Do these ways from one point go once around it, each a bit further than the one before?"""
    rounds = 0
    for before, way in zip([ways[-1]] + ways, ways):
        was_upper, is_upper = before.is_upper(), way.is_upper()
        # Past the bearing 0, if not forward within one half.
        rounds += before.turn_to(way) <= 0 if was_upper == is_upper else is_upper
    return rounds == 1


def check_arcs(discs, arcs, x, y, unit):
    """x, y: a point inside of all discs, in a unit of which `unit` make one of the discs."""
    if len(arcs) == 1:
        for k, disc in enumerate(discs):
            require(holds(disc, discs[arcs[0]]), "B1", "circle %d does not hold circle %d" % (k, arcs[0]))
        return
    after = arcs[1:] + arcs[:1]
    corners = [Corner(discs[a], discs[b]) for a, b in zip(arcs, after)]
    for a, b, corner in zip(arcs, after, corners):
        require(corner.root > 0, "B1", "circles %d and %d do not cross in two points" % (a, b))
    require(go_round_once([corner.seen_from(x, y, unit) for corner in corners]), "B2",
            "the corners do not go once around the point")
    for m, (a, corner) in enumerate(zip(arcs, corners)):
        circle = discs[a]
        begin, end = (c.seen_from(circle[0], circle[1]) for c in (corners[m - 1], corner))
        turn = begin.turn_to(end)
        for k, disc in enumerate(discs):
            require(corner.is_in(disc), "B3", "the end of arc %d is not in circle %d" % (m, k))
            away = circle[0] - disc[0], circle[1] - disc[1]
            require(not is_between(away, begin, end, turn) or holds(disc, circle), "B4",
                    "arc %d is not all in circle %d" % (m, k))
