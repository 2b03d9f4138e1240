#!/usr/bin/env python3
"""How often libraries are wrong about meshes that touch, or nearly do: counts, not times.

    bench/mesh_contacts.py [--pairs N] [--seed N] [--check]

Needs numpy and the Python package of Sunder; of python-fcl, coal, cgal and trueform (all of PyPI) what is there. Each is
asked whether two closed meshes that are not convex meet, with its defaults, under the given poses; CGAL's answers are
about the placed coordinates, rounded, as it takes no poses, and with its kernel of exact predicates.

A is a tetrahedron with a dent in one of its faces, with whole coordinates; B is another one, a spike, whose tip points at
another face of A, and whose other corners are on the far side of that face's plane. So what is true follows from the side
of the plane on which the exact image of the tip lies, in fractions; Sunder is not asked for it:

    touching     the tip is on the face, exactly; B is turned about the axes
    a bit apart  the same, one coordinate of the tip moved outwards by one unit in the last place
    a bit in     or inwards
    turned       B has any turn, in doubles, and its tip is moved to the face as near as doubles are; either may be true
    1e-7 apart   a gap of so much, where coordinates are up to some hundreds
    inside       B is small, and in the interior of A

--check exits 1 where one of Sunder's answers is wrong.
"""
import argparse
import math
import random
import sys
from fractions import Fraction

import numpy as np

import sunder
from sunder import solid

try:
    import fcl
except ImportError:
    fcl = None
try:
    import coal
except ImportError:
    coal = None
try:
    from CGAL.CGAL_Kernel import Point_3
    from CGAL.CGAL_Polygon_mesh_processing import Point_3_Vector, Polygon_Vector, do_intersect, polygon_soup_to_polygon_mesh
    from CGAL.CGAL_Polyhedron_3 import Polyhedron_3
    cgal = do_intersect
except ImportError:
    cgal = None
try:
    import trueform
except ImportError:
    trueform = None

# Of a tetrahedron of positive volume whose face of the corners 0, 1 and 3 has a dent down to a fifth point.
TRIANGLES = [[0, 2, 1], [1, 2, 3], [2, 0, 3], [0, 1, 4], [1, 3, 4], [3, 0, 4]]
GROUPS = ("touching", "a bit apart", "a bit in", "turned", "1e-7 apart", "inside")


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def minus(p, q):
    return [x - y for x, y in zip(p, q)]


def volume(p, q, r, s):
    """Six times that of a tetrahedron; its sign tells on which side of the first three points the fourth is."""
    return dot(cross(minus(q, p), minus(r, p)), minus(s, p))


