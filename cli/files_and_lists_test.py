#!/usr/bin/env python3
"""Runs the program where it might lose something: outputs that are inputs, signals, little memory, long lists."""
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
CASES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "cases")
IS_SANITIZED = "asan" in PROGRAM or "tsan" in PROGRAM  # uses more memory


def run(*arguments, cwd=None, **options):
    return subprocess.run([PROGRAM, *arguments], cwd=cwd, capture_output=True, **options)


def within(megabytes):
    """For preexec_fn: no more address space than so much."""
    return None if IS_SANITIZED else lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return name

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as stream:
            return stream.read()

    def run_here(self, *arguments, **options):
        return run(*arguments, cwd=self.folder.name, **options)

    def expect_bad(self, part, *arguments):
        """Code 2, one line that says so, and no file is changed or made."""
        before = {name: (os.lstat(self.path(name)).st_ino, self.read(name)) for name in os.listdir(self.folder.name)}
        done = self.run_here(*arguments)
        after = {name: (os.lstat(self.path(name)).st_ino, self.read(name)) for name in os.listdir(self.folder.name)}
        self.assertEqual((done.returncode, done.stdout), (2, b""), (arguments, done))
        self.assertEqual(done.stderr.count(b"\n"), 1, done)
        self.assertIn(part.encode(), done.stderr)
        self.assertEqual(before, after)


