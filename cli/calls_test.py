#!/usr/bin/env python3
"""Runs the calls of the program that cli/calls/*.toml list, and checks what they say of each.

    calls_test.py [--jobs N] [--only PART] [--stop] [--net FILE [--record]] [SUBJECT...]
                                            # subjects, or files *.toml; all if none is named

A file holds tests, a test holds steps, a step is a call with what must be so. Tests run side by side, each in a new
folder with a link `cases` to the cases; the steps of a test share that folder, in their order. Unknown keys, unknown
variables, and tests that check nothing are errors.

    [let]                                   # variables of the file: $cube is replaced by the text, in all texts below;
                                            # $source is the folder of the sources, $$ a dollar
    cube = "cases/mesh/cube.obj"

    [[test]]
    name = "Moved"
    let = {pair = "pair $cube $cube"}       # variables of the test
    for = {method = ["gjk", "scan"]}        # the test once for each value, for each pair of values of two variables;
                                            # or once for each row: for = [{at = 1, code = 0}, {at = 2, code = 1}];
                                            # files: for = {file = {glob = "cases/mesh/*.obj", least = 9, except = []}}
    files = {"a.wkt" = "POINT (1 1)"}       # written first; a name with / at its end is a folder
    bad = [["pair a", "B is required"]]     # calls that fail: code 2, nothing on standard output (with --json, the
                                            # same text), one line on standard error that begins "sunder: " and holds
                                            # the part, no file left behind
    [[test.step]]                           # or step = [{...}, {...}], a line each
    run = "$pair --method $method"          # the arguments as a shell reads them, but run by none
    code = 1                                # of exit; 0 if not given
    out = ["meet", "decided by"]            # parts of standard output; or {...}, see below
    err = {is = ""}                         # of standard error
    report = ['answer = "meet"']            # facts of the report: the call is made with --json too, or only so if there
                                            # is no `out` or `err`; the keys that all reports have are looked for
    accepted = "proof.json"                 # both verifiers accept the file; refused: both refuse it with code 1

Other keys of a step: `shell` in the place of `run`: for bash, where $SUNDER is the program and variables are those of
the environment; `for`, `let`, `files`, `bad` as above; `make = {"a.csv" = "name 1 2"}` files that a function of
calls/made.py writes; `edit = {"a.json" = ["statements[0].number += 1"]}` changes a JSON file first (=, +=, append,
delete); `replace = {"a.txt" = ["old", "new"]}` a text; `file = {"a.svg" = ["parts"]}` what a file holds; `absent =
[files]`; `keep = {x = "a.b"}` a variable from the report for the steps that follow; `as = "first"` a name for what the
call wrote; `check = "name"` a function of calls/checks.py, for what no key can say. A test may have `slow = "why"`
or `unsanitized = "why"`: it is left out with a scale below 0.05, or of an instrumented program.

A text is checked by parts that it has, or by a table: has, has_not, is, starts, ends, lines (their number), matches (a
pattern for each line), same_as (the output of the step "first", or a file), json (facts), json_lines (facts of the list
of its lines).

A fact is `PATH = JSON`; also !=, <, <=, >, >=, has (a part of a text; of another value, of its JSON), starts, ends,
`is number`, absent, present. A path is like pairs[0].a; [*] is every element, and there must be one; [a="cube"] those
elements that have this; .length the number of elements; .values the list of all values before it.
`@NAME:PATH` in the place of the JSON is a value of the report of the step NAME, of a file, or with no NAME of the same
document, to which a number may be added: `@:low + 1e-9`; `@sha256:FILE` is a digest. `each PATH: FACT` is the fact of
every element there.

A net holds what a change of the program's structure must not change: of each test its name and, for each of its calls,
a hash of the exit code, of both outputs and of the files in the folder after it, but for times. With --net the tests
that give other hashes than the file are named, and fail; with --record too, the file is written.
"""
import argparse
import concurrent.futures
import glob
import hashlib
import itertools
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import tomllib
import traceback

sys.dont_write_bytecode = True
ROOT = os.environ.get("SUNDER_SOURCE_DIR") or os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CASES = os.environ.get("SUNDER_CASES_DIR") or os.path.join(ROOT, "cases")
PROGRAM = os.environ.get("SUNDER_PROGRAM") and os.path.abspath(os.environ["SUNDER_PROGRAM"])
FOLDER = os.path.join(ROOT, "cli", "calls")
sys.path.insert(0, FOLDER)
import checks  # noqa: E402
import made  # noqa: E402
from facts import FACT, TYPES, Wrong, found_at, is_so, read_json, read_lines, steps_of, values_at  # noqa: E402

