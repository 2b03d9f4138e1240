"""What the public headers declare: Doxygen's XML tells the names and the lines; words and code are taken from there."""
import glob
import os
import re
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests"))
from check_contracts import front_doors, functions_of, public_headers, read, words_above, words_behind  # noqa: E402

ALSO_DOORS = ("sunder/io/", "sunder/near/", "sunder/robot/")  # though not in sunder/sunder.h


@dataclass
class Declared:
    name: str  # within sunder::
    path: str
    kind: str  # function, class, enum, typedef, variable
    line: int
    words: str
    code: str


@dataclass
class Header:
    path: str
    is_door: bool
    lines: list
    functions: list = field(default_factory=list)
    types: list = field(default_factory=list)

    def __post_init__(self):
        top = self.lines[:self.lines.index("#pragma once")]
        self.words = "\n".join(line[2:].removeprefix(" ") for line in top if line.startswith("//"))
        self.short = self.path.removeprefix("sunder/")
        self.page = self.short.replace("/", ".") + ".html"
        self.folder = os.path.dirname(self.short)
        self.scope = self.folder.split("/")[0]

    def names(self):
        return list(dict.fromkeys(declared.name for declared in self.functions))


def question_of(name):
    """The name without its method."""
    return re.sub(r"_by_\w+$", "", name)


def first_sentence(words):
    return " ".join(re.match(r".*?[.?!](?=\s|$)|.*", words, re.DOTALL).group().split())


def code_of(lines, first, kind):
    """The declaration: of a function without its body, of a class without what is private."""
    taken = []
    for line in lines[first - 1:]:
        if kind == "function":
            line = re.sub(r"\s*//.*", "", line)
            taken.append(re.sub(r"(?<!=) \{.*|;.*", ";", line))
        elif re.match(r" (private|protected):", line):
            taken = "\n".join(taken).rstrip().split("\n") + ["};"]
        else:
            taken.append(line)
        if taken[-1].endswith(";") if kind == "function" else re.match(r"(\S.*)?;(\s*//.*)?$|\};|  .*\};$", taken[-1]):
            break
    return "\n".join(taken)


def read_headers(root, xml):
    """The headers by path, and the places of all functions, those of inner namespaces too."""
    doors = set(front_doors(root))
    headers = {path: Header(path, path in doors or path.startswith(ALSO_DOORS), read(root, path).split("\n"))
               for path in public_headers(root)}
    found, places = [], set()
    for path in sorted(glob.glob(xml + "/*.xml")):
        for compound in ElementTree.parse(path).getroot().iter("compounddef"):
            name = compound.findtext("compoundname")
            if compound.get("kind") in ("class", "struct") and "<" not in name:
                found.append((name, "class", compound.find("location")))
            for member in compound.iter("memberdef") if compound.get("kind") == "namespace" else []:
                kind, of_type = member.get("kind"), member.findtext("type") or ""
                if kind == "variable" and member.find("initializer") is None:
                    kind = "function"  # declared by the name of its type
                if not of_type.startswith("template"):
                    found.append((name + "::" + member.findtext("name"), kind, member.find("location")))
    for name, kind, place in found:
        header, line, scopes = headers.get(place.get("file")), int(place.get("line")), name.split("::")[1:-1]
        if header is None:
            continue
        line -= header.lines[line - 2].startswith("template")
        places.add((header.path, line))
        inner = len(scopes) > 1 or scopes and not os.path.isdir(os.path.join(root, "sunder", scopes[0]))
        if inner or "operator" in name:
            continue
        code, (start, words) = code_of(header.lines, line, kind), words_above(header.lines, line)
        if kind == "function":
            words = words or words_behind(header.lines, line, line + code.count("\n"))
            if not header.lines[start - 2] and header.lines[start - 3].startswith("//"):
                words = words_above(header.lines, start - 2)[1] + "\n\n" + words  # alone above a group: about it
        (header.functions if kind == "function" else header.types).append(
            Declared(name.removeprefix("sunder::"), header.path, kind, line, words, code))
    for header in headers.values():
        header.functions.sort(key=lambda declared: declared.line)
        header.types.sort(key=lambda declared: declared.line)
    return headers, places


def findings(headers, places, root):
    """A line for each function of a front door that has no words, or is not in the XML."""
    for header in (headers[path] for path in front_doors(root)):
        for declared in header.functions:
            if not declared.words:
                yield "%s:%d: no words about %s" % (header.path, declared.line, declared.name)
        for line, _ in functions_of(header.lines):
            if (header.path, line - header.lines[line - 2].startswith("template")) not in places:
                yield "%s:%d: Doxygen does not know it" % (header.path, line)
