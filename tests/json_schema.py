"""The part of JSON Schema (draft 2020-12) that docs/schema uses. A keyword that is not known is an error."""
import json
import re

NOTES = {"$schema", "$defs", "title", "description"}
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None), "integer": int,
         "number": (int, float)}


def is_of_type(value, name):
    return isinstance(value, TYPES[name]) and (name == "boolean" or not isinstance(value, bool))


def same(a, b):
    return type(a) is type(b) and a == b


class Schema:
    def __init__(self, top):
        self.top = top
        self.seen = set()  # places in the schema at which some value was right; "place=value" of enum and const

    def faults(self, value):
        """What is wrong with the value, in lines; nothing: it is valid."""
        faults, _, seen = self._check(self.top, "#", value, "")
        if not faults:
            self.seen |= seen
        return faults

    def _check(self, rule, place, value, at):
        """The faults, the keys of an object that were spoken of, and the places seen."""
        if isinstance(rule, bool):
            return ([] if rule else ["%s: nothing may be here" % at]), set(), {place}
        faults, keys, seen = [], set(), {place}

        def sub(inner, where, item=value, there=at):
            found, spoken, places = self._check(inner, where, item, there)
            faults.extend(found)
            seen.update(places)
            return spoken

        def tries(word):
            results = [self._check(inner, "%s/%s/%d" % (place, word, k), value, at) for k, inner in enumerate(rule[word])]
            right = [result for result in results if not result[0]]
            if not right or (word == "oneOf" and len(right) > 1):
                faults.extend(min(results, key=lambda r: len(r[0]))[0] or ["%s: fits more than one of %s" % (at, place)])
            for _, spoken, places in right:
                keys.update(spoken)
                seen.update(places)

        for word, given in rule.items():
            where = "%s/%s" % (place, word)
            if word == "$ref":
                target = self.top
                for step in given.split("/")[1:]:
                    target = target[step]
                keys |= sub(target, given)
            elif word == "type":
                if not any(is_of_type(value, name) for name in ([given] if isinstance(given, str) else given)):
                    faults.append("%s: %s is no %s" % (at, json.dumps(value)[:60], given))
            elif word in ("enum", "const"):
                if not any(same(value, one) for one in (given if word == "enum" else [given])):
                    faults.append("%s: %s is not of %s" % (at, json.dumps(value)[:60], json.dumps(given)))
                seen.add("%s=%s" % (place, json.dumps(value)))
            elif word == "required":
                faults += ["%s: %s is missing" % (at, key) for key in given if isinstance(value, dict) and key not in value]
            elif word == "properties":
                for key in given.keys() & value.keys() if isinstance(value, dict) else ():
                    keys.add(key)
                    sub(given[key], "%s/%s" % (where, key), value[key], "%s/%s" % (at, key))
            elif word == "items":
                for k, item in enumerate(value if isinstance(value, list) else ()):
                    sub(given, where, item, "%s/%d" % (at, k))
            elif word in ("minItems", "maxItems"):
                if isinstance(value, list) and (len(value) < given if word == "minItems" else len(value) > given):
                    faults.append("%s: %d items" % (at, len(value)))
            elif word == "minimum":
                if is_of_type(value, "number") and value < given:
                    faults.append("%s: %s is less than %s" % (at, value, given))
            elif word == "pattern":
                if isinstance(value, str) and not re.search(given, value):
                    faults.append("%s: %r is not like %s" % (at, value[:60], given))
            elif word == "allOf":
                for k, inner in enumerate(given):
                    keys |= sub(inner, "%s/%d" % (where, k))
            elif word in ("oneOf", "anyOf"):
                tries(word)
            elif word == "if":
                found, spoken, places = self._check(given, where, value, at)
                keys |= spoken if not found else set()
                branch = "else" if found else "then"
                keys |= sub(rule.get(branch, True), "%s/%s" % (place, branch))
            elif word not in NOTES | {"then", "else", "additionalProperties", "unevaluatedProperties"}:
                raise ValueError("%s: an unknown keyword" % where)
        for word in ("additionalProperties", "unevaluatedProperties"):  # when it is known what was spoken of
            if word in rule and isinstance(value, dict):
                spoken = keys if word[0] == "u" else rule.get("properties", {}).keys()
                for key in value.keys() - spoken:
                    sub(rule[word], "%s/%s" % (place, word), value[key], "%s/%s" % (at, key))
                    keys.add(key)
        return faults, keys, seen
