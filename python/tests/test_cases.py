"""Case files: Python answers as the C++ program does, and its certificates say the same and are accepted."""
import csv
import glob
import json
import os

import numpy as np
import pytest
import sunder
from sunder import planar, solid

from helpers import CASES, PROGRAM, program, proved


def case(name):
    return os.path.join(CASES, name)


def rows(name, columns):
    """The numbers of these columns of a CSV file, by name or place, as they are read in full double precision."""
    with open(case(name), encoding="utf-8", newline="") as file:
        lines = [line for line in csv.reader(file) if line]
    names = lines[0] if not lines[0][0].replace(".", "").lstrip("-").isdigit() else None
    places = [names.index(column) for column in columns] if names and columns[0] in names else range(len(columns))
    return np.array([[float(line[k]) for k in places] for line in lines[1 if names else 0:]])


def certificate_of(folder, *words):
    """What the program writes, without what its tables were made of."""
    path = str(folder / "proof.json")
    program(*words, "--certificate", path)
    with open(path, "rb") as file:
        data = file.read()
    return data


def said(certificate):
    """Statements with their claims, and tables without names and lines."""
    top = json.loads(certificate)
    for table in top["tables"].values():
        for entry in table:
            if isinstance(entry, dict):
                entry.pop("name", None)
    return top["statements"], top["tables"]


# --- Pairs on which something once failed --------------------------------------------------------------------------

def number(text):
    return float.fromhex(text) if "0x" in text else float(text)


SOLID_PAIRS = sorted(glob.glob(case("solid-pair/*.json")))


@pytest.mark.parametrize("path", SOLID_PAIRS, ids=os.path.basename)
def test_solid_pairs(path):
    with open(path, encoding="utf-8") as file:
        top = json.load(file)
    bodies, poses = [], []
    for body in top["tables"]["bodies"]:
        if "of" not in body:
            bodies.append(solid.ConvexPolyhedron([[number(x) for x in p] for p in body["points"]]))
            poses.append(solid.Pose())
        else:
            bodies.append(bodies[body["of"]])
            linear, translation = ([number(x) for x in body[part]] for part in ("linear", "translation"))
            poses.append(solid.Pose.from_matrix(linear, translation))
    for pair in top["statements"]:
        i, j = pair["a"], pair["b"]
        answer = sunder.intersect(bodies[i], poses[i], bodies[j], poses[j])
        assert answer.meet == (pair["verdict"] == "meet")
        (statement,), _ = said(answer.certificate())
        assert statement["verdict"] == pair["verdict"]
        proved(answer.certificate())
        rows_ab = [np.hstack([poses[k].linear, poses[k].translation[:, None]]) for k in (i, j)]
        assert sunder.intersect_many(bodies[i], rows_ab[0], bodies[j], rows_ab[1][None]).tolist() == [answer.meet]


def test_there_are_solid_pairs():
    assert len(SOLID_PAIRS) >= 3


# --- Meshes --------------------------------------------------------------------------------------------------------

def vertices_of(name):
    with open(case(name), encoding="utf-8") as file:
        return [[float(x) for x in line.split()[1:4]] for line in file if line.startswith("v ")]


@pytest.mark.parametrize("a", ["cube", "tetrahedron", "points"])
@pytest.mark.parametrize("b, there", [("cube", (0.5, 0, 0)), ("tetrahedron", (1, 0, 0)), ("cube", (1, 1, 1)),
                                      ("tetrahedron", (5, 0, 0)), ("points", (0.25, 0.5, 0.125))])
def test_meshes(tmp_path, a, b, there):
    of_a, of_b = (solid.ConvexPolyhedron(vertices_of("mesh/%s.obj" % name)) for name in (a, b))
    answer = sunder.intersect(of_a, solid.Pose(), of_b, solid.Pose.from_matrix(np.eye(3), there))
    words = ("pair", case("mesh/%s.obj" % a), case("mesh/%s.obj" % b), "--pose-b", ",".join(map(str, there)))
    report = program(*words)
    assert report["answer"] == ("meet" if answer else "apart")
    cost = {name: getattr(answer.cost, name) for name in ("probes", "iterations", "exact")}
    assert {name: report["cost"][name] for name in cost} == cost and report["decided_by"] == answer.decided_by
    assert said(answer.certificate())[0][0]["claims"] == said(certificate_of(tmp_path, *words))[0][0]["claims"]
    proved(answer.certificate())


