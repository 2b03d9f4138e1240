"""The tables of a certificate file, as integers: docs/claims.md, "Tables". Everything that is required is the form."""
import functools
import itertools
import operator

from .reader import LIST, anything, bits, common, double, form, index, length, list_of, members, numbers, text_of
from .said import description
from .sentences import counted, in_quotes, shown


def dot(u, v):
    """The product of as many numbers as the shorter one has."""
    return sum(map(operator.mul, u, v))


def turn(u, v):
    """Positive: v is less than half a turn counter-clockwise from u."""
    return u[0] * v[1] - u[1] * v[0]


def cross(u, v):
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def around(items):
    """Each with the next one, and the last with the first."""
    return zip(items, items[1:] + items[:1])


def rows_of(value, count, where):
    """Rows of so many doubles each, as rows of integers, in units of 2^e; and e."""
    flat = []
    for k, row in enumerate(LIST(value, where)):
        flat += numbers(row, count, double, "%s[%d]" % (where, k))
    flat, _, e = common(flat)
    return [tuple(flat[k:k + count]) for k in range(0, len(flat), count)], e


ROUND = {"radius": None, "cylinder": 2, "cone": 2, "ellipsoid": 1}  # kinds of bodies with a radius: points of the core


class Body:
    """A convex hull of points, with the ways that go on from there for ever, or with a radius; or the image of one."""

    def __init__(self, item, bodies, where, told):
        self.linear, self.turned, self.base, self.said = None, 0, len(bodies), ""
        if type(item) is dict and "of" in item:
            read = members(item, {"name": text_of, "of": anything, "linear": anything, "translation": anything}, where)
            body = bodies[index(read["of"], len(bodies), where + ".of")]
            form(body.linear is None, where + " is of one that is placed itself")
            self.base = read["of"]
            self.rows, self.count, self.exponent, d = body.rows, body.count, body.exponent, body.dimension
            self.kind, self.radius, self.size, self.bits = body.kind, body.radius, body.size, body.bits
            self.r, self.said = body.r, body.said and body.said + ", mapped"
            (self.linear,), self.turned = rows_of([read["linear"]], d * d, where + ".linear")
            (self.translation,), self.moved = rows_of([read["translation"]], d, where + ".translation")
            self.size += bits(self.linear) + abs(self.turned) + bits(self.translation) + abs(self.moved)
        else:
            shapes = {"name": text_of, "points": LIST, "ways": LIST, **dict.fromkeys(ROUND, double), "said": description}
            read = members(item, shapes, where, dict(told), {"ways": [], **dict.fromkeys(ROUND), "said": ""})
            points, self.said = read["points"], read["said"]
            form(points and type(points[0]) is list and 2 <= len(points[0]) <= 6,
                 where + ".points is not a list of points of 2 to 6 numbers")
            d = len(points[0])
            arrows = [(way[:d], way[d:]) if type(way) is list and len(way) == 2 * d else (["0x0p+0"] * d, way)
                      for way in read["ways"]]
            rows, self.exponent = rows_of(points + [end for arrow in arrows for end in arrow], d, where + " row")
            self.count = len(points)
            ends = rows[self.count:]
            self.rows = rows[:self.count] + [tuple(map(operator.sub, q, p)) for p, q in zip(ends[::2], ends[1::2])]
            self.translation, self.moved = (0,) * d, self.exponent
            kinds = [kind for kind in ROUND if read[kind]]
            self.kind, self.radius = (kinds[0], read[kinds[0]]) if kinds else (None, (0, 1, 0))
            self.r = shown(item[self.kind]) if kinds else ""
            form(not kinds or (len(kinds) == 1 and d == 3 and not read["ways"] and self.radius[0] >= 0 and
                               ROUND[self.kind] in (None, self.count)), where + " is no body with a radius")
            self.bits = max(map(bits, self.rows))
            self.size = self.bits + abs(self.exponent) + length([self.radius])
        self.name, self.dimension = in_quotes(read["name"]), d
        self.axis = self.turn(list(map(operator.sub, self.rows[1], self.rows[0]))) if ROUND.get(self.kind) == 2 else ()
        form(not self.axis or any(self.axis), where + " has no axis")

    def __len__(self):
        return len(self.rows)

    def title(self):
        """What it is, and of how many points."""
        kind = {None: "convex hull", "ellipsoid": "ball"}.get(self.kind, self.kind)
        if self.kind == "radius":
            kind = {1: "ball", 2: "capsule"}.get(self.count, "rounded hull")
        of = counted(self.count, "mapped point" if self.linear and self.kind != "ellipsoid" else "point")
        if self.count < len(self):
            of += " and " + counted(len(self) - self.count, "way")
        image = "image of the " if self.linear and self.kind == "ellipsoid" else ""
        return "the %s%s%s of the %s of %s" % (image, kind, " of radius " * bool(self.kind) + self.r, of, self.name)

    def turn(self, v):
        """The matrix times a vector, in units of 2^turned times its own."""
        d = self.dimension
        return [dot(self.linear[r:r + d], v) for r in range(0, d * d, d)] if self.linear else v

    def forms(self, steps, along):
        """A direction's products with the points and with the ways, all as integers * 2^e, and e."""
        d, turned, moved = self.dimension, self.turned + self.exponent, dot(along, self.translation)
        if self.linear:
            steps.take(d * d, bits(along), bits(self.linear))
            along = [dot(along, self.linear[c::d]) for c in range(d)]
        steps.take(len(self.rows), bits(along), self.bits)
        e = min(turned, self.moved)
        products = products_of([n << (turned - e) for n in along], self.rows)
        points, moved = products[:self.count], moved << (self.moved - e)
        return [n + moved for n in points] if moved else points, products[self.count:], e

    def image(self, k):
        """Of point or way k: its numbers, and 1 for a point, 0 for a way, as integers * 2^e, which stands last."""
        v, is_point, turned = self.turn(self.rows[k]), int(k < self.count), self.turned + self.exponent
        e = min(turned, self.moved, 0)
        moved = [t * is_point << (self.moved - e) for t in self.translation]
        return *((x << (turned - e)) + t for x, t in zip(v, moved)), is_point << -e, e

    def core(self, k):
        """Point k where it is not placed, likewise."""
        e = min(self.exponent, 0)
        return *(x << (self.exponent - e) for x in self.rows[k]), 1 << -e, e

    def spread(self, d):
        """How far along a direction it goes beyond its core, squared: a number."""
        (r, _, e), whole = self.radius, 1
        if not r:
            return 0, 1, 0
        if self.kind == "ellipsoid" and self.linear:
            d, e = [dot(d, self.linear[c::3]) for c in range(3)], e + self.turned
        if self.axis:  # d d - (d a)^2 / (a a) = |d x a|^2 / (a a)
            d, whole = cross(d, self.axis), dot(self.axis, self.axis)
        return r * r * dot(d, d), whole, 2 * e


