#!/usr/bin/env python3
"""Makes the reference of the library, plain pages, from Doxygen's XML and the words of the headers.

    scripts/api_pages.py [ROOT]

Reads build/docs/xml (by doxygen scripts/Doxyfile), which tells what is declared where; the words are taken from the
headers as they stand there. Writes build/docs/index.html, a page a public header, and a page a public function with all
its overloads. A declaration's own words are those above it in its group, as in tests/check_contracts.py.

Exit code 0: all is well. 1: the pages are there, but a function of a front door has no words, or Doxygen does not know
it, or a link leads nowhere: a line for each. 2: there is no XML.
"""
import glob
import html
import os
import re
import shutil
import sys

SCRIPTS = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [SCRIPTS, os.path.join(SCRIPTS, "..", "tests")]
from api_headers import findings, first_sentence, question_of, read, read_headers  # noqa: E402
from check_papers_table import COLUMNS, tables_of  # noqa: E402

FOLDERS = {
    "planar/pair": "The plane: two objects", "planar/segments": "The plane: sets of segments",
    "planar/discs": "The plane: sets of circles", "planar/boxes": "The plane: sets of boxes",
    "planar/polygons": "The plane: sets of polygons",
    "planar/region": "The plane: what is common to many", "planar/object": "The plane: objects",
    "solid": "Space: bodies, and two of them", "scene": "Space: scenes of many bodies", "certificate": "Certificates",
    "near": "Sets of anything: boxes first", "io": "Files", "": "All of it", "base": "Errors, cost and such",
    "predicate": "Signs of computed coordinates", "number": "Numbers", "planar/sweep": "The orders of sweeps"}
LABELS = (r"(?:Also called|Sources?(?: and method)?|Departures?(?: from the paper)?|Cost|Time|Memory):|Requires|Throws|"
          r"None (?:but the scan )?(?:allocates|throws)|Does not throw|What one might assume and does not hold")
SAYS_LITTLE = re.compile(r"The front doors?[:.]|(?:Cost|Requires|Throws|As above)\b|O\(|$")
SCRIPT = """<script>
document.getElementById("filter").addEventListener("input", event => {
  const words = event.target.value.toLowerCase().split(/\\s+/);
  for (const door of document.querySelectorAll(".door"))
    door.hidden = !words.every(word => door.textContent.toLowerCase().includes(word));
  for (const section of document.querySelectorAll("section"))
    section.hidden = event.target.value !== "" && !section.querySelector(".door:not([hidden])");
});
</script>
"""


def escaped(text):
    return html.escape(text, quote=False)


def with_code(text):
    return re.sub("`([^`]+)`", r"<code>\1</code>", text)


def last(name):
    return name.split("::")[-1]


def page_of(function):
    return "function." + function.replace("::", ".") + ".html"


def read_papers(root):
    """(page, title, item, words in backticks and names of sources) of each row."""
    for path in sorted(glob.glob(root + "/docs/papers/*.md")):
        text = read(root, path)
        for table in tables_of(text):
            columns = [cell.lower() for cell in table[0][1]]
            for _, cells in table[1:] if set(COLUMNS) <= set(columns) else []:
                words = set(re.findall("`([^`]+)`", " ".join(cells)))
                words |= {os.path.basename(word).split(".")[0] for word in words if word.endswith(".cpp")}
                title = text[2:text.index("\n")]
                yield "../../docs/papers/" + os.path.basename(path), title, cells[columns.index("item")], words