# --- Sets and regions ----------------------------------------------------------------------------------------------

QUESTIONS = {"": "any", "--all": "all", "--count": "count"}
SETS = [(name, "circles", planar.Discs, "xyr") for name in ("outcomes/circles.csv", "outcomes/circles_apart.csv",
                                                            "outcomes/circles_touching.csv", "circles/moon.csv")]
SETS += [(name, "segments", planar.Segments, ("x1", "y1", "x2", "y2"))
         for name in ("outcomes/segments.csv", "outcomes/segments_none.csv", "outcomes/segments_ends.csv",
                      "outcomes/segments_touch.csv", "segments/wires.csv")]


def contacts_of(report):
    return [(c["i"], c["j"], c["contact"]) for c in report["contacts"]]


def verdict_of(answer, question):
    return bool(answer.found if question == "any" else answer.count if question == "count" else len(answer))


@pytest.mark.parametrize("option", QUESTIONS)
@pytest.mark.parametrize("allowed", ["nothing", "touch"])
@pytest.mark.parametrize("name, verb, make, columns", SETS, ids=[s[0] for s in SETS])
def test_sets(tmp_path, name, verb, make, columns, allowed, option):
    question = QUESTIONS[option]
    ask = getattr(planar, "%s_%s" % ("discs" if verb == "circles" else verb, question))
    answer = ask(make(rows(name, columns)), allowed=allowed)
    words = (verb, case(name), "--allow", allowed, *option.split())
    report = program(*words)
    assert (report["answer"] == "some") == verdict_of(answer, question)
    if question == "all":
        assert [(*pair, kind) for pair, kind in zip(answer.pairs.tolist(), answer.kinds)] == contacts_of(report)
    if question == "count":
        assert answer.count == report["count"]
    assert said(answer.certificate()) == said(certificate_of(tmp_path, *words))
    proved(answer.certificate())


@pytest.mark.parametrize("name", [os.path.basename(p) for p in sorted(glob.glob(case("outcomes/half_planes_*.csv")))])
def test_half_planes(tmp_path, name):
    region = planar.half_plane_intersection(planar.Constraints(rows("outcomes/" + name, "abc")))
    words = ("region", case("outcomes/" + name))
    assert program(*words)["region"]["kind"] == region.kind
    assert said(region.certificate()) == said(certificate_of(tmp_path, *words))
    proved(region.certificate())


@pytest.mark.parametrize("objective", ["1,2", "0,0", "-1,0", "0.25,-3"])
@pytest.mark.parametrize("name", [os.path.basename(p) for p in sorted(glob.glob(case("outcomes/half_planes_*.csv")))])
def test_linear_programs(tmp_path, name, objective):
    given = planar.Constraints(rows("outcomes/" + name, "abc"))
    best = planar.linear_program(given, [float(x) for x in objective.split(",")])
    ((ours,), tables), (theirs, same) = said(best.certificate()), said(
        certificate_of(tmp_path, "region", case("outcomes/" + name), "--maximize=" + objective))
    assert tables == same and ours["verdict"] == theirs[0]["verdict"] == best.outcome  # then what the region is
    if best.outcome == "one":  # else there are many proofs
        assert ours == theirs[0]
    proved(best.certificate())


@pytest.mark.parametrize("name", ["discs_empty.csv", "discs_point.csv", "discs_region.csv"])
def test_common_parts_of_discs(tmp_path, name):
    part = planar.disc_intersection(planar.Discs(rows("outcomes/" + name, "xyr")))
    words = ("region", "--of", "circles", case("outcomes/" + name))
    assert part.kind == name.split("_")[1].split(".")[0]
    assert said(part.certificate()) == said(certificate_of(tmp_path, *words))
    proved(part.certificate())


# --- Polygons ------------------------------------------------------------------------------------------------------

def features(name):
    """Of each feature of a GeoJSON file its parts, each a list of rings."""
    with open(case(name), encoding="utf-8") as file:
        top = json.load(file)
    shapes = [feature["geometry"] for feature in top["features"]] if "features" in top else [top.get("geometry") or top]
    return [shape["coordinates"] if shape["type"] == "MultiPolygon" else [shape["coordinates"]] for shape in shapes]


