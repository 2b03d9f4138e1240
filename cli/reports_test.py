#!/usr/bin/env python3
"""Every report of the program is as docs/schema/report.schema.json says, and docs/guide/reports.md says the same.

reports_test.py --write brings the tables of the page up to date.
"""
# long because: the calls that show every key stand in one list
import collections
import concurrent.futures
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "tests"))
import json_schema  # noqa: E402

PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
PAGE = os.path.join(ROOT, "docs", "guide", "reports.md")
with open(os.path.join(ROOT, "docs", "schema", "report.schema.json"), encoding="utf-8") as stream:
    SCHEMA = json.load(stream)
DEFINITIONS = SCHEMA["$defs"]
BEGIN = "## What all have"  # here the tables of the page begin

# What no call can show, and why.
NEVER_SEEN = {
    "#/$defs/error/properties/kind": {"internal": "a fault of the program"},
}

# Keys that may be missing, by the object that holds them: "" is the report.
OPTIONAL = {
    "": "attached hull lemmas left_out not_proved coordinate_systems skipped mended remarks contact enclosed said_of distance depth clearance nearest time cut support planes group layer across_layers count counts "
        "contact_unknown part_unknown partition unit "
        "best contradiction formats",
    "objects[]": "surface why_hull frame moves moved_about departure groups layers left_out coordinate_systems remarks properties box without inputs against call "
                 "proved",
    "objects[].against": "why",
    "objects[].links[].shapes[]": "file",
    "allowed_meeting[]": "point_about",
    "objects[].bodies[].parts[]": "mesh",
    "objects[].departure": "volume_missing_about volume_of_hull_about",
    "distance": "a b face",
    "evidence": "gap_about",
    "depth": "square a b",
    "clearance": "undecided",
    "common": "edge surface nearest furthest point first last hits parts",
    "common.parts[]": "is_next_near",
    "common.parts[].first": "beginning face",
    "common.parts[].last": "face",
    "common.first": "along_edge beginning",
    "common.last": "along_edge",
    "cut": "first last",
    "support": "at",
    "cut.first": "beginning",
    "cut.last": "end",
    "pairs[]": "contact contact_unknown",
    "pairs[].evidence": "face",
    "clearance.closer[]": "points_about",
    "clearance.undecided[]": "points_about",
    "nearest[]": "points_about",
    "contacts[]": "groups layers files lines properties",
    "best": "before side after point",
    "region": "dimension direction_about",
    "sections[]": "area_bounds through",
    "sections[].corners[]": "vertex edge",
}

METHODS = {
    "pair cases/mesh/cube.obj cases/mesh/tetrahedron.ply": "automatic gjk hierarchy bounded polar drums scan",
    "pair cases/planar-pair/plate.wkt cases/planar-pair/wheel.wkt": "difference halving triangles gjk scan",
    "pair cases/outcomes/square.wkt cases/outcomes/lines.csv --feature-b diagonal": "fibonacci scan",
    "pair cases/mesh/cube.obj cases/space/plane.json": "automatic drums scan",
    "pair cases/polytopes/cross.csv cases/polytopes/box.csv": "automatic gjk scan tree",
    "pair cases/mesh/cube.obj cases/space/line.json": "automatic drums scan",
    "pair cases/mesh/cube.obj cases/space/line.json --support": "automatic drums hierarchy scan",
    "pair cases/mesh/cube.obj cases/space/kite.wkt": "automatic drums gjk scan",
    "scene cases/mesh/cube.obj cases/mesh/cube.obj@0.5,0,0": "automatic gjk hierarchy bounded polar scan",
    "segments cases/segments/wires.csv": "automatic grid sweep bentley-ottmann scan",
    "segments cases/outcomes/intervals.csv": "intervals",
    "segments cases/outcomes/drawing_plane.csv --allow shared-endpoint": "drawing",
    "polygons cases/planar-pair/panes.wkt": "convex",
    "segments cases/segments/wires.csv --all": "automatic grid bentley-ottmann balaban scan",
    "simple cases/valid-polygons/several.wkt": "automatic scan",
    "simple cases/mesh/crossed.obj": "automatic scan",
    "circles cases/outcomes/circles.csv": "automatic grid sweep scan",
    "boxes cases/outcomes/boxes.csv": "automatic scan",
    "polygons cases/outcomes/polygons.wkt": "automatic boxes grid sweep scan",
    "region cases/outcomes/half_planes_bounded.csv": "automatic sort division scan",
    "region cases/polytopes/box.csv --maximize 1,2,3,4": "automatic seidel scan",
    "region --of circles cases/outcomes/discs_region.csv": "automatic division scan",
    "region --of polygons cases/outcomes/convex_bounded.wkt": "automatic edges division scan",
    "kernel cases/outcomes/star_bounded.wkt": "automatic half-planes lee-preparata scan",
    "section cases/mesh/cube.obj --plane z=-1:1:0.5": "automatic scan",
}

