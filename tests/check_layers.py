#!/usr/bin/env python3
"""Reads the #include lines of the tree and refuses what would bend its order.

    tests/check_layers.py [ROOT]

L1  Includes point down: a layer sees only the layers that LAYERS gives it, a folder within a layer only those
    before it in ORDER. The verifier sees nothing of the library. Only oracles (x_by_scan.cpp) see the layer oracle,
    and that shares nothing with what it checks: of number not the folder exact.
L2  Headers of the library are included as <sunder/...>, from the repository's root.
L3  Other people's headers are included only where OUTSIDE allows them.
L4  The core (base to scene) does not print, does not touch files, does not end the process.
    It knows no environment, locale or unseeded random numbers, and keeps to plain IEEE arithmetic: no fused
    multiply-add, no change of the rounding mode.
L5  Sources are ASCII, end with a newline, and hold no tab.
L6  No source is over 600 lines without a line "// long because: ...".
L7  No line of a comment's list is a word or two that a formatter left over: what follows a full line, and is indented
    as an entry is, begins one.
L8  No header gives a type of a namespace within sunder the name of one of sunder itself: which of both is meant
    would depend on what else is included.
L9  ask prints nothing and asks nobody: it knows no stream of the process, no terminal and no environment (ask/talk.h
    has what it tells), and no variable outlives a call.
L10 Only predicate evaluates formulas in stages: nothing else names a stage, a formula or what lifts points to it.
    What needs numbers asks for coordinates<Dyadic>(point).
L11 No two representations of a layer have the same slot, for they may lie in one object (sunder/base/lazy_slots.h).

Tests beside the sources (x_test.cpp, x_test.h) are held to L1, L2, L5 and L6.
Exit code 0: in order. 1: not, one line for each finding. 2: nothing was found to check.
"""
import os
import re
import sys

CORE = ["base", "number", "oracle", "predicate", "certificate", "near", "planar", "solid", "polytope", "scene"]
UP_TO_NEAR = {"base", "number", "predicate", "certificate", "near"}

# layer: the layers that it may include, besides itself
LAYERS = {
    "base": set(),
    "number": {"base"},
    "oracle": {"base", "number"},
    "predicate": {"base", "number"},
    "certificate": {"base", "number", "predicate"},
    "near": {"base", "number", "predicate", "certificate"},
    "planar": UP_TO_NEAR,
    "solid": UP_TO_NEAR | {"planar"},  # searches in planar sequences of vertices, which sections are
    "polytope": UP_TO_NEAR,
    "scene": UP_TO_NEAR | {"planar", "solid", "polytope"},
    "io": set(CORE),
    "robot": set(CORE) | {"io"},
    "picture": set(CORE) | {"io", "robot"},
    "ask": set(CORE) | {"io", "robot", "picture", "verifier"},
    "cli": set(CORE) | {"io", "robot", "picture", "ask", "verifier", "sunder"},
    "python": set(CORE) | {"io", "robot", "picture", "ask", "cli", "verifier", "sunder"},
    "verifier": set(),
    "sunder": set(CORE),
}

FRONT_DOORS = {"sunder/sunder.h", "sunder/version.h"}

# layer: its folders from the lowest to the highest
ORDER = {
    "number": ["exact"],
    "predicate": ["filter", "point", "line", "disc"],
    "planar": ["object", "pair", "sweep", "discs", "segments", "boxes", "polygons", "region"],
    "solid": ["hull", "object", "represent", "search", "exact", "line", "pair", "section", "descent", "drums", "round", "mesh"],
    "polytope": ["object", "represent", "pair", "hull", "region", "tree"],
    "io": ["text", "mesh", "plane", "robot"],
    "ask": ["set", "scene", "pair", "region"],
}

# The first part of a header of somebody else's: where it may be included (tests may include all).
CORE_AND_UP = set(LAYERS)
IO_AND_UP = {"io", "robot", "picture", "ask", "cli"}
OUTSIDE = {
    "boost": CORE_AND_UP,
    "hwy": set(CORE),
    "tbb": {"scene", "ask"},
    "oneapi": {"scene", "ask"},
    "fmt": IO_AND_UP,
    "tinyxml2.h": {"io"},
    "zlib.h": {"io"},
    "nlohmann": IO_AND_UP,
    "CLI": {"cli"},
    "nanobind": {"python"},
}

