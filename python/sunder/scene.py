"""Scenes: many placed bodies."""
from sunder._sunder.scene import *  # noqa: F401,F403
