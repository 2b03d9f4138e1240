#!/usr/bin/env python3
"""Tests of statements about convex hulls against brute force: python3 verifier/python/tests/test_hulls.py."""
import itertools
import json
import unittest

from files import FORCED, MUTANT, Twins, dice_of, file_of, hexadecimal, lacking, main, some, sunder_verify


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def cross(u, v):
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def hull_of_line(points):
    """The two points that have all others between them."""
    return [(i, j) for i, p in enumerate(points) for j, q in enumerate(points)
            if p != q and all(dot(minus(r, p), minus(r, q)) <= 0 for r in points)]


def ring_of(points, which, normal):
    """Of points in one plane the strictly extreme ones, counter-clockwise seen from where the normal points; the first of
    those that are equal."""
    def turn(i, j, k):
        return dot(normal, cross(minus(points[j], points[i]), minus(points[k], points[i])))
    after = {}
    for i, j in itertools.permutations(which, 2):
        if points[i] == points[j] or points[i] in [points[k] for k in range(i) if k in which]:
            continue
        rest = [k for k in which if points[k] not in (points[i], points[j])]
        if points[j] in [points[k] for k in range(j) if k in which]:
            continue
        if all(turn(i, j, k) >= 0 for k in rest) and not any(
                turn(i, j, k) == 0 and dot(minus(points[k], points[i]), minus(points[k], points[j])) > 0 for k in rest):
            after[i] = j
    ring = [min(after)]
    while after[ring[-1]] != ring[0]:
        ring.append(after[ring[-1]])
    return ring


def true_hull(points):
    """The verdict, and the faces, the outline, or the ends."""
    if len(set(points)) == 1:
        return "point", None
    normals = {}
    for i, j, k in itertools.combinations(range(len(points)), 3):
        normal = cross(minus(points[j], points[i]), minus(points[k], points[i]))
        if any(normal):
            heights = [dot(normal, minus(p, points[i])) for p in points]
            on = tuple(m for m, height in enumerate(heights) if height == 0)
            if max(heights) <= 0:
                normals[on] = normal
            elif min(heights) >= 0:
                normals[on] = minus((0, 0, 0), normal)
    if not normals and len(hull_of_line(points)) > 0:
        return "segment", hull_of_line(points)
    if len(normals) == 1 and len(next(iter(normals))) == len(points):
        return "flat", ring_of(points, next(iter(normals)), next(iter(normals.values())))
    return "solid", [ring_of(points, on, normal) for on, normal in normals.items()]


def homes_of(points, faces):
    """Of each vertex None; of each other point a triangle that it is behind, seen from the mean of the vertices."""
    vertices = sorted({k for face in faces for k in face})
    mean = [sum(points[k][axis] for k in vertices) for axis in range(3)]
    at = [tuple(len(vertices) * x - y for x, y in zip(p, mean)) for p in points]

    def is_home(k, face, c):
        a, b, d = (at[m] for m in (face[0], face[c], face[c + 1]))
        return all(dot(cross(p, q), at[k]) >= 0 for p, q in ((a, b), (b, d), (d, a)))
    return [None if k in vertices else next([f, c] for f, face in enumerate(faces) for c in range(1, len(face) - 1)
                                            if is_home(k, face, c)) for k in range(len(points))]


def sectors_of(points, ring):
    mean = [sum(points[k][axis] for k in ring) for axis in range(3)]
    at = [tuple(len(ring) * x - y for x, y in zip(p, mean)) for p in points]
    normal = cross(at[ring[0]], at[ring[1]])
    return [None if k in ring else next(m for m in range(len(ring))
                                        if dot(normal, cross(at[ring[m]], at[k])) >= 0
                                        and dot(normal, cross(at[k], at[ring[(m + 1) % len(ring)]])) >= 0)
            for k in range(len(points))]


def statement_of(points, verdict, *found):
    says, claim = {}, {"claim": {"solid": "surface", "flat": "outline", "segment": "between", "point": "one_point"}[verdict]}
    if verdict == "solid":
        says, claim["homes"] = {"faces": found[0]}, found[1]
    elif verdict == "flat":
        says, claim["sectors"] = {"outline": found[0]}, found[1]
    elif verdict == "segment":
        says = {"i": found[0], "j": found[1]}
    table = {"bodies": [{"name": "points", "points": [[hexadecimal(x) for x in p] for p in points]}]}
    return file_of(table, {"question": "hull", "body": 0, "verdict": verdict, **says, "claims": [claim]})


def honest(points):
    verdict, found = true_hull(points)
    if verdict == "solid":
        return statement_of(points, verdict, found, homes_of(points, found))
    if verdict == "flat":
        return statement_of(points, verdict, found, sectors_of(points, found))
    return statement_of(points, verdict, *(found[0] if verdict == "segment" else ()))


def some_points(dice):
    """Few places, so that there are faces of many corners, points on faces and edges, and twice."""
    size, throw = dice.choice([1, 2, 3]), dice.random()
    count = dice.randint(1, 4) if dice.random() < .2 else dice.randint(4, 11)
    points = [tuple(dice.randint(-size, size) for _ in range(3)) for _ in range(count)]
    if throw < .2:
        points = [(x, y, x + y) for x, y, _ in points]
    elif throw < .3:
        points = [(x, 2 * x, -x) for x, _, _ in points]
    elif throw < .35:
        points = points[:1] * count
    return points


def turned(ring):
    k = ring.index(min(ring))
    return tuple(ring[k:] + ring[:k])


