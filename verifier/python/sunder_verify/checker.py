"""Checks a file: its form, then each statement."""
from collections import namedtuple

from .questions import statement
from .reader import MOST_NUMBER, SHA256, Refused, Steps, anything, double, form, list_of, load, members, text_of
from .said import of_tables
from .meshes import meshes
from .tables import TABLES

# What a file says of itself, and what became of its statements: (sentence, refusal), where refusal is None or
# (rule, reason).
Report = namedtuple("Report", "inputs call left_out statements")

VERSION = 3


def sha256(value, where, read):
    form(type(value) is str and SHA256.fullmatch(value), where + " is not 64 small hexadecimal digits")
    return value


def made_of(value, where, read):
    return tuple(members(value, {"name": text_of, "sha256": sha256}, where).values())


def tables(value, where, read):
    shapes = {**TABLES, "meshes": meshes}
    result = members(value, shapes, where, {"inputs": read["inputs"], "steps": read["steps"]}, dict.fromkeys(shapes))
    return {**result, "sizes": {name: len(those) for name, those in value.items()}}


def has_open_piece(meshes, item):
    return any(len(meshes[item[key]].closed) < len(meshes[item[key]].triangles) for key in ("a", "b"))


FILE = {"sunder_certificate": anything, "inputs": list_of(made_of), "call": list_of(text_of),
        "left_out": list_of(text_of), "tables": tables, "said": of_tables,
        "statements": list_of(statement, lambda those, read: those, ": the file states nothing")}


def verify(data, is_limited=False):
    """Checks the bytes of a file; is_limited: within the steps that a file of its size may take. Raises Unreadable, or
    Refused where the form is wrong."""
    steps = Steps(len(data) if is_limited else None)
    top = load(data)
    form(type(top) is dict, "the file is not an object")
    version = top.get("sunder_certificate", 1 if "sunder_set_certificate" in top else None)
    form(type(version) is int and abs(version) <= MOST_NUMBER, "the file has no version, sunder_certificate")
    form(version == VERSION, "the file is of version %d, and version %d is needed; make it again" % (version, VERSION))
    read = members(top, FILE, "", {"steps": steps, "proved": {}}, {"said": {}})
    statements = []
    for item, said, checks in read["statements"]:
        refusal = None
        try:
            for rule, bound in checks:
                rule(steps, *bound)
            if "a" in item and "b" in item:
                word, least = item["verdict"], double(item["least"], "least") if "least" in item else None
                if word == "touching" and item["question"] == "meshes" and has_open_piece(read["tables"]["meshes"], item):
                    word = "meet"  # what a surface alone may do, where touching is allowed, is not told
                read["proved"].setdefault((item["question"], item["a"], item["b"], least), set()).add(word)
            if item["question"] == "hull":
                faces = item.get("faces") or [item.get("outline") or [item.get("i"), item.get("j")]]
                read["proved"][item["body"]] = item["verdict"], faces
        except Refused as error:
            refusal = error.args
        statements.append((said, refusal))
    return Report(read["inputs"], read["call"], read["left_out"], statements)
