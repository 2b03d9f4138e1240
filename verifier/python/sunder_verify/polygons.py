"""The rules about polygons, and about lists of what meets: docs/claims.md, "Polygons", "Valid polygons"."""
import collections
import fractions
import itertools

from .reader import length, projective, require
from .rules import before, contacts_of, ends_at, is_on, side, sweep, way_of
from .tables import Polygons, turn


# ---- Polygons: their edges, and what is above an odd number of them.

def cells(steps, claim, polygons, allowed):
    """Gives, event by event, pairs of sets: each polygon of the first has common points that count with each of the second.
    Any two that have some are in one of these pairs."""
    owner, covers = polygons.owner, {-1: frozenset()}  # of each edge in the list, the polygons that cover what is just above
    for k, (point, here, row) in enumerate(sweep(steps, claim, polygons.edges)):
        label = covers[claim["events"][k][1]]
        looks, at = len(label), {owner[s] for s in here + row}
        passing = {owner[s] for s in here + row if not ends_at(polygons.edges[s], point)}
        if not allowed:
            pairs = [(at, at | label)]
        elif "touch" not in allowed:
            pairs = [(passing, at | label), (at, label - at)]
        else:
            within = {i for i in at & polygons.flat if i in passing or polygons.is_point(i)}
            pairs = [(within, within | (label - at))]
        for s in here:
            del covers[s]
        row = [s for s in row if polygons.edges[s][0] != polygons.edges[s][1]]
        border, lower = set(), label  # the owners of the edges that go on in one direction; what is just below these
        for s, t in zip(row, row[1:] + [None]):
            label = covers[s] = label ^ {owner[s]}
            looks += len(label)
            border.add(owner[s])
            if t is None or turn(way_of(polygons.edges[s]), way_of(polygons.edges[t])):
                if "touch" in allowed:
                    pairs += [(label & at, label), (border & polygons.flat, border & polygons.flat | (lower - border))]
                elif allowed:
                    pairs.append((border, border | lower))
                border, lower = set(), label
        steps.take(looks, 1, 1)
        yield pairs


def pairs_of(steps, claim, polygons, groups, allowed):
    """Gives (i, j), i < j, once for each two polygons of different groups that have a common point that counts."""
    of, found = groups if groups is not None else range(len(polygons)), set()
    for first, second in itertools.chain.from_iterable(cells(steps, claim, polygons, allowed)):
        members = {}
        for j in sorted(second):
            members.setdefault(of[j], []).append(j)
        for i in sorted(first):
            others = [j for group in sorted(members) if group != of[i] for j in members[group]]
            steps.take(len(members) + len(others), 1, 1)
            for pair in ((min(i, j), max(i, j)) for j in others):
                if pair not in found:
                    found.add(pair)
                    yield pair


def above_odd(edges, point):
    """Is the point above an odd number of edges?"""
    return sum(1 for first, last in edges if not before(point, first + (1,)) and before(point, last + (1,)) and
               side((first, last), point) > 0) % 2 == 1


def common_point(steps, claim, polygons, i, j, point, groups, allowed):
    """Two polygons of different groups hold a point, which counts."""
    place = projective([(n, d, e - polygons.edges.exponent) for n, d, e in point])
    require(i != j and (groups is None or groups[i] != groups[j]), "common_point", "%d and %d are of one group" % (i, j))
    inside, touched, passed = 0, 0, False
    for k in (i, j):
        edges = polygons.edges_of(k)
        steps.take(4 * len(edges), length(point), polygons.edges.bits)
        on = [edge for edge in edges if is_on(edge, place)]
        require(on or above_odd(edges, place), "common_point", "the point is not in polygon %d" % k)
        passes = not all(ends_at(edge, place) for edge in on)
        inside += not on or (k in polygons.flat and (passes or polygons.is_point(k)))
        touched, passed = touched + bool(on), passed or passes
    require(inside == 2 or "touch" not in allowed, "common_point", "the point is not inside of both")
    require(not allowed or "touch" in allowed or touched < 2 or passed, "common_point", "all edges of both end at the point")


def fits(parts, label):
    """May all these rings have a common point inside? In each part its shell, and one hole; one shell without."""
    rings = collections.Counter(parts.part[r] for r in label)
    return all(n <= 2 and parts.shell[i] in label for i, n in rings.items()) and sum(n == 1 for n in rings.values()) <= 1


def leader(joined, r):
    while joined[r] != r:
        joined[r] = r = joined[joined[r]]
    return r


