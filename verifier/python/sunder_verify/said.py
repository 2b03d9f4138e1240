"""What somebody says that entries are, in words: nothing of it is proved, and sentences say so (docs/claims.md, "Said").

Words are those of the twin (verifier/cpp/said.cpp).
"""
import re

from .reader import (LIST, MOST_NUMBER, OBJECT, anything, double, form, index, list_of, members, numbers, row_of,
                     text_of)
from .sentences import in_quotes, shown

MOST_STEPS = 8  # of one description
MOST = 3        # texts, and values of joints, that are shown


def named(value, where, read):
    return in_quotes(read["inputs"][index(value, len(read["inputs"]), where)][0])


def or_none(shape, words):
    return lambda value, where, read: words % shape(value, where, read) if value is not None else ""


def some(those):
    return ", ".join(those[:MOST]) + (" and %d more" % (len(those) - MOST) if len(those) > MOST else "")


def texts(value, where, read):
    return some([*map(in_quotes, list_of(text_of)(value, where))])


def whole(value, where, read):
    return index(value, MOST_NUMBER + 1, where)


def positive(value, where, read):
    return index(value, MOST_NUMBER + 1, where, 1)


def reals(count=None):
    def read_reals(value, where, read):
        numbers(value, count or len(LIST(value, where)), double, where)
        return ", ".join(map(shown, value))
    return read_reals


def joints(value, where, read):
    list_of(row_of(text_of, double), lambda those, _: those, " is empty")(value, where, read)
    return some(["%s %s" % (in_quotes(name), shown(number)) for name, number in value])


def reasons(value, where, read):
    those = list_of(row_of(text_of, positive))(value, where, read)
    form(sum(n for _, n in those) == len(read.get("except", ())) > 0, where + " do not sum to the pairs not asked about")
    return some(["%d %s" % (n, in_quotes(text)) for text, n in those])


SHAPES = {
    "input": named, "part": or_none(lambda *told: in_quotes(text_of(*told)), "part %s of "), "of": OBJECT,
    "without": lambda *told: ", without " * bool(told[0]) + texts(*told), "changes": texts, "by": reals(),
    "frame": reals(9), **dict.fromkeys(("text", "axis", "unit", "system"), lambda *told: in_quotes(text_of(*told))),
    "from": or_none(named, " of %s"), "row": or_none(whole, " of row %d"), "values": joints, "pairs": reasons,
}
SOURCES = {"vertices": "all vertices", "triangles": "all triangles", "points": "all points", "half_spaces": "all half-spaces", "lines": "all lines",
           "centre_lines": "the centre lines of all tracks", "polygons": "all polygons", "circles": "all circles",
           "boxes": "all boxes", "half_planes": "all half-planes", "shape": "the shape"}
DESCRIPTIONS = {  # in words, of the members that they name; those that begin with a comma are steps, and have `of`
    **{kind: words + " of {part}{input}{without}" for kind, words in SOURCES.items()},
    "given": "what is given as {text}",
    "hull": ", which is replaced by its convex hull",
    "scaled": ", times {by}",
    "unit": ", in {unit}",
    "projected": ", projected onto the frame {frame}",
    "dropped": ", with {axis} dropped",
    "radius": ", with a radius that is given beside it",
    "mended": ", mended: {changes}",
    "system": ", in the coordinate system {system}",
}
NOTES = {  # of statements
    "joint_values": "; the joint values{row}{from} are said to be {values}",
    "allowed": "; the pairs not asked about are said to be allowed: {pairs}",
}


def words_of(kinds, value, where, read):
    kind = OBJECT(value, where).get("is")
    form(type(kind) is str and kind in kinds, where + ".is is none that is known")
    words = kinds[kind]
    names = re.findall("{(.*?)}", words) + ["of"] * words.startswith(",")
    return words.format(**members(value, {"is": anything, **{name: SHAPES[name] for name in names}}, where, dict(read)))


def description(value, where, read):
    """What it is made of, then what has become of that, from the first step to the last."""
    words, value = [], OBJECT(value, where)
    while value is not None:
        form(len(words) < MOST_STEPS, where + " has more than %d steps" % (MOST_STEPS - 1))
        words.append(words_of(DESCRIPTIONS, value, where, read))
        value, where = value.get("of"), where + ".of"
    return "".join(reversed(words))


def notes(value, where, read):
    """Of a statement."""
    return "".join(list_of(lambda *told: words_of(NOTES, *told))(value, where, read))


def of_tables(value, where, read):
    """Of tables of rows: lists of how many entries are said to be what. In words, by table."""
    sizes, result = read["tables"]["sizes"], {}
    for name, those in OBJECT(value, where).items():
        place = "%s.%s" % (where, name)
        form(name in sizes and name not in ("bodies", "polytopes", "meshes"), place + " is of no table of rows that the file has")
        parts = list_of(row_of(positive, description))(those, place, read)
        form(sum(n for n, _ in parts) == sizes[name] and parts, place + " does not sum to the entries")
        words = ["%d: %s" % part if len(parts) > 1 else part[1] for part in map(tuple, parts)]
        result[name] = "; these are said to be made of " + some(words)
    return result
