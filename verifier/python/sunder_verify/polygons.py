"""The rules about polygons, and about lists of what meets: docs/claims.md, "Polygons", "Valid polygons"."""
import collections
import fractions
import itertools

from .arcs import Way
from .reader import length, projective, require
from .rules import (before, contacts_by_cover, contacts_of_segments, ends_at, is_on, lines_of, number_of_segments, side,
                    sweep)
from .tables import Polygons, Segments, around


# ---- Polygons: their edges, and what is above an odd number of them.

def labelled(steps, events, edges, owner):
    """A sweep of edges, by lines of what goes on. Labels are sets of owners: of those that cover what is just below the
    first edge that goes on, and what is just above each."""
    above = {-1: frozenset()}  # the label above each edge in the list
    for point, below, here, row in sweep(steps, events, edges):
        lines, labels = lines_of(edges, row), [above[below]]
        steps.take(2 * len(labels[0]), 1, 1)
        for s in here:
            del above[s]
        for s in itertools.chain(*lines):
            above[s] = labels[-1] ^ {owner[s]}
            labels.append(above[s])
            steps.take(2 * len(above[s]), 1, 1)
        yield point, below, here, row, lines, labels


def cells(steps, events, polygons, allowed):
    """Gives pairs of sets: each polygon of the first has common points that count with each of the second. Any two that
    have some are in one of these pairs."""
    owner, flat = polygons.owner, polygons.flat
    for point, _, here, row, lines, labels in labelled(steps, events, polygons.edges, owner):
        at, label, k = {owner[s] for s in here + row}, labels[0], 0
        passing = {owner[s] for s in here + row if not ends_at(polygons.edges[s], point)}
        if not allowed:
            yield at, at | label
        elif "touch" not in allowed:
            yield passing, at | label
            yield at, label - at
        else:
            within = {i for i in at & flat if i in passing or polygons.is_point(i)}
            yield within, within | (label - at)
        for line in lines if allowed else ():
            border, lower, upper = {owner[s] for s in line}, labels[k], labels[k + len(line)]
            if "touch" in allowed:
                yield upper & at, upper
                yield border & flat, border & flat | (lower - border)
            else:
                yield border, border | lower
            k += len(line)


def contacts_of_polygons(steps, events, polygons, groups, allowed):
    """Gives (i, j), i < j, once for each two polygons of different groups that have a common point that counts."""
    found, size = set(), len(polygons)
    for first, second in cells(steps, events, polygons, allowed):
        if not first:
            continue
        members = {}
        for j in sorted(second):
            members.setdefault(groups[j], []).append(j)
        for i in sorted(first):
            others = [j for group in sorted(members) if group != groups[i] for j in members[group]]
            steps.take(len(members) + len(others), 1, 1)
            for j in others:
                pair = min(i, j) * size + max(i, j)
                if pair not in found:
                    steps.take(8, 1, 1)
                    found.add(pair)
                    yield min(i, j), max(i, j)


def kinds_of_polygons(steps, events, polygons, groups, allowed):
    """The same, with how they meet."""
    overlapping = {*contacts_of_polygons(steps, events, polygons, groups, ("touch",))}
    for pair in contacts_of_polygons(steps, events, polygons, groups, allowed):
        yield *pair, "overlapping" if pair in overlapping else "touching"


def kinds_count(steps, events, polygons, groups, allowed, overlapping, touching):
    """So many have common points that count: so many of them inside of both, the others none."""
    number = collections.Counter(kind for *_, kind in kinds_of_polygons(steps, events, polygons, groups, allowed))
    is_so = (number["overlapping"], number["touching"]) == (overlapping, touching)
    require(is_so, "kinds_count", "%d of %d contacts are inside of both" % (number["overlapping"], sum(number.values())))


def how_two_meet(steps, events, pair, verdict):
    """Two polygons have no common points, or some inside of both, or others."""
    found = [kind for *_, kind in kinds_of_polygons(steps, events, pair, range(2), ())] or ["apart"]
    require(found == [verdict], "how_two_meet", "they are " + found[0])


def near(steps, polygons, ring, size, place):
    """Of a ring the edges, by number, of which some part may be at a point (place, of so many bits), or below it."""
    x, y, w = place
    blocks = polygons.blocks[ring]
    steps.take(len(blocks) + 4, size, polygons.edges.bits)
    some = [k for left, right, low, begin, end in blocks if left * w <= x <= right * w and low * w <= y
            for k in range(begin, end)]
    steps.take(4 * len(some), size, polygons.edges.bits)
    return some


def edges_at(polygons, some, place):
    return [k for k in some if is_on(polygons.edges[k], place)]


def above_odd(polygons, some, place):
    """Is the point above an odd number of edges?"""
    edges = (polygons.edges[k] for k in some)
    return sum(not before(place, (*first, 1)) and before(place, (*last, 1)) and side((first, last), place) > 0
               for first, last in edges) % 2 == 1


