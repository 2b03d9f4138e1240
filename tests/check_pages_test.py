#!/usr/bin/env python3
"""check_pages.py accepts what is printed and finds what is not."""
import os
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_pages


def check(text):
    """For `sunder`, this stands for the program: `sh`."""
    with tempfile.TemporaryDirectory() as root:
        with open(os.path.join(root, "README.md"), "w", encoding="utf-8") as stream:
            stream.write(text)
        return check_pages.check_page(root, shutil.which("sh"), "README.md")


class CheckPages(unittest.TestCase):
    def test_accepts(self):
        for text in ("```\n$ echo a; echo b >&2\nb\na\n```\n", "    $ sunder -c 'echo a'\n    a\n\nText\n",
                     "```\n$ echo a \\\n  b\na b\n$ true\n```\n", "    $ seq 9\n    1\n    ...\n    9\n",
                     "    $ echo one '  0.21 ms'\n    one 17.3 ms\n", "```\n$ printf 'a\\n\\nb\\n'\na\n\nb\n\n```\n",
                     "```\n$ echo x > file\n```\ntext\n```\n$ cat file\nx\n```\n"):
            with self.subTest(text):
                findings, commands, corrected = check(text)
                self.assertEqual(findings, [])
                self.assertEqual(commands, text.count("$ "))
                self.assertEqual(corrected, text)

    def test_finds(self):
        for text in ("```\n$ echo a\nb\n```\n", "```\n$ echo a\n```\n", "```\n$ true\na\n```\n",
                     "    $ echo 1 ms\n    2 us 3\n", "    $ seq 9\n    1\n    ...\n    8\n",
                     "    $ echo a\n    a\n\n    b\n", "    $ echo a \\\n        b\n    c\n", "```\n$ echo a >&2; echo b\nb\na\n```\n"):
            with self.subTest(text):
                findings, _, corrected = check(text)
                self.assertEqual(len(findings), 1)
                self.assertTrue(findings[0].startswith("README.md:"), findings)
                self.assertEqual(check(corrected)[0], [])

    def test_other_blocks_hold_no_command(self):
        self.assertEqual(check("```json\n{}\n```\n    a $ b\n\nIn text $ c\n")[:2], ([], 0))

    def test_what_is_not_there_is_refused(self):
        page = "## What is not there\n- A thing: `sunder -c 'exit %d'`.\n%s\n## More\n- `sunder -c 'exit 0'`\n"
        self.assertEqual(check(page % (2, "Text"))[:2], ([], 1))
        for text in (page % (0, ""), page % (1, ""), page % (2, "- A thing.")):
            findings, _, corrected = check(text)
            self.assertEqual((len(findings), corrected), (1, text))


if __name__ == "__main__":
    unittest.main()
