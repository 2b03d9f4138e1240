"""Many pairs in one call."""
from __future__ import annotations

import numpy

from sunder import _sunder
from sunder._arrays import side
from sunder._error import Error


def intersect_many(a, poses_a, b, poses_b) -> numpy.ndarray:
    """Which of many placed pairs meet, as an array of bool.

    a and b: one convex object, or a list with one for each pair. poses: an array of (N, D, D + 1) or (N, D * (D + 1))
    numbers, each row of the linear part followed by its number of the translation; or one pose for all, or None.
    """
    first = next((one for given in (a, b) for one in (given if isinstance(given, (list, tuple)) else [given])), None)
    dimension = 2 if isinstance(first, _sunder.planar.ConvexPolygon) else 3
    of_a, rows_a, count_a = side(a, poses_a, dimension, "a")
    of_b, rows_b, count_b = side(b, poses_b, dimension, "b")
    if None not in (count_a, count_b) and count_a != count_b:
        raise Error("bad-shape", "intersect_many", "%d of a, %d of b; give as many, or one" % (count_a, count_b))
    count = next((n for n in (count_a, count_b) if n is not None), 1)
    return (_sunder.planar if dimension == 2 else _sunder.solid)._meet(of_a, rows_a, of_b, rows_b, count)