def test_polygons(tmp_path):
    name = "outcomes/polygons.geojson"
    polygons = planar.Polygons([rings for parts in features(name) for rings in parts])
    every = planar.polygons_all(polygons)
    report = program("polygons", case(name), "--all")
    assert [(*pair, kind) for pair, kind in zip(every.pairs.tolist(), every.kinds)] == \
        [(c["i"], c["j"], c["contact"]) for c in report["contacts"]] != []
    assert planar.polygons_count(polygons).count == report["count"]
    assert said(every.certificate()) == said(certificate_of(tmp_path, "polygons", case(name), "--all"))


def expected_defects():
    with open(case("valid-polygons/EXPECTED.tsv"), encoding="utf-8") as file:
        for line in file:
            name, *kinds = line.rstrip("\n").split("\t")
            if name.endswith((".geojson", ".json")):
                yield name, kinds


def test_valid_polygons():
    seen = 0
    for name, kinds in expected_defects():
        for rule, expected in zip(("simple", "valid", "self-touch"), kinds):
            parts = features("valid-polygons/" + name)[0]
            found = planar.polygon_defects(parts, rule=rule)
            kinds_of_file = set(expected.replace(",", " ").split()) - {"-"}
            assert {defect[0] for defect in found.defects} == kinds_of_file, (name, rule)
            proved(found.certificate())
            seen += 1
    assert seen >= 3


# --- All calls of the page of proofs, asked of files ---------------------------------------------------------------

def calls():
    with open(os.path.join(os.path.dirname(CASES), "docs", "guide", "proofs.md"), encoding="utf-8") as page:
        for line in page:
            cells = [cell.strip() for cell in line.strip("| \n").split("|")]
            if len(cells) == 5 and cells[4].startswith("`sunder "):
                yield cells[4].strip("`").split()[1:], cells[2] != "nothing is asked"


WITH_VALUE = ("plane", "method", "feature_a", "feature_b", "pose_a", "pose_b", "poses_b", "allow", "group", "clearance", "maximize", "feature",
              "of", "project", "srdf", "radius_a", "radius_b", "to_a", "to_b", "joints",
              "placements", "margin")


def test_files_are_asked_as_by_the_program(monkeypatch, tmp_path):
    monkeypatch.chdir(os.path.dirname(CASES))
    asked = 0
    for words, is_stated in calls():
        verb, files, options, last = words[0], [], {}, None
        for word in words[1:]:
            if word.startswith("--"):
                last = word[2:].replace("-", "_")
                options[last] = True
            elif last in WITH_VALUE and options[last] is True:
                options[last] = word
            else:
                files.append(word)
        report, plain = sunder.ask(verb, *files, **options), program(*words)
        seconds = [[placement.pop("seconds") for placement in top.get("placements", [])] for top in (report, plain)]
        assert report == plain and len(seconds[0]) == len(seconds[1]), words
        if is_stated:
            proof = sunder.ask(verb, *files, certificate=True, **options).proof
            assert proof == certificate_of(tmp_path, *words) and proved(proof)
        asked += 1
    assert asked > 60 and PROGRAM


def test_files_that_are_refused():
    refused = placed = 0
    for folder, verb in (("broken", "hull"), ("broken-lines", "segments"), ("broken-planar", "pair"), ("broken-space", "pair")):
        with open(case(folder + "/EXPECTED.tsv"), encoding="utf-8") as file:
            expected = dict(line.rstrip("\n").split("\t")[:2] for line in file if line.strip() and line[0] != "#")
        for name, part in expected.items():
            if folder == "broken" and not name.endswith((".obj", ".stl", ".ply", ".off")):
                continue
            path = case(os.path.join(folder, name))
            with pytest.raises(sunder.Error) as caught:
                sunder.ask(verb, *([path, path] if verb == "pair" else [path]))
            assert part in str(caught.value) and caught.value.kind == "bad-file", (name, caught.value)
            place, text = caught.value.place, caught.value.text
            assert text and (not place or not text.startswith(place)), (name, place, text)
            placed += bool(place)
            refused += 1
    assert refused > 80 and placed > 80


def test_wrong_calls():
    for words, options in ((("circle", "x.csv"), {}), (("circles", "x.csv"), {"every": True}), (("circles",), {}),
                           (("",), {}), (("circles", "nul\0byte"), {}), (("circles", "no such file"), {}), ((5,), {}),
                           (("circles", 5), {})):
        with pytest.raises(sunder.Error) as caught:
            sunder.ask(*words, **options)
        assert caught.value.kind in ("bad-call", "bad-file") and caught.value.text, words
