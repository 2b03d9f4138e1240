#!/usr/bin/env python3
"""Checks certificate files of Sunder, exactly and without Sunder: python3 sunder_verify.py FILE...

The format and the checks F, A1-A3 and M1-M3 are those of docs/certificates.md; no code is shared with the library.
All arithmetic is on integers: a number is kept as (n, d, e), meaning n / d * 2^e with d > 0, and numbers are brought
to a common denominator where they are used.

Exit code: 0 all accepted, 1 something refused, 2 a file that is not JSON or a bad call.
"""
import argparse
import json
import math
import re
import sys

MAX_CHARACTERS = 20000  # of a number
MAX_EXPONENT = 20000   # E of a hexadecimal number, either sign
MAX_WEIGHTS = 16       # of one body in a pair; 4 are always enough

HEXADECIMAL = re.compile(r"(-?)0x([0-9a-fA-F]+)(?:\.([0-9a-fA-F]+))?p([+-]?[0-9]+)")
DECIMAL = re.compile(r"(-?[0-9]+)(?:/([0-9]+))?")

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)  # MAX_CHARACTERS bounds them


class Unreadable(Exception):
    """The text is not JSON."""


class Refused(Exception):
    """A check failed: args are its name and the reason."""


def require(condition, check, reason):
    if not condition:
        raise Refused(check, reason)


# ---- Reading: everything that is required here is check F.

def load(data):
    """The JSON value of the bytes of a file."""
    repeated = []

    def make_object(items):
        if len(dict(items)) < len(items):
            repeated.append(items)
        return dict(items)

    def make_float(text):
        if not math.isfinite(float(text)):  # text can be NaN or Infinity, which are not JSON
            raise Unreadable("%.20s is no JSON number; write numbers as strings" % text)
        return float(text)

    def make_int(text):
        return int(text) if len(text) < 20 else make_float(text)

    try:
        text = data.decode("utf-8-sig")
        value = json.loads(text, object_pairs_hook=make_object, parse_float=make_float, parse_int=make_int,
                           parse_constant=make_float)
        if "\\u" in text:
            json.dumps(value, ensure_ascii=False).encode("utf-8")  # fails on half a surrogate pair
    except json.JSONDecodeError as error:
        raise Unreadable("line %d, column %d: %s; write the file again" % (error.lineno, error.colno, error.msg))
    except UnicodeError:
        raise Unreadable("not UTF-8 text; write the file again")
    except RecursionError:
        raise Unreadable("nested too deeply; a certificate needs 5 levels")
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
    member(item, "name", str, where)
    flat = []
    for i, vertex in enumerate(member(item, "vertices", list, where)):
        flat += numbers(vertex, 3, double, "%s.vertices[%d]" % (where, i))
    require(flat, "F", where + " has no vertex")
    flat, _, e = common(flat)
    return list(zip(flat[0::3], flat[1::3], flat[2::3])), e


class Placed:
    """A placed body as integers: the image of vertex v is linear v * 2^turned + translation * 2^moved."""

    def __init__(self, item, bodies, where):
        self.name = member(item, "name", str, where)
        self.vertices, e = bodies[index(member(item, "body", int, where), len(bodies), where + ".body")]
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
    row = [dot(d, a.linear[c::3]) for c in range(3)]  # d . image = row . v * 2^turned + something that all v share
    furthest = dot(row, a.vertices[extreme_a])
    for i, v in enumerate(a.vertices):
        if dot(row, v) > furthest:
            raise Refused("A1", "vertex %d of A is further along the direction than extreme_a" % i)
    row = [dot(d, b.linear[c::3]) for c in range(3)]
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
    scaled = {name: common(weights.values()) for name, _, weights in sides}
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


def verify(data, only=None):
    """Checks the bytes of a file, or one pair of it. Returns a list of (pair, name_a, name_b, verdict, refusal), where
    refusal is None or (check, reason). Raises Unreadable, or Refused where the form is wrong."""
    top = load(data)
    if type(top) is dict and "sunder_set_certificate" in top:
        import sunder_verify_sets  # beside this file
        return sunder_verify_sets.verify(top)
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


def main(arguments):
    parser = argparse.ArgumentParser(description="Checks certificate files of Sunder, exactly and without Sunder.")
    parser.add_argument("files", metavar="FILE", nargs="+")
    parser.add_argument("--pair", type=int, metavar="I", help="check pair I only, counted from 0")
    parser.add_argument("--quiet", action="store_true", help="print refusals and errors only")
    parser.error = lambda message: parser.exit(2, "sunder_verify.py: %s; see --help\n" % message)
    options = parser.parse_args(arguments)
    code = accepted = refused = 0
    for file in options.files:
        try:
            with open(file, "rb") as stream:
                results = verify(stream.read(), options.pair)
        except Refused as error:
            print("%s: refused: %s: %s" % (file, *error.args))
            code = max(code, 1)
        except (OSError, Unreadable) as error:
            print("%s: %s" % (file, getattr(error, "strerror", error)), file=sys.stderr)
            code = 2
        else:
            for i, name_a, name_b, verdict, refusal in results:
                if refusal or not options.quiet:
                    print("%s: pair %d: %s, %s: %s: %s" % (file, i, json.dumps(name_a), json.dumps(name_b), verdict,
                                                           "refused: %s: %s" % refusal if refusal else "accepted"))
            bad = sum(result[4] is not None for result in results)
            refused += bad
            accepted += len(results) - bad
            code = max(code, 1 if bad else 0)
    if not options.quiet:
        print("%d pairs accepted, %d refused: %s" % (accepted, refused, ("accepted", "REFUSED", "ERROR")[code]))
    return code


if __name__ == "__main__":
    sys.modules["sunder_verify"] = sys.modules["__main__"]  # what the other file imports is this one
    sys.exit(main(sys.argv[1:]))
