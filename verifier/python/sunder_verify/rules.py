"""The rules by which claims are checked: docs/claims.md, "Rules". They know tables and claims, and no question.

All arithmetic is on integers. A point is x, ..., w with w > 0, for (x / w, ...), a direction likewise with w = 0;
points of a table have w = 1, and are in units of a power of two. A rule is told the steps that it may take, what the
claim brings, if anything, and what it is bound to.
"""
# long because: the rules are one list, in the order of docs/claims.md
import collections
import itertools
import math

from .linear import Basis, aligned, mean_of, sign, sign_of, way_between, weighted_sum
from .reader import Refused, bits, common, length, projective, require
from .tables import Boxes, Discs, Segments, dot, goes_round_once, turn


# ---- Convex objects: the convex hull of points, and the ways from there that go on for ever, or what is around it.

def reach(steps, body, d):
    """How far a body goes along a direction: the furthest of some n * 2^e + sqrt(u), as n, e and the number u, which is
    not negative; and is all of it as far? None where a way leads on along it."""
    points, ways, e = body.forms(steps, d)
    if any(n > 0 for n in ways):
        return None
    spread = body.spread(d)
    is_flat = min(points) == max(points) and not any(ways) and not spread[0]
    if body.kind == "cone":
        return [(points[0], e, spread), (points[1], e, (0, 1, 0))], is_flat
    return [(max(points), e, spread)], is_flat


def is_behind(steps, body, d, place):
    """Is none of a body further along a direction than the point x, .., w?"""
    found, w = reach(steps, body, d), place[-1]
    if found is None:
        return False
    for n, e, (square, whole, k) in found[0]:
        last, limit = aligned(n * w, e, dot(d, place), 0)
        (left, right), _, _ = common([((limit - last) ** 2, w * w, 2 * min(e, 0)), (square, whole, k)])
        if limit < last or left < right:
            return False
    return True


def beyond(steps, rule, end, d, body, least):
    """Along a direction, which is not zero, all of a body is further than n * 2^e, and by a length, if that is not 0, in units of
    that of the direction. end: n, e, and the bits of what that is made of."""
    require(any(d), rule, "a direction is zero")
    found, (last, e, bits_of_end) = reach(steps, body, [-n for n in d]), end
    require(found, rule, "a way of %s goes on along the direction" % body.name)
    size = bits(d) + body.size + bits_of_end + length([least])
    if body.kind or least[0]:
        steps.take(16, size, size)
    for n, f, u in found[0]:
        begin, ends = aligned(-n, f, last, e)
        order = sign(begin - ends)
        if u[0] or least[0]:  # sqrt(between) - sqrt(u) - the length
            square = (least[0] ** 2 * dot(d, d), 1, 2 * least[2]) if least[0] else least
            (between, *roots), _, _ = common([((begin - ends) ** 2, 1, 2 * min(e, f)), u, square])
            order = sign_of((((0, order), (-1, 0)), ((-1, 0), (0, 0))), between, *roots)
        require(order > 0 or least[0] and order == 0, rule, "%s does not begin far enough beyond a part, along its direction" % body.name)


def gap(steps, rule, d, a, b, length_of=(0, 1, 0), way=-1):
    """The sign of how much further B begins along a direction than A ends, less a length (way 1: and the length), which
    is in units of that of the direction; and is all of both just as far along it?"""
    found = reach(steps, a, d), reach(steps, b, [-n for n in d])
    for body, ends in zip((a, b), found):
        require(ends, rule, "a way of %s goes on along the direction" % body.name)
    (of_a, is_flat), (of_b, is_flat_too) = found
    square = (length_of[0] ** 2 * dot(d, d), 1, 2 * length_of[2]) if length_of[0] else length_of
    size, signs = bits(d) + a.size + b.size + length([length_of]), []
    for (m, e, u), (n, f, v) in itertools.product(of_a, of_b):
        last, first = aligned(m, e, -n, f)
        if a.kind or b.kind or way > 0:
            steps.take(16, size, size)
        (between, *roots), _, _ = common([((first - last) ** 2, 1, 2 * min(e, f)), u, v, square])
        if any(roots):  # sqrt(between) - sqrt(u) - sqrt(v) + way sqrt(square)
            signs.append(sign_of(((((0, sign(first - last)), (-1, 0)), ((-1, 0), (0, 0))),
                                  (((way, 0), (0, 0)), ((0, 0), (0, 0)))), between, *roots))
        else:
            signs.append(sign(first - last))
    return min(signs), is_flat and is_flat_too


