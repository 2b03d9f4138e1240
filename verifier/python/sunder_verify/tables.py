"""The tables of a certificate file, as integers: docs/claims.md, "Tables". Everything that is required is rule F, the form."""
from .reader import bits, common, double, index, members, numbers, require, text_of


def rows_of(value, count, where):
    """Rows of so many doubles each, as rows of integers, in units of 2^e; and e."""
    flat = []
    for k, row in enumerate(value):
        flat += numbers(row, count, double, "%s[%d]" % (where, k))
    flat, _, e = common(flat)
    return [tuple(flat[k:k + count]) for k in range(0, len(flat), count)], e


class Body:
    """A convex hull of points, with the ways that go on from there for ever; or the image of one."""

    def __init__(self, item, bodies, where):
        if type(item) is dict and "of" in item:
            name, of, linear, translation = members(
                item, {"name": str, "of": int, "linear": list, "translation": list}, where)
            body = bodies[index(of, len(bodies), where + ".of")]
            require(body.linear is None, "F", where + " is of one that is placed itself")
            self.rows, self.count, self.exponent, self.dimension = body.rows, body.count, body.exponent, body.dimension
            d = self.dimension
            (self.linear,), self.turned = rows_of([linear], d * d, where + ".linear")
            (self.translation,), self.moved = rows_of([translation], d, where + ".translation")
        else:
            name, points, ways = members(item, {"name": str, "points": list}, where, {"ways": list})
            require(points and type(points[0]) is list and len(points[0]) in (2, 3), "F",
                    where + ".points is not a list of points of 2 or 3 numbers")
            count, d = self.count, self.dimension = len(points), len(points[0])
            arrows = [(way[:d], way[d:]) if type(way) is list and len(way) == 2 * d else (["0x0p+0"] * d, way) for way in ways or []]
            rows, self.exponent = rows_of(points + [end for arrow in arrows for end in arrow], d, where + " row")
            self.rows = rows[:count] + [tuple(y - x for x, y in zip(*arrow)) for arrow in zip(rows[count::2], rows[count + 1::2])]
            self.linear = None
        self.name = text_of(name, where + ".name")
        self.bits = max(map(bits, self.rows))

    def __len__(self):
        return len(self.rows)

    def is_way(self, k):
        return k >= self.count

    def forms(self, steps, along):
        """A direction's products with the points and with the ways, all as integers * 2^e, and e."""
        d = self.dimension
        if self.linear is None:
            steps.take(len(self.rows), bits(along), self.bits)
            return *self.split(products_of(along, self.rows)), self.exponent
        steps.take(d * d, bits(along), bits(self.linear))
        row = [dot(along, self.linear[c::d]) for c in range(d)]
        steps.take(len(self.rows), bits(row), self.bits)
        turned, e = self.turned + self.exponent, min(self.turned + self.exponent, self.moved)
        moved = dot(along, self.translation) << (self.moved - e)
        points, ways = self.split([n << (turned - e) for n in products_of(row, self.rows)])
        return [n + moved for n in points], ways, e

    def split(self, values):
        return values[:self.count], values[self.count:]

    def image(self, k):
        """Of point or way k, as integers * 2^e, and e."""
        d, v = self.dimension, self.rows[k]
        if self.linear is None:
            return v, self.exponent
        turned = self.turned + self.exponent
        e = min(turned, self.moved)
        v = [dot(self.linear[r * d:r * d + d], v) << (turned - e) for r in range(d)]
        return [n + (t << (self.moved - e)) for n, t in zip(v, self.translation)] if k < self.count else v, e


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def products_of(row, rows):
    if len(row) == 2:
        a, b = row
        return [a * x + b * y for x, y in rows]
    a, b, c = row
    return [a * x + b * y + c * z for x, y, z in rows]


def bodies(value, where):
    result = []
    for i, item in enumerate(value):
        result.append(Body(item, result, "%s[%d]" % (where, i)))
    return result


class Segments(list):
    """Pairs of points, the lexicographically lesser one first, in units of 2^exponent."""

    def __init__(self, pairs, exponent):
        super().__init__(pairs)
        self.edges, self.exponent = self, exponent
        self.bits = max((bits(p + q) for p, q in self), default=0)


def segments(value, where):
    rows, exponent = rows_of(value, 4, where)
    for i, row in enumerate(rows):
        require(row[:2] <= row[2:], "F", "%s[%d] does not begin with its lexicographically first end" % (where, i))
    return Segments(((row[:2], row[2:]) for row in rows), exponent)


class Polygons(list):
    """Of each polygon its rings, each as the range of its edges. Edge k goes from vertex k to the next of the ring."""

    def __init__(self, value, where):
        super().__init__()
        vertices, ends = [], []
        for i, item in enumerate(value):
            require(type(item) is list and all(type(ring) is list and ring for ring in item), "F",
                    "%s[%d] is not a list of rings of one vertex or more" % (where, i))
            self.append([])
            for ring in item:
                self[i].append(range(len(vertices), len(vertices) + len(ring)))
                vertices += ring
                ends += [(k, k + 1) for k in self[i][-1][:-1]] + [(self[i][-1][-1], self[i][-1][0])]
        rows, exponent = rows_of(vertices, 2, where + " vertex")
        self.edges = Segments((sorted((rows[p], rows[q])) for p, q in ends), exponent)
        self.owner = [i for i, rings in enumerate(self) for ring in rings for _ in ring]
        self.flat = {i for i, rings in enumerate(self) if sum(map(len, rings)) < 3}  # points and segments

    def edges_of(self, i):
        return [self.edges[k] for ring in self[i] for k in ring]

    def is_point(self, i):
        return all(first == last for first, last in self.edges_of(i))


