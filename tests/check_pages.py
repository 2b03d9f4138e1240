#!/usr/bin/env python3
"""Runs the commands of the pages and compares what they print.

    tests/check_pages.py [--write] ROOT PROGRAM [PAGE...]         PROGRAM: the built `sunder`

A command is a line "$ COMMAND" of a fenced or an indented block (a backslash at the end goes on with the next line); what
follows, up to the next command or the end of the block, is what it must print, standard error first and then standard
output, and nothing else. A line "..." stands for any lines. Times are not compared: a number and its unit (ns, us, ms, s,
with the spaces before it). Pages: README.md and docs/**/*.md. The commands of a page are run in turn, in a folder where
everything of ROOT is but build/, and PROGRAM is `sunder`. --write puts what is printed in the place of what does not agree.

What a page denies cannot go stale: under a heading that begins "What is not there", each item of a list has a call of
`sunder` in backticks, which is refused: exit code 2.

Exit code 0: all is as printed. 1: not, one finding after the other. 2: no command was found.
"""
import difflib
import os
import re
import subprocess
import sys
import tempfile

TIME = re.compile(r" *\b\d+(\.\d+)? ?(ns|us|ms|s|microseconds|milliseconds|seconds)\b")


def pages_of(root):
    found = ["README.md"]
    for here, _, files in os.walk(os.path.join(root, "docs")):
        found += [os.path.relpath(os.path.join(here, name), root) for name in files if name.endswith(".md")]
    return sorted(found)


def blocks_of(text):
    """(line number, lines) of each fenced or indented block, without fence and indentation."""
    lines, blocks, k = text.split("\n"), [], 0
    while k < len(lines):
        fence = re.match(r"(```|~~~)", lines[k])
        begin = k = k + 1 if fence else k
        if fence:
            while k < len(lines) and not lines[k].startswith(fence.group()):
                k += 1
            blocks.append((begin + 1, lines[begin:k]))
        elif lines[k].startswith("    "):
            while k < len(lines) and (lines[k].startswith("    ") or not lines[k].strip()):
                k += 1
            blocks.append((begin + 1, [line[4:] for line in lines[begin:k]]))
            continue
        k += 1
    return blocks


def commands_of(text):
    """(line number, command, lines expected) of a page."""
    commands = []
    for number, lines in blocks_of(text):
        goes_on = None
        for k, line in enumerate(lines):
            if goes_on is not None:
                goes_on += "\n" + line
            elif line.startswith("$ "):
                goes_on = line[2:]
                commands.append([number + k, None, []])
            elif commands and commands[-1][0] >= number:
                commands[-1][2].append(line)
            if goes_on is not None and not goes_on.endswith("\\"):
                commands[-1][1], goes_on = goes_on, None
    for command in commands:
        while command[2] and not command[2][-1].strip():
            command[2].pop()
    return [tuple(command) for command in commands]


def denials_of(text):
    """(line number, call or None) of each item under the heading "What is not there"."""
    denials, inside = [], False
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("#"):
            inside = line.lstrip("# ").startswith("What is not there")
        elif inside and line.startswith("- "):
            call = re.search(r"`(sunder [^`]+)`", line)
            denials.append((number, call and call.group(1)))
    return denials


def masked(line):
    return TIME.sub(" <time>", line).rstrip()


def agree(expected, printed):
    """Are the lines those expected, where "..." stands for any lines?"""
    if not expected:
        return not printed
    if expected[0].strip() == "...":
        return any(agree(expected[1:], printed[k:]) for k in range(len(printed) + 1))
    return bool(printed) and masked(expected[0]) == masked(printed[0]) and agree(expected[1:], printed[1:])


def run(command, folder, environment):
    """(exit code, the lines printed)"""
    done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=120, check=False)
    text = done.stderr + done.stdout
    return done.returncode, text.rstrip("\n").split("\n") if text else []


def check_page(root, program, page):
    """(findings as text, number of commands, the page as it should be)"""
    with open(os.path.join(root, page), encoding="utf-8") as stream:
        text = stream.read()
    commands, lines = commands_of(text), text.split("\n")
    findings, corrections = [], []
    with tempfile.TemporaryDirectory() as folder:
        for name in os.listdir(root):
            if name not in ("build", ".git"):
                os.symlink(os.path.join(root, name), os.path.join(folder, name))
        os.makedirs(os.path.join(folder, "build", "bin"))
        os.symlink(program, os.path.join(folder, "build", "bin", "sunder"))
        environment = dict(os.environ, LC_ALL="C.UTF-8",
                           PATH=os.path.join(folder, "build", "bin") + os.pathsep + os.environ["PATH"])
        for number, command, expected in commands:
            _, printed = run(command, folder, environment)
            if not agree(expected, printed):
                difference = difflib.unified_diff([masked(line) for line in expected],
                                                  [masked(line) for line in printed], "page", "printed", lineterm="")
                findings.append("%s:%d: $ %s\n%s" % (page, number, command, "\n".join(difference)))
                indentation = lines[number - 1][:lines[number - 1].index("$")]
                corrections.append((number + command.count("\n"), len(expected),
                                    [indentation + line if line else "" for line in printed]))
        denials = denials_of(text)
        for number, call in denials:
            if call is None:
                findings.append("%s:%d: an item without a call of sunder" % (page, number))
            elif run(call, folder, environment)[0] != 2:
                findings.append("%s:%d: is not refused: %s" % (page, number, call))
    for begin, count, printed in reversed(corrections):
        lines[begin:begin + count] = printed
    return findings, len(commands) + len(denials), "\n".join(lines)


def main(arguments):
    write = "--write" in arguments
    arguments = [argument for argument in arguments if argument != "--write"]
    root, program = (os.path.abspath(name) for name in arguments[:2])
    count = wrong = 0
    for page in arguments[2:] or pages_of(root):
        findings, commands, corrected = check_page(root, program, page)
        if write and findings:
            with open(os.path.join(root, page), "w", encoding="utf-8") as stream:
                stream.write(corrected)
        count, wrong = count + commands, wrong + len(findings)
        for finding in findings:
            print(finding)
    print("%d commands: %d findings" % (count, wrong))
    return 1 if wrong else 0 if count else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
