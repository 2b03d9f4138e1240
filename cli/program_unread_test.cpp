// What the program does not read counts for nothing without the caller's word, and no sentence says more than is so.
#include <sunder/io/sha256.h>
#include <tests/support/program.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace sunder::tests {

namespace {

std::string link_of(const std::string& name, const std::string& inside) {
  return "<link name=\"" + name + "\">" + inside + "</link>\n";
}

std::string collision(const std::string& geometry, const std::string& at = "0 0 0") {
  return "<collision><origin xyz=\"" + at + "\"/><geometry>" + geometry + "</geometry></collision>";
}

// A robot of links in a row, joined by fixed joints.
std::string robot_of(const std::vector<std::string>& links, const std::vector<std::string>& names) {
  std::string text = "<robot name=\"r\">\n";
  for (const std::string& link : links) text += link;
  for (std::size_t i = 1; i < names.size(); ++i) {
    text += "<joint name=\"j" + names[i] + "\" type=\"fixed\"><parent link=\"" + names[i - 1] + "\"/><child link=\"" +
            names[i] + "\"/></joint>\n";
  }
  return text + "</robot>\n";
}

const std::string ellipsoid = "<ellipsoid radii=\"1 1 1\"/>", box = "<box size=\"1 1 1\"/>";

TEST_F(Program, ShapesThatAreNotReadAreNotSafe) {
  const std::string two = in_folder("two.urdf"), quoted = "'" + two + "'";
  write_text(two, robot_of({link_of("a", collision(ellipsoid)), link_of("b", collision(ellipsoid))}, {"a", "b"}));
  expect_bad("scene " + quoted, "two.urdf: not read: 2 ellipsoids of a, b; give meshes in their stead, or ask without");
  expect_bad("scene " + quoted + " --leave-out", "there is nothing to ask about; left out: 2 ellipsoids of a, b");
  write_text(
      two, robot_of({link_of("a", "<visual><geometry>" + box + "</geometry></visual>"), link_of("b", "")}, {"a", "b"}));
  expect_bad("scene " + quoted, "not read: 1 visual shape of a");
  write_text(two,
             robot_of({link_of("a", "<visual><geometry>" + box + "</geometry></visual>"), link_of("b", collision(box))},
                      {"a", "b"}));
  const Run told = run("scene " + quoted + " --json");
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(json::parse(told.out)["left_out"][0]["kind"], "visual shape");
  EXPECT_NE(run("scene " + quoted).out.find("none of the bodies read meet; left out: 1 visual shape of a\n"),
            std::string::npos);
  write_text(two, robot_of({link_of("a", ""), link_of("b", "")}, {"a", "b"}));
  expect_bad("scene " + quoted, "no link has a shape, so there is nothing to ask about");
  write_text(two, robot_of({link_of("a", collision(box + ellipsoid))}, {"a"}));
  expect_bad("scene " + quoted, "has two shapes");
  write_text(two, robot_of({link_of("a", "<xacro:arm/>")}, {"a"}));
  expect_bad("scene " + quoted, "xacro that was not expanded");
}

TEST_F(Program, WhatIsLeftOutIsTold) {
  const std::string robot = in_folder("five.urdf"), proof = in_folder("proof.json"), quoted = "'" + robot + "'";
  write_text(robot,
             robot_of({link_of("a", collision(box)), link_of("b", collision(box, "3 0 0") + collision(ellipsoid)),
                       link_of("c", collision("<cone/>") + collision(ellipsoid)),
                       link_of("d", collision("<mesh filename=\"none.stl\"/>")),
                       link_of("e", collision("<mesh filename=\"model.dae\"/>"))},
                      {"a", "b", "c", "d", "e"}));
  write_text(in_folder("model.dae"), "<COLLADA/>\n");
  expect_bad("scene " + quoted, "not read: 2 ellipsoids of b, c; 1 cone of c; give");
  const Run r = run("scene " + quoted + " --leave-out --certificate '" + proof + "'");
  EXPECT_EQ(r.code, 0) << r.err;
  const std::string left_out = "left out: 2 ellipsoids of b, c; 1 cone of c; 2 meshes of d, e";
  EXPECT_NE(r.out.find("\nnone of the bodies read meet; " + left_out + "\n"), std::string::npos) << r.out;
  const json texts{"2 ellipsoids of b, c", "1 cone of c", "2 meshes of d, e"};
  const json file = json::parse(read_text(proof));
  EXPECT_EQ(file["left_out"], texts);
  ASSERT_EQ(file["inputs"].size(), 1u);
  EXPECT_EQ(file["inputs"][0]["name"], robot);
  EXPECT_EQ(file["inputs"][0]["sha256"], io::sha256(read_text(robot)));
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_NE(run("verify '" + proof + "'").out.find("\n  left out: 1 cone of c\n"), std::string::npos);
  EXPECT_EQ(report("verify '" + proof + "'", 0)["objects"][0]["without"], texts);
  const json j = report("scene " + quoted + " --leave-out", 0);
  EXPECT_EQ(j["left_out"][0], (json{{"kind", "ellipsoid"}, {"count", 2}, {"of", {"b", "c"}}}));
  EXPECT_EQ(j["left_out"].size(), 3u);
  EXPECT_EQ(report("info " + quoted, 0)["objects"][0]["left_out"].size(), 2u);  // which opens no mesh
  // A mesh that is missing is an error of its own without the option.
  write_text(robot, robot_of({link_of("a", collision(box)), link_of("d", collision("<mesh filename=\"no.stl\"/>"))},
                             {"a", "d"}));
  expect_bad("scene " + quoted, "no.stl: no such mesh");
  // What meets does so, whatever was left out; this is told then too.
  write_text(robot,
             robot_of({link_of("a", collision(box)), link_of("b", collision(box) + collision(ellipsoid))}, {"a", "b"}));
  const Run meets = run("scene " + quoted + " --leave-out");
  EXPECT_EQ(meets.code, 1);
  EXPECT_NE(meets.out.find("this is of the bodies read; left out: 1 ellipsoid of b"), std::string::npos) << meets.out;
}

TEST_F(Program, MeshesWithMoreThanPolygons) {
  const std::string tetra = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string file = in_folder("more.obj"), quoted = "'" + file + "'", ply = in_folder("more.ply");
  write_text(file, tetra + "v 9 9 9\nv 8 8 8\nl 5 6\np 5 6\n");
  for (const std::string& call : {"pair " + quoted + " " + cube, "hull " + quoted, "scene " + cube + " " + quoted}) {
    expect_bad(call, "more.obj: not read: 1 line; 2 points; 2 unused vertices; mend the file, or ask");
    EXPECT_EQ(report(call + " --leave-out", call.starts_with("hull") ? 0 : 1)["left_out"].size(), 3u) << call;
  }
  EXPECT_EQ(report("info " + quoted, 0)["objects"][0]["left_out"].size(), 3u);
  const std::string proof = in_folder("proof.json");
  EXPECT_EQ(run("pair " + quoted + " " + cube + " --leave-out --certificate '" + proof + "'").code, 1);
  const json told = json::parse(read_text(proof));
  EXPECT_EQ(told["left_out"][0], "1 line of more.obj");
  EXPECT_EQ(told["left_out"].size(), 3u);
  ASSERT_EQ(told["inputs"].size(), 2u);
  EXPECT_EQ(told["inputs"][0]["name"], file);
  EXPECT_EQ(told["inputs"][1]["sha256"], io::sha256(read_text(cases + "/mesh/cube.obj")));
  // Without faces the vertices are the object, those of lines and points too.
  write_text(file, "v 0 0 0\nv 1 0 0\nl 1 2\np 1\n");
  EXPECT_EQ(run("hull " + quoted).code, 0);
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  write_text(ply, header +
                      "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
                      "0 0 0\n1 0 0\n0 1 0\n0 1\n");
  expect_bad("hull '" + ply + "'", "not read: 1 edge; mend");
  write_text(ply,
             header + "element face 1\nproperty list uchar int corners\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  expect_bad("hull '" + ply + "'", "the element 'face' has no list 'vertex_indices'");
}

// Parts of one file: a tetrahedron, and a pyramid that is hollow from below; numbers are those of the file.
TEST_F(Program, VerticesOfPartsAreNumberedAsInTheFile) {
  const std::string file = in_folder("parts.obj");
  write_text(file,
             "o first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 7 7 7\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
             "o second\nv 5 0 0\nv 7 0 0\nv 7 2 0\nv 5 2 0\nv 6 1 1\nv 6 1 3\n"
             "f 7 8 10\nf 8 9 10\nf 9 6 10\nf 6 7 10\nf 6 7 11\nf 7 8 11\nf 8 9 11\nf 9 6 11\n");
  const Run r = run("scene " + cube + " '" + file + "' --require-convex --leave-out");
  EXPECT_EQ(r.code, 2);
  EXPECT_NE(r.err.find("its face 4 is inside its hull (counted from 0)"), std::string::npos) << r.err;
  // An open one names an edge.
  write_text(file,
             "o first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
             "o second\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\n");
  expect_bad("scene '" + file + "' --require-convex", "from vertex 5 (6, 0, 0) to vertex 6 (5, 1, 0)");
}

// One step of a double in a corner of a cube, and a body with a deep notch.
TEST_F(Program, ABendByTheLastBitAndANotchDoNotReadAlike) {
  const std::string bent = in_folder("bent.obj"), notched = in_folder("notched.obj");
  write_text(bent,
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1.0000000000000002\nv 0 1 1\n"
             "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 8\nf 6 7 8\n");
  write_text(
      notched,
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 4\nv 2 0 4\nv 2 1 4\nv 1 1 4\nv 1 2 4\nv 0 2 4\n"
      "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n");
  const json a = report("info '" + bent + "'", 0)["objects"][0], b = report("info '" + notched + "'", 0)["objects"][0];
  EXPECT_NEAR(a["departure"]["depth_about"], 0x1p-53, 1e-20);
  EXPECT_NEAR(a["departure"]["volume_missing_about"], 0x1p-52 / 6, 1e-20);
  EXPECT_NEAR(b["departure"]["depth_about"], std::sqrt(0.5), 1e-5);
  EXPECT_NEAR(b["departure"]["volume_missing_about"], 2, 1e-12);
  EXPECT_NEAR(b["departure"]["volume_of_hull_about"], 14, 1e-12);
  EXPECT_NE(run("info '" + notched + "'")
                .out.find("the deepest edge is about 0.7071 below the hull, which holds about "
                          "2 more than the mesh, of 14\n"),
            std::string::npos);
  const std::string both = "'" + notched + "' '" + bent + "'";
  const Run meet = run("pair " + both + " --pose-b 1.2,1.2,0");
  EXPECT_EQ(meet.code, 1);
  EXPECT_NE(meet.out.find(": meet as hulls\n"), std::string::npos) << meet.out;
  EXPECT_NE(meet.out.find("the deepest edge is about 1.11e-16 below the hull"), std::string::npos) << meet.out;
  EXPECT_EQ(report("pair " + both + " --pose-b 1.2,1.2,0", 1)["said_of"], "hulls");
  EXPECT_EQ(report("pair " + both + " --pose-b 9,0,0", 0)["said_of"], "bodies");
  const Run scene = run("scene '" + notched + "' '" + bent + "@1.2,1.2,0'");
  EXPECT_NE(scene.out.find("\nnotched and bent meet as hulls, at about"), std::string::npos) << scene.out;
  EXPECT_NE(scene.err.find("of notched.obj, the deepest edge is about 0.7071"), std::string::npos) << scene.err;
  const json j = report("scene '" + notched + "' '" + bent + "@1.2,1.2,0'", 1);
  EXPECT_EQ(j["pairs"][0]["said_of"], "hulls");
  EXPECT_TRUE(j["objects"][0].contains("departure"));
  // Convex bodies simply meet.
  EXPECT_NE(run("pair " + cube + " " + tetrahedron).out.find(": meet\n"), std::string::npos);
}

// Two tracks of different nets, 0.25 wide and 0.2 apart: their copper overlaps, their centre lines do not meet.
TEST_F(Program, ABoardIsAskedAboutByItsCentreLines) {
  const std::string board = in_folder("board.kicad_pcb"), proof = in_folder("proof.json"), quoted = "'" + board + "'";
  write_text(
      board,
      "(kicad_pcb (version 20221018) (generator hand) (layers (0 \"F.Cu\" signal))\n(net 0 \"\") (net 1 \"A\") "
      "(net 2 \"B\")\n(segment (start 0 0) (end 9 0) (width 0.25) (layer \"F.Cu\") (net 1))\n"
      "(segment (start 0 0.2) (end 9 0.2) (width 0.25) (layer \"F.Cu\") (net 2))\n(zone (net 1)) (mystery 1))\n");
  expect_bad("segments " + quoted, "copper is not read (track width 0.25 mm; clearance is not checked");
  expect_bad("segments " + quoted, "say --centre-lines");
  expect_bad("segments " + cases + "/segments/wires.csv --centre-lines", "is for boards; leave it out");
  const Run r = run("segments " + quoted + " --centre-lines --certificate '" + proof + "'");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.out.find("\nnone of the tracks' centre lines meet"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("1 list of an unknown kind: not looked at"), std::string::npos) << r.out;
  EXPECT_EQ(report("segments " + quoted + " --centre-lines", 0)["said_of"], "centre lines");
  const std::string note = json::parse(read_text(in_folder("proof.json")))["left_out"][0];
  EXPECT_TRUE(note.starts_with("copper, but for the centre lines of tracks: ")) << note;
  EXPECT_TRUE(python_accepts(proof));
}

// One common point: that there is more than one is not said, nor accepted.
TEST_F(Program, AZeroObjectiveIsOptimalEverywhere) {
  const std::string file = in_folder("point.csv"), proof = in_folder("proof.json"), quoted = "'" + file + "'";
  write_text(file, "1,0,1\n-1,0,-1\n0,1,0\n0,-1,0\n");
  const Run r = run("region " + quoted + " --maximize 0,0 --certificate '" + proof + "'");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.out.find("0 x + 0 y is zero everywhere: every common point is an optimum; they are one point\n"),
            std::string::npos)
      << r.out;
  EXPECT_EQ(report("region " + quoted + " --maximize 0,0", 0)["best"]["outcome"], "all");
  // The value of an objective is not that of the rounded point: here it would be infinite, and 0 for 1 / 3.
  const std::string large = in_folder("large.csv"), near = in_folder("near.csv");
  write_text(large, "1,0,1e308\n0,1,1e308\n");
  EXPECT_NE(run("region '" + large + "' --maximize 1,1").out.find("is greatest, beyond the range of doubles, at about"),
            std::string::npos);
  write_text(near, "3,-3,1\n-1,0,-1e17\n1,0,1e17\n");
  EXPECT_NE(run("region '" + near + "' --maximize 1,-1").out.find("is greatest, about 0.3333333333, at about"),
            std::string::npos);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
  std::string many = read_text(proof);
  many.replace(many.find("\"all\""), 5, "\"many\", \"side\": -1, \"before\": -1, \"after\": -1");
  write_text(proof, many);
  EXPECT_FALSE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 1);
}