IS_SANITIZED = "asan" in (PROGRAM or "") or "tsan" in (PROGRAM or "")
# A sanitizer's report must not look like an exit code of the program.
ENVIRONMENT = {**os.environ, "SUNDER": PROGRAM or "", "LC_ALL": "C"}
for sanitizer in ("ASAN", "UBSAN", "TSAN", "LSAN"):
    ENVIRONMENT[sanitizer + "_OPTIONS"] = ENVIRONMENT.get(sanitizer + "_OPTIONS", "") + ":exitcode=86"

FILE_KEYS = {"let", "test"}
TEST_KEYS = {"name", "let", "for", "files", "bad", "step", "slow", "unsanitized"}
CALL_KEYS = {"code", "out", "err", "report", "keep", "as"}  # those that need a call
STEP_KEYS = CALL_KEYS | {"run", "shell", "let", "for", "files", "make", "edit", "replace", "bad", "file", "absent",
                         "accepted", "refused", "check"}
TEXT_KEYS = {"has", "has_not", "is", "starts", "ends", "lines", "matches", "same_as", "json", "json_lines"}
TIMES = re.compile(rb' +[0-9.]+ (?:us|ms|s)\b|"seconds": [0-9.e+-]+')  # what no two calls tell alike
REPORT_KEYS = ("sunder", "verb", "answer", "method", "function", "decided_by", "cost", "objects", "notes")


def as_text(value):
    return value if isinstance(value, str) else json.dumps(value)


def inserted(text, variables):
    """The text with its variables; $$ is $."""
    def value(match):
        name = match.group(1) or match.group(2)
        if name is None:
            return "$"
        if name not in variables:
            raise Wrong("there is no variable '%s'" % name)
        return as_text(variables[name])
    return re.sub(r"\$(?:(\w+)|\{(\w+)\}|\$)", value, text)


def filled(value, variables):
    """The same with all texts in it, keys too."""
    if isinstance(value, str):
        whole = re.fullmatch(r"\$(\w+)", value)
        if whole and isinstance(variables.get(whole.group(1)), (list, dict)):
            return variables[whole.group(1)]
        return inserted(value, variables)
    if isinstance(value, list):
        return [filled(v, variables) for v in value]
    if isinstance(value, dict):
        return {inserted(k, variables): filled(v, variables) for k, v in value.items()}
    return value


def with_lets(variables, lets):
    variables = dict(variables)
    for name, value in lets.items():
        variables[name] = filled(value, variables)
    return variables


def files_of(choice):
    """The paths of cases that a pattern chooses."""
    known(choice, {"glob", "except", "least"}, "for")
    found = sorted(set(glob.glob(choice["glob"], root_dir=os.path.dirname(CASES))) - set(choice.get("except", [])))
    if len(found) < choice["least"]:
        raise Wrong("%s: %d files, and %d are expected" % (choice["glob"], len(found), choice["least"]))
    return found


def rows_of(loop, variables):
    """The variables of each turn: of each row, or of each way to choose a value for each name."""
    if isinstance(loop, list):
        rows = loop
    else:
        choices = [files_of(v) if isinstance(v, dict) else filled(v, variables) for v in loop.values()]
        rows = [dict(zip(loop, values)) for values in itertools.product(*choices)]
    if not rows:
        raise Wrong("'for' has no turn")
    return [{**variables, **filled(row, variables)} for row in rows]


def known(table, keys, where):
    if not isinstance(table, dict):
        raise Wrong("%s: a table is expected" % where)
    for key in table:
        if key not in keys:
            raise Wrong("%s: there is no key '%s'; there are %s" % (where, key, ", ".join(sorted(keys))))


class Done:
    def __init__(self, call, code, out, err):
        self.call, self.code, self.out, self.err = call, code, out, err


