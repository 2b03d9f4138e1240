"""What is the convex hull of points in space: docs/claims.md, "Hulls".

Points are seen from the mean of the hull's vertices, and as many times as far from it as there are of these.
"""
import itertools

from .reader import require
from .tables import around, cross, dot, goes_round_once


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def from_mean(steps, body, named, corners):
    """All points of a body, from the mean of the named ones."""
    size = 2 * (body.bits + len(named).bit_length())
    steps.take(8 * (len(body) + corners), size, size)
    mean = [sum(axis) for axis in zip(*(body.rows[k] for k in named))]
    return [[len(named) * x - y for x, y in zip(row, mean)] for row in body.rows]


def is_convex(ring, normal):
    """Is a ring in a plane strictly convex, once round, counter-clockwise seen from where the normal points?"""
    axis = next(k for k, x in enumerate(normal) if x)
    i, j = ((axis + 1) % 3, (axis + 2) % 3)[::1 if normal[axis] > 0 else -1]
    return goes_round_once([(q[i] - p[i], q[j] - p[j]) for p, q in around(ring)])


def surface(steps, homes, body, faces):
    """The faces are those of the hull of a body's points, which is solid."""
    vertices = {*itertools.chain(*faces)}
    at, planes, beside = from_mean(steps, body, vertices, sum(map(len, faces))), [], {}
    for f, face in enumerate(faces):
        ring = [at[k] for k in face]
        normal = cross(minus(ring[1], ring[0]), minus(ring[2], ring[0]))
        height = dot(normal, ring[0])
        is_face = height > 0 and all(dot(normal, p) == height for p in ring) and is_convex(ring, normal)
        require(is_face, "surface", "face %d is no strictly convex polygon that is seen from outside" % f)
        planes.append((normal, height))
        for edge, (_, after) in zip(around(face), around(face[1:] + face[:1])):
            require(edge not in beside, "surface", "two faces have the edge from %d to %d" % edge)
            beside[edge] = f, after
    for (i, j), (f, _) in beside.items():
        require((j, i) in beside, "surface", "only one face contains the edge from %d to %d" % (i, j))
        normal, height = planes[f]
        require(dot(normal, at[beside[j, i][1]]) < height, "surface", "the edge from %d to %d is not convex" % (i, j))
    middle = [sum(axis) for axis in zip(*(at[k] for k in faces[0]))]
    for f, face in enumerate(faces[1:], 1):
        is_beside = any(dot(cross(at[i], at[j]), middle) < 0 for i, j in around(face))
        require(is_beside, "surface", "face %d is in the way of face 0" % f)
    for k, home in enumerate(homes):
        if home is None:
            require(k in vertices, "surface", "point %d has no home" % k)
            continue
        (normal, height), face, c = planes[home[0]], faces[home[0]], home[1]
        around_it = all(dot(cross(at[i], at[j]), at[k]) >= 0 for i, j in around([face[0], face[c], face[c + 1]]))
        require(around_it and dot(normal, at[k]) <= height, "surface", "point %d is not in its home" % k)


def outline(steps, sectors, body, ring):
    """The ring is that of the hull of a body's points, which is flat."""
    vertices = {*ring}
    at = from_mean(steps, body, vertices, len(ring))
    corners = [at[k] for k in ring]
    normal = cross(corners[0], corners[1])
    require(any(normal) and not any(dot(normal, p) for p in at), "outline", "the points are not in one plane")
    require(is_convex(corners, normal), "outline", "the ring is not strictly convex")
    for k, (point, sector) in enumerate(zip(at, sectors)):
        if sector is None:
            require(k in vertices, "outline", "point %d has no sector" % k)
            continue
        p, q = corners[sector], corners[(sector + 1) % len(ring)]
        ways = (p, point), (point, q), (minus(q, p), minus(point, p))
        require(all(dot(normal, cross(u, v)) >= 0 for u, v in ways), "outline", "point %d is not in its sector" % k)


def is_between(first, last, point):
    """Is a point on the segment between two others, or, where these are one, there?"""
    way, here = minus(last, first), minus(point, first)
    axis = next((c for c, x in enumerate(way) if x), None)
    if axis is None:
        return not any(here)
    return all(way[axis] * y == here[axis] * x for x, y in zip(way, here)) and 0 <= dot(way, here) <= dot(way, way)


def between(steps, body, i, j):
    """All points of a body are on a segment, whose ends differ."""
    steps.take(4 * len(body), body.bits, body.bits)
    first, last = body.rows[i], body.rows[j]
    for k, row in enumerate(body.rows):
        is_on = first != last and is_between(first, last, row)
        require(is_on, "between", "point %d is not between the ends" % k)


def one_point(steps, body):
    """All points of a body are one."""
    steps.take(4 * len(body), body.bits, body.bits)
    require(all(row == body.rows[0] for row in body.rows), "one_point", "two points differ")