def valid(steps, claim, parts, rule):
    """Rings are simple, have no pieces in common, and each part is the inside of its first ring without the others, which
    are holes side by side; it hangs together, and no other part is in it."""
    covers, joined, seen = {-1: frozenset()}, list(range(len(parts.part))), set()
    for k, (_, here, row) in enumerate(sweep(steps, claim, parts.edges)):
        label = covers[claim["events"][k][1]]
        going = [s for s in row if parts.edges[s][0] != parts.edges[s][1]]
        require(rule == "valid" or going == row, "valid", "a vertex is repeated")
        at = collections.Counter(parts.ring[s] for s in here + going)
        require(all(n == 2 for n in at.values()), "valid", "a ring comes twice to a point")
        require(all(turn(way_of(parts.edges[s]), way_of(parts.edges[t])) for s, t in zip(going, going[1:])), "valid",
                "edges go on along one line")
        steps.take(len(label), 1, 1)
        for s in here:
            del covers[s]
        for s in going:
            label = covers[s] = label ^ {parts.ring[s]}
            steps.take(len(label), 1, 1)
            require(fits(parts, label), "valid", "a ring is misplaced")
        for i, count in collections.Counter(parts.part[r] for r in at).items():
            require(rule == "valid" or count == 1, "valid", "two rings of a part touch")
            leaders = {leader(joined, r) for r in at if parts.part[r] == i} if count > 1 else {i}
            require(count == len(leaders), "valid", "rings close a circle")
            for r in leaders if count > 1 else ():
                joined[r] = min(leaders)
        seen.update(at)
    require(len(seen) == len(parts.part) and all(parts), "valid", "a ring is one point, or a part has none")


def edges_at(steps, name, parts, ring, point):
    """The edges of a ring that hold a point, which are of some length; there are some."""
    steps.take(4 * len(parts.rings[ring]), length(point), parts.edges.bits)
    place = projective([(n, d, e - parts.edges.exponent) for n, d, e in point])
    on = [parts.edges[k] for k in parts.rings[ring] if is_on(parts.edges[k], place)]
    on = [edge for edge in on if edge[0] != edge[1]]
    require(on, name, "the point is not on ring %d" % ring)
    return on, place


def too_few_points(steps, claim, parts, ring):
    steps.take(2 * len(parts.rings[ring]), parts.edges.bits, 1)
    ends = {end for k in parts.rings[ring] for end in parts.edges[k]}
    require(len(ends) < 3, "too_few_points", "ring %d has three different vertices" % ring)


def comes_twice(steps, claim, parts, ring, point):
    """A ring comes to a point twice."""
    on, place = edges_at(steps, "comes_twice", parts, ring, point)
    require(sum(2 - ends_at(edge, place) for edge in on) > 2, "comes_twice", "the ring comes there once")


def misplaced(steps, claim, parts, ring, point):
    """On one side of a ring there are rings that do not fit."""
    _, place = edges_at(steps, "misplaced", parts, ring, point)
    label = set()
    for r, edges in enumerate(parts.rings):
        steps.take(4 * len(edges), length(point), parts.edges.bits)
        edges = [parts.edges[k] for k in edges]
        require(r == ring or not any(is_on(edge, place) for edge in edges), "misplaced", "the point is on ring %d, too" % r)
        label |= {r} if r != ring and above_odd(edges, place) else set()
    require(not fits(parts, label) or not fits(parts, label | {ring}), "misplaced", "rings fit there")


def circle(steps, claim, parts, rings, points):
    """Rings of one part that touch, each the next and the last the first, in different points."""
    require(len({parts.part[r] for r in rings}) == 1, "circle", "the rings are of different parts")
    places = set()
    for r, q, point in zip(rings, rings[1:] + rings[:1], points):
        for ring in (r, q):
            x, y, w = edges_at(steps, "circle", parts, ring, point)[1]
        places.add((fractions.Fraction(x, w), fractions.Fraction(y, w)))
    require(len(places) == len(rings), "circle", "a point stands twice")


def repeated(steps, claim, parts, rule, edge):
    require(rule == "simple", "repeated", "vertices may be repeated")
    require(parts.edges[edge][0] == parts.edges[edge][1], "repeated", "the edge is of some length")


def rings_touch(steps, claim, parts, rule, ring, other, point):
    require(rule == "simple" and ring != other and parts.part[ring] == parts.part[other], "rings_touch", "these may touch")
    for r in (ring, other):
        edges_at(steps, "rings_touch", parts, r, point)


# ---- Lists: of segments that meet, and of polygons.

def all_contacts(steps, claim, table, groups, allowed):
    return (pairs_of if isinstance(table, Polygons) else contacts_of)(steps, claim, table, groups, allowed)


def none_counts(steps, claim, table, groups, allowed):
    for contact_found in all_contacts(steps, claim, table, groups, allowed):
        require(False, "none_counts", "%d and %d have a contact that counts" % contact_found[:2])


def these_count(steps, claim, table, groups, allowed, contacts):
    """The contacts that count are those listed."""
    left = {(i, j): kind for i, j, *kind in contacts}
    for i, j, *kind in all_contacts(steps, claim, table, groups, allowed):
        require(left.pop((i, j), None) == kind, "these_count", "the contact of %d and %d is not listed as it is" % (i, j))
    for pair in left:
        require(False, "these_count", "%d and %d have no contact that counts" % pair)


def number_counts(steps, claim, table, groups, allowed, number):
    """So many contacts count."""
    found = sum(1 for _ in all_contacts(steps, claim, table, groups, allowed))
    require(found == number, "number_counts", "%d contacts count" % found)
