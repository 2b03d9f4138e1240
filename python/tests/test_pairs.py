"""Pairs of convex polygons and polyhedra: one, and many in one call."""
import json
import threading

import numpy as np
import pytest
import sunder
from sunder import planar, solid

from helpers import proved, refused, statements

CUBE = solid.ConvexPolyhedron([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
SQUARE = planar.ConvexPolygon.from_vertices([[0, 0], [1, 0], [1, 1], [0, 1]])


def at(*translation):
    return solid.Pose.from_matrix(np.eye(3), translation)


def test_one_pair():
    for there, meet, contact in (((0.5, 0, 0), True, "overlapping"), ((1, 1, 1), True, "touching"),
                                 ((np.nextafter(1, 2), 0, 0), False, "none")):
        answer = sunder.intersect(CUBE, solid.Pose(), CUBE, at(*there))
        assert answer.meet is meet is bool(answer)
        assert solid.polyhedron_polyhedron_contact(CUBE, solid.Pose(), CUBE, at(*there)) == contact
        assert answer.decided_by in ("filter", "evidence", "finishing") and answer.cost.probes > 0
        assert statements(answer.certificate()) == [("pair", "meet" if meet else "apart")]
        proved(answer.certificate())
    assert sunder.intersect(CUBE, CUBE) and solid.polyhedron_polyhedron(CUBE, at(9, 9, 9), CUBE, at(9, 9, 9))


def test_one_pair_of_the_plane():
    flip = planar.Pose.from_matrix([[-1, 0], [0, 1]], [3, 0])
    answer = planar.polygon_polygon(SQUARE, planar.Pose(), SQUARE, flip)
    assert not answer and planar.polygon_polygon_contact(SQUARE, planar.Pose(), SQUARE, flip) == "none"
    proved(answer.certificate())
    assert len(json.loads(answer.certificate())["tables"]["bodies"][0]["points"][0]) == 2


def test_poses():
    turn = solid.Pose.from_quaternion(2, 0, 0, 1, [1.7, 0.1, 0.5])
    rows = np.eye(4)
    rows[:3, :3], rows[:3, 3] = turn.linear, turn.translation
    same = solid.Pose.from_matrix4(rows)
    assert np.array_equal(same.linear, turn.linear) and np.array_equal(same.translation, [1.7, 0.1, 0.5])
    assert np.array_equal(solid.compose(at(1, 2, 3), at(3, 2, 1)).translation, [4, 4, 4])
    refused("bad-pose", "pose", solid.Pose.from_matrix, np.zeros((3, 3)), [0, 0, 0])
    rows[3, 3] = 2
    refused("bad-pose", "pose", solid.Pose.from_matrix4, rows)
    assert np.allclose(planar.Pose.from_angle(np.pi / 2, [0, 0]).linear, [[0, -1], [1, 0]])


def test_polygons_that_are_not_convex():
    dent = [[0, 0], [4, 0], [1, 1], [0, 4]]
    assert "vertex 2" in str(pytest.raises(sunder.Error, planar.ConvexPolygon.from_vertices, dent).value)
    assert len(planar.ConvexPolygon.hull_of(dent)) == 3
    assert len(planar.ConvexPolygon.mended([[0, 0], [0, 1], [1, 1], [1, 0.5], [1, 0], [0, 0]])) == 4


def random_poses(count, dimension, seed, shift):
    random = np.random.default_rng(seed)
    poses = np.empty((count, dimension, dimension + 1))
    poses[:, :, :dimension] = random.normal(size=(count, dimension, dimension))
    poses[:, :, dimension] = random.uniform(-shift, shift, (count, dimension))
    return poses


def pose_of(chapter, rows):
    return chapter.Pose.from_matrix(rows[:, :-1], rows[:, -1])


@pytest.mark.parametrize("chapter, dimension, hull", [(planar, 2, planar.ConvexPolygon.hull_of),
                                                      (solid, 3, solid.ConvexPolyhedron)])
def test_many_are_as_one_by_one(chapter, dimension, hull):
    random = np.random.default_rng(7)
    objects = [hull(random.normal(size=(random.integers(1, 40), dimension))) for _ in range(12)]
    count = 400
    poses_a, poses_b = random_poses(count, dimension, 1, 2), random_poses(count, dimension, 2, 2)
    a, b = ([objects[k] for k in random.integers(0, 12, count)] for _ in range(2))
    many = sunder.intersect_many(a, poses_a, b, poses_b)
    one = [sunder.intersect(a[k], pose_of(chapter, poses_a[k]), b[k], pose_of(chapter, poses_b[k])).meet
           for k in range(count)]
    assert many.dtype == bool and many.tolist() == one and count / 10 < sum(one) < count * 9 / 10
    flat = sunder.intersect_many(tuple(a), poses_a.reshape(count, -1), b, np.asfortranarray(poses_b))
    assert np.array_equal(flat, many)
    fixed = sunder.intersect_many(objects[0], poses_a, objects[1], pose_of(chapter, poses_b[0]))
    assert np.array_equal(fixed, sunder.intersect_many(objects[0], poses_a, objects[1], poses_b[0]))
    assert np.array_equal(fixed, sunder.intersect_many(objects[0], poses_a, [objects[1]] * count, poses_b[0]))
    assert sunder.intersect_many(objects[0], None, objects[0], None).tolist() == [True]
    assert sunder.intersect_many([], None, objects[0], None).shape == (0,)
    assert sunder.intersect_many(objects[0], poses_a[:0], objects[0], None).shape == (0,)


def test_many_that_do_not_fit():
    poses = random_poses(5, 3, 3, 1)
    refused("bad-shape", "intersect_many", sunder.intersect_many, CUBE, poses, CUBE, poses[:4])
    refused("bad-shape", "intersect_many", sunder.intersect_many, [CUBE] * 4, None, CUBE, poses)
    refused("bad-shape", "poses_a", sunder.intersect_many, [CUBE] * 4, poses, CUBE, None)
    for a, b in ((CUBE, [CUBE, SQUARE]), ([None], CUBE), ("cube", CUBE), (CUBE, SQUARE), (5, 5), ({}, [CUBE]),
                 (np.zeros((3, 3)), CUBE)):
        pytest.raises(TypeError, sunder.intersect_many, a, None, b, None)
    refused("bad-shape", "poses_a", sunder.intersect_many, CUBE, np.zeros((5, 2, 3)), CUBE, None)
    poses[3, :, :3] = 0
    refused("bad-pose", "poses_b[3]", sunder.intersect_many, CUBE, None, CUBE, poses)
    poses[1, 0, 0] = np.nan
    refused("bad-pose", "poses_b[1]", sunder.intersect_many, CUBE, None, CUBE, poses)


def test_many_lets_others_run():
    body = solid.ConvexPolyhedron(np.random.default_rng(1).normal(size=(2000, 3)))
    poses = random_poses(20000, 3, 4, 3)
    done, results, ran = threading.Event(), [], 0
    def work():
        results.append(sunder.intersect_many(body, poses, body, None))
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.wait(0.001):
        ran += 1
    thread.join()
    assert len(results[0]) == 20000 and ran >= 3  # this loop went on meanwhile


def test_polyhedra():
    points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1], [0, 0, 0]]
    body = solid.ConvexPolyhedron(points)
    assert (body.dimension, len(body), body.source.tolist()) == (3, 4, [0, 1, 2, 3])
    assert sorted(map(len, body.facets)) == [3, 3, 3, 3] and solid.ConvexPolyhedron(points[:1]).dimension == 0
    assert "corner" in proved(solid.hull_certificate(points, "corner"))[0]
    refused("bad-value", "name", solid.hull_certificate, points, "")