class Outputs(InFolder):
    def setUp(self):
        super().setUp()
        self.write("x.csv", "0,0,1,1\n5,5,6,7\n")
        with open(os.path.join(CASES, "mesh", "cube.obj"), encoding="utf-8") as cube:
            self.write("cube.obj", cube.read())

    def test_an_output_is_no_input(self):
        same = "is the same file as the input 'x.csv'"
        os.link(self.path("x.csv"), self.path("hard.json"))
        os.symlink("x.csv", self.path("soft.json"))
        for name in ("x.csv", "./x.csv", self.path("x.csv"), "../%s/x.csv" % os.path.basename(self.folder.name),
                     "hard.json", "soft.json"):
            for option in ("--certificate", "--svg", "--geojson"):
                self.expect_bad(same, "segments", "x.csv", option, name)
        self.expect_bad("is the same file as the input 'cube.obj'", "hull", "cube.obj", "-o", "cube.obj")
        self.expect_bad("is the same file as the input 'cube.obj'", "pair", "x.csv", "cube.obj", "--certificate",
                        "cube.obj")
        self.expect_bad("is the same file as the input 'cube.obj'", "scene", "cube.obj@1,0,0", "--svg", "cube.obj")
        self.write("joints", "a=1\n")
        self.expect_bad("is the same file as --joints-file 'joints'", "scene", "cube.obj", "--joints-file", "joints",
                        "--svg", "joints")

    def test_an_output_is_no_mesh_of_a_robot(self):
        with open(os.path.join(CASES, "mesh", "arm.urdf"), encoding="utf-8") as robot:
            self.write("arm.urdf", robot.read())
        for name in ("cube.off", "tetrahedron.stl"):
            with open(os.path.join(CASES, "mesh", name), encoding="utf-8") as mesh:
                self.write(name, mesh.read())
        os.symlink("tetrahedron.stl", self.path("soft.svg"))
        scene = ("scene", "arm.urdf", "--leave-out", "--joints", "elbow=-2,slide=1")
        for option in ("--certificate", "--svg"):
            self.expect_bad("cube.off' is the same file as the input", *scene, option, "cube.off")
            self.expect_bad("soft.svg' is the same file as the input", *scene, option, "soft.svg")
        self.assertIn(self.run_here(*scene, "--svg", "y.svg", "--certificate", "y.json").returncode, (0, 1))

    def test_outputs_of_placements_are_no_inputs(self):
        with open(os.path.join(CASES, "scene", "primitives.urdf"), encoding="utf-8") as robot:
            self.write("robot.urdf", robot.read())
        self.write("t.csv", "hoist\n0\n1\n")
        scene = ("scene", "robot.urdf", "--placements", "t.csv")
        for more in ((), ("--between",)):
            for option in ("--json-lines", "--csv", "--meeting-certificate"):
                self.expect_bad("is the same file as --placements 't.csv'", *scene, *more, option, "t.csv")
                self.expect_bad("is the same file as the input 'robot.urdf'", *scene, *more, option, "robot.urdf")
                self.expect_bad("the name of the file is empty", *scene, *more, option, "")

    def test_an_output_is_no_other_output(self):
        self.expect_bad("is the same file as --geojson 'y'", "segments", "x.csv", "--svg", "y", "--geojson", "y")
        self.expect_bad("is the same file as", "circles", "x.csv", "--svg", "y", "--certificate", "./y")
        self.write("y", "before")
        os.link(self.path("y"), self.path("z"))
        self.expect_bad("is the same file as", "segments", "x.csv", "--svg", "y", "--geojson", "z")

    def test_an_output_is_not_where_the_report_goes(self):
        with open(self.path("y.json"), "wb") as stdout:
            done = subprocess.run([PROGRAM, "segments", "x.csv", "--json", "--certificate", "y.json"],
                                  cwd=self.folder.name, stdout=stdout, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count(b"\n"), 1)
        self.assertIn("is the same file as", json.loads(self.read("y.json"))["error"]["text"])

    def in_shell(self, words):
        return subprocess.run(["sh", "-c", '"$0" ' + words, PROGRAM], cwd=self.folder.name, capture_output=True)

    def expect_refused(self, part, words):
        """Nothing but one line on standard error, and with --json its report; the files stay."""
        before = {name: self.read(name) for name in os.listdir(self.folder.name)}
        done = self.in_shell(words)
        self.assertEqual(done.returncode, 2, (words, done))
        self.assertIn(part.encode(), done.stderr, words)
        self.assertEqual(done.stderr.count(b"\n"), 1, (words, done))
        if "--json" in words and done.stdout:
            self.assertIn("error", json.loads(done.stdout))
        else:
            self.assertEqual(done.stdout, b"", words)
        self.assertEqual({name: self.read(name) for name in os.listdir(self.folder.name)}, before, words)

    def test_standard_output_has_one_writer_by_any_name(self):
        for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"):
            for call in ("segments x.csv --certificate", "segments x.csv --json --svg", "segments x.csv --csv"):
                self.expect_refused("is the same file as standard output", "%s %s" % (call, name))
            self.expect_refused("is the same file as --certificate -",
                                "segments x.csv --certificate - --geojson " + name)
            self.assertEqual(self.in_shell("segments x.csv --quiet --certificate %s" % name).returncode, 0)
        nowhere = "segments x.csv --certificate /dev/null --svg /dev/null > /dev/null"
        self.assertEqual(self.in_shell(nowhere).returncode, 0)
        self.assertEqual(self.in_shell("segments x.csv --certificate - --svg y.svg").returncode, 0)

    def test_standard_input_is_an_input(self):
        self.expect_refused("'x.csv' is the same file as the input -", "segments - --certificate x.csv < x.csv")
        self.expect_refused("is the same file as the input -", "segments - --json < x.csv >> x.csv")
        self.expect_refused("is the same file as the input -", "segments - --certificate - < x.csv >> x.csv")
        self.assertEqual(self.in_shell("segments - --certificate y.json < x.csv").returncode, 0)

    def test_nothing_is_printed_over_an_input(self):
        for words, part in (("segments x.csv --json >> x.csv", "is the same file as the input 'x.csv'"),
                            ("segments x.csv --json --frob >> x.csv", "there is no option '--frob'"),
                            ("scene cube.obj@1,0,0 --json >> cube.obj", "is the same file as the input 'cube.obj'")):
            self.expect_refused(part, words)

    def test_standard_input_is_named_once(self):
        for words in ("pair - -", "verify - -", "verify - --against -", "verify - /dev/stdin"):
            self.expect_refused("standard input is named twice", words + " < cube.obj")

    def test_words_are_no_files(self):
        for words in ("segments x.csv --layer", "pair x.csv cube.obj --feature-a", "kernel x.csv --feature",
                      "segments x.csv --group", "segments x.csv --name", "segments x.csv --property", "region x.csv --maximize",
                      "scene cube.obj --allow adjacent --title"):
            done = self.in_shell(words + " out1 --certificate out1")
            self.assertNotIn(b"is the same file", done.stderr, words)
        self.assertNotIn(b"is the same file", self.in_shell("scene cube.obj --allow touch --svg touch").stderr)
        os.remove(self.path("touch"))
        self.write("pairs", "cube cube\n")
        self.expect_refused("is the same file as --allow 'pairs'", "scene cube.obj --allow pairs --svg pairs")

    def test_names_are_not_empty(self):
        for option in ("--certificate", "--svg", "--geojson"):
            self.expect_bad("the name of the file is empty", "segments", "x.csv", option, "")
        self.expect_bad("the name of the file is empty", "hull", "cube.obj", "-o", "")

    def test_values_are_not_empty(self):
        """As of a variable that is not set: what was to be asked would be left out, and nobody told."""
        for option in ("--clearance", "--pose-b", "--to-b", "--radius-a", "--method", "--certificate="):
            value = () if "=" in option else ("",)
            self.expect_bad("the value of %s is empty; give" % option.rstrip("="), "pair", "cube.obj", "cube.obj", option,
                            *value)
        for option in ("--clearance", "--margin", "--placements", "--joints", "--srdf", "--allow"):
            self.expect_bad("the value of %s is empty; give" % option, "scene", "cube.obj", "cube.obj@3,0,0", option, "")
        self.expect_bad("the value of --clearance is empty; give", "scene", "cube.obj", "cube.obj@3,0,0", "--clearance=")
        done = self.run_here("scene", "cube.obj", "cube.obj@3,0,0", "--svg", "y.svg", "--title", "")
        self.assertEqual(done.returncode, 0, done)

    def test_certificates_of_layers(self):
        board = os.path.join(CASES, "boards", "tinyfpga", "TinyFPGA-BX.kicad_pcb")
        layers = json.loads(run("segments", board, "--centre-lines", "--json").stdout)["objects"][0]["layers"]
        self.assertGreater(len(layers), 1)
        taken = "p.%s.json" % layers[0]  # by the proof for this layer
        with open(board, encoding="utf-8") as stream:
            self.write(taken, stream.read())
        self.expect_bad("is the same file as the input", "segments", taken, "--centre-lines", "--certificate", "p.json")
        self.expect_bad("add --layer NAME or --across-layers", "segments", board, "--centre-lines", "--certificate",
                        "-")
        for choice in (("--layer", layers[0]), ("--across-layers",)):
            done = self.run_here("segments", board, "--centre-lines", "--certificate", "-", *choice)
            self.assertEqual(json.loads(done.stdout)["sunder_certificate"], 3)
        self.write("p.%s.json" % layers[-1], "")
        self.expect_refused("is the same file as standard output",
                            "segments '%s' --centre-lines --certificate p.json >> 'p.%s.json'" % (board, layers[-1]))

    def test_names_of_layers_in_names_of_files(self):
        board = os.path.join(CASES, "boards", "two_nets.kicad_pcb")
        with open(board, encoding="utf-8") as stream:
            self.write("slash.kicad_pcb", stream.read().replace("F.Cu", "../a:b").replace("B.Cu", "../a b"))
        done = self.run_here("segments", "slash.kicad_pcb", "--centre-lines", "--certificate", "proof.json")
        self.assertEqual(done.returncode, 0, done)
        self.assertLess({"proof..._a_b.json", "proof..._a_b-2.json"}, set(os.listdir(self.folder.name)))

    def test_what_is_apart_is_written(self):
        done = self.run_here("segments", "x.csv", "--certificate", "proof.json")
        self.assertEqual(done.returncode, 0, done)
        self.assertEqual(self.run_here("verify", "proof.json").returncode, 0)
        self.assertEqual(self.run_here("segments", "x.csv", "--certificate", "/dev/null").returncode, 0)
        self.assertEqual(self.run_here("segments", "x.csv", "--svg", "y.svg", "--title", "y.svg").returncode, 0)
        self.assertEqual(self.run_here("segments", "x.csv", "--svg", "y.svg", "--title", "y.svg").returncode, 0)


