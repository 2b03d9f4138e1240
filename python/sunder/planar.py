"""The plane: convex polygons and poses, sets of segments, discs and polygons, regions and linear programs."""
from sunder._sunder.planar import *  # noqa: F401,F403
