"""Robots: what meets, placement by placement, as the program says."""
import os
import threading
import time
import warnings

import numpy
import pytest
import sunder

from helpers import CASES, program, proved, refused

PANDA = os.path.join(CASES, "panda", "panda.urdf")
ARM = os.path.join(CASES, "mesh", "arm.urdf")
CRANE = os.path.join(CASES, "scene", "primitives.urdf")
NEARLY = os.path.join(CASES, "scene", "nearly.urdf")


def read_joints(name):
    with open(os.path.join(CASES, "scene", name), encoding="utf-8") as file:
        lines = [line.split("#")[0].split() for line in file]
    return {line[0]: float(line[-1]) for line in lines if line}


@pytest.fixture(scope="module")
def panda():
    return sunder.Robot(PANDA, allow="adjacent")


def random_placements(robot, count, seed=1):
    low, high = numpy.array(list(robot.joints.values())).T
    return numpy.random.default_rng(seed).uniform(low, high, (count, len(low)))


def test_what_it_is(panda):
    assert panda.name == "panda"
    assert list(panda.joints)[0] == "panda_joint1"
    assert panda.joints["panda_joint4"] == pytest.approx((-3.0718, -0.0698))
    assert len(panda.bodies) == 11 and set(panda.bodies) < set(panda.links)
    assert ("panda_link0", "panda_link1") in panda.allowed
    assert "panda_link0" in panda.hulls
    assert panda.parts("panda_link0") and panda.left_out == []


def test_one_placement(panda):
    folded = panda.collisions(read_joints("folded.joints"))
    assert len(folded) == 1 and folded and folded.points is None
    assert folded[0] == [("panda_link1", "panda_hand")] == folded[-1]
    ready = panda.collisions(read_joints("ready.joints"))
    assert not ready and ready[0] == [] and not ready.meet.any()
    with pytest.raises(IndexError):
        folded[1]
    vector = [read_joints("folded.joints").get(name, 0.0) for name in panda.joints]
    assert panda.collisions(vector)[0] == folded[0]
    assert len(panda.collisions()) == 1  # at rest


def test_many_placements_are_as_the_program_says(panda):
    rows = random_placements(panda, 40)
    found = panda.collisions(rows, evidence=True)
    assert found.points.shape == (len(found.placement), 3) and numpy.isfinite(found.points).all()
    hits = 0
    for k, row in enumerate(rows[:20]):
        values = ",".join("%s=%r" % (name, float(x)) for name, x in zip(panda.joints, row))
        report = program("scene", PANDA, "--allow", "adjacent", "--joints", values)
        told = [(pair["a"], pair["b"]) for pair in report["pairs"] if pair["counted"]]
        assert found[k] == list(dict.fromkeys(told))
        assert found.meet[k] == bool(told)
        hits += bool(told)
    assert 0 < hits < 20


def test_threads_and_columns(panda):
    rows = random_placements(panda, 300, seed=2)
    one = panda.collisions(rows, threads=1, evidence=True)
    for other in (panda.collisions(rows, threads=3, evidence=True),
                  panda.collisions({name: rows[:, k] for k, name in enumerate(panda.joints)}, evidence=True),
                  panda.collisions(numpy.asfortranarray(rows), evidence=True)):
        for name in ("placement", "bodies", "parts", "decided", "points"):
            assert numpy.array_equal(getattr(one, name), getattr(other, name)), name
    assert 0 < one.meet.sum() < 300
    assert len(panda.collisions(numpy.empty((0, len(panda.joints))))) == 0


def test_other_threads_run_meanwhile(panda):
    rows = random_placements(panda, 20_000, seed=3)
    ticks, done = [], threading.Event()

    def ask():
        panda.collisions(rows, threads=1)
        done.set()

    asking = threading.Thread(target=ask)
    start = time.monotonic()
    asking.start()
    while not done.is_set():
        ticks.append(time.monotonic())
        time.sleep(0.001)
    asking.join()
    took = time.monotonic() - start
    assert len(ticks) > 10 and max(numpy.diff(ticks)) < max(0.5 * took, 0.05)


def test_certificates(panda):
    sentences = proved(panda.certificate(read_joints("folded.joints")))
    assert any("panda_link1" in s and "panda_hand" in s for s in sentences)
    both = panda.certificate([[read_joints(name).get(joint, 0.0) for joint in panda.joints]
                              for name in ("ready.joints", "folded.joints")])
    assert len(proved(both)) > len(sentences)
    assert b"panda.urdf" in both and b"sha256" in both


