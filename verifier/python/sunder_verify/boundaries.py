"""What is the convex hull of points of R^d, as facets: docs/claims.md, "Boundaries".

Points are seen from the mean of the corners, and as many times as far from it as there are of these.
"""
import itertools

from .linear import Basis, Surface, from_mean, sum_of
from .reader import require
from .tables import dot


def flat(points, some):
    """The columns that tell the others of all points, if these are combinations of some, which are independent."""
    basis = Basis(len(some[0]), some)
    require(basis.are_all, "boundary", "the corners of the first simplex and the mean of all are in a flat")
    for k, p in enumerate(points):
        require(not any(basis.rest(p)), "boundary", "point %d is not in the flat of the first simplex" % k)
    return sorted(basis.pivots)


def plane(corners):
    """The normal and the height, which is positive, of the plane of independent points; and on which side it is."""
    k = len(corners)
    basis = Basis(k, [(*p, 1) for p in corners])
    if not basis.are_all:
        return None
    sign = 1 if basis.unit > 0 else -1
    normal = [0] * k
    for column, row in zip(basis.pivots, basis.rows):
        normal[column] = sign * row[k]
    return normal, sign * basis.unit, basis.is_positive()


def is_in_cone(corners, point):
    """Is a point a combination of independent ones, with no number less than zero?"""
    basis = Basis(len(corners), zip(*corners, point))
    return all(row[-1] * basis.unit >= 0 for row in basis.rows)


def beside(at, middle):
    """Of each point the signs of some products that are zero of the middle."""
    axis = max(range(len(middle)), key=lambda c: abs(middle[c]))
    rest = [c for c in range(len(middle)) if c != axis]
    return {k: [p[c] * middle[axis] - p[axis] * middle[c] for c in rest] for k, p in at.items()}


def boundary(steps, homes, body, facets):
    """The facets are those of the hull of a body's points: each a list of simplices, which are lists of points."""
    simplices = [simplex for facet in facets for simplex in facet]
    facet_of = [f for f, facet in enumerate(facets) for _ in facet]
    corners, k = {*itertools.chain(*simplices)}, len(simplices[0])
    size = k * (body.bits + len(corners).bit_length() + 1) // 2
    steps.take((len(body) + len(simplices)) * k ** 3, size, size)
    points = from_mean(body.rows, corners)
    columns = flat(points, [points[v] for v in simplices[0]])
    points = [[p[c] for c in columns] for p in points]
    planes, surface, held = [], Surface("boundary"), [{*itertools.chain(*facet)} for facet in facets]
    for s, simplex in enumerate(simplices):
        found = plane([points[v] for v in simplex])
        require(found and (not planes or found[2] == planes[0][2]), "boundary",
                "simplex %d is not seen from the mean as the first one is" % s)
        planes.append(found)
        normal, height, _ = found
        if s == 0 or facet_of[s - 1] < facet_of[s]:
            require(all(dot(normal, points[v]) == height for v in held[facet_of[s]]), "boundary",
                    "facet %d is not in one plane" % facet_of[s])
        for i, v in enumerate(simplex):
            surface.take(simplex, i, (s, v), "two simplices are on one side of a ridge of simplex %d" % s)
    for s, simplex in enumerate(simplices):
        for i in range(k):
            t, w = surface.beyond(simplex, i, "only one simplex contains a ridge of simplex %d" % s)
            normal, height, _ = planes[s]
            require(facet_of[s] == facet_of[t] or dot(normal, points[w]) < height, "boundary",
                    "facets %d and %d are not convex at a ridge" % (facet_of[s], facet_of[t]))
    middle = sum_of(points[v] for v in simplices[0])
    signs = beside({v: points[v] for v in corners}, middle)
    for s, simplex in enumerate(simplices[1:], 1):
        is_beside = any(all(x > 0 for x in xs) or all(x < 0 for x in xs) for xs in zip(*(signs[v] for v in simplex)))
        require(is_beside or not is_in_cone([points[v] for v in simplex], middle), "boundary",
                "simplex %d is in the way of the first" % s)
    facets_at = {v: [] for v in corners}
    for f, those in enumerate(held):
        for v in those:
            facets_at[v].append(f)
    for v in sorted(corners):
        those = sorted((held[f] for f in facets_at[v]), key=len)
        steps.take(len(those) * len(those[0]), 0, 0)
        common = set.intersection(*those)
        require(common == {v}, "boundary", "point %d is between others" % v)
    for q, home in enumerate(homes):
        if home is None:
            require(q in corners, "boundary", "point %d has no home" % q)
            continue
        normal, height, _ = planes[home]
        require(dot(normal, points[q]) <= height and is_in_cone([points[v] for v in simplices[home]], points[q]),
                "boundary", "point %d is not in its home" % q)