def parted(steps, direction, a, b, is_weak=False):
    """A is strictly less far along a direction than B; if is_weak, nowhere further, and not all of both just as far."""
    further, is_flat = gap(steps, "parted", common(direction)[0], a, b)  # along a positive multiple of the direction
    require(further > 0 or (is_weak and further == 0), "parted", "%s is not %sless far along the direction than %s" % (
        a.name, "" if is_weak else "strictly ", b.name))
    require(further > 0 or not is_flat, "parted", "all of %s and %s is as far along the direction" % (a.name, b.name))


def ends_between(steps, rule, d, a, b, p, q, words):
    """Along a direction nothing of A is beyond the point p, nothing of B before q; points are x, .., w."""
    for body, way, place in (a, d, p), (b, [-n for n in d], q):
        require(is_behind(steps, body, way, place), rule, body.name + words)


def slab(steps, a, b, from_a, to_b):
    """Along the way from a point of A to one of B, nothing of A is beyond the first, nothing of B before the second."""
    p, q = projective(from_a), projective(to_b)
    d = way_between(p, q)
    require(any(d), "slab", "the two points are the same")
    ends_between(steps, "slab", d, a, b, p, q, " extends beyond its point along the direction")


def clear(steps, direction, a, b, far, rule="clear", way=-1, words="are less far apart than stated"):
    """From A to B it is so far along a direction, in units of its length; or, with way = 1, so far back."""
    d = common(direction)[0]
    further, _ = gap(steps, rule, d, a, b, far, way)
    require(any(d) and further >= 0, rule, "along the direction they " + words)


def line_of(steps, rule, body):
    """A body is more than a point, and on one line: along this, as it is not placed."""
    steps.take(4 * body.dimension * len(body), 2 * body.bits, 2 * body.bits)
    ways = [[x - y * (k < body.count) for x, y in zip(row, body.rows[0])] for k, row in enumerate(body.rows)]
    way = max(ways, key=any)
    axis = next((c for c, x in enumerate(way) if x), 0)
    is_line = any(way) and all(way[axis] * x == other[axis] * y for other in ways for x, y in zip(other, way))
    require(is_line, rule, "%s is " % body.name + ("not on one line" if any(way) else "a point"))
    return way


def no_further(steps, before, after, a, b, first, last):
    """B is on a line; along it, one of A and B ends at the first point one way, and at the last point the other way."""
    way, sides = line_of(steps, "no_further", b), []
    for direction, point in (before, first), (after, last):
        d, place = common(direction)[0], projective(point)
        is_end = is_behind(steps, a, d, place) or is_behind(steps, b, d, place)
        require(is_end, "no_further", "both go on beyond a point")
        sides.append(sign(dot(d, b.turn(way))))
    require(sides[0] * sides[1] < 0, "no_further", "the directions are not along %s, to either side" % b.name)


