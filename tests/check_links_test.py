#!/usr/bin/env python3
"""check_links.py accepts good links and refuses bad ones."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_links


def check(text, source=""):
    with tempfile.TemporaryDirectory() as root:
        os.mkdir(os.path.join(root, "docs"))
        with open(os.path.join(root, "README.md"), "w", encoding="utf-8") as stream:
            stream.write("# Top\n## What is exact, and why?\n")
        with open(os.path.join(root, "docs", "a.md"), "w", encoding="utf-8") as stream:
            stream.write(text)
        with open(os.path.join(root, "docs", "walk.h"), "w", encoding="utf-8") as stream:
            stream.write(source)
        return check_links.check(root)


class CheckLinks(unittest.TestCase):
    def test_accepts(self):
        text = ("# A b\n[x](../README.md) [y](#a-b) ![z](../README.md#what-is-exact-and-why) [w](https://a.b/c)\n"
                "`[not](a-link)`\n```\n[nor](this)\n```\n<img width=\"3\" src=\"../README.md\">\n")
        self.assertEqual(check(text), ([], 4))

    def test_refuses(self):
        for link in ("[x](../OTHER.md)", "![x](picture.svg)", "[x](#top)", "[x](../README.md#bottom)",
                     "<img src=\"picture.svg\">"):
            with self.subTest(link):
                findings, _ = check("# A\n\n" + link + "\n")
                self.assertEqual(len(findings), 1)
                self.assertTrue(findings[0].startswith("docs/a.md:3: there is no "), findings)

    def test_files_named_in_comments(self):
        self.assertEqual(check("", "// As walk.h, docs/a.md and docs/walk.h have it: p.h is code.\n"), ([], 2))
        for named in ("run.h", "other/walk.h", "docs/walk.cpp"):
            with self.subTest(named):
                self.assertEqual(check("", "int x;\nint y;  // see %s.\n" % named)[0],
                                 ["docs/walk.h:2: there is no " + named])


if __name__ == "__main__":
    unittest.main()
