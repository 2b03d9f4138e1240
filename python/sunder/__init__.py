"""Sunder tells whether things meet, and proves it: exact answers for the doubles given, each with its certificate.

Objects and questions are in sunder.planar, sunder.solid and sunder.polytope, under the names of the C++ library. All of
them are immutable. Arrays are copied, and refused where a number would be rounded. Bad input raises sunder.Error.
"""
from sunder._error import Error
from sunder._sunder import Cost, PairAnswer, __version__, intersect
from sunder import planar, polytope, solid
from sunder._ask import Report, ask
from sunder._many import intersect_many
from sunder._robot import Found, Robot

__all__ = ["Cost", "Error", "Found", "PairAnswer", "Report", "Robot", "ask", "intersect", "intersect_many",
           "planar", "polytope", "solid", "__version__"]
