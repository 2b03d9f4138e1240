"""10,000 posed pairs in one call, beside the bare C++ loop of tests/tools/posed_pairs.cpp in the same run.

    pytest -m slow -s python/tests/test_speed.py
"""
import os
import subprocess
import time

import numpy as np
import pytest
import sunder
from sunder import solid

from helpers import PROGRAM

PAIRS, ROUNDS, REPEATS = 10_000, 7, 5
LOOP = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "tools", "posed_pairs")


def scene(vertices, reach):
    """Bodies, and pairs of them under rotations, about half of which meet."""
    random = np.random.default_rng(vertices)
    points = [random.normal(size=(vertices, 3)) for _ in range(50)]
    points = [p / np.linalg.norm(p, axis=1, keepdims=True) for p in points]
    poses = np.empty((2, PAIRS, 3, 4))
    poses[..., :3] = np.linalg.qr(random.normal(size=(2, PAIRS, 3, 3)))[0]
    poses[..., 3] = random.uniform(-reach, reach, (2, PAIRS, 3))
    return points, random.integers(0, 50, (2, PAIRS)), poses


@pytest.mark.slow
@pytest.mark.parametrize("vertices, reach", [(8, 1.2), (100, 1.2), (2000, 1.2)])
def test_at_most_1_2_times_the_loop(tmp_path, vertices, reach):
    points, which, poses = scene(vertices, reach)
    numbers = [np.array([50.0])] + [np.concatenate([[len(p)], p.ravel()]) for p in points]
    numbers += [np.concatenate([which.T, poses[0].reshape(-1, 12), poses[1].reshape(-1, 12)], axis=1).ravel()]
    np.concatenate(numbers).astype(float).tofile(tmp_path / "scene")
    bodies = [solid.ConvexPolyhedron(p) for p in points]
    a, b = [bodies[k] for k in which[0]], [bodies[k] for k in which[1]]
    python, loop, loop_made = [], [], []
    for _ in range(ROUNDS):  # in turn, so that both see the same machine
        done = subprocess.run([LOOP, tmp_path / "scene", str(REPEATS)], capture_output=True, text=True, check=True)
        meeting, made_in_loop, made_before = done.stdout.split()
        loop.append(float(made_in_loop))
        loop_made.append(float(made_before))
        for _ in range(REPEATS):
            start = time.perf_counter_ns()
            meet = sunder.intersect_many(a, poses[0], b, poses[1])
            python.append((time.perf_counter_ns() - start) / PAIRS)
        assert meet.sum() == int(meeting) and 0.2 < meet.mean() < 0.8
    print("\n%d vertices: %.0f ns a pair in one call, %.0f in the C++ loop (%.0f with poses made before): %.2f times" %
          (vertices, min(python), min(loop), min(loop_made), min(python) / min(loop)))
    assert min(python) <= 1.2 * min(loop)