def products_of(row, rows):
    if len(row) == 2:
        a, b = row
        return [a * x + b * y for x, y in rows]
    if len(row) == 3:
        a, b, c = row
        return [a * x + b * y + c * z for x, y, z in rows]
    return [dot(row, other) for other in rows]


def bodies(value, where, read=None):
    result = []
    for i, item in enumerate(LIST(value, where)):
        result.append(Body(item, result, "%s[%d]" % (where, i), read or {}))
    return result


class Polytope:
    """The hull of points of R^d, or the common part of half-spaces a x <= b: rows a1, .., ad, b; or the image of one."""

    def __init__(self, item, polytopes, where, told):
        self.linear, self.turned, self.said = None, 0, ""
        if type(item) is dict and "of" in item:
            read = members(item, {"name": text_of, "of": anything, "linear": anything, "translation": anything}, where)
            of = polytopes[index(read["of"], len(polytopes), where + ".of")]
            form(of.linear is None, where + " is of one that is placed itself")
            self.rows, self.exponent, self.dimension, self.is_of_points = of.rows, of.exponent, of.dimension, of.is_of_points
            self.bits, self.said = of.bits, of.said and of.said + ", mapped"
            (self.linear,), self.turned = rows_of([read["linear"]], of.dimension ** 2, where + ".linear")
            (self.translation,), self.moved = rows_of([read["translation"]], of.dimension, where + ".translation")
        else:
            self.is_of_points = type(item) is dict and "points" in item
            key = "points" if self.is_of_points else "half_spaces"
            shapes = {"name": text_of, "dimension": anything, key: LIST, "said": description}
            read = members(item, shapes, where, dict(told), {"said": ""})
            self.said = read["said"]
            self.dimension = index(read["dimension"], 7, where + ".dimension", 2)
            form(read[key] or not self.is_of_points, where + ".points is empty")
            self.rows, self.exponent = rows_of(read[key], self.dimension + (not self.is_of_points), where + " row")
            self.bits = max(map(bits, self.rows), default=0)
        self.name = in_quotes(read["name"])

    def title(self):
        kind, of = ("convex hull", "point") if self.is_of_points else ("common part", "half-space")
        return "the %s%s of the %s of %s" % ("image of the " if self.linear else "", kind, counted(len(self), of), self.name)

    def __len__(self):
        return len(self.rows)


