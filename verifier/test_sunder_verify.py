#!/usr/bin/env python3
"""Tests of sunder_verify.py: python3 verifier/test_sunder_verify.py. The C++ test compares the twins."""
import json
import os
import random
import subprocess
import sys
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(os.path.dirname(HERE), "cases", "certificates")
PROGRAM = os.path.join(HERE, "sunder_verify.py")
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import sunder_verify  # noqa: E402


def read(file):
    with open(os.path.join(CASES, file), "rb") as stream:
        return stream.read()


def expected_table():
    lines = read("EXPECTED.tsv").decode().splitlines()
    return [line.split("\t") for line in lines[1:]]


def outcome(data):
    """'-' if accepted, 'unreadable', 'F', or the first check that failed."""
    try:
        refusals = [result[4] for result in sunder_verify.verify(data)]
    except sunder_verify.Unreadable:
        return "unreadable"
    except sunder_verify.Refused as error:
        return error.args[0]
    return next((refusal[0] for refusal in refusals if refusal), "-")


class Corpus(unittest.TestCase):
    def test_each_file_meets_its_expectation(self):
        count = {}
        for file, check, what in expected_table():
            with self.subTest(file=file, what=what):
                self.assertEqual(outcome(read(file)), check)
            count[check] = count.get(check, 0) + 1
        self.assertGreaterEqual(count["-"], 12)
        for check in ("unreadable", "F", "A1", "A2", "A3", "M1", "M2", "M3"):
            self.assertGreaterEqual(count[check], 5)

    def test_index_and_folders_agree(self):
        present = {folder + "/" + file for folder in ("accepted", "refused")
                   for file in os.listdir(os.path.join(CASES, folder))}
        self.assertEqual(sorted(row[0] for row in expected_table()), sorted(present))


