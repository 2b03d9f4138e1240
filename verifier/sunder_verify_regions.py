"""Checks statements about the common part of half-planes: a part of sunder_verify_sets.py.

The format and the checks are those of docs/certificates-sets.md, "half_planes", "linear_program", "kernel" and
"convex_polygons"; no code is shared with the library.
A half-plane a x + b y <= c is a triple (a, b, c) of integers: any positive multiple of it is the same half-plane.
"""
from sunder_verify import bits, common, double, index, member, number, numbers, require, steps

# verdict: the least and the greatest number of sides, and whether the sides go round
SIDES = {
    "empty": (2, 3, True),
    "point": (3, 4, True),
    "segment": (4, 4, True),
    "ray": (3, 3, False),
    "line": (2, 2, False),
    "strip": (2, 2, False),
    "half-plane": (1, 1, False),
    "unbounded": (2, None, False),
    "bounded": (3, None, True),
    "plane": (0, 0, False),
}


def turn(h, k):
    """Positive: the normal of k is less than half a turn counter-clockwise from that of h."""
    return h[0] * k[1] - h[1] * k[0]


def facing(h, k):
    return h[0] * k[0] + h[1] * k[1]


def opposite(h, k):
    return turn(h, k) == 0 and facing(h, k) < 0


def corner(h, k):
    """The common point of the lines of two half-planes that turn, as x, y, w with w > 0: the point x / w, y / w."""
    return h[2] * k[1] - k[2] * h[1], h[0] * k[2] - k[0] * h[2], turn(h, k)


def excess(h, point):
    """Positive: the point x, y, w is outside; zero: on the line."""
    return h[0] * point[0] + h[1] * point[1] - h[2] * point[2]


def width(h, k):
    """Of two opposite ones: positive: their common part is a strip; zero: a line; negative: empty."""
    return facing(h, h) * k[2] - facing(h, k) * h[2]


def turns_before_start(h):
    """Is the normal's angle from half a turn to less than a turn?"""
    return h[1] < 0 or (h[1] == 0 and h[0] < 0)


def goes_round_once(sides):
    """Requires that each turns to the next, by less than half a turn."""
    return sum(turns_before_start(h) and not turns_before_start(k) for h, k in zip(sides, sides[1:] + sides[:1])) == 1


def check_normals(verdict, sides):
    """S1: the sides turn as they do for such a region."""
    least, most, is_round = SIDES[verdict]
    require(least <= len(sides) and (most is None or len(sides) <= most), "S1",
            "%d sides are not those of this verdict" % len(sides))
    if len(sides) == 2 and verdict != "unbounded":
        require(opposite(*sides), "S1", "the two sides are not opposite")
    elif len(sides) > 1:
        following = list(zip(sides, sides[1:] + sides[:1]))
        for k, (h, g) in enumerate(following if is_round else following[:-1]):
            require(turn(h, g) > 0, "S1", "side %d does not turn to the next by less than half a turn" % k)
        if is_round:
            require(goes_round_once(sides), "S1", "the sides do not go round once")
        else:
            for k in range(1, len(sides) - 1):
                require(turn(sides[0], sides[k]) > 0, "S1", "the sides turn by more than half a turn")
            require(turn(sides[0], sides[-1]) >= 0, "S1", "the sides turn by more than half a turn")
            require(verdict != "ray" or opposite(sides[0], sides[2]), "S1", "the ends of a ray are not opposite")