# NAME stands for a file of the folder that is written below; OUT, for an output in it.
MORE = """
pair cases/mesh/cube.obj cases/mesh/cube.obj --pose-b 2,0,0 --classify --certificate OUT
pair cases/mesh/cube.obj cases/panda/meshes/collision/link3.stl
pair cases/mesh/cube.obj cases/panda/meshes/collision/link3.stl --hull
pair cases/mesh/cube.obj open.obj --pose-a 0.25,0,0,2,0,0.25,0,2,0,0,0.25,2 --certificate OUT
pair cases/mesh/cube.obj open.obj
pair cases/space/ball.json cases/mesh/bracket.obj --pose-b 9,0,0,-2.5,0,9,0,-4.5,0,0,9,-4.5 --method scan
pair cases/mesh/bracket.obj cases/space/above.json --pose-a 0,0,2
pair mixed.obj between.json
pair gap.obj through.json
scene balls.json
pair cases/mesh/cube.obj cases/mesh/bracket.obj --pose-a 0.25,0,0,0.5,0,0.25,0,0.5,0,0,0.25,0.5
pair cases/mesh/cube.obj cases/mesh/tetrahedron.obj --pose-b 3,4,5 --distance --clearance 1 --certificate OUT
pair cases/mesh/cube.obj cases/mesh/tetrahedron.obj --pose-b 3,0.25,0.125 --distance
pair cases/mesh/cube.obj cases/mesh/tetrahedron.obj --pose-b 0.25,0,0 --depth --certificate OUT
pair cases/space/ball.json cases/space/capsule.json --pose-b 1,0,-2 --depth --certificate OUT
pair vast.obj vast.obj --depth
pair left.obj right.obj --distance --clearance 1
pair left.obj right.obj --radius-a 1 --distance --clearance 1
scene left.obj right.obj --distance
pair cases/mesh/cube.obj cases/mesh/tetrahedron.obj --pose-b 3,0.25,0.125 --to-b -3,0.25,0 --certificate OUT
pair cases/mesh/cube.obj cases/mesh/cube.obj --pose-b 3,2,0 --to-b -3,2,0 --to-a 0,1,0
pair cases/mesh/cube.obj cases/space/ball.json --pose-b 9,0.25,0.125 --to-b -9,0.25,0 --certificate OUT
pair cases/mesh/cube.obj cases/mesh/cube.obj --radius-a 0.5 --pose-b 3,2,0 --to-b -3,2,0
pair cases/planar-pair/plate.wkt cases/planar-pair/wheel.wkt --distance --clearance 0.1 --classify --svg OUT
pair cases/planar-pair/plate.wkt cases/planar-pair/wheel.wkt --clearance 1 --certificate OUT
pair cases/planar-pair/plate.wkt cases/planar-pair/plate.wkt --distance --clearance 1
pair cases/planar-pair/dented.wkt cases/planar-pair/plate.wkt --hull
pair cases/planar-pair/plate.wkt cases/planar-pair/paths.csv --feature-b diagonal --svg OUT
pair cases/planar-pair/plate.wkt cases/planar-pair/paths.csv --feature-b roof
pair cases/planar-pair/plate.wkt cases/planar-pair/paths.csv --feature-b corner --classify
pair cases/planar-pair/plate.wkt cases/planar-pair/paths.csv --feature-b beam --certificate OUT
pair cases/planar-pair/plate.wkt cases/planar-pair/paths.csv --feature-b river
pair cases/planar-pair/plate.wkt cases/planar-pair/paths.csv --feature-b hill
pair cases/planar-pair/paths.csv cases/planar-pair/plate.wkt --feature-a east
pair cases/mesh/cube.obj cases/space/plane.json --classify --certificate OUT
pair cases/mesh/cube.obj cases/space/line.json --support --pose-a 3,0,0 --certificate OUT
pair cases/mesh/cube.obj cases/space/line.json --support --pose-a 0.5,0.5,0.5
pair cases/mesh/cube.obj cases/space/line.json --support --pose-a 0.5,0.25,0
pair cases/mesh/cube.obj cases/space/edge.json --support
pair cases/mesh/tetrahedron.obj cases/space/edge.json --pose-b -0.5,-0.5,-0.5 --support --method drums
pair cases/space/above.json cases/mesh/cube.obj
pair cases/mesh/cube.obj cases/space/ball.json --classify --certificate OUT
pair cases/mesh/cube.obj cases/space/cylinder.json --classify --certificate OUT
pair cases/space/ellipsoid.json cases/space/cone.json --pose-a 0,0,1 --classify --certificate OUT
pair cases/space/ball.json cases/space/capsule.json --clearance 1 --certificate OUT
pair cases/space/ball.json cases/space/capsule.json --clearance 2 --certificate OUT
pair cases/mesh/cube.obj cases/mesh/tetrahedron.obj --pose-b 3,4,5 --radius-a 1 --radius-b 0.5 --certificate OUT
pair cases/space/cylinder.json cases/space/cone.json --pose-b 5,0,0 --distance --clearance 1 --certificate OUT
pair cases/space/cylinder.json cases/space/cone.json --pose-b 5,0,0 --clearance 1.2 --certificate OUT
pair cases/space/tip.json cases/space/beside.json --distance --clearance 1e-300
pair cases/mesh/cube.obj cases/space/rim.json --classify
pair cases/space/plane.json cases/space/line.json --certificate OUT
pair cases/space/plane.json cases/space/above.json
pair cases/space/plane.json cases/space/tilted.json --classify
pair cases/space/ray.json cases/space/line.json --certificate OUT
pair cases/space/ray.json cases/space/ray.json --certificate OUT
pair cases/space/ray.json cases/space/back.json
pair cases/mesh/cube.obj cases/space/plane.json --pose-a 0,0,4
pair cases/mesh/cube.obj cases/space/line.json --classify --certificate OUT
pair cases/mesh/cube.obj cases/space/ray.json --classify --certificate OUT
pair cases/mesh/cube.obj cases/space/edge.json
pair cases/mesh/cube.obj cases/space/diagonal.wkt --distance
pair cases/mesh/cube.obj cases/space/needle.json
pair cases/mesh/cube.obj cases/space/edge.wkt
pair cases/mesh/cube.obj cases/space/kite.json --certificate OUT
pair cases/mesh/cube.obj cases/space/kite.wkt --certificate OUT
pair cases/mesh/cube.obj cases/space/bent.json --project 0,0,0,1,0,0,0,1,0
pair cases/mesh/cube.obj cases/space/bent.json
pair cases/polytopes/cross.csv cases/polytopes/cube.csv --pose-b 2.5,0,0,0 --certificate OUT
pair cases/polytopes/cross.csv cases/polytopes/simplex.csv
pair cases/polytopes/cross.csv cases/polytopes/box.npy --half-spaces-b --pose-b 2.5,0,0,0 --method columns --hyperplanes
pair cases/polytopes/cross.csv cases/polytopes/cube.csv --poses-b cases/polytopes/poses.csv --method columns
pair shapes.csv shapes.csv --feature-a p --feature-b s --distance
pair mixed.wkt cases/planar-pair/plate.wkt --leave-out
pair repeated.wkt cases/planar-pair/plate.wkt --mend
pair pyramid.obj pyramid.obj --pose-b TWIST
scene cases/panda/panda.urdf --allow adjacent --allow touch --joints-file cases/scene/folded.joints
scene cases/panda/panda.urdf --hull --allow adjacent --joints-file cases/scene/folded.joints
scene cases/panda/panda.urdf --hull --joints-file cases/scene/folded.joints --allow adjacent --check-allowed
scene cases/mesh/bracket.obj cases/mesh/cube.obj@1.5,1.5,0 --classify --certificate OUT
pair cases/mesh/bracket.obj cases/mesh/cube.obj --pose-b 1.5,1.5,0 --classify --certificate OUT
pair cases/mesh/bracket.obj cases/mesh/bracket.obj --classify --certificate OUT
pair cases/mesh/bracket.obj cases/mesh/cube.obj --pose-b 0.5,0.5,0.5 --classify --certificate OUT
pair cases/mesh/cube.obj cases/mesh/bracket.obj --pose-a 0.5,0.5,0.5 --classify --certificate OUT
pair cases/mesh/cube.obj cases/mesh/bracket.obj --pose-a 0.25,0,0,0.5,0,0.25,0,0.5,0,0,0.25,0.5 --classify --certificate OUT
pair cases/mesh/bracket.obj cases/mesh/cube.obj --pose-b 0.25,0,0,0.5,0,0.25,0,0.5,0,0,0.25,0.5 --classify --certificate OUT
pair cases/mesh/bracket.obj mixed.obj --classify
scene cases/panda/panda.urdf --joints panda_joint1=0.5 --joints home:panda_joint2=0.1 --svg OUT --classify
scene cases/mesh/arm.urdf --leave-out --srdf cases/scene/arm.srdf --state up --state hand/open --certificate OUT
scene cases/mesh/two_nodes.dae cases/mesh/two_nodes.wrl@0,0,9 cases/mesh/two_nodes.gltf@0,9,0 --groups
scene left=cases/scene/primitives.urdf right=cases/scene/primitives.urdf@4,0,0 cases/mesh/cube.obj --attach cube=left/load --joints right/hoist=1
scene cases/scene/primitives.urdf --joints hoist=1.125 --classify --certificate OUT
scene cases/panda/panda.urdf --allow adjacent --joints-file cases/scene/folded.joints --joints-file cases/scene/ready.joints --clearance 0.01 --margin panda_link5,panda_link7=0.02 --distance
scene cases/scene/nearly.urdf --joints way=1 --clearance 1e-33 --distance
scene cases/scene/nearly.urdf --joints way=1
scene cases/scene/nearly.urdf --joints way=1 --allow adjacent
scene cases/scene/wire.urdf --classify
scene cases/scene/workcell.json --classify --certificate OUT
scene cases/scene/ghost.urdf --leave-out
scene cases/scene/never.urdf --srdf cases/scene/never.srdf
scene cases/mesh/arm.urdf --leave-out --srdf cases/scene/arm.srdf --group upper_arm
scene cases/scene/in-cm.json
scene cases/scene/in-mm.json cases/mesh/cube.obj@9,0,0
scene cases/scene/in-inches.json
scene cases/scene/in-feet.json
info cases/scene/primitives.urdf
info cases/scene/workcell.json
scene cases/mesh/cube.obj cases/mesh/cube.obj@1,0,0 cases/mesh/cube.obj@9,0,0 --allow cube,cube#2 --certificate OUT
segments cases/boards/two_nets.kicad_pcb --centre-lines
segments cases/boards/crossing_nets.kicad_pcb --centre-lines --all --across-layers --geojson OUT
segments cases/boards/crossing_nets.kicad_pcb --centre-lines --layer F.Cu --count
segments cases/segments/pond.geojson --group feature --all --allow shared-endpoint --svg OUT
segments cases/segments/paths.wkt --count --allow touch --certificate OUT
segments empty.wkt --all
segments parcels.geojson --all --property owner --property tags --geojson OUT
simple empty.wkt --strict
simple mendable.geojson --mend
simple mendable.geojson --skip-invalid --name title
simple parcels.geojson --property owner --property public --all --geojson OUT
simple cases/outcomes/mixed.wkt --leave-out --all
simple cases/mesh/unused-outside.obj --leave-out --all
simple cases/valid-polygons/pocket.wkt --self-touch --certificate OUT
polygons flat.wkt --mend
region --of circles sited.csv
circles sited.csv
boxes cases/coordinate-systems/fence.csv
info sited.csv
simple cases/valid-polygons/several.wkt --all --geojson OUT
circles cases/outcomes/circles_named.csv --group owner --all --property owner --svg OUT
circles cases/outcomes/circles_touching.csv --count --allow touch
boxes cases/outcomes/boxes.csv --group owner --all --property name --csv OUT
boxes cases/outcomes/boxes_touching.csv --count --allow touch
boxes cases/outcomes/square.wkt
polygons empty.wkt
polygons parcels.geojson --all --property owner --property area --property public --csv OUT
polygons cases/outcomes/polygons.geojson --group owner --all --geojson OUT
polygons cases/outcomes/square.wkt cases/outcomes/within.wkt --all --svg OUT
polygons cases/outcomes/polygons.wkt --count --allow shared-endpoint --certificate OUT
polygons cases/outcomes/hourglasses.wkt --skip-invalid --count
region cases/half-planes/co2-five-years.csv --maximize 1,0 --certificate OUT
region cases/outcomes/half_planes_unbounded.csv --maximize 1,1 --svg OUT
region cases/outcomes/half_planes_unbounded.csv --maximize -1,-1
region cases/outcomes/half_planes_bounded.csv --maximize 0,-1
region cases/outcomes/half_planes_bounded.csv --maximize 0,0
region cases/outcomes/half_planes_empty.csv --maximize 1,0
region cases/polytopes/wedge.csv
region cases/polytopes/wedge.csv --maximize 1,1,1 --certificate OUT
region cases/polytopes/wedge.csv --maximize -1,-1,0
region cases/polytopes/facet.csv --certificate OUT
region cases/polytopes/box.csv --maximize 1,0,0,0
region cases/polytopes/box.csv --maximize 0,0,0,0
region cases/polytopes/empty.csv --maximize 1,0,0,0
region cases/polytopes/box.csv --method seidel
region cases/polytopes/box.csv --maximize 1,0
region cases/polytopes/cube.csv --of half-spaces
region --of polygons empty.wkt --mend
region --of polygons cases/outcomes/star_bounded.wkt cases/planar-pair/panes.wkt --skip-invalid
kernel empty.wkt --svg OUT
kernel mendable.geojson --mend --name title
kernel cases/outcomes/mixed.wkt --leave-out --certificate OUT
kernel cases/outcomes/hourglasses.wkt --skip-invalid
hull cases/mesh/cube.stl --out OUT.off --certificate OUT
hull two_points.obj
hull cases/polytopes/pyramid.csv --out OUT.csv --certificate OUT
hull cases/polytopes/line.csv
hull cases/polytopes/place.csv
hull cases/polytopes/square.csv
hull cases/polytopes/octahedron.csv
hull cases/polytopes/box.csv --out OUT.csv --certificate OUT
hull cases/polytopes/facet.csv
hull cases/polytopes/apex.csv
hull cases/polytopes/empty.csv
hull cases/polytopes/wedge.csv --certificate OUT
hull cases/polytopes/interval.csv
hull cases/polytopes/corner.csv
hull cases/polytopes/box.npy --half-spaces
hull cases/polytopes/cube.csv --out OUT.obj
section cases/mesh/cube.obj --plane 1,1,1,1.5 --plane 1,1,0,1 --plane x=0.25 --out OUT.obj --certificate OUT --svg OUT.svg
section cases/mesh/cube.obj --plane cases/space/tilted.json --plane cases/space/plane.json --certificate OUT
section cases/mesh/cube.obj --plane cases/space/line.json
section cases/mesh/cube.obj --plane z=3 --plane z=-3 --pose 0,0,1 --out OUT.wkt
section cases/panda/meshes/collision/link3.stl --plane z=0
section cases/mesh/two_parts.obj --plane z=0 --leave-out
section cases/mesh/cube.obj --plane z=1:0:1
section cases/mesh/cube.obj --plane z=1 --out OUT.frob
polar cases/mesh/cube.obj --check --out OUT.off
polar cases/mesh/two_parts.obj --origin 0.1,0.1,0.1 --leave-out
polar cases/mesh/points.off
polar cases/mesh/cube.obj --origin 1,0,0
polar cases/panda/meshes/collision/link3.stl --check
info --formats
info shapes.csv
info empty.wkt cases/mesh/cube.obj
verify PROOF
verify PROOF --against cases/outcomes/segments.csv
verify PROOF --against cases/segments/wires.csv
verify PROOF missing PROOF
verify missing
verify cases/mesh/cube.obj cases/certificates/refused/parted_second_statement.json
help frob
frob
pair cases/mesh/cube.obj
pair cases/mesh/cube.obj cases/mesh/cube.obj --pose-b 0,0,0,0,0,0,0,0,0,0,0,0
pair cases/mesh/cube.obj cases/panda/meshes/collision/link3.stl --require-convex
pair cases/mesh/cube.obj cases/mesh/cube.obj --jsno
scene cases/panda/panda.urdf --joints nothing=1
segments cases/segments/wires.csv --method frob
segments cases/segments/wires.csv --allow frob
segments cases/segments/wires.csv --certificate cases/segments/wires.csv
segments cases/segments/wires.csv --svg OUT --svg-limit 1
circles cases/outcomes/circles.csv --group frob
polygons parcels.geojson --property frob
polygons cases/outcomes/square.wkt cases/outcomes/square.wkt cases/outcomes/square.wkt
region cases/outcomes/half_planes_bounded.csv --of frob
kernel cases/outcomes/star_bounded.wkt --feature frob
hull cases/mesh/cube.obj --out OUT.frob
info
"""

