#!/usr/bin/env python3
"""Checks the tables of docs/papers/*.md against the tree. docs/papers/README.md explains the tables.

    tests/check_papers_table.py [ROOT [PROGRAM]]

T1  docs/papers has a page besides its README, and each page a table with the columns of COLUMNS.
T2  Such a table has rows.
T3  Every cell of these columns says something: a name, a file, or '-: ' (not meant to be) and why, in a sentence.
T4  A file that is named exists.
T5  A word in backticks that is no file, in the columns file, test and benchmark, occurs in a file named in that cell.
T6  A row with a file has a test.
T7  A command, in any table with that column, is `sunder ...`. It answers, if PROGRAM is given: exit code 0 or 1, and
    nothing on standard error.
T8  'not yet' stands nowhere, in any table, but in the rows of WAITING; and each of these has one.
T9  'wished', in any table, is 'wished: ' and why, in a sentence.
T10 The function that the command's report names, if PROGRAM is given, is a word in backticks of the row: of its column
    file, where there is one.

Exit code 0: all rows hold. 1: not, one line for each finding.
"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile

COLUMNS = ["item", "file", "test", "benchmark", "certificate", "command"]
NOT_YET = "not yet"
WAITING = {}  # page: items that are being built; each leaves this list with its last 'not yet'


def is_nothing(cell):
    return cell == NOT_YET or re.match(r"-(?!\w)", cell) is not None


def has_reason(cell, word):
    """Is it the word, a colon, and a sentence, four words or more?"""
    reason = re.fullmatch(r"%s: (\S.*)" % re.escape(word), cell)
    return reason is not None and len(reason.group(1).split()) >= 4


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


def check_row(root, page, columns, cells):
    if len(cells) < len(columns):
        yield "T3: %d cells under %d columns" % (len(cells), len(columns))
        return
    for name in COLUMNS:
        cell = cells[columns.index(name)]
        if not cell:
            yield "T3: %s is empty; say '-: ' and why" % name
            continue
        if name == "item" and is_nothing(cell):
            yield "T3: the item has no name"
        elif is_nothing(cell):
            if cell != NOT_YET and not has_reason(cell, "-"):
                yield "T3: %s is '-' without a reason; say '-: ' and why, in a sentence" % name
            continue
        files, words = named_in(cell)
        if name in ("file", "test", "benchmark") and not files:
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
    file, test = (cells[columns.index(name)] for name in ("file", "test"))
    if file and not is_nothing(file) and is_nothing(test):
        yield "T6: a file without a test"


def check_command(root, columns, cells, program):
    if len(cells) < len(columns):
        return
    command = cells[columns.index("command")]
    if is_nothing(command) or not command:
        return
    if not re.fullmatch(r"`sunder [^`]+`", command):
        yield "T7: the command is not one `sunder ...`"
        return
    if not program:
        return

    def run(*more):
        with tempfile.TemporaryDirectory() as folder:  # where the command may write
            os.symlink(os.path.abspath(os.path.join(root, "cases")), os.path.join(folder, "cases"))
            return subprocess.run([os.path.abspath(program), *shlex.split(command.strip("`"))[1:], *more], cwd=folder,
                                  capture_output=True, text=True, check=False)
    done = run()
    if done.returncode not in (0, 1) or done.stderr or not done.stdout:
        yield "T7: %s gives %d: %s" % (command, done.returncode, done.stderr.strip()[:200])
        return
    function = json.loads(run("--json").stdout).get("function") or ""
    where = cells[columns.index("file")] if "file" in columns else " ".join(cells)
    if function.split("::")[-1] not in named_in(where)[1]:
        yield "T10: %s calls %s, which the row does not name" % (command, function or "no function that it names")


def check_words(page, cells, waiting):
    is_waiting = any(cells[0].startswith(item) for item in waiting.get(os.path.basename(page), []))
    for cell in cells:
        if re.search(r"\b%s\b" % NOT_YET, cell) and not is_waiting:
            yield "T8: '%s'; build it, or say '-: ' and why" % NOT_YET
        if re.search(r"\bwished\b", cell) and not has_reason(cell, "wished"):
            yield "T9: 'wished' without a reason; say 'wished: ' and why, in a sentence"


def check_waiting(folder, tables_of_page, waiting):
    for page, items in waiting.items():
        for item in items:
            rows = [cells for table in tables_of_page.get(page, []) for _, cells in table[1:]]
            if not any(cells[0].startswith(item) and NOT_YET in cells for cells in rows):
                yield "%s/%s: T8: %s waits no longer; take it out of WAITING" % (folder, page, item)


def occurs_as_test(word, texts):
    """GoogleTest's Suite.Name is TEST(Suite, Name) in the source."""
    suite, dot, name = word.partition(".")
    return bool(dot) and any(re.search(r"\(\s*%s\s*,\s*%s\s*[,)]" % (re.escape(suite), re.escape(name)), text)
                             for text in texts)


def check(root, program=None, waiting=None):
    """(findings as text, number of rows)"""
    waiting = WAITING if waiting is None else waiting
    folder = os.path.join(root, "docs", "papers")
    names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    pages = [os.path.join(folder, name) for name in names if name.endswith(".md") and name != "README.md"]
    findings, rows, all_tables = [], 0, {}
    if not pages:
        findings.append("docs/papers: T1: there is no page")
    for page in pages:
        short = os.path.relpath(page, root).replace(os.sep, "/")
        with open(page, encoding="utf-8") as stream:
            tables = tables_of(stream.read())
        all_tables[os.path.basename(page)] = tables
        found = False
        for table in tables:
            number, header = table[0]
            columns = [cell.lower() for cell in header]
            for number, cells in table[1:]:
                texts = list(check_words(page, cells, waiting))
                if "command" in columns:
                    texts += check_command(root, columns, cells, program)
                findings += ["%s:%d: %s" % (short, number, text) for text in texts]
            number = table[0][0]
            if not set(COLUMNS) <= set(columns):
                continue
            found = True
            if len(table) == 1:
                findings.append("%s:%d: T2: the table is empty" % (short, number))
            for number, cells in table[1:]:
                rows += 1
                findings += ["%s:%d: %s" % (short, number, text) for text in check_row(root, page, columns, cells)]
        if not found:
            findings.append("%s:1: T1: no table with the columns %s" % (short, ", ".join(COLUMNS)))
    findings += check_waiting("docs/papers", all_tables, waiting)
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
