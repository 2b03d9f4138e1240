"""What is the convex hull of points in space: docs/claims.md, "Hulls".

Points are seen from the mean of the hull's vertices, and as many times as far from it as there are of these.
"""
import itertools

from .linear import Surface, from_mean, sum_of
from .reader import require
from .tables import around, cross, dot, goes_round_once


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def seen_from_mean(steps, body, named, corners):
    """All points of a body, from the mean of the named ones."""
    size = 2 * (body.bits + len(named).bit_length())
    steps.take(8 * (len(body) + corners), size, size)
    return from_mean(body.rows, named)


def plane_of(at, face):
    """Its normal and height, by the first three corners of a face."""
    o, a, b = (at[k] for k in face[:3])
    normal = cross(minus(a, o), minus(b, o))
    return normal, dot(normal, o)


def is_in_plane(at, face, plane):
    return all(dot(plane[0], at[k]) == plane[1] for k in face)


def is_convex(ring, normal):
    """Is a ring in a plane strictly convex, once round, counter-clockwise seen from where the normal points?"""
    axis = next(k for k, x in enumerate(normal) if x)
    i, j = ((axis + 1) % 3, (axis + 2) % 3)[::1 if normal[axis] > 0 else -1]
    return goes_round_once([(q[i] - p[i], q[j] - p[j]) for p, q in around(ring)])


def surface(steps, homes, body, faces):
    """The faces are those of the hull of a body's points, which is solid."""
    vertices = {*itertools.chain(*faces)}
    at, edges = seen_from_mean(steps, body, vertices, sum(map(len, faces))), Surface("surface")
    planes = [plane_of(at, face) for face in faces]
    for f, (face, plane) in enumerate(zip(faces, planes)):
        is_face = plane[1] > 0 and is_in_plane(at, face, plane) and is_convex([at[k] for k in face], plane[0])
        require(is_face, "surface", "face %d is no strictly convex polygon that is seen from outside" % f)
        for edge, (_, after) in zip(around(face), around(face[1:] + face[:1])):
            edges.take((f, *edge), 0, after, "two faces have the edge from %d to %d" % edge)
    for (normal, height), face in zip(planes, faces):
        for edge in around(face):
            after = edges.beyond((None, *edge), 0, "only one face contains the edge from %d to %d" % edge)
            require(dot(normal, at[after]) < height, "surface", "the edge from %d to %d is not convex" % edge)
    middle = sum_of(at[k] for k in faces[0])
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
    at = seen_from_mean(steps, body, vertices, len(ring))
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


def solid_hull(rule, body, proved):
    """The faces of the hull of a body's points, which is solid."""
    hull, faces = proved.get(body.base, ("", ()))
    require(hull == "solid", rule, "that the hull of %s is solid has not been proved before" % body.name)
    return faces


def bounds_hull(steps, beneath, body, polygons, proved):
    """Polygons, counted modulo two, cover the boundary of the hull of a body's points, which is solid, once."""
    faces = solid_hull("bounds_hull", body, proved)
    require(max(beneath) < len(faces), "bounds_hull", "a face is none of the hull's")
    steps.take(16 * sum(map(len, polygons)), body.bits, 2 * body.bits)
    odd, beside, (u, v) = set(), False, (body.rows[k] for k in faces[0][:2])
    for p, (polygon, facet) in enumerate(zip(polygons, beneath)):
        is_on = is_in_plane(body.rows, polygon, plane_of(body.rows, faces[facet]))
        require(is_on, "bounds_hull", "face %d is not in the plane of the one beneath it" % p)
        for edge in around([body.rows[k] for k in polygon]):
            odd ^= {frozenset(edge)} if edge[0] != edge[1] else set()
            if facet == 0 and u in edge and edge[0] != edge[1]:
                beside ^= not any(cross(minus(v, u), minus(edge[edge[0] == u], u)))
    require(not odd, "bounds_hull", "an edge is one of an odd number of faces")
    require(beside, "bounds_hull", "the faces cover the hull an even number of times")


def leaves_hull(steps, body, polygons, face, proved):
    """No face of the hull of a body's points, which is solid, holds all corners of a polygon."""
    faces = solid_hull("leaves_hull", body, proved)
    steps.take(8 * len(faces) * len(polygons[face]), body.bits, 2 * body.bits)
    is_off = not any(is_in_plane(body.rows, polygons[face], plane_of(body.rows, one)) for one in faces)
    require(is_off, "leaves_hull", "face %d is in the plane of a face of the hull" % face)
