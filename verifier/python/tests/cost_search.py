#!/usr/bin/env python3
"""Looks for certificate files of 1 MB that take long to check: cost_search.py SECONDS [SEED].

Files are those of cases/certificates in which a list, or two, is filled up with its own entries until the file is full:
each statement, each claim and each table in turn, with references repeated as often as they fit; those of hostile.py;
and changes of the slowest ones so far. Prints the ten slowest of each checker, with seconds of the processor and peak
memory. SUNDER_PROGRAM is the program whose `verify` is the twin.
"""
import json
import os
import random
import subprocess
import sys
import tempfile
import time

from files import PROGRAM
from hostile import HOSTILE
from test_costs import FAMILIES
from test_limits import CASES, PYTHON

MOST = 10 ** 6  # bytes of a file
MOST_SECONDS = {"python": 30, "c++": 3}
MOST_MEMORY = {"python": 10 ** 9, "c++": 3 * 10 ** 8}
LONG = ["0x1p1023", "0x1p-1074", "0x1p20000", "1/" + "7" * 3000, "0x" + "f" * 3000 + "p0"]


def size_of(value):
    return len(json.dumps(value, separators=(",", ":"), ensure_ascii=False).encode())


def lists_in(value, path=()):
    """The paths of all lists that have entries."""
    if isinstance(value, list) and value:
        yield path
    items = enumerate(value) if isinstance(value, list) else value.items() if isinstance(value, dict) else ()
    for key, item in items:
        yield from lists_in(item, path + (key,))


def at(value, path):
    for key in path:
        value = value[key]
    return value


