"""The rules by which claims are checked: docs/claims.md, "Rules". They know tables and claims, and no question.

All arithmetic is on integers. A point is x, ..., w with w > 0, for (x / w, ...); points of a table have w = 1 and are in
units of a power of two. A rule is told the steps that it may take, what the claim brings, and what it is bound to.
"""
from .reader import bits, common, length, projective, require
from .tables import Discs, Segments, dot, goes_round_once, turn


def aligned(m, e, n, f):
    """Two integers that compare as m * 2^e and n * 2^f do."""
    return m << max(e - f, 0), n << max(f - e, 0)


# ---- Convex objects: the convex hull of points, and the ways from there that go on for ever.

def parted(steps, claim, a, b, is_weak=False):
    """A is strictly less far along a direction than B; where is_weak, nowhere further, and not all of both just as far."""
    d, _, _ = common(claim["direction"])  # a positive multiple of the direction
    limits, is_flat = [], is_weak
    for body, sign in ((a, 1), (b, -1)):
        points, ways, e = body.forms(steps, [sign * n for n in d])
        require(all(n <= 0 for n in ways), "parted", "a way of %s goes on along the direction" % body.name)
        limits.append((max(points), e))
        is_flat = is_flat and min(points) == max(points) and not any(ways)
    (p, e), (q, f) = limits
    p, q = aligned(p, e, -q, f)
    require(p < q or (is_weak and p == q), "parted", "%s is not %sless far along the direction than %s" % (
        a.name, "" if is_weak else "strictly ", b.name))
    require(p < q or not is_flat, "parted", "all of %s and %s is as far along the direction" % (a.name, b.name))


def parted_weakly(steps, claim, a, b):
    parted(steps, claim, a, b, True)