// The table "What counts" of the guide, row by row: what counts without an option, and what --allow and --group change.
TEST_F(Program, WhatCountsIsAsInTheGuide) {
  const auto file = [&](const std::string& name, const std::string& text) {
    write_text(in_folder(name), text);
    return " '" + in_folder(name) + "'";
  };
  struct Row {
    std::string call;
    std::vector<std::string> none;  // options with which nothing counts
  };
  const std::string ends = file("ends.csv", "x1,y1,x2,y2,net\n0,0,1,0,a\n1,0,2,0,a\n");
  const std::string touch = file("touch.csv", "x1,y1,x2,y2,net\n0,0,2,0,a\n1,0,1,1,a\n");
  const std::string tangent = file("tangent.csv", "x,y,r,net\n0,0,1,a\n2,0,1,a\n");
  const std::string nested = file("nested.csv", "x,y,r,net\n0,0,2,a\n0,0,1,a\n");
  const std::string beside_boxes = file("beside.csv", "x1,y1,x2,y2,net\n0,0,1,1,a\n1,0,2,1,a\n");
  const std::string nested_boxes = file("nested_boxes.csv", "x1,y1,x2,y2,net\n0,0,3,3,a\n1,1,2,2,a\n");
  const std::string parts = "((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 1, 2 1, 2 2, 1 2, 1 1))";
  const std::string of_one = file("parts.wkt", "MULTIPOLYGON (" + parts + ")\n");
  const std::string corners =
      file("corners.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\nPOLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))\n");
  const std::string layer = file("layer.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"layer": "a"},
     "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}},
    {"type": "Feature", "properties": {"layer": "a"},
     "geometry": {"type": "Polygon", "coordinates": [[[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]]}}]})");
  const std::string sides =
      file("sides.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\nPOLYGON ((1 0, 2 0, 2 1, 1 1, 1 0))\n");
  const std::string inside =
      file("inside.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))\nPOLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))\n");
  const std::string beside = " " + cube + " " + cube + "@1,0,0";  // touching
  const std::string arm =
      file("arm.urdf", robot_of({link_of("a", collision(box)), link_of("b", collision(box))}, {"a", "b"}));
  const std::vector<Row> rows{{"pair " + cube + " " + cube + " --pose-b 1,0,0", {}},
                              {"scene" + beside, {"touch", "cube,cube#2"}},
                              {"scene" + arm, {"adjacent", "a,b"}},
                              {"segments" + ends, {"shared-endpoint", "touch"}},
                              {"segments" + touch, {"touch"}},
                              {"circles" + tangent, {"touch"}},
                              {"circles" + nested, {}},
                              {"boxes" + beside_boxes, {"touch"}},
                              {"boxes" + nested_boxes, {}},
                              {"polygons" + corners, {"shared-endpoint", "touch"}},
                              {"polygons" + sides, {"touch"}},
                              {"polygons" + inside, {}}};
  for (const Row& row : rows) {
    EXPECT_EQ(run(row.call).code, 1) << row.call;
    for (const char* allowed : {"touch", "shared-endpoint", "adjacent", "a,b", "cube,cube#2"}) {
      const bool is_listed = std::find(row.none.begin(), row.none.end(), allowed) != row.none.end();
      const int code = run(row.call + " --allow '" + allowed + "'").code;
      EXPECT_EQ(code == 0, is_listed) << row.call << " --allow " << allowed << ": " << code;
    }
  }
  for (const std::string& call : {"segments" + ends, "segments" + touch, "circles" + tangent, "circles" + nested,
                                  "boxes" + beside_boxes, "boxes" + nested_boxes}) {
    EXPECT_EQ(run(call + " --group net").code, 0) << call;
  }
  EXPECT_EQ(run("polygons" + layer).code, 1);
  EXPECT_EQ(run("polygons" + layer + " --group layer").code, 0);
  EXPECT_EQ(run("polygons" + of_one).code, 0);
  const std::string pocket = " " + cases + "/valid-polygons/pocket.wkt";
  EXPECT_EQ(run("simple" + pocket).code, 1);
  EXPECT_EQ(run("simple" + pocket + " --self-touch").code, 0);
  EXPECT_EQ(run("simple" + of_one).code, 0);  // parts with a common corner
  const std::string twice = file("twice.wkt", "POLYGON ((0 0, 1 0, 1 0, 0 1, 0 0))\n");
  EXPECT_EQ(run("simple" + twice).code, 0);
  EXPECT_EQ(run("simple" + twice + " --strict").code, 1);
  const std::string two_parts = file("two.obj",
                                     "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
                                     "o b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
  EXPECT_EQ(run("scene" + two_parts).code, 0);  // parts of one body
}

}  // namespace

}  // namespace sunder::tests