FILES = {
    "shapes.csv": "kind,x1,y1,x2,y2,name\npoint,0,0,p\nsegment,1,0,2,0,s\n",
    "mixed.wkt": "POLYGON ((0 0, 1 0, 1 1, 0 0))\nMULTIPOINT ((5 5), (6 6))\n",
    "repeated.wkt": "POLYGON ((0 0, 1 0, 1 0, 1 1, 0 0))\n",
    "empty.wkt": "POLYGON EMPTY\nPOLYGON ((0 0, 1 0, 1 1, 0 0))\nPOLYGON ((0 0, 1 0, 0 1, 0 0))\n",
    "two_points.obj": "v 0 0 0\nv 1 0 0\n",
    "pyramid.obj": "".join("v %r %r 0\n" % (math.cos(math.pi * i / 2), math.sin(math.pi * i / 2)) for i in range(4))
                   + "v 0 0 1\n",
    # Lengths beyond the range of doubles.
    "vast.obj": "".join("v %d.7e308 %d.7e308 %d.7e308\n" % xyz for xyz in itertools.product((-1, 1), repeat=3)),
    "open.obj": "v 0 0 0\nv 6 0 0\nv 0 6 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 1 4 3\n",
    "mixed.obj": "v 0 0 0\nv 6 0 0\nv 0 6 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nv 9 0 0\nv 9 1 0\nv 9 0 1\nf 5 6 7\n",
    "balls.json": '{"bodies": [{"name": "g", "parts": [{"mesh": "gap.obj"}]}, {"name": "b", "parts": [{"ball": {"center": [2.5, 0.5, 0.5], "radius": 1}}]}]}',
    "between.json": '{"plane": {"normal": [1, 0, 0], "offset": 8}}', "through.json": '{"ray": [[-3.5, 0.5, 0.5], [4.5, 0.5, 0.1]]}',
    # Two boxes; between their sides there is a last bit, and on the ray, whose way is of no doubles, from one to the other no double.
    "gap.obj": "".join("v %r %d %d\n" % (x, y, z) for ends in ((-4.0, 1.0), (1.0000000000000002, 2.0)) for z in (0, 1) for y in (0, 1) for x in ends)
               + "".join("f %d %d %d %d\n" % tuple(8 * k + i for i in face) for k in (0, 1) for face in (
                   (1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6))),
    "left.obj": "v -1.7e308 0 0\nv -1.6e308 0 0\nv -1.7e308 1e307 0\nv -1.7e308 0 1e307\n",
    "right.obj": "v 1.7e308 0 0\nv 1.6e308 0 0\nv 1.7e308 1e307 0\nv 1.7e308 0 1e307\n",
    "sited.csv": "x,y,r\n0,0,2\n1,1,2\n", "sited.prj": "EPSG:28992\n", "shapes.prj": "EPSG:28992\n",
    "flat.wkt": "POLYGON ((0 0, 4 0, 4 4, 0 0))\nPOLYGON ((1 0, 2 0, 1 0, 1 0))\n",
    "parcels.geojson": json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": properties, "geometry": {"type": "Polygon", "coordinates": [
            [[at, 0], [at + 2, 0], [at + 2, 2], [at, 0]]]}}
        for at, properties in enumerate(({"owner": "a", "area": 2.5, "public": True, "tags": [1]}, {"owner": None}))]}),
    "mendable.geojson": json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"title": name}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
        for name, ring in (("open", [[0, 0], [1, 0], [1, 1], [0, 1]]), ("whole", [[5, 0], [6, 0], [6, 1], [5, 0]]))]}),
}
# The pyramid and its copy over it, turned by less than a double can tell: no search decides this.
TWIST = ",".join("%r" % float.fromhex(x) for x in (
    "1", "0", "-0x1.97bc0c83a2d44p-31", "0", "0", "1", "-0x1.70c293018f74fp-31", "0",
    "0x1.97bc0c83a2d44p-31", "0x1.70c293018f74fp-31", "1", "1"))

