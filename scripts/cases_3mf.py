#!/usr/bin/env python3
"""Writes the 3MF files of cases/mesh and cases/broken, by Python's zipfile, which shares no code with the reader.

    scripts/cases_3mf.py [FOLDER]    the folder of cases; default: that of the project
"""
import io
import os
import sys
import zipfile

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
LATTICE = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"
TYPES = ('<?xml version="1.0" encoding="UTF-8"?>\n<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
         '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
         '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>\n')


def relationships(*targets):
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
            + "".join(f'<Relationship Target="{target}" Id="r{i}" '
                      'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>'
                      for i, target in enumerate(targets)) + "</Relationships>\n")


def mesh(vertices, triangles):
    return ("<mesh><vertices>\n" + "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>\n' for x, y, z in vertices)
            + "</vertices><triangles>\n" + "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>\n' for a, b, c in triangles)
            + "</triangles></mesh>")


def model(objects, items, more=""):
    return (f'<?xml version="1.0" encoding="UTF-8"?>\n<model unit="millimeter" xmlns="{CORE}"{more}>\n<resources>\n'
            + "\n".join(f'<object id="{i}" name="{name}" type="model">{content}</object>' for i, name, content in objects)
            + "\n</resources>\n<build>\n" + "\n".join(f"<item {item}/>" for item in items) + "\n</build>\n</model>\n")


def package(files, method=zipfile.ZIP_DEFLATED):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        for name, text in files.items():
            entry = zipfile.ZipInfo(name)  # of 1980
            entry.compress_type = method
            archive.writestr(entry, text)
    return out.getvalue()


def package_of(text, others=None, method=zipfile.ZIP_DEFLATED):
    return package({"[Content_Types].xml": TYPES, "_rels/.rels": relationships("/3D/3dmodel.model"),
                    "3D/3dmodel.model": text, **(others or {})}, method)


TETRAHEDRON = mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
CUBE = mesh([(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)],
            [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
             (1, 3, 7), (1, 7, 5)])
PLAIN = model([(1, "tetrahedron", TETRAHEDRON)], ['objectid="1"'])


def good():
    yield "tetrahedron.3mf", package_of(PLAIN)
    yield "cube.3mf", package_of(model([(3, "cube", CUBE)], ['objectid="3"']), method=zipfile.ZIP_STORED)
    # Turned by a quarter, by two mirrors; and twice as large, out of another model of the package.
    mirrored = '<components><component objectid="1" transform="1 0 0 0 -1 0 0 0 1 0 0 0"/></components>'
    root = model([(1, "turned", TETRAHEDRON), (2, "", mirrored)],
                 ['objectid="2" transform="0 1 0 1 0 0 0 0 1 10 0 0"',
                  'p:path="/3D/large.model" objectid="7" transform="2 0 0 0 2 0 0 0 2 10 5 0"'],
                 f' xmlns:p="{PRODUCTION}" requiredextensions="p"')
    yield "two_nodes.3mf", package_of(root, {"3D/_rels/3dmodel.model.rels": relationships("/3D/large.model"),
                                             "3D/large.model": model([(7, "large", TETRAHEDRON)], [])})


def bad():
    plain = package_of(PLAIN)
    yield "truncated.3mf", plain[:-30]
    at = plain.index(b"3D/3dmodel.model") + len("3D/3dmodel.model")
    yield "deflate.3mf", plain[:at] + b"\x07" + plain[at + 1:]
    stored = package_of(PLAIN, method=zipfile.ZIP_STORED)
    yield "checksum.3mf", stored.replace(b'x="1"', b'x="2"')
    yield "bzip2.3mf", package_of(PLAIN, method=zipfile.ZIP_BZIP2)
    entry = plain.rindex(b"PK\1\2")
    yield "encrypted.3mf", plain[:entry + 8] + b"\1" + plain[entry + 9:]
    yield "bomb.3mf", package_of(PLAIN.replace("<build>", "<build>" + " " * 10_000_000))
    yield "no_model.3mf", package({"[Content_Types].xml": TYPES, "_rels/.rels": relationships()})
    yield "model_missing.3mf", package({"_rels/.rels": relationships("/3D/other.model"), "3D/3dmodel.model": PLAIN})
    yield "mismatched.3mf", package_of(PLAIN.replace("</build>", ""))
    yield "index_large.3mf", package_of(PLAIN.replace('v3="1"', 'v3="4"'))
    yield "nan.3mf", package_of(PLAIN.replace('x="1"', 'x="nan"'))
    yield "no_triangles.3mf", package_of(model([(1, "points", mesh([(0, 0, 0)], []))], ['objectid="1"']))
    yield "flat.3mf", package_of(PLAIN.replace('<item objectid="1"', '<item objectid="1" transform="1 0 0 0 1 0 0 0 0 0 0 0"'))
    yield "lattice.3mf", package_of(PLAIN.replace("<model ", f'<model xmlns:b="{LATTICE}" requiredextensions="b" '))


def main():
    cases = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "cases")
    for folder, files in (("mesh", good()), ("broken", bad())):
        for name, data in files:
            with open(os.path.join(cases, folder, name), "wb") as out:
                out.write(data)


if __name__ == "__main__":
    main()
