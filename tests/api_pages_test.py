#!/usr/bin/env python3
"""scripts/api_pages.py makes the pages of a small library, from XML as Doxygen writes it, and finds what is wrong."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scripts"))
import api_pages

HEADER = """// Do two things meet? See docs/claims.md.
// Also called: narrow phase.
//   P1. Touching is meeting.
#pragma once

namespace sunder::planar {

// A thing.
class Thing {
 public:
  int size() const;

 private:
  int size_;
};

// The front door: the fastest. Cost: at most 3 < n probes.
bool thing_thing(const Thing& a,  // the first
                 const Thing& b, Thing c = {});

// Every part: the oracle.
template <class T>
inline bool thing_thing_by_scan(const T& a) {
  return a.size() == 0;
}

}  // namespace sunder::planar
"""
MEMBER = ('<memberdef kind="%s"><type>bool</type><name>%s</name><location file="sunder/planar/thing.h" line="%d"/>'
          '</memberdef>')
XML = ('<doxygen><compounddef kind="class"><compoundname>sunder::planar::Thing</compoundname>'
       '<location file="sunder/planar/thing.h" line="9"/></compounddef>'
       '<compounddef kind="namespace"><compoundname>sunder::planar</compoundname>%s</compounddef></doxygen>')
FUNCTIONS = MEMBER % ("function", "thing_thing", 18) + MEMBER % ("function", "thing_thing_by_scan", 23)
ROW = "# A paper\n\n| item | file | test | benchmark | certificate | command |\n|---|---|---|---|---|---|\n" \
      "| Lemma 1 | `sunder/planar/thing.h` `thing_thing` | - | - | - | - |\n"
TREE = {"sunder/sunder.h": "// All.\n#pragma once\n#include <sunder/planar/thing.h>\n", "sunder/planar/thing.h": HEADER,
        "sunder/planar/thing_test.cpp": "", "examples/two.cpp": "thing_thing(a, b);\n", "docs/papers/p.md": ROW,
        "docs/claims.md": "", "build/docs/xml/a.xml": XML % FUNCTIONS}


def made(tree):
    """(findings, pages by name) of the tree."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in tree.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                file.write(text)
        findings, _, _ = api_pages.make(root)
        folder = os.path.join(root, "build/docs")
        return findings, {name: api_pages.read(folder, name) for name in os.listdir(folder) if name.endswith(".html")}


class ApiPages(unittest.TestCase):
    def test_pages(self):
        findings, pages = made(TREE)
        self.assertEqual(findings, [])
        self.assertEqual(sorted(pages), ["function.planar.thing_thing.html", "function.planar.thing_thing_by_scan.html",
                                         "index.html", "planar.thing.h.html", "sunder.h.html"])
        page = pages["function.planar.thing_thing.html"]
        for part in ('const <a href="planar.thing.h.html#planar::Thing">Thing</a>&amp; b', "c = {});</pre>",
                     "<b>Cost:</b> at most 3 &lt; n probes.", "<b>P1.</b> Touching",
                     "<b>Also called:</b> narrow phase.",
                     '<a href="function.planar.thing_thing_by_scan.html">', "sunder/planar/thing_test.cpp",
                     "examples/two.cpp", "Lemma 1", '<a href="../../docs/claims.md">'):
            self.assertIn(part, page)
        self.assertNotIn("the first", page)
        self.assertIn("template &lt;class T&gt;\ninline bool thing_thing_by_scan(const T&amp; a);</pre>",
                      pages["function.planar.thing_thing_by_scan.html"])
        self.assertIn("int size() const;\n};", pages["planar.thing.h.html"])
        self.assertIn("Also called: narrow phase", pages["index.html"])

    def test_a_function_without_words(self):
        header = HEADER.replace("// Every part: the oracle.\n", "\n")
        findings, _ = made({**TREE, "sunder/planar/thing.h": header})
        self.assertEqual(findings, ["sunder/planar/thing.h:22: no words about planar::thing_thing_by_scan"])

    def test_a_function_that_doxygen_does_not_know(self):
        findings, _ = made({**TREE, "build/docs/xml/a.xml": XML % (MEMBER % ("function", "thing_thing", 18))})
        self.assertEqual(findings, ["sunder/planar/thing.h:23: Doxygen does not know it"])

    def test_a_link_that_leads_nowhere(self):
        class Astray(api_pages.Reference):
            def write_index(self):
                self.write("index.html", "", ['<a href="planar.thing.h.html#Thong">', '<a href="other.html">'])
        whole, api_pages.Reference = api_pages.Reference, Astray
        try:
            findings, _ = made(TREE)
        finally:
            api_pages.Reference = whole
        self.assertEqual(findings, ["build/docs/index.html: there is no " + target
                                    for target in ("planar.thing.h.html#Thong", "other.html")])

    def test_without_xml(self):
        with tempfile.TemporaryDirectory() as root:
            self.assertEqual(api_pages.main([root]), 2)


if __name__ == "__main__":
    unittest.main()
