#!/usr/bin/env python3
"""Installs the package into an environment of its own, as `pip install .` does, and runs its tests there.

    python/tests/run.py SOURCE BUILD COMPILER WARNINGS_AS_ERRORS [OPTION OF PYTEST...]

The environment is BUILD/python, and is kept. What is compiled is in BUILD-python: as deep as BUILD, whose relative names
the compiler cache knows. Where the package cannot be built, this says what is missing, and fails.
"""
import os
import shutil
import subprocess
import sys
import sysconfig


def read_header():
    with open(os.path.join(sysconfig.get_path("include"), "Python.h"), "rb"):
        pass


NEEDED = {  # what it takes: (how it is used, Debian's package)
    "the modules venv and ensurepip": (lambda: [__import__("venv"), __import__("ensurepip")], "python3-venv"),
    "the header Python.h": (read_header, "python3-dev"),
    "the module tomllib of Python 3.11": (lambda: __import__("tomllib"), "python3"),
}


def look():
    for what, (use, package) in NEEDED.items():
        try:
            use()
        except (ImportError, OSError):
            sys.exit("The Python package cannot be built: %s has not %s; install %s." % (sys.executable, what, package))


def run(*command, **environment):
    print("$", *command, flush=True)
    done = subprocess.run(command, check=False, env={**os.environ, **environment})
    if done.returncode:
        sys.exit("%s ended with %d" % (" ".join(command), done.returncode))


def requirements(source):
    import tomllib
    with open(os.path.join(source, "pyproject.toml"), "rb") as file:
        top = tomllib.load(file)
    project = top["project"]
    return top["build-system"]["requires"] + project["dependencies"] + project["optional-dependencies"]["test"]


def compiler_of(compiled):
    """That a folder was compiled with; None where nothing was."""
    try:
        with open(os.path.join(compiled, "CMakeCache.txt"), encoding="utf-8") as file:
            return next((line.split("=", 1)[1].strip() for line in file if line.startswith("CMAKE_CXX_COMPILER:")), None)
    except OSError:
        return None


def main(source, build, compiler, warnings_as_errors, *options):
    look()
    environment, compiled = os.path.join(build, "python"), build + "-python"
    python = os.path.join(environment, "bin", "python")
    version = "import sys; sys.exit(sys.version_info[:3] != %r)" % (sys.version_info[:3],)
    if not os.path.exists(python) or subprocess.run([python, "-c", version], check=False).returncode:
        run(sys.executable, "-m", "venv", "--clear", environment)
        shutil.rmtree(compiled, ignore_errors=True)
    if compiler_of(compiled) not in (None, compiler):
        shutil.rmtree(compiled)
    pip = [python, "-m", "pip", "--disable-pip-version-check", "--quiet", "install"]
    own = {"PYTHONPYCACHEPREFIX": ""}  # what is installed has its bytecode beside it
    run(*pip, *requirements(source), **own)
    # Without isolation: pip's own environments have another name each time, and the compiler cache would know nothing.
    run(*pip, "--no-build-isolation", "--no-deps", "-C", "build-dir=" + compiled,
        "-C", "cmake.define.SUNDER_WARNINGS_AS_ERRORS=" + warnings_as_errors, source,
        CXX=compiler, CMAKE_BUILD_PARALLEL_LEVEL=os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", "2"), **own)
    run(python, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-c", os.path.join(source, "pyproject.toml"),
        os.path.join(source, "python", "tests"), *options)


if __name__ == "__main__":
    main(*sys.argv[1:])
