#!/usr/bin/env python3
"""check_links.py accepts good links and refuses bad ones."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_links


def check(text):
    with tempfile.TemporaryDirectory() as root:
        os.mkdir(os.path.join(root, "docs"))
        with open(os.path.join(root, "README.md"), "w", encoding="utf-8") as stream:
            stream.write("# Top\n## What is exact, and why?\n")
        with open(os.path.join(root, "docs", "a.md"), "w", encoding="utf-8") as stream:
            stream.write(text)
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


if __name__ == "__main__":
    unittest.main()