def check_lines(verdict, sides):
    """S2: the sides' lines lie as they do for such a region. Requires S1."""
    n = len(sides)

    def end(k):
        """Negative: side k has a part of the boundary, from the corner before it to the one after."""
        return excess(sides[(k + 1) % n], corner(sides[k - 1], sides[k]))

    if verdict == "empty":
        require(width(*sides) < 0 if n == 2 else end(1) > 0, "S2", "the half-planes have a common point")
    elif verdict in ("line", "ray"):
        require(width(sides[0], sides[-1]) == 0, "S2", "the first and last side are not on one line")
    elif verdict == "strip":
        require(width(*sides) > 0, "S2", "the strip has no inside")
    elif verdict in ("unbounded", "bounded"):
        for k in range(n) if verdict == "bounded" else range(1, n - 1):
            require(end(k) < 0, "S2", "side %d has no part of the boundary" % k)
    elif verdict == "point":
        for k in range(n):
            require(end(k) == 0, "S2", "side %d does not hold the point" % k)
    elif verdict == "segment":
        k = 0 if opposite(sides[0], sides[2]) and width(sides[0], sides[2]) == 0 else 1
        require(opposite(sides[k], sides[k + 2]) and width(sides[k], sides[k + 2]) == 0, "S2",
                "no two sides are on one line and opposite")
        require(end(k) < 0, "S2", "the segment has no length")


def check_others(verdict, sides, cones, given):
    """S3, S4: each half-plane holds the region. Requires S1 and S2."""
    has_corners = verdict in ("point", "segment", "ray", "unbounded", "bounded")
    for i, (h, p) in enumerate(zip(given, cones)):
        side = sides[p]
        if has_corners:
            after = sides[(p + 1) % len(sides)]
            require(turn(side, h) >= 0 and turn(h, after) >= 0, "S3",
                    "half-plane %d does not face as between its sides" % i)
            require(excess(h, corner(side, after)) <= 0, "S4", "half-plane %d does not hold its corner" % i)
        else:
            require(turn(side, h) == 0 and facing(side, h) > 0, "S3", "half-plane %d does not face as its side" % i)
            require(facing(side, h) * side[2] <= facing(side, side) * h[2], "S4",
                    "half-plane %d does not hold its side" % i)


def check_region(verdict, sides, cones, given):
    sides = [given[k] for k in sides]
    check_normals(verdict, sides)
    check_lines(verdict, sides)
    if verdict != "empty":
        check_others(verdict, sides, cones, given)


def read_region(item, given, about, where):
    """A statement that the common part of half-planes is of some kind."""
    verdict = member(item, "verdict", str, where)
    require(verdict in SIDES, "F", where + ".verdict is no kind of region")
    sides = [index(k, len(given), where + ".sides entry") for k in member(item, "sides", list, where)]
    cones = []
    if verdict != "empty":
        cones = member(item, "cones", list, where)
        require(len(cones) == len(given), "F", where + ".cones is not a list of %d" % len(given))
        # A corner is between two sides: of those that do not go round, none is after the last one.
        count = max(len(sides) - (verdict in ("ray", "unbounded")), 0)
        for p in cones:
            index(p, count, where + ".cones entry")
    return *about, verdict, lambda: check_region(verdict, sides, cones, given)


def place_of(point):
    """A point given as two numbers, as x, y, w with w > 0: the point x / w, y / w."""
    (x, y), d, e = common(point)
    return x << max(e, 0), y << max(e, 0), d << max(-e, 0)


def take_steps(given, vector):
    """Of a look at all half-planes with a point or a direction."""
    steps.take(2 * len(given), bits(vector), max(map(bits, given), default=0))


def check_in_all(given, place, check, what):
    take_steps(given, place)
    for i, h in enumerate(given):
        require(excess(h, place) <= 0, check, "%s is outside of half-plane %d" % (what, i))


def check_on_lines(given, names, place):
    for k in names:
        require(excess(given[k], place) == 0, "L2", "the point is not on the line of half-plane %d" % k)


def check_one(given, up, place, tight):
    check_in_all(given, place, "L1", "the point")
    check_on_lines(given, tight, place)
    sides = [given[k] for k in tight]
    if len(sides) == 2:
        ways = turn(sides[0], up) > 0 and turn(up, sides[1]) > 0 and turn(*sides) > 0
    else:
        ways = turn(sides[1], up) == 0 and facing(sides[1], up) > 0
        ways = ways and turn(sides[0], sides[1]) > 0 and turn(sides[1], sides[2]) > 0
    require(ways, "L3", "the half-planes at the point do not face as the objective needs")


