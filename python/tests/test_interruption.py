"""A call that takes long is ended by what a signal's handler raises, as Ctrl-C does, and soon."""
import os
import signal
import time

import numpy as np
import pytest
import sunder
from sunder import planar, polytope, solid

from helpers import CASES, proved

SOON = 0.2  # seconds of processor time from the signal to what its handler does
BEGIN = 0.03  # and from the call's begin to the signal


class Heard(Exception):
    pass


@pytest.fixture
def interrupted():
    """Calls, sends the signal, and returns after how long its handler was called."""

    def call(question):
        heard = []

        def handler(*_):
            heard.append(time.process_time())
            raise Heard

        before = signal.signal(signal.SIGPROF, handler)
        begin = time.process_time()
        signal.setitimer(signal.ITIMER_PROF, BEGIN)
        try:
            with pytest.raises(Heard):
                question()
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.signal(signal.SIGPROF, before)
        return heard[0] - begin - BEGIN

    return call


def random(*shape):
    return np.random.default_rng(1).uniform(-1, 1, shape)


def tangents(count):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.stack([np.cos(angle), np.sin(angle), np.ones(count)], axis=1)


def star(count):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radius = 1 + 0.5 * np.cos(np.arange(count) * np.pi)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)


def short_segments(count):
    begin = random(count, 2)
    return np.concatenate([begin, begin + 0.01 * np.random.default_rng(2).uniform(-1, 1, (count, 2))], axis=1)


def rows(count):
    """Parallel segments of which none meet."""
    begin = random(count, 2)
    return np.concatenate([begin, begin + 1], axis=1)


def discs(count):
    return np.concatenate([random(count, 2), np.full((count, 1), 0.02)], axis=1)


def squares(count):
    x = random(count, 2)
    size = 0.2
    return [[p + size * np.array(corner) for corner in ((0, 0), (1, 0), (1, 1), (0, 1))] for p in x]


def sphere(count, dimension=3):
    points = np.random.default_rng(1).normal(size=(count, dimension))
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def poses(count, reach):
    all_of_them = np.zeros((count, 3, 4))
    all_of_them[:, [0, 1, 2], [0, 1, 2]] = 1
    all_of_them[:, :, 3] = reach * random(count, 3)
    return all_of_them


# What is prepared in the first function is not interrupted; the second one is the question.
LONG = {
    "segments_any": (lambda: planar.Segments(rows(500_000)), planar.segments_any),
    "segments_all": (lambda: planar.Segments(short_segments(1_000_000)), planar.segments_all),
    "segments_count": (lambda: planar.Segments(short_segments(1_000_000)), planar.segments_count),
    "discs_all": (lambda: planar.Discs(discs(100_000)), planar.discs_all),
    "polygons_all": (lambda: planar.Polygons([[ring] for ring in squares(40_000)]), planar.polygons_all),
    "polygon_defects": (lambda: [[star(400_000)]], planar.polygon_defects),
    "half_plane_intersection": (lambda: planar.Constraints(tangents(1_000_000)), planar.half_plane_intersection),
    "disc_intersection": (lambda: planar.Discs(np.concatenate([0.1 * random(150_000, 2), np.ones((150_000, 1))], axis=1)),
                          planar.disc_intersection),
    "kernel": (lambda: star(250_000), planar.kernel),
    "ConvexPolyhedron": (lambda: sphere(300_000), solid.ConvexPolyhedron),
    "intersect_many": (lambda: (solid.ConvexPolyhedron(sphere(1000)), poses(500_000, 1.5)),
                       lambda given: sunder.intersect_many(given[0], None, given[0], given[1])),
    "convex_hull": (lambda: polytope.Polytope.from_points(sphere(1000, 6)), polytope.convex_hull),
    "region_vertices": (lambda: polytope.Polytope.from_half_spaces(np.concatenate([sphere(64, 6), np.ones((64, 1))], axis=1)),
                        polytope.region_vertices),
    "HierarchicalTree": (lambda: polytope.Polytope.from_points(sphere(20_000, 4)), polytope.HierarchicalTree),
    "collisions": (lambda: (sunder.Robot(os.path.join(CASES, "panda", "panda.urdf"), allow="adjacent"),
                            random(100_000, 7)),
                   lambda given: given[0].collisions(
                       dict(zip(["panda_joint%d" % k for k in range(1, 8)], given[1].T)), threads=1)),
}


@pytest.mark.filterwarnings("ignore:joint")  # beyond its limits
@pytest.mark.parametrize("name", LONG)
def test_is_heard_soon(interrupted, name):
    prepare, question = LONG[name]
    given = prepare()
    assert interrupted(lambda: question(given)) < SOON


def test_questions_of_files_too(interrupted, tmp_path):
    points = tmp_path / "points.csv"
    np.savetxt(points, sphere(1000, 6), delimiter=",", header="x1,x2,x3,x4,x5,x6", comments="")
    assert interrupted(lambda: sunder.ask("hull", points)) < SOON


def test_certificates_too(interrupted):
    answer = planar.segments_any(planar.Segments(rows(300_000)))
    assert interrupted(answer.certificate) < SOON


def test_what_was_interrupted_can_be_asked_again(interrupted):
    body = solid.ConvexPolyhedron(sphere(1000))
    many = poses(500_000, 1.5)
    interrupted(lambda: sunder.intersect_many(body, None, body, many))
    assert sunder.intersect_many(body, None, body, many[:100]).tolist() == [
        bool(sunder.intersect(body, solid.Pose(), body, solid.Pose.from_matrix(pose[:, :3], pose[:, 3])))
        for pose in many[:100]]
    proved(sunder.intersect(body, body).certificate())
