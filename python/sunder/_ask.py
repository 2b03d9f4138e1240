"""Questions asked of files, as the program asks them."""
import json
import os

from sunder import _sunder
from sunder._error import Error


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


def ask(verb: str, *files: "str | os.PathLike", certificate: bool = False, **options: object) -> Report:
    """Asks a question of files: the verb, the files and the options of the program `sunder`, --some-option as
    some_option=value. Returns the report; with certificate=True its `proof` is the certificate, as bytes."""
    if not isinstance(verb, str):
        raise Error("bad-call", "ask", "the verb is a text, such as \"circles\"")
    try:
        words = [os.fsencode(word) for word in (verb, "--json", *_words(options), "--", *files)]
    except (TypeError, UnicodeError) as error:
        raise Error("bad-call", "ask", "files are paths: %s" % error) from None
    if any(b"\0" in word or word == b"-" or word.endswith(b"=-") for word in words):
        raise Error("bad-call", "ask", "names hold no null byte, and no file is \"-\": there is no standard input here")
    try:
        said, errors, proof = _sunder._ask(words[:1] + [b"--certificate=-"] * bool(certificate) + words[1:])
    except RuntimeError as error:
        raise Error("internal", "", "internal error: %s; please report it" % error) from None
    try:
        report = Report(json.loads(said))
    except ValueError:
        raise Error("bad-call", "ask", errors.decode(errors="replace") or "no report is made of this call") from None
    if "error" in report:
        error = report["error"]
        raise Error(error["kind"], error["place"], error["text"].removeprefix(error["place"] + ": "))
    if certificate:
        report.proof = proof
    return report