def is_so(points, statement):
    """Is this the hull? Points that are equal stand for each other."""
    verdict, found = true_hull(points)
    first = {p: points.index(p) for p in points}

    def named(ring):
        return turned([first[points[k]] for k in ring])
    if statement["verdict"] != verdict:
        return False
    if verdict == "solid":
        return sorted(map(named, statement["faces"])) == sorted(map(named, found))
    if verdict == "flat":
        ring = named(statement["outline"])
        return ring in (named(found), turned(list(named(found))[::-1]))
    return verdict == "point" or (first[points[statement["i"]]], first[points[statement["j"]]]) in found


def changed(top, points, dice):
    """The statement, or one of another verdict, with a few changes."""
    one = top["statements"][0]
    verdict = dice.choice([one["verdict"]] * 3 + ["solid", "flat", "segment", "point"])
    if verdict != one["verdict"]:
        n = len(points)
        ring = dice.sample(range(n), min(n, dice.choice([3, 3, 4])))
        if verdict in ("solid", "flat") and n < 3:
            return None
        if verdict == "solid":
            faces = [ring, ring[::-1]] if dice.random() < .5 else [dice.sample(range(n), 3) for _ in range(4)]
            return statement_of(points, verdict, faces, [None if any(k in f for f in faces) else [0, 1] for k in range(n)])
        if verdict == "flat":
            return statement_of(points, verdict, ring, [None if k in ring else dice.randrange(len(ring)) for k in range(n)])
        return statement_of(points, verdict, *(dice.choices(range(n), k=2) if verdict == "segment" else ()))
    if verdict == "solid":
        faces, homes = [list(f) for f in one["faces"]], list(one["claims"][0]["homes"])
        for _ in range(dice.randint(1, 2)):
            change, f = dice.randint(0, 6), dice.randrange(len(faces))
            if change == 0:
                faces[f].reverse()
            elif change == 1 and len(faces) > 1:
                faces.pop(f)
            elif change == 2:
                k = dice.randrange(len(faces[f]))
                faces[f][k] = dice.randrange(len(points))
            elif change == 3 and len(faces[f]) > 3:  # into two
                faces += [faces[f][:3], faces[f][2:] + faces[f][:1]]
                faces.pop(f)
            elif change == 4:  # another point for a vertex, everywhere
                a, b = dice.randrange(len(points)), dice.randrange(len(points))
                faces = [[b if k == a else k for k in face] for face in faces]
            elif change == 5:
                faces[f] = faces[f][1:] + faces[f][:1]
            else:
                k = dice.randrange(len(homes))
                homes[k] = None if homes[k] else [f, 1]
        vertices = {k for face in faces for k in face}
        homes = [None if k in vertices and dice.random() < .9 else home or [dice.randrange(len(faces)), 1]
                 for k, home in enumerate(homes)]
        return statement_of(points, verdict, faces, homes)
    if verdict == "flat":
        ring = list(one["outline"])
        change = dice.randint(0, 3)
        if change == 0:
            ring.reverse()
        elif change == 1:
            ring[dice.randrange(len(ring))] = dice.randrange(len(points))
        elif change == 2 and len(ring) > 3:
            ring.pop(dice.randrange(len(ring)))
        else:
            ring.insert(dice.randrange(len(ring)), dice.randrange(len(points)))
        return statement_of(points, verdict, ring, [None if k in ring else dice.randrange(len(ring)) for k in range(len(points))])
    return statement_of(points, verdict, *(dice.choices(range(len(points)), k=2) if verdict == "segment" else ()))


class HullsTest(unittest.TestCase):
    def test_each_hull_is_proved(self):
        dice, twins, verdicts = dice_of(1), Twins(self), []
        for _ in range(some(1000)):
            top = honest(some_points(dice))
            verdicts.append(top["statements"][0]["verdict"])
            self.assertEqual(twins.look(top), "accepted", top)
        twins.compare()
        for verdict in ("solid", "flat", "segment", "point"):
            self.assertTrue(some(100) < 100 or verdicts.count(verdict) > len(verdicts) / 100, verdict)

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while lacking(FORCED, "hull"):
            points = some_points(dice)
            top = honest(points)
            for _ in range(4):
                forced = changed(top, points, dice)
                if forced is None:
                    continue
                said = twins.force(forced)
                accepted += said == "accepted"
                self.assertTrue(said != "accepted" or is_so(points, forced["statements"][0]), forced)
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > 0)

    def test_a_surface_that_goes_around_twice(self):
        """Closed, convex at each edge, each face seen from the middle, and not the hull of anything."""
        twins, rim = Twins(self), [(4, 0), (1, 4), (-3, 2), (-3, -2), (1, -4)]
        points = [(x, y, 0) for x, y in rim] + [(0, 0, 3), (0, 0, -3)]
        for step, wanted in ((1, "accepted"), (2, "surface")):
            order = [k * step % 5 for k in range(5)]
            faces = [[a, b, 5] for a, b in zip(order, order[1:] + order[:1])]
            faces += [[b, a, 6] for a, b, _ in faces]
            top = statement_of(points, "solid", faces, [None] * len(points))
            self.assertEqual(twins.look(top), wanted)
        ((_, refusal),) = sunder_verify.verify(json.dumps(top).encode()).statements
        self.assertIn("is in the way of face 0", refusal[1])
        twins.compare()

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, "hull"):
            top = honest(some_points(dice))
            if top["statements"][0]["verdict"] in lacking(MUTANT, "hull"):
                twins.spoil(top, dice)
        twins.compare()


if __name__ == "__main__":
    main()