# The system's own headers that are no part of the C++ standard library but look like it (no folder, ending .h).
SYSTEM_ALLOWED = {"io", "ask", "cli"}

CORE_HEADERS_REFUSED = {
    "iostream", "ostream", "istream", "fstream", "filesystem", "syncstream", "print", "stdio.h", "unistd.h",
}
CORE_CALLS_REFUSED = re.compile(
    r"(?<![\w:.>])(?:(?:std)?::)?((?:f|v|vf)?printf|f?puts|putchar|fwrite|fopen|freopen|abort|exit|_Exit|quick_exit|terminate)\s*\("
    r"|\bstd::(cout|cerr|clog|cin)\b")
CORE_STATE_REFUSED = re.compile(
    r"(?<![\w.>])(?:\w+::)*(fmaf?l?|MulAdd|NegMulAdd|MulSub|fesetround|feholdexcept|feenableexcept|setlocale|getenv|s?rand"
    r"|random_device|strtok)\s*[({]")

ASK_HEADERS_REFUSED = {"unistd.h", "stdio.h", "cstdio", "cstdlib", "stdlib.h", "iostream", "print", "syncstream"}
ASK_REFUSED = re.compile(r"\b(stdout|stderr|stdin|STD(?:IN|OUT|ERR)_FILENO|isatty|(?:secure_)?getenv|std::(?:cout|cerr|clog|cin))\b")
# A variable of a namespace, in column 0, that is not constant; or a static one of a function.
ASK_STATE = re.compile(
    r"^(?!constexpr |const |inline const(?:expr)? |extern const |using |namespace |struct |class |enum |friend |typedef |return )"
    r"[\w:][\w:<>,*& ]* \w+(?:\{[^}]*\}| = [^()]*)?;|^ *(?:static|thread_local) (?!constexpr |const )[\w:<>, ]+ \w+(?:;|\{| =)")
STAGES = re.compile(r"\b(\w+Stage\b|lift<|decide(?:_sharply)?\(&?tally|\w+_formula\b)|sunder/predicate/(?:filter/(?:sharp_stage|stages)|disc/disc_stages)\.h")

CONTRACT = "sunder/base/contract.cpp"  # its one purpose is to say so and to end the process

SOURCES = (".h", ".cpp", ".py", ".cmake", ".sh")
FOLDERS = ["sunder", "cli", "python", "verifier", "tests", "fuzz", "bench", "examples", "cmake"]
LONGEST = 600
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
NAMESPACE = re.compile(r"namespace ((?:\w+)(?:::\w+)*) \{|\}  // namespace (\w+)$")
SLOT = re.compile(r"^ *static constexpr std::size_t slot = (\d+);", re.MULTILINE)
TYPE = re.compile(r"(?:struct|class|enum class|enum|using) (\w+)(?: final)?(?: :.*)? (?:\{|=)")