# What each case file is asked; what it does not answer is an error with a report, too.
QUESTIONS = """
pair FILE FILE --leave-out
pair FILE FILE --mend --drop-z
scene FILE --leave-out
segments FILE
segments FILE --leave-out --drop-z --count
simple FILE
simple FILE --leave-out --drop-z --mend
circles FILE --count
polygons FILE
polygons FILE --leave-out --drop-z --mend --skip-invalid --count
region FILE
region FILE --of circles
region FILE --of polygons --leave-out --drop-z --mend --skip-invalid
kernel FILE
kernel FILE --leave-out --drop-z --mend --skip-invalid
hull FILE
hull FILE --leave-out
polar FILE
info FILE
"""


def case_files():
    for folder, _, names in sorted(os.walk(os.path.join(ROOT, "cases"))):
        for name in sorted(names):
            if not name.endswith((".md", ".txt", ".tsv")) and name != "LICENSE":
                yield os.path.relpath(os.path.join(folder, name), ROOT)


def run(*words):
    return subprocess.run([PROGRAM, *words], cwd=ROOT, capture_output=True, check=False)


def plain_calls(folder):
    """Calls as words, and each certificate; files of FILES are in the folder."""
    proof = os.path.join(folder, "proof.json")
    known = {name: os.path.join(folder, name) for name in FILES} | {"PROOF": proof, "TWIST": TWIST}
    for name, text in FILES.items():
        with open(known[name], "w", encoding="utf-8") as stream:
            stream.write(text)
    run("segments", "cases/segments/wires.csv", "--certificate", proof)
    for number, line in enumerate(MORE.strip().split("\n")):
        out = os.path.join(folder, "out%d" % number)
        yield [known.get(word, out + word[3:] if word.startswith("OUT") else word) for word in line.split()]
    for call, methods in METHODS.items():
        for method in methods.split():
            yield [*call.split(), "--method", method]
    from proofs_page_test import ROWS
    for row in ROWS:
        yield row.words()
    for file in case_files():
        if os.path.join("cases", "certificates") in file:
            yield ["verify", file]