def filled(entries, count, dice):
    """So many entries more: of a list of indices each once others, else one of them, or all in turn."""
    size = len(entries)
    if sorted(map(str, entries)) == sorted(map(str, range(size))):
        return entries + list(range(size, size + count))
    some = dice.choice([entries, [dice.choice(entries)]])
    return entries + json.loads(json.dumps((some * (count // len(some) + 1))[:count]))  # none of them is another one


def blown_up(top, dice):
    """A list, or two, as long as fits; mostly with all other lists that were as long."""
    paths = list(lists_in(top))
    if not paths:
        return top
    statements = [path for path in paths if path[-1] == "statements"]
    chosen = [dice.choice(paths)]
    if dice.random() < .7:
        chosen.append(dice.choice(statements if statements and dice.random() < .6 else paths))
    together = dice.random() < .7
    for k, path in enumerate(chosen):
        try:
            entries = at(top, path)
        except (KeyError, IndexError, TypeError):
            continue
        if not isinstance(entries, list) or not entries:
            continue
        like = [other for other in map(lambda p: at(top, p), lists_in(top)) if len(other) == len(entries)] if together else [entries]
        room = (MOST - size_of(top)) * dice.choice([.3, .5, .7] if k + 1 < len(chosen) else [1])
        each = sum(size_of(other) + len(other) for other in like) / len(entries)
        count = int(room / each)
        if count <= 0:
            break
        if len(like) > 50:
            like = [entries]
            count = int(room / (size_of(entries) + len(entries)) * len(entries))
        longer = [filled(other, count, dice) for other in like]
        for other, entries in zip(like, longer):
            other[:] = entries
    return top


def changed(top, dice):
    """Some numbers as long ones; or shorter lists, and others filled up."""
    def walk(value):
        if isinstance(value, list):
            return [walk(item) for item in value]
        if isinstance(value, dict):
            return {key: walk(item) for key, item in value.items()}
        if isinstance(value, str) and dice.random() < share and value[:2] in ("0x", "-0"):
            return long
        return value
    share, long = dice.choice([0, .01, .1]), dice.choice(LONG[:2] if dice.random() < .8 else LONG)
    top = walk(top)
    for path in dice.sample(list(lists_in(top)), min(3, len(list(lists_in(top))))):
        try:
            entries = at(top, path)
        except (KeyError, IndexError, TypeError):
            continue
        if isinstance(entries, list) and len(entries) > 4:
            del entries[len(entries) * dice.randint(1, 3) // 4:]
    return blown_up(top, dice) if size_of(top) < MOST else top


def cases():
    result = {}
    for folder in ("accepted", "refused"):
        for name in sorted(os.listdir(os.path.join(CASES, folder))):
            with open(os.path.join(CASES, folder, name), "rb") as stream:
                try:
                    top = json.loads(stream.read())
                except (ValueError, RecursionError):
                    continue
            if isinstance(top, dict) and isinstance(top.get("statements"), list):
                result[folder + "/" + name[:-5]] = top
    return result


LAUNCHER = """
import os, subprocess, sys
process = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
_, status, used = os.wait4(process.pid, 0)
process.returncode = os.waitstatus_to_exitcode(status)
print(process.returncode, used.ru_utime + used.ru_stime, used.ru_maxrss * 1024)
"""


def measured(command, path):
    """The exit code, seconds of the processor, and bytes of memory at most. By a small process: a child begins with the
    peak of its parent."""
    done = subprocess.run([sys.executable, "-S", "-c", LAUNCHER, *command, path], stdout=subprocess.PIPE, check=True)
    code, seconds, memory = done.stdout.split()
    return int(code), float(seconds), int(memory)


def search(seconds, seed):
    dice, end, known, slowest = random.Random(seed), time.monotonic() + seconds, cases(), {}
    twins = {"python": PYTHON, **({"c++": [PROGRAM, "verify"]} if PROGRAM else {})}
    worst = {name: [] for name in twins}
    fixed = list(HOSTILE.items()) + [(what, lambda make=make: make(4000)) for what, (make, _) in FAMILIES.items()]
    looked, differ = 0, 0
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None) as folder:
        while time.monotonic() < end:
            if fixed:
                what, make = fixed.pop()
                made = make()
            elif slowest and dice.random() < .4:
                what = dice.choice(sorted(slowest, key=lambda w: -slowest[w][0])[:20])
                made = changed(json.loads(slowest[what][1]), dice)
                what = what.split(", changed")[0] + ", changed"
            else:
                what = dice.choice(sorted(known))
                made = blown_up(json.loads(json.dumps(known[what])), dice)
                what += ", filled"
            text = made if isinstance(made, str) else json.dumps(made, separators=(",", ":"), ensure_ascii=False)
            if len(text.encode()) > 1.2 * MOST:
                continue
            path = os.path.join(folder, "file.json")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text)
            codes, shares = [], []
            for name, command in twins.items():
                code, took, memory = measured(command, path)
                codes.append(code)
                shares.append(max(took / MOST_SECONDS[name], memory / MOST_MEMORY[name]))
                worst[name].append((took, memory, code, what))
                if took > MOST_SECONDS[name] or memory > MOST_MEMORY[name]:
                    keep(text, what, name)
            looked += 1
            if len(set(codes)) > 1:
                differ += 1
                keep(text, what, "differ")
                print("the checkers differ: %s: %s" % (what, codes), flush=True)
            if not isinstance(made, str) and (what not in slowest or max(shares) > slowest[what][0]):
                slowest[what] = max(shares), text
                for dropped in sorted(slowest, key=lambda w: -slowest[w][0])[40:]:
                    del slowest[dropped]
            if looked % 50 == 0:
                tell(worst, looked, differ)
    tell(worst, looked, differ)


def keep(text, what, why):
    """Of what passes a bound, or about which the checkers differ, the file is kept."""
    folder = os.environ.get("SUNDER_COST_FILES")
    if folder:
        name = "%s_%s_%d.json" % (why, "".join(c if c.isalnum() else "_" for c in what), len(os.listdir(folder)))
        with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
            stream.write(text)


def tell(worst, looked, differ):
    print("%d files; the checkers differ on %d" % (looked, differ))
    for name, those in worst.items():
        for by, title in ((0, "seconds"), (1, "memory")):
            best = {}
            for entry in sorted(those, key=lambda e: -e[by]):
                best.setdefault(entry[3], entry)
            print("%s, by %s:" % (name, title))
            for took, memory, code, what in list(best.values())[:10]:
                print("  %6.2f s %6.0f MB  code %d  %s" % (took, memory / 10 ** 6, code, what))
        those.sort(key=lambda e: -max(e[0] / MOST_SECONDS[name], e[1] / MOST_MEMORY[name]))
        del those[200:]
    sys.stdout.flush()


if __name__ == "__main__":
    search(float(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1)
