#!/usr/bin/env python3
"""What is said of entries, and what sentences say: each kind of field changes the sentence, and what is left of a field
is refused. Both checkers print the same words."""
import copy
import json
import re

from files import PROGRAM, file_of, main, told, told_by_twin, unittest
from sunder_verify import said

ORIGIN, FAR = [["0x0p+0", "0x0p+0", "0x0p+0"]], [["0x1p+3", "0x0p+0", "0x0p+0"]]
APART = {"question": "pair", "a": 0, "b": 1, "verdict": "apart", "claims": [{"claim": "parted", "direction": ["1", "0", "0"]}]}
LINES = [["0x0p+0", "0x0p+0", "0x1p+0", "0x0p+0"], ["0x0p+0", "0x1p+0", "0x1p+0", "0x1p+0"]]
NONE = {"question": "segments", "allowed": "nothing", "verdict": "none",
        "claims": [{"claim": "none_counts", "events": [[0, -1, 0], [2, 0, 1], [1, -1], [3, -1]]}]}
MEMBERS = {"input": 0, "part": "arm", "without": ["2 faces"], "text": "--line 0,0,1,1", "by": ["0x1p-1"],
           "frame": ["0x0p+0"] * 9, "axis": "z", "unit": "mm", "changes": ["2 rings closed"], "system": "EPSG:4326",
           "values": [["hoist", "0x1p-2"]], "row": 7, "from": 0, "pairs": [["Never", 1]]}
WORDS = {  # what each member must bring into the sentence
    "input": '"a.obj"', "part": 'part "arm" of ', "without": ', without "2 faces"', "text": '"--line 0,0,1,1"', "by": "0x1p-1",
    "frame": "0x0p+0, 0x0p+0", "axis": '"z"', "unit": '"mm"', "changes": '"2 rings closed"', "system": '"EPSG:4326"',
    "values": '"hoist" 0x1p-2', "row": " of row 7", "from": ' of "a.obj"', "pairs": '1 "Never"'}
SOURCE = {"is": "vertices", "input": 0, "part": None, "without": []}


def field(kinds, kind):
    """One of the kind, with all of its members."""
    names = re.findall("{(.*?)}", kinds[kind])
    one = {"is": kind, **{name: MEMBERS[name] for name in names}}
    return {**one, "of": SOURCE} if kinds[kind].startswith(",") else one


def of_bodies(description):
    bodies = [{"name": "p", "points": ORIGIN, **({"said": description} if description else {})}, {"name": "q", "points": FAR}]
    return {**file_of({"bodies": bodies}, APART), "inputs": [{"name": "a.obj", "sha256": "0" * 64}]}


def of_rows(parts):
    top = {**file_of({"segments": LINES}, NONE), "inputs": [{"name": "a.obj", "sha256": "0" * 64}]}
    return {**top, "said": {"segments": parts}} if parts else top


def of_scene(notes):
    scene = {"question": "bodies", "members": [0, 1, 2], "allowed": "nothing", "except": [[0, 2]], "verdict": "these", "contacts": [],
             "claims": [{"claim": "each_pair"}], **({"said": notes} if notes else {})}
    bodies = [{"name": name, "points": [[x, "0x0p+0", "0x0p+0"]]} for name, x in (("p", "0x0p+0"), ("q", "0x1p+3"), ("r", "0x1p+4"))]
    top = file_of({"bodies": bodies}, APART, {**APART, "a": 1, "b": 2}, scene)
    return {**top, "inputs": [{"name": "a.obj", "sha256": "0" * 64}]}


