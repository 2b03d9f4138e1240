"""Checks statements about convex polygons: a part of sunder_verify_sets.py.

The format and the checks are those of docs/certificates-sets.md, "convex_polygons_any"; no code is shared with the
library. A polygon is the convex hull of its vertices, in whatever order: also a segment, or a point. All coordinates
are integers here, multiples of one power of two.
"""
import functools

from sunder_verify import bits, common, common_weights, double, index, length, member, number, numbers, read_weights, \
    require, steps
from sunder_verify_circles import RULES, read_groups

CONTACTS = ("touching", "overlapping")


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def contact_at(a, b, point):
    """How two polygons with a common point x, y, w meet. Where their relative interiors do not, a line through the
    point parts them: then all ways from it into a, and the opposites of those into b, are on one side of the line, or
    on it, and not all are on it."""
    x, y, w = point
    ways = [(p[0] * w - x, p[1] * w - y) for p in a] + [(x - p[0] * w, y - p[1] * w) for p in b]
    ways = [way for way in ways if way != (0, 0)]
    if not ways:
        return "overlapping"

    def half(u):
        return u < (0, 0)

    def compare(u, v):  # by angle
        return half(u) - half(v) or -cross(u, v)

    ways.sort(key=functools.cmp_to_key(compare))
    if all(cross(ways[0], v) == 0 for v in ways):
        return "overlapping" if dot(ways[0], ways[-1]) < 0 else "touching"
    # They are on one side of a line iff some two that follow each other are half a turn or more apart.
    for u, v in zip(ways, ways[1:] + ways[:1]):
        if cross(u, v) < 0 or (cross(u, v) == 0 and dot(u, v) < 0):
            return "touching"
    return "overlapping"


def scaled_point(point, exponent):
    """A point given as two numbers, as x, y, w with w > 0, in units of 2^exponent."""
    (x, y), d, e = common(point)
    return x << max(e - exponent, 0), y << max(e - exponent, 0), d << max(exponent - e, 0)


def check_some(polygons, greatest, exponent, groups, allowed, i, j, contact, point, weights):
    require(contact == "overlapping" or allowed != "touch", "C1", "touching does not count where it is allowed")
    require(groups is None or groups[i] != groups[j], "C1", "polygons %d and %d are of one group" % (i, j))
    place = scaled_point(point, exponent)
    for k, named in zip((i, j), weights):
        values, d, e = common_weights(named.values())
        require(all(v >= 0 for v in values), "C2", "a weight of polygon %d is negative" % k)
        total = sum(values)
        require(total << max(e, 0) == d << max(-e, 0), "C2", "the weights of polygon %d do not sum to 1" % k)
        for axis in (0, 1):
            mean = sum(v * polygons[k][vertex][axis] for v, vertex in zip(values, named))
            require(mean * place[2] == place[axis] * total, "C2", "the weighted sum of polygon %d is not the point" % k)
    whole = length(*point) + greatest
    steps.take(8 * (len(polygons[i]) + len(polygons[j])), whole, whole)
    found = contact_at(polygons[i], polygons[j], place)
    require(found == contact, "C3", "the contact is %s" % found)


def check_order(polygons, events):
    require(sorted(events) == list(range(2 * len(polygons))), "T1", "the events are not each end of each polygon once")
    ends = [(min(polygon), max(polygon)) for polygon in polygons]
    before = None
    for k, event in enumerate(events):
        here = ends[event // 2][event % 2]
        is_point = event % 2 and k > 0 and events[k - 1] == event - 1  # it may come and go at once
        require(before is None or before < here or (before == here and is_point), "T1",
                "event %d is out of order, or shares its point" % k)
        before = here


def check_none(polygons, events, below, directions):
    check_order(polygons, events)
    above_of, below_of = {-1: -1}, {-1: -1}  # a ring: -1 stands below and above all
    given = iter(directions)
    greatest = bits(x for polygon in polygons for vertex in polygon for x in vertex)

    def become_neighbours(lower, upper, is_new):
        above_of[lower], below_of[upper] = upper, lower
        if lower < 0 or upper < 0:
            return
        d = next(given, None)
        require(d is not None, "T4", "there are fewer directions than neighbours")
        require(not is_new or d[1] > 0, "T3",
                "the direction between polygons %d and %d does not point up" % (lower, upper))
        steps.take(len(polygons[lower]) + len(polygons[upper]), bits(d), greatest)
        require(max(dot(d, p) for p in polygons[lower]) < min(dot(d, p) for p in polygons[upper]), "T4",
                "the direction does not part polygons %d and %d, which become neighbours" % (lower, upper))

    begun = iter(below)
    for event in events:
        s = event // 2
        if event % 2:
            become_neighbours(below_of.pop(s), above_of.pop(s), False)
            continue
        lower = next(begun)
        require(lower in above_of, "T2", "polygon %d begins above %d, which is not cut then" % (s, lower))
        upper = above_of[lower]
        become_neighbours(lower, s, True)
        become_neighbours(s, upper, True)
    require(next(given, None) is None, "T4", "there are more directions than neighbours")


class Table:
    """The convex polygons of a file."""

    def __init__(self, top):
        flat, sizes = [], []
        for i, polygon in enumerate(member(top, "convex_polygons", list, "the file")):
            where = "convex_polygons[%d]" % i
            require(type(polygon) is list and polygon, "F", where + " is not a list of vertices")
            for vertex in polygon:
                flat += numbers(vertex, 2, double, where + " vertex")
            sizes.append(len(polygon))
        flat, _, self.exponent = common(flat)
        self.bits = bits(flat)
        vertices = iter(zip(flat[0::2], flat[1::2]))
        self.polygons = [[next(vertices) for _ in range(size)] for size in sizes]

    def read_any(self, item, where):
        size = len(self.polygons)
        allowed = member(item, "allowed", str, where)
        require(allowed in RULES, "F", where + ".allowed is none of nothing, shared-endpoint, touch")
        verdict = member(item, "verdict", str, where)
        require(verdict in ("none", "some"), "F", where + ".verdict is neither none nor some")
        groups = read_groups(item, size, where)
        about = "convex polygons", allowed + " allowed", verdict
        if verdict == "some":
            i, j = (index(member(item, key, int, where), size, "%s.%s" % (where, key)) for key in "ij")
            require(i != j, "F", where + " names one polygon twice")
            contact = member(item, "contact", str, where)
            require(contact in CONTACTS, "F", where + ".contact is neither touching nor overlapping")
            point = numbers(member(item, "point", list, where), 2, number, where + ".point")
            weights = [read_weights(member(item, "weights_" + key, list, where), len(self.polygons[k]),
                                    "%s.weights_%s" % (where, key)) for key, k in zip("ij", (i, j))]
            return *about, lambda: check_some(self.polygons, self.bits, self.exponent, groups, allowed, i, j, contact, point,
                                              weights)
        require(groups is None and allowed != "touch", "F",
                where + " has groups or allows touching, for which there is no transcript")
        events = [index(event, 2 * size, where + " event") for event in member(item, "events", list, where)]
        below = member(item, "below", list, where)
        require(len(below) == size, "F", where + ".below is not a list of %d" % size)
        for b in below:
            require(type(b) is int and -1 <= b < size, "F", where + ".below has an entry that is no index and not -1")
        directions = [common(numbers(d, 2, number, where + ".directions entry"))[0]
                      for d in member(item, "directions", list, where)]
        return *about, lambda: check_none(self.polygons, events, below, directions)


def questions(top):
    """How a statement is read, for each question that the tables of a file allow."""
    return {"convex_polygons_any": Table(top).read_any} if "convex_polygons" in top else {}
