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

    def __init__(self, value, where):
        rows, self.exponent = rows_of(value, 4, where)
        self.bits = max(map(bits, rows), default=0)
        super().__init__((row[:2], row[2:]) for row in rows)
        for i, (first, last) in enumerate(self):
            require(first <= last, "F", "%s[%d] does not begin with its lexicographically first end" % (where, i))


def half_planes(value, where):
    """Of a, b, c, or of an arrow from one point to another, which has it on its left: (a, b, c) as integers * 2^e, and e."""
    result = []
    for i, item in enumerate(value):
        place = "%s[%d]" % (where, i)
        require(type(item) is list and len(item) in (3, 4), "F", place + " is not a list of 3 or 4")
        (row,), e = rows_of([item], len(item), place)
        if len(row) == 4:
            px, py, qx, qy = row  # a and b are in units of 2^e, c in units of their square
            row, e = ((qy - py) << max(-e, 0), (px - qx) << max(-e, 0), (px * qy - qx * py) << max(e, 0)), e + min(e, 0)
        require(row[0] or row[1], "F", place + " has no direction")
        result.append((*row, e))
    return result


TABLES = {"bodies": bodies, "segments": Segments, "half_planes": half_planes}
