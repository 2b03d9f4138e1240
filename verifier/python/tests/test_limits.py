#!/usr/bin/env python3
"""Tests of both checkers at their limits: hostile files of 1 MB, and what may go wrong around a file.

All of the files if SUNDER_TEST_SCALE is greater than 1; else each fourth, but for the slowest.
"""
import contextlib
import io
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(HERE, "..", "..", "..", "cases", "certificates")
PYTHON = [sys.executable, os.path.join(os.path.dirname(HERE), "sunder_verify")]
PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
IS_WHOLE = float(os.environ.get("SUNDER_TEST_SCALE", "1")) > 1
IS_SANITIZED = "asan" in PROGRAM or "tsan" in PROGRAM
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(HERE))
from hostile import apart, around, bodies, claimed, held, HOSTILE, kept, parts_in_turns, simplex, ZEROS  # noqa: E402
from sunder_verify import __main__ as program, reader  # noqa: E402

YARDSTICK = 0.15  # seconds of yardstick() where the limits are as they are said
MOST_SECONDS = {"python": 30, "c++": 60 if IS_SANITIZED else 3}

SLOWEST = ("a point beside many rings", "linear programs", "linear programs of long integers", "a simplex around a point, often",
           "linear programs with long points")


def files_of_this_run():
    if IS_WHOLE:
        return HOSTILE
    return {what: HOSTILE[what] for what in [what for what in HOSTILE if what not in SLOWEST][::4]}


