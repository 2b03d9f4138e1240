#!/usr/bin/env python3
"""Asks `sunder scene` about every robot (URDF) of a folder, and says which answer and why others do not.

    scripts/robot_files.py FOLDER [--program build/bin/sunder] [--leave-out] [--timeout SECONDS] [--table]

FOLDER: such as PyPI's package example-robot-data, unpacked:

    pip download --no-deps example-robot-data && unzip -d robots example_robot_data-*.whl

A robot answers where the program ends with code 0 or 1, after a question about all its shapes (with --leave-out: about
those that are read). --table prints a line for each file, also those that answer.
Exit code 0: every file answers or is refused with a message of one line; 1: the program crashed, ran out of time, or
printed anything else; 2: there is no robot.
"""
import argparse
import collections
import json
import os
import re
import subprocess
import sys
import time


def robots(folder):
    found = []
    for path, _, names in os.walk(folder):
        found += [os.path.join(path, name) for name in names if name.endswith(".urdf")]
    return sorted(found)


def ask(program, robot, leave_out, timeout):
    """(outcome, reason or report, seconds): outcome is "answers", "refused" or "fails"."""
    call = [program, "scene", robot, "--allow", "adjacent", "--json"] + (["--leave-out"] if leave_out else [])
    start = time.monotonic()
    try:
        ran = subprocess.run(call, capture_output=True, text=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        return "fails", "no answer in %g s" % timeout, timeout
    seconds = time.monotonic() - start
    if ran.returncode in (0, 1):
        return "answers", json.loads(ran.stdout), seconds
    errors = [line for line in ran.stderr.splitlines() if not line.startswith("sunder: note: ")]
    if ran.returncode == 2 and len(errors) == 1:
        return "refused", errors[0], seconds
    return "fails", "code %d: %s" % (ran.returncode, " | ".join(errors)[:200]), seconds


def kind_of(reason):
    """The reason without names and numbers, to count alike ones together."""
    text = re.sub(r"^sunder: (?:.*?(?:\.\w+|//[^:]*)(?::\d+)?: )?", "", reason)
    text = re.sub(r"'[^']*'", "'...'", text)
    text = re.sub(r" of .*?([;,]|$)", r" of ...\1", text)
    return re.sub(r"\d+", "N", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder")
    parser.add_argument("--program", default="build/bin/sunder")
    parser.add_argument("--leave-out", action="store_true")
    parser.add_argument("--timeout", type=float, default=300)
    parser.add_argument("--table", action="store_true")
    call = parser.parse_args()
    files = robots(call.folder)
    if not files:
        print("there is no .urdf in %s" % call.folder, file=sys.stderr)
        return 2

    count = collections.Counter()
    reasons = collections.Counter()
    formats = collections.Counter()
    left_out = collections.Counter()
    for file in files:
        outcome, said, seconds = ask(call.program, file, call.leave_out, call.timeout)
        count[outcome] += 1
        name = os.path.relpath(file, call.folder)
        if outcome == "answers":
            formats.update(each["format"] for each in said["objects"])
            for item in said.get("left_out", []):
                left_out[item["kind"]] += item["count"]
            line = "%s: %d bodies, %d parts, %d pairs meet" % (
                said["answer"], len(said["bodies"]), len(said["objects"]), said["count"])
        else:
            reasons[kind_of(said)] += 1
            line = said
        if call.table or outcome != "answers":
            print("%-8s %6.2f s  %s: %s" % (outcome, seconds, name, line), flush=True)

    total = len(files)
    print("%d of %d answer (%.1f %%), %d are refused, %d fail" %
          (count["answers"], total, 100 * count["answers"] / total, count["refused"], count["fails"]))
    print("shapes read: " + ", ".join("%d %s" % (n, kind) for kind, n in formats.most_common()))
    if left_out:
        print("left out: " + ", ".join("%d %s" % (n, kind) for kind, n in left_out.most_common()))
    for reason, n in reasons.most_common():
        print("%4d  %s" % (n, reason))
    return 1 if count["fails"] else 0


if __name__ == "__main__":
    sys.exit(main())
