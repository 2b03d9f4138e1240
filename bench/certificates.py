#!/usr/bin/env python3
"""bench_certificates: what does a proof cost? Asking whether segments meet, writing the proof that none do, checking it.

    bench_certificates [--check] [--quick] [--size N] [--json FILE] [--commit ID]

The program as a whole, from file to file: `sunder segments --method sweep`, the same with `--certificate`, and
`sunder verify`, in processor time (user and system, one thread). All three take turns in each of some rounds; a time is the
median over rounds. The segments are short, each in a cell of a grid of its own, in no order. Only ratios mean anything.

--check: exit code 1 where checking takes more than 5 times the question. What writing may take in sorts is a demand of
bench_segments, which has the sort.
"""
import argparse
import json
import os
import random
import resource
import statistics
import subprocess
import sys
import tempfile

PROGRAM = os.path.join(os.path.dirname(os.path.realpath(__file__)), "sunder")
MOST = 5


def write_segments(path, n):
    draw, side = random.Random(7), int(n ** 0.5) + 1
    cells = list(range(n))
    draw.shuffle(cells)
    with open(path, "w", encoding="utf-8") as stream:
        for cell in cells:
            x, y = cell % side, cell // side
            stream.write(",".join(repr(c + 0.05 + 0.9 * draw.random()) for c in (x, y, x, y)) + "\n")


def seconds_of(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(n, rounds):
    """Seconds for each row, and the megabytes of the certificate."""
    with tempfile.TemporaryDirectory() as folder:
        data, proof = os.path.join(folder, "segments.csv"), os.path.join(folder, "proof.json")
        write_segments(data, n)
        ask = [PROGRAM, "segments", data, "--method", "sweep"]
        rows = {"question": ask, "write": ask + ["--certificate", proof], "check": [PROGRAM, "verify", proof]}
        times = {name: [] for name in rows}
        for _ in range(rounds):
            for name, command in rows.items():
                times[name].append(seconds_of(command))
        return {name: statistics.median(all_of) for name, all_of in times.items()}, os.path.getsize(proof) / 1e6


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--quick", action="store_true", help="a tenth of the segments, one round")
    parser.add_argument("--size", type=int, default=1000000, help="segments")
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--commit", default="unknown", metavar="ID")
    options = parser.parse_args()
    n = options.size // 10 if options.quick else options.size
    seconds, megabytes = measure(n, 1 if options.quick else 5)
    ratios = {name: seconds[name] / seconds["question"] for name in seconds}
    print("bench_certificates: %d segments of which no two meet; the certificate has %.0f MB" % (n, megabytes))
    for name in seconds:
        print("  %-10s %8.3f s   %5.2f times the question" % (name, seconds[name], ratios[name]))
    if options.json:
        with open(options.json, "w", encoding="utf-8") as stream:
            json.dump({"commit": options.commit, "segments": n, "megabytes": megabytes, "seconds": seconds,
                       "ratios": ratios}, stream, indent=1)
    if options.check and ratios["check"] > MOST:
        print("  NOT KEPT: checking takes at most %d times the question" % MOST)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
