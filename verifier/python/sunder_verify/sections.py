"""What a plane has in common with the hull of a body's points: docs/claims.md, "Sections".

The plane is pulled back to where the rows of the body are: a map keeps what lies between what.
"""
from .hulls import is_between, minus
from .linear import aligned, way_between
from .reader import bits, require
from .tables import around, cross, dot


def pulled(steps, of, plane):
    """Told how far a row is above the plane, as an integer; and is the body not mirrored (1), or mirrored (-1)?"""
    *normal, level = plane
    level = [level, dot(normal, of.translation)]
    turned, upright, m = of.turned + of.exponent, 1, of.linear
    if m:
        steps.take(9, bits(normal), bits(m))
        normal, upright = [dot(normal, m[c::3]) for c in range(3)], dot(m[:3], cross(m[3:6], m[6:]))
    e = min(turned, of.moved, 0)
    normal, level = [n << (turned - e) for n in normal], (level[0] << -e) - (level[1] << (of.moved - e))
    return normal, level, upright


def heights(steps, of, plane):
    """Of all points."""
    normal, level, _ = pulled(steps, of, plane)
    steps.take(len(of), bits((*normal, level)), of.bits)
    return [dot(normal, row) - level for row in of.rows]


def beyond(steps, of, plane):
    """All of the body is on one side."""
    above = heights(steps, of, plane)
    require(min(above) > 0 or max(above) < 0, "beyond", "the plane is not beyond %s" % of.name)


def touches(steps, of, plane, corners):
    """All of it is on one side, but for what is on the plane, which is between two corners, or one."""
    above, ends = heights(steps, of, plane), [of.rows[k] for k, _ in corners]
    is_one_way = min(above) >= 0 or max(above) <= 0
    is_on_plane = all(i == j and above[i] == 0 for i, j in corners)
    require(is_one_way and is_on_plane and len({*ends}) == len(ends) < 3, "touches", "the plane does not touch it there only")
    steps.take(4 * above.count(0), of.bits, of.bits)
    for k, h in enumerate(above):
        require(h or is_between(ends[0], ends[-1], of.rows[k]), "touches", "point %d is on the plane, too" % k)


def corner_of(of, normal, level, i, j):
    """Where the plane crosses the way from one point to another, as x, y, z, w."""
    if i == j:
        return *of.rows[i], 1
    above, below = (dot(normal, of.rows[k]) - level for k in (i, j))
    return *(above * b - below * a for a, b in zip(of.rows[i], of.rows[j])), above - below


def outlined(steps, along, of, plane, corners, proved):
    """The corners, in order, are those of the section: each on an edge, each with the next one in a face."""
    hull, faces = proved.get(of.base, ("", ()))
    require(hull in ("solid", "flat", "segment"), "outlined", "what the hull of %s is has not been proved before" % of.name)
    normal, level, upright = pulled(steps, of, plane)
    steps.take(64 * len(corners), bits((*normal, level)), of.bits)

    def above(k):
        return dot(normal, of.rows[k]) - level

    for k, (i, j) in enumerate(corners):
        is_corner = above(i) == 0 if i == j else above(i) > 0 > above(j)
        require(is_corner, "outlined", "corner %d is not on the plane" % k)
    require(max(along) < len(faces), "outlined", "a face is none of the hull's")
    steps.take(sum(len(faces[f]) for f in along), 1, 1)
    for k, (f, (c, d)) in enumerate(zip(along, around(corners))):
        require({*c, *d} <= {*faces[f]}, "outlined", "corner %d and the next one are not in that face" % k)
        require(hull != "solid" or any(map(above, faces[f][:3])), "outlined", "face %d is in the plane" % f)
    ring = faces[0]
    if hull == "solid":
        require(len(corners) > 2 and len(set(along)) == len(along), "outlined", "the corners are not around the body")
    else:
        sides = {*around(ring), *around(ring[::-1]), *(zip(ring, ring) if hull == "flat" else ())}
        is_whole = hull == "flat" and not any(map(above, ring[:3]))
        fits = all((c[0], d[0]) in sides for c, d in around(corners)) if is_whole else all(c in sides for c in corners)
        wanted = len(ring) if is_whole else len(ring[:3]) - 1
        require(fits and len(corners) == wanted, "outlined", "the corners are not those of the hull")
    if len(corners) > 2:
        first, *others = (corner_of(of, normal, level, i, j) for i, j in corners[:3])
        ways = [way_between(first, other) for other in others]
        require(upright * dot(normal, cross(*ways)) > 0, "outlined", "the corners do not go counter-clockwise")


def area(steps, of, plane, corners, area_from, area_to):
    """The area is between two numbers: it is the sum of those of triangles at the first corner, which are rounded."""
    normal, level, _ = pulled(steps, of, plane)
    steps.take(32 * len(corners), bits((*normal, level)), of.bits)
    first, *others = (corner_of(of, normal, level, i, j) for i, j in corners)
    ways, parts = [(of.turn(way_between(first, p)), p[3]) for p in others], []
    for (u, v), (w, x) in zip(ways, ways[1:]):
        n, d = dot(plane[:3], cross(u, w)), (first[3] * v) * (first[3] * x)
        require(n > 0, "area", "the corners do not turn to the left")
        s = 64 + d.bit_length() - n.bit_length()
        parts.append(((n << max(s, 0)) // (d << max(-s, 0)), -s))
    require(parts, "area", "there are not three corners")
    e, square = min(s for _, s in parts), dot(plane[:3], plane[:3])
    unit = 2 * (e + 2 * (of.turned + of.exponent))
    for limit, sign, much in (area_from, 1, 0), (area_to, -1, 1):
        found = sum((n + much) << (s - e) for n, s in parts)
        this, that = aligned(found ** 2, unit, 4 * square * limit[0] ** 2, 2 * limit[2])
        require(sign * (this - that) >= 0, "area", "the area is not between these")
