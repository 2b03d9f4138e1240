"""Certificate files of version 2, how they are spoilt, and what both checkers say of them: for tests."""
import json
import os
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import sunder_verify  # noqa: E402

PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
SCALE = float(os.environ.get("SUNDER_TEST_SCALE", "1"))


def some(count):
    """So many, at the scale that is asked for."""
    return max(1, int(count * SCALE))


def hexadecimal(n):
    return "%s0x%xp+0" % ("-" if n < 0 else "", abs(n))


def fraction(x):
    return "%d/%d" % (x.numerator, x.denominator) if x.denominator != 1 else str(x.numerator)


def file_of(tables, *statements):
    return {"sunder_certificate": 2, "tables": tables, "statements": list(statements)}


def outcome(top):
    """By the Python checker: "accepted", "not checked", or the first rule that fails."""
    try:
        report = sunder_verify.verify(json.dumps(top).encode(), True)
    except sunder_verify.Refused as refused:
        return refused.args[0]
    except sunder_verify.Unreadable:
        return "not checked"
    return next((refusal[0] for *_, refusal in report.statements if refusal), "accepted")


def outcomes_of_twin(tops):
    """The same by `sunder verify`."""
    result = []
    with tempfile.TemporaryDirectory() as folder:
        for begin in range(0, len(tops), 500):
            names = []
            for i, top in enumerate(tops[begin:begin + 500]):
                names.append(os.path.join(folder, str(i)))
                with open(names[-1], "w", encoding="utf-8") as stream:
                    json.dump(top, stream)
            run = subprocess.run([PROGRAM, "verify", "--json", *names], capture_output=True, text=True, check=False)
            objects = json.loads(run.stdout)["objects"] if run.stdout else [{"answer": "not checked"}] * len(names)
            result += [o["refused"][0]["check"] if o["answer"] == "refused" else o["answer"] for o in objects]
    return result


VALUES = ["0", "1", "-1", "1/2", "-1/3", "0x1p+0", "-0x1p-1", "0x3p+0", "7", "nothing", "touch", "0x1p+20001", "1/0", ".5"]


def spoilt(value, dice):
    """One random change somewhere in a JSON value."""
    if isinstance(value, dict) and value:
        key, value, throw = dice.choice(list(value)), dict(value), dice.random()
        if throw < .03:
            del value[key]
        elif throw < .04:
            value[key + "x"] = 1
        else:
            value[key] = spoilt(value[key], dice)
        return value
    if isinstance(value, list):
        value, throw = list(value), dice.random()
        if not value or throw < .05:
            value.insert(dice.randint(0, len(value)), dice.choice([0, 1, -1, "1", "0x1p+0", None]))
        elif throw < .1:
            value.pop(dice.randrange(len(value)))
        elif throw < .15 and len(value) > 1:
            i, j = dice.sample(range(len(value)), 2)
            value[i], value[j] = value[j], value[i]
        else:
            i = dice.randrange(len(value))
            value[i] = spoilt(value[i], dice)
        return value
    if isinstance(value, str):
        return dice.choice(VALUES + [value])
    if isinstance(value, int):
        return dice.choice([value + 1, value - 1, 0, 1, 2, -1, True, 1.0, None, 10 ** 16])
    return dice.choice([0, None, "1", [], {}])


def spoilt_in_statements(top, dice):
    """The same, in the statements only: what they speak of stays as it is."""
    return {**top, "statements": spoilt(top["statements"], dice)}


class Twins:
    """Collects files and what the Python checker says of them, to compare it with what the twin says."""

    def __init__(self, test):
        self.test, self.tops, self.outcomes = test, [], []

    def look(self, top):
        self.tops.append(top)
        self.outcomes.append(outcome(top))
        return self.outcomes[-1]

    def compare(self):
        if not PROGRAM:
            return
        for top, ours, other in zip(self.tops, self.outcomes, outcomes_of_twin(self.tops)):
            self.test.assertEqual(ours, other, json.dumps(top)[:3000])

    def tally(self):
        return {name: self.outcomes.count(name) for name in set(self.outcomes)}


def dice_of(seed):
    return random.Random(seed + int(os.environ.get("SUNDER_TEST_SEED", "0")))
