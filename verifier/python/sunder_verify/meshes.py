"""Meshes: their table, and the rules about them (docs/claims.md, "Meshes")."""
import collections
import functools
import itertools
import math

from .reader import LIST, bits, common, form, projective, require
from .rules import holds
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


def covered(steps, cuts, directions, rays_a, rays_b, a, b):
    """Each triangle of A is parted from each of B; and each piece of one is outside of the other."""
    whole = [(0, len(mesh.triangles)) for mesh in (a, b)]
    pairs, outside, left = [whole], (set(), set()), iter(directions)
    for k in cuts:
        require(pairs, "covered", "the walk goes on where no pair of parts is left")
        parts = pairs.pop()
        if k:
            which = k < 0
            first, end = parts[which]
            require(first < abs(k) < end, "covered", "a part is cut where it has no triangles on both sides")
            for half in (abs(k), end), (first, abs(k)):
                pairs.append([half, parts[1]] if k > 0 else [parts[0], half])
            continue
        direction = next(left, None)
        require(direction, "covered", "there is no direction for a pair of parts")
        d = common(direction)[0]
        (_, last, e), (begin, _, f) = a.ends(steps, d, *parts[0]), b.ends(steps, d, *parts[1])
        require(last << max(e - f, 0) < begin << max(f - e, 0), "covered",
                "a part of %s is not strictly less far along its direction than one of %s" % (a.name, b.name))
        for mesh, of, part, other in (a, 0, parts[0], 1), (b, 1, parts[1], 0):
            if parts[other] == whole[other]:
                outside[of].update(mesh.piece[part[0]:part[1]])
    require(not pairs and next(left, None) is None, "covered", "the walk does not end with its numbers and directions")
    for mesh, other, rays, out in (a, b, rays_a, outside[0]), (b, a, rays_b, outside[1]):
        for t, direction in rays:
            place = mesh.image(mesh.triangles[t][0])[:4]
            wound = other.winding(steps, "covered", common(direction)[0], place)
            require(not wound, "covered", "triangle %d of %s is inside of %s" % (t, mesh.name, other.name))
            out.add(mesh.piece[t])
        require(not other.closed or out.issuperset(mesh.piece), "covered",
                "a piece of %s is not shown to be outside of %s" % (mesh.name, other.name))


def on_triangle(steps, triangle, weights, mesh, point):
    """A triangle of a mesh holds a point."""
    for k, _ in weights:
        require(k in mesh.triangles[triangle], "on_triangle", "a weight is not of a corner of the triangle")
    holds(steps, weights, None, mesh, point)


def encloses(steps, direction, mesh, point):
    """A point is inside of what the closed pieces of a mesh bound."""
    require(mesh.winding(steps, "encloses", common(direction)[0], projective(point)), "encloses",
            "the point is not inside of %s" % mesh.name)
