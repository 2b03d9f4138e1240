"""How deep two bodies are in each other: docs/claims.md, "Depth"."""
import itertools

from .reader import bits, common, length, projective, require
from .rules import aligned, holds, reach, weighted_sum
from .tables import around, cross, dot


def covers(m, u, v):
    """Is m - sqrt(u) - sqrt(v) not negative? No number under a root is."""
    rest = m * m - u - v
    return m >= 0 and rest >= 0 and rest * rest >= 4 * u * v


def covers_with(m, u, v):
    """Is m + sqrt(u) - sqrt(v) not negative?"""
    if m < 0:
        rest = u - m * m - v
        return rest >= 0 and rest * rest >= 4 * m * m * v
    rest = v - m * m - u
    return rest <= 0 or 4 * m * m * u >= rest * rest


def leaves(steps, direction, a, b, most):
    """Along a direction A reaches by no more than `most` beyond where B begins."""
    d, (n, _, unit) = common(direction)[0], most
    (of_a, _), (of_b, _) = reach(steps, "leaves", a, d), reach(steps, "leaves", b, [-x for x in d])
    size, leaves_it = bits(d) + a.size + b.size + length([most]), any(d)
    for (m, e, u), (k, f, v) in itertools.product(of_a, of_b):
        steps.take(16, size, size)
        last, first = aligned(m, e, -k, f)
        squares = ((first - last) ** 2, 1, 2 * min(e, f)), (n * n * dot(d, d), 1, 2 * unit), u, v
        (s, w, x, y), _, _ = common(squares)
        if last > first:
            leaves_it = leaves_it and w >= s and covers(s + w - x - y, 4 * s * w, 4 * x * y)
        else:
            leaves_it = leaves_it and covers_with(s + w - x - y, 4 * s * w, 4 * x * y)
    require(leaves_it, "leaves", "along the direction they overlap by more than the stated depth")


def place_of(steps, end, body):
    """The point of the core that the weights of a hull make; of others the point, which the body holds."""
    weights, point, origin = end
    if body.kind in (None, "radius"):
        reason = "a weight of %s is negative" % body.name
        (*mean, total), d, e = weighted_sum(steps, weights, body.image, 0, "surrounds", reason)
        total, one = aligned(total, e, d, 0)
        require(total == one, "surrounds", "the weights of %s do not sum to 1" % body.name)
        return [(n, d, e) for n in mean]
    holds(steps, weights, origin, body, point)
    return point


def difference_of(steps, corner, a, b):
    """x, y, z, w of a point of A less one of B."""
    p, q = (place_of(steps, end, body) for end, body in zip(corner, (a, b)))
    size, way = a.size + b.size + length(p) + length(q), []
    steps.take(16, size, size)
    for x, y in zip(p, q):
        (m, n), d, e = common([x, y])
        way.append((m - n, d, e))
    return projective(way)


def surrounds(steps, corners, triangles, a, b, least):
    """A surface around the origin, of points of A less points of B, is nowhere nearer to it than `least` less the radii;
    or one point is as near as they exceed it."""
    radii = [body.radius if body.kind == "radius" else (0, 1, 0) for body in (a, b)]
    (rest, *of_radii), whole, e = common([least, *radii])
    rest -= sum(of_radii)
    at = [difference_of(steps, corner, a, b) for corner in corners]
    size = max(length([least, *radii]), *map(bits, at), 0)
    if not triangles:
        require(len(at) == 1, "surrounds", "there is no surface, and more than one point")
        (*p, w), = at
        steps.take(8, size, size)
        (square, wanted), _, _ = common([(dot(p, p), 1, 0), ((rest * w) ** 2, whole * whole, 2 * e)])
        require(rest <= 0 and square <= wanted, "surrounds", "the point is too far from the origin")
        return
    edges = set()
    for triangle in triangles:
        steps.take(24, size, size)
        p, q, r = (at[k] for k in triangle)
        products = cross(p, q), cross(q, r), cross(r, p)
        volume = dot(p[:3], products[1])
        require(volume > 0, "surrounds", "a triangle is not counterclockwise from outside")
        if rest > 0:
            normal = [dot((r[3], p[3], q[3]), axis) for axis in zip(*products)]
            (far, wanted), _, _ = common([(volume ** 2, 1, 0), (rest ** 2 * dot(normal, normal), whole * whole, 2 * e)])
            require(far >= wanted, "surrounds", "a triangle is too near to the origin")
        for edge in around(triangle):
            require(edge not in edges, "surrounds", "an edge occurs twice in the same direction")
            edges.add(edge)
    require(all((j, i) in edges for i, j in edges), "surrounds", "the surface is not closed")
