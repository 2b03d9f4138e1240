#!/usr/bin/env python3
"""Runs each row of docs/guide/proofs.md: the program answers and states what the row says, and both checkers accept it."""
import contextlib
import io
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
sys.path.insert(0, os.path.join(ROOT, "verifier", "python"))
from sunder_verify import __main__ as checker  # noqa: E402
from sunder_verify.questions import QUESTIONS  # noqa: E402

NOTHING_ASKED = "nothing is asked"


def page():
    with open(os.path.join(ROOT, "docs", "guide", "proofs.md"), encoding="utf-8") as stream:
        return stream.read()


def rows_below(header):
    """The cells of the rows of the table with this header."""
    lines = page().split("\n")
    begin = lines.index(header) + 2
    end = next(k for k in range(begin, len(lines)) if not lines[k].startswith("|"))
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[begin:end]]


def quoted(cell):
    return re.findall("`([^`]+)`", cell)


def statements_of(cell):
    """Pairs of question and verdict, as a cell lists them."""
    words = [word for word in quoted(cell) if word != "left_out"]
    return list(zip(words[::2], words[1::2]))


class Row:
    def __init__(self, cells):
        call, self.outcome, self.states, claims, example = cells
        (self.call,), (self.example,) = quoted(call), quoted(example)
        self.has_left_out = "`left_out`" in self.states
        self.is_stated = self.states != NOTHING_ASKED
        kinds = [tuple(quoted(of_one)) for of_one in claims.split(";")]
        self.wanted = {(*said, of) for said, of in zip(statements_of(self.states), kinds)} if self.is_stated else set()

    def words(self):
        return shlex.split(self.example)[1:]


ROWS = [Row(cells) for cells in rows_below("| verb and options | outcome | statement | claims | for example |")]
UNSAID = {said for cells in rows_below("| statement | why |") for said in statements_of(cells[0])}


def run(*command, **options):
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, **options)


def options_of(verb):
    """Those that its help lists."""
    return set(re.findall(r"^ +(?:-\w,)?(--[\w-]+)", run(PROGRAM, verb, "--help").stdout, re.M)) - {"--help"}


class ProofsPage(unittest.TestCase):
    def test_each_row(self):
        self.is_command_tried = False
        with tempfile.TemporaryDirectory() as folder:
            for row in ROWS:
                with self.subTest(row.example):
                    self.look(row, os.path.join(folder, "proof.json"))

    def look(self, row, proof):
        self.assertEqual(row.example.split()[0], "sunder")
        for word in row.call.split():
            self.assertIn(word, row.words())
        done = run(PROGRAM, *row.words(), *(["--certificate", proof] if row.is_stated else []))
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertIn(row.outcome, done.stdout)
        if not row.is_stated:
            return
        with open(proof, encoding="utf-8") as stream:
            top = json.load(stream)
        made = {(s["question"], s["verdict"], tuple(claim["claim"] for claim in s["claims"])) for s in top["statements"]}
        self.assertEqual(made, row.wanted)
        self.assertEqual(bool(top["left_out"]), row.has_left_out)
        against = [word for given in top["inputs"] for word in ("--against", os.path.join(ROOT, given["name"]))]
        self.assertEqual(self.said_by_python(proof, against), self.said_by_program(proof))
        self.look_at_inputs(top, proof, against)
        os.remove(proof)

    def look_at_inputs(self, top, proof, against):
        """The program makes the same tables again of the inputs, and says of each what the tables are made of."""
        done = run(PROGRAM, "verify", proof, *against)
        self.assertEqual(done.returncode, 0, done)
        self.assertIn("made of these files: this program", done.stdout)
        self.assertTrue(top.get("said") or any("said" in entry for entry in top["tables"].get("bodies", []) + top["tables"].get("meshes", []) +
                                               top["tables"].get("polytopes", [])), top["call"])

    def said_by_python(self, proof, against):
        """By what its command calls, in this process; once by the command. It knows the inputs by their digests."""
        if not self.is_command_tried:
            command = os.path.join(ROOT, "verifier", "python", "sunder_verify")
            told = run(sys.executable, command, proof, *against).stdout
            self.is_command_tried = True
        else:
            with contextlib.redirect_stdout(io.StringIO()) as stream:
                self.assertEqual(checker.main([proof, *against]), 0)
            told = stream.getvalue()
        self.assertIn("of files with these digests", told)
        self.assertTrue(told.endswith(" statements accepted, 0 refused: accepted\n"), told)
        return re.findall(r": statement \d+: accepted: (.*)$", told, re.M)

    def said_by_program(self, proof):
        done = run(PROGRAM, "verify", "--json", proof)
        self.assertEqual(done.returncode, 0, done)
        (told,) = json.loads(done.stdout)["objects"]
        self.assertEqual(told["answer"], "accepted")
        self.assertTrue(told["proved"])
        return told["proved"]

    def test_no_verb_and_no_option_is_missing(self):
        verbs = set(re.findall(r"^  ([a-z]+) {3,}\S", run(PROGRAM, "--help").stdout.split("Verbs:")[1], re.M))
        self.assertEqual(verbs, {row.call.split()[0] for row in ROWS})
        listed = set(quoted(re.search("^Other options.*$", page(), re.M).group()))
        known = set()
        for verb in verbs:
            shown = {word for row in ROWS if row.call.split()[0] == verb for word in row.words() + row.call.split()}
            of_verb = options_of(verb)
            if "--certificate" in of_verb:
                self.assertEqual(of_verb - shown - listed, {"--certificate"}, verb)
            known |= of_verb
        self.assertEqual(listed - known, set())

    def test_no_statement_is_missing(self):
        known = {(question, verdict) for question, (*_, verdicts) in QUESTIONS.items() for verdict in verdicts}
        said = {(question, verdict) for row in ROWS for question, verdict, _ in row.wanted}
        self.assertEqual(said | UNSAID, known)
        self.assertEqual(said & UNSAID, set())


if __name__ == "__main__":
    unittest.main()