def polytopes(value, where, read=None):
    result = []
    for i, item in enumerate(LIST(value, where)):
        result.append(Polytope(item, result, "%s[%d]" % (where, i), read or {}))
    return result


class Segments(list):
    """Pairs of points, the lexicographically lesser one first, in units of 2^exponent."""

    def __init__(self, pairs, exponent):
        super().__init__(pairs)
        self.edges, self.exponent = self, exponent
        self.bits = max((bits(p + q) for p, q in self), default=0)


def segments(value, where, read=None):
    rows, exponent = rows_of(value, 4, where)
    for i, row in enumerate(rows):
        form(row[:2] <= row[2:], "%s[%d] does not begin with its lexicographically first end" % (where, i))
    return Segments([(row[:2], row[2:]) for row in rows], exponent)


BLOCK = 32  # edges


class Polygons(list):
    """Lists of rings, which are lists of edges. Rings and edges are numbered over all polygons."""

    def __init__(self, polygons, exponent):
        super().__init__(polygons)
        self.last = None
        self.rings = [ring for polygon in self for ring in polygon]
        self.edges = Segments([edge for ring in self.rings for edge in ring], exponent)
        self.part = [i for i, polygon in enumerate(self) for _ in polygon]  # of each ring its polygon
        self.ring = [r for r, ring in enumerate(self.rings) for _ in ring]  # of each edge its ring
        self.owner = [self.part[r] for r in self.ring]
        self.shell = {i: r for r, i in reversed([*enumerate(self.part)])}  # of each polygon its first ring
        self.flat = {i for i, polygon in enumerate(self) if sum(map(len, polygon)) < 3}  # points and segments

    def some(self, steps, which):
        """Some of them, numbered anew. Statements that follow each other are mostly about the same."""
        if self.last is None or self.last[0] != which:
            some = [self[i] for i in which]
            steps.take(20 * sum(map(len, itertools.chain(*some))), 1, 1)
            self.last = which, Polygons(some, self.edges.exponent)
        return self.last[1]

    @functools.cached_property
    def beside(self):
        """Of each edge of some length those before and after it on its ring, those of no length left out."""
        result = {}
        for _, ring in itertools.groupby(range(len(self.edges)), self.ring.__getitem__):
            ring = [s for s in ring if self.edges[s][0] != self.edges[s][1]]
            result.update(zip(ring, zip(ring[-1:] + ring[:-1], ring[1:] + ring[:1])))
        return result

    @functools.cached_property
    def first_edge(self):
        """Of each ring, and then their number."""
        return [0, *itertools.accumulate(map(len, self.rings))]

    @functools.cached_property
    def rings_of(self):
        """Of each polygon."""
        first = [0, *itertools.accumulate(map(len, self))]
        return [range(*ends) for ends in zip(first, first[1:])]

    @functools.cached_property
    def blocks(self):
        """Of each ring edges that follow each other: least and greatest x, least y, the first and the last of them."""
        result = []
        for begin, end in zip(self.first_edge, self.first_edge[1:]):
            result.append([])
            for k in range(begin, end, BLOCK):
                some = self.edges[k:min(k + BLOCK, end)]
                result[-1].append((min(p[0] for p, _ in some), max(q[0] for _, q in some),
                                   min(min(p[1], q[1]) for p, q in some), k, k + len(some)))
        return result

    def is_point(self, i):
        return all(first == last for ring in self[i] for first, last in ring)


def polygons(value, where, read=None):
    for i, item in enumerate(LIST(value, where)):
        form(type(item) is list and all(type(ring) is list and ring for ring in item),
             "%s[%d] is not a list of rings of one vertex or more" % (where, i))
    rows, exponent = rows_of([vertex for rings in value for ring in rings for vertex in ring], 2, where + " vertex")
    row = iter(rows)
    placed = [[[next(row) for _ in ring] for ring in rings] for rings in value]
    return Polygons([[[tuple(sorted(ends)) for ends in around(ring)] for ring in rings] for rings in placed], exponent)


