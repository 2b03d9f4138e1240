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
PLANNED = ("| Lemma 2 | not yet | not yet | -: no one waits for it | -: it yields no evidence "
           "| -: a lemma is not run | |\n")
OPEN = ("\n| Question | Here | Command |\n|---|---|---|\n"
        "| Is it so? | wished: nobody needs it as yet | -: none is there yet |\n")
GOOD = HEAD + COLUMNS + BUILT + PLANNED + "\n```\n| item | file |\n```\n" + OPEN
WAITING = {"a.md": ["Lemma 2"]}
NONE_AT_ALL = "| -: no one waits for it | -: it yields no evidence | -: a lemma is not run | |"

# name: (what of the good page becomes what, the rule that refuses it)
BAD = {
    "no table": (GOOD, "# A paper\n", "T1"),
    "a column is missing": ("| Benchmark ", "| Speed ", "T1"),
    "in a code block only": (GOOD, "```\n" + COLUMNS + BUILT + "```\n", "T1"),
    "empty": (BUILT + PLANNED, "", "T2"),
    "an empty cell": (NONE_AT_ALL, NONE_AT_ALL.replace("-: no one waits for it", ""), "T3"),
    "a short row": (NONE_AT_ALL, "| -: no one waits for it |", "T3"),
    "no name": ("| Theorem 1 |", "| - |", "T3"),
    "no reason": ("-: no one waits for it", "-", "T3"),
    "hardly a reason": ("-: no one waits for it", "-: so be it", "T3"),
    "a file that is not": ("pair/x.h`", "pair/y.h`", "T4"),
    "a test that is not": ("x_test.cpp", "y_test.cpp", "T4"),
    "a benchmark that is not": ("bench/pair.cpp", "bench/other.cpp", "T4"),
    "a link that is not": ("../claims.md", "../other.md", "T4"),
    "a folder for a file": ("`sunder/solid/pair/x.h`", "`sunder/solid/pair`", "T4"),
    "a word for a file": ("-: no one waits for it", "soon", "T4"),
    "a function that is not": ("`by_drums`", "`by_polar`", "T5"),
    "a test case that is not": ("`X.Grows`", "`X.Shrinks`", "T5"),
    "no test": ("`sunder/solid/pair/x_test.cpp` `X.Grows`", "-: it is too plain to test", "T6"),
    "another command": ("`sunder pair a b`", "`cat a b`", "T7"),
    "two commands": ("`sunder pair a b`", "`sunder pair a b` `sunder pair b a`", "T7"),
    "a command of another table": ("-: none is there yet", "`cat a`", "T7"),
    "not yet": ("apart, [meet](../claims.md#meet)", "not yet", "T8"),
    "not yet in another table": ("Is it so?", "Is it, or not yet?", "T8"),
    "wished and no more": ("wished: nobody needs it as yet", "wished", "T9"),
}


def findings_of(pages, program=None, waiting=WAITING):
    with tempfile.TemporaryDirectory() as root:
        for path, text in {**FILES, **pages}.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                stream.write(text)
        return check_papers_table.check(root, program, waiting)


class CheckPapersTable(unittest.TestCase):
    def test_accepts_the_good_page(self):
        self.assertEqual(findings_of({"docs/papers/a.md": GOOD}), ([], 2))

    def test_refuses_each_bad_twin(self):
        for name, (old, new, rule) in BAD.items():
            with self.subTest(name):
                self.assertEqual(GOOD.count(old), 1)
                findings, _ = findings_of({"docs/papers/a.md": GOOD.replace(old, new)})
                self.assertTrue(findings)
                findings = [f for f in findings if "waits no longer" not in f]
                self.assertTrue(findings and all(": %s: " % rule in finding for finding in findings), findings)

    def test_what_waits_is_there(self):
        built = GOOD.replace("not yet", "-: it is not meant")
        self.assertEqual(findings_of({"docs/papers/a.md": built})[0],
                         ["docs/papers/a.md: T8: Lemma 2 waits no longer; take it out of WAITING"])
        self.assertEqual(findings_of({"docs/papers/a.md": built}, waiting={})[0], [])

    def test_runs_the_commands(self):
        def findings(program):
            return findings_of({"docs/papers/a.md": GOOD}, program)[0]
        self.assertEqual(len(findings("/bin/false")), 1)  # says nothing
        self.assertEqual(len(findings("/bin/ls")), 1)     # complains

    def test_the_report_names_the_function(self):
        def findings(function):
            with tempfile.TemporaryDirectory() as folder:
                program = os.path.join(folder, "program")
                with open(program, "w", encoding="utf-8") as stream:
                    stream.write("#!/bin/sh\necho '{\"function\": %s}'\n" % function)
                os.chmod(program, 0o755)
                return findings_of({"docs/papers/a.md": GOOD}, program)[0]
        self.assertEqual(findings('"solid::by_drums"'), [])
        for function in ('"solid::by_polar"', "null"):
            self.assertEqual([": T10: " in finding for finding in findings(function)], [True])

    def test_no_page_is_no_success(self):
        findings, _ = findings_of({}, waiting={})
        self.assertEqual(findings, ["docs/papers: T1: there is no page"])

    def test_names_file_and_line(self):
        findings, _ = findings_of({"docs/papers/a.md": GOOD.replace("pair/x.h", "pair/y.h")})
        self.assertEqual(findings, ["docs/papers/a.md:9: T4: file: there is no file sunder/solid/pair/y.h"])


if __name__ == "__main__":
    unittest.main()
