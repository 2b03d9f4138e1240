#!/usr/bin/env python3
"""Checks that headers say what a caller must know, and that who reads one can do as it says.

    tests/check_contracts.py [ROOT]

C1  Each function of a front door (a header that sunder/sunder.h includes) has words of its own: a comment above it, or
    above the group of lines that it stands in, or behind it.
C2  A public header that speaks of throwing Error includes <sunder/base/error.h>: with that header alone it is caught.
C3  sunder/sunder.h has every front door: each public header of a folder of QUESTIONS whose name begins
    with an object (OBJECTS) and that declares a function of its own name, and each header of scene/ that begins with
    a question.
C4  SUNDER_REQUIRE asks and does nothing, for most builds leave its words out: no assignment stands in it, and no call
    whose name says that something changes (EFFECTS).

Exit code 0: so it is. 1: not, one line for each finding. 2: no front door was found.
"""
import os
import re
import sys

FRONT = "sunder/sunder.h"
INCLUDE = re.compile(r"^#include <(sunder/[^>]+)>", re.MULTILINE)
NO_FUNCTION = re.compile(r"[#/}\s]|$|(?:namespace|using|struct|class|enum|union|template|extern template|friend)\b")
FUNCTION = re.compile(r"[^(=]*?\w\(|[\w:]+ \w+;")  # also `Method name;`, by the name of its type
QUESTIONS = ("pair", "line", "section", "segments", "discs", "boxes", "polygons", "region", "round")
OBJECTS = r"(?:convex_)?(?:polygons?|segments?|discs?|boxes|intervals|lines?|planes?|flat|half_(?:plane|space)|" \
          r"polyhedron|polytope|round|region|linear_program|kernel)(?:_|$)"
THROWS = re.compile(r"\b[Tt]hrows?\b(?:[^.;]|\n)*?\bError\b")

REQUIRED = re.compile(r"(?<!define )\bSUNDER_REQUIRE\(([^;]*)\);")
EFFECTS = re.compile(r"\+\+|--|[^=!<>]=[^=]|"
                     r"\b(?:set|make|add|push|pop|insert|erase|emplace|take|read|next|step|build|clear)(?:_\w+)?\(")


def words_above(lines, number):
    """The comment of the declaration that begins at this line (from 1): (number of its first line, its text); of the
    nearest one above in its group, which ends at a blank line or where it is indented less; (number, "") where none."""
    indent = len(lines[number - 1]) - len(lines[number - 1].lstrip())
    is_words = lambda k: k >= 0 and re.match(r" {%d}//(?! NOLINT)" % indent, lines[k])
    last = number - 1
    while not is_words(last):
        if last < 0 or not lines[last].strip() or len(lines[last]) - len(lines[last].lstrip()) < indent:
            return number, ""
        last -= 1
    first = last
    while is_words(first - 1):
        first -= 1
    return first + 1, "\n".join(line.strip()[2:].removeprefix(" ") for line in lines[first:last + 1])


def words_behind(lines, first, last):
    """Comments at the ends of these lines (from 1)."""
    found = [re.search(r"\S\s*//\s*(\S.*)", line) for line in lines[first - 1:last]]
    return "\n".join(match.group(1) for match in found if match)


def functions_of(lines):
    """(first line, last line) of each function of a namespace; declarations begin at the margin (clang-format)."""
    for number, line in enumerate(lines, 1):
        if NO_FUNCTION.match(line) or not FUNCTION.match(line):
            continue
        last = number
        while last < len(lines) and lines[last].startswith(" ") and not re.search(r"[;{}]", lines[last - 1]):
            last += 1
        yield number, last


def public_headers(root):
    for here, folders, names in os.walk(os.path.join(root, "sunder")):
        folders[:] = sorted(set(folders) - {"ask", "picture"})  # of the program, not installed
        for name in sorted(names):
            if name.endswith(".h") and not name.endswith(("_internal.h", "_test.h")):
                yield os.path.relpath(os.path.join(here, name), root).replace(os.sep, "/")


def sources(root):
    for here, folders, names in os.walk(os.path.join(root, "sunder")):
        folders.sort()
        for name in sorted(names):
            if name.endswith((".h", ".cpp")):
                yield os.path.relpath(os.path.join(here, name), root).replace(os.sep, "/")


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def front_doors(root):
    return INCLUDE.findall(read(root, FRONT))


def is_front_door(path, text):
    """By its place, its name and what it declares."""
    folder, name = path.split("/")[-2], os.path.basename(path)[:-2]
    if path.startswith("sunder/scene/"):
        return re.match(r"// [^.]*?\?", text.replace("\n// ", " ")) is not None
    code = re.sub(r"//.*", "", text)
    return (folder in QUESTIONS and re.match(OBJECTS, name) is not None
            and re.search(r"^\w[^;={}()]*\b%s(?:_\w+)?\(" % name, code, re.MULTILINE) is not None)


def check(root):
    """(findings as text, number of functions)"""
    findings, functions = [], 0
    for path in front_doors(root):
        lines = read(root, path).split("\n")
        for first, last in functions_of(lines):
            functions += 1
            above = first - 1 if lines[first - 2].startswith("template") else first
            if not words_above(lines, above)[1] and not words_behind(lines, first, last):
                findings.append("%s:%d: C1: no words about: %s" % (path, first, lines[first - 1]))
    doors = set(front_doors(root))
    for path in public_headers(root):
        text = read(root, path)
        if path not in doors and is_front_door(path, text):
            findings.append("%s:1: C3: a front door; include it in %s" % (path, FRONT))
        comments = re.sub(r"^(?!\s*//).*?(//.*)?$", lambda line: line.group(1) or "", text, flags=re.MULTILINE)
        said = THROWS.search(re.sub(r"//", "  ", comments))
        if said and path != "sunder/base/error.h" and "sunder/base/error.h" not in INCLUDE.findall(text):
            findings.append("%s:%d: C2: says that Error is thrown; include <sunder/base/error.h>"
                            % (path, comments.count("\n", 0, said.start()) + 1))
    for path in sources(root):
        text = read(root, path)
        for required in REQUIRED.finditer(text):
            if EFFECTS.search(required.group(1)):
                findings.append("%s:%d: C4: has an effect; take it out of SUNDER_REQUIRE"
                                % (path, text.count("\n", 0, required.start()) + 1))
    return findings, functions


def main(arguments):
    root = arguments[0] if arguments else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    findings, functions = check(os.path.abspath(root))
    for finding in findings:
        print(finding)
    print("%d functions of front doors: %d findings" % (functions, len(findings)))
    return 1 if findings else 0 if functions else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