class Streams(InFolder):
    """Standard error and standard output, where they are closed, full, or have another use."""

    def setUp(self):
        super().setUp()
        self.write("x.csv", "0,0,1,1\n0,1,1,0\n")
        self.write("bent.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nv 0.5 0.5 0.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 5\n"
                   "f 3 4 5\nf 4 2 5\n")
        self.run_here("segments", "x.csv", "--certificate", "proof.json")

    def in_shell(self, words):
        return subprocess.run(["sh", "-c", '"$0" ' + words, PROGRAM], cwd=self.folder.name, capture_output=True)

    def test_standard_error_that_cannot_be_written(self):
        for to in ("2>&-", "2>/dev/full"):
            for words, code in (("nofile", 2), ("segments nofile", 2), ("segments nofile --json", 2),
                                ("pair bent.obj bent.obj", 1), ("verify nofile proof.json", 2)):
                done = self.in_shell(words + " " + to)
                self.assertEqual(done.returncode, code, (words, to, done))
        self.assertIn("error", json.loads(self.in_shell("segments nofile --json 2>&-").stdout))

    def test_no_file_takes_the_place_of_a_closed_stream(self):
        done = self.in_shell("pair bent.obj bent.obj --certificate bent.json 2>&-")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.run_here("verify", "bent.json").returncode, 0)
        done = self.in_shell("segments x.csv >&-")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"standard output: cannot be written", done.stderr)

    def test_notes_stay_where_standard_output_is_a_proof(self):
        done = self.run_here("pair", "--hull", "bent.obj", "bent.obj", "--certificate", "-")
        self.assertIn(b"bent.obj is not exactly convex", done.stderr)
        self.assertEqual(json.loads(done.stdout)["sunder_certificate"], 3)
        self.assertEqual(self.run_here("pair", "bent.obj", "bent.obj", "--certificate", "-", "--quiet").stderr, b"")

    def test_verify_is_quiet(self):
        done = self.run_here("verify", "--quiet", "proof.json")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"", b""))

    def test_joint_values_are_held_against_the_files(self):
        robot = os.path.join(CASES, "scene", "primitives.urdf")
        done = self.run_here("scene", robot, "--joints", "hoist=1.125", "--certificate", "joints.json")
        self.assertIn(done.returncode, (0, 1), done)
        proof = self.read("joints.json")
        files = [word for given in json.loads(proof)["inputs"] for word in ("--against", given["name"])]
        self.assertEqual(self.run_here("verify", "joints.json", *files).returncode, 0)
        note = re.search(r'\["hoist", "([^"]*)"\]', proof)
        self.write("joints.json", proof[:note.start(1)] + "0x1p+0" + proof[note.end(1):])
        self.assertEqual(self.run_here("verify", "joints.json").returncode, 0)
        done = self.run_here("verify", "joints.json", *files)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"they do not make the note", done.stdout)

    def test_verify_reports_what_it_cannot_read(self):
        self.write("empty", "")
        self.write("words", "no JSON")
        for name in ("missing", "empty", "words"):
            done = self.run_here("verify", name, "--json")
            report = json.loads(done.stdout)
            self.assertEqual((done.returncode, report["answer"], report["error"]["kind"]), (2, None, "bad-file"))
            self.assertEqual("sunder: %s\n" % report["error"]["text"], done.stderr.decode())
            self.assertEqual([(entry["file"], entry["answer"]) for entry in report["objects"]], [(name, None)])
        report = json.loads(self.run_here("verify", "proof.json", "missing", "--json").stdout)
        self.assertIsNone(report["answer"])
        self.assertIn("missing", report["error"]["text"])
        report = json.loads(self.run_here("verify", "proof.json", "--against", "missing", "--json").stdout)
        self.assertEqual([(entry["file"], entry["answer"]) for entry in report["objects"]],
                         [("proof.json", None)])
        self.assertIn("missing", report["error"]["text"])


