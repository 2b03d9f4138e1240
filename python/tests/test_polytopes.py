"""Polytopes of any dimension."""
from fractions import Fraction

import numpy as np
import pytest
import sunder
from sunder import polytope

from helpers import proved, refused, statements

Polytope, Pose = polytope.Polytope, polytope.Pose
FACES = np.vstack([np.eye(4), -np.eye(4)])
CROSS = Polytope.from_points(FACES)
BOX = Polytope.from_half_spaces(np.column_stack([FACES, np.ones(8)]))


def moved(*by):
    return Pose.from_matrix(np.eye(len(by)), by)


def ball(n, d, seed):
    points = np.random.default_rng(seed).normal(size=(n, d))
    return points / np.linalg.norm(points, axis=1)[:, None]


def test_bodies_are_what_was_given():
    assert (len(CROSS), CROSS.dimension, CROSS.is_of_points) == (8, 4, True)
    assert (len(BOX), BOX.dimension, BOX.is_of_points) == (8, 4, False)
    assert (CROSS.rows == FACES).all() and BOX.rows.shape == (8, 5)
    assert (Pose(4).linear == np.eye(4)).all() and moved(1, 2).translation.tolist() == [1, 2]


@pytest.mark.parametrize("method", ["automatic", "gjk", "scan"])
def test_evidence_is_exact(method):
    rng = np.random.default_rng(5)
    meets = 0
    for k in range(40):
        d = 2 + k % 5
        a, b = (rng.integers(-4, 5, size=(d + 3, d)) for _ in range(2))
        shift = rng.integers(-4, 5, size=d)
        answer = polytope.polytope_polytope(Polytope.from_points(a), Pose(d), Polytope.from_points(b), moved(*shift), method)
        assert answer.meet == bool(answer)
        if answer:
            assert answer.direction is None
            for rows, weights in ((a, answer.weights_a), (b + shift, answer.weights_b)):
                assert sum(weights.values()) == 1 and all(w >= 0 for w in weights.values())
                assert tuple(sum(w * int(rows[i][c]) for i, w in weights.items()) for c in range(d)) == answer.point
            meets += 1
        else:
            assert answer.point is None and answer.weights_a == {}
            along = [[sum(x * int(y) for x, y in zip(answer.direction, row)) for row in rows] for rows in (a, b + shift)]
            assert max(along[0]) < min(along[1])
        proved(answer.certificate())
    assert 5 < meets < 35


def test_half_spaces():
    touch = sunder.intersect(CROSS, Pose(4), BOX, moved(2, 0, 0, 0))
    assert touch and touch.point == (1, 0, 0, 0) and touch.weights_a == {0: 1}
    apart = sunder.intersect(CROSS, Pose(4), BOX, moved(2.5, 0, 0, 0))
    assert not apart and apart.direction[0] > 0 and list(apart.weights_b) == [4]
    assert statements(apart.certificate()) == [("polytopes", "apart")]
    empty = Polytope.from_half_spaces([[1, 0, -1], [-1, 0, -1]])
    nothing = sunder.intersect(empty, Polytope.from_half_spaces([[0, 1, 0]]))
    assert not nothing and nothing.direction == (0, 0) and len(nothing.weights_a) == 2
    for answer in (touch, apart, nothing):
        proved(answer.certificate())


def test_many_points():
    points = np.random.default_rng(6).normal(size=(300, 4)) * .45
    found = polytope.polytope_points(CROSS, points)
    expected = np.abs(points).sum(axis=1) <= 1  # no point is within a rounding of the boundary
    assert len(found) == 300 and (found.inside == expected).all() and 30 < expected.sum() < 270
    for k in range(0, 300, 30):
        one = found[k]
        assert one.meet == expected[k]
        if one:
            assert tuple(sum(w * Fraction(FACES[i][c]) for i, w in one.weights_a.items()) for c in range(4)) == one.point
            assert one.point == tuple(map(Fraction, points[k]))
        proved(one.certificate())
    with pytest.raises(IndexError):
        found[300]


def test_trees_and_hyperplanes():
    for d, n in ((2, 500), (3, 500), (4, 200)):
        a, b = (polytope.HierarchicalTree(Polytope.from_points(ball(n, d, seed))) for seed in (1, 2))
        assert a.depth >= 1 and a.unverified == 0 and a.memory > 0 and a.estimate > 0 and a.row_count > n
        assert a.node_count == a.cone_count + 1 and a.largest_leaf <= n and len(a.polytope) == n
        for shift in (0.5, 2.1, 4):
            there = moved(shift, *[0] * (d - 1))
            answer = polytope.polytope_polytope_by_columns(a, Pose(d), b, there)
            assert answer.meet == polytope.polytope_polytope(a.polytope, Pose(d), b.polytope, there).meet == (shift < 2)
            proved(answer.certificate())
            if not answer:
                assert max(answer.hyperplanes) <= d * max(a.depth, b.depth) + 1
                assert statements(answer.hyperplane_certificate()) == [("polytopes", "apart_by_hyperplanes")]
                proved(answer.hyperplane_certificate())
            else:
                refused("bad-call", "", answer.hyperplane_certificate)


def test_one_descent_down_two_trees():
    for d, n in ((2, 500), (3, 300), (4, 60)):
        a, b = (polytope.FaceTrees(Polytope.from_points(ball(n, d, seed))) for seed in (1, 2))
        assert a.memory > 0 and len(a.polytope) == n
        for shift in (0.5, 2.1, 4):
            there = moved(shift, *[0] * (d - 1))
            answer = polytope.polytope_polytope_by_tree(a, Pose(d), b, there)
            assert answer.meet == (shift < 2)
            assert answer.cost.iterations <= a.depth + b.polar_depth + 2
            proved(answer.certificate())
            if not answer:
                proved(answer.hyperplane_certificate())
    flat = polytope.FaceTrees(Polytope.from_points([[0, 0, 0], [1, 0, 0], [0, 1, 0]]))
    assert flat.polar_depth is None
    refused("bad-shape", "polytope", polytope.FaceTrees, BOX)


def test_what_is_refused():
    refused("bad-shape", "points", Polytope.from_points, [[1, 2, 3, 4, 5, 6, 7]])
    refused("bad-shape", "points", Polytope.from_points, [[1], [2]])
    refused("bad-shape", "points", Polytope.from_points, [1, 2, 3])
    refused("bad-shape", "half_spaces", Polytope.from_half_spaces, [[1, 2]])
    with pytest.raises(sunder.Error):
        Polytope.from_points([[1, np.nan]])
    with pytest.raises(sunder.Error):
        Polytope.from_points(np.empty((0, 3)))
    refused("bad-pose", "dimension", Pose, 7)
    with pytest.raises(sunder.Error):
        Pose.from_matrix(np.zeros((3, 3)), [0, 0, 0])
    refused("bad-shape", "pose_b", polytope.polytope_polytope, CROSS, Pose(4), BOX, Pose(3))
    refused("bad-shape", "b", sunder.intersect, CROSS, Polytope.from_points([[0, 0]]))
    refused("bad-value", "method", polytope.polytope_polytope, CROSS, Pose(4), BOX, Pose(4), "drums")
    refused("bad-shape", "points", polytope.polytope_points, CROSS, [[1, 2, 3]])
    refused("bad-call", "", sunder.intersect(CROSS, Pose(4), BOX, moved(9, 0, 0, 0)).hyperplane_certificate)
    with pytest.raises(sunder.Error):
        polytope.HierarchicalTree(Polytope.from_points(ball(500, 4, 3)), most_bytes=1000)