def test_bodies_with_a_radius():
    crane = sunder.Robot(CRANE, allow=["adjacent", ("mast", "load")])
    assert not crane.collisions({"hoist": 1.125})
    crane = sunder.Robot(CRANE, allow=["adjacent"])
    assert crane.collisions({"hoist": 1.125})[0] == [("mast", "load")]
    assert [crane.collisions({"hoist": x}).meet[0] for x in (0, 0.625)] == [False, True]
    assert sunder.Robot(CRANE, allow=["adjacent", "touch"]).collisions({"hoist": [0.625, 1.125]}).meet.tolist() == \
        [False, True]
    proved(crane.certificate({"hoist": 1.125}))

    nearly = sunder.Robot(NEARLY)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = nearly.collisions({"way": [1.0, 0.0]}, evidence=True)
    assert found.undecided.tolist() == [True, False]
    assert found[0] == [] and not found.decided[0] and numpy.isnan(found.points[0]).all()
    assert found.meet.tolist() == [False, True]


def test_around_it(tmp_path):
    scene = tmp_path / "floor.json"
    scene.write_text('{"unit": "m", "bodies": [{"name": "floor", "parts": [{"box": {"size": [9, 9, 1]},'
                     ' "pose": {"translation": [0, 0, -0.51]}}]}]}')
    arm = sunder.Robot(PANDA, allow="adjacent", scene=scene)
    assert arm.bodies[-1] == "floor"
    assert not arm.collisions(read_joints("ready.joints"))
    bent = dict(read_joints("ready.joints"), panda_joint2=1.7, panda_joint4=-0.1)
    assert ("panda_leftfinger", "floor") in arm.collisions(bent)[0]
    assert b"floor.json" in arm.certificate(bent)
    scene.write_text('{"unit": "mm", "bodies": [{"name": "f", "parts": [{"box": {"size": [9, 9, 1]}}]}]}')
    assert "mm" in refused("bad-call", str(scene), sunder.Robot, PANDA, scene=scene)


def test_srdf_and_packages(tmp_path):
    arm = sunder.Robot(ARM, srdf=os.path.join(CASES, "scene", "arm.srdf"), leave_out=True)
    assert len(arm.allowed) == 2 and arm.left_out
    part = sunder.Robot(ARM, srdf=os.path.join(CASES, "scene", "arm.srdf"), leave_out=True, groups="upper_arm")
    assert part.bodies == ["upper", "lower"] and part.allowed == [] and "1 shape of base" in part.left_out
    assert part.collisions()[0] == [("upper", "lower")] and b"1 shape of base" in part.certificate()
    assert "whole" in refused("bad-call", "groups", sunder.Robot, ARM, leave_out=True, groups="frob",
                              srdf=os.path.join(CASES, "scene", "arm.srdf"))
    (tmp_path / "arm.urdf").write_text('<robot name="r"><link name="a"><collision><geometry>'
                                       '<mesh filename="package://parts/cube.obj"/></geometry></collision></link></robot>')
    robot = sunder.Robot(tmp_path / "arm.urdf", packages={"parts": os.path.join(CASES, "mesh")})
    assert robot.bodies == ["a"] and robot.joints == {}
    assert refused("bad-call", "certificate", robot.certificate)


def test_groups_keep_neighbours(tmp_path):
    (tmp_path / "g.srdf").write_text("<robot><group name='ends'><link name='panda_link0'/><link name='panda_link2'/></group>"
                                     "<group name='start'><chain base_link='panda_link0' tip_link='panda_link1'/></group>"
                                     "</robot>")
    ends = sunder.Robot(PANDA, srdf=tmp_path / "g.srdf", groups=["ends"], allow="adjacent")
    assert ends.bodies == ["panda_link0", "panda_link2"] and ends.allowed == []  # link1 is between them
    assert "shapes of panda_link1" in ends.left_out[0]
    both = sunder.Robot(PANDA, srdf=tmp_path / "g.srdf", groups=["ends", "start"], allow="adjacent")
    assert both.allowed == [("panda_link0", "panda_link1"), ("panda_link1", "panda_link2")]


def test_limits_are_warned_of(panda):
    with pytest.warns(UserWarning, match="panda_joint1.*2 values"):
        panda.collisions({"panda_joint1": [9, 0, -9]})


def test_bad_calls(panda):
    refused("bad-call", "joint 'nothing'", panda.collisions, {"nothing": 1})
    refused("bad-shape", "joints", panda.collisions, [1, 2])
    refused("bad-shape", "joints", panda.collisions, {"panda_joint1": [1, 2], "panda_joint2": [1, 2, 3]})
    refused("bad-value", "joints", panda.collisions, {"panda_joint1": float("nan")})
    refused("bad-value", "panda_joint1", panda.collisions, {"panda_joint1": "1"})
    refused("bad-call", "joints", panda.collisions, {1: 1})
    refused("bad-call", "threads", panda.collisions, {}, threads=-1)
    refused("bad-call", "allow", sunder.Robot, PANDA, allow=["frob"])
    refused("bad-call", "allow", sunder.Robot, PANDA, allow=[("panda_hand", "frob")])
    refused("bad-call", "allow", sunder.Robot, PANDA, allow=[("panda_hand", "panda_hand")])
    refused("bad-call", "parts", panda.parts, "frob")
    with pytest.raises(sunder.Error):
        sunder.Robot("missing.urdf")
    with pytest.raises(sunder.Error):
        sunder.Robot(ARM)  # has shapes that are not read
