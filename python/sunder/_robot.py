"""Robots and what stands around them: what meets, is too near, or meets on the way, for one placement or thousands."""
from __future__ import annotations

import os
import warnings
from typing import Any, Dict, Iterable, List, Mapping, Optional, Tuple, Union

import numpy

from sunder import _sunder
from sunder._arrays import doubles, side
from sunder._error import Error

Path = Union[str, "os.PathLike[str]"]
MOST_PROVED = 10_000  # placements in one certificate


class Found:
    """What was found, placement by placement (of a motion: step by step): found[k] are the pairs of bodies of placement
    k, by name. True where some are found.

    some, undecided: of each placement, are some known, and are some undecided? The arrays below are about pairs of parts,
    placement after placement. placement: of each pair its placement, (M,). bodies, parts: two numbers each, (M, 2), of
    names in robot.bodies and robot.parts(name). decided: whether it is known, (M,); only pairs with cylinders, cones and
    ellipsoids may be undecided, next to touching, and of a motion those that turn. Then, of collisions with evidence,
    points: about a common point, (M, 3); of a clearance, distances: lower and upper bounds, (M, 2); of a motion, times:
    bounds of the first time, 0 at one placement and 1 at the next, (M, 2), and all_the_way: False where only both ends
    were asked about, (M,).
    """

    def __init__(self, found: "_sunder._Found", names: List[str], **more: Any) -> None:
        self._names = names
        self.some, self.undecided = found.verdicts.astype(bool).T
        self.placement, self.bodies, self.parts = found.row, found.bodies, found.parts
        self.decided = found.decided.astype(bool)
        self.__dict__.update(more)

    @property
    def meet(self) -> numpy.ndarray:
        """The same as some."""
        return self.some

    @property
    def pairs(self) -> List[Tuple[str, str]]:
        """Of each row of the arrays the two bodies, by name."""
        return [(self._names[a], self._names[b]) for a, b in self.bodies.tolist()]

    def __len__(self) -> int:
        return len(self.some)

    def __getitem__(self, k: int) -> List[Tuple[str, str]]:
        k = range(len(self))[k]
        first, last = numpy.searchsorted(self.placement, [k, k + 1])
        pairs = self.bodies[first:last][self.decided[first:last]]
        return [(self._names[a], self._names[b]) for a, b in dict.fromkeys(map(tuple, pairs.tolist()))]

    def __bool__(self) -> bool:
        return bool(self.some.any())