class Said(unittest.TestCase):
    def setUp(self):
        self.files = []

    def tell(self, top, rule="accepted"):
        """The last sentence."""
        text = json.dumps(top)
        outcome, sentences = told(text)
        self.assertEqual(outcome, rule, text)
        self.files.append((text, outcome, sentences))
        return sentences[-1] if sentences else None

    def tearDown(self):
        if PROGRAM and self.files:
            by_twin = told_by_twin([text for text, _, _ in self.files])
            for (text, outcome, sentences), (rule, others) in zip(self.files, by_twin):
                self.assertEqual((rule, others), (outcome, sentences), text)

    def test_null_is_no_description(self):
        top = of_bodies(None)
        top["tables"]["bodies"][0]["said"] = None
        for text in map(json.dumps, (top, of_rows([[2, None]]))):
            self.assertEqual(told(text)[0], "F")
            if PROGRAM:
                self.assertEqual(told_by_twin([text])[0][0], "F")

    def test_each_kind_of_each_place(self):
        """With the field the sentence says more; without it, less; with a member of it missing the file is refused."""
        places = {of_bodies: said.DESCRIPTIONS, of_rows: said.DESCRIPTIONS, of_scene: said.NOTES}
        for make, kinds in places.items():
            plain = self.tell(make(None))
            wrap = {of_bodies: lambda one: one, of_rows: lambda one: [[2, one]], of_scene: lambda one: [one]}[make]
            for kind in kinds:
                with self.subTest(place=make.__name__, kind=kind):
                    one = field(kinds, kind)
                    more = self.tell(make(wrap(one)))
                    self.assertTrue(more.startswith(plain + "; "), more)
                    self.assertIn("said to be", more)
                    for name in one:
                        if name in WORDS:
                            self.assertIn(WORDS[name], more)
                        self.tell(make(wrap({key: value for key, value in one.items() if key != name})), "F")
                        self.tell(make(wrap({**one, name: 5.0})), "F")
                    self.tell(make(wrap({**one, "besides": 1})), "F")
                    if kinds[kind].startswith(","):
                        self.assertGreater(len(more), len(self.tell(make(wrap(SOURCE)))))

    def test_whole_sentences(self):
        hull = {"is": "hull", "of": {**SOURCE, "without": ["1 face", "2 lines"]}}
        self.assertEqual(self.tell(of_bodies(hull)), (
            'the convex hull of the 1 point of "p" and the convex hull of the 1 point of "q" are apart; "p" is said to be made of '
            'all vertices of "a.obj", without "1 face", "2 lines", which is replaced by its convex hull'))
        lines = {**SOURCE, "is": "lines"}
        self.assertEqual(self.tell(of_rows([[1, lines], [1, {"is": "dropped", "axis": "z", "of": lines}]])), (
            'no two of the 2 segments meet; these are said to be made of 1: all lines of "a.obj", 1: all lines of "a.obj", '
            'with "z" dropped'))
        self.assertEqual(self.tell(of_scene([field(said.NOTES, "joint_values"), field(said.NOTES, "allowed")])), (
            "exactly 0 pairs of the 3 bodies meet (members: 0, 1, 2, 1 pair not asked about: 0 2); the joint values of row 7 of "
            '"a.obj" are said to be "hoist" 0x1p-2; the pairs not asked about are said to be allowed: 1 "Never"'))
        image = of_bodies(SOURCE)
        image["tables"]["bodies"].append({"name": "i", "of": 0, "linear": ["0x1p+0"] + ["0x0p+0"] * 8, "translation": ["0x1p-1"] * 3})
        image["statements"][0] = {**APART, "a": 2}
        self.assertIn('the 1 mapped point of "i" and ', self.tell(image))
        self.assertIn('; "i" is said to be made of all vertices of "a.obj", mapped', self.tell(image))

    def test_what_is_refused(self):
        for top in (of_bodies({"is": "hull", "of": None}), of_bodies([SOURCE]), of_bodies({"is": "nothing"}), of_bodies({"is": ["hull"]}),
                    of_bodies({**SOURCE, "input": 1}), of_bodies({**SOURCE, "part": ""}), of_bodies({**SOURCE, "without": [""]}),
                    of_bodies({"is": "given", "text": "x" * 4001}), of_bodies({"is": "scaled", "by": ["1/2"], "of": SOURCE}),
                    of_bodies({"is": "projected", "frame": ["0x0p+0"] * 8, "of": SOURCE}), of_bodies(field(said.NOTES, "allowed")),
                    of_rows([]) | {"said": {"segments": []}}, of_rows([[1, SOURCE]]), of_rows([[3, SOURCE]]),
                    of_rows([[2, SOURCE], [0, SOURCE]]), of_rows([[2, SOURCE, 1]]), of_rows([[2, SOURCE]]) | {"said": []},
                    {**of_rows(None), "said": {"circles": [[2, SOURCE]]}}, {**of_bodies(None), "said": {"bodies": [[2, SOURCE]]}},
                    of_scene([{"is": "allowed", "pairs": [["Never", 2]]}]), of_scene([{"is": "allowed", "pairs": []}]),
                    of_scene([{"is": "allowed", "pairs": [["Never", 0], ["Adjacent", 1]]}]), of_scene([SOURCE]),
                    of_scene([{**field(said.NOTES, "joint_values"), "values": []}]), of_scene(field(said.NOTES, "allowed"))):
            self.tell(top, "F")
        pair = of_bodies(None)
        pair["statements"][0] = {**APART, "said": [field(said.NOTES, "allowed")]}
        self.tell(pair, "F")
        deep = SOURCE
        for step in range(9):
            self.tell(of_bodies(deep), "accepted" if step <= 7 else "F")
            deep = {"is": "hull", "of": deep}

    def test_what_each_file_has(self):
        whole = {**of_rows(None), "call": ["segments", "a.obj"], "left_out": ["1 point"]}
        self.tell(whole)
        for key in ("sunder_certificate", "inputs", "call", "left_out", "tables", "statements"):
            self.tell({name: value for name, value in whole.items() if name != key}, "F")
        for version in (0, 1, 2, 4, -3, 10 ** 15, 10 ** 18, 3.0, "3", True, None, [3]):
            self.tell({**whole, "sunder_certificate": version}, "F")

    def test_a_radius_is_in_the_sentence(self):
        """And without it the file says less, or is refused."""
        for kind, words in (("radius", "capsule of radius 0x1p+0 of the 2 points"), ("cylinder", "cylinder of radius 0x1p+0 of the 2 points"),
                            ("cone", "cone of radius 0x1p+0 of the 2 points")):
            top = of_bodies(None)
            top["tables"]["bodies"][0] = {"name": "p", "points": ORIGIN + [["0x0p+0", "0x0p+0", "0x1p+0"]], kind: "0x1p+0"}
            self.assertTrue(self.tell(top).startswith("the " + words))
            del top["tables"]["bodies"][0][kind]
            self.assertTrue(self.tell(top).startswith("the convex hull of the 2 points"))

    def test_pairs_that_are_asked_about(self):
        """Each sentence of a set says of how many entries; of no pair, that."""
        def segments(rows, **more):
            return file_of({"segments": LINES[:rows]}, {**NONE, **more, "claims": [{"claim": "none_counts", "events": (
                NONE["claims"][0]["events"] if rows == 2 else [[0, -1, 0], [1, -1]])}]})
        self.assertEqual(self.tell(segments(2)), "no two of the 2 segments meet")
        self.assertEqual(self.tell(segments(1)), "no pair of 1 segment is asked about")
        self.assertEqual(self.tell(segments(2, groups=[1, 1])),
                         "no pair of 2 segments is asked about (members of one of 1 groups may meet)")
        self.assertEqual(self.tell(segments(2, groups=[1, 2])),
                         "no two of the 2 segments meet (members of one of 2 groups may meet)")
        count = copy.deepcopy(segments(1))
        count["statements"][0].update(verdict="count", number=0, claims=[{**count["statements"][0]["claims"][0], "claim": "number_counts"}])
        self.assertEqual(self.tell(count), "no pair of 1 segment is asked about")
        alone = of_scene(None)
        alone["statements"] = [{**alone["statements"][2], "members": [0], "except": []}]
        self.assertEqual(self.tell(alone), "no pair of 1 body is asked about (members: 0)")
        none_left = of_scene(None)
        none_left["statements"] = [{**none_left["statements"][2], "except": [[0, 1], [0, 2], [1, 2]]}]
        self.assertEqual(self.tell(none_left), "no pair of 3 bodies is asked about (members: 0, 1, 2, 3 pairs not asked about: 0 1, 0 2, 1 2)")


if __name__ == "__main__":
    main()