def some_tetrahedron(dice, size):
    """Whole coordinates, positive volume, not too flat; and the bottom of a dent, a point within."""
    while True:
        corners = [[4 * dice.randint(-size, size) for _ in range(3)] for _ in range(4)]
        if volume(*corners) > 4 * size ** 3:
            return corners + [[sum(x) // 4 for x in zip(*corners)]]


def image(pose, p):
    """Exactly."""
    matrix, shift = pose
    return [sum(Fraction(m) * Fraction(x) for m, x in zip(row, p)) + Fraction(t) for row, t in zip(matrix, shift)]


def is_within(p, triangle, normal):
    """Is a point, moved along the normal, clearly within a triangle?"""
    whole = dot(normal, normal)
    parts = [dot(cross(minus(b, a), minus(p, a)), normal) / whole for a, b in zip(triangle, triangle[1:] + triangle[:1])]
    return min(parts) > Fraction(1, 100)


def some_turn(dice):
    """A quarter turn about each axis, or none."""
    order, signs = dice.sample(range(3), 3), [dice.choice((-1, 1)) for _ in range(3)]
    matrix = [[float(signs[r] * (order[r] == c)) for c in range(3)] for r in range(3)]
    return matrix if np.linalg.det(matrix) > 0 else [[-x for x in row] for row in matrix]


def any_turn(dice):
    w, x, y, z = (dice.gauss(0, 1) for _ in range(4))
    n = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / n, x / n, y / n, z / n
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


class Pair:
    """A at rest; B with its pose; do they meet?"""

    def __init__(self, a, b, pose, meet):
        self.a, self.b, self.pose, self.meet = a, b, pose, meet


def some_pair(group, dice):
    while True:
        a = some_tetrahedron(dice, 200)
        if group == "inside":
            p, q, r, _, t = a  # the tetrahedron p, q, r, t is a part of A
            middle = [Fraction(sum(x), 4) for x in zip(p, q, r, t)]
            pose = some_turn(dice), [float(x) for x in middle]
            b = [[x / 2 ** 12 for x in v] for v in some_tetrahedron(dice, 200)]
            placed = [image(pose, v) for v in b]
            faces = [(p, q, r), (p, t, q), (q, t, r), (r, t, p)]
            if all(volume(*face, v) * volume(*face, middle) > 0 for face in faces for v in placed):
                return Pair(a, b, pose, True)
            continue
        face = [a[0], a[2], a[1]]
        normal = cross(minus(face[1], face[0]), minus(face[2], face[0]))  # outwards
        weights = [dice.randint(1, 14) for _ in range(2)]
        weights = [Fraction(w, 16) for w in weights + [16 - sum(weights)]]
        if weights[2] <= 0:
            continue
        tip = [sum(w * p[c] for w, p in zip(weights, face)) for c in range(3)]
        if group == "1e-7 apart":
            tip = [x + Fraction(n) / 10 ** 7 / Fraction(math.sqrt(dot(normal, normal))) for x, n in zip(tip, normal)]
        turn = any_turn(dice) if group == "turned" else some_turn(dice)
        # B in its own place: the tip anywhere, the others along the turned normal and about it.
        own_tip = [float(4 * dice.randint(-50, 50)) for _ in range(3)]
        back = np.array(turn).T
        scale = 400 / math.sqrt(dot(normal, normal))
        far = [[float(round(x)) for x in back @ (np.array(normal) * scale + np.array([dice.randint(-150, 150) for _ in range(3)]))]
               for _ in range(3)]
        b = [own_tip] + [[x + y for x, y in zip(own_tip, v)] for v in far]
        if volume(*b) < 0:
            b[1], b[2] = b[2], b[1]
        if volume(*b) < 1000:
            continue
        b.append([float(round(sum(x) / 4)) for x in zip(*b)])
        shift = [float(x - y) for x, y in zip(tip, image((turn, [0, 0, 0]), own_tip))]
        axis = max(range(3), key=lambda c: abs(normal[c]))
        if group in ("a bit apart", "a bit in"):
            way = math.inf if (normal[axis] > 0) == (group == "a bit apart") else -math.inf
            there = math.nextafter(float(tip[axis]), way)
            shift[axis] = float(Fraction(there) - image((turn, [0, 0, 0]), own_tip)[axis])
        pose = turn, shift
        placed = [image(pose, v) for v in b]
        sides = [dot(normal, minus(v, face[0])) for v in placed]
        if min(sides[1:]) <= 0 or not is_within(placed[0], face, normal):
            continue
        if group != "turned" and (sides[0] > 0) - (sides[0] < 0) != {"touching": 0, "a bit in": -1}.get(group, 1):
            continue
        return Pair(a, b, pose, sides[0] <= 0)


# ---- Those who are asked.


def by_sunder(pair):
    a, b = (solid.Mesh(np.array(points, float), TRIANGLES) for points in (pair.a, pair.b))
    return sunder.intersect(a, solid.Pose(), b, solid.Pose.from_matrix(*map(np.array, pair.pose))).meet


def by_fcl(pair):
    def model(points):
        made = fcl.BVHModel()
        made.beginModel(len(points), len(TRIANGLES))
        made.addSubModel(np.array(points, float), np.array(TRIANGLES))
        made.endModel()
        return made
    return fcl.collide(fcl.CollisionObject(model(pair.a), fcl.Transform()),
                       fcl.CollisionObject(model(pair.b), fcl.Transform(*map(np.array, pair.pose)))) > 0


def by_coal(pair):
    def model(points):
        made = coal.BVHModelOBBRSS()
        made.beginModel(len(TRIANGLES), len(points))
        corners, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
        corners.extend([np.array(p, float) for p in points])
        triangles.extend([coal.Triangle(*t) for t in TRIANGLES])
        made.addSubModel(corners, triangles)
        made.endModel()
        return made
    rest, placed = coal.Transform3s(), coal.Transform3s(*map(np.array, pair.pose))
    return coal.collide(model(pair.a), rest, model(pair.b), placed, coal.CollisionRequest(), coal.CollisionResult()) > 0


def by_cgal(pair):
    def model(points):
        corners, faces, made = Point_3_Vector(), Polygon_Vector(), Polyhedron_3()
        for p in points:
            corners.append(Point_3(*map(float, p)))
        for triangle in TRIANGLES:
            faces.append(triangle)
        polygon_soup_to_polygon_mesh(corners, faces, made)
        return made
    matrix, shift = map(np.array, pair.pose)
    return do_intersect(model(pair.a), model(np.array(pair.b, float) @ matrix.T + shift))


def by_trueform(pair):
    a, b = (trueform.Mesh(np.array(TRIANGLES, np.int32), np.array(points, float)) for points in (pair.a, pair.b))
    placed = np.eye(4)
    placed[:3, :3], placed[:3, 3] = pair.pose
    b.transformation = placed
    return bool(trueform.intersects(a, b))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--pairs", type=int, default=500, help="in each group (500)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--check", action="store_true", help="exit 1 where one of Sunder's answers is wrong")
    options = parser.parse_args()
    asked = {"Sunder": by_sunder}
    for name, there, ask in (("FCL", fcl, by_fcl), ("Coal", coal, by_coal), ("CGAL", cgal, by_cgal),
                             ("trueform", trueform, by_trueform)):
        if there is None:
            print("%s is not there, and not asked" % name)
        else:
            asked[name] = ask
    print("%-12s %6s %6s  " % ("wrong of", "pairs", "meet") + " ".join("%8s" % name for name in asked))
    wrong_of_ours = 0
    for group in GROUPS:
        dice = random.Random("%d %s" % (options.seed, group))
        pairs = [some_pair(group, dice) for _ in range(options.pairs)]
        wrong = {name: sum(ask(pair) != pair.meet for pair in pairs) for name, ask in asked.items()}
        wrong_of_ours += wrong["Sunder"]
        print("%-12s %6d %6d  " % (group, len(pairs), sum(pair.meet for pair in pairs)) +
              " ".join("%8d" % wrong[name] for name in asked), flush=True)
    sys.exit(options.check and wrong_of_ours > 0)


if __name__ == "__main__":
    main()
