"""The one exception of the package."""


class Error(Exception):
    """Bad input: what is wrong and the remedy.

    kind: "bad-value", "bad-shape", "bad-pose", "bad-file", "bad-call", or "internal" for a fault of Sunder itself.
    place: where, such as "vertex 7", "pose", "FILE:LINE"; may be empty.
    text: what is wrong, and what to do. str() gives place and text.
    """

    def __init__(self, kind: str, place: str, text: str) -> None:
        super().__init__("%s: %s" % (place, text) if place else text)
        self.kind, self.place, self.text = kind, place, text

    def __reduce__(self):
        return Error, (self.kind, self.place, self.text)


Error.__module__ = "sunder"  # as which it is known
