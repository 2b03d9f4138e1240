"""Reads certificate files of version 3: JSON, numbers, and what has a wrong form (docs/claims.md, "The file").

A number is kept as (n, d, e), meaning n / d * 2^e with d > 0. Tables are kept as multiples of one power of two.
"""
import itertools
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


def form(condition, reason):
    """What every file must be like, whatever it states."""
    require(condition, "F", reason)


class Steps:
    """How much work is left of what a file of its size may take: docs/claims.md, "Limits"."""

    def __init__(self, size=None):
        self.most = self.left = None if size is None else 300 * max(size, 1000000)

    def take(self, looks, a, b):
        """So many looks at a number of a bits and one of b bits."""
        if self.left is not None:
            self.left -= looks * (16 + (a // 64 + 1) * (b // 64 + 1))
            if self.left < 0:
                raise Unreadable("checking it takes more than %d steps, the limit for a file of its size; "
                                 "give --no-limit to check it all the same" % self.most)


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
        runs = BRACKETS.findall(STRING.sub("", text))
        levels = itertools.accumulate(len(run) if run[0] in "[{" else -len(run) for run in runs)
        if max(levels, default=0) > MAX_DEPTH:
            raise Unreadable("nested too deeply; a certificate needs 7 levels")
        value = json.loads(text, object_pairs_hook=make_object, parse_float=make_float, parse_int=make_int,
                           parse_constant=make_float)
    except json.JSONDecodeError as error:
        raise Unreadable("line %d, column %d: %s; write the file again" % (error.lineno, error.colno, error.msg))
    except UnicodeError:
        raise Unreadable("not UTF-8 text; write the file again")
    if any(escape.group(1) for escape in ESCAPE.finditer(text)):
        raise Unreadable("half a surrogate pair; write the file again")
    form(not repeated, "an object has a key twice")
    return value


# ---- The form. A shape reads a value: it is told the value, its place, and, by name, what has been read before.

def anything(value, where, read=None):
    return value


def typed(kind, words):
    def read_typed(value, where, read=None):
        form(type(value) is kind, where + words)
        return value
    return read_typed


LIST, OBJECT = typed(list, " is not a list"), typed(dict, " is not an object")


def members(item, shapes, where, read=None, optional=()):
    """Reads an object that has these members, each of its shape, into `read`; some may be missing."""
    read = {} if read is None else read
    for key in OBJECT(item, where or "the file"):
        form(key in shapes, "%s has %s, which means nothing" % (where or "the file", json.dumps(key)[:60]))
    for key in shapes:
        form(key in item or key in optional, "%s has no %s" % (where or "the file", key))
    for key, shape in shapes.items():
        read[key] = shape(item[key], "%s.%s" % (where, key) if where else key, read) if key in item else optional[key]
    return read


def list_of(shape, fits=None, words=""):
    """Lists of that shape which, as read, fit: told the list and what has been read before."""
    def read_list(value, where, read=None):
        result = [shape(item, "%s[%d]" % (where, k), read) for k, item in enumerate(LIST(value, where))]
        form(fits is None or fits(result, read), where + words)
        return result
    return read_list


def row_of(*shapes):
    """Lists of so many entries, each of its shape."""
    def read_row(value, where, read=None):
        form(type(value) is list and len(value) == len(shapes), "%s is not a list of %d" % (where, len(shapes)))
        return [shape(item, where + " entry", read) for shape, item in zip(shapes, value)]
    return read_row


def text_of(value, where, read=None):
    is_text = type(value) is str and 0 < len(value) <= MAX_TEXT
    form(is_text, "%s is not a text of 1 to %d characters" % (where, MAX_TEXT))
    return value


def index(value, size, where, least=0):
    form(type(value) is int and least <= value < size, where + " is not an index in range")  # true is no int here
    return value


# ---- Numbers.

def number(value, where, read=None):
    form(type(value) is str and len(value) <= MAX_CHARACTERS, where + " is not a number as a string")
    match = HEXADECIMAL.fullmatch(value)
    if match:
        sign, whole, fraction, exponent = match.groups(default="")
        n, e = int(sign + whole + fraction, 16), int(exponent)
        form(abs(e) <= MAX_EXPONENT, where + " has too large an exponent")
        zeros = (n & -n).bit_length() - 1 if n else 0
        return n >> zeros, 1, e - 4 * len(fraction) + zeros
    match = DECIMAL.fullmatch(value)
    form(match, where + " is not a number of one of the three forms")
    n, d = int(match.group(1)), int(match.group(2) or 1)
    form(d != 0, where + " has denominator zero")
    return n, d, 0


def double(value, where, read=None):
    n, d, e = number(value, where)
    size = n.bit_length()  # n is odd or zero
    form("x" in value and (n == 0 or (size <= 53 and e >= -1074 and size + e <= 1024)),
         where + " is not a hexadecimal double")
    return n, d, e if n else 0


def numbers(value, count, read_number, where):
    form(type(value) is list and len(value) == count, "%s is not a list of %d" % (where, count))
    return [read_number(item, where) for item in value]


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


def projective(values, unit=0):
    """(x, ..., w), integers with w > 0, for the point (x / w, ...) in units of a power of two."""
    integers, d, e = common([(n, d, k - unit) for n, d, k in values])
    return tuple(n << max(e, 0) for n in integers) + (d << max(-e, 0),)


def length(values):
    """The bits of numbers together, exponents counted as they are."""
    return sum(abs(n).bit_length() + d.bit_length() + abs(e) for n, d, e in values)


def bits(integers):
    """The greatest number of bits of some integers."""
    return max((n.bit_length() for n in integers), default=0)