class Terminal(InFolder):
    def test_control_bytes_of_names_are_escaped(self):
        name = "a\x1b[31m\nb.csv"
        for text, code in (("0,0,1,1\n0,1,1,0\n", 1), ("0,0,1\n", 2)):
            self.write(name, text)
            done = self.run_here("segments", name)
            self.assertEqual(done.returncode, code)
            shown = done.stdout + done.stderr
            self.assertNotIn(b"\x1b", shown)
            self.assertIn(b"a\\x1b[31m\\x0ab.csv", shown)
        self.write(name, "0,0,1\n0,1,1\n")
        self.assertNotIn(b"\x1b", self.run_here("circles", name).stdout)
        done = self.run_here("circles", name, "--certificate", "p\x1b.json", "--svg", "p\x1b.svg")
        self.assertNotIn(b"\x1b", done.stdout + done.stderr)

    def test_names_in_files_are_escaped(self):
        self.write("x.csv", "0,0,2,2,\x1b[31mred\n0,2,2,0,b\n")
        done = self.run_here("segments", "x.csv")
        self.assertEqual(done.returncode, 1)
        self.assertNotIn(b"\x1b", done.stdout)
        self.assertIn(b"\\x1b[31mred", done.stdout)

    def test_verify_tells_of_each_file(self):
        accepted = os.path.join(CASES, "certificates", "accepted")
        refused = os.path.join(CASES, "certificates", "refused")
        good = os.path.join(accepted, sorted(os.listdir(accepted))[0])
        bad = next(path for path in (os.path.join(refused, name) for name in sorted(os.listdir(refused)))
                   if run("verify", path).returncode == 1)
        done = self.run_here("verify", bad, "missing", good)
        self.assertEqual(done.returncode, 2)
        self.assertIn(os.path.basename(bad).encode() + b": REFUSED", done.stdout)
        self.assertIn(os.path.basename(good).encode() + b": accepted", done.stdout)
        self.assertEqual(done.stderr.count(b"\n"), 1)
        self.assertIn(b"missing", done.stderr)
        report = json.loads(self.run_here("verify", bad, "missing", good, "--json").stdout)
        self.assertEqual([entry["answer"] for entry in report["objects"]], ["refused", None, "accepted"])