class Members(list):
    """Of so many numbers each, in units of 2^exponent."""

    def __init__(self, value, where, read=None):
        rows, self.exponent = rows_of(value, self.columns, where)
        super().__init__(rows)
        self.bits = max(map(bits, rows), default=0)
        for i, row in enumerate(self):
            form(self.is_one(*row), "%s[%d] %s" % (where, i, self.otherwise))


class Discs(Members):
    """Closed discs x, y, r."""
    columns, otherwise = 3, "has a negative radius"
    is_one = staticmethod(lambda x, y, r: r >= 0)

    def box(self, i):
        x, y, r = self[i]
        return x - r, y - r, x + r, y + r


class Boxes(Members):
    """Closed boxes: lowest x and y, highest x and y."""
    columns, otherwise, box = 4, "does not begin with its lowest corner", list.__getitem__
    is_one = staticmethod(lambda x, y, u, v: x <= u and y <= v)


# ---- Half-planes a x + b y <= c as integers (a, b, c, exponent of all three).

def half_plane(a, b, e, c, f):
    """Of a and b in units of 2^e, c in units of 2^f."""
    least = min(e, f)
    return a << (e - least), b << (e - least), c << (f - least), least


def left_of(p, q, e, where):
    """What is left of the arrow from one point to another, both in units of 2^e."""
    form(p != q, where + " has no direction")
    return half_plane(q[1] - p[1], p[0] - q[0], e, turn(p, q), 2 * e)


def given_half_plane(item, where, read=None):
    """Of a, b, c, or of an arrow from one point to another."""
    form(type(item) is list and len(item) in (3, 4), where + " is not a list of 3 or 4")
    (row,), e = rows_of([item], len(item), where)
    form(len(row) == 4 or row[0] or row[1], where + " has no direction")
    return (*row, e) if len(row) == 3 else left_of(row[:2], row[2:], e, where)


def sides_of(vertices, e, where):
    return [left_of(p, q, e, where) for p, q in around(vertices)]


class Ring(list):
    """The half-planes on the inner side of its edges."""

    def __init__(self, sides, vertices, exponent):
        super().__init__(sides)
        self.vertices, self.exponent = vertices, exponent

    @functools.cached_property
    def alone(self):
        """The polygon of this ring."""
        return Polygons([[[tuple(sorted(ends)) for ends in around(self.vertices)]]], self.exponent)


def sides_of_ring(item, where, read=None):
    form(type(item) is list and len(item) > 2, where + " is not a list of three vertices or more")
    vertices, e = rows_of(item, 2, where)
    area = sum(turn(p, q) for p, q in around(vertices))
    form(area, where + " has no area")
    inner = sides_of(vertices, e, where)
    return Ring(inner if area > 0 else [(-a, -b, -c, f) for a, b, c, f in inner], vertices, e)


def goes_round_once(sides):
    """Does each half-plane turn to the next, by less than half a turn, and all by one turn?"""
    is_low = [h[1] < 0 or (h[1] == 0 and h[0] < 0) for h in sides]
    return all(turn(h, g) > 0 for h, g in around(sides)) and sum(low > after for low, after in around(is_low)) == 1


def sides_of_convex_polygon(item, where, read=None):
    """Also of a segment and a point."""
    form(type(item) is list and item, where + " is not a list of a vertex or more")
    vertices, e = rows_of(item, 2, where)
    sides = sides_of(vertices, e, where) if len(vertices) > 1 else []
    if len(vertices) < 3:
        axes = [(1, 0), (0, 1)] if not sides else [(1, 0)] if vertices[0][0] != vertices[1][0] else [(0, 1)]
        axes += [(-x, -y) for x, y in axes]
        return sides + [half_plane(x, y, 0, max(dot((x, y), v) for v in vertices), e) for x, y in axes]
    form(goes_round_once(sides), where + " is not strictly convex and counter-clockwise")
    return sides


def convex_polygons(value, where, read=None):
    """The half-planes of all, polygon after polygon."""
    return [side for sides in list_of(sides_of_convex_polygon)(value, where, read) for side in sides]


TABLES = {"bodies": bodies, "polytopes": polytopes, "segments": segments, "polygons": polygons, "circles": Discs, "boxes": Boxes,
          "half_planes": list_of(given_half_plane), "rings": list_of(sides_of_ring), "convex_polygons": convex_polygons}
