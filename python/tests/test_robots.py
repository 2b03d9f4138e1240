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


def test_clearances_are_as_the_program_says(panda):
    rows = random_placements(panda, 20, seed=4)
    found = panda.clearance(rows, least=0.02)
    met = panda.collisions(rows)
    assert len(found) == 20 and (met.some <= found.some).all() and found.some.sum() > met.some.sum()
    for k, row in enumerate(rows[:8]):
        values = ",".join("%s=%r" % (name, float(x)) for name, x in zip(panda.joints, row))
        told = program("scene", PANDA, "--allow", "adjacent", "--joints", values, "--clearance", "0.02")["clearance"]["closer"]
        mine = found.placement == k
        assert [(pair["low"], pair["high"]) for pair in told] == list(map(tuple, found.distances[mine].tolist()))
        assert [(pair["a"], pair["b"]) for pair in told] == [found.pairs[i] for i in numpy.flatnonzero(mine)]
    refused("bad-value", "least", panda.clearance, rows, least=-1)
    refused("bad-value", "least", panda.clearance, rows, least=float("nan"))


def test_motion(panda):
    rails = sunder.Robot(os.path.join(CASES, "scene", "rails.urdf"))
    table = numpy.genfromtxt(os.path.join(CASES, "scene", "rails.csv"), delimiter=",", names=True)
    found = rails.motion({name: table[name] for name in table.dtype.names})
    assert len(found) == 4 and found.some.tolist() == [True, False, False, False]
    assert found.undecided.tolist() == [False, False, False, True]  # the arm turns
    assert found[0] == [("carriage", "lift")] and found.all_the_way[0] and found.times[0].tolist() == [0.5, 0.5]
    refused("bad-call", "motion", panda.motion, {})
    refused("bad-call", "motion", sunder.Robot(CRANE, allow="touch").motion, {"hoist": [0, 1]})


def test_link_poses(panda):
    rows = random_placements(panda, 3, seed=5)
    poses = panda.poses(rows)
    assert poses.shape == (3, len(panda.links), 4, 4)
    turns = poses[..., :3, :3]
    assert numpy.allclose(turns @ turns.swapaxes(-1, -2), numpy.eye(3)) and (poses[..., 3, :] == [0, 0, 0, 1]).all()
    first = panda.links.index("panda_link1")
    assert numpy.allclose(poses[:, first, :3, 3], [0, 0, 0.333])
    assert numpy.allclose(poses[:, first, 0, 0], numpy.cos(rows[:, 0]))
    assert numpy.array_equal(panda.poses(rows[1]), poses[1:2])


def test_two_robots_and_what_is_attached(tmp_path):
    aside = numpy.eye(3, 4)
    aside[0, 3] = 4
    srdf = os.path.join(CASES, "scene", "arm.srdf")
    cranes = sunder.Robot({"left": CRANE, "right": (CRANE, aside), "cube": os.path.join(CASES, "mesh", "cube.obj")},
                          attach={"cube": "left/load"}, allow="adjacent")
    assert list(cranes.joints) == ["left/turn", "left/hoist", "right/turn", "right/hoist"]
    assert ("left/load", "cube") in cranes.allowed and "right/boom" in cranes.links
    joints = {"left/hoist": [0, 0.25], "right/turn": [0, 3]}
    assert numpy.allclose(cranes.poses(joints)[:, cranes.links.index("right/mast"), 0, 3], 4)
    found = cranes.collisions(joints)
    report = program("scene", "left=" + CRANE, "right=%s@4,0,0" % CRANE, os.path.join(CASES, "mesh", "cube.obj"),
                     "--attach", "cube=left/load", "--allow", "adjacent",
                     "--joints", "left/hoist=0", "--joints", "left/hoist=0.25,right/turn=3")
    assert report["attached"] == [{"name": "cube", "link": "left/load"}]
    for k in range(2):
        told = [(pair["a"], pair["b"]) for pair in report["pairs"] if pair["counted"] and pair["placement"] == k]
        assert found[k] == list(dict.fromkeys(told))
    text = cranes.certificate({name: values[1] for name, values in joints.items()})
    assert b"right/turn" in text and proved(text)
    refused("bad-call", "joint 'turn'", cranes.collisions, {"turn": 1})
    refused("bad-call", "attach", sunder.Robot, CRANE, attach={"cube": "load"})

    arms = sunder.Robot({"left": ARM, "right": (ARM, aside)}, srdf={"right": srdf}, leave_out=True)
    assert arms.states == ["right/whole/up", "right/whole/open", "right/hand/open", "right/hand/closed"]
    assert arms.state("up") == {"right/elbow": -1.5, "right/shoulder": 1.0}
    assert len(arms.collisions(arms.state("up"))) == 1
    refused("bad-call", "state", arms.state, "down")


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


def test_what_an_open_mesh_seems_to_enclose_is_not_said_to_be_free(tmp_path):
    corners = [(x, y, z) for z in (0, 4) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))]
    faces = ("4 3 2 1", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8")  # a box without a lid
    (tmp_path / "shell.obj").write_text("".join("v %d %d %d\n" % p for p in corners) + "".join("f %s\n" % f for f in faces))
    (tmp_path / "press.urdf").write_text(
        '<robot name="press"><link name="shell"><collision><geometry><mesh filename="shell.obj"/></geometry></collision></link>'
        '<link name="block"><collision><geometry><box size="1 1 1"/></geometry></collision></link>'
        '<joint name="slide" type="prismatic"><parent link="shell"/><child link="block"/><origin xyz="2 2 2"/>'
        '<axis xyz="0 0 1"/><limit lower="-9" upper="9"/></joint></robot>')
    press = sunder.Robot(tmp_path / "press.urdf")
    values = numpy.array([[0.0], [6.0], [-2.0]])  # in it, above it, through its floor
    found = press.collisions(values)
    assert (found.meet.tolist(), found.undecided.tolist()) == ([False, False, True], [True, False, False])
    near = press.clearance(values, least=1.25)
    assert (near.some.tolist(), near.undecided.tolist()) == ([False, False, True], [True, False, False])
    assert press.clearance(values, least=1.75).some.tolist() == [True, False, True]


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
