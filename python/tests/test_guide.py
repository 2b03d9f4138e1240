"""The guide's snippets print what stands below them."""
import doctest
import os
import shutil

from helpers import CASES, SOURCE


def test_guide(monkeypatch, tmp_path):
    with open(os.path.join(SOURCE, "docs", "guide", "python.md"), encoding="utf-8") as page:
        text = "".join("\n" if line.startswith("```") else line for line in page)
    for folder in ("mesh", "outcomes", "panda", "scene"):
        shutil.copytree(os.path.join(CASES, folder), tmp_path / "cases" / folder)
    monkeypatch.chdir(tmp_path)
    test = doctest.DocTestParser().get_doctest(text, {}, "docs/guide/python.md", None, 0)
    failed, tried = doctest.DocTestRunner().run(test)
    assert failed == 0 and tried > 30