def first_along(steps, direction, a, b, i):
    """Along a direction A begins at its point i; B is the flat across it, or the half of space up to there, and ends
    before A, if it ends."""
    d = common(direction)[0]
    (points, _, e), (ends, ways, f) = a.forms(steps, d), b.forms(steps, d)
    steps.take(4 * a.dimension ** 2 * len(ways), 2 * b.bits, 2 * b.bits)
    level = {tuple(x // math.gcd(*row) for x in row) for row, n in zip(b.rows[b.count:], ways) if n == 0 and any(row)}
    is_across = all(tuple(-x for x in way) in level for way in level) and all(n <= 0 for n in ways)
    turned = Basis(a.dimension, map(b.turn, level))
    require(any(d) and is_across and len(turned.rows) == a.dimension - 1, "first_along",
            "%s is not all that is across the direction, or up to there" % b.name)
    last, first = aligned(max(ends), f, min(points), e)
    require(min(ways, default=0) < 0 or last <= first, "first_along", "%s does not begin beyond %s" % (a.name, b.name))
    require(points[i] == min(points), "first_along", "%s begins before its point %d" % (a.name, i))


def sides_of_touched(steps, rule, direction, a, b, way, named):
    """All of B is across a direction, and A nowhere further along it: these points of A just as far, and no others. On
    which side of B is each of them, seen along the direction?"""
    d = common(direction)[0]
    (points, _, e), (level, ways, f) = a.forms(steps, d), b.forms(steps, d)
    require(any(d) and not any(ways) and min(level) == max(level), rule, "%s is not across the direction" % b.name)
    orders = [sign(n - m) for n, m in (aligned(n, e, level[0], f) for n in points)]
    require(max(orders) <= 0, rule, "%s is further along the direction than %s" % (a.name, b.name))
    touched = [k for k, order in enumerate(orders) if order == 0]
    require(touched == named, rule, "the points of %s that are as far as %s are others" % (a.name, b.name))
    (x, y, z), (u, v, w) = d, b.turn(way)
    beside = [y * w - z * v, z * u - x * w, x * v - y * u]
    (points, _, e), (level, _, f) = a.forms(steps, beside), b.forms(steps, beside)
    return [sign(n - m) for n, m in (aligned(points[k], e, level[0], f) for k in touched)]


def wedge(steps, before, after, a, b, on_first, on_last):
    """Two planes through B, which is on a line, have all of A on one side, and a point of it beside the line."""
    way = line_of(steps, "wedge", b)
    for direction, named in (before, on_first), (after, on_last):
        require(any(sides_of_touched(steps, "wedge", direction, a, b, way, named)), "wedge",
                "no point of %s that is as far as %s is beside its line" % (a.name, b.name))
    (x, y, z), (u, v, w) = common(before)[0], common(after)[0]
    require((y * w, z * u, x * v) != (z * v, x * w, y * u), "wedge", "the directions are parallel")


def rests(steps, direction, a, b, on_plane):
    """A plane through B, which is on a line, has all of A on one side, and points of it on both sides of the line."""
    sides = sides_of_touched(steps, "rests", direction, a, b, line_of(steps, "rests", b), on_plane)
    require({-1, 1} <= set(sides), "rests",
            "the points of %s that are as far as %s are not on both sides of its line" % (a.name, b.name))


def full(steps, i, j, k, l, body):
    """Four points of a body in space are not in one plane."""
    steps.take(16, body.size, body.size)
    ways = [body.turn([x - y for x, y in zip(body.rows[to], body.rows[i])]) for to in (j, k, l)]
    require(len(Basis(3, ways).rows) == 3, "full", "the four points of %s are in one plane" % body.name)


def nearer(steps, from_a, to_b, least):
    """Two points are less far apart."""
    steps.take(16, length(from_a) + length(to_b), length(from_a) + length(to_b))
    (n, _, unit), p, q = least, projective(from_a), projective(to_b)
    way = way_between(p, q)
    square, limit = aligned(dot(way, way), 0, (n * p[-1] * q[-1]) ** 2, 2 * unit)
    require(square < limit, "nearer", "the points are not nearer than the stated distance")


def holds(steps, weights, origin, body, point):
    """A body holds a point: a convex combination of its points, and a combination of its ways; or, with a radius, what is
    around such a point. Is it then nearer than the radius? origin: where a point of an ellipsoid comes from."""
    mean, d, e = mean_of(steps, "holds", weights, body, body.core if origin else body.image)
    if not body.kind:
        for axis, (m, (n, denominator, k)) in enumerate(zip(mean, point)):
            m, wanted = aligned(m * denominator, e, n * d, k)
            require(m == wanted, "holds", "the weighted sum of the points of %s differs from the stated point in coordinate %d" % (body.name, axis))
        return False
    size = body.size + length(point) + length(origin or []) + length([weight for _, weight in weights])
    steps.take(8, size, size)
    if origin:
        v, whole, k = common(origin)
        for v, t, (n, denominator, f) in zip(body.turn(v), body.translation, point):
            values = (v, whole, k + body.turned), (t, 1, body.moved), (-n, denominator, f)
            require(sum(common(values)[0]) == 0, "holds", "the point of %s comes from elsewhere" % body.name)
    (r, _, f), (share, whole, k) = body.radius, (1, 1, 0)
    if body.kind == "cone":
        share, whole, k = dict(weights).get(0, (0, 1, 0))
    values = [(n * d, denominator, k) for n, denominator, k in origin or point] + [(m, 1, e) for m in mean]
    (*values, radius), _, _ = common([*values, (r * share * d, whole, f + k)])
    way = [x - y for x, y in zip(values[:3], values[3:])]
    require(dot(way, body.axis) == 0, "holds", "the offset of the point from the axis is not perpendicular to the axis of %s" % body.name)
    require(dot(way, way) <= radius ** 2, "holds", "the point is outside of %s" % body.name)
    return dot(way, way) < radius ** 2


def inside(steps, weights, origin, body, point):
    """A body holds a point in its relative interior: what has a positive weight spans as much as the body does; or it
    is nearer than the radius, and not beside an end of an axis."""
    is_nearer = holds(steps, weights, origin, body, point)
    named = [k for k, (n, _, _) in weights if n > 0]
    if body.radius[0]:
        is_inner = is_nearer and (not body.axis or len(named) == 2)
        require(is_inner, "inside", "the point is on the boundary of " + body.name)
        return
    steps.take(body.dimension * len(body), 4 * body.bits, 4 * body.bits)
    basis = Basis(body.dimension + 1)  # of rows 1, x, ... of points and 0, x, ... of ways
    for k in (*named, *range(len(body))):
        if len(basis.rows) > body.dimension:
            break
        is_new = basis.take((int(k < body.count), *body.rows[k]))
        require(k in named or not is_new, "inside", "the points with a positive weight do not span %s" % body.name)


def moved_back(steps, point, time, body, to):
    """A point, less how far a body that moves straight to another place has come by then."""
    size = length(point) + length([time]) + body.size + to.size
    steps.take(16, size, size)
    (n, d, e), result = time, []
    for axis, p in enumerate(point):
        parts, whole, unit = common([p, *((way * n * place.translation[axis], d, e + place.moved)
                                          for place, way in ((body, 1), (to, -1)) if place.linear)])
        result.append((sum(parts), whole, unit))
    return result


def parted_all_along(steps, direction, a, b, to_a, to_b):
    """A direction parts A and B at both ends of their ways."""
    parted(steps, direction, a, b)
    parted(steps, direction, to_a, to_b)


def holds_at(steps, weights, origin, body, to, time, point):
    """A body on its way holds a point at that time."""
    holds(steps, weights, origin, body, moved_back(steps, point, time, body, to))


def not_before(steps, direction, a, b, to_a, to_b, time, point):
    """Along a direction, where A and B have the point at that time, A ends and B begins; and they come nearer."""
    d = common(direction)[0]
    p, q = (projective(moved_back(steps, point, time, body, to)) for body, to in ((a, to_a), (b, to_b)))
    ends_between(steps, "not_before", d, a, b, p, q, " extends beyond the point")
    require(dot(d, way_between(p, q)) > 0, "not_before", "along the direction %s and %s do not come nearer" % (a.name, b.name))


def look_at_each(steps, rule, members, groups, besides, listed, looks, known_of, counts, others):
    """Of each two members of different groups, but for some, what is known has a word that counts if they are listed,
    and one of the others if not."""
    besides, left, of_group = {*map(tuple, besides)}, {*map(tuple, listed)}, {}
    for i, group in zip(range(len(members)), groups):
        of_group.setdefault(group, []).append(i)
    for first, second in itertools.combinations([those for _, those in sorted(of_group.items())], 2):
        for pair in itertools.product(first, second):
            steps.take(looks, 1, 1)
            pair = tuple(sorted(pair))
            if pair not in besides:
                require(known_of(*pair) & (counts if pair in left else others), rule, "of %d and %d this is not proved before" % pair)
                left.discard(pair)
    require(not left, rule, "a pair is listed that is not asked about")


def known_of_members(rule, members, as_meshes, proved, questions, of_hulls, least=None):
    """What statements before say of two members: of two bodies; of two meshes; of a mesh and a body. That word carries over
    to meshes from bodies, which hold them. And how often it is looked for."""
    def stated(question, a, b):
        return proved.get((question, a, b, least), set())

    def known(i, j):
        (a, b), (p, q) = (members[i], members[j]), (as_meshes[i], as_meshes[j])
        words = stated(questions[0], a, b) | stated(questions[0], b, a)
        if p and q:
            return words & {of_hulls} | stated(questions[1], p[0], q[0]) | stated(questions[1], q[0], p[0])
        if p or q:
            return words & {of_hulls} | stated(questions[2], (p or q)[0], b if p else a)
        return words
    for k, mesh in enumerate(as_meshes or ()):
        require(not mesh or ("around", *mesh[1:], None) in proved, rule, "that member %d holds its mesh is not proved before" % k)
    looks = 12 if any(as_meshes or ()) else 4
    as_meshes = as_meshes or [None] * len(members)
    return looks, known


def each_pair(steps, members, groups, besides, allowed, as_meshes, proved, contacts):
    """Of each two members of different groups, but for some, a statement before tells whether they meet; these do."""
    known = known_of_members("each_pair", members, as_meshes, proved, ("pair", "meshes", "mesh_body"), "apart")
    meet = {"meet", "touching", "overlapping", "a_within", "b_within", "a_inside_b", "b_inside_a"}
    look_at_each(steps, "each_pair", members, groups, besides, contacts, *known, {"overlapping"} if allowed else meet,
                 {"apart", "touching"} if allowed else {"apart"})


def each_clearance(steps, members, groups, besides, least, as_meshes, proved, nearer=()):
    """Likewise, a statement before tells whether they are so far apart; these are not."""
    questions = "clearance", "mesh_clearance", "mesh_body_clearance"
    known = known_of_members("each_clearance", members, as_meshes, proved, questions, "kept", least)
    look_at_each(steps, "each_clearance", members, groups, besides, nearer, *known, {"broken", "a_within", "b_within"}, {"kept"})


# ---- Linear constraints: half-planes a x + b y <= c as integers (a, b, c, exponent of all three).

def excess(h, place):
    """Positive: the point x, y, w is outside, or the direction leads there; zero: it is on the line, or along it."""
    return h[0] * place[0] + h[1] * place[1] - h[2] * place[2]


def require_kept(steps, given, place, rule, reason):
    """All hold the point, or go on along the direction."""
    steps.take(2 * len(given), bits(place), max((bits(h[:3]) for h in given), default=0))
    for i, h in enumerate(given):
        require(excess(h, place) <= 0, rule, reason % i)


def feasible(steps, given, point):
    """The point keeps all constraints."""
    require_kept(steps, given, projective(point), "feasible", "the point is outside of half-plane %d")


def bounds(steps, weights, given, objective, point, is_only=False):
    """No common point is further along the objective than the point, and, where is_only, no other one as far."""
    (a, b, _), _, _ = weighted_sum(steps, weights, given.__getitem__)
    up, place = common(objective)[0], projective(point)
    require(turn((a, b), up) == 0 < dot((a, b), up), "bounds", "the weighted normals are not the objective")
    for k, _ in weights:
        require(excess(given[k], place) == 0, "bounds", "the point is not on the line of half-plane %d" % k)
    is_corner = any(turn(given[weights[0][0]], given[k]) for k, _ in weights)
    require(is_corner or not is_only, "bounds", "the lines at the point coincide")


def no_objective(steps, given, objective):
    """No point is further than another."""
    require(not any(common(objective)[0]), "no_objective", "there is an objective")


def contradict(steps, weights, given):
    """No point keeps the named constraints."""
    (a, b, c), _, _ = weighted_sum(steps, weights, given.__getitem__)
    require(a == b == 0 > c, "contradict", "the weighted constraints have a common point")


def goes_on(steps, direction, given, objective):
    """Along a direction no constraint is left; and it leads further along the objective."""
    way = (*common(direction)[0], 0)
    require(dot(common(objective)[0], way) > 0, "goes_on", "the direction does not lead further along the objective")
    require_kept(steps, given, way, "goes_on", "the direction leaves half-plane %d")


def ends(steps, given_ends, given, objective, point):
    """All that is as far along the objective as the point, on one line, is from the first to the second end, where
    these are; the second is to the left of the objective."""
    (p, q), (x, y, w), places = common(objective)[0], projective(point), []
    for way, end in zip(((q, -p, 0), (-q, p, 0)), given_ends):
        place = projective(end[0]) if end else way
        require_kept(steps, given, place, "ends", "an end is outside of half-plane %d" if end else
                     "there is an end, at half-plane %d, and it is not given")
        if end:
            h = given[end[1]]
            level = (p * w, q * w, p * x + q * y)
            require(excess(level, place) == 0, "ends", "an end is not as far along the objective")
            require(excess(h, place) == 0 < excess(h, way), "ends", "half-plane %d does not end it" % end[1])
            places.append(place)
    if len(places) == 2:
        (x, y, w), last = places
        require(excess((-q * w, p * w, p * y - q * x), last) > 0, "ends", "the two ends are the same point")


EXTENTS = {"point": 0, "segment": 2, "ray": 0}  # how many sides with a corner at each end are no point; else all
NUMBER = {"half-plane": 1, "line": 2, "strip": 2}  # of sides without corners


def turn_on(sides, verdict):
    """Does each side turn to the next, and the first to all but the last, which may be opposite, and is of a ray?"""
    if len(sides) < 2 or not all(turn(h, g) > 0 for h, g in zip(sides, sides[1:])):
        return False
    whole = turn(sides[0], sides[-1])
    return (whole == 0 if verdict == "ray" else whole >= 0) and all(turn(sides[0], h) > 0 for h in sides[1:-1])


def corner(h, g):
    """The common point of the lines of two half-planes that turn; of one and itself, a point of its line."""
    if h is g:
        return h[0] * h[2], h[1] * h[2], dot(h[:2], h)
    return h[2] * g[1] - g[2] * h[1], h[0] * g[2] - g[0] * h[2], turn(h, g)


def cones(steps, corners_of, given, verdict, named):
    """The sides, counter-clockwise, bound a region of the kind, and each half-plane holds it."""
    sides, is_open = [given[k] for k in named], verdict in ("ray", "unbounded")
    n, after = len(sides), sides if verdict in NUMBER else sides[1:] + sides[:1]
    corners = [corner(h, g) for h, g in zip(sides, after)]
    if verdict in NUMBER:
        require(n == NUMBER[verdict], "sides", "there are %d sides" % n)
        if n == 2:
            gap = -excess(sides[1], corners[0])
            require(turn(*sides) == 0 > dot(sides[0][:2], sides[1]) and (gap == 0 if verdict == "line" else gap > 0),
                    "sides", "the sides are not opposite, or not as far apart as they must be")
    else:
        require(turn_on(sides, verdict) if is_open else goes_round_once(sides), "sides",
                "the sides do not turn as they must")
        side_ends = [excess(after[k], corners[k - 1]) for k in range(is_open, n - is_open)]
        extents = sum(end < 0 for end in side_ends)
        require(all(end <= 0 for end in side_ends) and extents == EXTENTS.get(verdict, len(side_ends)), "sides",
                "%d sides have a part of the boundary" % extents)
    for i, (h, p) in enumerate(zip(given, corners_of)):
        is_after = turn(sides[p], h) > 0 or turn(sides[p], h) == 0 < dot(sides[p][:2], h)
        require(is_after and turn(h, after[p]) >= 0, "cones", "half-plane %d does not face as between its sides" % i)
        require(excess(h, corners[p]) <= 0, "cones", "half-plane %d does not hold its corner" % i)


# ---- Segments: pairs of points, the lexicographically lesser one first.

KINDS = ("shared-endpoint", "touch", "crossing", "overlap")


def before(p, q):
    """Is p lexicographically before q?"""
    return (p[0] * q[2] - q[0] * p[2] or p[1] * q[2] - q[1] * p[2]) < 0


def side(segment, point):
    """Positive: the point x, y, w is above the segment's line: left of it, seen from its first end."""
    (ax, ay), (bx, by) = segment
    x, y, w = point
    return (bx - ax) * (y - ay * w) - (by - ay) * (x - ax * w)


def way_of(segment):
    (ax, ay), (bx, by) = segment
    return bx - ax, by - ay


def is_on(segment, point):
    first, last = segment
    return side(segment, point) == 0 and not before(point, (*first, 1)) and not before((*last, 1), point)


def is_at(point, end):
    x, y, w = point
    return x == end[0] * w and y == end[1] * w


def ends_at(segment, point):
    return is_at(point, segment[0]) or is_at(point, segment[1])


def kind_of(s, t, point):
    """How two segments meet that have this point in common."""
    if turn(way_of(s), way_of(t)) == 0 and max(s[0], t[0]) < min(s[1], t[1]):  # along a line points are in their order
        return "overlap"
    return KINDS[2 - ends_at(s, point) - ends_at(t, point)]


# ---- Discs: x, y, r.

DISC_KINDS = ("touching", "overlapping", "inside")


def power_of(disc, point):
    """Positive: the point x, y, w is outside."""
    x, y, w = point
    return (x - disc[0] * w) ** 2 + (y - disc[1] * w) ** 2 - (disc[2] * w) ** 2


def is_in(disc, point):
    return power_of(disc, point) <= 0


def kind_of_discs(c, d, point=None):
    """How two discs meet, or None."""
    distance, most, least = (c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2, (c[2] + d[2]) ** 2, (c[2] - d[2]) ** 2
    if distance >= most:
        return "touching" if distance == most else None
    return "overlapping" if distance > least else "inside"


def in_discs(steps, discs, point, verdict):
    """The point is in all discs; for a region, inside of all circles."""
    place = projective(point, discs.exponent)
    steps.take(4 * len(discs), length(point) + discs.bits, length(point) + discs.bits)
    for k, disc in enumerate(discs):
        is_within = power_of(disc, place) < (verdict == "point")
        require(is_within, "in_discs", "the point is not inside of circle %d" % k)


def powers(steps, weights, discs, verdict):
    """The weighted mean of the powers is positive everywhere, or, if there is a common point, zero there at least."""
    def row_of(k):
        x, y, r = discs[k]
        return 1, x, y, x * x + y * y - r * r, 0
    (total, x, y, rest), _, _ = weighted_sum(steps, weights, row_of)
    least = total * rest - x * x - y * y
    require(least > 0 or (least == 0 and verdict == "point"), "powers", "the mean of the powers is not as it must be")


# ---- Boxes: lowest x and y, highest x and y.

def is_in_box(box, point):
    x, y, w = point
    return box[0] * w <= x <= box[2] * w and box[1] * w <= y <= box[3] * w


def kind_of_boxes(a, b, point=None):
    """How two boxes meet, or None."""
    if any(a[k] > b[k + 2] or b[k] > a[k + 2] for k in (0, 1)):
        return None
    if any((a[k] == b[k + 2]) != (b[k] == a[k + 2]) for k in (0, 1)):  # both, where they are one number
        return "touching"
    part = max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])
    return "inside" if part in (tuple(a), tuple(b)) else "overlapping"


# ---- Contacts of two entries of a table. Those of one group do not count, nor do kinds that are allowed.

MEETING = {Segments: (is_on, kind_of, KINDS), Discs: (is_in, kind_of_discs, DISC_KINDS),
           Boxes: (is_in_box, kind_of_boxes, DISC_KINDS)}


def contact(steps, table, i, j, kind, point, groups, allowed):
    """Two entries of different groups hold a point, and the kind of their contact counts."""
    holds_point, kind_between, _ = MEETING[type(table)]
    place = projective(point, table.exponent)
    steps.take(16, length(point), table.bits)
    require(groups[i] != groups[j], "contact", "%d and %d are of one group" % (i, j))
    require(kind not in allowed, "contact", kind + " does not count")
    for k in (i, j):
        require(holds_point(table[k], place), "contact", "the point is not in %d" % k)
    found = kind_between(table[i], table[j], place)
    require(found == kind, "contact", "the contact is " + found)


class Node:
    """Of the tree over an order of a table: a range of it, its box, its group where it is one, and its halves."""

    def __init__(self, order, table, groups):
        self.first, self.halves = order[0], None
        if len(order) > 1:
            half = len(order) // 2
            self.halves = a, b = Node(order[:half], table, groups), Node(order[half:], table, groups)
            self.box = (*map(min, a.box[:2], b.box[:2]), *map(max, a.box[2:], b.box[2:]))
            self.group = a.group if a.group == b.group else None
        else:
            self.box, self.group = table.box(self.first), groups[self.first]
        self.length = max(self.box[2] - self.box[0], self.box[3] - self.box[1])


def contacts_by_cover(steps, order, table, groups, allowed):
    """Gives (i, j, kind), i < j, once for each two entries of different groups whose contact counts."""
    kind_between = MEETING[type(table)][1]
    root = order and Node(order, table, groups)
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
            kind = kind_between(table[i], table[j])
            if kind and kind not in allowed:
                yield i, j, kind


# ---- Sweeps: a list of segments from the lowest up, kept through events at points, lexicographically ordered.

def crossing_of(s, t):
    """The common point of two segments' lines, which are not parallel."""
    (ax, ay), u, v = s[0], way_of(s), way_of(t)
    across, along = turn(u, v), turn((t[0][0] - ax, t[0][1] - ay), v)
    if across < 0:
        across, along = -across, -along
    return ax * across + u[0] * along, ay * across + u[1] * along, across


def sweep(steps, events, segments):
    """Gives, point by point, which segment is just below, and which hold it: those that were in the list, from the
    lowest up, and those that go on from there. Between these points no two segments meet that did not meet at one."""
    above_of = {-1: -1}  # the list, as a ring: -1 stands below and above all
    begun, last = [False] * len(segments), None

    def must(condition, reason, *numbers):
        if not condition:
            raise Refused("sweep", "event %d" % k + reason % numbers)

    for k, (at, below, *row) in enumerate(events):
        if at >= 0:
            point = (*segments[at // 2][at % 2], 1)
        else:
            must(len(row) > 1 and turn(way_of(segments[row[0]]), way_of(segments[row[-1]])) != 0,
                 " has no point: its first and last segment do not cross")
            steps.take(len(row) + 4, 3 * segments.bits, 3 * segments.bits)
            point = crossing_of(segments[row[0]], segments[row[-1]])
        must(last is None or before(last, point), " is not after the one before it")
        last = point
        # What stands in the list at this point: all from `below` up that hold it.
        must(below in above_of, " is above a segment that is not in the list")
        must(below < 0 or side(segments[below], point) > 0, " is not above segment %d", below)
        here, upper, height = [], above_of[below], 0
        while upper >= 0 and (height := side(segments[upper], point)) == 0:
            here.append(upper)
            upper = above_of.pop(upper)
        must(upper < 0 or height < 0, " is not below segment %d", upper)
        stay = {s for s in here if not is_at(point, segments[s][1])}
        # What goes on from it, sorted by direction.
        lower = below
        for s in row:
            if s not in stay:
                must(not begun[s] and is_at(point, segments[s][0]),
                     ": segment %d is not in the list there, or does not begin there", s)
                begun[s] = True
            stay.discard(s)
            must(lower == below or turn(way_of(segments[lower]), way_of(segments[s])) >= 0,
                 ": segment %d does not go on above %d", s, lower)
            if segments[s][0] != segments[s][1]:
                above_of[lower] = s
                lower = s
        must(not stay, " loses a segment that goes on")
        above_of[lower] = upper
        yield point, below, here, row
    require(all(begun) and above_of[-1] == -1, "sweep", "not all segments begin and end")


def lines_of(segments, row):
    """Of some segments through a point, sorted by direction, those of some length: line by line."""
    lines = []
    for s in row:
        if segments[s][0] == segments[s][1]:
            continue
        if lines and turn(way_of(segments[lines[-1][-1]]), way_of(segments[s])) == 0:
            lines[-1].append(s)
        else:
            lines.append([s])
    return lines


class Meeting:
    """Segments in classes, of which two may have contacts if they are of different classes and groups, both of the
    second set, and one of the first, which is part of the second."""

    def __init__(self, classes, groups, first, second):
        self.classes, self.groups, self.first, self.second = classes, groups, first, second

    def pairs(self):
        """Each two once, in time of their number and that of the segments."""
        of_first, of_second = {}, {}  # of the classes before, by group
        for those in self.classes:
            those = [s for s in those if s in self.second]
            for s in those:
                for group, others in (of_second if s in self.first else of_first).items():
                    if group != self.groups[s]:
                        yield from ((s, t) for t in others)
            for s in those:
                for known in (of_second, of_first) if s in self.first else (of_second,):
                    known.setdefault(self.groups[s], []).append(s)

    def number(self):
        """How many these are, in time of the number of segments."""
        return self.number_in(self.second) - self.number_in(self.second - self.first)

    def number_in(self, some):
        return self.of_two_groups(some) - sum(self.of_two_groups(some.intersection(those)) for those in self.classes)

    def of_two_groups(self, some):
        sizes = collections.Counter(self.groups[s] for s in some).values()
        return (len(some) ** 2 - sum(n * n for n in sizes)) // 2


def meetings_of_segments(steps, events, segments, groups, allowed):
    """Gives, event by event, what may have contacts that count, and a function that tells their kind."""
    for point, _, here, row in sweep(steps, events, segments):
        members = {*here, *row}
        if len(members) < 2 or len({groups[s] for s in members}) < 2:
            continue
        lines, behind, before = lines_of(segments, row), lines_of(segments, here), {*here}
        ends = {s for s in members if ends_at(segments[s], point)}
        line_of = {s: k for k, line in enumerate(lines) for s in line}

        def kind(s, t):
            is_overlap = s in line_of and line_of[s] == line_of.get(t)
            return "overlap" if is_overlap else KINDS[2 - (s in ends) - (t in ends)]
        # Those on one line before the point have met. What goes on along one line counts even if the point is an end.
        some = members if not allowed else members - ends
        meetings = [Meeting(behind + [[s] for s in row if s not in before], groups, some,
                            some if "touch" in allowed else members)]
        for line in lines if allowed else ():
            on = ends.intersection(line)
            meetings.append(Meeting([[s] for s in line], groups, on, {*line} if "touch" in allowed else on))
        yield meetings, kind


def contacts_of_segments(*told):
    """Gives (i, j, kind), i < j, once for each two segments of different groups whose contact counts."""
    for meetings, kind in meetings_of_segments(*told):
        for meeting in meetings:
            for s, t in meeting.pairs():
                yield min(s, t), max(s, t), kind(s, t)


def number_of_segments(*told):
    """How many these are."""
    return sum(meeting.number() for meetings, _ in meetings_of_segments(*told) for meeting in meetings)