def without_comments_and_strings(text):
    """The C++ text with comments and literals blanked, lines kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^(\n]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)

# One or two words alone.
LEFT_OVER = re.compile(r"// {3,5}[a-z]+( [a-z]+)?$")


def place_of(path):
    """(layer, folder within the layer) of a path from the root, (None, None) outside of the layers."""
    parts = path.split("/")
    if parts[0] == "sunder":
        layer = parts[1] if len(parts) > 2 else "sunder" if path in FRONT_DOORS else None
        return layer, parts[2] if len(parts) > 3 else None
    if parts[0] in ("cli", "python", "verifier"):
        return parts[0], None
    return None, None


def may_include(path, other):
    """Why the file must not include the header (both from the root), or None."""
    layer, folder = place_of(path)
    other_layer, other_folder = place_of(other)
    if layer is None or other_layer is None:
        return None
    if other_layer == "oracle" and layer != "oracle":
        return None if path.endswith("_by_scan.cpp") else "only oracles, x_by_scan.cpp, may include oracle"
    if layer == "oracle" and (other_layer, other_folder) == ("number", "exact"):
        return "oracles share nothing with number/exact"
    if layer != other_layer:
        if other_layer in LAYERS.get(layer, ()):
            return None
        return "%s may not include %s" % (layer, other_layer)
    if folder == other_folder:
        return None
    order = ORDER.get(layer, [])
    for name in (folder, other_folder):
        if name is not None and name not in order:
            return "the folder %s/%s has no place in ORDER of tests/check_layers.py" % (layer, name)
    if other_folder is None:  # what lies in the layer itself is below its folders
        return None
    if folder is None or order.index(folder) < order.index(other_folder):
        return "%s may not include %s/%s" % (path.rsplit("/", 1)[0], other_layer, other_folder)
    return None


def check_include(path, test, bracket, header):
    layer, _ = place_of(path)
    if bracket == '"':
        if path.startswith("sunder/"):
            yield 'L2: include "%s" from the root: <sunder/...>' % header
            return
        target = os.path.normpath(os.path.join(os.path.dirname(path), header))
        if target.startswith("sunder/") or header.startswith("sunder/"):
            yield 'L2: include "%s" from the root: <sunder/...>' % header
        return
    if header.startswith("sunder/"):
        if place_of(header)[0] not in LAYERS:
            yield "L1: <%s> is in no layer" % header
        elif layer is not None:
            reason = may_include(path, header)
            if reason:
                yield "L1: <%s>: %s" % (header, reason)
        return
    if layer is None or test:
        return
    first = header.split("/")[0]
    if first in ("verifier", "cli", "python"):
        reason = may_include(path, header)
        if reason:
            yield "L1: <%s>: %s" % (header, reason)
    elif first in OUTSIDE:
        if layer not in OUTSIDE[first]:
            yield "L3: <%s> is not for %s" % (header, layer)
        elif layer in CORE and path.endswith(".h") and not path.endswith("_internal.h"):
            yield "L3: <%s>: a public header of the core includes the C++ library only" % header
    elif "/" in header or header.endswith(".hpp"):
        if layer not in SYSTEM_ALLOWED:
            yield "L3: <%s> is not known to OUTSIDE of tests/check_layers.py" % header
    elif layer in CORE and header in CORE_HEADERS_REFUSED:
        yield "L4: <%s>: the core neither prints nor touches files" % header
    elif layer in CORE and header.endswith(".h"):
        yield "L3: <%s>: the core includes standard C++ headers only" % header


def check_file(root, path):
    with open(os.path.join(root, path), "rb") as stream:
        data = stream.read()
    cpp = path.endswith((".h", ".cpp"))
    for number, line in enumerate(data.split(b"\n"), 1):
        if any(byte > 126 or (byte < 32 and byte != 9) for byte in line):
            yield number, "L5: a character that is not ASCII"
        if b"\t" in line:
            yield number, "L5: a tab"
    if data and not data.endswith(b"\n"):
        yield data.count(b"\n") + 1, "L5: no newline at the end"
    text = data.decode("ascii", "replace")
    lines = text.split("\n")
    if data.count(b"\n") > LONGEST and not re.search(r"^\s*(//|#) long because: \S", text, re.MULTILINE):
        yield 1, "L6: %d lines; divide the file, or say '// long because: ...'" % data.count(b"\n")
    if not cpp:
        return
    layer, _ = place_of(path)
    test = re.search(r"_test\.(h|cpp)$", path) is not None
    if path.startswith("sunder/") and layer not in LAYERS:
        yield 1, "L1: the file is in no layer"
    for number in range(2, len(lines) + 1):
        if len(lines[number - 2]) > 100 and re.match(r"// {3,}", lines[number - 2]) and LEFT_OVER.match(lines[number - 1]):
            yield number, "L7: a line of a list with nothing but %r" % lines[number - 1][2:].strip()
    bare = without_comments_and_strings(text).split("\n")
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if match and bare[number - 1].strip():  # not commented out
            for finding in check_include(path, test, match.group(1), match.group(2)):
                yield number, finding
    if layer not in (None, "predicate", "verifier") and not test:
        for number, line in enumerate(bare, 1):
            match = STAGES.search(line)
            if match:
                yield number, "L10: %s: formulas are evaluated in predicate alone" % match.group()
    if layer in CORE and not test and path != CONTRACT:
        for number, line in enumerate(bare, 1):
            match = CORE_CALLS_REFUSED.search(line)
            if match:
                yield number, "L4: %s: the core neither prints nor ends the process" % match.group().strip(" (")
            match = CORE_STATE_REFUSED.search(line)
            if match:
                yield number, "L4: %s: answers depend on the input alone, in plain IEEE arithmetic" % match.group()[:-1]
    if layer == "ask" and not test:
        for number, line in enumerate(bare, 1):
            match = INCLUDE.match(lines[number - 1])
            if match and line.strip() and match.group(2) in ASK_HEADERS_REFUSED:
                yield number, "L9: <%s>: ask prints nothing and asks nobody" % match.group(2)
            match = ASK_REFUSED.search(line)
            if match:
                yield number, "L9: %s: who calls has it; what ask tells goes through ask/talk.h" % match.group()
            if ASK_STATE.match(line):
                yield number, "L9: %s: a call leaves nothing behind" % line.strip()


def sources_of(root):
    for folder in FOLDERS:
        for here, folders, files in os.walk(os.path.join(root, folder)):
            folders[:] = sorted(name for name in folders if name not in ("__pycache__", "results"))
            for name in sorted(files):
                if name.endswith(SOURCES) or name == "CMakeLists.txt":
                    yield os.path.relpath(os.path.join(here, name), root).replace(os.sep, "/")
    for name in ("CMakeLists.txt", "do", ".ci/run"):
        if os.path.isfile(os.path.join(root, name)):
            yield name


def types_of(root, path):
    """(namespace, name, line number) of each type that a header of the library gives a name in a namespace itself."""
    namespace = None
    with open(os.path.join(root, path), encoding="ascii", errors="replace") as stream:
        for number, line in enumerate(stream, 1):
            match = NAMESPACE.match(line)
            if match and match.group(2):
                namespace = namespace and namespace.removesuffix("::" + match.group(2))
            elif match:
                inner = match.group(1)
                namespace = inner if inner.split("::")[0] == "sunder" else "%s::%s" % (namespace, inner)
            match = TYPE.match(line)
            if match and namespace:
                yield namespace, match.group(1), number


def namesakes(root, paths):
    types = [(path, *found) for path in paths for found in types_of(root, path)]
    of_all = {name for _, namespace, name, _ in types if namespace == "sunder"}
    for path, namespace, name, number in types:
        if namespace != "sunder" and name in of_all:
            yield "%s:%d: L8: %s is a type of sunder, too" % (path, number, name)


def shared_slots(root, paths):
    taken = {}
    for path in paths:
        with open(os.path.join(root, path), encoding="ascii", errors="replace") as stream:
            text = stream.read()
        for match in SLOT.finditer(text):
            other = taken.setdefault((place_of(path)[0], match.group(1)), path)
            if other != path:
                yield "%s:%d: L11: %s has slot %s, too" % (path, text.count("\n", 0, match.start(1)) + 1, other, match.group(1))


def check(root):
    """(findings as text, number of files, number of C++ files in layers)"""
    findings, files, in_layers = [], 0, 0
    headers = [p for p in sources_of(root) if re.match(r"sunder/.*(?<!_test)\.h$", p)]
    findings += namesakes(root, headers)
    findings += shared_slots(root, headers)
    for path in sources_of(root):
        files += 1
        in_layers += place_of(path)[0] is not None and path.endswith((".h", ".cpp"))
        findings += ["%s:%d: %s" % (path, number, text) for number, text in check_file(root, path)]
    return findings, files, in_layers


def main(arguments):
    root = arguments[0] if arguments else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    findings, files, in_layers = check(root)
    for finding in findings:
        print(finding)
    print("%d files, %d of them C++ in layers: %d findings" % (files, in_layers, len(findings)))
    return 1 if findings else 0 if in_layers else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