def questions_of_files():
    """For each folder and ending, and each of QUESTIONS: the calls that ask it of these files."""
    alike = collections.defaultdict(list)
    for file in case_files():
        if os.path.join("cases", "certificates") not in file:
            alike[os.path.dirname(file), os.path.splitext(file)[1]].append(file)
    for files, line in itertools.product(alike.values(), QUESTIONS.strip().split("\n")):
        yield [[file if word == "FILE" else word for word in line.split()] for file in files]


def normal(path):
    return ".".join("[]" if isinstance(step, int) else step for step in path).replace(".[]", "[]")


def places(value, path=()):
    """Each value inside, with the way there."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for step, inner in items:
        yield path + (step,), inner
        yield from places(inner, path + (step,))


def changed(report, path, change):
    """A copy in which change(holder, step) was done at the path; it shares what is not on the way there."""
    copy = holder = report.copy()
    for step in path[:-1]:
        holder[step] = holder[step].copy()
        holder = holder[step]
    change(holder, path[-1])
    return copy


def other_types(value):
    """Values of other types: none of them is right where this one is."""
    if isinstance(value, bool):
        return [{"mutant": 1}, str(value), 1]
    if isinstance(value, int):
        return [{"mutant": 1}, str(value), value + 0.5, -1 - value]
    if isinstance(value, float):
        return [{"mutant": 1}, str(value)]
    if isinstance(value, dict):
        return [7, [value], "mutant"]
    return [{"mutant": 1}, [[[[value]]]], *([] if value is None else [7])]


class Reports(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.schema = json_schema.Schema(SCHEMA)
        cls.wrong, cls.telling, cls.count = [], [], collections.Counter()
        with tempfile.TemporaryDirectory() as folder:
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                cls.look_at_all(pool, list(plain_calls(folder)))
                questions = list(questions_of_files())
                first = iter(cls.look_at_all(pool, [call for calls in questions for call in calls[:4]]))
                # What is an error of one kind for the first four files of a folder is not asked of the others.
                kinds = [{next(first) for _ in calls[:4]} for calls in questions]
                cls.look_at_all(pool, [call for calls, kind in zip(questions, kinds) for call in calls[4:]
                                       if len(kind) > 1 or None in kind])

    @classmethod
    def look_at_all(cls, pool, calls):
        """Of each call the kind of its error; None: there is none."""
        return [cls.look(words, done) for words, done in
                zip(calls, pool.map(lambda words: run(*words, "--json"), calls))]

    @classmethod
    def look(cls, words, done):
        try:
            report = json.loads(done.stdout)
        except ValueError:
            cls.wrong.append((words, done.returncode, done.stdout[:80], done.stderr[:200]))
            return None
        before = len(cls.schema.seen)
        faults = cls.schema.faults(report)
        answer = "error" if "error" in report else report["answer"]
        is_told = done.returncode < 2 or done.stderr.decode().endswith("sunder: %s\n" % report["error"]["text"]) or \
            report["verb"] == "verify"
        if faults or (done.returncode >= 2) != (answer == "error") or not is_told:
            cls.wrong.append((words, done.returncode, faults[:3], done.stderr[:200]))
        notes = [line[14:] for line in done.stderr.decode().split("\n") if line.startswith("sunder: note: ")]
        if answer != "error" and notes != report["notes"]:
            cls.wrong.append((words, "notes", notes))
        cls.count[report["verb"], answer] += 1
        if len(cls.schema.seen) > before:
            cls.telling.append(report)
        return report["error"]["kind"] if answer == "error" else None

    def test_all_are_right(self):
        self.assertEqual(self.wrong, [])

    def test_each_verb_with_each_answer(self):
        told = {verb: {answer for of, answer in self.count if of == verb} for verb, _ in self.count}
        some, set_verb = {"feasible", "infeasible", "error"}, {"none", "some", "error"}
        self.assertEqual(told, {
            "pair": {"apart", "meet", "undecided", "error"}, "scene": set_verb | {"undecided"}, "segments": set_verb, "circles": set_verb,
            "boxes": set_verb, "polygons": set_verb,
            "simple": {"valid", "not valid", "simple", "not simple", "error"}, "region": some,
            "kernel": some, "hull": {"point", "segment", "polygon", "body", "polytope", "empty", "unbounded", "error"}, "section": set_verb,
            "polar": {"body", "error"},
            "info": {"read", "error"},
            "verify": {"accepted", "refused", "error"}, None: {"error"}})
        self.assertGreater(sum(self.count.values()), 4000)
        print("\n%d reports: %s" % (sum(self.count.values()), ", ".join(
            "%s %s %d" % (verb, answer, n) for (verb, answer), n in sorted(self.count.items(), key=str))))

    def test_each_place_of_the_schema_was_seen(self):
        unseen = set()

        def walk(rule, place):
            if isinstance(rule, bool):
                return
            if place not in self.schema.seen:
                unseen.add(place)
                return
            unseen.update("%s=%s" % (place, json.dumps(value)) for value in rule.get("enum", [])
                          if "%s=%s" % (place, json.dumps(value)) not in self.schema.seen)
            for word, inner in rule.items():
                if word in ("properties", "$defs"):
                    for key, one in inner.items():
                        walk(one, "%s/%s/%s" % (place, word, key))
                elif word in ("oneOf", "allOf"):
                    for k, one in enumerate(inner):
                        walk(one, "%s/%s/%d" % (place, word, k))
                elif word in ("items", "then", "else", "additionalProperties"):
                    walk(inner, "%s/%s" % (place, word))

        walk(SCHEMA, "#")
        allowed = {"%s=%s" % (place, json.dumps(value)) for place, values in NEVER_SEEN.items() for value in values}
        self.assertEqual(unseen, allowed)

    def test_mutants_are_refused(self):
        schema, done, kept, refused = json_schema.Schema(SCHEMA), set(), collections.defaultdict(set), 0
        for report in self.telling:
            short = {key: value[:40] if isinstance(value, list) else value for key, value in report.items()}
            for path, value in places(short):
                key = (report["verb"], "error" in report, normal(path), type(value))
                if key in done:
                    continue
                done.add(key)
                is_of_file = "properties" in path[:-1]  # any simple value
                mutants = [changed(short, path, lambda holder, step, other=other: holder.__setitem__(step, other))
                           for other in other_types(value) if isinstance(other, (dict, list)) or not is_of_file]
                is_named = isinstance(path[-1], str) and not is_of_file and normal(path[:-1]) not in (
                    "placements[].joints", "objects[].accepted")  # names that files give
                if is_named:
                    mutants.append(changed(short, path, lambda holder, step: holder.update(mutant=holder.pop(step))))
                    lost = changed(short, path, lambda holder, step: holder.pop(step))
                    if schema.is_right(lost):
                        kept[normal(path[:-1])].add(path[-1])
                    else:
                        refused += 1
                for mutant in mutants:
                    self.assertFalse(schema.is_right(mutant), (report["verb"], path, value))
                refused += len(mutants)
        self.assertEqual({place: sorted(keys) for place, keys in kept.items()},
                         {place: sorted(keys.split()) for place, keys in OPTIONAL.items()})
        self.assertGreater(refused, 3000)
        print("\n%d mutants of %d reports are refused" % (refused, len(self.telling)))


SIMPLE = ["count", "position", "line", "text", "property", "about", "point2", "point3", "fraction"]
SHARED = ["cost", "error", "left_out", "coordinate_systems", "skipped", "mended", "feature", "body", "as_mesh", "surface", "planar_body", "unbounded", "flat", "mesh",
          "evidence", "common", "closest", "end", "pairs_of_parts", "near_parts", "info_of_mesh", "info_of_robot", "info_of_scene", "info_of_lines",
          "info_of_rows", "info_of_objects", "certificate_file"]
VERBS = [one["$ref"].split("/")[-1] for one in SCHEMA["else"]["oneOf"]]


def target(rule):
    return rule.get("$ref", "").split("/")[-1]


def are_keys(rules):
    """Do these rules say no more than which keys there are?"""
    return all(one.keys() == {"required"} for one in rules)


def words_for(rule):
    """What a value is, in a few words."""
    name = target(rule)
    if name:
        link = "[%s](#%s)" % (name, name)
        return name if name in SIMPLE else link if name in SHARED else words_for(DEFINITIONS[name])
    if "const" in rule or "enum" in rule:
        return ", ".join("`%s`" % json.dumps(value) for value in rule.get("enum", [rule.get("const")]))
    for parts in (rule.get("oneOf", []), rule.get("allOf", [])):
        if parts and not are_keys(parts):
            return " or ".join(words_for(one) for one in parts) + (", and" if "properties" in rule else "")
    if rule.get("type") == "array":
        return "list of " + words_for(rule["items"]) if "items" in rule else "list"
    kind = rule.get("type", "object")
    return kind if isinstance(kind, str) else " or ".join(kind)


def rows(rule, prefix="", told=()):
    """The keys of an object, but for those told before, and of what is inside, each with its value and meaning."""
    for key, inner in rule.get("properties", {}).items():
        if key in told:
            continue
        mark = "" if key in rule.get("required", []) or key in SCHEMA["required"] else " ?"
        meaning = inner.get("description", "")
        if not meaning and target(inner) not in SIMPLE + SHARED:
            meaning = DEFINITIONS.get(target(inner), {}).get("description", "")
        yield "| `%s%s`%s | %s | %s |" % (prefix, key, mark, words_for(inner), meaning)
        if "$ref" not in inner:
            yield from rows(inner, "%s%s." % (prefix, key))
    if "items" in rule and "$ref" not in rule["items"]:
        yield from rows(rule["items"], prefix[:-1] + "[]." if prefix else "")
    for one in rule.get("oneOf", []) + rule.get("allOf", []):
        if "$ref" not in one:
            yield from rows(one, prefix)


def table(heading, rule, told=()):
    text = rule.get("description", "")
    return ["", heading, *([text[0].upper() + text[1:] + "."] if text else []), "", "| key | value | meaning |",
            "|---|---|---|", *rows(rule, told=told)]


def tables():
    text = [BEGIN] + table("", {key: SCHEMA[key] for key in ("properties", "required")})[2:]
    text += ["", "| simple value | meaning |", "|---|---|"]
    text += ["| %s | %s |" % (name, DEFINITIONS[name]["description"]) for name in SIMPLE]
    text += ["", "## Verbs"]
    for name in VERBS:
        known = ({"const": name.split("_")[0]}, {"$ref": "#/$defs/cost"}, {"type": "null"})
        told = {key for key, rule in DEFINITIONS[name]["properties"].items() if rule in known}
        text += table("### " + name.replace("_of_", ", of ").replace("_", "-"), DEFINITIONS[name], told)
    text += ["", "## What is in them"]
    for name in SHARED:
        text += table("### " + name, DEFINITIONS[name])
    return "\n".join(text) + "\n"


def page_with_tables():
    with open(PAGE, encoding="utf-8") as stream:
        return stream.read().split(BEGIN)[0] + tables()


class Page(unittest.TestCase):
    def test_tables_are_those_of_the_schema(self):
        with open(PAGE, encoding="utf-8") as stream:
            self.assertEqual(stream.read(), page_with_tables(), "cli/reports_test.py --write brings it up to date")

    def test_each_definition_has_its_place(self):
        text = json.dumps(SCHEMA)
        for name in DEFINITIONS:
            self.assertIn('"#/$defs/%s"' % name, text)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        whole = page_with_tables()
        with open(PAGE, "w", encoding="utf-8") as stream:
            stream.write(whole)
    else:
        if not PROGRAM:
            print("skipped: SUNDER_PROGRAM does not name the program")
            sys.exit(0)
        unittest.main()