class Test:
    """One run of one test: its folder, its variables, and what was found so far."""

    def __init__(self, name, variables, folder):
        self.name, self.variables, self.folder = name, variables, folder
        self.calls = self.facts = 0
        self.faults, self.saved = [], {}
        self.hashes = None  # of the calls, where there is a net
        os.symlink(CASES, self.path("cases"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def read(self, name):
        with open(self.path(name), encoding="utf-8", errors="surrogateescape", newline="") as stream:
            return stream.read()

    def write(self, name, text):
        if name.endswith("/"):
            os.makedirs(self.path(name))
            return
        data = text if isinstance(text, bytes) else text.encode("utf-8", "surrogateescape")
        with open(self.path(name), "wb") as stream:
            stream.write(data)

    def expect(self, is_right, words):
        """One fact."""
        self.facts += 1
        if not is_right:
            self.faults.append("%s: %s" % (self.name, words() if callable(words) else words))
        return is_right

    def execute(self, command, words, is_program=True):
        done = subprocess.run(command, cwd=self.folder, capture_output=True, stdin=subprocess.DEVNULL, check=False,
                              env={**ENVIRONMENT, **{k: as_text(v) for k, v in self.variables.items()}})
        found = Done(words, done.returncode, *(s.decode("utf-8", "surrogateescape") for s in (done.stdout, done.stderr)))
        if is_program:
            self.calls += 1
            if self.hashes is not None:
                self.hashes.append(self.hash_of(done))
            if "Sanitizer" in found.err or "runtime error:" in found.err:
                self.faults.append("%s: %s: %s" % (self.name, words, found.err))
        return found

    def hash_of(self, done):
        """Of the exit code, both outputs and all files in the folder; but for times, and where the folders are."""
        digest = hashlib.sha256(b"%d" % done.returncode)

        def add(data):
            for path in (self.folder, CASES, ROOT):
                data = data.replace(os.fsencode(path), b"")
            digest.update(hashlib.sha256(TIMES.sub(b"", data)).digest())
        add(done.stdout)
        add(done.stderr)
        for name in sorted(os.listdir(self.folder)):
            if os.path.isfile(self.path(name)):
                digest.update(os.fsencode(name))
                with open(self.path(name), "rb") as stream:
                    add(stream.read())
        return digest.hexdigest()[:12]

    def run(self, arguments):
        return self.execute([PROGRAM, *shlex.split(arguments)], "sunder " + arguments)

    def shell(self, text):
        return self.execute(["bash", "-c", text], text)

    def verdicts(self, name):
        """The codes of both verifiers."""
        python = self.execute([sys.executable, os.path.join(ROOT, "verifier", "python", "sunder_verify"), "--quiet",
                               name], name, is_program=False)
        return self.run("verify " + shlex.quote(name)).code, python.code

    def expect_verdict(self, name, code):
        codes = self.verdicts(name)
        for verifier, found in zip(("sunder verify", "sunder_verify of Python"), codes):
            self.expect(found == code, "%s of %s ends with code %d, not %d" % (verifier, name, found, code))

    def expect_bad(self, arguments, part):
        before = sorted(os.listdir(self.folder))
        done = self.run(arguments)

        def fault(words):
            return "sunder %s: %s\n%s%s" % (arguments, words, done.out, done.err)
        self.expect(done.code == 2, lambda: fault("code %d, not 2" % done.code))
        if re.search(r"--json(?!-)", arguments):
            try:
                told = read_json(done.out)["error"]["text"]
            except (ValueError, KeyError, TypeError):
                told = None
            self.expect("sunder: %s\n" % told == done.err, lambda: fault("the report's error is another"))
        else:
            self.expect(done.out == "", lambda: fault("something is on standard output"))
        self.expect(done.err.startswith("sunder: "), lambda: fault("the line does not begin with 'sunder: '"))
        self.expect(done.err.count("\n") == 1, lambda: fault("not one line"))
        self.expect(part in done.err, lambda: fault("expected: " + part))
        self.expect(sorted(os.listdir(self.folder)) == before, lambda: fault("the folder has changed"))

    def referred(self, text, own):
        """The value that the right side of a fact is."""
        if not text.startswith("@"):
            return json.loads(text)
        text, sign, more = re.match(r"^(.*?)(?: ([+-]) (\S+))?$", text).groups()
        name, _, path = text[1:].partition(":")
        if name == "sha256":
            with open(self.path(path), "rb") as stream:
                return hashlib.sha256(stream.read()).hexdigest()
        if not name:
            document = own
        elif name in self.saved:
            document = read_json(self.saved[name].out)
        else:
            document = (read_lines if name.endswith(".jsonl") else read_json)(self.read(name))
        values = found_at(document, path)
        if len(values) != 1:
            raise Wrong("%s: %d values are there" % (text, len(values)))
        return values[0] + (-1 if sign == "-" else 1) * float(more) if sign else values[0]

    def expect_fact(self, document, fact, where):
        each = re.match(r"^each (.*?): (.*)$", fact, re.S)
        if each:
            values = values_at(document, steps_of(each.group(1)))
            self.expect(values, "%s: there is none: %s" % (where, fact))
            for value in values:
                self.expect_fact(value, each.group(2), where)
            return
        match = FACT.match(fact)
        if not match:
            raise Wrong("'%s' is no fact" % fact)
        path, how, right = match.group(1) or match.group(4), match.group(2) or match.group(5), match.group(3)
        values = found_at(document, path)
        if how in ("absent", "present"):
            self.expect(bool(values) == (how == "present"), "%s: not so: %s" % (where, fact))
            return
        value = right if how == "is" else self.referred(right, document)
        if how == "is" and value not in TYPES:
            raise Wrong("'%s' is no type; there are %s" % (value, ", ".join(TYPES)))
        if not values:
            self.expect(False, "%s: nothing is at %s" % (where, path))
        for found in values:
            self.expect(is_so(found, how, value),
                        lambda: "%s: not so: %s\n  found %s" % (where, fact, json.dumps(found)[:2000]))

    def expect_facts(self, text, facts, where, read=read_json):
        try:
            document = read(text)
        except ValueError as error:
            self.expect(False, "%s: no JSON: %s\n%s" % (where, error, text[:2000]))
            return
        for fact in facts:
            self.expect_fact(document, fact, where)

    def expect_text(self, text, wanted, where):
        wanted = wanted if isinstance(wanted, dict) else {"has": wanted}
        known(wanted, TEXT_KEYS, where)

        def fault(words):
            return "%s: %s\n%s" % (where, words, text[:2000])

        def list_of(key):
            value = wanted.get(key, [])
            return [value] if isinstance(value, str) else value
        for part in list_of("has"):
            self.expect(part in text, lambda: fault("has no part " + repr(part)))
        for part in list_of("has_not"):
            self.expect(part not in text, lambda: fault("has a part " + repr(part)))
        if "is" in wanted:
            self.expect(text == wanted["is"], lambda: fault("is not " + repr(wanted["is"])))
        if "starts" in wanted:
            self.expect(text.startswith(wanted["starts"]), lambda: fault("does not begin with " + repr(wanted["starts"])))
        if "ends" in wanted:
            self.expect(text.endswith(wanted["ends"]), lambda: fault("does not end with " + repr(wanted["ends"])))
        if "lines" in wanted:
            self.expect(len(text.splitlines()) == int(wanted["lines"]), lambda: fault("not %s lines" % wanted["lines"]))
        for line in text.splitlines() if "matches" in wanted else ():
            self.expect(re.fullmatch(wanted["matches"], line), lambda: fault("another line: " + line))
        for name in list_of("same_as"):
            if name in self.saved:
                expected = self.saved[name].out
            else:
                expected = self.read(name)
            self.expect(text == expected, lambda: fault("is not as %s:\n%s" % (name, expected[:2000])))
        for key, read in (("json", read_json), ("json_lines", read_lines)):
            if key in wanted:
                self.expect_facts(text, list_of(key), where, read)

    def expect_report(self, arguments, code, facts):
        done = self.run(arguments + " --json")
        where = "sunder %s --json" % arguments
        self.expect(done.code == code, lambda: "%s: code %d, not %d\n%s" % (where, done.code, code, done.err))
        try:
            document = read_json(done.out)
            self.expect(True, "")
        except ValueError as error:
            self.expect(False, "%s: no JSON: %s\n%s" % (where, error, done.out[:2000]))
            return done
        for key in REPORT_KEYS:
            self.expect(key in document, lambda: "%s: no key '%s'" % (where, key))
        self.expect(document.get("sunder") == 1, lambda: where + ": sunder is not 1")
        self.expect(document.get("verb") == shlex.split(arguments)[0], lambda: where + ": the verb is another")
        for fact in facts:
            self.expect_fact(document, fact, where)
        return done

    def edit(self, name, changes):
        """Changes a JSON file; each path must be there, but for a key that is set."""
        document = read_json(self.read(name))
        for change in changes:
            match = re.match(r"^(?:(delete) (.*)|(.*?) (=|\+=|append) (.*))$", change, re.S)
            if not match:
                raise Wrong("'%s' is no change" % change)
            how = match.group(1) or match.group(4)
            *before, last = steps_of(match.group(2) or match.group(3))
            places = values_at(document, before)
            if len(places) != 1:
                raise Wrong("%s: there are %d such places" % (change, len(places)))
            place = places[0]
            if how != "=" and not values_at(place, [last]):
                raise Wrong("%s: nothing is there" % change)
            if how == "delete":
                del place[last]
            elif how == "append":
                place[last].append(json.loads(match.group(5)))
            else:
                value = self.referred(match.group(5), document)
                place[last] = place[last] + value if how == "+=" else value
        self.write(name, json.dumps(document))

    def prepare(self, step):
        """What a step does to files before its call."""
        for name, text in step.get("files", {}).items():
            self.write(name, text)
        for name, words in step.get("make", {}).items():
            function, *arguments = words.split()
            self.write(name, getattr(made, function)(*(int(a) if a.isdigit() else a for a in arguments)))
        for name, changes in step.get("edit", {}).items():
            self.edit(name, changes)
        for name, (old, new) in step.get("replace", {}).items():
            text = self.read(name)
            if old not in text:
                raise Wrong("%s has no part %r to replace" % (name, old))
            self.write(name, text.replace(old, new, 1))

    def call(self, step):
        """The call of a step, once or with --json too."""
        code, words = int(step.get("code", 0)), step.get("run", step.get("shell"))
        told = done = None
        if "run" in step and ("report" in step or "keep" in step):
            told = self.expect_report(words, code, step.get("report", []))
        if told is None or "out" in step or "err" in step:
            done = self.run(words) if "run" in step else self.shell(words)
            self.expect(done.code == code,
                        lambda: "%s: code %d, not %d\n%s%s" % (done.call, done.code, code, done.out[:4000], done.err))
        for stream in ("out", "err"):
            if stream in step:
                self.expect_text(getattr(done, stream), step[stream], "%s: standard %s" % (
                    done.call, "output" if stream == "out" else "error"))
        if "as" in step:
            self.saved[step["as"]] = told or done
        for name, path in step.get("keep", {}).items():
            self.variables[name] = self.referred("@:" + path, read_json(told.out))

    def take(self, step):
        """One step, for each turn of its loop."""
        for variables in rows_of(step["for"], self.variables) if "for" in step else [self.variables]:
            own = with_lets(variables, step.get("let", {}))
            now = filled({k: v for k, v in step.items() if k not in ("for", "let", "shell")}, own)
            if "shell" in step:
                now["shell"] = step["shell"]
            outer, self.variables = self.variables, own
            self.prepare(now)
            for arguments, part in now.get("bad", []):
                self.expect_bad(arguments, part)
            if "run" in now or "shell" in now:
                self.call(now)
            for name in listed(now.get("accepted", [])):
                self.expect_verdict(name, 0)
            for name in listed(now.get("refused", [])):
                self.expect_verdict(name, 1)
            for name, wanted in now.get("file", {}).items():
                if self.expect(os.path.exists(self.path(name)), "there is no file " + name):
                    self.expect_text(self.read(name), wanted, name)
            for name in now.get("absent", []):
                self.expect(not os.path.exists(self.path(name)), "there is a file " + name)
            if "check" in now:
                function, *arguments = now["check"].split()
                getattr(checks, function)(self, *arguments)
            kept = {name: self.variables[name] for name in now.get("keep", {})}
            self.variables = {**outer, **kept}


def listed(value):
    return [value] if isinstance(value, str) else value


def check_names(lets, loop, text, where):
    """A variable that nothing uses is a slip."""
    names = set(lets).union(*loop) if isinstance(loop, list) else {*lets, *loop}
    for name in names:
        if not re.search(r"\$\{?%s\b" % name, text):
            raise Wrong("%s: nothing uses the variable '%s'" % (where, name))


def check_step(step, where):
    known(step, STEP_KEYS, where)
    check_names(step.get("let", {}), step.get("for", {}), json.dumps(step), where)
    if "run" in step and "shell" in step:
        raise Wrong(where + ": 'run' excludes 'shell'")
    if not ("run" in step or "shell" in step):
        for key in CALL_KEYS & set(step):
            raise Wrong("%s: '%s' needs 'run'" % (where, key))
    if "shell" in step and ("report" in step or "keep" in step):
        raise Wrong(where + ": a report is of 'run'")


def tests_of(subject):
    """Each test of the file, once for each turn: (name, test, variables)."""
    path = subject if subject.endswith(".toml") else os.path.join(FOLDER, subject + ".toml")
    with open(path, "rb") as stream:
        data = tomllib.load(stream)
    known(data, FILE_KEYS, path)
    lets = with_lets({"source": ROOT}, data.get("let", {}))
    check_names(data.get("let", {}), {}, json.dumps(data), path)
    found, names = [], set()
    for test in data.get("test", []):
        where = "%s: %s" % (os.path.basename(path), test.get("name"))
        known(test, TEST_KEYS, where)
        if not test.get("name") or test["name"] in names:
            raise Wrong(where + ": each test has a name of its own")
        names.add(test["name"])
        steps = test.get("step", [])
        check_names(test.get("let", {}), test.get("for", {}), json.dumps(test), where)
        for k, step in enumerate(steps):
            check_step(step, "%s: step %d" % (where, k))
        for variables in rows_of(test["for"], lets) if "for" in test else [lets]:
            turn = " ".join("%s=%s" % (k, v) for k, v in variables.items() if k not in lets)
            first = {k: test[k] for k in ("files", "bad") if k in test}
            found.append((where + (" (%s)" % turn if turn else ""), test, [first, *steps],
                          with_lets(variables, test.get("let", {}))))
    if not found:
        raise Wrong(path + ": has no test")
    return found


def run_test(name, test, steps, variables, has_net=False):
    if "slow" in test and float(os.environ.get("SUNDER_TEST_SCALE") or 1) < 0.05:
        return None
    if "unsanitized" in test and IS_SANITIZED:
        return None
    with tempfile.TemporaryDirectory(prefix="sunder_calls_") as folder:
        one = Test(name, variables, folder)
        one.hashes = [] if has_net else None
        try:
            for step in steps:
                one.take(step)
        except Exception as error:  # pylint: disable=broad-except
            words = str(error) if isinstance(error, Wrong) else traceback.format_exc()
            one.faults.append("%s: %s" % (name, words))
        if one.facts == 0:
            one.faults.append(name + ": nothing was checked")
        return one


def read_net(path):
    """The hashes of the calls of each test."""
    with open(path, encoding="utf-8") as stream:
        return dict(line.rstrip("\n").split("\t") for line in stream)


def compare_with_net(run, path):
    """A fault for each test whose calls have other outputs than the net says; a test that it does not know is one."""
    known_hashes = read_net(path)
    for one in run:
        before, now = known_hashes.get(one.name, "").split(), one.hashes
        others = [k for k, (a, b) in enumerate(itertools.zip_longest(before, now)) if a != b]
        if others:
            one.faults.append("%s: not as in the net: calls %s of %d" % (one.name, others, len(now)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="how many tests run side by side")
    parser.add_argument("--only", default="", help="tests whose name has this part")
    parser.add_argument("--stop", action="store_true", help="run no more tests after one that fails")
    parser.add_argument("--net", metavar="FILE", help="name the tests whose calls write other things than the file says")
    parser.add_argument("--record", action="store_true", help="with --net: write that file")
    parser.add_argument("subjects", nargs="*")
    options = parser.parse_args()
    if options.record and not options.net:
        parser.error("--record needs --net")
    if not PROGRAM:
        print("skipped: SUNDER_PROGRAM does not name the program")
        return 0
    subjects = options.subjects or sorted(n[:-5] for n in os.listdir(FOLDER) if n.endswith(".toml"))
    tests = [test for subject in subjects for test in tests_of(subject) if options.only in test[0]]
    with concurrent.futures.ThreadPoolExecutor(max(1, min(options.jobs, os.cpu_count()))) as pool:
        runs = [pool.submit(run_test, *test, has_net=bool(options.net)) for test in tests]
        done = []
        for one in runs:
            done.append(one.result())
            if options.stop and done[-1] and done[-1].faults:
                pool.shutdown(cancel_futures=True)
                break
    run = [one for one in done if one]
    if options.record:
        with open(options.net, "w", encoding="utf-8") as stream:
            stream.writelines("%s\t%s\n" % (one.name, " ".join(one.hashes)) for one in run)
    elif options.net:
        compare_with_net(run, options.net)
    faults = [fault for one in run for fault in one.faults]
    for fault in faults:
        print(fault.encode("utf-8", "surrogateescape").decode("utf-8", "replace"))
    calls, facts = sum(one.calls for one in run), sum(one.facts for one in run)
    print("%d tests, %d calls, %d facts, %d not so" % (len(run), calls, facts, len(faults)) +
          (", %d tests left out" % (len(done) - len(run)) if len(done) > len(run) else ""))
    if calls == 0:
        print("no call was made")
    return 1 if faults or calls == 0 else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Wrong, tomllib.TOMLDecodeError) as error:
        sys.exit(str(error))
