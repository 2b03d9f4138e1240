"""Space: convex polyhedra and their poses."""
from sunder._sunder.solid import *  # noqa: F401,F403
