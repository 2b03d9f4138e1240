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
    """A schema, read once into rules that look at values."""

    def __init__(self, top):
        self.top, self.rules = top, {}  # by place
        self.first = self.rule(top, "#")
        self.seen = set()  # places in the schema at which some value was right; "place=value" of enum and const

    def rule(self, rule, place):
        return self.rules.get(place) or Rule(self, rule, place)

    def faults(self, value):
        """What is wrong with the value, in lines; nothing: it is valid."""
        found = Found()
        self.first.look(value, (), found)
        self.seen |= set() if found.faults else found.seen
        return found.faults

    def is_right(self, value):
        """The same in short, and nothing is seen."""
        return self.first.tried(value) is not None


class Wrong(Exception):
    """The first fault, where no more is asked for."""


class Found:
    """Faults, and the places of the schema that were used."""

    def __init__(self, is_brief=False):
        self.faults, self.seen, self.is_brief = [], set(), is_brief

    def fault(self, at, text):
        if self.is_brief:
            raise Wrong
        self.faults.append("%s: %s" % ("".join("/%s" % step for step in at), text))


class Rule:
    """One rule of a schema: a check for each keyword, which is told a value, the way there and what was found, and tells
    the keys that it spoke of."""

    def __init__(self, schema, rule, place):
        schema.rules[place] = self  # before its parts, which may refer to it
        self.schema, self.place, self.rest = schema, place, None
        if isinstance(rule, bool):
            self.checks = [] if rule else [lambda value, at, found: found.fault(at, "may not be here")]
            return
        self.checks = [getattr(self, "see_" + word.strip("$"))(said, rule) for word, said in rule.items()
                       if word not in SAID_ELSEWHERE]
        if "unevaluatedProperties" in rule:
            self.rest = self.part(rule["unevaluatedProperties"], "unevaluatedProperties")

    def part(self, rule, word):
        return self.schema.rule(rule, "%s/%s" % (self.place, word))

    def look(self, value, at, found):
        found.seen.add(self.place)
        keys = set()
        for check in self.checks:
            keys.update(check(value, at, found) or ())
        if self.rest and isinstance(value, dict):
            keys.update(others(self.rest, value, at, found, keys))
        return keys

    def tried(self, value):
        """What was found, and the keys, if the value is right by this rule; else None."""
        found = Found(True)
        try:
            return found, self.look(value, (), found)
        except Wrong:
            return None

    def see_ref(self, name, _):
        rule = self.schema.top
        for step in name.split("/")[1:]:
            rule = rule[step]
        return self.schema.rule(rule, name).look

    def see_type(self, names, _):
        names = [names] if isinstance(names, str) else names

        def check(value, at, found):
            if not any(is_of_type(value, name) for name in names):
                found.fault(at, "is no %s" % " or ".join(names))
        return check

    def see_enum(self, values, _):
        places = {(type(value), value): "%s=%s" % (self.place, json.dumps(value)) for value in values}

        def check(value, at, found):
            if not isinstance(value, (dict, list)) and (type(value), value) in places:
                found.seen.add(places[type(value), value])
            else:
                found.fault(at, "is none of %s" % values)
        return check

    def see_const(self, value, rule):
        return self.see_enum([value], rule)

    def see_required(self, keys, _):
        def check(value, at, found):
            for key in keys if isinstance(value, dict) else ():
                if key not in value:
                    found.fault(at, key + " is missing")
        return check

    def see_properties(self, rules, _):
        rules = {key: self.part(rule, "properties/" + key) for key, rule in rules.items()}

        def check(value, at, found):
            known = [key for key in value if key in rules] if isinstance(value, dict) else ()
            for key in known:
                rules[key].look(value[key], (*at, key), found)
            return known
        return check

    def see_additionalProperties(self, rule, whole):
        rule, known = self.part(rule, "additionalProperties"), whole.get("properties", {}).keys()

        def check(value, at, found):
            return others(rule, value, at, found, known) if isinstance(value, dict) else ()
        return check

    def see_items(self, rule, _):
        rule = self.part(rule, "items")

        def check(value, at, found):
            for k, item in enumerate(value if isinstance(value, list) else ()):
                rule.look(item, (*at, k), found)
        return check

    def see_minItems(self, least, _):
        return bound(list, lambda value: len(value) >= least, "has less than %d items" % least)

    def see_maxItems(self, most, _):
        return bound(list, lambda value: len(value) <= most, "has more than %d items" % most)

    def see_minimum(self, least, _):
        return bound((int, float), lambda value: isinstance(value, bool) or value >= least, "is less than %s" % least)

    def see_pattern(self, pattern, _):
        return bound(str, re.compile(pattern).search, "is not like " + pattern)

    def see_allOf(self, rules, _):
        rules = [self.part(rule, "allOf/%d" % k) for k, rule in enumerate(rules)]
        return lambda value, at, found: set().union(*(rule.look(value, at, found) for rule in rules))

    def see_oneOf(self, rules, _):
        rules = [self.part(rule, "oneOf/%d" % k) for k, rule in enumerate(rules)]

        def check(value, at, found):
            right = [tried for tried in (rule.tried(value) for rule in rules) if tried]
            if len(right) > 1:
                found.fault(at, "fits more than one of " + self.place)
            if right:
                found.seen |= right[0][0].seen
                return right[0][1]
            if found.is_brief:
                raise Wrong
            looks = [(Found(), rule) for rule in rules]
            keys = [rule.look(value, at, one) for one, rule in looks]
            best = min(range(len(rules)), key=lambda k: len(looks[k][0].faults))  # which was meant, most likely
            found.faults += looks[best][0].faults
            return keys[best]
        return check

    def see_if(self, rule, whole):
        asked = self.part(rule, "if")
        parts = {word: self.part(whole.get(word, True), word) for word in ("then", "else")}

        def check(value, at, found):
            tried = asked.tried(value)
            return parts["then" if tried else "else"].look(value, at, found) | (tried[1] if tried else set())
        return check


def others(rule, value, at, found, known):
    """Looks by a rule at the members that are not known; their keys."""
    keys = [key for key in value if key not in known]
    for key in keys:
        rule.look(value[key], (*at, key), found)
    return keys


def bound(kind, fits, text):
    """A check for values of a kind alone."""
    def check(value, at, found):
        if isinstance(value, kind) and not fits(value):
            found.fault(at, text)
    return check
