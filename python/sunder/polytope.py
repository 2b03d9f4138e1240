"""Any dimension, 2 to 6: polytopes of points or half-spaces, their poses, and hierarchical trees."""
from sunder._sunder.polytope import *  # noqa: F401,F403
