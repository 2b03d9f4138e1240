"""The rules about polytopes of R^d, of points or of half-spaces: docs/claims.md, "Polytopes"."""
from .reader import bits, common, length, projective, require
from .rules import aligned, weighted_sum
from .tables import dot, products_of


def keeps(steps, weights, at, body, point):
    """A polytope holds a point: as a convex combination of its points, or as the image of one that its rows keep."""
    d = body.dimension
    if body.is_of_points:
        up = min(body.exponent, 0)  # rows and a one, in one unit
        (*v, w), n, e = weighted_sum(
            steps, weights, lambda k: (*(x << (body.exponent - up) for x in body.rows[k]), 1 << -up, up), 0, "keeps",
            "a weight of %s is negative" % body.name)
        total, one = aligned(w, e, n, 0)
        require(total == one, "keeps", "the weights of %s do not sum to 1" % body.name)
    else:
        *v, w = projective(at)
        steps.take(len(body), length(at), body.bits)
        for k, row in enumerate(body.rows):
            require(dot(row, v) <= row[d] * w, "keeps", "half-space %d of %s does not hold its point" % (k, body.name))
    *p, q = projective(point)
    image, e = v, 0
    if body.linear:
        steps.take(d * d, length(point), bits(body.linear))
        e = min(body.turned, body.moved)
        image = [(dot(body.linear[r * d:r * d + d], v) << (body.turned - e)) + (t * w << (body.moved - e))
                 for r, t in enumerate(body.translation)]
    for axis, (m, n) in enumerate(zip(image, p)):
        m, wanted = aligned(m * q, e, n * w, 0)
        require(m == wanted, "keeps", "the point of %s is another one in coordinate %d" % (body.name, axis))


def planes_of(steps, body, planes):
    """Half-spaces that hold all of a polytope of points, where it is no image: of each integers, d and e."""
    result = []
    for k, plane in enumerate(planes):
        steps.take(len(plane), length(plane), length(plane))
        integers, n, e = common(plane)
        steps.take(len(body), bits(integers), body.bits)
        furthest, most = aligned(max(products_of(integers[:-1], body.rows)), body.exponent, integers[-1], 0)
        require(furthest <= most, "parted_by_hyperplanes", "hyperplane %d of %s does not hold all of it" % (k, body.name))
        result.append((integers, n, e))
    return result


def limit(steps, body, multipliers, direction, side, planes=None):
    """How far a polytope goes along a direction, or (side -1) its opposite, at most; as numbers to be summed. Of
    planes: as of half-spaces."""
    rule = "parted_by" if planes is None else "parted_by_hyperplanes"
    d, (along, denominator, e) = body.dimension, common(direction)
    along, turned, moved = [side * n for n in along], e + body.turned, []
    if body.linear:
        steps.take(d * d, bits(along), bits(body.linear))
        moved = [(dot(along, body.translation), denominator, e + body.moved)]
        along = [dot(along, body.linear[c::d]) for c in range(d)]
    if body.is_of_points and planes is None:
        steps.take(len(body), bits(along), body.bits)
        return moved + [(max(products_of(along, body.rows)), denominator, turned + body.exponent)]
    (*normal, b), n, f = [0] * (d + 1), 1, 0
    row_of = lambda k: (*body.rows[k], body.exponent)
    if body.is_of_points:
        multipliers = [(k, (n, m * planes[k][1], e)) for k, (n, m, e) in multipliers]
        row_of = lambda k: (*planes[k][0], planes[k][2])
    if multipliers:
        (*normal, b), n, f = weighted_sum(steps, multipliers, row_of, 0, rule,
                                          "a multiplier of %s is negative" % body.name)
    for m, wanted in zip(normal, along):
        m, wanted = aligned(m * denominator, f, wanted * n, turned)
        require(m == wanted, rule, "the multipliers of %s do not make the direction" % body.name)
    return moved + [(b, n, f)]


def parted_by(steps, direction, of_a, of_b, a, b):
    """A is strictly less far along a direction than B."""
    ends = limit(steps, a, of_a, direction, 1) + limit(steps, b, of_b, direction, -1)
    steps.take(16, length(ends), length(ends))
    require(sum(common(ends)[0]) < 0, "parted_by", "%s is not strictly less far along the direction than %s" % (
        a.name, b.name))


def parted_by_hyperplanes(steps, direction, planes_a, of_a, planes_b, of_b, a, b):
    """Half-spaces around A and around B contradict."""
    planes_a, planes_b = planes_of(steps, a, planes_a), planes_of(steps, b, planes_b)
    ends = limit(steps, a, of_a, direction, 1, planes_a) + limit(steps, b, of_b, direction, -1, planes_b)
    steps.take(16, length(ends), length(ends))
    require(sum(common(ends)[0]) < 0, "parted_by_hyperplanes", "the half-spaces around %s and %s do not contradict" % (
        a.name, b.name))