def common_point(steps, polygons, i, j, point, groups, allowed):
    """Two polygons of different groups hold a point, which counts."""
    require(groups[i] != groups[j], "common_point", "%d and %d are of one group" % (i, j))
    inside, touched, passed, place = 0, 0, False, projective(point, polygons.edges.exponent)
    for k in (i, j):
        some = [e for ring in polygons.rings_of[k] for e in near(steps, polygons, ring, length(point), place)]
        on = edges_at(polygons, some, place)
        require(on or above_odd(polygons, some, place), "common_point", "the point is not in polygon %d" % k)
        passes = not all(ends_at(polygons.edges[e], place) for e in on)
        inside += not on or (k in polygons.flat and (passes or polygons.is_point(k)))
        touched, passed = touched + bool(on), passed or passes
    if "touch" in allowed:
        require(inside == 2, "common_point", "the point is not inside of both")
    elif allowed:
        require(touched < 2 or passed, "common_point", "all edges of both end at the point")


# ---- Valid polygons: some polygons as parts of one, and what is wrong with them.

SELF_TOUCH = "valid-with-self-touch"  # the rule that allows rings to touch themselves


def filled(parts, label):
    """Of which parts the label has the shell, and no hole."""
    rings = collections.Counter(parts.part[r] for r in label)
    return [i for i, n in rings.items() if n == 1 and parts.shell[i] in label]


def fits(parts, label):
    """May all these rings have a common point inside? In each part its shell, and one hole; one shell without."""
    rings = collections.Counter(parts.part[r] for r in label)
    return all(n <= 2 and parts.shell[i] in label for i, n in rings.items()) and len(filled(parts, label)) <= 1


def leader(joined, k):
    while joined[k] != k:
        joined[k] = k = joined[joined[k]]
    return k


def regions(steps, events, parts, pieces):
    """A sweep of the edges, with labels of rings. Counts in how many pieces the inside of each part is: in the end,
    or what has been seen of it."""
    face, joined = {-1: 0}, [0]  # of what is above each edge of the list; faces that turn out to be one
    for _, below, here, row, lines, labels in labelled(steps, events, parts.edges, parts.ring):
        going, lower = [*itertools.chain(*lines)], face[below]
        upper = face[here[-1]] if here else lower
        for s, label in zip(going[:-1], labels[1:]):
            face[s] = len(joined)
            joined.append(len(joined))
            pieces.update(filled(parts, label))
        if going:
            face[going[-1]] = upper
        elif leader(joined, lower) != leader(joined, upper):
            joined[leader(joined, upper)] = leader(joined, lower)
            pieces.subtract(filled(parts, labels[0]))
        yield here, row, lines, labels[1:]


def is_nested(parts, ways):
    """Of the edges around a point, one that passes twice: does each way of a ring through it have, on either side, all
    of another one, or nothing?"""
    begun = []
    for s in ways:
        if begun and (begun[-1] == s or begun[-1] in parts.beside[s]):
            begun.pop()
        else:
            begun.append(s)
    return not begun


def valid(steps, events, parts, rule):
    """Rings are simple, or touch themselves, have no pieces in common, and each part is the inside of its first ring
    without the others, which are holes side by side; it hangs together, and no other part is in it."""
    seen, pieces = set(), collections.Counter()
    for here, row, lines, labels in regions(steps, events, parts, pieces):
        going = [s for line in lines for s in line]
        require(rule != "simple" or len(going) == len(row), "valid", "a vertex is repeated")
        at = collections.Counter(parts.ring[s] for s in here + going)
        require(rule == SELF_TOUCH or all(n == 2 for n in at.values()), "valid", "a ring comes twice to a point")
        require(len(going) == len(lines), "valid", "edges go on along one line")
        require(rule != SELF_TOUCH or is_nested(parts, going + here[::-1]), "valid", "a ring crosses itself")
        require(all(fits(parts, label) for label in labels), "valid", "a ring is misplaced")
        is_alone = len({parts.part[r] for r in at}) == len(at)
        require(rule != "simple" or is_alone, "valid", "two rings of a part touch")
        seen.update(at)
    require(len(seen) == len(parts.part) and all(parts), "valid", "a ring is one point, or a part has none")
    require(all(pieces[i] == 1 for i in range(len(parts))), "valid", "a part falls apart")


def falls_apart(steps, events, parts):
    """The inside of a part is in two pieces or more."""
    pieces = collections.Counter()
    for _, _, lines, _ in regions(steps, events, parts, pieces):
        require(all(len(line) == 1 for line in lines), "falls_apart", "edges go on along one line")
    require(max(pieces.values(), default=0) > 1, "falls_apart", "no part falls apart")


