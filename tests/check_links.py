#!/usr/bin/env python3
"""Checks that what the pages link to exists: relative links and pictures of every *.md, and their headings.

    tests/check_links.py [ROOT]

Exit code 0: all there. 1: not, one line for each finding. 2: no link was found.
"""
import os
import re
import sys

SKIPPED = {".git", "build", "cases"}


def without_code(text):
    text = re.sub(r"^(```|~~~).*?^\1", lambda match: re.sub(r"[^\n]", " ", match.group()), text,
                  flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"`[^`\n]*`", lambda match: " " * len(match.group()), text)


def anchors_of(text):
    """As GitHub makes them of headings."""
    headings = re.findall(r"^#{1,6}\s+(.+?)\s*#*$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check(root):
    """(findings as text, number of links)"""
    findings, links = [], 0
    for here, folders, files in os.walk(root):
        folders[:] = sorted(set(folders) - SKIPPED)
        for name in sorted(files):
            if not name.endswith(".md"):
                continue
            page = os.path.join(here, name)
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
