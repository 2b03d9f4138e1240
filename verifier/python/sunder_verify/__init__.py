"""Checks certificate files of Sunder, exactly and without Sunder: docs/claims.md. No code of the library is shared."""
from .checker import verify  # noqa: F401
from .reader import Refused, Unreadable  # noqa: F401
