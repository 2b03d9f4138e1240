"""Robots: which links meet, for one placement or for thousands."""
from __future__ import annotations

import os
import warnings
from typing import Dict, Iterable, List, Mapping, Optional, Tuple, Union

import numpy

from sunder import _sunder
from sunder._arrays import doubles
from sunder._error import Error

Path = Union[str, "os.PathLike[str]"]
MOST_PROVED = 10_000  # placements in one certificate


class Collisions:
    """What meets, placement by placement: collisions[k] are the pairs of placement k, by name. True where some meet.

    The arrays are about pairs of parts, placement after placement; those that meet in a way that is allowed are not
    among them. placement: of each pair its placement, (M,). bodies, parts: two numbers each, (M, 2), of names in
    robot.bodies and robot.parts(name). decided: where it is known that they meet, (M,); only pairs with cylinders,
    cones and ellipsoids, and only next to touching, may be undecided. points: about a common point, (M, 3), where
    evidence was asked for; else None.
    """

    def __init__(self, found: "_sunder._Collisions", names: List[str], evidence: bool) -> None:
        self._names = names
        self._count = found.placements
        self.placement = found.placement
        self.bodies = found.bodies
        self.parts = found.parts
        self.decided = found.decided.astype(bool)
        self.points = found.points if evidence else None

    @property
    def meet(self) -> numpy.ndarray:
        """Of each placement: do some meet?"""
        return self._some(self.decided)

    @property
    def undecided(self) -> numpy.ndarray:
        """Of each placement: is it unknown of some pair whether it meets?"""
        return self._some(~self.decided)

    def _some(self, which):
        result = numpy.zeros(self._count, dtype=bool)
        result[self.placement[which]] = True
        return result

    @property
    def pairs(self) -> List[Tuple[str, str]]:
        """Of each row of the arrays the two bodies, by name."""
        return [(self._names[a], self._names[b]) for a, b in self.bodies.tolist()]

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, k: int) -> List[Tuple[str, str]]:
        k = range(self._count)[k]
        first, last = numpy.searchsorted(self.placement, [k, k + 1])
        pairs = self.bodies[first:last][self.decided[first:last]]
        return [(self._names[a], self._names[b]) for a, b in dict.fromkeys(map(tuple, pairs.tolist()))]

    def __bool__(self) -> bool:
        return bool(self.decided.any())


class Robot:
    """A robot out of a URDF file, and maybe what stands around it.

    packages: folders of packages by name. srdf: pairs that it disables are allowed to meet. groups: names of groups of
    the srdf; the shapes of other links are left out. scene: a scene file, whose
    bodies do not move. allow: "adjacent" (links joined by a joint), "touch" (pairs that only touch do not count), and
    pairs of names. require_convex: meshes that are not convex are an error, and not stood for by their hulls; .hulls
    has the bodies of which some are. leave_out: shapes that are not read are left out; .left_out says which.
    """

    def __init__(self, file: Path, *, packages: Optional[Mapping[str, Path]] = None, srdf: Optional[Path] = None,
                 groups: "str | Iterable[str]" = (), scene: Optional[Path] = None,
                 allow: "str | Iterable[str | Tuple[str, str]]" = (), require_convex: bool = False,
                 leave_out: bool = False) -> None:
        named = ["%s=%s" % (name, os.fspath(folder)) for name, folder in dict(packages or {}).items()]
        self._robot = _sunder._Robot(os.fspath(file), named, "" if srdf is None else os.fspath(srdf),
                                     "" if scene is None else os.fspath(scene),
                                     [groups] if isinstance(groups, str) else list(groups), require_convex, leave_out)
        for one in [allow] if isinstance(allow, str) else allow:
            if one == "adjacent":
                self._robot.allow_adjacent()
            elif one == "touch":
                self._robot.allow_touch()
            elif isinstance(one, (tuple, list)) and len(one) == 2 and all(isinstance(name, str) for name in one):
                self._robot.allow(*one)
            else:
                raise Error("bad-call", "allow", "give \"adjacent\", \"touch\", and pairs of names")

    @property
    def name(self) -> str:
        return self._robot.name

    @property
    def joints(self) -> Dict[str, Tuple[float, float]]:
        """The joints that take values, with their limits, in the order of vectors: radians, or metres."""
        return self._robot.joints

    @property
    def links(self) -> List[str]:
        """All links, also those without a shape."""
        return self._robot.links

    @property
    def bodies(self) -> List[str]:
        """What is asked about: links with shapes, then the bodies of the scene."""
        return self._robot.bodies

    def parts(self, body: str) -> List[str]:
        """The names of a body's parts."""
        if body not in self.bodies:
            raise Error("bad-call", "parts", "no body is named '%s'" % body)
        return self._robot.part_names(self.bodies.index(body))

    @property
    def hulls(self) -> List[str]:
        """Bodies of which a mesh is not convex: its hull stands for it, and what is said of it is said of the hull."""
        return self._robot.hulls

    @property
    def allowed(self) -> List[Tuple[str, str]]:
        """Pairs of bodies that are not asked about."""
        return self._robot.allowed

    @property
    def left_out(self) -> List[str]:
        """What of the files is not asked about."""
        return self._robot.left_out

    def collisions(self, joints: object = None, *, evidence: bool = False, threads: int = 0) -> Collisions:
        """Which bodies meet?

        joints: values by name (others are at 0, or at the limit nearest to it); a vector in the order of .joints; or an
        array of a row for each placement, or values by name that are vectors, for many. Values beyond a joint's limits
        are asked about, with a warning. threads: 0 is all cores; the result is the same for any number. Other threads
        of Python run meanwhile.
        """
        names, rows = self._rows(joints)
        if isinstance(threads, bool) or not isinstance(threads, int) or threads < 0:
            raise Error("bad-call", "threads", "give a whole number, 0 for all cores")
        return Collisions(self._robot.collisions(names, rows, evidence, threads), self.bodies, evidence)

    def certificate(self, joints: object = None) -> bytes:
        """The certificate file of these placements, for sunder_verify: of all pairs that are not allowed."""
        names, rows = self._rows(joints)
        if len(rows) > MOST_PROVED:
            raise Error("bad-call", "joints", "%d placements; give at most %d in one certificate" %
                        (len(rows), MOST_PROVED))
        return self._robot.certificate(names, rows)

    def _rows(self, joints):
        limits = self.joints
        if joints is None:
            joints = {}
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
            names = list(limits)
            rows = numpy.atleast_2d(doubles(joints, "joints", (len(names),), (-1, len(names))))
        if not numpy.isfinite(rows).all():
            raise Error("bad-value", "joints", "a number is not finite")
        self._warn(names, rows, limits)
        return names, numpy.ascontiguousarray(rows)

    @staticmethod
    def _warn(names, rows, limits):
        for k, name in enumerate(names):
            low, high = limits.get(name, (-numpy.inf, numpy.inf))
            beyond = (rows[:, k] < low) | (rows[:, k] > high)
            if beyond.any():
                warnings.warn("joint '%s': %d values are beyond its limits from %g to %g, and asked about all the same" %
                              (name, beyond.sum(), low, high), stacklevel=4)
