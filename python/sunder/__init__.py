"""Sunder tells whether things meet, and proves it: exact answers for the doubles given, each with its certificate.

Objects and questions are in sunder.planar, sunder.solid and sunder.scene, under the names of the C++ library. All of
them are immutable. Arrays are copied, and refused where a number would be rounded. Bad input raises sunder.Error.
"""
from sunder._error import Error
from sunder import _sunder
from sunder._sunder import Cost, PairAnswer, __version__, intersect, intersect_many
from sunder import planar, scene, solid
from sunder._ask import Report, ask

__all__ = ["Cost", "Error", "PairAnswer", "Report", "ask", "intersect", "intersect_many", "planar", "scene", "solid",
           "__version__"]