def test_meshes():
    """A box in the notch of a bracket, on its side, a last bit away, within it; each answer is proved."""
    corners = [[x, y, z] for x, y in ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)) for z in (0, 1)]
    sides = [[2 * k, (2 * k + 2) % 12, (2 * k + 3) % 12, 2 * k + 1] for k in range(6)]
    bracket = solid.Mesh(corners, [[10, 8, 6, 4, 2, 0], [1, 3, 5, 7, 9, 11], *sides])
    unit = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    box = solid.Mesh(unit, np.array(faces))
    assert (len(box), box.closed, box.pieces) == (12, True, 1) and not solid.Mesh(unit, faces[1:]).closed
    assert sunder.intersect(bracket, box).meet
    for x, meet, words in ((1.25, False, "are apart"), (1, True, "meet at"), (np.nextafter(1, 2), False, "are apart"),
                           (0.25, True, "is inside of")):
        answer = sunder.intersect(bracket, solid.Pose(), box, solid.Pose.from_matrix(np.eye(3) / 4, [x, max(x, 0.25), 0.25]))
        assert answer.meet is meet and bool(answer) is meet
        [sentence] = proved(answer.certificate())
        assert words in sentence
    for wrong, place in (([[0, 1, 8]], "face 0"), ([[]], "face 0"), ([], "")):
        refused("bad-shape", place, solid.Mesh, unit, wrong)