class Parts(list):
    """Some polygons, with edges and rings numbered anew."""

    def __init__(self, polygons, which):
        super().__init__(polygons[i] for i in which)
        self.edges = Segments((edge for i in which for edge in polygons.edges_of(i)), polygons.edges.exponent)
        self.rings, self.ring, self.part, self.shell = [], [], [], []  # of each edge its ring; of each ring its part
        for i, rings in enumerate(self):
            self.shell.append(len(self.rings))
            for ring in rings:
                self.rings.append(range(len(self.ring), len(self.ring) + len(ring)))
                self.ring += [len(self.part)] * len(ring)
                self.part.append(i)


class Discs(list):
    """Closed discs x, y, r, in units of 2^exponent."""

    def __init__(self, value, where):
        rows, self.exponent = rows_of(value, 3, where)
        self.bits = max(map(bits, rows), default=0)
        super().__init__(rows)
        for i, (_, _, r) in enumerate(self):
            require(r >= 0, "F", "%s[%d] has a negative radius" % (where, i))

    def boxes(self):
        return [(x - r, y - r, x + r, y + r) for x, y, r in self]


def left_of(arrow, e, where):
    """The half-plane left of an arrow in units of 2^e: (a, b, c) as integers in units of 2^f, and f."""
    px, py, qx, qy = arrow  # a and b are in units of 2^e, c in units of their square
    require((px, py) != (qx, qy), "F", where + " has no direction")
    return (qy - py) << max(-e, 0), (px - qx) << max(-e, 0), (px * qy - qx * py) << max(e, 0), e + min(e, 0)


def half_planes(value, where):
    """Of a, b, c, or of an arrow from one point to another, which has it on its left."""
    result = []
    for i, item in enumerate(value):
        place = "%s[%d]" % (where, i)
        require(type(item) is list and len(item) in (3, 4), "F", place + " is not a list of 3 or 4")
        (row,), e = rows_of([item], len(item), place)
        require(len(row) == 4 or row[0] or row[1], "F", place + " has no direction")
        result.append((*row, e) if len(row) == 3 else left_of(row, e, place))
    return result


def sides_of(vertices, e, where):
    return [left_of(p + q, e, where) for p, q in zip(vertices, vertices[1:] + vertices[:1])]


def turn(u, v):
    """Positive: v is less than half a turn counter-clockwise from u."""
    return u[0] * v[1] - u[1] * v[0]


def rings(value, where):
    """Of each ring the half-planes on the inner side of its edges."""
    result = []
    for i, item in enumerate(value):
        place = "%s[%d]" % (where, i)
        require(type(item) is list and len(item) > 2, "F", place + " is not a list of three vertices or more")
        vertices, e = rows_of(item, 2, place)
        area = sum(turn(p, q) for p, q in zip(vertices, vertices[1:] + vertices[:1]))
        require(area, "F", place + " has no area")
        inner = sides_of(vertices, e, place)
        result.append(inner if area > 0 else [(-a, -b, -c, f) for a, b, c, f in inner])
    return result


def goes_round_once(sides):
    """Does each half-plane turn to the next, by less than half a turn, and all by one turn?"""
    after = sides[1:] + sides[:1]
    is_low = [h[1] < 0 or (h[1] == 0 and h[0] < 0) for h in after]
    return all(turn(h, g) > 0 for h, g in zip(sides, after)) and sum(map(int.__gt__, is_low[-1:] + is_low, is_low)) == 1


def convex_polygons(value, where):
    """The half-planes of the sides of all, polygon after polygon; also of segments and points."""
    result = []
    for i, item in enumerate(value):
        place = "%s[%d]" % (where, i)
        require(type(item) is list and item, "F", place + " is not a list of a vertex or more")
        vertices, e = rows_of(item, 2, place)

        def beside(axis, way, limit):
            row = [0, 0, way * limit << max(e, 0), min(e, 0)]
            row[axis] = way << max(-e, 0)
            return tuple(row)
        sides = sides_of(vertices, e, place) if len(vertices) > 1 else []
        if len(vertices) < 3:
            axes = (0, 1) if not sides else (0,) if vertices[0][0] != vertices[1][0] else (1,)
            sides += [beside(axis, way, way * max(way * v[axis] for v in vertices)) for way in (1, -1) for axis in axes]
        else:
            require(goes_round_once(sides), "F", place + " is not strictly convex and counter-clockwise")
        result += sides
    return result


TABLES = {"bodies": bodies, "segments": segments, "polygons": Polygons, "circles": Discs, "half_planes": half_planes, "rings": rings,
          "convex_polygons": convex_polygons}
