#!/usr/bin/env python3
"""The runner of cli/calls finds what is not so, and refuses data that are not as its format is. The program is echo."""
import os
import subprocess
import sys
import tempfile
import unittest

RUNNER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "calls_test.py")


def run(text, *options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "x.toml")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        done = subprocess.run([sys.executable, RUNNER, *options, path], capture_output=True, text=True, check=False,
                              env={**os.environ, "SUNDER_PROGRAM": "/bin/echo"})
        return done.returncode, done.stdout + done.stderr


def step(text, *options):
    return run('[[test]]\nname = "x"\nstep = [%s]\n' % text, *options)


class Runner(unittest.TestCase):
    def test_what_is_so(self):
        for text, facts in (('{run = "hello", out = ["ell", "lo"]}', 3),
                            ('{run = "a", out = {is = "a\\n", lines = 1}}', 3),
                            ("""{run = "'{\\"a\\": [1, 2]}'", out = {json = ["a.length = 2", "a[*] > 0", "b absent"]}}""",
                             5),
                            ("""{run = "'[{\\"b\\": 1}, {\\"b\\": 2}]'", out = {json = ['[b=2].length = 1']}}""", 2),
                            ('{for = {a = [1, 2], b = ["x", "y"]}, run = "$a $b", out = {is = "$a $b\\n"}}', 8),
                            ('{files = {a = "q"}, file = {a = {is = "q"}}, run = "", absent = ["b"]}', 4)):
            code, out = step(text)
            self.assertEqual(code, 0, out)
            self.assertIn("%d facts, 0 not so" % facts, out)

    def test_what_is_not_so(self):
        for text in ('{run = "hello", out = ["elf"]}', '{run = "hello", code = 1}', '{run = "", file = {a = ["x"]}}',
                     '{run = "hello", out = {has_not = "ell"}}', '{run = "hello", out = {is = "hello"}}',
                     '{run = "a", files = {b = ""}, absent = ["b"]}', '{bad = [["x", "y"]]}', '{run = "a", report = []}',
                     """{run = "'{\\"a\\": [1, 2]}'", out = {json = ["a.length = 3"]}}""",
                     """{run = "'{\\"a\\": []}'", out = {json = ["a[*] > 0"]}}""",
                     """{run = "'{\\"a\\": true}'", out = {json = ["a = 1"]}}""",
                     '{shell = "echo x.cpp:1: runtime error: overflow >&2"}', '{shell = "kill -9 $$"}'):
            code, out = step(text)
            self.assertEqual(code, 1, text)
            self.assertIn("not so", out)

    def test_what_is_not_as_in_the_net(self):
        first = '{run = "b", out = ["b"], files = {f = "1"}}'
        with tempfile.TemporaryDirectory() as folder:
            net = os.path.join(folder, "net")
            self.assertEqual(step('{run = "a", out = ["a"]}, ' + first, "--net", net, "--record")[0], 0)
            for second, calls in ((first, None), ('{run = "bb", out = ["b"], files = {f = "1"}}', "[1] of 2"),
                                  ('{run = "b", out = ["b"], files = {f = "2"}}', "[1] of 2"),
                                  ('{run = "b", out = ["b"], files = {g = "1"}}', "[1] of 2"),
                                  (first + ', {run = "c", out = ["c"]}', "[2] of 3")):
                code, out = step('{run = "a", out = ["a"]}, ' + second, "--net", net)
                self.assertEqual(code, 0 if calls is None else 1, out)
                self.assertIn("0 not so" if calls is None else "not as in the net: calls " + calls, out)

    def test_data_that_are_wrong(self):
        for text, part in (('{run = "a", uot = ["x"]}', "there is no key 'uot'"), ('{out = ["x"]}', "'out' needs 'run'"),
                           ('{run = "a", out = {hass = ["x"]}}', "there is no key 'hass'"), ("", "nothing was checked"),
                           ('{run = "$a"}', "there is no variable 'a'"), ('{run = "a", out = {json = ["a is 1"]}}', ""),
                           ('{run = "$b", for = {b = []}}', "'for' has no turn"), ('{run = "a", let = {b = "c"}}', "nothing uses"),
                           ('{run = "a", for = [{b = 1}]}', "nothing uses the variable 'b'"), ('{run = "a", shell = "a"}', "excludes"),
                           ("""{run = "'{}'", out = {json = ["a == 1"]}}""", "is no fact"),
                           ('{for = {a = {glob = "cases/*.none", least = 1}}, run = "$a"}', "0 files, and 1 are expected"),
                           ('{run = "a", files = {b = "{}"}, edit = {b = ["a.c = 1"]}}', "there are 0 such places")):
            code, out = step(text)
            self.assertEqual(code, 1, text)
            self.assertIn(part, out)

    def test_files_that_are_wrong(self):
        for text, part in (("", "has no test"), ("[[tset]]\n", "there is no key 'tset'"), ("[[test]]\n", "a name of its own"),
                           ('[[test]]\nname = "a"\n[[test]]\nname = "a"\n', "a name of its own")):
            code, out = run(text)
            self.assertEqual(code, 1, text)
            self.assertIn(part, out)


if __name__ == "__main__":
    unittest.main()
