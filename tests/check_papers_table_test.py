#!/usr/bin/env python3
"""check_papers_table.py accepts a good table, and refuses each of its bad twins for the right reason."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_papers_table

FILES = {
    "sunder/solid/pair/x.h": "int by_drums();\n",
    "sunder/solid/pair/x_test.cpp": "TEST(X, Grows) {}\n",
    "bench/pair.cpp": "\n",
    "docs/claims.md": "\n",
    "docs/papers/README.md": "No table here.\n",
}
HEAD = "# A paper\n\n| symbol | here |\n|---|---|\n| n | size |\n\n"
COLUMNS = "| Item | File | Test | Benchmark | Certificate | Command | Departure |\n|---|---|---|---|---|---|---|\n"
BUILT = ("| Theorem 1 | `sunder/solid/pair/x.h` `by_drums` | `sunder/solid/pair/x_test.cpp` `X.Grows` | bench/pair.cpp "
         "| apart, [meet](../claims.md#meet) | `sunder pair a b` | a \\| b |\n")
PLANNED = "| Lemma 2 | not yet | not yet | - | - | - | |\n"
GOOD = HEAD + COLUMNS + BUILT + PLANNED + "\n```\n| item | file |\n```\n"

# name: (what of the good page becomes what, the rule that refuses it)
BAD = {
    "no table": (GOOD, "# A paper\n", "T1"),
    "a column is missing": ("| Benchmark ", "| Speed ", "T1"),
    "in a code block only": (GOOD, "```\n" + COLUMNS + BUILT + "```\n", "T1"),
    "empty": (BUILT + PLANNED, "", "T2"),
    "an empty cell": ("| - | - | - | |", "| | - | - | |", "T3"),
    "a short row": ("| - | - | - | |", "| - |", "T3"),
    "no name": ("| Lemma 2 |", "| - |", "T3"),
    "a file that is not": ("pair/x.h`", "pair/y.h`", "T4"),
    "a test that is not": ("x_test.cpp", "y_test.cpp", "T4"),
    "a benchmark that is not": ("bench/pair.cpp", "bench/other.cpp", "T4"),
    "a link that is not": ("../claims.md", "../other.md", "T4"),
    "a folder for a file": ("`sunder/solid/pair/x.h`", "`sunder/solid/pair`", "T4"),
    "a word for a file": ("| - | - | - | |", "| soon | - | - | |", "T4"),
    "a function that is not": ("`by_drums`", "`by_polar`", "T5"),
    "a test case that is not": ("`X.Grows`", "`X.Shrinks`", "T5"),
    "no test": ("`sunder/solid/pair/x_test.cpp` `X.Grows`", "not yet", "T6"),
    "another command": ("`sunder pair a b`", "`cat a b`", "T7"),
    "two commands": ("`sunder pair a b`", "`sunder pair a b` `sunder pair b a`", "T7"),
}


def findings_of(pages, program=None):
    with tempfile.TemporaryDirectory() as root:
        for path, text in {**FILES, **pages}.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                stream.write(text)
        return check_papers_table.check(root, program)


class CheckPapersTable(unittest.TestCase):
    def test_accepts_the_good_page(self):
        self.assertEqual(findings_of({"docs/papers/a.md": GOOD}), ([], 2))

    def test_refuses_each_bad_twin(self):
        for name, (old, new, rule) in BAD.items():
            with self.subTest(name):
                self.assertEqual(GOOD.count(old), 1)
                findings, _ = findings_of({"docs/papers/a.md": GOOD.replace(old, new)})
                self.assertTrue(findings)
                self.assertTrue(all(": %s: " % rule in finding for finding in findings), findings)

    def test_runs_the_commands(self):
        def findings(program):
            return findings_of({"docs/papers/a.md": GOOD}, program)[0]
        self.assertEqual(findings("/bin/echo"), [])
        self.assertEqual(len(findings("/bin/false")), 1)  # says nothing
        self.assertEqual(len(findings("/bin/ls")), 1)     # complains

    def test_no_page_is_no_success(self):
        findings, _ = findings_of({})
        self.assertEqual(findings, ["docs/papers: T1: there is no page"])

    def test_names_file_and_line(self):
        findings, _ = findings_of({"docs/papers/a.md": GOOD.replace("pair/x.h", "pair/y.h")})
        self.assertEqual(findings, ["docs/papers/a.md:9: T4: file: there is no file sunder/solid/pair/y.h"])


if __name__ == "__main__":
    unittest.main()
