"""What no key of the data can say: `check = "name a b"` calls name(test, "a", "b"), after the call of the step."""
import json
import os
import re


def help_lines_are_short(test):
    """No line of help has more than 100 characters, and long descriptions are wrapped, not cut."""
    verbs = re.findall(r"^  ([a-z]+) {3,}", test.run("--help").out.partition("Verbs:")[2], re.M)
    test.expect(len(verbs) == 14, "the verbs are %s" % verbs)
    wrapped = 0
    for call in ["--help"] + ["help " + verb for verb in verbs]:
        for line in test.run(call).out.splitlines():
            test.expect(len(line) <= 100, "%s has a line of %d characters: %s" % (call, len(line), line))
            test.expect(line == line.rstrip(), "%s has a line that ends with a space: %s" % (call, line))
            wrapped += line.startswith(28 * " ") and line[28:29].strip() != ""
    test.expect(wrapped > 50, "%d lines continue another" % wrapped)


def guide_names_all_options(test):
    """The page has a section for each verb, which names each of its options; each verb tells its exit codes."""
    page = test.read(os.path.join(test.variables["source"], "docs", "guide", "program.md"))
    verbs = re.findall(r"^  ([a-z]+) ", test.run("--help").out.partition("Verbs:")[2], re.M)
    test.expect(len(verbs) == 14, "the verbs are %s" % verbs)
    for verb in verbs:
        words = test.run("help " + verb).out
        test.expect("Exit code: 0" in words and "3 internal error." in re.sub(r"\s+", " ", words), verb + " tells no exit code")
        test.expect("[%s](#sunder-%s)" % (verb, verb) in page, "no link to " + verb)
        parts = re.split(r"^## (.*)\n", page, flags=re.M)
        sections = dict(zip(parts[1::2], parts[2::2]))
        section = sections.get("sunder " + verb, "")
        test.expect(section, "no section of " + verb)
        test.expect("\n    sunder %s " % verb in section, "no call of " + verb)
        for option in re.findall(r"^  (?=-).*?(--[a-z-]+)", words, re.M):
            test.expect(option in ("--help", "--quiet", "--out") or option in section,
                        "the section of %s does not name %s" % (verb, option))


def rows_are_lines(test, lines, table, key):
    """The rows of a table of placements, or of steps between them, tell what the JSON lines do."""
    told = [json.loads(line) for line in test.read(lines).splitlines()][1:]
    rows = test.read(table).splitlines()[1:]
    test.expect(len(rows) == len(told) > 10, "%d rows, %d lines" % (len(rows), len(told)))
    for k, (line, row) in enumerate(zip(told, rows)):
        test.expect(line[key] == k, "line %d is of %s" % (k, line[key]))
        pairs = line.get("pairs", [])
        test.expect((line["answer"] == "some") == bool(pairs), "line %d: %s, %d pairs" % (k, line["answer"], len(pairs)))
        begin = "%d,%s,%d," % (k, line["answer"], len(pairs))
        test.expect(row.startswith(begin), "row %d does not begin %s: %s" % (k, begin, row))


def lists_are_the_same(test, report, map_file, table):
    """The contacts of a report are those of the map and of the table."""
    contacts = json.loads(test.saved[report].out)["contacts"]
    features = json.loads(test.read(map_file))["features"]
    rows = test.read(table).split("\r\n")
    test.expect(len(features) == len(contacts), "%d contacts, %d features" % (len(contacts), len(features)))
    test.expect(len(rows) == len(contacts) + 2, "%d contacts, %d rows" % (len(contacts), len(rows)))
    for k, (contact, feature, row) in enumerate(zip(contacts, features, rows[1:])):
        test.expect(feature["properties"].pop("number") == k + 1, "feature %d has another number" % k)
        del contact["point"]
        test.expect(feature["properties"] == contact, "feature %d is not as in the report: %s" % (k, feature))
        test.expect(row.startswith("%d,%d,%s," % (contact["i"], contact["j"], contact["contact"])), "row: " + row)


def keys_are(test, report, *keys):
    """The keys of a report, in their order."""
    found = list(json.loads(test.saved[report].out))
    test.expect(found == list(keys), "the keys are %s" % found)


def statements_of_defects(test, report, proof):
    """A proof has a statement of each feature, and at most one of each defect: one may tell of several."""
    told, proved = json.loads(test.read(report)), json.loads(test.read(proof))
    expected = sum(max(len(feature["defects"]), 1) for feature in told["objects"])
    test.expect(len(told["objects"]) <= len(proved["statements"]) <= expected,
                "%d statements of %d features, and at most %d" % (len(proved["statements"]), len(told["objects"]), expected))


def defects_of_the_cases(test):
    """The kinds of defects that EXPECTED.tsv lists, by each rule and method."""
    rows = [line.split("\t") for line in test.read("cases/valid-polygons/EXPECTED.tsv").splitlines()]
    rows = [row for row in rows if not row[0].startswith("#")]
    test.expect(len(rows) == 20, "%d rows" % len(rows))
    for file, *columns in rows:
        for option, kinds in zip(("--strict ", "", "--self-touch "), columns):
            for method in ("automatic", "scan"):
                call = "simple --all --method %s %scases/valid-polygons/%s" % (method, option, file)
                done = test.expect_report(call, 0 if kinds == "-" else 1, [])
                found = []
                for defect in json.loads(done.out)["objects"][0]["defects"]:
                    if found[-1:] != [defect["kind"]]:
                        found.append(defect["kind"])
                test.expect((" ".join(found) or "-") == kinds, "%s: %s, not %s" % (call, found, kinds))


