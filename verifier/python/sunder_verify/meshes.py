"""Meshes: their table, and the rules about them (docs/claims.md, "Meshes")."""
import collections
import functools
import itertools
import math

from .linear import aligned, way_between
from .reader import LIST, bits, common, form, length, projective, require
from .rules import beyond, holds, moved_back
from .sentences import counted
from .tables import Body, cross, dot


class Mesh(Body):
    """Triangles between points, or the image of a mesh."""

    def __init__(self, item, meshes, where, told):
        is_image = type(item) is dict and "of" in item
        form(is_image or (type(item) is dict and "triangles" in item), where + " has no triangles")
        form(all(key not in item for key in ("ways", "radius", "cylinder", "cone", "ellipsoid")), where + " has more than a mesh")
        super().__init__({key: value for key, value in item.items() if is_image or key != "triangles"}, meshes, where, told)
        form(self.dimension == 3, where + " is not in space")
        if is_image:
            self.triangles, self.closed, self.by_winding, self.piece = (
                getattr(meshes[self.base], key) for key in ("triangles", "closed", "by_winding", "piece"))
            return
        form(len(set(self.rows)) == len(self.rows), where + " has two points that are equal")
        given = LIST(item["triangles"], where + ".triangles")
        form(given and all(type(t) is list and len(t) == 3 for t in given), where + ".triangles are not lists of 3")
        corners = [*itertools.chain.from_iterable(given)]
        form({int} == {*map(type, corners)} and 0 <= min(corners) and max(corners) < len(self.rows),
             where + ".triangles has an index that is not in range")
        self.triangles = [*map(tuple, given)]
        told["steps"].take(32 * len(self.triangles), 2 * self.bits, 2 * self.bits)
        self.find_pieces()

    def find_pieces(self):
        """Of each triangle its piece, a number; which triangles bound an inside; and do all of these go round it?"""
        parent = [*range(len(self.rows))]

        def find(i):
            while parent[i] != i:
                parent[i] = i = parent[parent[i]]
            return i

        for i, j, k in self.triangles:
            i = find(i)
            if parent[j] != i:
                parent[find(j)] = i
            if parent[k] != i:
                parent[find(k)] = i
        ends = [*zip(*self.triangles)]
        edges = collections.Counter(itertools.chain.from_iterable(map(zip, ends, ends[1:] + ends[:1])))
        lines = collections.defaultdict(list)
        for (i, j), count in [*edges.items()]:
            back = edges.get((j, i), 0)
            if count != back and (i < j or not back):
                way = tuple(y - x for x, y in zip(self.rows[i], self.rows[j]))
                share = math.gcd(*way) * (1 if way > (0, 0, 0) else -1)
                way = tuple(x // share for x in way)
                ends = sorted((dot(way, self.rows[k]), n) for k, n in ((i, count), (j, back)))
                lines[way, cross(self.rows[i], way)].append((ends[0][0], ends[1][0], ends[0][1], ends[1][1], i))
        worst = {}
        for on_line in lines.values():
            on_line.sort()
            end, last = on_line[0][1], on_line[0][4]
            for edge in on_line:
                if edge[0] < end:
                    parent[find(edge[4])] = find(last)
                end, last = max((end, last), (edge[1], edge[4]))
            changes = sorted((at, way * there, way * back, i) for low, high, there, back, i in on_line
                             for at, way in ((low, 1), (high, -1)))
            there = back = 0
            for (at, more, less, i), following in zip(changes, changes[1:]):
                there, back = there + more, back + less
                if at < following[0] and there != back:
                    worst[i] = max(worst.get(i, 0), 1 + (there + back) % 2)
        kinds = collections.Counter()
        for i, kind in worst.items():
            kinds[find(i)] = max(kinds[find(i)], kind)
        self.piece = [find(corners[0]) for corners in self.triangles]
        self.closed = [corners for corners, piece in zip(self.triangles, self.piece) if kinds[piece] < 2]
        self.by_winding = 1 not in kinds.values()

    def title(self):
        parts = ["the " + of + counted(n, "mapped triangle" if self.linear else "triangle") for n, of in (
            (len(self.closed), "solid of " if self.by_winding else "solid, by parity, of "),
            (len(self.triangles) - len(self.closed), "surface of ")) if n]
        return "%s of %s" % (" and ".join(parts), self.name)

    @functools.cached_property
    def images(self):
        """Of all points, as integers in units of 2^e; and e."""
        places = [self.image(k) for k in range(len(self.rows))]
        return [place[:3] for place in places], places[0][4]

    def ends(self, steps, d, first, end):
        """The least and the greatest of a direction's products with the corners of triangles, from one to before another,
        as integers * 2^e; and e."""
        turned, moved = self.turned + self.exponent, dot(d, self.translation)
        e = min(turned, self.moved)
        if self.linear:
            steps.take(9, bits(d), bits(self.linear))
            d = [dot(d, self.linear[c::3]) for c in range(3)]
        steps.take(3 * (end - first), bits(d), self.bits)
        u, v, w = d
        corners = set(itertools.chain.from_iterable(self.triangles[first:end]))
        products = [u * x + v * y + w * z for x, y, z in map(self.rows.__getitem__, corners)]
        return *((n << (turned - e)) + (moved << (self.moved - e)) for n in (min(products), max(products))), e

    def winding(self, steps, rule, d, place):
        """How often the closed pieces wind around the point x, .., w, or whether a ray crosses them an odd number of
        times, as a ray along d tells: how often it leaves them, less how often it enters."""
        size = bits(d) + self.size + bits(place)
        steps.take(8 * (len(self.rows) + len(self.triangles)), size, size)
        require(any(d), rule, "the direction is zero")
        (images, e), (*at, w) = self.images, place
        c = next(k for k in range(3) if d[k])
        i, j = ((c + 1) % 3, (c + 2) % 3)[::1 if d[c] > 0 else -1]
        seen = []  # the corners from the point, as two directions across d and d itself tell: a frame that is not mirrored
        for axis, other in (i, c), (j, c), (None, None):
            row = list(d) if axis is None else [0, 0, 0]
            if axis is not None:
                row[axis], row[other] = d[c], -d[axis]
            origin = dot(row, at) << max(-e, 0)
            row = [n * w << max(e, 0) for n in row]
            seen.append([dot(row, image) - origin for image in images])
        xs, ys, zs = seen
        total = 0
        for p, q, r in self.closed:
            x, y, z, s, t, u = xs[p], xs[q], xs[r], ys[p], ys[q], ys[r]
            if x > 0 < y and z > 0 or x < 0 > y and z < 0 or s > 0 < t and u > 0 or s < 0 > t and u < 0:
                continue
            turns = x * t - y * s, y * u - z * t, z * s - x * u
            if min(turns) < 0 < max(turns) or max(zs[p], zs[q], zs[r]) < 0:
                continue
            way = 1 if turns[0] > 0 else -1
            height = turns[0] * zs[r] + turns[1] * zs[p] + turns[2] * zs[q]
            require(0 not in turns and height, rule, "the ray meets an edge, or begins on a triangle, of %s" % self.name)
            total += way if height * way > 0 else 0
        return total if self.by_winding else total % 2


def meshes(value, where, read):
    result = []
    for i, item in enumerate(LIST(value, where)):
        result.append(Mesh(item, result, "%s[%d]" % (where, i), read))
    return result


def parted(rule, steps, cuts, directions, a, b, besides=None):
    """Each triangle of A is parted from each of B; the pieces of each that are parted from all of the other. besides(d, parts,
    last, e, begin, f) is asked of each two parts: A's ends at last * 2^e, B's begins at begin * 2^f."""
    whole = [(0, len(mesh.triangles)) for mesh in (a, b)]
    pairs, outside, left = [whole], (set(), set()), iter(directions)
    for k in cuts:
        require(pairs, rule, "the walk goes on where no pair of parts is left")
        parts = pairs.pop()
        if k:
            which = k < 0
            first, end = parts[which]
            require(first < abs(k) < end, rule, "a part is cut where it has no triangles on both sides")
            for half in (abs(k), end), (first, abs(k)):
                pairs.append([half, parts[1]] if k > 0 else [parts[0], half])
            continue
        direction = next(left, None)
        require(direction, rule, "there is no direction for a pair of parts")
        d = common(direction)[0]
        (_, last, e), (begin, _, f) = a.ends(steps, d, *parts[0]), b.ends(steps, d, *parts[1])
        require(last << max(e - f, 0) < begin << max(f - e, 0), rule,
                "a part of %s is not strictly less far along its direction than one of %s" % (a.name, b.name))
        if besides:
            besides(d, parts, last, e, begin, f)
        for mesh, of, part, other in (a, 0, parts[0], 1), (b, 1, parts[1], 0):
            if parts[other] == whole[other]:
                outside[of].update(mesh.piece[part[0]:part[1]])
    require(not pairs and next(left, None) is None, rule, "the walk does not end with its numbers and directions")
    return outside


def far_apart(rule, steps, a, b, square, over, unit, size):
    """Parts are so far apart along their direction: square / over * 2^unit, squared; size: its length."""
    def are_far_apart(d, _, last, e, begin, f):
        of_all = size + bits(d) + a.size + b.size
        steps.take(16, of_all, of_all)
        begin, last = aligned(begin, f, last, e)
        far, asked = aligned((begin - last) ** 2 * over, 2 * min(e, f), square * dot(d, d), unit)
        require(far >= asked, rule, "a part of %s and one of %s are less far apart than stated, along their direction" % (a.name, b.name))
    return are_far_apart


def told_pieces(rule, steps, mesh, other, rays, inside):
    """The pieces of a mesh that rays from first corners of triangles tell to be inside of another one, or outside."""
    for t, direction in rays:
        require(t < len(mesh.triangles), rule, "a ray is of a triangle that is not there")
        wound = other.winding(steps, rule, common(direction)[0], mesh.image(mesh.triangles[t][0])[:4])
        require(bool(wound) == inside, rule, "triangle %d of %s is %s of %s" % (
            t, mesh.name, "not inside" if inside else "inside", other.name))
        yield mesh.piece[t]


def outside_of(rule, steps, mesh, other, rays, parted_pieces):
    pieces = parted_pieces.union(told_pieces(rule, steps, mesh, other, rays, False))
    require(not other.closed or pieces.issuperset(mesh.piece), rule,
            "a piece of %s is not shown to be outside of %s" % (mesh.name, other.name))


def covered(steps, cuts, directions, rays_a, rays_b, a, b, rule="covered", besides=None):
    """Each triangle of A is parted from each of B; and each piece of one is outside of the other."""
    outside = parted(rule, steps, cuts, directions, a, b, besides)
    outside_of(rule, steps, a, b, rays_a, outside[0])
    outside_of(rule, steps, b, a, rays_b, outside[1])


def covered_apart(steps, cuts, directions, rays_a, rays_b, a, b, from_a, to_b):
    """Likewise, and as far apart as two points."""
    rule, p, q = "covered_apart", projective(from_a), projective(to_b)
    way = way_between(p, q)
    covered(steps, cuts, directions, rays_a, rays_b, a, b, rule, far_apart(
        rule, steps, a, b, dot(way, way), (p[3] * q[3]) ** 2, 0, length(from_a) + length(to_b)))


def covered_clear(steps, cuts, directions, rays_a, rays_b, a, b, least):
    """Likewise, and that far apart."""
    rule = "covered_clear"
    covered(steps, cuts, directions, rays_a, rays_b, a, b, rule, far_apart(
        rule, steps, a, b, least[0] ** 2, 1, 2 * least[2], length([least])))


def covered_all_along(steps, cuts, directions, rays_a, rays_b, a, b, to_a, to_b):
    """Likewise, and so at the end of their ways."""
    def are_parted(d, parts, *_):
        (_, last, e), (begin, _, f) = to_a.ends(steps, d, *parts[0]), to_b.ends(steps, d, *parts[1])
        require(last << max(e - f, 0) < begin << max(f - e, 0), "covered_all_along",
                "at the end a part of %s is not strictly less far along its direction than one of %s" % (a.name, b.name))
    covered(steps, cuts, directions, rays_a, rays_b, a, b, "covered_all_along", are_parted)


def covered_before(steps, cuts, directions, rays_a, rays_b, a, b, to_a, to_b, time):
    """Likewise before a time, when parts may touch."""
    (now, whole), _, _ = common([time, (1, 1, 0)])

    def are_parted(d, parts, last, e, begin, f):
        (_, to_last, g), (to_begin, _, h) = to_a.ends(steps, d, *parts[0]), to_b.ends(steps, d, *parts[1])
        size = bits(d) + a.size + b.size + to_a.size + to_b.size + length([time])
        steps.take(16, size, size)
        begin, last = aligned(begin, f, last, e)
        to_begin, to_last = aligned(to_begin, h, to_last, g)
        first, end = aligned((begin - last) * (whole - now), min(e, f), (to_begin - to_last) * now, min(g, h))
        require(first + end >= 0, "covered_before",
                "at the time a part of %s is further along its direction than one of %s" % (a.name, b.name))
    covered(steps, cuts, directions, rays_a, rays_b, a, b, "covered_before", are_parted)


def covered_within(steps, cuts, directions, inner, outer, a, b):
    """Likewise; and each piece of A is inside of B, each one of B outside of A."""
    outside = parted("covered_within", steps, cuts, directions, a, b)
    pieces = {*told_pieces("covered_within", steps, a, b, inner, True)}
    require(pieces.issuperset(a.piece), "covered_within", "a piece of %s is not shown to be inside of %s" % (a.name, b.name))
    outside_of("covered_within", steps, b, a, outer, outside[1])


def halves(polygon, heights):
    """What of a convex polygon is above a plane, and what is below, as its corners' heights tell; nothing where it has no
    point there. New corners are not in lowest terms."""
    above, below = [], []
    if max(heights) > 0 > min(heights):
        for corner, height, following, its_height in zip(
                polygon, heights, polygon[1:] + polygon[:1], heights[1:] + heights[:1]):
            if height >= 0:
                above.append(corner)
            if height <= 0:
                below.append(corner)
            if height > 0 > its_height or height < 0 < its_height:
                crossing = [height * y - its_height * x for x, y in zip(corner, following)]
                above.append(crossing)
                below.append(crossing)
    elif max(heights) > 0:
        above = polygon
    elif min(heights) < 0:
        below = polygon
    return above, below


def lowest_terms(row):
    share = math.gcd(*row) if row[-1] > 0 else -math.gcd(*row)
    return [n // share for n in row]


def partition(rule, steps, cuts, planes, cells, rays, meshes):
    """Of each cell of a tree of planes: is it outside of each mesh (False), inside (True), or is that not told (None)?"""
    places, told = [*map(projective, cells)], [[None, None] for _ in cells]
    for which, mesh in enumerate(meshes):
        for k, direction in rays[which]:
            require(k < len(cells), rule, "a ray is of a cell that is not there")
            told[k][which] = bool(mesh.winding(steps, rule, common(direction)[0], places[k]))
    parts = []
    for mesh in meshes:
        steps.take(16 * (len(mesh.rows) + len(mesh.closed)), mesh.size, mesh.size)
        images, e = mesh.images
        corners = [lowest_terms([n << max(e, 0) for n in image] + [1 << max(-e, 0)]) for image in images]
        parts.append([[corners[i] for i in triangle] for triangle in mesh.closed if has_area(*(mesh.rows[i] for i in triangle))])
    planes, left = iter(planes), enumerate(places)
    waiting = [((), parts)]
    for cut in cuts:
        require(waiting and cut in (0, 1), rule, "the walk goes on where no cell is left, or a number is not 0 or 1")
        path, parts = waiting.pop()
        if not cut:
            k, place = next(left, (None, None))
            require(place, rule, "there is no point for a cell")
            for which, mesh in enumerate(meshes):
                require(told[k][which] is None or not parts[which], rule, "a triangle of %s goes through cell %d" % (mesh.name, k))
            while path:
                (plane, sign), path = path
                steps.take(8, bits(plane), bits(place))
                require(sign * (dot(plane[:3], place) - plane[3] * place[3]) > 0, rule, "the point of cell %d is not in it" % k)
            continue
        plane = next(planes, None)
        require(plane, rule, "there is no plane for a cut")
        plane = common(plane)[0]
        sides = [], []
        for polygons in parts:
            both = [], []
            for polygon in polygons:
                of_plane, of_corners, (x, y, z, w) = bits(plane), max(map(bits, polygon)), plane
                steps.take(8 * len(polygon), of_plane, of_corners)
                above, below = halves(polygon, [x * p + y * q + z * r - w * s for p, q, r, s in polygon])
                if above and below:
                    steps.take(32, *2 * [of_plane + 2 * of_corners])
                    above, below = [*map(lowest_terms, above)], [*map(lowest_terms, below)]
                for side, half in zip(both, (above, below)):
                    if half:
                        side.append(half)
            for side, those in zip(sides, both):
                side.append(those)
        waiting.append((((plane, -1), path), sides[1]))
        waiting.append((((plane, 1), path), sides[0]))
    require(not waiting and next(planes, None) is None and next(left, None) is None, rule,
            "the walk does not end with its numbers, planes and points")
    return told


def has_area(p, q, r):
    return any(cross([y - x for x, y in zip(p, q)], [y - x for x, y in zip(p, r)]))


def insides_apart(steps, cuts, planes, cells, rays_first, rays_second, a, b):
    """No point is inside of both."""
    for k, (in_a, in_b) in enumerate(partition("insides_apart", steps, cuts, planes, cells, (rays_first, rays_second), (a, b))):
        require(in_a is False or in_b is False, "insides_apart", "cell %d is not shown to be outside of one" % k)


def part_of(steps, cuts, planes, cells, rays_first, rays_second, a, b):
    """What is inside of A is inside of B, or on a triangle of it."""
    for k, (in_a, in_b) in enumerate(partition("part_of", steps, cuts, planes, cells, (rays_first, rays_second), (a, b))):
        require(in_a is False or in_b, "part_of", "cell %d is not shown to be outside of %s or inside of %s" % (k, a.name, b.name))


def equal_insides(steps, cuts, planes, cells, rays_first, rays_second, a, b):
    """What is inside of one is inside of the other, or on a triangle of it."""
    for k, (in_a, in_b) in enumerate(partition("equal_insides", steps, cuts, planes, cells, (rays_first, rays_second), (a, b))):
        require(in_a is not None and in_a is in_b, "equal_insides", "cell %d is not shown to be inside of both or outside" % k)


def beside(steps, until, directions, away, a, b, rule="beside", least=(0, 1, 0)):
    """Parts of a mesh, one after the other, are parted from a body, and that far; the body's first point is outside."""
    require(len(until) == len(directions), rule, "there are not as many directions as parts")
    first = 0
    for end, direction in zip(until, directions):
        require(first < end <= len(a.triangles), rule, "the parts do not follow each other in %s" % a.name)
        d = common(direction)[0]
        _, last, e = a.ends(steps, d, first, end)
        beyond(steps, rule, (last, e, a.size), d, b, least)
        first = end
    require(first == len(a.triangles), rule, "a triangle of %s is in no part" % a.name)
    require(len(away) <= 1, rule, "there is more than one ray")
    for direction in away:
        require(not a.winding(steps, rule, common(direction)[0], b.image(0)[:4]), rule,
                "the first point of %s is inside of %s" % (b.name, a.name))
    require(away or len(until) == 1 or not a.closed, rule, "%s is not shown to be outside of %s" % (b.name, a.name))


def clear_beside(steps, until, directions, away, a, b, least):
    """Likewise, and that far apart."""
    beside(steps, until, directions, away, a, b, "clear_beside", least)


def half_spaces(corners, name):
    """Of a point, a triangle or a tetrahedron: normals and levels, of half-spaces whose common part it is."""
    def through(p, normal):
        return normal, dot(normal, p)
    if len(corners) == 1:
        return [through(corners[0], [way * (k == c) for k in range(3)]) for c in range(3) for way in (1, -1)]
    if len(corners) == 3:
        normal = cross(*([y - x for x, y in zip(corners[0], q)] for q in corners[1:]))
        require(any(normal), "around", "three points of %s are on one line" % name)
        edges = zip(corners, corners[1:] + corners[:1])
        return [through(corners[0], [way * n for n in normal]) for way in (1, -1)] + [
            through(p, cross(normal, [y - x for x, y in zip(p, q)])) for p, q in edges]
    result = []
    for k, apex in enumerate(corners):
        p, q, r = corners[:k] + corners[k + 1:]
        normal = cross([y - x for x, y in zip(p, q)], [y - x for x, y in zip(p, r)])
        height = dot(normal, apex) - dot(normal, p)
        require(height, "around", "four points of %s are in one plane" % name)
        result.append(through(p, normal if height > 0 else [-n for n in normal]))
    return result


def around(steps, holders, held, a, b):
    """Each point of A is in the hull of some points of B, one, three or four."""
    size, up = a.size + b.size, max(a.exponent - b.exponent, 0)
    steps.take(64 * len(holders), size, 2 * size)
    steps.take(24 * len(a.rows), 3 * size, size)
    bounds = [half_spaces([[n << max(b.exponent - a.exponent, 0) for n in b.rows[k]] for k in those], b.name) for those in holders]
    for k, (row, home) in enumerate(zip(a.rows, held)):
        at = [n << up for n in row]
        require(all(dot(normal, at) >= level for normal, level in bounds[home]), "around",
                "point %d of %s is not where it is said to be held" % (k, a.name))


def on_triangle(steps, triangle, weights, mesh, point, rule="on_triangle"):
    """A triangle of a mesh holds a point."""
    for k, _ in weights:
        require(k in mesh.triangles[triangle], rule, "a weight is not of a corner of the triangle")
    holds(steps, weights, None, mesh, point)


def on_triangle_at(steps, triangle, weights, mesh, to, time, point):
    """A triangle of a mesh on its way holds a point at that time."""
    on_triangle(steps, triangle, weights, mesh, moved_back(steps, point, time, mesh, to), "on_triangle_at")


def corners_around(steps, triangle, weights, mesh, point):
    """As on_triangle; the corners whose weights are positive."""
    for k, _ in weights:
        require(k in mesh.triangles[triangle], "triangles_cross", "a weight is not of a corner of the triangle")
    holds(steps, weights, None, mesh, point)
    return [k for k, (n, _, _) in weights if n > 0]


def triangles_cross(steps, triangle, weights, other, other_weights, mesh, point):
    """Two triangles have a point that is inside of one, or inside of edges of both that are not parallel."""
    require(triangle != other, "triangles_cross", "the two triangles are one")
    require(not mesh.linear, "triangles_cross", "%s is mapped" % mesh.name)
    one = corners_around(steps, triangle, weights, mesh, point)
    two = corners_around(steps, other, other_weights, mesh, point)
    steps.take(16, mesh.size, mesh.size)
    for of in triangle, other:
        require(has_area(*(mesh.rows[k] for k in mesh.triangles[of])), "triangles_cross", "a triangle has no area")

    def edges_cross():
        ways = [[y - x for x, y in zip(mesh.rows[i], mesh.rows[j])] for i, j in (one, two)]
        return any(cross(*ways))
    require(3 in (len(one), len(two)) or len(one) == len(two) == 2 and edges_cross(), "triangles_cross",
            "the point is not inside of a triangle, or of edges of both that cross")


def between(rows, i, j):
    return [y - x for x, y in zip(rows[i], rows[j])]


def have_more(rows, t, u):
    """Have two triangles with an area, which share corners, more in common than these and the edge between two?"""
    shared = [k for k in t if k in u]
    if len(shared) == 3:
        return True
    c, t, u = shared[0], [k for k in t if k not in shared], [k for k in u if k not in shared]
    if len(shared) == 2:
        edge, (p,), (r,) = between(rows, c, shared[1]), t, u
        one, other = cross(edge, between(rows, c, p)), cross(edge, between(rows, c, r))
        return not any(cross(one, other)) and dot(one, other) > 0
    p, q, r, s = (between(rows, c, k) for k in t + u)
    n, m = cross(p, q), cross(r, s)
    a, b, e, f = dot(n, r), dot(n, s), dot(m, p), dot(m, q)
    if a > 0 < b or a < 0 > b or e > 0 < f or e < 0 > f:
        return False
    if not (a or b or e or f):  # in one plane: is a side of one in the angle of the other?
        def is_within(x, p, q, way):
            return way * dot(n, cross(p, x)) >= 0 <= way * dot(n, cross(x, q))
        way = 1 if dot(n, m) > 0 else -1
        return any(is_within(x, p, q, 1) for x in (r, s)) or any(is_within(x, r, s, way) for x in (p, q))
    # Where each leaves the corner along the line of both planes.
    one, other = ([abs(far) * x + abs(near) * y for x, y in zip(v, w)] for v, w, near, far in ((p, q, e, f), (r, s, a, b)))
    return dot(one, other) > 0


def no_crossings(steps, cuts, directions, a):
    """Of each two triangles it is looked at what they have in common, if they share a corner; else they are parted."""
    rule = "no_crossings"
    require(not a.linear, rule, "%s is mapped" % a.name)
    steps.take(16 * len(a.triangles), a.size, a.size)
    require(all(has_area(*(a.rows[k] for k in t)) for t in a.triangles), rule, "a triangle has no area")
    whole, left = (0, len(a.triangles)), iter(directions)
    pairs = [(whole, whole)]

    def pass_over():
        """Triangles with themselves, and two that share a corner."""
        while pairs:
            (i, end), (j, other_end) = pairs[-1]
            if end - i > 1 or other_end - j > 1:
                return
            t, u = a.triangles[i], a.triangles[j]
            if i != j:
                if not {*t} & {*u}:
                    return
                steps.take(24, a.bits, 2 * a.bits)
                require(not have_more(a.rows, t, u), rule, "two triangles of %s have more in common than corners and an edge" % a.name)
            pairs.pop()
    for k in cuts:
        pass_over()
        require(pairs, rule, "the walk goes on where no pair of parts is left")
        parts = pairs.pop()
        if k:
            first, end = parts[k < 0]
            is_one = parts[0] == parts[1]
            require(first < abs(k) < end and (k > 0 or not is_one), rule, "a part is cut where it has no triangles on both sides")
            before, behind = (first, abs(k)), (abs(k), end)
            if is_one:
                pairs += [(behind, behind), (before, behind), (before, before)]
            else:
                pairs += [(half, parts[1]) if k > 0 else (parts[0], half) for half in (behind, before)]
            continue
        direction = next(left, None)
        require(direction, rule, "there is no direction for a pair of parts")
        d = common(direction)[0]
        (_, last, _), (begin, _, _) = (a.ends(steps, d, *part) for part in parts)
        require(last < begin, rule, "a part of %s is not strictly less far along its direction than another one" % a.name)
    pass_over()
    require(not pairs and next(left, None) is None, rule, "the walk does not end with its numbers and directions")


def encloses(steps, direction, mesh, point):
    """A point is inside of what the closed pieces of a mesh bound."""
    require(mesh.winding(steps, "encloses", common(direction)[0], projective(point)), "encloses",
            "the point is not inside of %s" % mesh.name)