def check_many(given, up, place, side, before, after):
    check_in_all(given, place, "L1", "the point")
    check_on_lines(given, [side], place)
    s = given[side]
    require(turn(s, up) == 0 and facing(s, up) > 0, "L3", "the side does not face as the objective")
    for end, sign in ((before, -1), (after, 1)):
        if end < 0:
            take_steps(given, s)
            for i, h in enumerate(given):
                require(sign * turn(s, h) <= 0, "L4", "half-plane %d ends the side" % i)
        else:
            h = given[end]
            require(sign * turn(s, h) > 0, "L4", "half-plane %d does not end the side there" % end)
            check_in_all(given, corner(s, h) if sign > 0 else corner(h, s), "L4", "the side's end")
    require(before < 0 or after < 0 or excess(given[after], corner(given[before], s)) < 0, "L4",
            "the side's ends are one point")


def check_all(given, up, place):
    check_in_all(given, place, "L1", "the point")
    require(up[0] == up[1] == 0, "L3", "there is an objective")


def check_unbounded(given, up, place, direction):
    check_in_all(given, place, "L1", "the point")
    take_steps(given, direction)
    require(facing(up, direction) > 0, "L3", "the direction does not lead further along the objective")
    for i, h in enumerate(given):
        require(facing(h, direction) <= 0, "L4", "the direction leaves half-plane %d" % i)


def check_infeasible(given, names):
    sides = [given[k] for k in names]
    check_normals("empty", sides)
    check_lines("empty", sides)


def read_linear_program(item, given, where):
    size = len(given)
    verdict = member(item, "verdict", str, where)
    require(verdict in ("one", "many", "all", "unbounded", "infeasible"), "F", where + ".verdict is no outcome")
    up = common(numbers(member(item, "objective", list, where), 2, double, where + ".objective"))[0]

    def names(key):
        return [index(k, size, "%s.%s entry" % (where, key)) for k in member(item, key, list, where)]

    def name(key):
        value = member(item, key, int, where)
        return value if value == -1 else index(value, size, "%s.%s" % (where, key))

    if verdict == "infeasible":
        sides = names("sides")
        return verdict, lambda: check_infeasible(given, sides)
    place = place_of(numbers(member(item, "point", list, where), 2, number, where + ".point"))
    if verdict == "one":
        tight = names("tight")
        require(len(tight) in (2, 3), "F", where + ".tight is not a list of 2 or 3")
        return verdict, lambda: check_one(given, up, place, tight)
    if verdict == "all":
        return verdict, lambda: check_all(given, up, place)
    if verdict == "many":
        side = index(member(item, "side", int, where), size, where + ".side")
        before, after = name("before"), name("after")
        return verdict, lambda: check_many(given, up, place, side, before, after)
    direction = common(numbers(member(item, "direction", list, where), 2, number, where + ".direction"))[0]
    return verdict, lambda: check_unbounded(given, up, place, direction)


def half_plane(item, where):
    """Of three numbers a, b, c, or of the four of an arrow, which has it on its left."""
    require(type(item) is list and len(item) in (3, 4), "F", where + " is not a list of 3 or 4")
    values, _, e = common(numbers(item, len(item), double, where))
    if len(values) == 3:
        a, b, c = values
        require(a or b, "F", where + " has no direction")
        return a, b, c
    return left_of(values, e, where)


def left_of(arrow, e, where):
    """What is left of an arrow of four integers, in units of 2^e."""
    px, py, qx, qy = arrow  # a and b are in units of 2^e, c in units of their square
    a, b, c = qy - py, px - qx, px * qy - qx * py
    a, b, c = (a << max(-e, 0), b << max(-e, 0), c << max(e, 0))
    require(a or b, "F", where + " has no direction")
    return a, b, c


