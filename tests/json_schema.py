"""The part of JSON Schema (draft 2020-12) that docs/schema uses; but 1.0 is no integer here, and is not 1.

A keyword that is not known is an error.
"""
import json
import re

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None), "integer": int,
         "number": (int, float)}
SAID_ELSEWHERE = {"$schema", "$defs", "title", "description", "then", "else", "unevaluatedProperties"}


def is_of_type(value, name):
    return isinstance(value, TYPES[name]) and (name == "boolean" or not isinstance(value, bool))


class Schema:
    def __init__(self, top):
        self.top = top
        self.seen = set()  # places in the schema at which some value was right; "place=value" of enum and const

    def faults(self, value):
        """What is wrong with the value, in lines; nothing: it is valid."""
        result = Look(self.top, self.top, "#", value, "")
        self.seen |= set() if result.faults else result.seen
        return result.faults


class Look:
    """At a value by one rule: its faults, the keys that were spoken of, and the places of the schema that were used."""

    def __init__(self, top, rule, place, value, at):
        self.top, self.place, self.value, self.at = top, place, value, at
        self.faults, self.keys, self.seen = [], set(), {place}
        if isinstance(rule, bool):
            self.expect(rule, "may not be here")
            return
        for word in rule.keys() - SAID_ELSEWHERE:
            getattr(self, "see_" + word.strip("$"))(rule[word], rule)
        if "unevaluatedProperties" in rule and isinstance(value, dict):
            self.see_others(rule["unevaluatedProperties"], "unevaluatedProperties", self.keys)

    def expect(self, is_right, text):
        self.faults += [] if is_right else ["%s: %s" % (self.at, text)]

    def look(self, rule, word, *step):
        """The same by another rule: at this value, or at what is at the step of it."""
        value, at = (self.value[step[0]], "%s/%s" % (self.at, step[0])) if step else (self.value, self.at)
        return Look(self.top, rule, word if word[0] == "#" else "%s/%s" % (self.place, word), value, at)

    def take(self, other, keys=()):
        self.faults += other.faults
        self.seen |= other.seen
        self.keys |= set(keys)

    def see_ref(self, name, _):
        rule = self.top
        for step in name.split("/")[1:]:
            rule = rule[step]
        other = self.look(rule, name)
        self.take(other, other.keys)

    def see_type(self, names, _):
        names = [names] if isinstance(names, str) else names
        self.expect(any(is_of_type(self.value, name) for name in names), "is no %s" % " or ".join(names))

    def see_enum(self, values, _):
        is_one = any(type(self.value) is type(one) and self.value == one for one in values)
        self.expect(is_one, "is none of %s" % values)
        self.seen.add("%s=%s" % (self.place, json.dumps(self.value)))

    def see_const(self, value, rule):
        self.see_enum([value], rule)

    def see_required(self, keys, _):
        for key in keys if isinstance(self.value, dict) else ():
            self.expect(key in self.value, key + " is missing")

    def see_properties(self, rules, _):
        for key in rules.keys() & self.value.keys() if isinstance(self.value, dict) else ():
            self.take(self.look(rules[key], "properties/" + key, key), {key})

    def see_others(self, rule, word, known):
        for key in self.value.keys() - known if isinstance(self.value, dict) else ():
            self.take(self.look(rule, word, key), {key})

    def see_additionalProperties(self, rule, whole):
        self.see_others(rule, "additionalProperties", whole.get("properties", {}).keys())

    def see_items(self, rule, _):
        for k in range(len(self.value) if isinstance(self.value, list) else 0):
            self.take(self.look(rule, "items", k))

    def see_minItems(self, least, _):
        self.expect(not isinstance(self.value, list) or len(self.value) >= least, "has less than %d items" % least)

    def see_maxItems(self, most, _):
        self.expect(not isinstance(self.value, list) or len(self.value) <= most, "has more than %d items" % most)

    def see_minimum(self, least, _):
        self.expect(not is_of_type(self.value, "number") or self.value >= least, "is less than %s" % least)

    def see_pattern(self, pattern, _):
        self.expect(not isinstance(self.value, str) or re.search(pattern, self.value), "is not like " + pattern)

    def see_allOf(self, rules, _):
        for k, rule in enumerate(rules):
            other = self.look(rule, "allOf/%d" % k)
            self.take(other, other.keys)

    def see_oneOf(self, rules, _):
        others = [self.look(rule, "oneOf/%d" % k) for k, rule in enumerate(rules)]
        right = [other for other in others if not other.faults]
        self.expect(len(right) < 2, "fits more than one of " + self.place)
        best = (right or sorted(others, key=lambda other: len(other.faults)))[0]  # which was meant, most likely
        self.take(best, best.keys)

    def see_if(self, rule, whole):
        asked = self.look(rule, "if")
        word = "else" if asked.faults else "then"
        other = self.look(whole.get(word, True), word)
        self.take(other, other.keys if asked.faults else other.keys | asked.keys)
