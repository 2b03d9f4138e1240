# Files about sets and what becomes of them: for tests of the checkers.
import json

import sunder_verify

RULES = ("nothing", "shared-endpoint", "touch")


def hexadecimal(n):
    return "%s0x%xp+0" % ("-" if n < 0 else "", abs(n))


def as_file(table, rows, *statements):
    rows = [[hexadecimal(n) for n in row] for row in rows]
    return json.dumps({"sunder_set_certificate": 1, table: rows, "statements": list(statements)}).encode()


def outcome(data):
    try:
        refusals = [result[4] for result in sunder_verify.verify(data)]
    except sunder_verify.Refused as error:
        return error.args[0]
    return next((refusal[0] for refusal in refusals if refusal), "-")


def refused_by(check):
    """The check that fails, or None."""
    try:
        check()
    except sunder_verify.Refused as error:
        return error.args[0]
    return None