class Program(unittest.TestCase):
    def run_program(self, *arguments):
        done = subprocess.run([sys.executable, PROGRAM, *arguments], cwd=CASES, capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    def test_accepted(self):
        code, out, err = self.run_program("accepted/segments.json")
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(len(out.splitlines()), 5)
        self.assertEqual(out.splitlines()[0], 'accepted/segments.json: pair 0: "X", "Y": meet: accepted')
        self.assertEqual(out.splitlines()[-1], "4 pairs accepted, 0 refused: accepted")

    def test_refused(self):
        code, out, err = self.run_program("refused/A1_second_pair.json", "accepted/segments.json", "--quiet")
        self.assertEqual((code, err), (1, ""))
        self.assertEqual(out, 'refused/A1_second_pair.json: pair 1: "first", "third": apart: refused: A1: '
                              'vertex 4 of A is further along the direction than extreme_a\n')
        code, out, err = self.run_program("refused/F_version_3.json", "--quiet")
        self.assertEqual((code, err), (1, ""))
        self.assertEqual(out, "refused/F_version_3.json: refused: F: sunder_certificate is not 1\n")

    def test_note(self):
        code, out, err = self.run_program("accepted/note.json", "--quiet")
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(out, "accepted/note.json: note: \"2 shapes were left out:\\n1 cylinder of 'arm'"
                              "\\u001b[2J\\u007f\\u009b, 1 sphere of 'Spitze, \\u00e4u\\u00dfere'\"\n")
        code, out, err = self.run_program("accepted/set_note.json")
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(out.splitlines()[0], 'accepted/set_note.json: note: "2 features were skipped"')

    def test_one_pair(self):
        code, out, _ = self.run_program("refused/A1_second_pair.json", "--pair", "2")
        self.assertEqual((code, len(out.splitlines())), (0, 2))
        self.assertEqual(self.run_program("refused/A1_second_pair.json", "--pair", "1")[0], 1)
        for pair in ("4", "-1"):
            code, out, err = self.run_program("refused/A1_second_pair.json", "--quiet", "--pair=" + pair)
            self.assertEqual((code, out, len(err.splitlines())), (2, "", 1))

    def test_unreadable_files_and_bad_calls(self):
        for arguments in (["refused/unreadable_comma.json"], ["no/such/file"], ["accepted"], [], ["--no-option", "x"],
                          ["refused/unreadable_utf8.json", "refused/A1_second_pair.json", "--pair", "0"]):
            code, _, err = self.run_program(*arguments)
            self.assertEqual((code, len(err.splitlines())), (2, 1), arguments)
        self.assertIn("refused/unreadable_comma.json: line 9, column ",
                      self.run_program("refused/unreadable_comma.json")[2])

    def test_names_are_printed_as_ascii_on_one_line(self):
        code, out, _ = self.run_program("accepted/spellings.json")
        self.assertEqual((code, len(out.splitlines()), out.isascii()), (0, 3, True))


class RandomStatements(unittest.TestCase):
    """Certificates of any scale, and mutations of them, against fractions."""

    def setUp(self):
        self.random = random.Random(3)

    def double(self):
        scale = self.random.choice((0, 0, -1074, -500, 900))
        return self.random.randint(-4, 4) * Fraction(2) ** scale

    def statement(self):
        """A statement that is true, or that A3 refuses. All numbers are fractions."""
        pick = self.random.randint
        sides = [{"vertices": [[self.double() for _ in range(3)] for _ in range(pick(1, 5))],
                  "linear": [Fraction(pick(-2, 2)) for _ in range(9)],
                  "translation": [self.double() for _ in range(3)]} for _ in range(2)]
        if pick(0, 1):
            direction = [self.double() / pick(1, 9) for _ in range(3)]
            along = [[sum(d * x for d, x in zip(direction, p)) for p in images(side)] for side in sides]
            extremes = [along[0].index(max(along[0])), along[1].index(min(along[1]))]
            return {"sides": sides, "direction": direction, "extremes": extremes}
        weights = []
        for side in sides:
            parts = [pick(0, 3) for _ in side["vertices"]]
            parts[pick(0, len(parts) - 1)] += 1
            weights.append([Fraction(part, sum(parts)) for part in parts])
        sides[1] = dict(sides[0], vertices=list(reversed(sides[0]["vertices"])))  # the same hull
        weights[1] = list(reversed(weights[0]))
        return {"sides": sides, "weights": weights, "point": combination(sides[0], weights[0])}

    def mutate(self, s):
        step = self.random.choice((-1, 1)) * Fraction(2) ** self.random.choice((-1074, -60, 0, 0, 900))
        choice = self.random.randint(0, 3)
        side = self.random.choice(s["sides"])
        if choice == 0:
            self.random.choice(side["vertices"])[self.random.randint(0, 2)] = step
        elif choice == 1:
            side["translation"][self.random.randint(0, 2)] = step
        elif "point" not in s:
            if choice == 2:
                s["direction"][self.random.randint(0, 2)] += step
            else:
                k = self.random.randint(0, 1)
                s["extremes"][k] = self.random.randint(0, len(s["sides"][k]["vertices"]) - 1)
        elif choice == 2:
            s["point"][self.random.randint(0, 2)] += step
        else:
            weights = self.random.choice(s["weights"])
            weights[0] += step
            if self.random.randint(0, 1):
                weights[-1] -= step

    def test_judged_as_with_fractions(self):
        count = {}
        for _ in range(2000):
            s = self.statement()
            self.assertEqual(outcome(to_text(s)), judge(s))
            self.mutate(s)
            check = judge(s)
            text = to_text(s)
            self.assertEqual(outcome(text), check, text)
            count[check] = count.get(check, 0) + 1
        for check in ("-", "A1", "A2", "A3", "M1", "M2", "M3"):
            self.assertGreaterEqual(count.get(check, 0), 40, count)
        self.assertLess(count["-"], 1000)


def images(side):
    m = side["linear"]
    return [[sum(m[3 * r + c] * v[c] for c in range(3)) + side["translation"][r] for r in range(3)]
            for v in side["vertices"]]


def combination(side, weights):
    return [sum(w * p[axis] for w, p in zip(weights, images(side))) for axis in range(3)]


def judge(s):
    """The check that must fail first, or '-'."""
    if "point" in s:
        if min(min(weights) for weights in s["weights"]) < 0:
            return "M1"
        if any(sum(weights) != 1 for weights in s["weights"]):
            return "M2"
        right = all(combination(side, weights) == s["point"] for side, weights in zip(s["sides"], s["weights"]))
        return "-" if right else "M3"
    a, b = ([sum(d * x for d, x in zip(s["direction"], p)) for p in images(side)] for side in s["sides"])
    a_end, b_end = a[s["extremes"][0]], b[s["extremes"][1]]
    return "A1" if max(a) > a_end else "A2" if min(b) < b_end else "-" if a_end < b_end else "A3"


def to_text(s):
    def doubles(values):
        return [float(value).hex() for value in values]
    pair = {"a": 0, "b": 1}
    if "point" in s:
        pair.update(verdict="meet", point=[str(x) for x in s["point"]])
        for name, weights in zip(("weights_a", "weights_b"), s["weights"]):
            pair[name] = [[i, str(weight)] for i, weight in enumerate(weights)]
    else:
        pair.update(verdict="apart", direction=[str(x) for x in s["direction"]],
                    extreme_a=s["extremes"][0], extreme_b=s["extremes"][1])
    sides = s["sides"]
    return json.dumps({
        "sunder_certificate": 1, "pairs": [pair],
        "bodies": [{"name": "", "vertices": [doubles(v) for v in side["vertices"]]} for side in sides],
        "placed": [{"name": "", "body": i, "linear": doubles(side["linear"]),
                    "translation": doubles(side["translation"])} for i, side in enumerate(sides)]}).encode()


if __name__ == "__main__":
    unittest.main()
