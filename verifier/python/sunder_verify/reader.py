"""Reads certificate files of version 2: JSON, numbers, and what has a wrong form (docs/claims.md, "The file").

A number is kept as (n, d, e), meaning n / d * 2^e with d > 0. Tables are kept as integers: multiples of one power of two.
"""
import json
import math
import re
import sys

MAX_CHARACTERS = 20000  # of a number
MAX_EXPONENT = 20000    # E of a hexadecimal number, either sign
MAX_TEXT = 4000         # characters of a name, or of what was left out
MAX_DEPTH = 500         # of nested JSON; a certificate needs 7 levels
MOST_NUMBER = 10 ** 15 - 1    # all JSON readers agree about whole numbers up to this, either sign

STRING = re.compile(r'"(?:[^"\\]|\\.)*"?', re.DOTALL)  # also one that does not end: no search twice
BRACKETS = re.compile(r"[\[{]+|[\]}]+")
ESCAPE = re.compile(r"\\(?:u[dD][89abAB][0-9a-fA-F]{2}\\u[dD][c-fC-F][0-9a-fA-F]{2}|(u[dD][89a-fA-F])|.)", re.DOTALL)
HEXADECIMAL = re.compile(r"(-?)0x([0-9a-fA-F]+)(?:\.([0-9a-fA-F]+))?p([+-]?[0-9]+)")
DECIMAL = re.compile(r"(-?[0-9]+)(?:/([0-9]+))?")
SHA256 = re.compile(r"[0-9a-f]{64}")

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)  # MAX_CHARACTERS bounds them


class Unreadable(Exception):
    """The text is not JSON, or checking it would take too long."""


class Refused(Exception):
    """What is stated is not proved: args are the rule that fails and the reason."""


def require(condition, rule, reason):
    if not condition:
        raise Refused(rule, reason)


class Steps:
    """How much work is left of what a file of its size may take: docs/claims.md, "Limits"."""

    def __init__(self, size=None):
        self.most = self.left = None if size is None else 300 * max(size, 1000000)

    def take(self, looks, a, b):
        """So many looks at a number of a bits and one of b bits."""
        if self.left is not None:
            self.left -= looks * (16 + (a // 64 + 1) * (b // 64 + 1))
            if self.left < 0:
                raise Unreadable("checking it takes more than %d steps, the limit for a file of its size; give --no-limit "
                                 "to check it all the same" % self.most)


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
        level = deepest = 0
        for brackets in BRACKETS.findall(STRING.sub("", text)):
            level += len(brackets) if brackets[0] in "[{" else -len(brackets)
            deepest = max(deepest, level)
        if deepest > MAX_DEPTH:
            raise Unreadable("nested too deeply; a certificate needs 7 levels")
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


# ---- Values. Everything that is required from here on is rule F, the form.

def members(item, needed, where, allowed=()):
    """The values of an object's keys, each of its type; a key of `allowed` may be missing, and is then None."""
    require(type(item) is dict, "F", where + " is not an object")
    for key in item:
        require(key in needed or key in allowed, "F", "%s has %s, which means nothing" % (where, json.dumps(key)[:60]))
    for key in needed:
        require(key in item, "F", "%s has no %s" % (where, key))
    kinds = {**needed, **dict(allowed)}
    for key, value in item.items():
        require(type(value) is kinds[key], "F", "%s.%s is not of type %s" % (where, key, kinds[key].__name__))
    return [item.get(key) for key in kinds]


def index(value, size, where, least=0):
    require(type(value) is int and least <= value < size, "F", where + " is not an index in range")  # true is no int here
    return value


def text_of(value, where):
    require(type(value) is str and 0 < len(value) <= MAX_TEXT, "F", "%s is not a text of 1 to %d characters" % (where, MAX_TEXT))
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
    size = n.bit_length()  # n is odd or zero
    require("x" in value and (n == 0 or (size <= 53 and e >= -1074 and size + e <= 1024)), "F",
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


def projective(values):
    """The same as integers and one positive denominator, without an exponent: (x, ..., w) for the point (x / w, ...)."""
    integers, d, e = common(values)
    return tuple(n << max(e, 0) for n in integers) + (d << max(-e, 0),)


def length(values):
    """The bits of numbers together, exponents counted as they are."""
    return sum(abs(n).bit_length() + d.bit_length() + abs(e) for n, d, e in values)


def bits(integers):
    """The greatest number of bits of some integers."""
    return max((n.bit_length() for n in integers), default=0)
