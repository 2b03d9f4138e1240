#!/usr/bin/env python3
"""Checks certificate files of Sunder, exactly and without Sunder.

The format and the checks F, A1-A3 and M1-M3 are those of docs/certificates.md; nothing here shares code with the
library. All arithmetic is on integers: a number is kept as (n, d, e), meaning n / d * 2^e with d > 0, and is brought
to a common denominator only when it is used.

Exit code: 0 all accepted, 1 something refused, 2 a file that is not JSON or a bad call.
"""
import argparse
import json
import math
import re
import sys

MAX_CHARACTERS = 20000  # of a number
MAX_EXPONENT = 100000   # E of a hexadecimal number, either sign
MAX_WEIGHTS = 16        # of one body in a pair; 4 are always enough

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


# ---- Reading: everything here is check F.

def load(data):
    """The JSON value of the bytes of a file."""
    repeated = []

    def make_object(items):
        result = dict(items)
        if len(result) != len(items):
            repeated.append(items)
        return result

    def make_float(text):
        if math.isinf(float(text)):
            raise Unreadable("a JSON number is beyond the doubles; write numbers as strings")
        return float(text)

    def make_int(text):
        return int(text) if len(text) < 20 else make_float(text)

    def make_constant(text):
        raise Unreadable(text + " is not JSON; write numbers as strings")

    try:
        text = data.decode("utf-8-sig")
        value = json.loads(text, object_pairs_hook=make_object, parse_float=make_float, parse_int=make_int,
                           parse_constant=make_constant)
        if "\\u" in text:
            json.dumps(value, ensure_ascii=False).encode("utf-8")  # fails on half a surrogate pair
    except json.JSONDecodeError as error:
        raise Unreadable("line %d, column %d: %s; write the file again as JSON" % (error.lineno, error.colno, error.msg))
    except UnicodeError:
        raise Unreadable("not UTF-8 text; write the file again as JSON")
    except RecursionError:
        raise Unreadable("nested too deeply; a certificate needs 5 levels")
    require(not repeated, "F", "an object has a key twice")
    return value


def is_list(value, length, where):
    require(type(value) is list and length in (None, len(value)), "F",
            where + " is not a list" + ("" if length is None else " of %d" % length))
    return value


def member(item, key, where):
    require(type(item) is dict, "F", where + " is not an object")
    require(key in item, "F", where + " has no " + key)
    return item[key]


def list_member(item, key, length, where):
    return is_list(member(item, key, where), length, where + "." + key)


def string_member(item, key, where):
    value = member(item, key, where)
    require(type(value) is str, "F", where + "." + key + " is not a string")
    return value


def index(value, size, where):
    require(type(value) is int, "F", where + " is not an integer")  # true and 1.0 are none
    require(0 <= value < size, "F", where + " is out of range")
    return value


def number(value, where):
    """The number (n, d, e) of a string."""
    require(type(value) is str and len(value) <= MAX_CHARACTERS, "F", where + " is not a string of a number")
    match = HEXADECIMAL.fullmatch(value)
    if match:
        sign, whole, fraction, exponent = match.groups(default="")
        n, e = int(whole + fraction, 16), int(exponent)
        require(abs(e) <= MAX_EXPONENT, "F", where + " has too large an exponent")
        zeros = (n & -n).bit_length() - 1 if n else 0
        return (-n if sign else n) >> zeros, 1, e - 4 * len(fraction) + zeros
    match = DECIMAL.fullmatch(value)
    require(match, "F", where + " is not a number")
    n, d = int(match.group(1)), int(match.group(2) or 1)
    require(d != 0, "F", where + " has denominator zero")
    return n, d, 0


def double(value, where):
    n, d, e = number(value, where)
    require("x" in value, "F", where + " is not hexadecimal")
    bits = n.bit_length()
    require(bits == 0 or (bits <= 53 and e >= -1074 and bits + e <= 1024), "F", where + " is not a double")
    return n, d, e


