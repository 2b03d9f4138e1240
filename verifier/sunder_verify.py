#!/usr/bin/env python3
"""Checks certificate files of Sunder, exactly and without Sunder: python3 sunder_verify.py FILE...

The format and the checks F, A1-A3 and M1-M3 are those of docs/certificates.md; no code is shared with the library.
All arithmetic is on integers: a number is kept as (n, d, e), meaning n / d * 2^e with d > 0, and numbers are brought
to a common denominator where they are used.

Exit code: 0 all accepted, 1 something refused, 2 a file that cannot be read, or checked within the limits, or a bad call,
3 an internal error or too little memory. Of many files each is told about; the greatest code counts.
"""
import argparse
import json
import math
import os
import re
import stat
import sys

MAX_CHARACTERS = 20000  # of a number
MAX_EXPONENT = 20000   # E of a hexadecimal number, either sign
MAX_NOTE = 4000        # characters of a note
MAX_WEIGHTS = 16       # of one body or polygon; 4 are always enough
MAX_NAME = 4000        # characters
MAX_DEPTH = 500        # of nested JSON; a certificate needs 5 levels
MAX_STREAM = 1 << 28   # bytes of what is no regular file

STRING = re.compile(r'"(?:[^"\\]|\\.)*"?', re.DOTALL)  # also one that does not end: no search twice
BRACKETS = re.compile(r"[\[{]+|[\]}]+")
ESCAPE = re.compile(r"\\(?:u[dD][89abAB][0-9a-fA-F]{2}\\u[dD][c-fC-F][0-9a-fA-F]{2}|(u[dD][89a-fA-F])|.)", re.DOTALL)
HEXADECIMAL = re.compile(r"(-?)0x([0-9a-fA-F]+)(?:\.([0-9a-fA-F]+))?p([+-]?[0-9]+)")
DECIMAL = re.compile(r"(-?[0-9]+)(?:/([0-9]+))?")

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)  # MAX_CHARACTERS bounds them


class Unreadable(Exception):
    """The text is not JSON, or checking it would take too long."""


class Refused(Exception):
    """A check failed: args are its name and the reason."""


