"""What no key of the data can say: `check = "name a b"` calls name(test, "a", "b"), after the call of the step."""
import json
import os
import re


def guide_names_all_options(test):
    """The page has a section for each verb, which names each of its options; each verb tells its exit codes."""
    page = test.read(os.path.join(test.variables["source"], "docs", "guide", "program.md"))
    subcommands = test.run("--help").out.partition("Subcommands:")[2]
    verbs = re.findall(r"^  ([a-z]+) ", subcommands, re.M)
    test.expect(len(verbs) == 13, "the verbs are %s" % verbs)
    for verb in verbs:
        words = test.run("help " + verb).out
        test.expect("Exit code: 0" in words, verb + " tells no exit code")
        test.expect("[%s](#sunder-%s)" % (verb, verb) in page, "no link to " + verb)
        parts = re.split(r"^## (.*)\n", page, flags=re.M)
        sections = dict(zip(parts[1::2], parts[2::2]))
        section = sections.get("sunder " + verb, "")
        test.expect(section, "no section of " + verb)
        test.expect("\n    sunder %s " % verb in section, "no call of " + verb)
        for option in re.findall(r"^  -.*?(--[a-z-]+)", words, re.M):
            test.expect(option in ("--help", "--quiet", "--out") or option in section,
                        "the section of %s does not name %s" % (verb, option))


def rows_are_lines(test, lines, table, key):
    """The rows of a table of placements, or of steps between them, tell what the JSON lines do."""
    told = [json.loads(line) for line in test.read(lines).splitlines()][1:]
    rows = test.read(table).splitlines()[1:]
    test.expect(len(rows) == len(told) > 10, "%d rows, %d lines" % (len(rows), len(told)))
    for k, (line, row) in enumerate(zip(told, rows)):
        test.expect(line[key] == k, "line %d is of %s" % (k, line[key]))
        begin = "%d,%s,%d," % (k, line["answer"], len(line.get("pairs", [])))
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


def a_statement_a_defect(test, report, proof):
    """A proof has a statement of each defect, and one of each feature that has none."""
    told, proved = json.loads(test.read(report)), json.loads(test.read(proof))
    expected = sum(max(len(feature["defects"]), 1) for feature in told["objects"])
    test.expect(len(proved["statements"]) == expected, "%d statements, not %d" % (len(proved["statements"]), expected))


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
