#!/usr/bin/env python3
"""check_contracts.py accepts good headers, and refuses each of their bad twins at its line."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_contracts

FRONT = "// All.\n#include <sunder/a.h>\n"
GOOD = """// A question.
#pragma once

#include <sunder/base/error.h>

namespace sunder {

enum class Kind { none };
std::string_view name_of(Kind);  // "none"
inline constexpr int most = int(7);

// The answer. Throws
// Error bad_value.
template <class T>
int f(const T& x,
      int y);
inline int f(int x) {
  return f(x, 0);
}

// Of two.
Found g(int a, const Options& options = {});

using Method = int(int);

// By scan.
Method f_by_scan;
extern template int f(const int&, int);

}  // namespace sunder
"""
TREE = {"sunder/sunder.h": FRONT, "sunder/a.h": GOOD, "sunder/b_internal.h": "// Throws Error.\n",
        "sunder/c_test.h": "// Throws Error.\n", "sunder/d.h": "int no_front_door();\n// None throws. No Error.\n"}

# name: (what is replaced in a.h, by what, the rule that refuses it, and at which lines)
BAD = {
    "no words": ("// By scan.\n", "", "C1", [26]),
    "words of another group": ("// By scan.\n", "// By scan.\n\n", "C1", [28]),
    "words within": ("// The answer. Throws\n// Error bad_value.\n", "", "C1", [13, 15]),
    "none of one with a default": ("// Of two.\n", "", "C1", [21]),
    "none behind": ('  // "none"', "", "C1", [9]),
    "an error that cannot be caught": ("#include <sunder/base/error.h>\n", "", "C2", [11]),
}


def findings_of(tree):
    with tempfile.TemporaryDirectory() as root:
        for path, text in tree.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                stream.write(text)
        return check_contracts.check(root)


class CheckContracts(unittest.TestCase):
    def test_accepts_good_headers(self):
        self.assertEqual(findings_of(TREE), ([], 5))

    def test_refuses_each_bad_twin(self):
        for name, (old, new, rule, lines) in BAD.items():
            with self.subTest(name):
                findings, _ = findings_of({**TREE, "sunder/a.h": GOOD.replace(old, new)})
                self.assertEqual([text[:text.index(rule) + 2] for text in findings],
                                 ["sunder/a.h:%d: %s" % (line, rule) for line in lines])

    def test_all_public_headers_are_read(self):
        findings, _ = findings_of({**TREE, "sunder/io/e.h": "#pragma once\n\n// It throws Error.\nint f();\n"})
        self.assertEqual([text[:text.index("C2") + 2] for text in findings], ["sunder/io/e.h:3: C2"])

    def test_every_front_door_is_included(self):
        doors = {"sunder/solid/line/polyhedron_line.h": "// Where.\nint polyhedron_line_by_scan(int);\n",
                 "sunder/planar/discs/discs_any.h": "// Any.\nint discs_any(\n    int);\n",
                 "sunder/scene/follower.h": "// Which of many\n// meet?\nclass Follower;\n"}
        others = {"sunder/solid/line/line_search.h": "// Where?\nclass LineSearch;\n",
                  "sunder/solid/search/tilt_direction.h": "int settle(int);\n",
                  "sunder/solid/hull/polygon.h": "int polygon(int);\n",
                  "sunder/scene/chains.h": "// Work in chains.\nint run(int);  // or not?\n"}
        findings, _ = findings_of({**TREE, **doors, **others})
        self.assertEqual(sorted(text[:text.index(":1: C3")] for text in findings), sorted(doors))

    def test_a_requirement_has_no_effect(self):
        good = "  SUNDER_REQUIRE(a <= b && c != d && is_set(e) && e == f);\n"
        for effect in ("++n < 3", "set_exponent(b)", "(x = y)", "v.push_back(1)"):
            with self.subTest(effect):
                findings, _ = findings_of({**TREE, "sunder/x.cpp": good + "  SUNDER_REQUIRE(%s);\n" % effect})
                self.assertEqual([text[:text.index("C4") + 2] for text in findings], ["sunder/x.cpp:2: C4"])
        self.assertEqual(findings_of({**TREE, "sunder/x.cpp": good})[0], [])


if __name__ == "__main__":
    unittest.main()
