"""Checks statements about sets of segments: a part of sunder_verify_sets.py.

The format and the checks C1-C3 and T1-T6 are those of docs/certificates.md, "Sets"; no code is shared with the library.
All coordinates are integers here: multiples of one power of two, which all comparisons may leave out. Where a file has
no groups, each segment has one of its own, with its index for a number.
"""
from sunder_verify import Refused, bits, common, double, index, length, member, number, numbers, require, steps

ALLOWED = {  # which kinds of contact do not count
    "nothing": (),
    "shared-endpoint": ("shared-endpoint",),
    "touch": ("shared-endpoint", "touch"),
}
KINDS = ("shared-endpoint", "touch", "crossing", "overlap")
EXCHANGE = -1  # the event
MOST_IN_GROUP_NUMBER = 10 ** 15 - 1  # all JSON readers agree about whole numbers up to this, either sign


def turn(p, q, r):
    """Positive: p, q, r turn left."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def kind_of(s, t):
    """How two segments meet: one of KINDS, or None. A segment is a pair of points, the lesser one first."""
    (a, b), (c, d) = s, t
    c_side, d_side, a_side, b_side = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
    if c_side == d_side == a_side == b_side == 0:  # on one line, where the order of points is the order along it
        first, last = max(a, c), min(b, d)
        if first > last:
            return None
        if first < last:
            return "overlap"
        return "shared-endpoint" if first in s and first in t else "touch"
    if c_side * d_side > 0 or a_side * b_side > 0:
        return None
    if c_side * d_side < 0 and a_side * b_side < 0:
        return "crossing"
    return "shared-endpoint" if a in t or b in t else "touch"


def crossing_of(s, t):
    """The common point of two segments that cross, as x, y, w with w > 0: the point x / w, y / w."""
    (a, b), (c, d) = s, t
    ux, uy, vx, vy, wx, wy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1], c[0] - a[0], c[1] - a[1]
    across, along = ux * vy - uy * vx, wx * vy - wy * vx
    if across < 0:
        across, along = -across, -along
    return a[0] * across + ux * along, a[1] * across + uy * along, across


def order(p, q):
    """Negative where p is lexicographically before q, zero where they are one point; both as x, y, w."""
    return p[0] * q[2] - q[0] * p[2] or p[1] * q[2] - q[1] * p[2]


def is_above(s, t, is_one_group):
    """Is s, just after it begins, above t, which has begun? A segment of length zero is above those that it lies on.
    Where both are on one line, s is above t if they are of one group."""
    side = turn(t[0], t[1], s[0])
    if side or s[0] == s[1]:
        return side >= 0
    direction = turn(t[0], t[1], s[1])
    return direction > 0 or (direction == 0 and is_one_group)


def cross_further_on(lower, upper):
    """Do two segments, the upper one above the lower before they meet, cross? Then the one that ends first does so on
    the wrong side of the other."""
    if lower[1] < upper[1]:
        is_wrong = turn(upper[0], upper[1], lower[1]) > 0
    else:
        is_wrong = turn(lower[0], lower[1], upper[1]) < 0
    return is_wrong and kind_of(lower, upper) == "crossing"


def check_some(segments, greatest, groups, exponent, allowed, i, j, kind, point):
    steps.take(16, length(*point), greatest)
    require(kind not in ALLOWED[allowed], "C1", "%s does not count where %s is allowed" % (kind, allowed))
    require(groups[i] != groups[j], "C1", "segments %d and %d are of one group" % (i, j))
    (px, dx, ex), (py, dy, ey) = point
    low = min(ex, ey, exponent)
    unit = dx * dy << (exponent - low)  # one unit of the coordinates
    for k in (i, j):
        a, b = segments[k]
        # p - a, times dx * dy * 2^-low: integers.
        ux = (px * dy << (ex - low)) - (a[0] * unit)
        uy = (py * dx << (ey - low)) - (a[1] * unit)
        vx, vy = b[0] - a[0], b[1] - a[1]
        inner = ux * vx + uy * vy
        require(ux * vy == uy * vx and 0 <= inner <= (vx * vx + vy * vy) * unit and
                (vx or vy or not (ux or uy)), "C2", "the point is not on segment %d" % k)
    found = kind_of(segments[i], segments[j])
    require(found == kind, "C3", "the contact is %s" % (found or "none"))


def places_of(segments, groups, allowed, events, exchanges):
    """The point of each event, as x, y, w. Checks T1, and of T5 what needs no list."""
    size = len(segments)
    greatest = bits(x for segment in segments for point in segment for x in point) if exchanges else 0
    ends = [event for event in events if event != EXCHANGE]
    require(sorted(ends) == list(range(2 * size)), "T1", "the events are not each end of each segment once")
    places, exchanged = [], iter(exchanges)
    rank_before = end_before = None
    for k, event in enumerate(events):
        if event == EXCHANGE:
            i, j = next(exchanged)
            steps.take(1, 3 * greatest, 3 * greatest)
            require(groups[i] == groups[j] and kind_of(segments[i], segments[j]) == "crossing", "T5",
                    "segments %d and %d, which are exchanged, are not of one group or do not cross" % (i, j))
            place, rank = crossing_of(segments[i], segments[j]), (1, 0)
        else:
            a, b = segments[event // 2]
            place = (b if event % 2 else a) + (1,)
            rank = (2, event) if a == b else (0, 0) if event % 2 else (3, 0)  # a point comes and goes at once
        if k > 0:
            step = order(places[-1], place)
            require(step < 0 or (step == 0 and rank_before <= rank), "T1", "event %d is out of order" % k)
        if allowed == "nothing" and event != EXCHANGE:
            require(end_before is None or order(end_before[0], place) != 0 or
                    groups[end_before[1]] == groups[event // 2], "T1",
                    "event %d shares its point with a segment that it may not meet" % k)
            end_before = place, event // 2
        places.append(place)
        rank_before = rank
    return places


class Holders:
    """T6: the ends at one point, and the segments that hold it inside."""

    def __init__(self, segments, groups):
        self.segments, self.groups = segments, groups
        self.point, self.of_ends, self.of_holder = None, set(), None

    def look(self, point, s, neighbours):
        """The next end, of segment s, and what stands next to it in the list."""
        if point != self.point:
            self.point, self.of_ends, self.of_holder = point, set(), None
        self.of_ends.add(self.groups[s])
        for n in neighbours:
            if n >= 0 and point not in self.segments[n] and turn(*self.segments[n], point) == 0:
                self.of_holder = self.groups[n]
        require(self.of_holder is None or self.of_ends == {self.of_holder}, "T6",
                "a segment with an end where segment %d has one is not of the group of one that holds that point" % s)


def check_none(segments, groups, allowed, events, below, exchanges=(), has_groups=False):
    places = places_of(segments, groups, allowed, events, exchanges)
    holders = Holders(segments, groups) if has_groups and allowed != "touch" else None
    above_of, below_of = {-1: -1}, {-1: -1}  # a ring: -1 stands below and above all

    def become_neighbours(lower, upper):
        if lower >= 0 and upper >= 0 and groups[lower] != groups[upper]:
            kind = kind_of(segments[lower], segments[upper])
            require(kind is None or kind in ALLOWED[allowed], "T4",
                    "segments %d and %d become neighbours and meet: %s" % (lower, upper, kind))

    def are_parted(lower, upper, place):
        if lower < 0 or upper < 0 or groups[lower] != groups[upper]:
            return  # of two groups: they do not cross, by T4
        s, t = segments[lower], segments[upper]
        require(not cross_further_on(s, t) or order(place, crossing_of(s, t)) <= 0, "T5",
                "segments %d and %d are neighbours still where they have crossed" % (lower, upper))

    def link(*row):
        for lower, upper in zip(row, row[1:]):
            above_of[lower], below_of[upper] = upper, lower

    exchanged, begun = iter(exchanges), iter(below)
    for event, place in zip(events, places):
        if event == EXCHANGE:
            i, j = next(exchanged)
            require(above_of.get(i) == j, "T5", "segment %d is not just below %d, with which it is exchanged" % (i, j))
            lower, upper = below_of[i], above_of[j]
            are_parted(lower, i, place)
            are_parted(i, j, place)
            are_parted(j, upper, place)
            link(lower, j, i, upper)
            become_neighbours(lower, j)
            become_neighbours(i, upper)
            continue
        s = event // 2
        if event % 2 == 0:
            lower = next(begun)
            require(lower in above_of, "T2", "segment %d begins above %d, which is not cut then" % (s, lower))
            upper = above_of[lower]
            require(lower < 0 or is_above(segments[s], segments[lower], groups[s] == groups[lower]), "T3",
                    "segment %d does not begin above %d" % (s, lower))
            require(upper < 0 or not is_above(segments[s], segments[upper], groups[s] == groups[upper]), "T3",
                    "segment %d does not begin below %d" % (s, upper))
            are_parted(lower, upper, place)
            link(lower, s, upper)
            become_neighbours(lower, s)
            become_neighbours(s, upper)
        else:
            require(s in above_of, "T2", "segment %d ends before it begins" % s)
            lower, upper = below_of.pop(s), above_of.pop(s)
            are_parted(lower, s, place)
            are_parted(s, upper, place)
            link(lower, upper)
            become_neighbours(lower, upper)
        if holders:
            holders.look(place[:2], s, (lower, upper))


def read_groups(top, size):
    groups = member(top, "groups", list, "the file")
    require(len(groups) == size, "F", "groups is not a list of %d" % size)
    for i, group in enumerate(groups):
        require(type(group) is int and abs(group) <= MOST_IN_GROUP_NUMBER, "F",
                "groups[%d] is not a whole number of at most 15 digits" % i)
    return groups


def read_exchanges(item, size, has_groups, where):
    if "exchanges" not in item:
        return []
    require(has_groups, "F", where + " has exchanges, but the file has no groups")
    exchanges = member(item, "exchanges", list, where)
    for pair in exchanges:
        require(type(pair) is list and len(pair) == 2, "F", where + ".exchanges has an entry that is no pair")
        for i in pair:
            index(i, size, where + ".exchanges entry")
    return exchanges


class Table:
    """The segments of a file, and their groups."""

    def __init__(self, top):
        flat = []
        for i, item in enumerate(member(top, "segments", list, "the file")):
            flat += numbers(item, 4, double, "segments[%d]" % i)
        flat, _, self.exponent = common(flat)
        self.bits = bits(flat)
        self.segments = [((flat[k], flat[k + 1]), (flat[k + 2], flat[k + 3])) for k in range(0, len(flat), 4)]
        for i, (a, b) in enumerate(self.segments):
            require(a <= b, "F", "segments[%d] does not begin with its lexicographically first end" % i)
        self.has_groups = "groups" in top
        self.groups = read_groups(top, len(self.segments)) if self.has_groups else range(len(self.segments))

    def read_statement(self, item, where):
        size, has_groups = len(self.segments), self.has_groups
        allowed = member(item, "allowed", str, where)
        require(allowed in ALLOWED, "F", where + ".allowed is none of nothing, shared-endpoint, touch")
        verdict = member(item, "verdict", str, where)
        require(verdict in ("none", "some"), "F", where + ".verdict is neither none nor some")
        rule = allowed + " allowed"
        if verdict == "some":
            i, j = (index(member(item, key, int, where), size, "%s.%s" % (where, key)) for key in "ij")
            require(i != j, "F", where + " names one segment twice")
            kind = member(item, "kind", str, where)
            require(kind in KINDS, "F", where + ".kind is no kind of contact")
            point = numbers(member(item, "point", list, where), 2, number, where + ".point")
            return "segments", rule, verdict, lambda: check_some(
                self.segments, self.bits, self.groups, self.exponent, allowed, i, j, kind, point)
        events = [EXCHANGE if has_groups and type(e) is int and e == EXCHANGE else index(e, 2 * size, where + " event")
                  for e in member(item, "events", list, where)]
        exchanges = read_exchanges(item, size, has_groups, where)
        require(events.count(EXCHANGE) == len(exchanges), "F",
                where + " has not one entry of exchanges for each event -1")
        below = member(item, "below", list, where)
        require(len(below) == size, "F", where + ".below is not a list of %d" % size)
        for b in below:
            require(type(b) is int and -1 <= b < size, "F", where + ".below has an entry that is no index and not -1")
        return "segments", rule, verdict, lambda: check_none(self.segments, self.groups, allowed, events, below,
                                                             exchanges, has_groups)


def questions(top):
    """How a statement is read, for each question that the tables of a file allow."""
    return {"segments_any": Table(top).read_statement} if "segments" in top else {}
