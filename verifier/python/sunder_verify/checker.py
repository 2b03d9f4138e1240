"""Checks a file: its form, then each statement."""
from .questions import read_statement
from .reader import SHA256, Refused, Steps, load, members, require, text_of
from .tables import TABLES


class Report:
    """What a file says of itself, and what became of its statements: (question, words, verdict, refusal), where refusal is
    None or (rule, reason)."""

    def __init__(self, inputs, left_out, statements):
        self.inputs, self.left_out, self.statements = inputs, left_out, statements


def read_inputs(value):
    result = []
    for i, item in enumerate(value):
        where = "inputs[%d]" % i
        name, digest = members(item, {"name": str, "sha256": str}, where)
        require(SHA256.fullmatch(digest), "F", where + ".sha256 is not 64 small hexadecimal digits")
        result.append((text_of(name, where + ".name"), digest))
    return result


def verify(data, is_limited=False):
    """Checks the bytes of a file; is_limited: within the steps that a file of its size may take. Raises Unreadable, or
    Refused where the form is wrong."""
    steps = Steps(len(data) if is_limited else None)
    top = load(data)
    require(type(top) is dict, "F", "the file is not an object")
    require("sunder_set_certificate" not in top and top.get("sunder_certificate") != 1, "F",
            "this is a certificate of version 1, which is no longer read; make it again")
    version, tables, statements, inputs, left_out = members(
        top, {"sunder_certificate": int, "tables": dict, "statements": list}, "the file",
        {"inputs": list, "left_out": list})
    require(version == 2, "F", "sunder_certificate is not 2")
    report = Report(read_inputs(inputs or []),
                    [text_of(text, "left_out[%d]" % i) for i, text in enumerate(left_out or [])], [])
    members(tables, {}, "tables", {name: list for name in TABLES})
    read = {name: TABLES[name](value, "tables." + name) for name, value in tables.items()}
    require(statements, "F", "the file states nothing")
    read_statements = [read_statement(item, read, "statements[%d]" % i) for i, item in enumerate(statements)]
    for said, checks in read_statements:
        refusal = None
        try:
            for rule, claim, bound in checks:
                rule(steps, claim, *bound)
        except Refused as error:
            refusal = error.args
        report.statements.append((*said, refusal))
    return report
