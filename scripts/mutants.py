#!/usr/bin/env python3
"""Do the calls of cli/calls find a program that is wrong? Changes one thing of it at a time, and runs them.

    scripts/mutants.py BUILD [NUMBER...]    BUILD is a folder where Ninja has built the program; it stays as it is

Of each mutant one file, or the batch that it is compiled in, is compiled and linked with what is there. The subject
that ought to find it runs first, then all others. Prints who found it, or that none did.
"""
import os
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
REPORT, TALK, CALL, SCENE = "sunder/ask/report.cpp", "sunder/ask/talk.cpp", "cli/call.cpp", "sunder/ask/scene/scene_report.cpp"
PROGRAM, ANSWER = "cli/program.cpp", "cli/answer.cpp"
PAIR, SIMPLE, POLYGONS = "sunder/ask/pair/verb_pair.cpp", "sunder/ask/set/verb_simple.cpp", "sunder/ask/set/verb_polygons.cpp"
VERIFY, SEGMENTS = "sunder/ask/verb_verify.cpp", "sunder/ask/set/verb_segments.cpp"

# File, old text (there once), new text, and who ought to find it: subject, or subject:part of a test's name.
MUTANTS = [
    (PROGRAM, '"sunder: {}\\n", io::one_line(text)', '"Sunder: {}\\n", io::one_line(text)', "depth"),
    (TALK, "if (sinks_.note) sinks_.note(", "if (!sinks_.note) sinks_.note(", "pair:not convex"),
    (REPORT, '{"notes", report.notes}', '{"notes", Json::array()}', "pair:not convex"),
    (REPORT, '{"decided_by", report.decided_by},', "", "vertices:Points"),
    (TALK, "if (is_quiet_ || leaves_output_) return;", "if (leaves_output_) return;", "general:Quiet"),
    (TALK, "if (is_quiet_ || leaves_output_) return;", "if (is_quiet_) return;", "general:Standard input and"),
    (REPORT, '{{"sunder", 1},', '{{"sunder", 2},', "depth"),
    (REPORT, "text += fact.text;", "text += fact.key;", "pair:Distances"),
    (REPORT, "json[fact.key] = fact.json;", "json[fact.key] = fact.text;", "pair:Distances"),
    (REPORT, "claims.add_origin(by_this_call(talk, origin));", "claims.add_origin({});", "files:Mending"),
    (ANSWER, 'if (first == "help" || ', "if (", "general:Help"),
    (ANSWER, "if (words.size() > 1) fail_word(first, words[1]);", "", "general:Where"),
    (PROGRAM, "exit_code::bad, error.what(), kind_of", "exit_code::yes, error.what(), kind_of", "depth"),
    (ANSWER, "!io::parse_integer(text, number) || number < 0", "!io::parse_integer(text, number)", "general:Values"),
    (ANSWER, '"nothing is expected at " + io::quote(extra.front())', '"nothing is expected there"', "general:Bad calls"),
    (ANSWER, 'fmt::format("Exit code: {}; {}", verb.codes, other_codes)', 'fmt::format("Exit code: {}", other_codes)', "general:Exit codes"),
    (PROGRAM, "kind_of(error.code()), error.place()", 'kind_of(error.code()), ""', "general:Errors"),
    (CALL, 'if (!takes && has) return given.word + " takes no value; leave it out";', "", "general:Values"),
    (CALL, 'return text + "; a file of that name is " + io::quote("./" + word);', "return text;", "general:meant"),
    ("sunder/ask/outputs.cpp", "return !is_terminal && is_same_file(written, input_of(input));", "return false;", "scene:Scene files"),
    ("sunder/ask/outputs.cpp", "return is_same_file(path, output_of(other.path)); });", "return false && &other; });", "sets:maps"),
    (PAIR, '{"--depth", deep},', "", "depth"),
    (PAIR, '{"--mend", plane},', "", "pair:Planar pairs"),
    (PAIR, "note_hulls(talk, bodies);", "", "pair:not convex"),
    ("sunder/ask/pair/pair_bounded.cpp", '{"kept", is_kept}', '{"kept", !is_kept}', "pair:Distances"),
    (SCENE, "scene.none_meet() && scene.is_kept() ?", "scene.none_meet() ?", "scene_clearance:Tells"),
    ("sunder/ask/scene/verb_scene.cpp", "  draw(talk, call, report);", "  if (false) draw(talk, call, report);", "scene:The arm"),
    (SCENE, 'json["said_of"] = meet_as_hulls(report, pair) ? "hulls"', 'json["said_of"] = meet_as_hulls(report, pair) ? "bodies"', "unread:A bend"),
    (SCENE, 'if (!scene.cell.unit().empty()) report.add', 'if (scene.cell.unit().empty()) report.add', "scene:Scene files"),
    (SCENE, "if (pair.counts) ++meeting;", "++meeting;", "scene:Scene files"),
    (SCENE, '.push_back({bodies[a].name, bodies[b].name})', '.push_back({bodies[b].name, bodies[a].name})', "scene:Scene files"),
    ("sunder/ask/scene/placements.cpp", "if (beyond == 0) return;", "if (beyond < 5) return;", "placements:Say"),
    ("sunder/ask/scene/row_run.cpp", "no proofs are written, as {}", "proofs are written, as {}", "placements:nothing meets"),
    (SEGMENTS, 'add("lines", false', 'add("line", false', "segments:Some"),
    (SEGMENTS, 'if (!file_.layers.empty()) add("layers"', 'if (file_.layers.empty()) add("layers"', "segments:Of a board"),
    (VERIFY, "if (!file.holds()) report.code = std::max(report.code, exit_code::yes);", "", "pair:Certificates"),
    (VERIFY, '{"answer", file.not_made_of->empty() ?', '{"answer", !file.not_made_of->empty() ?', "against"),
    (VERIFY, 'if (!result.left_out.empty()) json["without"] = result.left_out;', "", "unread:left out"),
    (SIMPLE, "if (at.size() > 1) geometry =", "if (at.size() > 9) geometry =", "simple:as GeoJSON"),
    (SIMPLE, 'report.add("rule", call_.strict', 'report.add("law", call_.strict', "simple:Simple polygons"),
    (SIMPLE, "if (mended > 0) text +=", "if (mended > 9) text +=", "simple:Mended"),
    (SIMPLE, "refuse_method(call.method, simple_methods);", "return told(0);", "simple:Simple polygons"),
    (POLYGONS, 'if (grouped()) text += fmt::format(" of {}"', 'if (false) text += fmt::format(" of {}"', "sets:of groups"),
    (POLYGONS, 'if (input_.files.size() > 1) add("files", i.file, j.file);', "", "files:Two files"),
    (POLYGONS, ", among {} only: {}", ", of {} only: {}", "files:Invalid"),
    ("sunder/ask/region/verb_kernel.cpp", "request.rule = planar::PolygonRule::simple;", "", "region:Kernels"),
    ("sunder/io/text/text.cpp", 'if (std::isnan(parsed)) return "is NaN; every number must be finite";', "", "region:Half-spaces"),
    ("sunder/io/text/file.cpp", "no such file; check the name", "there is no such thing; check the name", "pair:Certificates"),
    ("sunder/io/text/npy.cpp", "{} bytes of numbers, but the header says {} x {} of {}", "{}, {}, {}, {}", "polytopes:NPY that"),
    ("sunder/io/robot/joint_values.cpp", 'if (!joints.values.emplace(name, value).second) fail_call', 'if (!joints.values.emplace(name, value).second && false) fail_call', "scene:Bad scenes"),
]


