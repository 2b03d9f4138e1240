"""What is installed: one version, the checker, types; and how long the package is."""
import glob
import importlib.metadata
import os
import re
import subprocess
import sys

import sunder

from helpers import CASES, PROGRAM, SOURCE

MOST_LINES = 2750


def test_one_version():
    with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
        of_cmake = re.search(r"project\(sunder VERSION ([\d.]+)", file.read()).group(1)
    shipped = os.path.join(os.path.dirname(sunder.__file__), "bin", "sunder")
    said = [subprocess.run([p, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
            for p in (PROGRAM, shipped)]
    assert {sunder.__version__, importlib.metadata.version("sunder"), *said} == {of_cmake}


def test_the_checker_is_inside():
    folder = os.path.join(CASES, "certificates")
    for name, code in (("accepted/apart_tetrahedra.json", 0), ("refused/*.json", 1)):
        file = sorted(glob.glob(os.path.join(folder, name)))[0]
        call = [sys.executable, "-m", "sunder_verify", file]
        assert subprocess.run(call, capture_output=True, check=False).returncode == code


def test_types():
    folder = os.path.dirname(sunder.__file__)
    assert os.path.exists(os.path.join(folder, "py.typed"))
    stubs = {name: open(os.path.join(folder, "_sunder", name + ".pyi"), encoding="utf-8").read()
             for name in ("__init__", "planar", "polytope", "solid")}
    assert "def intersect(" in stubs["__init__"] and "class Segments" in stubs["planar"]
    for name in ("convex_hull", "half_space_region", "linear_program", "region_vertices"):
        assert "def %s(" % name in stubs["polytope"]
    for text in stubs.values():
        compile(text, "stub", "exec")


def test_nothing_else_is_installed():
    files = {str(file).split("/")[0] for file in importlib.metadata.files("sunder")}
    assert {name for name in files if not name.endswith(".dist-info")} == {"sunder", "sunder_verify"}


def test_everything_has_words():
    for chapter in (sunder, sunder.planar, sunder.solid, sunder.polytope):
        for name, value in vars(chapter).items():
            if not name.startswith("_") and callable(value):
                assert value.__doc__, (chapter.__name__, name)


def test_it_is_thin():
    sources = [p for pattern in ("*.cpp", "*.h", "CMakeLists.txt", "sunder/*.py")
               for p in glob.glob(os.path.join(SOURCE, "python", pattern))]
    lines = sum(-(-max(1, len(line.rstrip("\n"))) // 120) for p in sources for line in open(p, encoding="utf-8"))
    assert 300 < lines < MOST_LINES, lines
