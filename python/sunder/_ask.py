"""Questions asked of files, as the program asks them."""
import json
import os
import subprocess
import tempfile

from sunder._error import Error

_PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "sunder")


class Report(dict):
    """The report of a question, as `--json` of the program prints it. `proof`: the certificate, where asked for."""

    proof: "bytes | None" = None


def _words(options):
    for name, value in options.items():
        option = "--" + name.rstrip("_").replace("_", "-")
        for each in value if isinstance(value, (list, tuple)) else [value]:
            if each is True:
                yield option
            elif each is not None and each is not False:
                yield "%s=%s" % (option, os.fspath(each) if isinstance(each, os.PathLike) else each)


def _run(words):
    try:
        done = subprocess.run([_PROGRAM, *words], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    except (OSError, ValueError) as error:
        raise Error("bad-call", "", "the call cannot be made: %s" % error) from None
    try:
        report = Report(json.loads(done.stdout))
    except ValueError:
        said = done.stderr.decode(errors="replace").strip() or "the program ended with %d" % done.returncode
        raise Error("internal" if done.returncode not in (0, 1, 2) else "bad-call", "", said) from None
    if "error" in report:
        error = report["error"]
        raise Error(error["kind"], error["place"], error["text"].removeprefix(error["place"] + ": "))
    return report


def ask(verb: str, *files: "str | os.PathLike", certificate: bool = False, **options: object) -> Report:
    """Asks a question of files: the verb, the files and the options of the program `sunder`, --some-option as
    some_option=value. Returns the report; with certificate=True its `proof` is the certificate, as bytes."""
    if not isinstance(verb, str):
        raise Error("bad-call", "ask", "the verb is a text, such as \"circles\"")
    try:
        words = [verb, "--json", *_words(options), "--", *(os.fspath(file) for file in files)]
    except TypeError as error:
        raise Error("bad-call", "ask", "files are paths: %s" % error) from None
    if not certificate:
        return _run(words)
    with tempfile.TemporaryDirectory() as folder:
        proof = os.path.join(folder, "certificate.json")
        report = _run([verb, "--certificate=" + proof, *words[1:]])
        with open(proof, "rb") as file:
            report.proof = file.read()
    return report
