"""Checks statements about circles with their insides, closed discs: a part of sunder_verify_sets.py.

The format and the checks are those of docs/certificates-sets.md, "circles_any" and "circles"; no code is shared with
the library.
All numbers of discs are integers here, multiples of one power of two.
"""
from sunder_verify import bits, common, common_weights, double, index, length, member, number, numbers, require, steps
from sunder_verify_arcs import check_arcs

RULES = ("nothing", "shared-endpoint", "touch")  # all but the first: touching does not count
KINDS = ("touching", "overlapping", "inside")
MOST_NAMED = 16  # discs without a common point, or with a single one; 3 are always enough
MOST_IN_GROUP_NUMBER = 10 ** 15 - 1  # all JSON readers agree about whole numbers up to this, either sign


def distance_and_radii(c, d):
    """The squares of the distance of the centres, and of the sum and the difference of the radii."""
    dx, dy = c[0] - d[0], c[1] - d[1]
    return dx * dx + dy * dy, (c[2] + d[2]) ** 2, (c[2] - d[2]) ** 2


def kind_of(c, d):
    """How two discs (x, y, r) meet: one of KINDS, or None."""
    distance, most, least = distance_and_radii(c, d)
    if distance >= most:
        return "touching" if distance == most else None
    return "overlapping" if distance > least else "inside"


def may_meet(kind, allowed):
    return kind is None or (kind == "touching" and allowed != "nothing")


def in_integers(exponent, point):
    """A point, given as two numbers, as x, y and the one unit of the discs' numbers, in a smaller unit."""
    (px, dx, ex), (py, dy, ey) = point
    low = min(ex, ey, exponent)
    return px * dy << (ex - low), py * dx << (ey - low), dx * dy << (exponent - low)


def holds(disc, exponent, point, is_inside=False):
    """Is a point, given as two numbers, in a disc? Or inside of its circle?"""
    x, y, unit = in_integers(exponent, point)
    ux, uy = x - disc[0] * unit, y - disc[1] * unit
    left = (disc[2] * unit) ** 2 - ux * ux - uy * uy
    return left > 0 or (left == 0 and not is_inside)


def check_some(discs, greatest, exponent, groups, allowed, i, j, kind, point):
    longest = length(*point) + greatest
    steps.take(16, longest, longest)
    require(not may_meet(kind, allowed), "C1", "%s does not count where %s is allowed" % (kind, allowed))
    require(groups is None or groups[i] != groups[j], "C1", "circles %d and %d are of one group" % (i, j))
    for k in (i, j):
        require(holds(discs[k], exponent, point), "C2", "the point is not in circle %d" % k)
    found = kind_of(discs[i], discs[j])
    require(found == kind, "C3", "the contact is %s" % (found or "none"))