class Table:
    """The half-planes of a file."""

    def __init__(self, top):
        self.given = [half_plane(item, "half_planes[%d]" % i)
                      for i, item in enumerate(member(top, "half_planes", list, "the file"))]

    def read_region(self, item, where):
        return read_region(item, self.given, ("half-planes", "common part"), where)

    def read_linear_program(self, item, where):
        return "half-planes", "linear program", *read_linear_program(item, self.given, where)


def sides_of_ring(item, where):
    """Of each edge the half-plane of the side where the ring's inside is."""
    require(type(item) is list and len(item) > 2, "F", where + " is not a list of three vertices or more")
    flat = []
    for vertex in item:
        flat += numbers(vertex, 2, double, where + " vertex")
    flat, _, e = common(flat)
    vertices = list(zip(flat[0::2], flat[1::2]))
    edges = list(zip(vertices, vertices[1:] + vertices[:1]))
    area = sum(p[0] * q[1] - p[1] * q[0] for p, q in edges)
    require(area, "F", where + " has no area")
    return [left_of(p + q if area > 0 else q + p, e, where) for p, q in edges]


class Rings:
    """The rings of a file."""

    def __init__(self, top):
        self.sides = [sides_of_ring(item, "rings[%d]" % i)
                      for i, item in enumerate(member(top, "rings", list, "the file"))]

    def read_kernel(self, item, where):
        ring = index(member(item, "ring", int, where), len(self.sides), where + ".ring")
        return read_region(item, self.sides[ring], ("rings", "kernel"), where)


def sides_of_convex(item, where):
    """The half-planes whose common part is a convex polygon, a segment or a point."""
    require(type(item) is list and item, "F", where + " is not a list of a vertex or more")
    flat = []
    for vertex in item:
        flat += numbers(vertex, 2, double, where + " vertex")
    flat, _, e = common(flat)
    vertices = list(zip(flat[0::2], flat[1::2]))
    n = len(vertices)

    def at_most(axis, limit):
        one = 1 << max(-e, 0)
        return (one, 0, limit << max(e, 0)) if axis == 0 else (0, one, limit << max(e, 0))

    def at_least(axis, limit):
        a, b, c = at_most(axis, -limit)
        return -a, -b, c

    if n == 1:
        x, y = vertices[0]
        return [at_most(0, x), at_most(1, y), at_least(0, x), at_least(1, y)]
    sides = [left_of(p + q, e, where) for p, q in zip(vertices, vertices[1:] + vertices[:1])]
    if n == 2:
        axis = 0 if vertices[0][0] != vertices[1][0] else 1
        ends = [v[axis] for v in vertices]
        return sides + [at_most(axis, max(ends)), at_least(axis, min(ends))]
    require(all(turn(h, k) > 0 for h, k in zip(sides, sides[1:] + sides[:1])) and goes_round_once(sides), "F",
            where + " is not strictly convex and counter-clockwise")
    return sides


class ConvexPolygons:
    """The convex polygons of a file, for their common part; they are looked at where it is asked for."""

    def __init__(self, top):
        self.top, self.given = top, None

    def read_common_part(self, item, where):
        if self.given is None:
            self.given = []
            for i, polygon in enumerate(member(self.top, "convex_polygons", list, "the file")):
                self.given += sides_of_convex(polygon, "convex_polygons[%d]" % i)
        return read_region(item, self.given, ("convex polygons", "common part"), where)


def questions(top):
    """How a statement is read, for each question that the tables of a file allow."""
    result = {}
    if "half_planes" in top:
        table = Table(top)
        result = {"half_planes": table.read_region, "linear_program": table.read_linear_program}
    if "rings" in top:
        result["kernel"] = Rings(top).read_kernel
    if "convex_polygons" in top:
        result["convex_polygons"] = ConvexPolygons(top).read_common_part
    return result
