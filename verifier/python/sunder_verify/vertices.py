"""Which are the vertices of the common part of half-spaces: docs/claims.md, "Half-spaces"."""
import math

from .linear import Basis, Surface
from .polytopes import ends_at
from .reader import length, projective, require


def normal_fan(steps, fans, given, vertices):
    """These are the vertices: each is in all half-spaces, and the end of those of its cones, which are all directions."""
    d = given.dimension
    size = d * given.bits // 2
    steps.take(sum(map(len, fans)) * d ** 3, size, size)
    known, sides = {}, set()
    for v, (point, fan) in enumerate(zip(vertices, fans)):
        place = projective(point)
        on = ends_at(steps, "normal_fan", given, place, length(point), ("half-space ", " does not hold vertex %d" % v))
        steps.take(16, length(point), length(point))
        shared = math.gcd(*place)
        before = known.setdefault(tuple(x // shared for x in place), v)
        require(before == v, "normal_fan", "vertex %d is vertex %d once more" % (v, before))
        for cone in fan:
            for k in cone:
                require(k in on, "normal_fan", "vertex %d is not where half-space %d ends" % (v, k))
            cone = tuple(sorted(cone))
            basis = Basis(d, [given.rows[k][:-1] for k in cone])
            require(basis.are_all, "normal_fan", "the normals of a cone of vertex %d are in a hyperplane" % v)
            sides.update(Surface.key(cone, i, basis.is_positive()) for i in range(d))
    for v, fan in enumerate(fans):
        for cone in fan:
            for i in range(d):
                is_inner = all(Surface.key(sorted(cone), i, side) in sides for side in (False, True))
                require(is_inner, "normal_fan", "there is no cone beyond a ridge of one of vertex %d" % v)