def check_order(discs, events):
    require(sorted(events) == list(range(2 * len(discs))), "T1", "the events are not each end of each circle once")
    before = None
    for k, event in enumerate(events):
        x, _, r = discs[event // 2]
        here = (x + r, 1) if event % 2 else (x - r, 0)  # first ends come first
        require(before is None or before <= here, "T1", "event %d is out of order" % k)
        before = here


def check_none(discs, allowed, events, below):
    check_order(discs, events)
    above_of, below_of = {-1: -1}, {-1: -1}  # a ring: -1 stands below and above all

    def become_neighbours(lower, upper):
        above_of[lower], below_of[upper] = upper, lower
        if lower >= 0 and upper >= 0:
            kind = kind_of(discs[lower], discs[upper])
            require(may_meet(kind, allowed), "T4",
                    "circles %d and %d become neighbours and meet: %s" % (lower, upper, kind))

    begun = iter(below)
    for event in events:
        s = event // 2
        if event % 2:
            become_neighbours(below_of.pop(s), above_of.pop(s))
            continue
        lower = next(begun)
        require(lower in above_of, "T2", "circle %d begins above %d, which is not cut then" % (s, lower))
        upper = above_of[lower]
        require(lower < 0 or discs[lower][1] <= discs[s][1], "T3", "circle %d is not above %d" % (s, lower))
        require(upper < 0 or discs[s][1] <= discs[upper][1], "T3", "circle %d is not below %d" % (s, upper))
        become_neighbours(lower, s)
        become_neighbours(s, upper)


def depth(discs, weights):
    """Two integers: the weights' sum, and its square times the least weighted mean of the discs' powers. The power of a
    disc at p is |p - c|^2 - r^2; with weights w of sum 1 the mean is
    |p - sum w c|^2 + sum w (|c|^2 - r^2) - |sum w c|^2."""
    total = sum(weights)
    x, y = (sum(w * disc[axis] for w, disc in zip(weights, discs)) for axis in (0, 1))
    return total, total * sum(w * (d[0] ** 2 + d[1] ** 2 - d[2] ** 2) for w, d in zip(weights, discs)) - x * x - y * y


def check_common(discs, greatest, exponent, verdict, named, weights, point, arcs):
    """The common part of the discs."""
    if verdict == "region":
        longest = length(*point) + greatest
        steps.take(4 * len(discs), longest, longest)
        if arcs is not None:
            steps.take(10 * len(discs) * len(arcs), 4 * greatest, 4 * greatest)
        for k, disc in enumerate(discs):
            require(holds(disc, exponent, point, True), "D3", "the point is not inside of circle %d" % k)
        if arcs is not None:
            x, y, unit = in_integers(exponent, point)
            check_arcs(discs, arcs, x, y, unit)
        return
    chosen = [discs[k] for k in named]
    require(all(w >= 0 for w in weights) and any(weights), "D1", "the weights are not at least 0, and not all 0")
    total, power = depth(chosen, weights)
    if verdict == "empty":
        require(power > 0, "D2", "the named circles may have a common point")
        return
    require(power == 0, "D2", "the named circles have no single common point, or these weights do not show it")
    x, y = (sum(w * disc[axis] for w, disc in zip(weights, chosen)) for axis in (0, 1))
    steps.take(4 * len(discs), bits((x, y, total)), bits((x, y, total)))
    for k, (cx, cy, r) in enumerate(discs):
        require((x - cx * total) ** 2 + (y - cy * total) ** 2 <= (r * total) ** 2, "D3",
                "the point is not in circle %d" % k)


def read_groups(item, size, where):
    """The groups that a statement names, or None."""
    if "groups" not in item:
        return None
    groups = member(item, "groups", list, where)
    require(len(groups) == size, "F", where + ".groups is not a list of %d" % size)
    for group in groups:
        require(type(group) is int and abs(group) <= MOST_IN_GROUP_NUMBER, "F",
                where + ".groups has an entry that is not a whole number of at most 15 digits")
    return groups


class Table:
    """The circles of a file."""

    def __init__(self, top):
        flat = []
        for i, item in enumerate(member(top, "circles", list, "the file")):
            flat += numbers(item, 3, double, "circles[%d]" % i)
        flat, _, self.exponent = common(flat)
        self.bits = bits(flat)
        self.discs = list(zip(flat[0::3], flat[1::3], flat[2::3]))
        for i, (_, _, r) in enumerate(self.discs):
            require(r >= 0, "F", "circles[%d] has a negative radius" % i)

    def read_any(self, item, where):
        size = len(self.discs)
        allowed = member(item, "allowed", str, where)
        require(allowed in RULES, "F", where + ".allowed is none of nothing, shared-endpoint, touch")
        verdict = member(item, "verdict", str, where)
        require(verdict in ("none", "some"), "F", where + ".verdict is neither none nor some")
        groups = read_groups(item, size, where)
        rule = allowed + " allowed"
        if verdict == "some":
            i, j = (index(member(item, key, int, where), size, "%s.%s" % (where, key)) for key in "ij")
            require(i != j, "F", where + " names one circle twice")
            kind = member(item, "kind", str, where)
            require(kind in KINDS, "F", where + ".kind is no kind of contact")
            point = numbers(member(item, "point", list, where), 2, number, where + ".point")
            return "circles", rule, verdict, lambda: check_some(self.discs, self.bits, self.exponent, groups, allowed,
                                                                i, j, kind, point)
        require(groups is None, "F", where + " has groups, for which there is no transcript")
        events = [index(event, 2 * size, where + " event") for event in member(item, "events", list, where)]
        below = member(item, "below", list, where)
        require(len(below) == size, "F", where + ".below is not a list of %d" % size)
        for b in below:
            require(type(b) is int and -1 <= b < size, "F", where + ".below has an entry that is no index and not -1")
        return "circles", rule, verdict, lambda: check_none(self.discs, allowed, events, below)

    def read_common(self, item, where):
        verdict = member(item, "verdict", str, where)
        require(verdict in ("empty", "point", "region", "plane"), "F", where + ".verdict is no kind of common part")
        named, weights, point, arcs = [], [], None, None
        if verdict == "region":
            require(self.discs, "F", where + ".verdict is region, but there are no circles")
            point = numbers(member(item, "point", list, where), 2, number, where + ".point")
            if "arcs" in item:
                arcs = [index(k, len(self.discs), where + ".arcs entry") for k in member(item, "arcs", list, where)]
                require(arcs, "F", where + ".arcs is empty")
                require(len(arcs) <= 2 * len(self.discs), "F", where + ".arcs has more than two arcs a circle")
        elif verdict == "plane":
            require(not self.discs, "F", where + ".verdict is plane, but there are circles")
        else:
            named = [index(k, len(self.discs), where + ".discs entry") for k in member(item, "discs", list, where)]
            require(len(named) <= MOST_NAMED, "F", "%s.discs has more than %d entries" % (where, MOST_NAMED))
            weights = common_weights(
                numbers(member(item, "weights", list, where), len(named), number, where + ".weights"))[0]
        return "circles", "common part", verdict, lambda: verdict == "plane" or check_common(
            self.discs, self.bits, self.exponent, verdict, named, weights, point, arcs)


def questions(top):
    """How a statement is read, for each question that the tables of a file allow."""
    if "circles" not in top:
        return {}
    table = Table(top)
    return {"circles_any": table.read_any, "circles": table.read_common}
