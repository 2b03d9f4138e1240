#!/usr/bin/env python3
"""Scene files are as docs/schema/scene.schema.json says; what it refuses, the program refuses in one line."""
import copy
import json
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "tests"))
import json_schema  # noqa: E402

PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
CASES = os.path.join(ROOT, "cases", "scene")
SCHEMA = json_schema.Schema(json.load(open(os.path.join(ROOT, "docs", "schema", "scene.schema.json"), encoding="utf-8")))


def scenes():
    return [os.path.join(CASES, name) for name in sorted(os.listdir(CASES)) if name.endswith(".json")]


def run(path):
    return subprocess.run([PROGRAM, "scene", path], capture_output=True, text=True, check=False)


def mutants(value):
    """The value with one thing changed, wherever that can be: a key lost, a key too many, another type."""
    if isinstance(value, dict):
        yield {**value, "mutant": 1}
        for key in value:
            yield {k: v for k, v in value.items() if k != key}
            for inner in mutants(value[key]):
                yield {**value, key: inner}
    elif isinstance(value, list):
        yield value[:-1]
        for i, one in enumerate(value):
            for inner in mutants(one):
                yield value[:i] + [inner] + value[i + 1:]
    yield [7] if isinstance(value, (dict, str)) else "seven"


class SceneSchema(unittest.TestCase):
    def test_cases_are_right_and_answer(self):
        self.assertGreater(len(scenes()), 4)
        for path in scenes():
            with open(path, encoding="utf-8") as stream:
                self.assertEqual(SCHEMA.faults(json.load(stream)), [], path)
            done = run(path)
            self.assertIn(done.returncode, (0, 1), done.stderr)

    def test_what_the_schema_refuses_the_program_refuses(self):
        with open(os.path.join(CASES, "workcell.json"), encoding="utf-8") as stream:
            whole = json.load(stream)
        whole["bodies"][1]["parts"][0]["mesh"]["file"] = os.path.join(CASES, "../mesh/cube.obj")
        refused = taken = 0
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "s.json")
            for mutant in mutants(copy.deepcopy(whole)):
                is_wrong = bool(SCHEMA.faults(mutant))
                with open(path, "w", encoding="utf-8") as stream:
                    json.dump(mutant, stream)
                done = run(path)
                if is_wrong:
                    self.assertEqual(done.returncode, 2, mutant)
                    self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                    self.assertIn("s.json: ", done.stderr)
                    refused += 1
                elif done.returncode in (0, 1):
                    taken += 1
        self.assertGreater(refused, 200)
        self.assertGreater(taken, 10)  # poses, names and points that may be left out


if __name__ == "__main__":
    unittest.main()
