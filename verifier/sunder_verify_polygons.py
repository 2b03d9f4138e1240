"""Checks statements about polygons with holes: a part of sunder_verify_sets.py.

The format and the checks are those of docs/certificates-sets.md, "polygons_any"; no code is shared with the library. A
polygon is here the list of its edges, pairs of points, the lesser one first. All coordinates are integers, multiples of
one power of two.
"""
from sunder_verify import bits, common, double, index, length, member, number, numbers, require, steps
from sunder_verify_circles import RULES, read_groups
from sunder_verify_convex import scaled_point
from sunder_verify_segments import Holders, kind_of, turn

MAY_MEET = {  # how edges of different polygons may meet
    "nothing": (None,),
    "shared-endpoint": (None, "shared-endpoint"),
    "touch": (None, "shared-endpoint", "touch", "overlap"),
}


def place_in(edges, point, longest=0):
    """Where the point x, y, w is: outside, inside, on an edge, or at a vertex and on no edge but at its ends. longest: the
    bits of the numbers that are multiplied, for the steps."""
    x, y, w = point
    is_inside, on = False, None
    for edge in edges:
        a, b = ((u * w, v * w) for u, v in edge)
        if (x, y) in (a, b):
            on = on or "vertex"
        elif a < (x, y) < b:
            steps.take(1, longest, longest)
            side = turn(a, b, (x, y))
            if side == 0:  # on one line, the order of points is the order along it
                on = "edge"
            elif side > 0:  # the edge is below the point
                is_inside = not is_inside
    return on or ("inside" if is_inside else "outside")


def check_some(polygons, greatest, exponent, groups, allowed, i, j, point):
    require(groups is None or groups[i] != groups[j], "C1", "polygons %d and %d are of one group" % (i, j))
    places = []
    steps.take(4 * (len(polygons[i]) + len(polygons[j])), length(*point), greatest)
    for k in (i, j):
        places.append(place_in(polygons[k], scaled_point(point, exponent), length(*point) + greatest))
        require(places[-1] != "outside", "C2", "the point is not in polygon %d" % k)
    if allowed == "shared-endpoint":
        require(places != ["vertex", "vertex"], "C3", "the point is only a vertex of both")
    if allowed == "touch":
        require(places == ["inside", "inside"], "C3", "the point is not inside of both")


