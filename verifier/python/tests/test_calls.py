#!/usr/bin/env python3
"""The corpus of cases/certificates, and what the Python checker prints when it is called."""
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(HERE, "..", "..", "..", "cases", "certificates")
PACKAGE = os.path.join(os.path.dirname(HERE), "sunder_verify")
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(HERE))
import sunder_verify  # noqa: E402


def read(file):
    with open(os.path.join(CASES, file), "rb") as stream:
        return stream.read()


def expected_table():
    return [line.split("\t") for line in read("EXPECTED.tsv").decode().splitlines()[1:]]


def outcome(data):
    """'-' if accepted, 'unreadable', or the first rule that fails."""
    try:
        report = sunder_verify.verify(data)
    except sunder_verify.Unreadable:
        return "unreadable"
    except sunder_verify.Refused as error:
        return error.args[0]
    return next((refusal[0] for *_, refusal in report.statements if refusal), "-")


class Corpus(unittest.TestCase):
    def test_each_file_meets_its_expectation(self):
        count = {}
        for file, rule, what in expected_table():
            with self.subTest(file=file, what=what):
                self.assertEqual(outcome(read(file)), rule)
            count[rule] = count.get(rule, 0) + 1
        for rule in ("-", "unreadable", "F", "parted", "holds", "sweep", "sides", "cover"):
            self.assertGreaterEqual(count[rule], 5)

    def test_index_and_folders_agree(self):
        present = {folder + "/" + file for folder in ("accepted", "refused")
                   for file in os.listdir(os.path.join(CASES, folder))}
        self.assertEqual(sorted(row[0] for row in expected_table()), sorted(present))


class Calls(unittest.TestCase):
    def call(self, *arguments, how=(PACKAGE,), where=CASES):
        done = subprocess.run([sys.executable, *how, *arguments], cwd=where, capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    def test_accepted(self):
        code, out, err = self.call("accepted/segments.json")
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(out.splitlines()[0], 'accepted/segments.json: statement 0: accepted: the convex hull of the 2 mapped points of "X" '
                         'and the convex hull of the 2 mapped points of "Y" meet at (0, 0, 0)')
        self.assertEqual(out.splitlines()[4:], ["4 statements accepted, 0 refused: accepted"])
        as_module = self.call(os.path.join(CASES, "accepted", "segments.json"), "--quiet", how=("-m", "sunder_verify"),
                              where=os.path.dirname(PACKAGE))
        self.assertEqual(as_module, (0, "", ""))

    def test_refused(self):
        code, out, err = self.call("refused/parted_second_statement.json", "accepted/segments.json", "--quiet")
        self.assertEqual((code, err), (1, ""))
        self.assertEqual(out, 'refused/parted_second_statement.json: statement 1: refused: the convex hull of the 8 mapped points '
                              'of "first" and the convex hull of the 8 mapped points of "third" are apart: '
                              'parted: "first" is not strictly less far along the direction than "third"\n')
        for file, version in (("F_version_1", 1), ("F_version_1_of_a_set", 1), ("F_version_2", 2), ("F_version_4", 4)):
            file = "refused/%s.json" % file
            self.assertEqual(self.call(file, "--quiet"), (
                1, "%s: refused: F: the file is of version %d, and version 3 is needed; make it again\n" % (file, version), ""))

    def test_what_was_left_out_is_always_told(self):
        self.assertEqual(self.call("accepted/left_out.json", "--quiet"), (
            0, "accepted/left_out.json: left out: \"1 cylinder of 'arm'\\u001b[2J\\u007f\\u009b, \\u00e4u\\u00dfere\"\n", ""))

    def test_against_compares_digests_of_files_in_their_order(self):
        inputs = {"one": b"1", "two": b"22"}
        top = json.loads(read("accepted/segments.json"))
        top["inputs"] = [{"name": name, "sha256": hashlib.sha256(text).hexdigest()} for name, text in inputs.items()]
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**inputs, "other": b"3", "proof": json.dumps(top).encode()}.items():
                with open(os.path.join(folder, name), "wb") as stream:
                    stream.write(text)

            def told(*files):
                words = [word for file in files for word in ("--against", file)]
                return self.call("proof", "--quiet", *words, where=folder)
            code, out, err = told("one", "two")
            self.assertEqual((code, err), (0, ""))
            self.assertIn("proof: of files with these digests; what is in them was not looked at\n", out)
            for files, why in ((("one", "other"), 'input 2, "two", has another SHA-256 than other, '),
                               (("two", "one"), 'input 1, "one", has another SHA-256 than two, '),
                               (("one",), "it names 2 inputs, and 1 are given; give all, in their order"),
                               (("one", "two", "two"), "it names 2 inputs, and 3 are given")):
                code, out, err = told(*files)
                self.assertEqual((code, err), (1, ""), files)
                self.assertIn("proof: not of these files: " + why, out)
            code, out, err = told("one", "missing")
            self.assertEqual((code, out), (2, ""))
            self.assertIn("missing: No such file", err)

    def test_unreadable_files_and_bad_calls(self):
        for arguments in (["refused/unreadable_comma.json"], ["no/such/file"], ["accepted"], [], ["--no-option", "x"]):
            code, _, err = self.call(*arguments)
            self.assertEqual((code, len(err.splitlines())), (2, 1), arguments)
        self.assertIn("refused/unreadable_comma.json: line 9, column ", self.call("refused/unreadable_comma.json")[2])

    def test_names_are_printed_as_ascii_on_one_line(self):
        code, out, _ = self.call("accepted/spellings.json")
        self.assertEqual((code, len(out.splitlines()), out.isascii()), (0, 3, True))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "names.json")
            with open(path, "wb") as file:
                file.write(read("refused/parted_second_statement.json").replace(b'"first"', b'"fi\\nrst"'))
            code, out, _ = self.call(path, "--quiet")
            self.assertEqual((code, len(out.splitlines())), (1, 1), out)


if __name__ == "__main__":
    unittest.main()
