"""How deep two bodies are in each other: docs/claims.md, "leaves" and "surrounds"."""
from .linear import Surface, mean_of
from .reader import bits, common, length, projective, require
from .rules import holds
from .tables import cross, dot, turn


def place_of(steps, end, body):
    """The point of the core that the weights of a hull make; of others the point, which the body holds."""
    weights, point, origin = end
    if body.kind in (None, "radius"):
        mean, d, e = mean_of(steps, "surrounds", weights, body, body.image)
        return [(n, d, e) for n in mean]
    holds(steps, weights, origin, body, point)
    return point


def difference_of(steps, corner, a, b):
    """x, y, z, w, or x, y, w, of a point of A less one of B."""
    p, q = (place_of(steps, end, body) for end, body in zip(corner, (a, b)))
    size, way = a.size + b.size + length(p) + length(q), []
    steps.take(16, size, size)
    for x, y in zip(p, q):
        (m, n), d, e = common([x, y])
        way.append((m - n, d, e))
    return projective(way)


def facet_of(corners):
    """The normal, outward, of a triangle that is counterclockwise from outside, or in the plane of an edge; and how far
    along it the corners are. Both are to be divided by the product of the w."""
    if len(corners) == 2:
        p, q = corners
        return (q[1] * p[2] - p[1] * q[2], p[0] * q[2] - q[0] * p[2]), turn(p, q)
    p, q, r = corners
    products = cross(p, q), cross(q, r), cross(r, p)
    return [dot((r[3], p[3], q[3]), axis) for axis in zip(*products)], dot(p[:3], products[1])


def surrounds(steps, corners, triangles, a, b, least):
    """A surface around the origin, of points of A less points of B, is nowhere nearer to it than `least` less the radii;
    or one point is as near as they exceed it."""
    radii = [body.radius if body.kind == "radius" else (0, 1, 0) for body in (a, b)]
    (rest, *of_radii), whole, e = common([least, *radii])
    rest -= sum(of_radii)
    at = [difference_of(steps, corner, a, b) for corner in corners]
    size = max(length([least, *radii]), *map(bits, at), 0)
    if not triangles:
        require(len(at) == 1, "surrounds", "there is no surface, and not one point")
        (*p, w), = at
        steps.take(8, size, size)
        (square, wanted), _, _ = common([(dot(p, p), 1, 0), ((rest * w) ** 2, whole * whole, 2 * e)])
        require(rest <= 0 and square <= wanted, "surrounds", "the point is too far from the origin")
        return
    surface = Surface("surrounds")
    for triangle in triangles:
        steps.take(24, size, size)
        normal, volume = facet_of([at[k] for k in triangle])
        require(volume > 0, "surrounds", "a piece of the surface is not counterclockwise from outside")
        if rest > 0:
            (far, wanted), _, _ = common([(volume ** 2, 1, 0), (rest ** 2 * dot(normal, normal), whole * whole, 2 * e)])
            require(far >= wanted, "surrounds", "a piece of the surface is too near to the origin")
        for i in range(len(triangle)):
            surface.take(triangle, i, None, "an edge occurs twice in the same direction")
    for triangle in triangles:
        for i in range(len(triangle)):
            surface.beyond(triangle, i, "the surface is not closed")