def holds(steps, claim, body, point):
    """A body holds a point: a convex combination of its points, and a combination of its ways."""
    named = claim["weights"]
    whole = length([weight for _, weight in named])
    steps.take(len(named) // 4 + 1, whole, whole)
    weights, d, e = common([weight for _, weight in named])
    require(all(w >= 0 for w in weights), "holds", "a weight of %s is negative" % body.name)
    total, one = aligned(sum(w for w, (k, _) in zip(weights, named) if not body.is_way(k)), e, d, 0)
    require(total == one, "holds", "the weights of %s do not sum to 1" % body.name)
    images = [body.image(k) for k, _ in named]
    for axis, (n, denominator, k) in enumerate(point):
        mean = sum(w * image[axis] for w, (image, _) in zip(weights, images))
        mean, wanted = aligned(mean * denominator, e + images[0][1], n * d, k)
        require(mean == wanted, "holds", "the weighted sum of %s is not the point in coordinate %d" % (body.name, axis))


def inside(steps, claim, body, point):
    """A body holds a point in its relative interior: what has a positive weight spans as much as the body does."""
    holds(steps, claim, body, point)
    named = [k for k, (n, _, _) in claim["weights"] if n > 0]
    steps.take(body.dimension * len(body), 4 * body.bits, 4 * body.bits)
    origin = next(body.rows[k] for k in named if not body.is_way(k))
    basis = []  # rows, and where their first number stands that is not zero
    for k in (*named, *range(len(body))):
        row = body.rows[k] if body.is_way(k) else [x - y for x, y in zip(body.rows[k], origin)]
        for other, lead in basis:
            row = [x * other[lead] - y * row[lead] for x, y in zip(row, other)]
        require(k in named or not any(row), "inside", "what makes the point does not span all of %s" % body.name)
        if any(row):
            basis.append((row, next(axis for axis, x in enumerate(row) if x)))
        if len(basis) == body.dimension:
            break


def slab(steps, claim, a, b, from_a, to_b):
    """Along the way from a point of A to one of B, no point of A is beyond the first, and none of B before the second."""
    p, q = projective(from_a), projective(to_b)
    d = [y * p[-1] - x * q[-1] for x, y in zip(p, q[:-1])]  # a positive multiple of the way
    require(any(d), "slab", "the two points are one")
    for body, end, sign in ((a, p, 1), (b, q, -1)):
        points, ways, e = body.forms(steps, [sign * n for n in d])
        most, limit = aligned(max(points) * end[-1], e, sign * dot(d, end), 0)
        require(all(n <= 0 for n in ways) and most <= limit, "slab", "%s is not behind its point" % body.name)


# ---- Linear constraints: half-planes a x + b y <= c as integers (a, b, c, exponent of all three).

def excess(h, point):
    """Positive: the point x, y, w is outside; zero: on the line."""
    return h[0] * point[0] + h[1] * point[1] - h[2] * point[2]


def look_at_all(steps, given, vector):
    steps.take(2 * len(given), bits(vector), max((bits(h[:3]) for h in given), default=0))


def feasible(steps, claim, given, point):
    """The point keeps all constraints."""
    place = projective(point)
    look_at_all(steps, given, place)
    for i, h in enumerate(given):
        require(excess(h, place) <= 0, "feasible", "the point is outside of half-plane %d" % i)


def weighted_sum(steps, claim, rows):
    """Of the named rows of integers * 2^e, which stands last, by weights that are positive: times a positive number."""
    named = claim["weights"]
    whole = length([weight for _, weight in named])
    steps.take(len(named) // 4 + 1, whole, whole)
    chosen = [rows(k) for k, _ in named]
    weights, _, _ = common([(n, d, e + row[-1]) for row, (_, (n, d, e)) in zip(chosen, named)])
    require(all(w > 0 for w in weights), "weights", "a weight is not positive")
    return [sum(map(int.__mul__, weights, column)) for column in zip(*chosen)][:-1]


def bounds(steps, claim, given, objective, point, is_only=False):
    """No common point is further along the objective than the point, and, where is_only, no other one as far."""
    a, b, _ = weighted_sum(steps, claim, given.__getitem__)
    up = common(objective)[0]
    require(turn((a, b), up) == 0 and dot((a, b), up) > 0, "bounds", "the weighted normals are not the objective")
    place = projective(point)
    sides = [given[k] for k, _ in claim["weights"]]
    for (k, _), side in zip(claim["weights"], sides):
        require(excess(side, place) == 0, "bounds", "the point is not on the line of half-plane %d" % k)
    require(not is_only or any(turn(sides[0], side) for side in sides), "bounds",
            "the lines at the point are one")


def bounds_only(steps, claim, given, objective, point):
    bounds(steps, claim, given, objective, point, True)


def no_objective(steps, claim, given, objective):
    """No point is further than another."""
    require(not any(common(objective)[0]), "no_objective", "there is an objective")


def contradict(steps, claim, given):
    """No point keeps the named constraints."""
    a, b, c = weighted_sum(steps, claim, given.__getitem__)
    require(a == b == 0 and c < 0, "contradict", "the weighted constraints have a common point")


def goes_on(steps, claim, given, objective):
    """Along a direction no constraint is left; and it leads further along the objective."""
    way = common(claim["direction"])[0]
    require(dot(common(objective)[0], way) > 0, "goes_on", "the direction does not lead further along the objective")
    look_at_all(steps, given, way)
    for i, h in enumerate(given):
        require(dot(h, way) <= 0, "goes_on", "the direction leaves half-plane %d" % i)


def ends(steps, claim, given, objective, point):
    """All that is as far along the objective as the point, on one line, is from the first to the second end, where these
    are; the second is to the left of the objective."""
    p, q = common(objective)[0]
    places = []
    for way, end in zip(((q, -p), (-q, p)), claim["ends"]):
        if end is None:
            look_at_all(steps, given, way)
            require(all(dot(h, way) <= 0 for h in given), "ends", "there is an end, and it is not given")
            continue
        place, k = projective(end[0]), end[1]
        look_at_all(steps, given, place)
        require(all(excess(h, place) <= 0 for h in given), "ends", "an end is outside of a half-plane")
        here, there = dot((p, q), place), dot((p, q), projective(point))
        require(here * projective(point)[2] == there * place[2], "ends", "an end is not as far along the objective")
        require(excess(given[k], place) == 0 and dot(given[k], way) > 0, "ends", "half-plane %d does not end it" % k)
        places.append((dot((-q, p), place), place[2]))
    if len(places) == 2:
        (m, v), (n, w) = places
        require(m * w < n * v, "ends", "the ends are one point")


def corner(h, g):
    """The common point of the lines of two half-planes that turn, as x, y, w."""
    return h[2] * g[1] - g[2] * h[1], h[0] * g[2] - g[0] * h[2], turn(h, g)


EXTENTS = {"point": 0, "segment": 2, "ray": 0}  # how many sides with a corner at each end are no point; else all
NUMBER = {"plane": 0, "half-plane": 1, "line": 2, "strip": 2}  # of sides without corners


def cones(steps, claim, given, verdict, sides):
    """The sides, counter-clockwise, bound a region of the kind, and each half-plane holds it."""
    sides, is_open = [given[k] for k in sides], verdict in ("ray", "unbounded")
    n, after = len(sides), sides[1:] + sides[:1]
    if verdict in NUMBER:
        require(n == NUMBER[verdict], "sides", "there are %d sides" % n)
        if n == 2:
            h, g = sides
            gap = dot(h[:2], h) * g[2] - dot(h[:2], g) * h[2]
            require(turn(h, g) == 0 > dot(h[:2], g) and (gap == 0 if verdict == "line" else gap > 0), "sides",
                    "the sides are not opposite, or not as far apart as they must be")
    else:
        require(goes_round_once(sides) if not is_open else n > 1 and all(turn(h, g) > 0 for h, g in zip(sides, sides[1:])),
                "sides", "the sides do not turn as they must")
        whole = turn(sides[0], sides[-1]) if is_open else 0
        require(not is_open or (whole >= 0 and all(turn(sides[0], h) > 0 for h in sides[1:-1])), "sides",
                "the sides turn by more than half a turn")
        corners = [corner(h, g) for h, g in zip(sides, after)]
        ends = [excess(after[k], corners[k - 1]) for k in range(is_open, n - is_open)]
        extents = sum(end < 0 for end in ends)
        require(all(end <= 0 for end in ends) and extents == EXTENTS.get(verdict, len(ends)), "sides",
                "%d sides have a part of the boundary" % extents)
        require(verdict != "ray" or whole == 0, "sides", "the ray's sides are not opposite")
    for i, (h, p) in enumerate(zip(given, claim["cones"])):
        side = sides[p]
        if verdict in NUMBER:
            is_between, is_kept = turn(side, h) == 0 < dot(side[:2], h), dot(side[:2], h) * side[2] <= dot(side[:2], side) * h[2]
        else:
            is_between, is_kept = turn(side, h) >= 0 and turn(h, after[p]) >= 0, excess(h, corners[p]) <= 0
        require(is_between, "cones", "half-plane %d does not face as between its sides" % i)
        require(is_kept, "cones", "half-plane %d does not hold its corner" % i)


# ---- Segments: pairs of points, the lexicographically lesser one first.

KINDS = ("shared-endpoint", "touch", "crossing", "overlap")


def side(segment, point):
    """Positive: the point x, y, w is above the segment's line: left of it, seen from its first end."""
    (ax, ay), (bx, by) = segment
    x, y, w = point
    return (bx - ax) * (y - ay * w) - (by - ay) * (x - ax * w)


def way_of(segment):
    (ax, ay), (bx, by) = segment
    return bx - ax, by - ay


def kind_of(s, t):
    """How two segments meet that have a common point."""
    if turn(way_of(s), way_of(t)) == 0 and s[0] != s[1] and t[0] != t[1]:
        first, last = max(s[0], t[0]), min(s[1], t[1])  # on one line, where the order of points is the order along it
        return "overlap" if first < last else "shared-endpoint"
    ends = [any(side(v, end + (1,)) == 0 and v[0] <= end <= v[1] for end in u) for u, v in ((s, t), (t, s))]
    if s[0] in t or s[1] in t:
        return "shared-endpoint"
    return "touch" if any(ends) else "crossing"


def is_on(segment, point):
    first, last = (end + (1,) for end in segment)
    return side(segment, point) == 0 and not before(point, first) and not before(last, point)


# ---- Discs: x, y, r.

DISC_KINDS = ("touching", "overlapping", "inside")


def power_of(disc, point):
    """Positive: the point x, y, w is outside."""
    x, y, w = point
    return (x - disc[0] * w) ** 2 + (y - disc[1] * w) ** 2 - (disc[2] * w) ** 2


def is_in(disc, point):
    return power_of(disc, point) <= 0


def kind_of_discs(c, d):
    """How two discs meet, or None."""
    distance, most, least = (c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2, (c[2] + d[2]) ** 2, (c[2] - d[2]) ** 2
    if distance >= most:
        return "touching" if distance == most else None
    return "overlapping" if distance > least else "inside"


def in_discs(steps, claim, discs, point, verdict):
    """The point is in all discs; for a region, inside of all circles."""
    place = projective([(n, d, e - discs.exponent) for n, d, e in point])
    steps.take(4 * len(discs), length(point) + discs.bits, length(point) + discs.bits)
    for k, disc in enumerate(discs):
        power = power_of(disc, place)
        require(power < 0 or (power == 0 and verdict == "point"), "in_discs", "the point is not inside of circle %d" % k)


def no_entries(steps, claim, table):
    require(not table, "no_entries", "there are entries")


def powers(steps, claim, discs, verdict):
    """The weighted mean of the powers is positive everywhere, or, where there is a common point, zero there at least."""
    def row(k):
        x, y, r = discs[k]
        return 1, x, y, x * x + y * y - r * r, 0
    total, x, y, rest = weighted_sum(steps, claim, row)
    least = total * rest - x * x - y * y
    require(least > 0 or (least == 0 and verdict == "point"), "powers", "the mean of the powers is not as it must be")


# ---- Contacts of two entries of a table.

MEETING = {Segments: (is_on, kind_of), Discs: (is_in, kind_of_discs)}


def contact(steps, claim, table, i, j, kind, point, groups, allowed):
    """Two entries of different groups hold a point, and the kind of their contact counts."""
    holds_point, kind_between = MEETING[type(table)]
    place = projective([(n, d, e - table.exponent) for n, d, e in point])
    steps.take(16, length(point), table.bits)
    require(i != j and (groups is None or groups[i] != groups[j]), "contact", "%d and %d are of one group" % (i, j))
    require(kind not in allowed, "contact", kind + " does not count")
    for k in (i, j):
        require(holds_point(table[k], place), "contact", "the point is not in %d" % k)
    found = kind_between(table[i], table[j])
    require(found == kind, "contact", "the contact is " + found)


class Node:
    """Of the tree over an order: a range of it, its box, its group where it is one, and its halves."""

    def __init__(self, order, boxes, groups):
        self.first, self.halves = order[0], None
        self.box, self.group = boxes[self.first], groups[self.first]
        if len(order) > 1:
            half = len(order) // 2
            self.halves = a, b = Node(order[:half], boxes, groups), Node(order[half:], boxes, groups)
            self.box = (*map(min, a.box[:2], b.box[:2]), *map(max, a.box[2:], b.box[2:]))
            self.group = a.group if a.group == b.group else None
        self.length = max(self.box[2] - self.box[0], self.box[3] - self.box[1])


def meetings(steps, order, table, groups, allowed):
    """Gives all contacts that count of two entries of different groups: i, j and the kind."""
    root = order and Node(order, table.boxes(), groups if groups is not None else range(len(table)))
    left = order and [(root, root)]
    while left:
        a, b = left.pop()
        steps.take(1, table.bits, table.bits)
        p, q = a.box, b.box
        if p[2] < q[0] or q[2] < p[0] or p[3] < q[1] or q[3] < p[1] or a.group == b.group is not None:
            continue
        if a is b:
            left += [(a.halves[0], a.halves[0]), a.halves, (a.halves[1], a.halves[1])]
        elif a.halves and (not b.halves or a.length >= b.length):
            left += [(half, b) for half in a.halves]
        elif b.halves:
            left += [(a, half) for half in b.halves]
        else:
            i, j = sorted((a.first, b.first))
            kind = MEETING[type(table)][1](table[i], table[j])
            if kind and kind not in allowed:
                yield i, j, kind


def cover(steps, claim, table, groups, allowed, found=()):
    """The contacts that count are those found: a sorted list, or their number."""
    contacts = meetings(steps, claim["order"], table, groups, allowed)
    if type(found) is int:
        number = sum(1 for _ in contacts)
        require(number == found, "cover", "there are %d contacts" % number)
        return
    listed = {tuple(item) for item in found}
    for contact_found in contacts:
        require(contact_found in listed, "cover", "%d and %d have a contact, which is not listed: %s" % contact_found)
        listed.remove(contact_found)
    require(not listed, "cover", "a contact that is listed is none, or does not count")


# ---- Sweeps: a list of segments from the lowest up, kept through events at points, lexicographically ordered.

def before(p, q):
    """Is p lexicographically before q?"""
    return (p[0] * q[2] - q[0] * p[2] or p[1] * q[2] - q[1] * p[2]) < 0


def is_at(point, end):
    x, y, w = point
    return x == end[0] * w and y == end[1] * w


def crossing_of(s, t):
    """The common point of two segments' lines, which are not parallel."""
    u, v = way_of(s), way_of(t)
    across, along = turn(u, v), turn((t[0][0] - s[0][0], t[0][1] - s[0][1]), v)
    if across < 0:
        across, along = -across, -along
    return s[0][0] * across + u[0] * along, s[0][1] * across + u[1] * along, across


def sweep(steps, claim, segments):
    """Gives, point by point, which segments hold it: those that were in the list, from the lowest up, and those that
    go on from there. Between these points no two segments meet that did not meet at one of them."""
    above_of = {-1: -1}  # the list, as a ring: -1 stands below and above all
    begun = [False] * len(segments)
    last = None
    for k, (at, below, *row) in enumerate(claim["events"]):
        where = "event %d" % k
        if at >= 0:
            point = segments[at // 2][at % 2] + (1,)
        else:
            require(len(row) > 1 and turn(way_of(segments[row[0]]), way_of(segments[row[-1]])) != 0, "sweep",
                    where + " has no point: its first and last segment do not cross")
            steps.take(len(row) + 4, 3 * segments.bits, 3 * segments.bits)
            point = crossing_of(segments[row[0]], segments[row[-1]])
        require(last is None or before(last, point), "sweep", where + " is not after the one before it")
        last = point
        # What stands in the list at this point: all from `below` up that hold it.
        require(below in above_of, "sweep", where + " is above a segment that is not in the list")
        require(below < 0 or side(segments[below], point) > 0, "sweep", "%s is not above segment %d" % (where, below))
        here, upper = [], above_of[below]
        while upper >= 0 and side(segments[upper], point) == 0:
            here.append(upper)
            upper = above_of[upper]
        require(upper < 0 or side(segments[upper], point) < 0, "sweep", "%s is not below segment %d" % (where, upper))
        for s in here:
            del above_of[s]
        stay = {s for s in here if not is_at(point, segments[s][1])}
        # What goes on from it, sorted by direction.
        lower = below
        for s in row:
            if s in stay:
                stay.remove(s)
            else:
                require(not begun[s] and is_at(point, segments[s][0]), "sweep",
                        "%s: segment %d is not in the list there, or does not begin there" % (where, s))
                begun[s] = True
            if lower != below:
                require(turn(way_of(segments[lower]), way_of(segments[s])) >= 0, "sweep",
                        "%s: segment %d does not go on above %d" % (where, s, lower))
            if segments[s][0] != segments[s][1]:
                above_of[lower] = s
                lower = s
        require(not stay, "sweep", "%s loses a segment that goes on" % where)
        above_of[lower] = upper
        yield point, here, row
    require(all(begun) and above_of[-1] == -1, "sweep", "not all segments begin and end")


def ends_at(segment, point):
    return is_at(point, segment[0]) or is_at(point, segment[1])


def lines_of(segments, row):
    """For each of a row, which is sorted by direction, the first of those on its line."""
    lines = {}
    for s, t in zip(row[:1] + row, row):
        lines[t] = lines[s] if s != t and turn(way_of(segments[s]), way_of(segments[t])) == 0 else t
    return lines


def contacts_of(steps, claim, segments, groups, allowed):
    """Gives (i, j, kind), i < j, once for each two segments of different groups whose contact is of a kind that counts."""
    of = groups if groups is not None else range(len(segments))
    for point, here, row in sweep(steps, claim, segments):
        back, on = lines_of(segments, here), lines_of(segments, [s for s in row if segments[s][0] != segments[s][1]])
        members = here + [s for s in row if s not in back]
        passing = [s for s in members if not ends_at(segments[s], point)]
        rows = {s: [] for s in on.values()}  # those that go on along one line
        for s in on:
            rows[on[s]].append(s)
        found = set()
        for some, others in [(members if not allowed else passing, members if "touch" not in allowed else passing)] + \
                [(of_line, of_line) for of_line in rows.values()]:
            if len({of[s] for s in others}) < 2:
                continue
            steps.take(len(some) * len(others) // 16, 1, 1)
            for i, j in ((min(s, t), max(s, t)) for s in some for t in others if of[s] != of[t]):
                if (i, j) in found or back.get(i, -1) == back.get(j, -2):  # on one line before: they have met
                    continue
                found.add((i, j))
                overlap = on.get(i, -1) == on.get(j, -2)
                kind = "overlap" if overlap else KINDS[2 - ends_at(segments[i], point) - ends_at(segments[j], point)]
                if kind not in allowed:
                    yield i, j, kind