def check_order(edges, of, allowed, events):
    """T1. The point of each event."""
    require(sorted(events) == list(range(2 * len(edges))), "T1", "the events are not each end of each edge once")
    points, before, of_before = [], None, None
    for k, event in enumerate(events):
        a, b = edges[event // 2]
        points.append((a, b)[event % 2])
        # At one point first last ends, then edges of length zero, one after the other, then first ends.
        here = points[-1], (1, event) if a == b else (0, 0) if event % 2 else (2, 0)
        require(before is None or before <= here, "T1", "event %d is out of order" % k)
        require(allowed != "nothing" or before is None or before[0] != here[0] or of_before == of[event // 2], "T1",
                "event %d shares its point with another polygon" % k)
        before, of_before = here, of[event // 2]
    return points


def check_none(polygons, allowed, events, below):
    edges = [edge for polygon in polygons for edge in polygon]
    of = [i for i, polygon in enumerate(polygons) for _ in polygon]
    points = check_order(edges, of, allowed, events)
    holders = Holders(edges, of) if allowed != "touch" else None
    above_of, below_of = {-1: -1}, {-1: -1}  # a ring: -1 stands below and above all
    is_upper = {-1: True}  # in its pair

    def become_neighbours(lower, upper):
        above_of[lower], below_of[upper] = upper, lower
        if lower < 0 or upper < 0:
            return
        kind = kind_of(edges[lower], edges[upper])
        require(kind != "crossing" and (of[lower] == of[upper] or kind in MAY_MEET[allowed]), "T4",
                "edges %d and %d become neighbours and meet: %s" % (lower, upper, kind))

    def put_in(s, lower):
        require(lower in above_of, "T2", "edge %d begins above %d, which is not cut then" % (s, lower))
        upper = above_of[lower]
        for t, sign, where in ((lower, 1, "above"), (upper, -1, "below")):
            if t >= 0:
                side = turn(*edges[t], edges[s][0]) or turn(*edges[t], edges[s][1])
                require(side * sign >= 0, "T3", "edge %d does not begin %s %d" % (s, where, t))
        become_neighbours(lower, s)
        become_neighbours(s, upper)
        return lower, upper

    def take_out(s):
        require(s in above_of, "T2", "edge %d ends before it begins" % s)
        lower, upper = below_of.pop(s), above_of.pop(s)
        become_neighbours(lower, upper)
        return lower, upper

    def check_pairs(changed):
        """T5, around the edges that are new in the list, or have new neighbours."""
        changed = [s for s in changed if s in above_of]
        for s in changed:
            row = []
            while s not in is_upper:
                row.append(s)
                s = below_of[s]
            for e in reversed(row):
                is_upper[e] = not is_upper[below_of[e]]
        for s in changed:
            for lower, upper in ((below_of[s], s), (s, above_of[s])):
                if is_upper[lower]:
                    is_right = upper < 0 or not is_upper[upper]
                else:
                    is_right = upper >= 0 and is_upper[upper] and of[lower] == of[upper]
                require(is_right, "T5", "edges %d and %d are not as in pairs of one polygon each" % (lower, upper))

    begun, changed = iter(below), []
    for k, event in enumerate(events):
        s = event // 2
        neighbours = take_out(s) if event % 2 else put_in(s, next(begun))
        if holders:
            holders.look(points[k], s, neighbours)
        changed += (s, *neighbours)
        if k + 1 == len(events) or points[k + 1] != points[k]:
            check_pairs(changed)
            changed = []


class Table:
    """The polygons of a file."""

    def __init__(self, top):
        flat, sizes = [], []
        for i, rings in enumerate(member(top, "polygons", list, "the file")):
            where = "polygons[%d]" % i
            require(type(rings) is list and rings, "F", where + " is not a list of rings")
            sizes.append([])
            for ring in rings:
                require(type(ring) is list and len(ring) >= 3, "F", where + " has a ring of fewer than three vertices")
                sizes[-1].append(len(ring))
                for vertex in ring:
                    flat += numbers(vertex, 2, double, where + " vertex")
        flat, _, self.exponent = common(flat)
        self.bits = bits(flat)
        vertices = iter(zip(flat[0::2], flat[1::2]))
        self.polygons = []
        for i, of_rings in enumerate(sizes):
            self.polygons.append([])
            for size in of_rings:
                ring = [next(vertices) for _ in range(size)]
                require(len(set(ring)) > 1, "F", "polygons[%d] has a ring that is one point" % i)
                self.polygons[-1] += [tuple(sorted(edge)) for edge in zip(ring, ring[1:] + ring[:1])]

    def read_any(self, item, where):
        size = len(self.polygons)
        allowed = member(item, "allowed", str, where)
        require(allowed in RULES, "F", where + ".allowed is none of nothing, shared-endpoint, touch")
        verdict = member(item, "verdict", str, where)
        require(verdict in ("none", "some"), "F", where + ".verdict is neither none nor some")
        groups = read_groups(item, size, where)
        about = "polygons", allowed + " allowed", verdict
        if verdict == "some":
            i, j = (index(member(item, key, int, where), size, "%s.%s" % (where, key)) for key in "ij")
            require(i != j, "F", where + " names one polygon twice")
            point = numbers(member(item, "point", list, where), 2, number, where + ".point")
            return *about, lambda: check_some(self.polygons, self.bits, self.exponent, groups, allowed, i, j, point)
        require(groups is None, "F", where + " has groups, for which there is no transcript")
        count = sum(map(len, self.polygons))
        events = [index(event, 2 * count, where + " event") for event in member(item, "events", list, where)]
        below = member(item, "below", list, where)
        require(len(below) == count, "F", where + ".below is not a list of %d" % count)
        for b in below:
            require(type(b) is int and -1 <= b < count, "F", where + ".below has an entry that is no index and not -1")
        return *about, lambda: check_none(self.polygons, allowed, events, below)


def questions(top):
    """How a statement is read, for each question that the tables of a file allow."""
    return {"polygons_any": Table(top).read_any} if "polygons" in top else {}
