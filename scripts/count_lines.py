#!/usr/bin/env python3
"""How long are the parts of the project, tests aside?

    scripts/count_lines.py

A line of more than 120 characters counts as several. Code: without blank lines, comments, and texts that document.
"""
import io
import os
import subprocess
import tokenize

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LONGEST = 120
CHECKER = "verifier/python/sunder_verify/"
RULES = tuple(CHECKER + name + ".py" for name in (
    "arcs", "boundaries", "depths", "hulls", "linear", "polygons", "polytopes", "rules", "sections", "vertices"))
PROGRAM = ("cli/", "sunder/ask/", "sunder/picture/")
PARTS = {
    "the library": lambda name: name.startswith("sunder/") and not name.startswith(PROGRAM),
    "the program (cli, ask, picture)": lambda name: name.startswith(PROGRAM),
    "the Python package": lambda name: name.startswith("python/"),
    "the checker in C++": lambda name: name.startswith("verifier/cpp/"),
    "the checker in Python": lambda name: name.startswith(CHECKER),
    "of it, rules": lambda name: name in RULES,
}


def is_test(name):
    return "_test." in name or "/tests/" in name or os.path.basename(name).startswith("test_")


def code_of_python(text):
    """Numbers of the lines that hold more than comments and strings that stand alone."""
    lines, begins = set(), True
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in (tokenize.NEWLINE, tokenize.NL, tokenize.INDENT, tokenize.DEDENT, tokenize.COMMENT):
            begins = begins or token.type == tokenize.NEWLINE
            continue
        if token.type == tokenize.STRING and begins or token.type == tokenize.ENDMARKER:
            continue
        begins = False
        lines.update(range(token.start[0], token.end[0] + 1))
    return lines


def code_of_cpp(text):
    return {k for k, line in enumerate(text.split("\n"), 1) if line.strip() and not line.strip().startswith("//")}


def length_of(lines):
    return sum(max(1, -(-len(line) // LONGEST)) for line in lines)


def main():
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    names = [name for name in names if name.endswith((".h", ".cpp", ".py")) and not is_test(name)]
    print("%-34s%8s%8s%8s" % ("", "files", "lines", "code"))
    for part, holds in PARTS.items():
        files = total = code = 0
        for name in filter(holds, names):
            with open(os.path.join(ROOT, name), encoding="utf-8") as file:
                text = file.read()
            lines = text.rstrip("\n").split("\n")
            kept = code_of_python(text) if name.endswith(".py") else code_of_cpp(text)
            files, total = files + 1, total + length_of(lines)
            code += length_of(lines[k - 1] for k in kept if k <= len(lines))
        print("%-34s%8d%8d%8d" % (part, files, total, code))


if __name__ == "__main__":
    main()
