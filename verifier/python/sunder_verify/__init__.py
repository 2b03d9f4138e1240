"""Checks certificate files of Sunder, exactly and without Sunder: docs/claims.md. No code is shared with the library."""
from .checker import verify  # noqa: F401
from .reader import Refused, Unreadable  # noqa: F401
