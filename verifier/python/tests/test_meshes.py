#!/usr/bin/env python3
"""Tests of statements about convex meshes against brute force: python3 verifier/python/tests/test_meshes.py."""
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, lacking, main, some
from test_hulls import cross, dot, honest, minus, some_points, true_hull


def is_covered(points, polygons, on):
    """Is a point of a face, which is on no edge of a polygon, inside of an odd number of those in the plane?"""
    odd = False
    for polygon in polygons:
        for i, j in zip(polygon, polygon[1:] + polygon[:1]):
            (p, q), (x, y) = (points[i], points[j]), on
            if (p[1] > y) != (q[1] > y):
                odd ^= p[0] + Fraction(y - p[1]) * (q[0] - p[0]) / (q[1] - p[1]) > x
    return odd


def is_convex(points, faces, mesh, dice):
    """By the even-odd rule at places of each face, seen along an axis. Each face of the mesh is in one of the hull."""
    left = list(mesh)
    for face in faces:
        normal = cross(minus(points[face[1]], points[face[0]]), minus(points[face[2]], points[face[0]]))
        axis = next(k for k in range(3) if normal[k])
        flat = [tuple(x for k, x in enumerate(p) if k != axis) for p in points]
        those = [m for m in mesh if all(dot(normal, minus(points[k], points[face[0]])) == 0 for k in m)]
        left = [m for m in left if m not in those]
        for _ in range(24):
            weights = [dice.randint(1, 10 ** 6) for _ in face]
            at = [Fraction(sum(w * flat[k][c] for w, k in zip(weights, face)), sum(weights)) for c in range(2)]
            if not is_covered(flat, those, at):
                return False
    return not left


def beneath(points, faces, mesh, dice):
    """The first face of the hull with all corners in its plane; else any."""
    result = []
    for polygon in mesh:
        fit = [f for f, face in enumerate(faces) if all(dot(cross(
            minus(points[face[1]], points[face[0]]), minus(points[face[2]], points[face[0]])),
            minus(points[k], points[face[0]])) == 0 for k in polygon)]
        result.append(dice.choice(fit) if fit else dice.randrange(len(faces)))
    return result


def some_mesh(points, faces, dice):
    """Faces of the hull in pieces, some turned, doubled, dropped, moved, or three of them one upon the other."""
    mesh = []
    for face in faces:
        inner = [k for k, p in enumerate(points) if k not in face and all(dot(cross(
            minus(points[b], points[a]), minus(points[c], points[a])), minus(p, points[a])) == 0
            for a, b, c in [face[:3]])]
        throw = dice.random()
        if throw < .5 and inner and all(points[inner[0]] != points[k] for k in face):
            mesh += [[a, b, inner[0]] for a, b in zip(face, face[1:] + face[:1])]
        elif throw < .8:
            mesh += [[face[0], face[k], face[k + 1]] for k in range(1, len(face) - 1)]
        else:
            mesh.append(list(face))
    for _ in range(dice.choice([0, 0, 1, 1, 2])):
        change, m = dice.randint(0, 6), dice.randrange(len(mesh))
        if change == 0:
            mesh[m] = mesh[m][::-1]
        elif change == 1 and len(mesh) > 1:
            mesh.pop(m)
        elif change == 2:
            mesh.append(list(mesh[m]))
        elif change == 3:
            mesh[m][dice.randrange(len(mesh[m]))] = dice.randrange(len(points))
        elif change == 4:
            mesh += mesh
        elif change == 5:
            mesh += [list(mesh[m]), mesh[m][::-1]]
        else:
            mesh.append([mesh[m][0], mesh[m][1], mesh[m][0]])
    return mesh


def file_about(points, faces, mesh, dice):
    top = honest(points)
    statement = {"question": "mesh", "body": 0, "mesh_faces": mesh, "verdict": "convex",
                 "claims": [{"claim": "bounds_hull", "beneath": beneath(points, faces, mesh, dice)}]}
    return file_of(top["tables"], *top["statements"], statement)


def not_convex(top, m):
    """The same, but that it is not convex, as polygon m shows."""
    *before, one = top["statements"]
    return {**top, "statements": [*before, {**one, "verdict": "not_convex", "face": m, "claims": [{"claim": "leaves_hull"}]}]}


def some_solid(dice):
    while True:
        points = some_points(dice)
        verdict, faces = true_hull(points)
        if verdict == "solid":
            return points, honest(points)["statements"][0]["faces"]


class MeshesTest(unittest.TestCase):
    def test_no_forced_mesh_is_convex_if_it_is_not(self):
        dice, twins, convex = dice_of(1), Twins(self), 0
        while "convex" in lacking(FORCED, "mesh") or twins.count < some(300):
            points, faces = some_solid(dice)
            mesh = some_mesh(points, faces, dice)
            truth = is_convex(points, faces, mesh, dice)
            said = twins.force(file_about(points, faces, mesh, dice))
            self.assertTrue(truth or said != "accepted", twins.last)
            convex += said == "accepted"
        twins.compare()
        self.assertTrue(some(100) < 100 or convex > twins.count / 10, convex)

    def test_faces_of_the_hull_are_convex(self):
        dice, twins = dice_of(2), Twins(self)
        for _ in range(some(100)):
            points, faces = some_solid(dice)
            self.assertEqual(twins.look(file_about(points, faces, [list(f) for f in faces], dice)), "accepted")
        top = file_about(points, faces, faces, dice)
        self.assertEqual(twins.look(file_of(top["tables"], top["statements"][1])), "bounds_hull")
        twins.compare()

    def test_a_polygon_in_no_face_of_the_hull_shows_that_a_mesh_is_not_convex(self):
        dice, twins = dice_of(4), Twins(self)
        while "not_convex" in lacking(FORCED, "mesh") or twins.count < some(300):
            points, faces = some_solid(dice)
            mesh = some_mesh(points, faces, dice)
            if dice.random() < .5:
                dice.choice(mesh)[0] = dice.randrange(len(points))
            off = [m for m, polygon in enumerate(mesh) if not any(all(dot(
                cross(minus(points[face[1]], points[face[0]]), minus(points[face[2]], points[face[0]])),
                minus(points[k], points[face[0]])) == 0 for k in polygon) for face in faces)]
            m = dice.choice(off or range(len(mesh))) if dice.random() < .7 else dice.randrange(len(mesh))
            top, is_off = file_about(points, faces, mesh, dice), m in off
            self.assertEqual(twins.force(not_convex(top, m)), "accepted" if is_off else "leaves_hull", twins.last)
            self.assertFalse(is_off and is_convex(points, faces, mesh, dice), twins.last)
        other = {**top, "statements": not_convex(top, m)["statements"][1:]}  # its hull is not stated before
        self.assertEqual(twins.look(other), "leaves_hull")
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally()[word] for word in ("accepted", "leaves_hull")) > 20)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, "mesh"):
            points, faces = some_solid(dice)
            top = file_about(points, faces, some_mesh(points, faces, dice), dice)
            twins.spoil(top, dice)
            twins.spoil(not_convex(top, 0), dice)
        twins.compare()


if __name__ == "__main__":
    main()
