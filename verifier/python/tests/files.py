"""Certificate files of version 3, how they are spoilt, and what both checkers say of them: for tests."""
import collections
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import sunder_verify  # noqa: E402
from sunder_verify.questions import QUESTIONS  # noqa: E402
from units import in_other_units  # noqa: E402

PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
SCALE = float(os.environ.get("SUNDER_TEST_SCALE", "1"))


def some(count):
    """So many, at the scale that is asked for; 20 times at most: beyond, only tries of statements become more."""
    return max(1, int(count * min(SCALE, 20)))


FORCED, MUTANT = "forced", "mutants"
WANTED = {FORCED: max(4, int(400 * SCALE)), MUTANT: max(2, int(40 * SCALE))}  # tries of each statement
TRIED = {kind: collections.Counter() for kind in (*WANTED, "accepted")}       # by question and verdict


def lacking(kind, question):
    """The verdicts of a question of which too few have been tried."""
    return [verdict for verdict in QUESTIONS[question][-1] if TRIED[kind][question, verdict] < WANTED[kind]]


def hexadecimal(n):
    """Of an integer, or of a fraction whose denominator is a power of two."""
    return "%s0x%xp%+d" % ("-" if n < 0 else "", abs(n.numerator), 1 - n.denominator.bit_length())


def fraction(x):
    return "%d/%d" % (x.numerator, x.denominator) if x.denominator != 1 else str(x.numerator)


def file_of(tables, *statements):
    return {"sunder_certificate": 3, "inputs": [], "call": [], "left_out": [], "tables": tables, "statements": list(statements)}


def told(text):
    """By the Python checker: "accepted", "not checked", or the first rule that fails; and what is proved, in sentences."""
    try:
        report = sunder_verify.verify(text.encode(), True)
    except sunder_verify.Refused as refused:
        return refused.args[0], []
    except sunder_verify.Unreadable:
        return "not checked", []
    refusals = [refusal[0] for _, refusal in report.statements if refusal]
    return (refusals or ["accepted"])[0], [sentence for sentence, refusal in report.statements if not refusal]


def outcome(top):
    return told(json.dumps(top))[0]


def told_by_twin(texts):
    """The same by `sunder verify`, in one call. Files are in memory, if that is a folder: elsewhere they take long."""
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None) as folder:
        names = [os.path.join(folder, str(i)) for i in range(len(texts))]
        for name, text in zip(names, texts):
            with open(name, "w", encoding="utf-8") as stream:
                stream.write(text)
        run = subprocess.run([PROGRAM, "verify", "--json", *names], capture_output=True, text=True, check=False)
        objects = json.loads(run.stdout)["objects"] if run.stdout else [{"answer": "not checked"}] * len(names)
        return [(o["refused"][0]["check"] if o["answer"] == "refused" else o["answer"] or "not checked", o.get("proved", []))
                for o in objects]


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
    """Asks the Python checker about files, and compares what it says with what the twin says, of many at once; and of each
    fourth file with what both say of it in other units."""

    def __init__(self, test):
        self.test, self.waiting, self.count, self.last, self.said = test, [], 0, None, collections.Counter()
        self.dice = dice_of(2031)

    def look(self, top):
        """What the checker says of a file."""
        self.last, self.count = top, self.count + 1
        said = self.told(top)
        self.said[said] += 1
        other = in_other_units(top, self.dice) if self.count % 4 == 0 and said not in ("F", "not checked") else None
        if other:
            self.test.assertEqual(self.told(other), said, (top, other))
        if len(self.waiting) >= 1000:
            self.compare()
        return said

    def told(self, top):
        text = json.dumps(top)
        said, proved = told(text)
        if PROGRAM:
            self.waiting.append((text, (said, proved)))
        return said

    def force(self, top, at=-1):
        """The same of a file about which the test knows whether it is true. Counted, as a try of the statement that
        stands there, if its form is right."""
        said = self.look(top)
        if said not in ("F", "not checked"):
            key = top["statements"][at]["question"], top["statements"][at]["verdict"]
            TRIED[FORCED][key] += 1
            TRIED["accepted"][key] += said == "accepted"
        return said

    def spoil(self, top, dice):
        """Both checkers look at a file with a change anywhere, and at one with a change in the statements."""
        key = top["statements"][-1]["question"], top["statements"][-1]["verdict"]
        for change in (spoilt, spoilt_in_statements):
            self.look(change(top, dice))
            TRIED[MUTANT][key] += 1

    def compare(self):
        waiting, self.waiting = self.waiting, []
        if not waiting:
            return
        for (text, ours), other in zip(waiting, told_by_twin([text for text, _ in waiting])):
            self.test.assertEqual(ours, other, text[:3000])

    def tally(self):
        return dict(self.said)


def main():
    """Runs the tests of a file, then tells how often each statement was tried."""
    done = unittest.main(exit=False)
    keys = sorted(set(TRIED[FORCED]) | set(TRIED[MUTANT]))
    if keys:
        print("%-28s %-15s %9s %9s %9s" % ("question", "verdict", "forced", "accepted", "mutants"))
    for key in keys:
        print("%-28s %-15s %9d %9d %9d" % (*key, TRIED[FORCED][key], TRIED["accepted"][key], TRIED[MUTANT][key]))
    sys.exit(not done.result.wasSuccessful())


def dice_of(seed):
    return random.Random(seed + int(os.environ.get("SUNDER_TEST_SEED", "0")))
