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
