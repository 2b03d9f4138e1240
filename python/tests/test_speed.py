"""Posed pairs, in one call and one by one, beside the bare C++ loop of tests/tools/posed_pairs.cpp in the same run;
polygons beside Shapely's tree; and whether memory grows.

    pytest -m slow -s python/tests/test_speed.py
"""
import os
import resource
import subprocess
import time

import numpy as np
import pytest
import sunder
from sunder import planar, solid

from helpers import PROGRAM

ROUNDS, REPEATS = 7, 5
LOOP = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "tools", "posed_pairs")


def scene(bodies, pairs, vertices, reach):
    """Bodies, and pairs of them under rotations, about half of which meet."""
    random = np.random.default_rng(vertices)
    points = [random.normal(size=(vertices, 3)) for _ in range(bodies)]
    points = [p / np.linalg.norm(p, axis=1, keepdims=True) for p in points]
    poses = np.empty((2, pairs, 3, 4))
    poses[..., :3] = np.linalg.qr(random.normal(size=(2, pairs, 3, 3)))[0]
    poses[..., 3] = random.uniform(-reach, reach, (2, pairs, 3))
    which = random.integers(0, bodies, (2, pairs)) if bodies > 2 else np.tile([[0], [1]], (1, pairs))
    return points, which, poses


class Loop:
    """The C++ loop over a scene."""

    def __init__(self, folder, points, which, poses):
        self.file = folder / "scene"
        numbers = [np.array([float(len(points))])] + [np.concatenate([[len(p)], p.ravel()]) for p in points]
        numbers += [np.concatenate([which.T, poses[0].reshape(-1, 12), poses[1].reshape(-1, 12)], axis=1).ravel()]
        np.concatenate(numbers).astype(float).tofile(self.file)

    def __call__(self):
        """How many meet; nanoseconds a pair, with poses made in the loop, and before."""
        done = subprocess.run([LOOP, self.file, str(REPEATS)], capture_output=True, text=True, check=True)
        meeting, made_in_loop, made_before = done.stdout.split()
        return int(meeting), float(made_in_loop), float(made_before)


def nanoseconds(call):
    start = time.perf_counter_ns()
    result = call()
    return time.perf_counter_ns() - start, result


@pytest.mark.slow
@pytest.mark.parametrize("bodies, pairs, vertices", [(50, 10_000, 8), (50, 10_000, 100), (50, 10_000, 2000),
                                                     (2, 100_000, 8), (2, 100_000, 100), (2, 100_000, 2000)])
def test_a_batch_takes_at_most_1_2_times_the_loop(tmp_path, bodies, pairs, vertices):
    points, which, poses = scene(bodies, pairs, vertices, 1.2)
    loop = Loop(tmp_path, points, which, poses)
    made = [solid.ConvexPolyhedron(p) for p in points]
    a, b = ([made[k] for k in which[0]], [made[k] for k in which[1]]) if bodies > 2 else made
    in_python, in_loop, before_loop = [], [], []
    for _ in range(ROUNDS):  # in turn, so that both see the same machine
        meeting, made_in_loop, made_before = loop()
        in_loop.append(made_in_loop)
        before_loop.append(made_before)
        for _ in range(REPEATS):
            time_taken, meet = nanoseconds(lambda: sunder.intersect_many(a, poses[0], b, poses[1]))
            in_python.append(time_taken / pairs)
        assert meet.sum() == meeting and 0.2 < meet.mean() < 0.8
    print("\n%d bodies, %d pairs, %d vertices: %.0f ns a pair in one call, %.0f in the C++ loop (%.0f with poses made "
          "before): %.2f times" % (bodies, pairs, vertices, min(in_python), min(in_loop), min(before_loop),
                                   min(in_python) / min(in_loop)))
    assert min(in_python) <= 1.2 * min(in_loop)


@pytest.mark.slow
@pytest.mark.parametrize("vertices", [8, 100])
def test_a_single_call_takes_a_microsecond_more(tmp_path, vertices):
    points, which, poses = scene(2, 10_000, vertices, 1.2)
    loop = Loop(tmp_path, points, which, poses)
    a, b = (solid.ConvexPolyhedron(p) for p in points)
    placed = list(zip(*([solid.Pose.from_matrix(m[:, :3], m[:, 3]) for m in side] for side in poses)))
    singly, in_loop = [], []
    for _ in range(ROUNDS):
        in_loop.append(loop()[2])
        for _ in range(REPEATS):
            time_taken, _ = nanoseconds(lambda: [sunder.intersect(a, p, b, q) for p, q in placed])
            singly.append(time_taken / len(placed))
    print("\n%d vertices: %.0f ns a call, %.0f in the C++ loop" % (vertices, min(singly), min(in_loop)))
    assert min(singly) <= min(in_loop) + 1000


@pytest.mark.slow
def test_polygons_faster_than_a_tree_of_shapely():
    shapely = pytest.importorskip("shapely")
    random = np.random.default_rng(5)
    turns = np.sort(random.uniform(0, 2 * np.pi, (5000, 24)), axis=1)
    reach = random.uniform(0.4, 1, (5000, 24, 1))
    rings = random.uniform(0, 110, (5000, 1, 2)) + reach * np.stack([np.cos(turns), np.sin(turns)], axis=2)
    sunders, shapelys = [], []
    for _ in range(ROUNDS):
        making, polygons = nanoseconds(lambda: planar.Polygons(list(rings)))
        asking, found = nanoseconds(lambda: planar.polygons_all(polygons))
        sunders.append((making + asking, asking))
        making, polygons = nanoseconds(lambda: shapely.polygons(rings))
        asking, pairs = nanoseconds(lambda: shapely.STRtree(polygons).query(polygons, predicate="intersects"))
        shapelys.append((making + asking, asking))
    pairs = pairs[:, pairs[0] < pairs[1]]
    assert {tuple(p) for p in found.pairs.tolist()} == {tuple(p) for p in pairs.T.tolist()}
    (whole, asked), (shapely_whole, shapely_asked) = (np.min(times, axis=0) / 1e6 for times in (sunders, shapelys))
    print("\n5,000 polygons, %d pairs meet: %.1f ms, Shapely's tree %.1f; from arrays %.1f, %.1f" %
          (len(found.pairs), asked, shapely_asked, whole, shapely_whole))
    assert asked < shapely_asked


@pytest.mark.slow
def test_a_million_calls_leak_nothing():
    points, _, poses = scene(2, 1000, 8, 1.2)
    a, b = (solid.ConvexPolyhedron(p) for p in points)
    placed = [tuple(solid.Pose.from_matrix(m[:, :3], m[:, 3]) for m in pair) for pair in zip(*poses)]

    def calls(times):
        for _ in range(times):
            for p, q in placed:
                sunder.intersect(a, p, b, q)
            sunder.intersect_many(a, poses[0], b, poses[1])
            sunder.intersect(a, b).certificate()
            solid.ConvexPolyhedron(points[0])
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # KiB

    before = calls(100)
    grown = calls(1000) - before
    print("\na million calls: %d KiB more" % grown)
    assert grown < 1024
