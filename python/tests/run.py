#!/usr/bin/env python3
"""Installs the package into an environment of its own, as `pip install .` does, and runs its tests there.

    python/tests/run.py SOURCE WORK COMPILER [OPTION OF PYTEST...]

WORK keeps the environment and what was compiled. Where the package cannot be built, this says what is missing and fails.
"""
import os
import subprocess
import sys
import sysconfig

MISSING = {  # what it takes: (is it there, Debian's package)
    "the modules venv and ensurepip": (lambda: __import__("venv") and __import__("ensurepip"), "python3-venv"),
    "the header Python.h": (lambda: open(os.path.join(sysconfig.get_path("include"), "Python.h"), "rb").close(),
                            "python3-dev"),
    "Python 3.11 (its module tomllib)": (lambda: __import__("tomllib"), "python3"),
}


def look():
    for what, (use, package) in MISSING.items():
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
        project = tomllib.load(file)
    return project["build-system"]["requires"] + project["project"]["dependencies"] + \
        project["project"]["optional-dependencies"]["test"]


def main(source, work, compiler, *options):
    look()
    python = os.path.join(work, "venv", "bin", "python")
    if subprocess.run([python, "-c", "import sys; sys.exit(sys.version_info[:2] != %r)" % (sys.version_info[:2],)],
                      check=False, stderr=subprocess.DEVNULL).returncode if os.path.exists(python) else True:
        run(sys.executable, "-m", "venv", "--clear", os.path.join(work, "venv"))
    pip = [python, "-m", "pip", "--disable-pip-version-check", "--quiet", "install"]
    run(*pip, *requirements(source))
    # Without isolation, so that what was compiled before is found again: pip's isolated folders have other names each time.
    run(*pip, "--no-build-isolation", "--no-deps", "-C", "build-dir=" + os.path.join(work, "build"), source,
        CXX=compiler, CMAKE_BUILD_PARALLEL_LEVEL=os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", "2"))
    run(python, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-c", os.path.join(source, "pyproject.toml"),
        os.path.join(source, "python", "tests"), *options)


if __name__ == "__main__":
    main(*sys.argv[1:])