class Steps:
    """How much work is left of what a file of its size may take: docs/certificates.md, "Limits"."""

    def __init__(self):
        self.most = self.left = None  # None: no limit

    def limit(self, size):
        self.most = self.left = 300 * max(size, 1000000)

    def take(self, looks, a, b):
        """So many looks at a number of a bits and one of b bits."""
        if self.left is not None:
            self.left -= looks * (16 + (a // 64 + 1) * (b // 64 + 1))
            if self.left < 0:
                raise Unreadable("checking it takes more than %d steps, the limit for a file of its size; give --no-limit "
                                 "to check it all the same" % self.most)


steps = Steps()


def require(condition, check, reason):
    if not condition:
        raise Refused(check, reason)


# ---- Reading: everything that is required here is check F.

def depth(text):
    """How deep JSON is nested."""
    level = deepest = 0
    for brackets in BRACKETS.findall(STRING.sub("", text)):
        level += len(brackets) if brackets[0] in "[{" else -len(brackets)
        deepest = max(deepest, level)
    return deepest


def load(data):
    """The JSON value of the bytes of a file."""
    repeated = []

    def make_object(items):
        result = dict(items)
        if len(result) < len(items):
            repeated.append(None)
        return result

    def make_float(text):
        if not math.isfinite(float(text)):  # text can be NaN or Infinity, which are not JSON
            raise Unreadable("%.20s is no JSON number; write numbers as strings" % text)
        return float(text)

    def make_int(text):
        return int(text) if len(text) < 20 else make_float(text)

    try:
        text = data.decode("utf-8-sig")
        if depth(text) > MAX_DEPTH:
            raise Unreadable("nested too deeply; a certificate needs 5 levels")
        value = json.loads(text, object_pairs_hook=make_object, parse_float=make_float, parse_int=make_int,
                           parse_constant=make_float)
    except json.JSONDecodeError as error:
        raise Unreadable("line %d, column %d: %s; write the file again" % (error.lineno, error.colno, error.msg))
    except UnicodeError:
        raise Unreadable("not UTF-8 text; write the file again")
    if any(escape.group(1) for escape in ESCAPE.finditer(text)):
        raise Unreadable("half a surrogate pair; write the file again")
    require(not repeated, "F", "an object has a key twice")
    return value


def member(item, key, kind, where):
    require(type(item) is dict, "F", where + " is not an object")
    require(key in item, "F", "%s has no %s" % (where, key))
    require(type(item[key]) is kind, "F", "%s.%s is not of type %s" % (where, key, kind.__name__))
    return item[key]


def index(value, size, where):
    require(type(value) is int and 0 <= value < size, "F", where + " is not an index in range")  # true is no int here
    return value


def number(value, where):
    require(type(value) is str and len(value) <= MAX_CHARACTERS, "F", where + " is not a number as a string")
    match = HEXADECIMAL.fullmatch(value)
    if match:
        sign, whole, fraction, exponent = match.groups(default="")
        n, e = int(sign + whole + fraction, 16), int(exponent)
        require(abs(e) <= MAX_EXPONENT, "F", where + " has too large an exponent")
        zeros = (n & -n).bit_length() - 1 if n else 0
        return n >> zeros, 1, e - 4 * len(fraction) + zeros
    match = DECIMAL.fullmatch(value)
    require(match, "F", where + " is not a number of one of the three forms")
    n, d = int(match.group(1)), int(match.group(2) or 1)
    require(d != 0, "F", where + " has denominator zero")
    return n, d, 0


def double(value, where):
    n, d, e = number(value, where)
    bits = n.bit_length()  # n is odd or zero
    require("x" in value and (n == 0 or (bits <= 53 and e >= -1074 and bits + e <= 1024)), "F",
            where + " is not a hexadecimal double")
    return n, d, e


def numbers(value, count, read, where):
    require(type(value) is list and len(value) == count, "F", "%s is not a list of %d" % (where, count))
    return [read(item, where) for item in value]


def length(*values):
    """The bits of numbers together, exponents counted as they are."""
    return sum(abs(n).bit_length() + d.bit_length() + abs(e) for n, d, e in values)


def bits(integers):
    """The greatest number of bits of some integers."""
    return max((n.bit_length() for n in integers), default=0)


def common_weights(values):
    """As common, of weights; takes the steps."""
    values = list(values)
    whole = length(*values)
    steps.take(len(values) // 4 + 1, whole, whole)
    return common(values)


def name_of(item, where):
    name = member(item, "name", str, where)
    require(len(name) <= MAX_NAME, "F", "%s.name has more than %d characters" % (where, MAX_NAME))
    return name


def common(values):
    """Integers, a positive denominator d and an exponent e: each value is its integer / d * 2^e."""
    e = min((k for n, _, k in values if n), default=0)
    integers, product = [], 1
    for n, d, k in values:
        if d != 1:
            integers = [m * d for m in integers]
        integers.append(n * product << (k - e) if n else 0)
        product *= d
    return integers, product, e


def read_body(item, where):
    name_of(item, where)
    flat = []
    for i, vertex in enumerate(member(item, "vertices", list, where)):
        flat += numbers(vertex, 3, double, "%s.vertices[%d]" % (where, i))
    require(flat, "F", where + " has no vertex")
    flat, _, e = common(flat)
    return list(zip(flat[0::3], flat[1::3], flat[2::3])), e, bits(flat)


class Placed:
    """A placed body as integers: the image of vertex v is linear v * 2^turned + translation * 2^moved."""

    def __init__(self, item, bodies, where):
        self.name = name_of(item, where)
        self.vertices, e, self.bits = bodies[index(member(item, "body", int, where), len(bodies), where + ".body")]
        linear = numbers(member(item, "linear", list, where), 9, double, where + ".linear")
        translation = numbers(member(item, "translation", list, where), 3, double, where + ".translation")
        self.linear, _, turned = common(linear)
        self.translation, _, self.moved = common(translation)
        self.turned = turned + e

    def image(self, i):
        """Three integers and an exponent e: the image of vertex i is the integers * 2^e."""
        e = min(self.turned, self.moved)
        turned = [dot(self.linear[r:r + 3], self.vertices[i]) for r in (0, 3, 6)]
        return [(n << (self.turned - e)) + (t << (self.moved - e)) for n, t in zip(turned, self.translation)], e


def read_weights(value, size, where):
    """By vertex. Of a body or polygon of so many vertices."""
    require(len(value) <= MAX_WEIGHTS, "F", "%s has more than %d entries" % (where, MAX_WEIGHTS))
    weights = {}
    for entry in value:
        require(type(entry) is list and len(entry) == 2, "F", where + " has an entry that is not a list of 2")
        vertex = index(entry[0], size, where + " vertex")
        require(vertex not in weights, "F", "%s has vertex %d twice" % (where, vertex))
        weights[vertex] = number(entry[1], where)
    return weights


def read_pair(item, placed, where):
    a = placed[index(member(item, "a", int, where), len(placed), where + ".a")]
    b = placed[index(member(item, "b", int, where), len(placed), where + ".b")]
    verdict = member(item, "verdict", str, where)
    require(verdict in ("apart", "meet"), "F", where + ".verdict is neither apart nor meet")
    if verdict == "apart":
        return check_apart, verdict, a, b, (
            numbers(member(item, "direction", list, where), 3, number, where + ".direction"),
            index(member(item, "extreme_a", int, where), len(a.vertices), where + ".extreme_a"),
            index(member(item, "extreme_b", int, where), len(b.vertices), where + ".extreme_b"))
    return check_meet, verdict, a, b, (
        numbers(member(item, "point", list, where), 3, number, where + ".point"),
        read_weights(member(item, "weights_a", list, where), len(a.vertices), where + ".weights_a"),
        read_weights(member(item, "weights_b", list, where), len(b.vertices), where + ".weights_b"))


def read_note(top):
    """What the file says that it does not speak of; None where it has no note."""
    if type(top) is not dict or "note" not in top:
        return None
    note = member(top, "note", str, "the file")
    require(0 < len(note) <= MAX_NOTE, "F", "the note is not of 1 to %d characters" % MAX_NOTE)
    return note


def in_quotes(text):
    """The text in quotes, as one line of ASCII without control characters."""
    return json.dumps(text).replace("\x7f", "\\u007f")


def read(top):
    """The pairs of a file, each (check, verdict, a, b, evidence)."""
    require(member(top, "sunder_certificate", int, "the file") == 1, "F", "sunder_certificate is not 1")
    bodies = [read_body(item, "bodies[%d]" % i) for i, item in enumerate(member(top, "bodies", list, "the file"))]
    placed = [Placed(item, bodies, "placed[%d]" % i) for i, item in enumerate(member(top, "placed", list, "the file"))]
    return [read_pair(item, placed, "pairs[%d]" % i) for i, item in enumerate(member(top, "pairs", list, "the file"))]


# ---- Checking.

def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def aligned(m, e, n, f):
    """Two integers that compare as m * 2^e and n * 2^f do."""
    return m << max(e - f, 0), n << max(f - e, 0)


def check_apart(a, b, direction, extreme_a, extreme_b):
    d, _, _ = common(direction)  # a positive multiple of the direction
    for placed in (a, b):
        steps.take(9, bits(d), bits(placed.linear))
    row = [dot(d, a.linear[c::3]) for c in range(3)]  # d . image = row . v * 2^turned + something that all v share
    steps.take(len(a.vertices), bits(row), a.bits)
    furthest = dot(row, a.vertices[extreme_a])
    for i, v in enumerate(a.vertices):
        if dot(row, v) > furthest:
            raise Refused("A1", "vertex %d of A is further along the direction than extreme_a" % i)
    row = [dot(d, b.linear[c::3]) for c in range(3)]
    steps.take(len(b.vertices), bits(row), b.bits)
    least = dot(row, b.vertices[extreme_b])
    for i, w in enumerate(b.vertices):
        if dot(row, w) < least:
            raise Refused("A2", "vertex %d of B is less far along the direction than extreme_b" % i)
    (p, e), (q, f) = a.image(extreme_a), b.image(extreme_b)
    p, q = aligned(dot(d, p), e, dot(d, q), f)
    require(p < q, "A3", "extreme_a is not strictly less far along the direction than extreme_b")


def check_meet(a, b, point, weights_a, weights_b):
    sides = (("A", a, weights_a), ("B", b, weights_b))
    for name, _, weights in sides:
        for i, (n, _, _) in weights.items():
            require(n >= 0, "M1", "the weight of vertex %d of %s is negative" % (i, name))
    scaled = {name: common_weights(weights.values()) for name, _, weights in sides}
    for name, (values, d, e) in scaled.items():
        total, one = aligned(sum(values), e, d, 0)
        require(total == one, "M2", "the weights of %s do not sum to 1" % name)
    for name, placed, weights in sides:
        values, d, e = scaled[name]
        images = [placed.image(i) for i in weights]
        for axis in range(3):
            total = sum(value * image[axis] for value, (image, _) in zip(values, images))
            n, denominator, k = point[axis]
            total, wanted = aligned(total * denominator, e + images[0][1], n * d, k)
            require(total == wanted, "M3", "the weighted sum of %s is not the point in coordinate %d" % (name, axis))


def verify(data, only=None, is_limited=False):
    """Checks the bytes of a file, or one pair of it; is_limited: within the steps that a file of its size may take.
    Returns a list of (pair, name_a, name_b, verdict, refusal), where refusal is None or (check, reason). Raises
    Unreadable, or Refused where the form is wrong."""
    return verify_with_notes(data, only, is_limited)[1]


def verify_with_notes(data, only=None, is_limited=False):
    """What the file says of itself, for people, and what verify returns."""
    steps.left = None
    if is_limited:
        steps.limit(len(data))
    top = load(data)
    if type(top) is dict and top.get("sunder_certificate") == 2 and "sunder_set_certificate" not in top:
        return verify_claims(data, is_limited)
    note = read_note(top)
    note = [] if note is None else ["note: " + in_quotes(note)]
    if type(top) is dict and "sunder_set_certificate" in top:
        import sunder_verify_sets  # beside this file
        return note, sunder_verify_sets.verify(top)
    return note, verify_pairs(top, only)


def verify_claims(data, is_limited):
    """The same of a file of version 2, which the package beside checks (docs/claims.md)."""
    import importlib.util
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "python", "sunder_verify")
    spec = importlib.util.spec_from_file_location("sunder_verify_claims", os.path.join(folder, "__init__.py"),
                                                  submodule_search_locations=[folder])
    package = sys.modules.get("sunder_verify_claims")
    if package is None:
        package = sys.modules["sunder_verify_claims"] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(package)
    try:
        report = package.verify(data, is_limited)
    except package.Refused as error:
        raise Refused(*error.args)
    except package.Unreadable as error:
        raise Unreadable(*error.args)
    notes = ["of %s, SHA-256 %s" % (in_quotes(name), digest) for name, digest in report.inputs]
    notes += ["left out: " + in_quotes(text) for text in report.left_out]
    return notes, [(i, *(words if question in ("pair", "distance") else (question, ", ".join(words))), verdict, refusal)
                   for i, (question, words, verdict, refusal) in enumerate(report.statements)]


def verify_pairs(top, only):
    pairs = read(top)
    if only is not None and not 0 <= only < len(pairs):
        raise Unreadable("no pair %d; the file has %d, counted from 0" % (only, len(pairs)))
    results = []
    for i, (check, verdict, a, b, evidence) in enumerate(pairs):
        if only in (None, i):
            refusal = None
            try:
                check(a, b, *evidence)
            except Refused as error:
                refusal = error.args
            results.append((i, a.name, b.name, verdict, refusal))
    return results


# ---- The program.

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


def check_file(file, options):
    """Prints what becomes of a file. Returns the exit code, and how many pairs are accepted and refused."""
    name = shown(file)
    try:
        notes, results = verify_with_notes(read_file(file), options.pair, not options.no_limit)
    except Refused as error:
        print("%s: refused: %s: %s" % (name, *error.args))
        return 1, 0, 0
    except (OSError, Unreadable) as error:
        sys.stdout.flush()  # what is known of the files before
        print("%s: %s" % (name, getattr(error, "strerror", None) or error), file=sys.stderr)
        return 2, 0, 0
    for line in notes:
        print("%s: %s" % (name, line))
    for i, name_a, name_b, verdict, refusal in results:
        if refusal or not options.quiet:
            print("%s: pair %d: %s, %s: %s: %s" % (name, i, in_quotes(name_a), in_quotes(name_b), verdict,
                                                   "refused: %s: %s" % refusal if refusal else "accepted"))
    bad = sum(result[4] is not None for result in results)
    return 1 if bad else 0, len(results) - bad, bad


def main(arguments):
    parser = argparse.ArgumentParser(description="Checks certificate files of Sunder, exactly and without Sunder.")
    parser.add_argument("files", metavar="FILE", nargs="+")
    parser.add_argument("--pair", type=int, metavar="I", help="check pair I only, counted from 0")
    parser.add_argument("--quiet", action="store_true", help="print notes, refusals and errors only")
    parser.add_argument("--no-limit", action="store_true", help="check files that take long, too")
    parser.error = lambda message: parser.exit(2, "sunder_verify.py: %s; see --help\n" % shown(message))
    options = parser.parse_args(arguments)
    code = accepted = refused = 0
    for file in options.files:
        outcome, good, bad = check_file(file, options)
        code, accepted, refused = max(code, outcome), accepted + good, refused + bad
    if not options.quiet:
        print("%d pairs accepted, %d refused: %s" % (accepted, refused, ("accepted", "REFUSED", "ERROR")[code]))
    sys.stdout.flush()
    return code


def fail(code, text):
    """One line on standard error, and nothing more on standard output."""
    try:
        print("sunder_verify.py: " + text, file=sys.stderr, flush=True)
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
    sys.modules["sunder_verify"] = sys.modules["__main__"]  # what the other file imports is this one
    sys.exit(run(sys.argv[1:]))