def commands_of(build):
    """How each file is compiled, and how the program is linked."""
    lines = subprocess.run(["ninja", "-C", build, "-t", "commands", "sunder_cli"], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    link = next(line for line in lines if "-o bin/sunder " in line)
    return [line for line in lines if " -c " in line], re.sub(r"^: && | && :$", "", link)


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def make(build, mutant, folder):
    """The program with one thing changed."""
    file, old, new, _ = mutant
    compiles, link = commands_of(build)
    text = read(os.path.join(ROOT, file))
    if text.count(old) != 1:
        raise ValueError("the text is there %d times: %s" % (text.count(old), old))
    source, made, program = (os.path.join(folder, name) for name in ("mutant.cpp", "mutant.o", "sunder"))
    write(source, text.replace(old, new))
    include = "#include <%s>\n" % file
    for command in map(shlex.split, compiles):
        if command[-1].endswith("/" + file):
            command[-1] = source
            break
        if "/batches/" in command[-1] and include in read(command[-1]):  # then all of its batch is compiled
            batch = read(command[-1]).replace(include, '#include "%s"\n' % source)
            command[-1] = os.path.join(folder, "batch.cpp")
            write(command[-1], batch)
            break
    else:
        raise ValueError("is not compiled")
    command[command.index("-o") + 1] = made
    del command[command.index("-MD"):command.index("-o")]
    for words in (command, [program if w == "bin/sunder" else w for w in shlex.split(link)]):
        if words is not command:
            words.insert(words.index("-o"), made)
        done = subprocess.run(words, cwd=build, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise ValueError("does not build: " + done.stderr[:500])
    return program


def run(subjects, part, program):
    runner = os.path.join(ROOT, "cli", "calls_test.py")
    done = subprocess.run([sys.executable, runner, "--stop", "--only", part, *subjects], text=True, check=False,
                          capture_output=True, env={**os.environ, "SUNDER_PROGRAM": program})
    return done.returncode != 0, done.stdout.strip().splitlines()[-1:]


def main():
    build = os.path.abspath(sys.argv[1])
    numbers = [int(word) for word in sys.argv[2:]] or range(len(MUTANTS))
    missed = 0
    for number in numbers:
        file, first = MUTANTS[number][0], MUTANTS[number][3]
        with tempfile.TemporaryDirectory() as folder:
            try:
                program = make(build, MUTANTS[number], folder)
                subject, _, part = first.partition(":")
                found, last = run([subject], part, program)
                if not found:
                    first = "others"
                    found, last = run([], "", program)
                words = "found by " + first if found else "NOT FOUND"
            except ValueError as error:
                found, words, last = False, str(error), ""
        missed += not found
        print("%2d %s: %s %s" % (number, file, words, last), flush=True)
    print("%d mutants, %d not found" % (len(numbers), missed))
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
