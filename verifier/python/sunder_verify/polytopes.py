"""The rules about polytopes of R^d, of points or of half-spaces: docs/claims.md, "Polytopes"."""
from .linear import Basis, aligned, mean_of, way_between, weighted_sum
from .reader import bits, common, length, projective, require
from .tables import dot, products_of


def keeps(steps, weights, at, body, point):
    """A polytope holds a point: as a convex combination of its points, or as the image of one that its rows keep."""
    d = body.dimension
    if body.is_of_points:
        up = min(body.exponent, 0)  # rows and a one, in one unit
        v, w, e = mean_of(steps, "keeps", weights, body, lambda k: (
            *(x << (body.exponent - up) for x in body.rows[k]), 1 << -up, up))
    else:
        (*v, w), e = projective(at), 0
        words = "half-space ", " of %s does not hold its point" % body.name
        ends_at(steps, "keeps", body, (*v, w), length(at), words)
    *p, q = projective(point)
    image = v
    if body.linear:
        steps.take(d * d, length(point), bits(body.linear))
        turned, e = body.turned + e, min(body.turned + e, body.moved)
        image = [(dot(body.linear[r * d:r * d + d], v) << (turned - e)) + (t * w << (body.moved - e))
                 for r, t in enumerate(body.translation)]
    for axis, (m, n) in enumerate(zip(image, p)):
        m, wanted = aligned(m * q, e, n * w, 0)
        require(m == wanted, "keeps", "the weighted point of %s differs from the stated point in coordinate %d" % (body.name, axis))


def ends_at(steps, rule, given, place, size, words):
    """All half-spaces hold a point x, .., w, or go on along a direction, with w = 0; those at whose boundary it is, or
    along it. `words` stand before and after the number of one that does not."""
    steps.take(len(given), size, given.bits)
    found = set()
    for k, row in enumerate(given.rows):
        excess = dot(row[:-1], place) - row[-1] * place[-1]
        if excess == 0:
            found.add(k)
        require(excess <= 0, rule, str(k).join(words))
    return found


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


# ---- Half-spaces: a polytope of these, not placed.

def rank(steps, rows):
    """How many of these rows of integers are independent."""
    wide = len(rows[0]) * max(map(bits, rows)) if rows else 0
    steps.take(len(rows), wide, wide)
    return len(Basis(len(rows[0]) if rows else 0, rows).rows)


def combined(steps, rule, multipliers, given):
    """The sum of the rows by multipliers: its normal and its b, which are to be divided by n, times 2^e."""
    if not multipliers:
        return [0] * given.dimension, 0, 1, 0
    (*normal, b), n, e = weighted_sum(steps, multipliers, lambda k: (*given.rows[k], given.exponent), 1, rule,
                                      "a multiplier is not positive")
    return normal, b, n, e


def normals_of(multipliers, given):
    return [given.rows[k][:-1] for k, _ in multipliers]


def contradicted(steps, multipliers, given):
    """No point keeps the rows."""
    normal, b, _, _ = combined(steps, "contradicted", multipliers, given)
    require(not any(normal) and b < 0, "contradicted", "the combined rows have a common point")


def spans(steps, multipliers, given, dimension, points):
    """The common part has that dimension: that of these points of it, and rows that hold it there have all the rest."""
    require(len(points) == dimension + 1, "spans", "the number of points is not the dimension plus one")
    places = [projective(point) for point in points]
    for point, place in zip(points, places):
        ends_at(steps, "spans", given, place, length(point), ("half-space ", " does not hold a point"))
    require(rank(steps, places) == len(places), "spans", "the points are in a flat of less dimensions")
    normal, b, _, _ = combined(steps, "spans", multipliers, given)
    require(not any(normal) and b == 0, "spans", "the combined rows are not zero")
    require(rank(steps, normals_of(multipliers, given)) + dimension == given.dimension, "spans",
            "the rows leave more dimensions")


def enclosed(steps, multipliers, given):
    """No direction leads on in all half-spaces."""
    normal, _, _, _ = combined(steps, "enclosed", multipliers, given)
    require(not any(normal), "enclosed", "the combined normals are not zero")
    require(rank(steps, normals_of(multipliers, given)) == given.dimension, "enclosed", "the normals do not span all")


def recedes(steps, direction, given, rule="recedes"):
    """A direction leads on in all half-spaces."""
    way = common(direction)[0]
    require(any(way), rule, "there is no direction")
    ends_at(steps, rule, given, (*way, 0), bits(way), ("the direction leaves half-space ", ""))


def rises(steps, direction, given, objective):
    """The same, and it leads further along the objective."""
    recedes(steps, direction, given, "rises")
    require(dot(common(objective)[0], common(direction)[0]) > 0, "rises", "the direction does not lead further")


def tops(steps, multipliers, given, objective, point, is_only=False):
    """No common point is further along the objective than the point; nor, if is_only, as far."""
    rule = "tops_only" if is_only else "tops"
    normal, b, n, e = combined(steps, rule, multipliers, given)
    up, _, f = common(objective)
    require(any(up), rule, "there is no objective")
    *p, w = projective(point)
    for m, wanted in [*zip(normal, up), (b * w, dot(up, p))]:
        m, wanted = aligned(m, e, wanted * n, f)
        require(m == wanted, rule, "the combined rows do not bound the objective at the point")
    if is_only:
        require(rank(steps, normals_of(multipliers, given)) == given.dimension, rule, "the normals do not span all")


def another(steps, given, objective, point, as_good):
    """Another point, as far along the objective."""
    way = way_between(projective(point), projective(as_good))
    require(any(way), "another", "it is the same point")
    require(dot(common(objective)[0], way) == 0, "another", "it is not as far along the objective")
