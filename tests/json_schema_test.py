#!/usr/bin/env python3
"""json_schema.py takes what is right by each keyword, and refuses what is not."""
import os
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from json_schema import Schema  # noqa: E402

TWO = {"$defs": {"a": {"properties": {"a": {"type": "integer"}}}}}

# A schema, what it takes, what it refuses.
ROWS = [
    (True, [1, None, {}], []),
    (False, [], [1, None, {}]),
    ({"type": "integer"}, [0, -1], [0.5, 1.0, True, "1", None, [], {}]),
    ({"type": "number"}, [0, 1.5], [False, "1"]),
    ({"type": "boolean"}, [True, False], [0, 1, None]),
    ({"type": ["string", "null"]}, ["", None], [0, [], {}]),
    ({"enum": [1, "a", None]}, [1, "a", None], [True, 1.0, "b", 0]),
    ({"const": True}, [True], [1, "true"]),
    ({"required": ["a"]}, [{"a": 1, "b": 2}, 7], [{}, {"b": 1}]),
    ({"properties": {"a": {"type": "null"}}}, [{"a": None}, {"b": 1}, 7], [{"a": 1}]),
    ({"properties": {"a": {}}, "additionalProperties": False}, [{}, {"a": 1}, 7], [{"b": 1}, {"a": 1, "b": 1}]),
    ({"additionalProperties": {"type": "null"}}, [{}, {"a": None}], [{"a": 1}]),
    ({"items": {"type": "null"}}, [[], [None], 7], [[1], [None, 1]]),
    ({"minItems": 1, "maxItems": 2}, [[1], [1, 1], "", 7], [[], [1, 1, 1]]),
    ({"minimum": 1}, [1, 1.5, "0"], [0, 0.5]),
    ({"pattern": "^[0-9]+$"}, ["12", 7], ["", "1a"]),
    ({"allOf": [{"minimum": 1}, {"type": "integer"}]}, [1], [0, 1.5]),
    ({"oneOf": [{"minimum": 1}, {"type": "integer"}]}, [1.5, 0], [1, 0.5]),
    ({"if": {"required": ["a"]}, "then": {"required": ["b"]}, "else": {"required": ["c"]}},
     [{"a": 1, "b": 1}, {"c": 1}], [{"a": 1}, {"b": 1}]),
    ({"if": {"minimum": 1}, "then": {"type": "integer"}}, [1, 0.5], [1.5]),
    (TWO | {"allOf": [{"$ref": "#/$defs/a"}], "properties": {"b": {}}, "unevaluatedProperties": False},
     [{}, {"a": 1}, {"a": 1, "b": 2}], [{"c": 1}, {"a": "1"}]),
    (TWO | {"oneOf": [{"$ref": "#/$defs/a", "required": ["a"]}, {"required": ["b"], "properties": {"b": {}}}],
            "unevaluatedProperties": False}, [{"a": 1}, {"b": 1}], [{"a": 1, "b": 1}, {}, {"a": 1, "c": 1}]),
    (TWO | {"if": {"$ref": "#/$defs/a"}, "else": {"properties": {"b": {}}}, "unevaluatedProperties": False},
     [{"a": 1}], [{"b": 1}, {"a": "1"}, {"a": "1", "b": 1}]),
]


class Keywords(unittest.TestCase):
    def test_each_row(self):
        for schema, right, wrong in ROWS:
            for value in right:
                self.assertEqual(Schema(schema).faults(value), [], (schema, value))
            for value in wrong:
                self.assertTrue(Schema(schema).faults(value), (schema, value))

    def test_unknown_keywords_are_errors(self):
        with self.assertRaises(AttributeError):
            Schema({"anything": 1}).faults(1)
        with self.assertRaises(KeyError):
            Schema({"$ref": "#/$defs/none"}).faults(1)

    def test_faults_name_the_place(self):
        schema = Schema({"properties": {"a": {"items": {"type": "null"}}}})
        self.assertEqual(schema.faults({"a": [None, 1]}), ["/a/1: is no null"])

    def test_what_was_seen(self):
        schema = Schema({"oneOf": [{"enum": [1, 2]}, {"type": "string"}]})
        schema.faults(None)
        self.assertEqual(schema.seen, set())
        schema.faults(2)
        self.assertEqual(schema.seen, {"#", "#/oneOf/0", "#/oneOf/0=2"})


if __name__ == "__main__":
    unittest.main()
