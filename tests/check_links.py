#!/usr/bin/env python3
"""Checks that what the pages link to exists: relative links and pictures of every *.md, and their headings; and that
comments of C++ sources name files that exist, by the end of their path: `drum_search.h`, `search/drum_search.h`.

    tests/check_links.py [ROOT]

Exit code 0: all there. 1: not, one line for each finding. 2: no link was found.
"""
import os
import re
import sys

SKIPPED = {".git", "cases"}
# Names of three letters at least, as `p.h` is code; `x_by_scan.cpp` is any method's.
NAMED = re.compile(r"(?<![\w/.<*-])(?:\w+/)*(?!x_)[a-z]\w{2,}\.(?:h|cpp|md)\b(?!\()")


def without_code(text):
    text = re.sub(r"^(```|~~~).*?^\1", lambda match: re.sub(r"[^\n]", " ", match.group()), text,
                  flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"`[^`\n]*`", lambda match: " " * len(match.group()), text)


def anchors_of(text):
    """As GitHub makes them of headings."""
    headings = re.findall(r"^#{1,6}\s+(.+?)\s*#*$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check(root):
    """(findings as text, number of links and of files named in comments)"""
    findings, links = [], 0
    ends, comments = set(), []
    for here, folders, files in os.walk(root):
        folders[:] = sorted(f for f in set(folders) - SKIPPED if not f.startswith("build"))
        for name in sorted(files):
            page = os.path.join(here, name)
            steps = os.path.relpath(page, root).split(os.sep)
            ends.update("/".join(steps[k:]) for k in range(len(steps)))
            if name.endswith((".h", ".cpp")):
                comments.append(page)
            if not name.endswith(".md"):
                continue
            with open(page, encoding="utf-8") as stream:
                text = stream.read()
            for match in re.finditer(r"\]\(\s*<?([^)\s>]+)>?[^)]*\)|<img[^>]*\ssrc=\"([^\"]+)\"", without_code(text)):
                target = match.group(1) or match.group(2)
                if re.match(r"[a-z][a-z0-9+.-]*:", target):
                    continue
                links += 1
                file, _, anchor = target.partition("#")
                path = os.path.normpath(os.path.join(here, file)) if file else page
                place = "%s:%d" % (os.path.relpath(page, root), text.count("\n", 0, match.start()) + 1)
                if not os.path.exists(path):
                    findings.append("%s: there is no %s" % (place, target))
                elif anchor and path.endswith(".md"):
                    with open(path, encoding="utf-8") as stream:
                        if anchor not in anchors_of(stream.read()):
                            findings.append("%s: there is no heading %s" % (place, target))
    for page in comments:
        with open(page, encoding="utf-8") as stream:
            for number, line in enumerate(stream, 1):
                for named in NAMED.findall(line.partition("// ")[2]):
                    links += 1
                    if named not in ends:
                        findings.append("%s:%d: there is no %s" % (os.path.relpath(page, root), number, named))
    return findings, links


def main(arguments):
    root = arguments[0] if arguments else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    findings, links = check(os.path.abspath(root))
    for finding in findings:
        print(finding)
    print("%d links: %d findings" % (links, len(findings)))
    return 1 if findings else 0 if links else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