class Robot:
    """A robot out of a URDF file, or several, and what stands around.

    file: a URDF file; or several files (URDF, meshes, scene files) by name, each alone or with its pose, a (3, 4) array:
    {"left": "arm.urdf", "right": ("arm.urdf", pose)}. What two robots have by one name is named "left/elbow" then.
    scene: a scene file. attach: links by the names of what moves with them. packages: folders of packages by name.
    srdf: pairs that it disables are allowed to meet; of several robots also files by the robots' names. groups: names of
    groups of the srdf; the shapes of other links are left out. allow: "adjacent" (links joined by a joint), "touch"
    (pairs that only touch do not count), and pairs of names. require_convex: meshes that are not convex are an error,
    and not stood for by their hulls. leave_out: shapes that are not read are left out.

    name: the robot's. links: all, also those without a shape. bodies: what is asked about. hulls: bodies of which a mesh
    is not convex: its hull moves, and meets a radius. allowed: pairs of bodies that are not asked about. left_out:
    what of the files is not asked about. joints: those that take values, with their limits, in the order of vectors:
    radians, or metres. states: names of the states of the srdf; state(name) has the values of one, by joint.
    """

    def __init__(self, file: "Path | Mapping[str, Path | Tuple[Path, Any]]", *,
                 packages: Optional[Mapping[str, Path]] = None, srdf: "None | Path | Mapping[str, Path]" = None,
                 groups: "str | Iterable[str]" = (), scene: Optional[Path] = None,
                 attach: Optional[Mapping[str, str]] = None, allow: "str | Iterable[str | Tuple[str, str]]" = (),
                 require_convex: bool = False, leave_out: bool = False) -> None:
        files = [(name, *(of if isinstance(of, tuple) else (of, None)))
                 for name, of in (file.items() if isinstance(file, Mapping) else [("", file)])]
        files += [] if scene is None else [("", scene, None)]
        srdfs = srdf if isinstance(srdf, Mapping) else {} if srdf is None else {"": srdf}
        words = [(one, "") if one in ("adjacent", "touch") else one for one in ([allow] if isinstance(allow, str) else allow)]
        if not all(isinstance(w, (tuple, list)) and len(w) == 2 and all(isinstance(n, str) for n in w) for w in words):
            raise Error("bad-call", "allow", "give \"adjacent\", \"touch\", and pairs of names")
        self._robot = _sunder._Robot(
            [(name, os.fspath(path)) for name, path, _ in files],
            numpy.concatenate([side(None, pose, 3, name)[1] for name, _, pose in files]),
            ["%s=%s" % (name, os.fspath(folder)) for name, folder in dict(packages or {}).items()],
            [(name, os.fspath(path)) for name, path in srdfs.items()],
            [groups] if isinstance(groups, str) else list(groups), list(dict(attach or {}).items()),
            [tuple(w) for w in words], require_convex, leave_out)
        for name in ("name", "links", "bodies", "hulls", "allowed", "left_out", "joints", "states"):
            setattr(self, name, getattr(self._robot, name))

    def state(self, name: str) -> Dict[str, float]:
        """The values of joints in this state of the srdf: of all robots that have it, or of one: "left/home"."""
        return self._robot.state(name)

    def parts(self, body: str) -> List[str]:
        """The names of a body's parts."""
        if body not in self.bodies:
            raise Error("bad-call", "parts", "no body is named '%s'" % body)
        return self._robot.part_names(self.bodies.index(body))

    def collisions(self, joints: object = None, *, evidence: bool = False, threads: int = 0) -> Found:
        """Which bodies meet?

        joints: values by name (others are at 0, or at the limit nearest to it); a vector in the order of .joints; or an
        array of a row for each placement, or values by name that are vectors, for many. Values beyond a joint's limits
        are asked about, with a warning. threads: 0 is all cores; the result is the same for any number. Other threads
        of Python run meanwhile.
        """
        found = self._robot.collisions(*self._rows(joints), evidence, _threads(threads))
        return Found(found, self.bodies, points=found.numbers if evidence else None)

    def clearance(self, joints: object = None, *, least: float, threads: int = 0) -> Found:
        """Which bodies are closer than least? Arguments as of collisions()."""
        least = doubles(least, "least", ()).item()
        if not 0 <= least < numpy.inf:
            raise Error("bad-value", "least", "give a finite number that is not negative")
        found = self._robot.clearance(*self._rows(joints), least, _threads(threads))
        return Found(found, self.bodies, distances=found.numbers[:, :2])

    def motion(self, joints: object, *, threads: int = 0) -> Found:
        """Which bodies meet during the motion from each placement to the next, in which parts move straight? Parts that
        turn are asked about at both ends alone, and steps that are so not known to be free are undecided."""
        found = self._robot.motion(*self._rows(joints), _threads(threads))
        return Found(found, self.bodies, times=found.numbers[:, :2], all_the_way=found.numbers[:, 2].astype(bool))

    def poses(self, joints: object = None) -> numpy.ndarray:
        """Where the links are in the world: of each placement a 4x4 matrix for each of .links, (N, links, 4, 4)."""
        names, rows = self._rows(joints)
        return self._robot.poses(names, rows).reshape(len(rows), len(self.links), 4, 4)

    def certificate(self, joints: object = None) -> bytes:
        """The certificate file of these placements, for sunder_verify: of all pairs that are not allowed."""
        names, rows = self._rows(joints)
        if len(rows) > MOST_PROVED:
            raise Error("bad-call", "joints", "%d placements; give at most %d in one certificate" %
                        (len(rows), MOST_PROVED))
        return self._robot.certificate(names, rows)

    def _rows(self, joints):
        names, joints = list(self.joints), {} if joints is None else joints
        if isinstance(joints, Mapping):
            names = list(joints)
            if not all(isinstance(name, str) for name in names):
                raise Error("bad-call", "joints", "names of joints are texts")
            columns = [doubles(joints[name], name, (-1,), ()) for name in names]
            try:
                columns = numpy.broadcast_arrays(*columns)
            except ValueError:
                raise Error("bad-shape", "joints", "vectors of several lengths; give one length") from None
            rows = numpy.column_stack([numpy.atleast_1d(c) for c in columns]) if names else numpy.empty((1, 0))
        else:
            rows = numpy.atleast_2d(doubles(joints, "joints", (len(names),), (-1, len(names))))
        if not numpy.isfinite(rows).all():
            raise Error("bad-value", "joints", "a number is not finite")
        for name, column in zip(names, rows.T):
            low, high = self.joints.get(name, (-numpy.inf, numpy.inf))
            beyond = (column < low) | (column > high)
            if beyond.any():
                warnings.warn("joint '%s': %d values are beyond its limits from %g to %g, and asked about all the same" %
                              (name, beyond.sum(), low, high), stacklevel=3)
        return names, numpy.ascontiguousarray(rows)


def _threads(threads):
    if isinstance(threads, bool) or not isinstance(threads, int) or threads < 0:
        raise Error("bad-call", "threads", "give a whole number, 0 for all cores")
    return threads