def corners_are_in_the_plane(test, report):
    """The corners of the first section are on x + 2 y + 2 z = 0.7, but for rounding."""
    corners = json.loads(test.saved[report].out)["sections"][0]["corners"]
    test.expect(len(corners) > 2, "%d corners" % len(corners))
    for corner in corners:
        x, y, z = corner["point"]
        test.expect(abs(x + 2 * y + 2 * z - 0.7) < 1e-15, "not in the plane: %s" % corner)


def _lines(test, name):
    return [json.loads(line) for line in test.read(name).splitlines()]


def placements_are_as_the_report_says(test, report, text, lines):
    """The lines of all placements have what the report of all has, and each pair that meets has evidence."""
    held = json.loads(test.saved[report].out)
    words = test.saved[text].out.splitlines()
    for k, line in enumerate(_lines(test, lines)[1:]):
        test.expect(line["answer"] == held["placements"][k]["answer"], "placement %d has another answer" % k)
        expected = [p for p in held["pairs"] if p["placement"] == k and p["answer"] == "meet"]
        pairs = line.get("pairs", [])
        if not test.expect(len(pairs) == len(expected), "%d pairs, not %d" % (len(pairs), len(expected))):
            continue
        for pair, other in zip(pairs, expected):
            for key in ("a", "b", "part_a", "part_b", "answer", "contact", "said_of", "counted"):
                test.expect(pair[key] == other[key], "placement %d: %s is %s, not %s" % (k, key, pair[key], other[key]))
            if pair["said_of"] == "meshes":
                test.expect(pair["evidence"] == other["evidence"], "placement %d: other evidence" % k)
                continue
            named = len(pair["evidence"]["vertices_a"]) + len(pair["evidence"]["vertices_b"])
            test.expect(named >= 2, "%d vertices of the evidence" % named)
            test.expect(named <= 5, "%d vertices of the evidence" % named)
        test.expect(words[k].startswith("%d: " % k), words[k])
        test.expect(words[k].endswith(": none meet") == (not pairs), words[k])


def stops_at_the_first(test, everything, first):
    """The lines are those of all, up to the first that meets, and a sum."""
    lines = test.saved[everything].out.splitlines()
    end = next(k for k, line in enumerate(lines) if not line.endswith(": none meet")) + 1
    found = test.saved[first].out.splitlines()
    test.expect(len(found) == end + 1, "%d lines, not %d" % (len(found), end + 1))
    test.expect(found[:end] == lines[:end], "other lines: %s" % found)


def nearness_is_as_the_report_says(test, report, text, lines, table):
    """What is closer in each placement, and what is nearest, in lines, rows and words."""
    held = json.loads(test.saved[report].out)
    words, rows = test.saved[text].out.splitlines(), test.read(table).splitlines()
    not_kept = listed = 0
    for k, line in enumerate(_lines(test, lines)[1:]):
        expected = [{key: v for key, v in p.items() if key != "placement"}
                    for p in held["clearance"]["closer"] if p["placement"] == k]
        nearest = {key: v for key, v in held["nearest"][k].items() if key != "placement"}
        test.expect(line["closer"] == expected, "placement %d: %s is closer" % (k, line["closer"]))
        test.expect(line["nearest"] == nearest, "placement %d: %s is nearest" % (k, line["nearest"]))
        test.expect("closer_undecided" not in line, "placement %d is undecided" % k)
        test.expect(("; none are closer; nearest: " in words[k]) == (not expected), words[k])
        test.expect(",%d," % len(expected) in rows[k + 1], rows[k + 1])
        not_kept += bool(expected)
        listed += len(expected)
    test.expect(listed > not_kept, "%d pairs of %d placements" % (listed, not_kept))
    test.expect(10 < not_kept < 70, "%d placements" % not_kept)
    test.expect("; closer than asked for, or undecided: %d" % not_kept in words[-1], words[-1])


def statements_are_what_is_closer(test, lines, proof):
    """The statements are of the pairs that the lines tell, with their distances, and of no others."""
    told, statements = _lines(test, lines)[1:], json.loads(test.read(proof))["statements"]
    meeting = sum(len(line.get("pairs", [])) for line in told)
    least = [pair["least"] for line in told for pair in line["closer"]]
    stated = [float.fromhex(s["least"]) for s in statements if "least" in s]
    met = sum(s["verdict"] in ("meet", "a_within", "b_within") and "least" not in s for s in statements)
    test.expect(all(s["verdict"] in ("broken", "a_within", "b_within") for s in statements if "least" in s), "one is kept")
    own = least.count(0.03)
    test.expect(met == meeting > 10, "%d of %d meet" % (met, meeting))
    test.expect(stated == least, "%s, not %s" % (stated, least))
    test.expect(len(statements) == met + len(stated), "%d statements" % len(statements))
    test.expect(own > 0, "no pair has a margin of its own")
    test.expect(len(least) > meeting + own, "%d are closer" % len(least))


def forget_one_that_is_nearer(test, proof):
    """Takes a pair out of a statement that lists two or more pairs that are nearer."""
    document = json.loads(test.read(proof))
    found = [s for s in document["statements"] if s["question"] == "clearances" and len(s.get("nearer", [])) > 1]
    if test.expect(found, "no statement has two that are nearer"):
        del found[0]["nearer"][0]
        test.write(proof, json.dumps(document))