def ring_at(steps, rule, parts, ring, point):
    """The edges of a ring, of some length, that hold a point, by number; there are some. And the point as x, y, w."""
    place = projective(point, parts.edges.exponent)
    on = edges_at(parts, near(steps, parts, ring, length(point), place), place)
    on = [k for k in on if parts.edges[k][0] != parts.edges[k][1]]
    require(on, rule, "the point is not on ring %d" % ring)
    return on, place


def too_few_points(steps, parts, ring):
    steps.take(2 * len(parts.rings[ring]), parts.edges.bits, 1)
    vertices = set(itertools.chain(*parts.rings[ring]))
    require(len(vertices) < 3, "too_few_points", "ring %d has three different vertices" % ring)


def comes_twice(steps, parts, rule, ring, point):
    """A ring comes to a point twice, and may not."""
    require(rule != SELF_TOUCH, "comes_twice", "a ring may touch itself")
    on, place = ring_at(steps, "comes_twice", parts, ring, point)
    require(sum(2 - ends_at(parts.edges[k], place) for k in on) > 2, "comes_twice", "the ring comes there once")


def crosses(steps, parts, ring, point):
    """A ring crosses itself: of two of its ways through the point, each has an end of the other one on either side."""
    (on, (x, y, w)), ways = ring_at(steps, "crosses", parts, ring, point), []
    for s in on:
        ways += [((p * w - x, q * w - y), s) for p, q in parts.edges[s] if (p * w, q * w) != (x, y)]
    steps.take(32 * len(ways), length(point) + parts.edges.bits, length(point) + parts.edges.bits)
    ways.sort(key=lambda way: Way(way[0], (0, 0), 0))
    require(not is_nested(parts, [s for _, s in ways]), "crosses", "the ring does not cross itself there")


def misplaced(steps, parts, ring, point):
    """On one side of a ring there are rings that do not fit. Two holes of one part are enough."""
    label, size, place = set(), length(point), ring_at(steps, "misplaced", parts, ring, point)[1]
    holes = {parts.part[r] for r in [ring] if r != parts.shell[parts.part[r]]}  # their parts
    for r, part in enumerate(parts.part):
        if r == ring:
            continue
        some = near(steps, parts, r, size, place)
        require(not some or not edges_at(parts, some, place), "misplaced", "the point is on ring %d, too" % r)
        if some and above_odd(parts, some, place):
            if r != parts.shell[part] and part in holes:
                return
            label.add(r)
            holes |= {part} if r != parts.shell[part] else set()
    require(not fits(parts, label) or not fits(parts, label | {ring}), "misplaced", "rings fit there")


def circle(steps, parts, rings, points):
    """Rings of one part that touch, each the next and the last the first, in different points."""
    require(len({parts.part[r] for r in rings}) == 1, "circle", "the rings are of different parts")
    places = set()
    for touching, point in zip(around(rings), points):
        steps.take(32, length(point), length(point))
        for ring in touching:
            x, y, w = ring_at(steps, "circle", parts, ring, point)[1]
        places.add((fractions.Fraction(x, w), fractions.Fraction(y, w)))
    require(len(places) == len(rings), "circle", "a point is listed twice")


def repeated(steps, parts, rule, edge):
    first, last = parts.edges[edge]
    require(rule == "simple", "repeated", "vertices may be repeated")
    require(first == last, "repeated", "the edge is of some length")


def rings_touch(steps, parts, rule, ring, other, point):
    may_touch = rule != "simple" or ring == other or parts.part[ring] != parts.part[other]
    require(not may_touch, "rings_touch", "these may touch")
    for r in (ring, other):
        ring_at(steps, "rings_touch", parts, r, point)


# ---- Lists of what meets.

CONTACTS = {Segments: contacts_of_segments, Polygons: contacts_of_polygons}  # of others by a cover
NUMBER = {Segments: number_of_segments}  # of others the contacts are counted


def exactly(rule, finder=None):
    """The rule that the contacts that count are those wanted, which may be none, or are so many."""
    def check(steps, evidence, table, groups, allowed, wanted=()):
        told = steps, evidence, table, groups, allowed
        contacts_of = finder or CONTACTS.get(type(table), contacts_by_cover)
        if type(wanted) is int:
            number = NUMBER[type(table)](*told) if type(table) in NUMBER else sum(1 for _ in contacts_of(*told))
            require(number == wanted, rule, "%d contacts count" % number)
            return
        left = {(i, j): kind for i, j, *kind in wanted}
        for i, j, *kind in contacts_of(*told):
            is_listed = left.pop((i, j), None) == kind
            require(is_listed, rule, "%d and %d have a contact that counts, and is not listed" % (i, j))
        for pair in left:
            require(False, rule, "%d and %d have no contact that counts" % pair)
    return check