def numbers(value, count, read, where):
    return [read(item, where) for item in is_list(value, count, where)]


def common(values):
    """Integers, a positive denominator d and an exponent e: each value is its integer / d * 2^e."""
    e = min((k for n, _, k in values if n), default=0)
    product = 1
    for _, d, _ in values:
        product *= d
    return [n * (product // d) << (k - e) if n else 0 for n, d, k in values], product, e


class Placed:
    """A body and its placement, as integers: the image of v is linear v * 2^turned + translation * 2^moved."""

    def __init__(self, item, bodies, where):
        self.name = string_member(item, "name", where)
        self.vertices, e = bodies[index(member(item, "body", where), len(bodies), where + ".body")]
        self.linear, _, turned = common(numbers(member(item, "linear", where), 9, double, where + ".linear"))
        self.translation, _, self.moved = common(
            numbers(member(item, "translation", where), 3, double, where + ".translation"))
        self.turned = turned + e

    def image(self, i):
        """Three integers and an exponent e: the image of vertex i is the integers * 2^e."""
        e = min(self.turned, self.moved)
        x, y, z = self.vertices[i]
        m = self.linear
        image = (m[0] * x + m[1] * y + m[2] * z, m[3] * x + m[4] * y + m[5] * z, m[6] * x + m[7] * y + m[8] * z)
        return [(n << (self.turned - e)) + (t << (self.moved - e)) for n, t in zip(image, self.translation)], e


def read_body(item, where):
    string_member(item, "name", where)
    flat = []
    for i, vertex in enumerate(list_member(item, "vertices", None, where)):
        flat += numbers(vertex, 3, double, "%s.vertices[%d]" % (where, i))
    require(flat, "F", where + " has no vertex")
    flat, _, e = common(flat)
    return list(zip(flat[0::3], flat[1::3], flat[2::3])), e


def read_weights(item, key, size, where):
    where += "." + key
    weights = {}
    for entry in is_list(member(item, key, where), None, where):
        vertex, weight = is_list(entry, 2, where + " entry")
        index(vertex, size, where + " vertex")
        require(vertex not in weights, "F", "%s has vertex %d twice" % (where, vertex))
        weights[vertex] = number(weight, where)
    require(len(weights) <= MAX_WEIGHTS, "F", "%s has more than %d entries" % (where, MAX_WEIGHTS))
    return weights


def read_pair(item, placed, where):
    a = placed[index(member(item, "a", where), len(placed), where + ".a")]
    b = placed[index(member(item, "b", where), len(placed), where + ".b")]
    verdict = string_member(item, "verdict", where)
    if verdict == "apart":
        evidence = (numbers(member(item, "direction", where), 3, number, where + ".direction"),
                    index(member(item, "extreme_a", where), len(a.vertices), where + ".extreme_a"),
                    index(member(item, "extreme_b", where), len(b.vertices), where + ".extreme_b"))
    else:
        require(verdict == "meet", "F", where + ".verdict is neither apart nor meet")
        evidence = (numbers(member(item, "point", where), 3, number, where + ".point"),
                    read_weights(item, "weights_a", len(a.vertices), where),
                    read_weights(item, "weights_b", len(b.vertices), where))
    return verdict, a, b, evidence


def read(data):
    """The pairs of a file, each (verdict, a, b, evidence)."""
    top = load(data)
    version = member(top, "sunder_certificate", "the file")
    require(type(version) is int and version == 1, "F", "sunder_certificate is not 1")
    bodies = [read_body(item, "bodies[%d]" % i) for i, item in enumerate(list_member(top, "bodies", None, "the file"))]
    placed = [Placed(item, bodies, "placed[%d]" % i)
              for i, item in enumerate(list_member(top, "placed", None, "the file"))]
    return [read_pair(item, placed, "pairs[%d]" % i)
            for i, item in enumerate(list_member(top, "pairs", None, "the file"))]


# ---- Checking.

def aligned(m, e, n, f):
    """Two integers that compare as m * 2^e and n * 2^f do."""
    return m << max(e - f, 0), n << max(f - e, 0)


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def check_apart(a, b, direction, extreme_a, extreme_b):
    d, _, _ = common(direction)  # a positive multiple of the direction says the same
    row = [dot(d, a.linear[c::3]) for c in range(3)]  # d . image = row . v * 2^turned + what does not depend on v
    top = dot(row, a.vertices[extreme_a])
    for i, v in enumerate(a.vertices):
        require(dot(row, v) <= top, "A1", "vertex %d of A is further than extreme_a" % i)
    row = [dot(d, b.linear[c::3]) for c in range(3)]
    low = dot(row, b.vertices[extreme_b])
    for i, w in enumerate(b.vertices):
        require(dot(row, w) >= low, "A2", "vertex %d of B is less far than extreme_b" % i)
    (p, e), (q, f) = a.image(extreme_a), b.image(extreme_b)
    p, q = aligned(dot(d, p), e, dot(d, q), f)
    require(p < q, "A3", "extreme_a is not strictly less far than extreme_b")


def check_meet(a, b, point, weights_a, weights_b):
    sides = (("A", a, weights_a), ("B", b, weights_b))
    for name, _, weights in sides:
        for i, (n, _, _) in weights.items():
            require(n >= 0, "M1", "the weight of vertex %d of %s is negative" % (i, name))
    for name, _, weights in sides:
        values, d, e = common(list(weights.values()))
        total, one = aligned(sum(values), e, d, 0)
        require(total == one, "M2", "the weights of %s do not sum to 1" % name)
    for name, body, weights in sides:
        values, d, e = common(list(weights.values()))
        images = [body.image(i) for i in weights]
        for axis in range(3):
            total = sum(value * image[axis] for value, (image, _) in zip(values, images))
            n, denominator, k = point[axis]
            left, right = aligned(total * denominator, e + images[0][1], n * d, k)
            require(left == right, "M3", "coordinate %d of the sum over %s is not that of the point" % (axis, name))


def verify(data, only=None):
    """Checks the bytes of a file, or one pair of it. Returns a list of (pair, name_a, name_b, verdict, refusal), where
    refusal is None or (check, reason). Raises Unreadable, and Refused where the form is wrong."""
    pairs = read(data)
    if only is not None and not 0 <= only < len(pairs):
        raise Unreadable("no pair %d; the file has %d, counted from 0" % (only, len(pairs)))
    results = []
    for i, (verdict, a, b, evidence) in enumerate(pairs):
        if only in (None, i):
            refusal = None
            try:
                (check_apart if verdict == "apart" else check_meet)(a, b, *evidence)
            except Refused as error:
                refusal = error.args
            results.append((i, a.name, b.name, verdict, refusal))
    return results


def main(arguments):
    parser = argparse.ArgumentParser(description="Checks certificate files of Sunder.")
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
        except (OSError, Unreadable) as error:
            print("%s: %s" % (file, getattr(error, "strerror", None) or error), file=sys.stderr)
            code = 2
        except Refused as error:
            print("%s: refused: %s: %s" % (file, *error.args))
            code = max(code, 1)
        else:
            for i, name_a, name_b, verdict, refusal in results:
                line = "%s: pair %d: %s, %s: %s: " % (file, i, json.dumps(name_a), json.dumps(name_b), verdict)
                if refusal:
                    print(line + "refused: %s: %s" % refusal)
                    refused += 1
                    code = max(code, 1)
                else:
                    accepted += 1
                    if not options.quiet:
                        print(line + "accepted")
    if not options.quiet:
        print("%d pairs accepted, %d refused: %s" % (accepted, refused, ("accepted", "REFUSED", "ERROR")[code]))
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