def checked(command, *arguments, **options):
    """The exit code, standard output, standard error, and the seconds of the processor."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([*command, *arguments], capture_output=True, **options)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.returncode, done.stdout.decode(), done.stderr.decode(), seconds


def twins():
    result = {"python": PYTHON}
    if PROGRAM:
        result["c++"] = [PROGRAM, "verify"]
    return result


def codes_of(path, *arguments):
    """The exit code by each twin; of the Python checker by what its command calls, which is faster than a new process."""
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        code = program.main([path, *arguments])
    yield "python", code
    if PROGRAM:
        yield "c++", checked([PROGRAM, "verify"], path, *arguments)[0]


def yardstick():
    """The seconds of the processor that a fixed piece of work takes: how fast is this machine now?"""
    before, n = time.process_time(), 3 ** 20000
    for _ in range(300):
        n * n
    return time.process_time() - before


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        return path

    def expect_both(self, text, code):
        for name, found in codes_of(self.write("file.json", text)):
            with self.subTest(twin=name, text=text[:40]):
                self.assertEqual(found, code)


class Hostile(InFolder):
    def test_no_file_of_1_mb_takes_long(self):
        codes, slowest = {}, {}
        for what, make in files_of_this_run().items():
            made = make()
            path = self.write("hostile.json", made if isinstance(made, str) else json.dumps(made, separators=(",", ":")))
            self.assertLess(os.path.getsize(path), 1200000, what)
            for name, command in twins().items():
                code, _, error, seconds = checked(command, path)
                if seconds >= MOST_SECONDS[name]:  # a machine that is busy, or slower than the one of the limit
                    seconds = min(seconds, checked(command, path)[3]) / max(1, yardstick() / YARDSTICK)
                with self.subTest(what=what, twin=name):
                    self.assertLess(seconds, MOST_SECONDS[name])
                    self.assertIn(code, (0, 1, 2), error)
                    self.assertEqual(codes.setdefault(what, code), code, error)
                slowest[name] = max(slowest.get(name, (0, "")), (seconds, what))
        print(slowest)
        too_long = list(codes.values()).count(2)
        self.assertGreaterEqual(too_long, 15 if IS_WHOLE else 3)
        self.assertGreaterEqual(len(codes) - too_long, 12 if IS_WHOLE else 3)
        self.assertTrue(set(SLOWEST) < set(HOSTILE))

    def test_limits_are_where_they_are_said_to_be(self):
        direction = ["0x" + "f" * 1600 + "p0", "0", "0"]
        for count, code in ((76, 1), (77, 2)):  # 300 million steps, of 117 each for a look, at 2 x 16,806 + 18 of them
            text = json.dumps(bodies([ZEROS] * 16806, [apart(direction)] * count), separators=(",", ":"))
            self.assertLess(len(text), 10 ** 6)
            path = self.write("pairs.json", text)
            for name, found in codes_of(path):
                with self.subTest(twin=name, count=count):
                    self.assertEqual(found, code)
        for _, found in codes_of(path, "--no-limit"):
            self.assertEqual(found, 1)

    def test_roots_are_counted(self):
        """Four looks of two cones at K bits, two points a body; then a point, or where it comes from, of so many."""
        cone = {"name": "a", "points": [ZEROS, ["0x0p0", "0x0p0", "0x1p0"]], "cone": "0x1p0"}
        ball = {"name": "a", "points": [ZEROS], "radius": "0x1p0"}
        ellipsoid = {"name": "a", "points": [ZEROS], "ellipsoid": "0x1p0"}
        long = "0x" + "f" * 16000 + "p0"
        along = {**apart(["0x1p0", "0x0p0", "0x" + "f" * 1600 + "p0"]), "a": 0}
        for item, statement, steps in (
                (cone, along, 4 * 16 * (16 + 101 * 101) + 4 * (16 + 101)),
                (ball, held([long, "0", "0"]), 8 * (16 + 1001 * 1001) + 17),
                (ellipsoid, held(["0"] * 3, [long, "0", "0"]), 8 * (16 + 1001 * 1001) + 17)):
            statement = {**statement, "b": 1, "a": 0}
            for count, code in ((300000000 // steps, 1), (300000000 // steps + 1, 2)):
                text = json.dumps(claimed("bodies", [item] * 2, *[statement] * count), separators=(",", ":"))
                self.assertLess(len(text), 10 ** 6)
                self.expect_both(text, code)

    def test_all_numbers_of_a_body_are_counted(self):
        """The bits and units of rows, matrix and translation, of a radius and a clearance; a direction and a point."""
        cone = {"name": "a", "points": [["0x1p-1000", "0x0p0", "0x0p0"], ["0x0p0", "0x1p100", "0x0p0"]], "cone": "0x1.8p-500"}
        image = {"name": "a", "of": 1, "linear": ["0x1p-300"] + ZEROS + ["0x1p200"] + ZEROS + ["0x1p0"],
                 "translation": ["0x1p-600", "0x1p100", "0x0p0"]}
        one = {**kept(["1", "0", "0"]), "a": 0, "b": 2, "least": "0x1p-400"}
        size = 1 + (0 + 0 + 1) + (1101 + 1000 + 501 + 300 + 701 + 600 + 504) + 402
        steps = 2 * 16 * (16 + (size // 64 + 1) ** 2) + (16 + 1) + 9 * (16 + 8) + 2 * (16 + 18)
        for count, code in ((300000000 // steps, 1), (300000000 // steps + 1, 2)):
            self.expect_both(json.dumps(claimed("bodies", [{"name": "a", "points": [ZEROS]}, cone, image], *[one] * count)), code)


class Twins(InFolder):
    def test_a_ring_that_names_corners_often(self):
        """What steps are counted by is the number of corners, each once: else these are more than a file may take."""
        points = [["0x1p558", "0x0p0", "0x0p0"], ["0x0p0", "0x1p0", "0x0p0"], ["0x1p0", "0x1p0", "0x0p0"]]
        statement = {"question": "hull", "body": 0, "verdict": "flat", "outline": [0, 1, 2] * 33330,
                     "claims": [{"claim": "outline", "sectors": [None] * 3}]}
        text = json.dumps(claimed("bodies", [{"name": "a", "points": points}], statement), separators=(",", ":"))
        self.expect_both(text, 1)

    def test_nesting(self):
        for deep, code in ((500, 1), (501, 2), (700, 2), (990, 2), (100000, 2)):
            self.expect_both("[" * deep + "]" * deep, code)
            self.expect_both('{"a":' * deep + "1" + "}" * deep, code)
        self.expect_both('["' + "[" * 600 + '"]', 1)
        self.expect_both('["\\"' + "[" * 600 + '"]', 1)
        self.expect_both("[" * 499 + "[],{}" + "]" * 499, 1)

    def test_halves_of_surrogate_pairs(self):
        for half in ("\\ud800", "\\udc00", "\\uDBFF", "\\ud800\\ud800", "\\ud800x\\udc00", "\\ud800\\n"):
            self.expect_both('{"%s": 1}' % half, 2)
            self.expect_both('{"a": "%s", "a": 1}' % half, 2)
            self.expect_both('{"%s": 1, "%s": 1}' % (half, half), 2)
        self.expect_both('{"a": 1, "a": 1}', 1)
        self.expect_both('{"\\ud834\\udd1e": 1, "\\\\ud800": 1}', 1)

    def test_names(self):
        for length, code in ((4000, 1), (4001, 1)):
            path = self.write("file.json", json.dumps(bodies([ZEROS], [apart(["1", "0", "0"])], name="\u00e9" * length)))
            for name, command in twins().items():
                out = checked(command, path)[1]
                with self.subTest(twin=name, length=length):
                    self.assertEqual("of 1 to 4000 characters" in out, length > 4000)


class Around(unittest.TestCase):
    """What may go wrong around a file: one line, and the code that the help says."""

    def setUp(self):
        self.accepted = os.path.join(CASES, "accepted")
        self.names = sorted(os.listdir(self.accepted))
        self.files = [os.path.join(self.accepted, name) for name in self.names]

    def expect_line(self, result, *codes):
        self.assertIn(result.returncode, codes, result)
        self.assertNotIn(b"Traceback", result.stderr)
        self.assertEqual(result.stderr.count(b"\n"), 1, result)

    def test_a_closed_pipe(self):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "wb") as closed:
            self.expect_line(subprocess.run(PYTHON + self.files, stdout=closed, stderr=subprocess.PIPE), 2)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_a_full_output(self):
        with open("/dev/full", "wb") as full:
            self.expect_line(subprocess.run(PYTHON + self.files, stdout=full, stderr=subprocess.PIPE), 2)
            self.expect_line(subprocess.run(PYTHON + self.files[:1], stdout=full, stderr=subprocess.PIPE), 2)

    def test_names_of_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, shown in ((b"caf\xe9.json", b"caf\\xe9.json"), (b"a\x1b[31m\n.json", b"a\\x1b[31m\\x0a.json")):
                path = os.path.join(os.fsencode(folder), name)
                with open(self.files[0], "rb") as source, open(path, "wb") as copy:
                    copy.write(source.read())
                for command in twins().values():
                    for locale in ("C.UTF-8", "C", "POSIX"):
                        done = subprocess.run([*command, path], capture_output=True, env={**os.environ, "LC_ALL": locale})
                        self.assertEqual((done.returncode, done.stderr), (0, b""), done)
                        self.assertIn(shown, done.stdout)
                    done = subprocess.run([*command, path + b"missing"], capture_output=True)
                    self.expect_line(done, 2)
                    self.assertIn(shown, done.stderr)

    @unittest.skipUnless(os.path.exists("/dev/zero"), "there is no /dev/zero")
    def test_an_endless_file(self):
        for command in twins().values():
            done = subprocess.run([*command, "/dev/zero"], capture_output=True)
            self.expect_line(done, 2)
            self.assertIn(b"256 MiB", done.stderr)

    @unittest.skipIf(IS_SANITIZED, "a sanitizer needs more memory than that")
    def test_too_little_memory(self):
        """Code 3 of both, and one line."""
        text = json.dumps(bodies([ZEROS] * 60000, [apart(["1", "0", "0"])] * 30000))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "large.json")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text)
            for command in twins().values():
                most = 16 << 20
                while self.within(most, [*command, self.files[0]]).returncode != 0:  # what the program itself needs
                    most += 8 << 20
                self.expect_line(self.within(most + (16 << 20), [*command, path]), 3)

    @unittest.skipIf(IS_SANITIZED, "a sanitizer needs more memory than that")
    def test_parts_in_turns_of_long_integers(self):
        """In 300 MB: refused, as the file takes too many steps, and not for want of memory."""
        text = json.dumps(parts_in_turns(12000, 5000, far=[["0x1p1023", "0x1p-1074"]]))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "turns.json")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text)
            for command in twins().values():
                self.expect_line(self.within(300 << 20, [*command, path]), 2)

    def within(self, most, command):
        """The call, with so many bytes of memory."""
        return subprocess.run(command, capture_output=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (most, most)))

    def test_each_file_is_told_about(self):
        done = subprocess.run([*PYTHON, self.files[0], "missing", self.files[1]], capture_output=True)
        self.expect_line(done, 2)
        for name in self.names[:2]:
            self.assertIn(name.encode(), done.stdout)

    def test_no_more_than_is_said_is_read(self):
        self.assertEqual(program.MAX_STREAM, 256 << 20)
        self.assertEqual(reader.MAX_DEPTH, 500)


if __name__ == "__main__":
    unittest.main()
