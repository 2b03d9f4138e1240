"""A certificate file in other units: all lengths times a power of two, and bodies and rows in units of their own. It says
the same, so checkers must say the same of it: what mixes units up is seen."""
import json
import re

from sunder_verify.questions import QUESTIONS

POWERS = (-40, -3, -1, 0, 1, 2, 7)
PLACES = {"point", "from_a", "to_b", "first", "last", "as_good", "points", "vertices", "spanned_by", "least", "most"}
PLACED = ("a", "b", "to_a", "to_b", "of", "half_spaces")  # statements that name bodies where they are


def times(value, k):
    """A number times 2^k; of a list or an object each number in it. An index stays: `to_b` is a point, or a body. Some
    numbers that are doubles are written so then."""
    if isinstance(value, int):
        return value
    if isinstance(value, list):
        return [times(one, k) for one in value]
    if isinstance(value, dict):
        return {key: times(one, k) for key, one in value.items()}
    if "p" in value:
        digits, exponent = value.split("p")
        return "%sp%+d" % (digits, int(exponent) + k)
    above, _, below = value.partition("/")
    above, below = int(above), int(below or 1)
    if k % 2 and below & (below - 1) == 0:
        return "%s0x%xp%+d" % ("-" * (above < 0), abs(above), k + 1 - below.bit_length())
    return "%d/%d" % (above << max(k, 0), below << max(-k, 0))


def each_by(pairs, power_of):
    return [[k, times(number, power_of(k))] for k, number in pairs]


class Units:
    def __init__(self, top, dice):
        self.top, self.dice, self.all = top, dice, dice.choice(POWERS)
        self.frames, self.rows = {}, {}  # of each entry that may have images, and of rows, powers beside that of all
        placed = {one[key] for one in top["statements"] for key in PLACED if isinstance(one.get(key), int)}
        placed.update(k for one in top["statements"] for k in one.get("members", ()))
        are_tied = any("as_meshes" in one for one in top["statements"])  # meshes and bodies are placed alike
        for name in ("bodies", "polytopes", "meshes"):
            for k, entry in enumerate(top["tables"].get(name, ())):
                of, is_free = entry.get("of"), k not in placed and not are_tied
                self.frames[name, k] = dice.choice(POWERS) if is_free and of is None else self.frames.get((name, of), 0)
                self.rows[name, k] = dice.choice(POWERS) if of is None else self.rows[name, of]

    def entry(self, name, k, entry):
        frame, row = self.frames[name, k], self.rows[name, k]
        if "of" in entry:
            return {**entry, "linear": times(entry["linear"], -frame), "translation": times(entry["translation"], self.all)}
        result = dict(entry)
        for key in ("points", "ways", "ellipsoid"):
            if key in entry:
                result[key] = times(entry[key], self.all + frame)
        for key in ("radius", "cylinder", "cone"):
            if key in entry:
                result[key] = times(entry[key], self.all)
        if "half_spaces" in entry:
            result["half_spaces"] = [times(given[:-1], row) + [times(given[-1], row + self.all + frame)]
                                     for given in entry["half_spaces"]]
        return result

    def table(self, name, entries):
        if name in ("bodies", "polytopes", "meshes"):
            return [self.entry(name, k, entry) for k, entry in enumerate(entries)]
        if name != "half_planes":
            return times(entries, self.all)
        result = []
        for k, given in enumerate(entries):
            is_arrow = len(given) == 4
            self.rows[name, k] = row = self.all if is_arrow else self.dice.choice(POWERS)
            result.append(times(given, row) if is_arrow else times(given[:2], row) + [times(given[2], row + self.all)])
        return result

    def claim(self, claim, about, one, subject):
        """Of what that key of the statement names."""
        result, index = dict(claim), one.get(subject)
        about = "bodies" if one["question"].startswith("mesh_body") and subject == "b" else about
        frame = self.frames.get((about, index), 0) if isinstance(index, int) else 0
        if "from" in claim or "at" in claim:
            result.update({key: times(claim[key], self.all + frame) for key in ("from", "at") if key in claim})
        if "ends" in claim:
            result["ends"] = [end and [times(end[0], self.all), end[1]] for end in claim["ends"]]
        if "differences" in claim:
            result["differences"] = [[self.corner(end, one[key]) for end, key in zip(corner, "ab")]
                                     for corner in claim["differences"]]
        if "cells" in claim:
            result["cells"] = times(claim["cells"], self.all)
        if "planes" in claim:  # each in a unit of its own
            units = [self.dice.choice(POWERS) for _ in claim["planes"]]
            result["planes"] = [times(plane[:3], k) + [times(plane[3], k + self.all)]
                                for plane, k in zip(claim["planes"], units)]
        if "weights" in claim and subject == "half_planes":
            result["weights"] = each_by(claim["weights"], lambda k: -self.rows[about, k])
        if "multipliers" in claim:
            result["multipliers"] = each_by(claim["multipliers"], lambda k: -self.rows[about, index])
        for side in "ab" if about == "polytopes" else ():
            if "of_" + side in claim:
                result["of_" + side] = times_all(claim["of_" + side], -self.frames[about, one[side]] - self.rows[about, one[side]])
            if "planes_" + side in claim:
                self.planes(result, claim, one[side], side)
        return result

    def corner(self, end, body):
        """A point of a body, as `surrounds` names it."""
        powers = {"point": self.all, "from": self.all + self.frames["bodies", body]}
        return {key: times(one, powers[key]) if key in powers else one for key, one in end.items()} if type(end) is dict else end

    def planes(self, result, claim, k, side):
        """Half-spaces around a polytope, each in a unit of its own, and their multipliers."""
        entry, frame = self.top["tables"]["polytopes"][k], self.frames["polytopes", k]
        width, given = self.top["tables"]["polytopes"][entry.get("of", k)]["dimension"] + 1, claim["planes_" + side]
        units = [self.dice.choice(POWERS) for _ in given[::width]]
        row = self.rows["polytopes", k]
        result["planes_" + side] = [times(x, units[c // width] + (self.all + frame) * (c % width == width - 1))
                                    for c, x in enumerate(given)]
        result["by_" + side] = each_by(claim["by_" + side], lambda m: -frame - (units[m] if units else row))

    def statement(self, one):
        about, _, verdicts = QUESTIONS[one["question"]]
        result = {key: times(value, self.all) if key in PLACES else value for key, value in one.items()}
        for key in ("area_from", "area_to"):
            if key in one:
                result[key] = times(one[key], 2 * self.all)
        if "plane" in one:
            result["plane"] = one["plane"][:3] + times(one["plane"][3:], self.all)
        needed = [claim.split() for claim in verdicts[one["verdict"]].split(", ")]
        result["claims"] = [self.claim(claim, about, one, subject) for claim, (_, subject, *_) in zip(one["claims"], needed)]
        return result


def times_all(pairs, k):
    return each_by(pairs, lambda _: k)


def in_other_units(top, dice):
    """Requires that the form of the file is right. None: it mixes edges and axes, which do not have one unit; or it has
    doubles that are none in other units."""
    is_mixed = any(len(polygon) < 3 for polygon in top["tables"].get("convex_polygons", ()))
    if is_mixed or re.search(r"p[+-]?(9\d\d|\d{4})", json.dumps(top["tables"])):
        return None
    units = Units(top, dice)
    tables = {name: units.table(name, entries) for name, entries in top["tables"].items()}
    return {**top, "tables": tables, "statements": [units.statement(one) for one in top["statements"]]}