class Reference:
    def __init__(self, root, headers):
        self.root, self.folder, self.headers, self.functions, self.targets = root, root + "/build/docs", headers, {}, {}
        for header in headers.values():
            self.targets.update({declared.name: header.page + "#" + declared.name for declared in header.types})
            for declared in header.functions:
                self.functions.setdefault(declared.name, []).append(declared)
        self.targets.update({name: page_of(name) for name in self.functions})
        self.examples = {"examples/" + os.path.basename(path): read(root, path)
                         for path in sorted(glob.glob(root + "/examples/*.cpp"))}
        self.rows = list(read_papers(root))

    def linked(self, text, scope, here="", too_common="[a-z0-9]+"):
        """Escaped, names of types, functions, headers and pages as links, but for those that are usual words."""
        def link(match):
            word = match.group()
            names = [scope + "::" + word] * bool(scope) + [word.removeprefix("sunder::")]
            target = next((self.targets[name] for name in names if name in self.targets), None)
            if word.endswith(".h"):
                meant = [header.page for header in self.headers.values() if ("/" + header.path).endswith("/" + word)]
                target = meant[0] if len(meant) == 1 else None
            elif word.endswith((".md", ".cpp")) and os.path.isfile(os.path.join(self.root, word)):
                target = "../../" + word
            if target in (None, here) or re.fullmatch(too_common, word):
                return word
            return '<a href="%s">%s</a>' % (target, word)
        names = r"(?<![\w/.&])(?:[\w-]+/)*[\w-]+\.(?:h|md|cpp)\b|(?<![\w&])[A-Za-z_]\w*(?:::\w+)*"
        return re.sub(names, link, escaped(text))

    def prose(self, words, scope, here=""):
        """The words as paragraphs: a new one at an empty line, at numbered promises, and where a label begins."""
        blocks = [["p", ""]]
        for line in words.split("\n"):
            kind = "pre" if re.search(r"\S {3,}\S", line) else "item" if re.match(r"\s*([A-Z]\d+\.|-) ", line) else "p"
            goes_on = kind == "p" and line and (blocks[-1][0] == "p" or blocks[-1][0] == "item" and line[0] == " ")
            if goes_on or kind == "pre" == blocks[-1][0]:
                blocks[-1][1] += "\n" + line
            else:
                blocks.append([kind, line])
        out = []
        for kind, text in blocks:
            if kind == "pre":
                out.append("<pre>%s</pre>" % escaped(text))
                continue
            for part in re.split(r"(?<=[.?;:)])\s+(?=%s)" % LABELS, text.strip()):
                linked = with_code(self.linked(part, scope, here, "[A-Z]?[a-z0-9]+"))
                linked = re.sub(r"^(%s|[A-Z]\d+\.)" % LABELS, r"<b>\1</b>", linked)
                out.append("<p class=%s>%s</p>" % (kind, linked) if part else "")
        return "\n".join(out)

    def row(self, name, path=""):
        """Name and first sentence; of a front door also its methods."""
        declared = next((one for one in self.functions[name] if one.path == path), self.functions[name][0])
        header = self.headers[declared.path]
        said = first_sentence(header.words if SAYS_LITTLE.match(declared.words) else declared.words)
        said = "" if path and said == first_sentence(header.words) else with_code(escaped(said))
        methods = [other for other in self.functions if other.startswith(name + "_by_")] if path else []
        links = ['<a href="%s">%s</a>' % (page_of(other), other[len(name) + 4:].replace("_", " ")) for other in methods]
        return '<dt><a href="%s"><code>%s</code></a></dt><dd>%s%s</dd>' % (
            page_of(name), last(name), said, " <span class=small>by %s</span>" % ", ".join(links) if links else "")

    def write(self, page, title, body):
        top = "" if page == "index.html" else '<p class=small><a href="index.html">Sunder: the reference</a></p>'
        with open(os.path.join(self.folder, page), "w", encoding="utf-8") as file:
            file.write('<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" '
                       'content="width=device-width">\n<title>%s - Sunder</title>\n<link rel="stylesheet" '
                       'href="api_pages.css">\n%s\n%s\n</html>\n' % (title, top, "\n".join(filter(None, body))))

    def write_function(self, name, overloads):
        here, plain, scope = page_of(name), last(name), name.rpartition("::")[0]
        out, where = ["<h1>sunder::%s</h1>" % name], []
        for path in dict.fromkeys(declared.path for declared in overloads):
            header, stem, before = self.headers[path], path.removesuffix(".h"), ""
            out.append('<h2><code>#include &lt;<a href="%s">%s</a>&gt;</code></h2>' % (header.page, path))
            for declared in (one for one in overloads if one.path == path):
                out.append("<pre>%s</pre>" % self.linked(declared.code, scope, here))
                out.append(self.prose(declared.words, scope, here) if declared.words != before else "")
                before = declared.words
            out += ["<h3>The header says, of all in it</h3>", self.prose(header.words, scope, here)]
            beside = os.path.dirname(path) + "/" + plain
            for what, files in (("Header", [path]), ("Source", [beside + ".cpp", stem + ".cpp"]),
                                ("Test", [beside + "_test.cpp", question_of(stem) + "_test.cpp"])):
                where += [(what, '<a href="../../%s">%s</a>' % (file, file)) for file in dict.fromkeys(files)
                          if os.path.isfile(os.path.join(self.root, file))]
        where += [("Example", '<a href="../../%s">%s</a>' % (path, path))
                  for path, text in self.examples.items() if re.search(r"\b%s\s*[(<]" % plain, text)]
        where += [("Paper", '<a href="%s">%s</a>: %s' % (page, title, with_code(escaped(item))))
                  for page, title, item, words in self.rows if plain in words | set(map(question_of, words))]
        others = [one for one in self.functions if question_of(one) == question_of(name) and one != name]
        out.append("<h2>The same question</h2><dl>%s</dl>" % "".join(map(self.row, others)) if others else "")
        out.append("<h2>Where</h2><dl>%s</dl>" % "".join("<dt>%s</dt><dd>%s</dd>" % pair for pair in where))
        self.write(here, name, out)

    def write_header(self, header):
        out = ["<h1>%s</h1>" % header.path, self.prose(header.words, header.scope),
               '<p><a href="../../%s">The file</a></p>' % header.path]
        if header.functions:
            rows = (self.row(name, header.path) for name in header.names())
            out.append("<h2>Functions</h2><dl>%s</dl>" % "".join(rows))
        out.append("<h2>Types and constants</h2>" if header.types else "")
        for declared in header.types:
            out += ['<h3 id="%s">%s</h3>' % (declared.name, last(declared.name)),
                    self.prose(declared.words, header.scope),
                    "<pre>%s</pre>" % self.linked(declared.code, header.scope)]
        self.write(header.page, header.path, out)

    def write_index(self):
        out = ["<h1>Sunder: the reference</h1>", "<p>Questions by folder. A plain name is the front door: it picks the "
               "fastest method. <code>#include &lt;sunder/sunder.h&gt;</code> has all but files (<code>io</code>).</p>",
               '<p><input id="filter" placeholder="Filter: a name, or a textbook\'s word: clipping, narrow phase"></p>']
        groups = {folder: [] for folder in FOLDERS}
        for header in self.headers.values():
            groups.setdefault(header.folder if header.folder in FOLDERS else header.scope, []).append(header)
        for folder, headers in groups.items():
            title = FOLDERS.get(folder, folder)
            out.append("<section><h2>%s <span class=small>sunder/%s</span></h2>" % (title, folder) if headers else "")
            for header in (one for one in headers if one.is_door):
                also = re.search(r"Also called: (.*?)\.(?:\s|$)", header.words, re.DOTALL)
                names = [name for name in header.names() if last(name) != "name_of" and (
                    question_of(name) == name or question_of(name) not in self.functions)]
                types = ['<a href="%s#%s"><code>%s</code></a>' % (header.page, one.name, last(one.name))
                         for one in header.types if one.kind in ("class", "enum")]
                out += ['<div class=door><h3>%s <a class=small href="%s">%s</a></h3>' % (
                            with_code(escaped(first_sentence(header.words))), header.page, header.short),
                        "<p class=small>Also called: %s</p>" % " ".join(also.group(1).split()) if also else "",
                        "<dl>%s</dl>" % "".join(self.row(name, header.path) for name in names) if names else "",
                        "<p class=small>Types: %s</p>" % ", ".join(types) if types else "", "</div>"]
            others = ['<a href="%s">%s</a>' % (one.page, one.short) for one in headers if not one.is_door]
            out.append("<p class=small>Other headers: %s</p>" % ", ".join(others) if others else "")
            out.append("</section>" if headers else "")
        self.write("index.html", "The reference", out + [SCRIPT])

    def broken_links(self):
        pages = {os.path.basename(path): read(self.root, path) for path in glob.glob(self.folder + "/*.html")}
        for page, text in sorted(pages.items()):
            for target in re.findall('href="([^"]+)"', text):
                file, _, anchor = target.partition("#")
                there = os.path.exists(os.path.join(self.folder, file))
                if not there or anchor and 'id="%s"' % anchor not in pages[file]:
                    yield "build/docs/%s: there is no %s" % (page, target)


def make(root):
    """(findings as text, number of headers, number of functions)"""
    folder = root + "/build/docs"
    headers, places = read_headers(root, folder + "/xml")
    reference = Reference(root, headers)
    for old in glob.glob(folder + "/*.html"):
        os.remove(old)
    shutil.copy(os.path.join(SCRIPTS, "api_pages.css"), folder)
    for name, overloads in reference.functions.items():
        reference.write_function(name, overloads)
    for header in headers.values():
        reference.write_header(header)
    reference.write_index()
    return [*findings(headers, places, root), *reference.broken_links()], len(headers), len(reference.functions)


def main(arguments):
    root = os.path.abspath(arguments[0] if arguments else os.path.join(SCRIPTS, ".."))
    if not glob.glob(root + "/build/docs/xml/*.xml"):
        print("There is no build/docs/xml: run ./do docs")
        return 2
    found, headers, functions = make(root)
    for finding in found:
        print(finding)
    print("%d headers, %d functions: %d findings" % (headers, functions, len(found)))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
