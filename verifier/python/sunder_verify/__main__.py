"""Checks certificate files of Sunder: python3 -m sunder_verify FILE..., or the path of this folder for -m and its name.

Exit code: 0 all accepted, 1 something refused, 2 a file that cannot be read, or checked within the limits, or a bad
call, 3 an internal error or too little memory. Of many files each is told about; the greatest code counts.
"""
import argparse
import hashlib
import os
import stat
import sys

if not __package__:  # called by the folder's path
    sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

from sunder_verify import Refused, Unreadable, verify  # noqa: E402
from sunder_verify.reader import MAX_TEXT  # noqa: E402
from sunder_verify.sentences import in_quotes  # noqa: E402

MAX_STREAM = 1 << 28  # bytes of what is no regular file


def shown(text):
    """On one line: control bytes and what is no UTF-8 as \\xNN."""
    raw = os.fsencode(text).decode("utf-8", "backslashreplace")
    return "".join(c if c.isprintable() else "".join("\\x%02x" % byte for byte in c.encode()) for c in raw)


def read_file(file):
    with open(file, "rb") as stream:
        if stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
            return stream.read()
        data = stream.read(MAX_STREAM + 1)
        if len(data) > MAX_STREAM:
            raise Unreadable("gives more than 256 MiB; read from a regular file")
        return data


def difference(inputs, against):
    """Where these files, (name, digest) each, are not the inputs, each by its digest, in their order; else empty."""
    if len(inputs) != len(against):
        return "it names %d inputs, and %d are given; give all, in their order" % (len(inputs), len(against))
    for k, ((name, digest), (given, found)) in enumerate(zip(inputs, against)):
        if digest != found:
            return "input %d, %s, has another SHA-256 than %s, %s" % (k + 1, in_quotes(name), shown(given), found)
    return ""


def check_file(file, options, against):
    """Prints what becomes of a file. Returns the exit code, and how many statements are accepted and refused."""
    name = shown(file)
    try:
        report = verify(read_file(file), not options.no_limit)
    except Refused as error:
        print("%s: refused: %s: %s" % (name, error.args[0], shown(error.args[1])))
        return 1, 0, 0
    except (OSError, Unreadable) as error:
        sys.stdout.flush()  # what is known of the files before
        print("%s: %s" % (name, getattr(error, "strerror", None) or error), file=sys.stderr)
        return 2, 0, 0
    for given, digest in report.inputs:
        print("%s: of %s, SHA-256 %s" % (name, in_quotes(given, MAX_TEXT), digest))
    if report.call:
        print("%s: called with: %s" % (name, " ".join(in_quotes(word, MAX_TEXT) for word in report.call)))
    for text in report.left_out:
        print("%s: left out: %s" % (name, in_quotes(text, MAX_TEXT)))
    other = difference(report.inputs, against) if against else ""
    if other:
        print("%s: not of these files: %s" % (name, other))
    elif against:
        print("%s: of files with these digests; what is in them was not looked at" % name)
    bad = 0
    for i, (sentence, refusal) in enumerate(report.statements):
        bad += refusal is not None
        if refusal or not options.quiet:
            said = "refused: %s: %s: %s" % (sentence, refusal[0], shown(refusal[1])) if refusal else "accepted: " + sentence
            print("%s: statement %d: %s" % (name, i, said))
    return 1 if bad or other else 0, len(report.statements) - bad, bad


def main(arguments):
    parser = argparse.ArgumentParser(prog="sunder_verify",
                                     description="Checks certificate files of Sunder, exactly and without Sunder.")
    parser.add_argument("files", metavar="FILE", nargs="+")
    parser.add_argument("--quiet", action="store_true",
                        help="print inputs, the call, what was left out, refusals and errors only")
    parser.add_argument("--against", metavar="FILE", action="append", default=[],
                        help="refuse what is not of these files: give all inputs, in their order; their SHA-256 are "
                             "compared, and nothing else")
    parser.add_argument("--no-limit", action="store_true", help="check files that take long, too")
    parser.error = lambda message: parser.exit(2, "sunder_verify: %s; see --help\n" % shown(message))
    options = parser.parse_args(arguments)
    code = accepted = refused = 0
    try:
        against = [(given, hashlib.sha256(read_file(given)).hexdigest()) for given in options.against]
    except (OSError, Unreadable) as error:
        print("%s: %s" % (shown(getattr(error, "filename", None) or "--against"), getattr(error, "strerror", None) or error),
              file=sys.stderr)
        return 2
    for file in options.files:
        outcome, good, bad = check_file(file, options, against)
        code, accepted, refused = max(code, outcome), accepted + good, refused + bad
    if not options.quiet:
        print("%d statements accepted, %d refused: %s" % (accepted, refused, ("accepted", "REFUSED", "ERROR")[code]))
    sys.stdout.flush()
    return code


def fail(code, text):
    """One line on standard error, and nothing more on standard output."""
    try:
        print("sunder_verify: " + text, file=sys.stderr, flush=True)
    finally:
        os._exit(code)  # what is left in buffers cannot be written


def run(arguments):
    for stream in (sys.stdout, sys.stderr):
        if stream is None:
            return 2
        stream.reconfigure(errors="backslashreplace")
    try:
        return main(arguments)
    except OSError as error:
        return fail(2, "standard output: cannot be written (%s)" % error.strerror)
    except MemoryError:
        return fail(3, "out of memory; give smaller files or more memory")
    except KeyboardInterrupt:
        return fail(130, "interrupted")
    except Exception as error:  # pylint: disable=broad-except
        return fail(3, "internal error: %s; please report it" % shown(repr(error)))


if __name__ == "__main__":
    sys.exit(run(sys.argv[1:]))
