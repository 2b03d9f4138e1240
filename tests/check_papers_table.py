#!/usr/bin/env python3
"""Checks the tables of docs/papers/*.md against the tree. docs/papers/README.md explains the tables.

    tests/check_papers_table.py [ROOT [PROGRAM]]

T1  docs/papers has a page besides its README, and each page a table with the columns of COLUMNS.
T2  Such a table has rows.
T3  Every cell of these columns says something: a name, a file, '-' (not meant to be) or 'not yet'.
T4  A file that is named exists.
T5  A word in backticks that is no file, in the columns file, test and benchmark, occurs in a file named in that cell.
T6  A row with a file has a test.
T7  A command is `sunder ...`. It answers, if PROGRAM is given: exit code 0 or 1, and nothing on standard error.

Exit code 0: all rows hold. 1: not, one line for each finding.
"""
import os
import re
import shlex
import subprocess
import sys

COLUMNS = ["item", "file", "test", "benchmark", "certificate", "command"]
NOTHING = {"-", "not yet"}


def cells_of(line):
    text = line.strip()
    text = text[1:] if text.startswith("|") else text
    text = text[:-1] if text.endswith("|") and not text.endswith("\\|") else text
    return [cell.replace("\\|", "|").strip() for cell in re.split(r"(?<!\\)\|", text)]


def tables_of(text):
    """The tables outside of code blocks: lists of (line number, cells), the header first, without the rule."""
    tables, table, fenced = [], [], False
    for number, line in enumerate(text.split("\n") + [""], 1):
        if re.match(r"\s*(```|~~~)", line):
            fenced = not fenced
        if not fenced and line.lstrip().startswith("|"):
            table.append((number, cells_of(line)))
        elif table:
            tables.append(table)
            table = []
    return [[row for row in table if not all(re.fullmatch(r":?-{3,}:?", cell) for cell in row[1])] for table in tables]


def named_in(cell):
    """(files, other words in backticks) of a cell. A file has a slash; '#...' after it is dropped."""
    files, words = [], []
    for target in re.findall(r"\[[^\]]*\]\(([^)\s]+)\)", cell):
        files.append(("link", target.split("#")[0]))
    for word in re.findall(r"`([^`]+)`", re.sub(r"\]\([^)]*\)", "]", cell)):
        if re.fullmatch(r"[\w.-]+(/[\w.-]+)+/?(#\S*)?", word):
            files.append(("path", word.split("#")[0]))
        else:
            words.append(word)
    bare = re.sub(r"`[^`]*`|\[[^\]]*\]\([^)]*\)", " ", cell)
    files += [("path", word) for word in re.findall(r"(?<![\w/])[\w.-]+(?:/[\w.-]+)+\.\w+", bare)]
    return files, words


def check_row(root, page, columns, cells, program):
    if len(cells) < len(columns):
        yield "T3: %d cells under %d columns" % (len(cells), len(columns))
        return
    for name in COLUMNS:
        cell = cells[columns.index(name)]
        if not cell:
            yield "T3: %s is empty; say '-' or 'not yet'" % name
            continue
        if name == "item" and cell in NOTHING:
            yield "T3: the item has no name"
        files, words = named_in(cell)
        if name in ("file", "test", "benchmark") and cell not in NOTHING and not files:
            yield "T4: %s names no file" % name
        texts = []
        for kind, file in files:
            base = os.path.dirname(page) if kind == "link" else root
            path = os.path.join(base, file)
            if kind == "link" and "://" in file:
                continue
            if os.path.isdir(path) and name == "certificate":
                continue
            if not os.path.isfile(path):
                yield "T4: %s: there is no file %s" % (name, file)
                continue
            with open(path, encoding="utf-8", errors="replace") as stream:
                texts.append(stream.read())
        if name in ("file", "test", "benchmark") and texts:
            for word in words:
                if not any(word in text for text in texts) and not occurs_as_test(word, texts):
                    yield "T5: %s: no file of this cell has %s" % (name, word)
    command = cells[columns.index("command")]
    if command not in NOTHING and not re.fullmatch(r"`sunder [^`]+`", command):
        yield "T7: the command is not one `sunder ...`"
    elif command not in NOTHING and program:
        done = subprocess.run([program, *shlex.split(command.strip("`"))[1:]], cwd=root, capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1) or done.stderr or not done.stdout:
            yield "T7: %s gives %d: %s" % (command, done.returncode, done.stderr.strip()[:200])
    file, test = (cells[columns.index(name)] for name in ("file", "test"))
    if file and file not in NOTHING and test in NOTHING:
        yield "T6: a file without a test"


def occurs_as_test(word, texts):
    """GoogleTest's Suite.Name is TEST(Suite, Name) in the source."""
    suite, dot, name = word.partition(".")
    return bool(dot) and any(re.search(r"\(\s*%s\s*,\s*%s\s*[,)]" % (re.escape(suite), re.escape(name)), text)
                             for text in texts)


def check(root, program=None):
    """(findings as text, number of rows)"""
    folder = os.path.join(root, "docs", "papers")
    names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    pages = [os.path.join(folder, name) for name in names if name.endswith(".md") and name != "README.md"]
    findings, rows = [], 0
    if not pages:
        findings.append("docs/papers: T1: there is no page")
    for page in pages:
        short = os.path.relpath(page, root).replace(os.sep, "/")
        with open(page, encoding="utf-8") as stream:
            tables = tables_of(stream.read())
        found = False
        for table in tables:
            number, header = table[0]
            columns = [cell.lower() for cell in header]
            if not set(COLUMNS) <= set(columns):
                continue
            found = True
            if len(table) == 1:
                findings.append("%s:%d: T2: the table is empty" % (short, number))
            for number, cells in table[1:]:
                rows += 1
                findings += ["%s:%d: %s" % (short, number, text) for text in check_row(root, page, columns, cells, program)]
        if not found:
            findings.append("%s:1: T1: no table with the columns %s" % (short, ", ".join(COLUMNS)))
    return findings, rows


def main(arguments):
    root = arguments[0] if arguments else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    findings, rows = check(os.path.abspath(root), *arguments[1:])
    for finding in findings:
        print(finding)
    print("%d rows: %d findings" % (rows, len(findings)))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