class Lists(InFolder):
    def write_equal(self, count):
        self.write("equal.csv", "0,0,1,1\n" * count)

    def test_long_lists_take_little_memory(self):
        count = 2000  # two million contacts: with six bytes more for each, no call fits
        self.write_equal(count)
        self.write("discs.csv", "0,0,1\n" * count)
        squares, comb = (200, 100) if IS_SANITIZED else (725, 600)  # else more than are held
        self.write_squares(squares)
        self.write_comb(comb)
        for megabytes, *arguments in (
                (48, "segments", "equal.csv", "--all", "--json"), (48, "circles", "discs.csv", "--all", "--json"),
                (64, "polygons", "squares.wkt", "--json", "--geojson", "squares.geojson"),
                (64, "simple", "comb.wkt", "--json", "--geojson", "comb.geojson"),
                (48, "segments", "equal.csv", "--geojson", "all.geojson")):
            done = subprocess.run([PROGRAM, *arguments], cwd=self.folder.name, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, preexec_fn=within(megabytes))
            self.assertEqual((done.returncode, done.stderr), (1, b""))
        with open(self.path("all.geojson"), "rb") as stream:
            self.assertEqual(sum(1 for _ in stream), count * (count - 1) // 2 + 2)
        with open(self.path("squares.geojson"), "rb") as stream:
            self.assertEqual(sum(1 for _ in stream), squares * (squares - 1) // 2 + 2)
        with open(self.path("comb.geojson"), "rb") as stream:
            self.assertEqual(sum(1 for _ in stream), (comb // 2) ** 2 + 2)

    def write_squares(self, count):
        self.write("squares.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n" * count)

    def write_comb(self, count):
        """One ring: half of `count` edges go up and down, as many from side to side across these."""
        half = count // 2
        ring = [(k, k % 2 * 4 * half) for k in range(half + 1)]
        ring += [((half + 1, -1)[k % 2], half + k) for k in range(half + 1)]
        ring += [(half + 2, 2 * half), (half + 2, -1), (-1, -1)]
        self.write("comb.wkt", "POLYGON ((%s))\n" % ", ".join("%d %d" % p for p in ring + ring[:1]))

    def test_long_lists_are_in_order(self):
        count = 1450  # more contacts than are held, 2^20
        self.write_equal(count)
        self.write("discs.csv", "0,0,1\n" * count)
        self.expect_in_order(count, ("segments", "equal.csv"), ("circles", "discs.csv"))
        self.write_squares(725)
        self.expect_in_order(725, ("polygons", "squares.wkt"))

    def expect_in_order(self, count, *calls):
        for verb, file in calls:
            report = self.run_here(verb, file, "--all", "--json").stdout
            pairs, number = re.findall(rb'^ *({"i": \d+, "j": \d+)', report, re.M), count * (count - 1) // 2
            self.assertEqual(len(pairs), number)
            self.assertTrue(all(map(bytes.__eq__, pairs, (b'{"i": %d, "j": %d' % (i, j) for i in range(count)
                                                          for j in range(i + 1, count)))))
            self.assertIn(b'\n  "count": %d,\n' % number, report)
            self.assertTrue(report.endswith(b"\n  ]\n}\n"))
            text = self.run_here(verb, file, "--all").stdout.decode()
            self.assertIn("and %d more" % (number - 20), text)

    def test_a_picture_that_is_too_large_is_refused(self):
        self.write_equal(200)
        self.write("discs.csv", "0,0,1\n" * 200)
        for verb, file in (("segments", "equal.csv"), ("circles", "discs.csv")):
            self.expect_bad("--svg-limit 20100", verb, file, "--svg", "y.svg", "--svg-limit", "20099")
            self.expect_bad("--svg-limit 200", verb, file, "--svg", "y.svg", "--svg-limit", "199")
            self.assertEqual(self.run_here(verb, file, "--svg", "y.svg", "--svg-limit", "20100").returncode, 1)

    def test_pictures_of_each_verb_have_a_limit(self):
        """What is drawn, first things only, then with contacts; and the number that allows it."""
        self.write_squares(10)
        self.write_comb(20)
        self.write("half.csv", "1,0,1\n-1,0,1\n0,1,1\n0,-1,1\n")
        self.write("discs.csv", "0,0,1\n" * 10)
        self.write("a.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n")
        self.write("b.wkt", "RAY (0 0, 1 1)\n")
        for things, enough, *call in ((40, 85, "polygons", "squares.wkt"), (25, 125, "simple", "comb.wkt"),
                                      (40, 40, "kernel", "squares.wkt"), (4, 4, "region", "half.csv"),
                                      (10, 10, "region", "--of", "circles", "discs.csv"),
                                      (40, 40, "region", "--of", "polygons", "squares.wkt"),
                                      (8, 8, "pair", "a.wkt", "a.wkt"), (6, 6, "pair", "a.wkt", "b.wkt")):
            draw = (*call, "--svg", "y.svg", "--svg-limit")
            self.expect_bad("give --svg-limit %d" % things, *draw, str(things - 1))
            self.expect_bad("give --svg-limit %d" % enough, *draw, str(enough - 1))
            done = self.run_here(*draw, str(enough))
            self.assertIn(done.returncode, (0, 1), done)
            os.remove(self.path("y.svg"))

    def test_too_many_placements_to_draw(self):
        placements = [word for k in range(20) for word in ("--joints", "panda_joint1=0.%02d" % k)]
        panda = os.path.join(CASES, "panda", "panda.urdf")
        self.expect_bad("facets: more than 40000", "scene", panda, *placements, "--svg", "y.svg", "--svg-limit", "40000")
        self.assertEqual(self.run_here("scene", panda, "--svg", "y.svg", "--svg-limit", "40000").returncode, 1)

    @unittest.skipIf(IS_SANITIZED, "the sanitizer needs address space")
    def test_out_of_memory_is_one_line(self):
        self.write("many.csv", "0,0,1,1\n" * 300000)
        self.write("before.json", "before")
        done = self.run_here("segments", "many.csv", "--certificate", "before.json",
                             preexec_fn=within(48))
        self.assertEqual((done.returncode, done.stdout), (3, b""), done)
        self.assertEqual(done.stderr.count(b"\n"), 1, done)
        self.assertEqual(self.read("before.json"), "before")
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["before.json", "many.csv"])


class Signals(InFolder):
    def test_no_hidden_file_stays(self):
        self.write("equal.csv", "0,0,1,1\n" * 10000)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            process = subprocess.Popen([PROGRAM, "segments", "equal.csv", "--geojson", "all.geojson"],
                                       cwd=self.folder.name, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            for _ in range(12000):  # until the file is being written
                if any(name.endswith(".sunder") for name in os.listdir(self.folder.name)):
                    break
                time.sleep(0.01)
            else:
                self.fail("nothing was written")
            process.send_signal(number)
            self.assertEqual(process.wait(), -number)
            self.assertEqual(os.listdir(self.folder.name), ["equal.csv"])

    def test_no_half_of_a_long_run_stays(self):
        self.write("before.csv", "before")
        self.write("joints.csv", "panda_joint1,panda_joint4\n" + "".join("%r,-1.5\n" % (k * 1e-5) for k in range(200000)))
        before = sorted(os.listdir(self.folder.name))
        for number in (signal.SIGINT, signal.SIGTERM):
            for threads in ("1", "3"):
                process = subprocess.Popen(
                    [PROGRAM, "scene", os.path.join(CASES, "panda", "panda.urdf"), "--allow", "adjacent", "--placements",
                     "joints.csv", "--csv", "before.csv", "--json-lines", "new.jsonl", "--threads", threads],
                    cwd=self.folder.name, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                for _ in range(12000):  # until lines have been written
                    if any(name.endswith(".sunder") and os.path.getsize(self.path(name)) > 0
                           for name in os.listdir(self.folder.name)):
                        break
                    time.sleep(0.01)
                else:
                    self.fail("nothing was written")
                process.send_signal(number)
                self.assertEqual(process.wait(), -number)
                self.assertEqual(sorted(os.listdir(self.folder.name)), before)
                self.assertEqual(self.read("before.csv"), "before")


if __name__ == "__main__":
    if not PROGRAM:
        print("skipped: SUNDER_PROGRAM does not name the program")
        sys.exit(0)
    unittest.main()
