#!/usr/bin/env python3
"""check_layers.py accepts a good tree, and refuses each of its bad twins for the right reason."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_layers

GOOD = {
    "sunder/base/error.h": "#pragma once\n#include <string>\n",
    "sunder/number/sign.h": "#include <sunder/base/error.h>\nnamespace sunder {\nenum class Sign : int { zero };\n}\n",
    "sunder/solid/object/two.h": "namespace sunder::solid {\nstruct A {\n};\n}  // namespace sunder::solid\n\nnamespace sunder {\n"
                                 "struct B {\n};\n}  // namespace sunder\n\nnamespace sunder {\nstruct C {\n};\n}\n",
    "sunder/number/whole_internal.h": "#include <boost/multiprecision/cpp_int.hpp>\n",
    "sunder/oracle/dictionary_internal.h": "#include <sunder/number/whole_internal.h>\n",
    "sunder/solid/pair/body_body_by_scan.cpp": "#include <sunder/oracle/dictionary_internal.h>\n",
    "sunder/base/contract.cpp": "void f() { std::abort(); }\n",
    "sunder/solid/hull/convex_hull.h": "#include <sunder/number/sign.h>\n",
    "sunder/solid/object/body.h": "#include <sunder/solid/hull/convex_hull.h>\n",
    "sunder/solid/represent/drums.h": "#include <sunder/solid/object/body.h>\nstruct Drums {\n"
                                      "  static constexpr std::size_t slot = 5;\n};\n",
    "sunder/polytope/represent/tree.h": "struct Tree {\n  static constexpr std::size_t slot = 5;\n};\n",
    "sunder/solid/pair/body_body.cpp": "#include <sunder/solid/object/body.h>\n#include <cstdio>\n"
                                       "// printf(\"not code\");\nconst char* text = \"printf(1)\";\n"
                                       "int n = std::snprintf(p, 8, \"%d\", 1);\nvoid print_to(int); bool b = x.exit(1);\n",
    "sunder/solid/pair/body_body_test.cpp": "#include <sunder/io/text/file.h>\n".replace("io/text/file", "solid/object/body") +
                                            "#include <gtest/gtest.h>\n#include <fstream>\n#include <tests/support/a.h>\n",
    "sunder/io/text/file.cpp": "#include <sunder/solid/object/body.h>\n#include <fstream>\n#include <fmt/format.h>\n"
                          "#include <sys/stat.h>\n",
    "sunder/ask/verify.cpp": "#include <sunder/io/text/file.h>\n#include <sunder/picture/canvas.h>\n#include <verifier/verify.h>\n"
                             "#include <sys/stat.h>\nconst char* const standard_output = \"/dev/stdout\";\n",
    "cli/program.cpp": "#include <iostream>\n#include \"words.h\"\n#include <sunder/ask/verb.h>\n#include <CLI/App.hpp>\n",
    "python/bind.cpp": "#include \"common.h\"\n#include <sunder/solid/object/body.h>\n#include <nanobind/nanobind.h>\n",
    "verifier/verify.cpp": "#include \"verify.h\"\n#include <boost/multiprecision/cpp_int.hpp>\n",
    "sunder/predicate/point/turn.cpp": "Sign s = decide(tally, turn_formula, lift<ExactStage>(a));\n",
    "tests/a_test.cpp": "#include <sunder/scene/scene.h>\n#include <gtest/gtest.h>\n",
    "sunder/solid/pair/table.cpp": "// long because: it is a table\n" + "int x;\n" * 700,
}

# name: (file, text, the rule that refuses it)
BAD = {
    "Boost in a public header": ("sunder/number/sign.h", "#include <boost/multiprecision/cpp_int.hpp>\n", "L3"),
    "up a layer": ("sunder/base/cost.h", "#include <sunder/number/sign.h>\n", "L1"),
    "up a layer, spaced": ("sunder/base/cost.h", "  #  include <sunder/number/sign.h>\n", "L1"),
    "to a sibling": ("sunder/planar/pair/x.h", "#include <sunder/solid/object/body.h>\n", "L1"),
    "up a folder": ("sunder/solid/hull/x.cpp", "#include <sunder/solid/object/body.h>\n", "L1"),
    "a representation in an object": ("sunder/solid/object/x.cpp", "#include <sunder/solid/represent/drums.h>\n", "L1"),
    "up a folder from the layer itself": ("sunder/solid/x.h", "#include <sunder/solid/object/body.h>\n", "L1"),
    "a folder without a place": ("sunder/solid/other/x.h", "#include <sunder/solid/object/body.h>\n", "L1"),
    "up from a test": ("sunder/number/sign_test.cpp", "#include <sunder/solid/object/body.h>\n", "L1"),
    "io from the core": ("sunder/scene/x.h", "#include <sunder/io/text/file.h>\n", "L1"),
    "the verifier from the core": ("sunder/certificate/x.cpp", "#include <verifier/verify.h>\n", "L1"),
    "questions from pictures": ("sunder/picture/x.cpp", "#include <sunder/ask/verb.h>\n", "L1"),
    "CLI11 in questions": ("sunder/ask/x.cpp", "#include <CLI/App.hpp>\n", "L3"),
    "Python from the program": ("cli/x.cpp", "#include <python/bind.h>\n", "L1"),
    "nanobind in the core": ("sunder/scene/x.cpp", "#include <nanobind/nanobind.h>\n", "L3"),
    "the library from the verifier": ("verifier/x.cpp", "#include <sunder/base/error.h>\n", "L1"),
    "the oracle from a method": ("sunder/solid/pair/body_body.cpp", "#include <sunder/oracle/dictionary_internal.h>\n", "L1"),
    "the oracle from the program": ("cli/x.cpp", "#include <sunder/oracle/dictionary_internal.h>\n", "L1"),
    "exact linear algebra from the oracle": ("sunder/oracle/x.cpp", "#include <sunder/number/exact/basis_internal.h>\n", "L1"),
    "no layer": ("sunder/x.h", "\n", "L1"),
    "an unknown layer": ("sunder/other/x.h", "\n", "L1"),
    "an unknown layer included": ("cli/x.cpp", "#include <sunder/other/x.h>\n", "L1"),
    "quotes": ("sunder/base/x.cpp", "#include \"error.h\"\n", "L2"),
    "quotes from outside": ("bench/x.cpp", "#include \"../sunder/base/error.h\"\n", "L2"),
    "quotes with the whole path": ("cli/x.cpp", "#include \"sunder/base/error.h\"\n", "L2"),
    "fmt in the core": ("sunder/solid/pair/x.cpp", "#include <fmt/format.h>\n", "L3"),
    "CLI11 in io": ("sunder/io/x.cpp", "#include <CLI/CLI.hpp>\n", "L3"),
    "something new in the core": ("sunder/solid/pair/x.cpp", "#include <eigen3/Eigen/Core>\n", "L3"),
    "a system header in the core": ("sunder/solid/pair/x.cpp", "#include <pthread.h>\n", "L3"),
    "iostream in the core": ("sunder/solid/pair/x.cpp", "#include <iostream>\n", "L4"),
    "files in the core": ("sunder/certificate/x.cpp", "#include <fstream>\n", "L4"),
    "printing in the core": ("sunder/solid/pair/x.cpp", "void f() { std::printf(\"x\"); }\n", "L4"),
    "printing after a string": ("sunder/solid/pair/x.cpp", "void f() { g(\"//\"); fprintf(h, \"x\"); }\n", "L4"),
    "cerr in the core": ("sunder/base/x.cpp", "void f() { std::cerr << 1; }\n", "L4"),
    "abort in the core": ("sunder/base/x.cpp", "void f() { std::abort(); }\n", "L4"),
    "abort of the global namespace": ("sunder/base/x.cpp", "void f() { ::abort(); }\n", "L4"),
    "a fused multiply-add in the core": ("sunder/predicate/x.cpp", "double f() { return std::fma(1, 2, 3); }\n", "L4"),
    "one of Highway's": ("sunder/solid/pair/x.cpp", "auto f() { return hn::MulAdd(a, b, c); }\n", "L4"),
    "another rounding mode": ("sunder/number/x.cpp", "void f() { fesetround(0); }\n", "L4"),
    "the environment in the core": ("sunder/number/x.cpp", "auto f() { return std::getenv(name); }\n", "L4"),
    "a stream of the process in ask": ("sunder/ask/x.cpp", "void f() { g(stdout); }\n", "L9"),
    "printing in ask": ("sunder/ask/pair/x.cpp", "void f() { std::cout << 1; }\n", "L9"),
    "a header for printing in ask": ("sunder/ask/x.h", "#include <cstdio>\n", "L9"),
    "a terminal in ask": ("sunder/ask/scene/x.cpp", "bool f() { return isatty(1) == 1; }\n", "L9"),
    "the environment in ask": ("sunder/ask/x.cpp", "auto f() { return std::getenv(name); }\n", "L9"),
    "a variable of ask": ("sunder/ask/x.cpp", "namespace sunder::ask {\nWords words_now;  // of the call\n}\n", "L9"),
    "a variable of ask with a value": ("sunder/ask/x.cpp", "std::vector<std::string> said{};\n", "L9"),
    "a variable of a function of ask": ("sunder/ask/x.cpp", "int f() {\n  static int calls = 0;\n  return ++calls;\n}\n", "L9"),
    "an umlaut": ("sunder/base/x.h", "// K\u00f6rper\n", "L5"),
    "an umlaut in a test": ("tests/x_test.cpp", "// K\u00f6rper\n", "L5"),
    "a tab": ("sunder/base/x.h", "\tint x;\n", "L5"),
    "a carriage return": ("sunder/base/x.h", "int x;\r\n", "L5"),
    "no newline at the end": ("cli/x.h", "int x;", "L5"),
    "a broken list": ("sunder/base/x.h", "//   A1. " + "word " * 22 + "by\n//   the\n//       end.\nint x;\n", "L7"),
    "a namesake after another namespace": (
        "sunder/solid/pair/x.h",
        "namespace sunder::planar {\nint x;\n}  // namespace sunder::planar\n\nnamespace sunder::solid {\nstruct Sign {\n};\n}\n", "L8"),
    "a namesake": ("sunder/solid/pair/x.h", "namespace sunder::solid {\nstruct Sign {\n};\n}\n", "L8"),
    "a namesake of an alias": ("sunder/solid/pair/x.h", "namespace sunder::solid {\nusing Sign = int;\n}\n", "L8"),
    "one slot for two": ("sunder/solid/represent/x.h", "struct X {\n  static constexpr std::size_t slot = 5;\n};\n", "L11"),
    "stages outside of predicate": ("sunder/solid/pair/x.cpp", "#include <sunder/predicate/filter/stages.h>\n", "L10"),
    "a formula outside of predicate": ("sunder/solid/pair/x.cpp", "Sign s = decide(&tally_, turn_formula, a, b, c);\n", "L10"),
    "a point lifted outside of predicate": ("cli/x.cpp", "auto x = lift<Exact>(a);\n", "L10"),
    "a long file": ("sunder/base/x.h", "int x;\n" * 601, "L6"),
    "a long file without a reason": ("sunder/base/x.h", "// long because: \n" + "int x;\n" * 601, "L6"),
}


def findings_of(tree):
    with tempfile.TemporaryDirectory() as root:
        for path, text in tree.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8", newline="") as stream:
                stream.write(text)
        return check_layers.check(root)


class CheckLayers(unittest.TestCase):
    def test_accepts_the_good_tree(self):
        findings, files, in_layers = findings_of(GOOD)
        self.assertEqual(findings, [])
        self.assertEqual((files, in_layers), (len(GOOD), len(GOOD) - 1))

    def test_refuses_each_bad_twin(self):
        for name, (path, text, rule) in BAD.items():
            with self.subTest(name):
                findings, _, _ = findings_of({**GOOD, path: text})
                self.assertEqual(len(findings), 1, findings)
                self.assertTrue(findings[0].startswith(path + ":"), findings)
                self.assertIn(": %s: " % rule, findings[0])

    def test_an_empty_tree_is_no_success(self):
        with tempfile.TemporaryDirectory() as root:
            self.assertEqual(check_layers.main([root]), 2)

    def test_every_layer_sees_only_what_its_lower_ones_may_see(self):
        for layer, below in check_layers.LAYERS.items():
            for other in below:
                self.assertNotIn(layer, check_layers.LAYERS[other])
                self.assertLessEqual(check_layers.LAYERS[other], below)


if __name__ == "__main__":
    unittest.main()
