"""Values inside of JSON, and what may be said of them: see the first lines of cli/calls_test.py."""
import json
import operator
import re


class Wrong(Exception):
    """The data are not as the format is."""


# Values inside of JSON.

STEP_OF_PATH = re.compile(r"\.?([A-Za-z0-9_ /-]+)|\[(-?\d+)\]|\[(\*)\]|\[(\w+)=")


def steps_of(path):
    steps, at = [], 0
    while at < len(path):
        match = STEP_OF_PATH.match(path, at)
        if not match:
            raise Wrong("the path '%s' is none from '%s' on" % (path, path[at:]))
        name, index, every, key = match.groups()
        at = match.end()
        if key is not None:
            value, at = json.JSONDecoder().raw_decode(path, at)
            if path[at:at + 1] != "]":
                raise Wrong("the path '%s' has no ] before '%s'" % (path, path[at:]))
            steps.append((int(key) if key.isdigit() else key, value))
            at += 1
        else:
            steps.append(name if name is not None else int(index) if index is not None else every)
    return steps


def same(a, b):
    """Equal as JSON: true is not 1, but 1 is 1.0."""
    if isinstance(a, bool) or isinstance(b, bool):
        return a is b
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[k], b[k]) for k in a)
    return a == b


def values_at(value, steps):
    """All values there: one, or as many as [*] has elements; none where a key or an element is missing."""
    if not steps:
        return [value]
    step, rest = steps[0], steps[1:]
    if isinstance(step, tuple):
        if not isinstance(value, list):
            return []
        return values_at([v for v in value if any(same(x, step[1]) for x in values_at(v, [step[0]]))], rest)
    if step == "*":
        elements = value.values() if isinstance(value, dict) else value if isinstance(value, list) else []
        return [found for v in elements for found in values_at(v, rest)]
    if step == "length" and isinstance(value, (list, str, dict)) and not (isinstance(value, dict) and "length" in value):
        return values_at(len(value), rest)
    if isinstance(step, int) and isinstance(value, list):
        return values_at(value[step], rest) if -len(value) <= step < len(value) else []
    return values_at(value[step], rest) if isinstance(value, dict) and step in value else []


def found_at(value, path):
    """All values at a path; before .values, a list of them."""
    path, collected, rest = path.partition(".values")
    values = values_at(value, steps_of(path))
    return values_at(values, steps_of(rest)) if collected else values


FACT = re.compile(r"^(.*?) (!?=|[<>]=?|has|starts|ends|is) (.*)$|^(.*) (absent|present)$", re.S)
ORDERS = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
TYPES = {"number": (int, float), "text": str, "list": list, "object": dict, "true or false": bool, "null": type(None)}


def is_so(found, how, value):
    if how in ORDERS:
        return not isinstance(found, bool) and isinstance(found, (int, float)) and ORDERS[how](found, value)
    if how == "has":
        if isinstance(found, list) and any(isinstance(entry, str) and value in entry for entry in found):
            return True
        return value in (found if isinstance(found, str) else json.dumps(found, ensure_ascii=False))
    if how == "starts":
        return isinstance(found, str) and found.startswith(value)
    if how == "ends":
        return isinstance(found, str) and found.endswith(value)
    if how == "is":
        return isinstance(found, TYPES[value]) and (value == "true or false" or not isinstance(found, bool))
    return same(found, value) == (how == "=")


def no_nan(word):
    raise ValueError("%s is not JSON" % word)


def read_json(text):
    return json.loads(text, parse_constant=no_nan)


def read_lines(text):
    return [read_json(line) for line in text.splitlines()]
