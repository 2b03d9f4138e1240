// The verbs pair, hull, section, info, verify.
#include <tests/support/program.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunder::tests {

namespace {

TEST_F(Program, BadPoses) {
  const std::string call = "pair " + cube + " " + cube + " --certificate " + in_folder("c.json") + " --pose-b ";
  expect_bad(call + "1,2", "--pose-b: a pose of 2 numbers; give tx,ty,tz");
  expect_bad(call + "1,2,x", "--pose-b: 'x' is not a number");
  expect_bad(call + "1,2,", "--pose-b: '' is not a number");
  expect_bad(call + "nan,0,0", "--pose-b: 'nan' is NaN");
  expect_bad(call + "0,inf,0", "'inf' is infinite");
  expect_bad(call + "0,0,1e999", "too large");
  expect_bad(call + "0,0,0,0,1,2,3", "length zero");
  expect_bad(call + "1,0,0,0,0,1,0,0,1,1,0,0", "singular");
  expect_bad(call + "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2", "last row");
}

TEST_F(Program, PairAnswers) {
  const std::string pair = "pair " + cube + " " + cube;
  for (const char* method : {"automatic", "gjk", "hierarchy", "polar", "drums", "scan"}) {
    const std::string with = pair + " --method " + method;
    EXPECT_EQ(run(with + " --pose-b 3,0,0").code, 0) << method;
    EXPECT_EQ(run(with + " --pose-b -1,0,0").code, 1) << method;
    EXPECT_EQ(run(with + " --pose-b -1.0000000000000002,0,0").code, 0) << method;
    EXPECT_EQ(report(with, 1)["method"], method);
  }
  // The same pose in all forms: a quarter turn about z, then a shift.
  for (const char* pose : {"1,0,0,1,2.5,0,0", "0,-1,0,2.5,1,0,0,0,0,0,1,0", "0,-1,0,2.5,1,0,0,0,0,0,1,0,0,0,0,1",
                           "0 -1 0 2.5  1 0 0 0  0 0 1 0", "0, -1, 0, 2.5, 1, 0, 0, 0, 0, 0, 1, 0"}) {
    const json j = report(pair + " --pose-b '" + pose + "'", 0);
    EXPECT_EQ(j["answer"], "apart") << pose;
    EXPECT_GT(j["evidence"]["gap_about"].get<double>(), 0) << pose;
  }
  EXPECT_EQ(run(pair + " --pose-a 0,1,0 --pose-b 0,1,0.5").code, 1);
}

TEST_F(Program, PairReport) {
  const json j = report("pair " + cube + " " + tetrahedron + " --pose-b 0.5,0,0 --classify", 1);
  EXPECT_EQ(j["answer"], "meet");
  EXPECT_EQ(j["contact"], "touching");
  EXPECT_EQ(j["objects"].size(), 2u);
  EXPECT_EQ(j["objects"][0]["shape"], "convex");
  EXPECT_EQ(j["objects"][0]["vertices"], 8);
  EXPECT_EQ(j["objects"][0]["facets"], 6);
  EXPECT_EQ(j["objects"][1]["vertices"], 4);
  EXPECT_GT(j["cost"]["probes"].get<int>(), 0);
  EXPECT_EQ(j["evidence"]["point"].size(), 3u);
  EXPECT_EQ(report("pair " + cube + " " + tetrahedron + " --classify", 1)["contact"], "overlapping");
  EXPECT_EQ(report("pair " + cube + " " + tetrahedron + " --classify --pose-b 0.6,0,0", 0)["contact"], "none");
}

TEST_F(Program, DistancesOfBodies) {
  const std::string pair = "pair " + cube + " " + cube + " --pose-b ", proof = in_folder("bodies.json");
  const std::string and_proof = " --distance --certificate '" + proof + "'";
  // The cube is [-1/2, 1/2]^3: a corner to a corner, an edge to an edge across, a facet to a facet.
  const json corners = report(pair + "3,4,7" + and_proof, 0);
  EXPECT_EQ(corners["distance"]["low"], 7);
  EXPECT_EQ(corners["distance"]["high"], 7);
  EXPECT_EQ(corners["distance"]["a"]["vertex"], 7);
  EXPECT_EQ(corners["distance"]["b"]["vertex"], 0);
  EXPECT_TRUE(python_accepts(proof));
  const json facets = report(pair + "3,0.25,0.25" + and_proof, 0);
  EXPECT_EQ(facets["distance"]["low"], 2);
  EXPECT_EQ(facets["distance"]["high"], 2);
  EXPECT_TRUE(python_accepts(proof));
  const json root = report(pair + "2,2,0.5" + and_proof, 0);
  EXPECT_EQ(std::nextafter(root["distance"]["low"].get<double>(), 2), root["distance"]["high"].get<double>());
  EXPECT_NEAR(root["distance"]["low"].get<double>(), std::sqrt(2), 1e-15);
  EXPECT_TRUE(python_accepts(proof));
  const json facet = report("pair " + tetrahedron + " " + cube + " --pose-a -3,0,0" + and_proof, 0);
  EXPECT_EQ(facet["distance"]["low"], 1.5);
  EXPECT_EQ(facet["distance"]["a"]["vertex"], 1);
  EXPECT_GE(facet["distance"]["b"]["facet"].size(), 2u);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(report(pair + "0.5,0,0 --distance", 1)["distance"], json::parse(R"({"low": 0.0, "high": 0.0})"));
  // So far, and not a bit further; of objects that meet, nothing.
  for (const auto& [least, code] : {std::pair("7", 0), {"7.000000000000001", 1}, {"0.001", 0}, {"1e300", 1}}) {
    const json r = report(pair + "3,4,7 --clearance " + least + " --certificate '" + proof + "'", code);
    EXPECT_EQ(r["answer"], "apart");
    EXPECT_EQ(r["clearance"]["kept"], code == 0);
    EXPECT_TRUE(python_accepts(proof)) << least;
    EXPECT_EQ(run("verify '" + proof + "'").code, 0) << least;
  }
  const json none = report(pair + "0.5,0,0 --clearance 1e-300 --certificate '" + proof + "'", 1);
  EXPECT_EQ(none["answer"], "meet");
  EXPECT_FALSE(none["clearance"]["kept"]);
  EXPECT_TRUE(python_accepts(proof));
}

TEST_F(Program, PlanarPairs) {
  const std::string square = in_folder("square.wkt"), others = in_folder("others.geojson"), points = in_folder("p.csv");
  write_text(square, "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))\n");
  write_text(others,
             R"({"type":"FeatureCollection","features":[
               {"type":"Feature","id":"far","geometry":{"type":"Polygon","coordinates":[[[7,1],[9,0],[9,4],[7,1]]]}},
               {"type":"Feature","id":"corner","geometry":{"type":"Point","coordinates":[4,3]}},
               {"type":"Feature","id":"across","geometry":{"type":"LineString","coordinates":[[0,5],[8,-1]]}}]})");
  write_text(points, "0,0\n2,0\n1,0.25\n1,1\n");
  const std::string pair = "pair '" + square + "' '" + others + "' ", proof = in_folder("planar.json");
  const json far = report(pair + "--feature-b far --distance --certificate '" + proof + "'", 0);
  EXPECT_EQ(far["answer"], "apart");
  EXPECT_EQ(far["distance"]["a"]["edge"], json::parse("[1, 2]"));
  EXPECT_EQ(far["distance"]["b"]["vertex"], 0);
  EXPECT_LE(far["distance"]["low"].get<double>(), 3);
  EXPECT_GE(far["distance"]["high"].get<double>(), 3);
  EXPECT_EQ(far["evidence"]["direction_about"].size(), 2u);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
  const Run same = run("verify '" + proof + "' --against '" + square + "' --against '" + others + "'");
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_NE(same.out.find("\n  made of " + others + "\n"), std::string::npos) << same.out;
  const Run other = run("verify '" + proof + "' --against '" + square + "' --against '" + points + "'");
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.out.find("REFUSED: 2 of 2 statements accepted"), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("\n  not made of " + points + ": it names no file"), std::string::npos) << other.out;
  EXPECT_EQ(report("verify '" + proof + "' --against '" + points + "'", 1)["objects"][0]["not_made_of"], json{points});
  expect_bad("verify '" + proof + "' --against '" + in_folder("nothing.wkt") + "'", "no such file");
  // So far, and not a bit further.
  for (const auto& [least, code] : {std::pair("3", 0), {"3.0000000000000004", 1}, {"0.001", 0}, {"4", 1}}) {
    const std::string with = "--feature-b far --certificate '" + proof + "' --clearance " + least;
    const json r = report(pair + with, code);
    EXPECT_EQ(r["answer"], "apart");
    EXPECT_EQ(r["clearance"]["kept"], code == 0);
    EXPECT_TRUE(python_accepts(proof)) << least;
    EXPECT_EQ(run("verify '" + proof + "'").code, 0) << least;
  }
  EXPECT_FALSE(report(pair + "--feature-b corner --clearance 1e-300", 1)["clearance"]["kept"]);
  for (const char* method : {"automatic", "difference", "halving", "triangles", "gjk", "scan"}) {
    const std::string with = pair + "--method " + method + " --classify --certificate '" + proof + "' ";
    EXPECT_EQ(report(with + "--feature-b corner", 1)["contact"], "touching") << method;
    EXPECT_TRUE(python_accepts(proof)) << method;
    EXPECT_EQ(report(with + "--feature-b across", 1)["contact"], "overlapping") << method;
    EXPECT_TRUE(python_accepts(proof)) << method;
    // Three forms of the same pose, then one that reflects.
    for (const char* pose : {"0,1", "0,0,1", "1,0,0,0,1,1", "1,0,0, 0,1,1, 0,0,1"}) {
      EXPECT_EQ(run(with + "--feature-b corner --pose-b '" + pose + "'").code, 0) << method << " " << pose;
    }
    EXPECT_EQ(run(with + "--feature-b far --pose-b '-1,0,10,0,1,0'").code, 1) << method;
    EXPECT_TRUE(python_accepts(proof)) << method;
  }
  // What is not convex, or not one object, or not planar.
  const std::string dent = "pair '" + points + "' '" + square + "' ";
  EXPECT_EQ(run(dent).code, 2);
  EXPECT_NE(run(dent).err.find("p.csv:1: vertex 2: reflex"), std::string::npos) << run(dent).err;
  EXPECT_EQ(run(dent + "--hull").code, 1);
  for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
           {pair, "has 3 objects, 'far' first; name one by --feature-b"},
           {pair + "--feature-b none", "has no feature 'none'"},
           {"pair '" + square + "' " + cube, "is not planar"},
           {"pair " + cube + " " + cube + " --mend", "is for planar objects only"},
           {"pair " + cube + " " + cube + " --clearance 0", "'0' is not one number above zero"},
           {pair + "--feature-b far --clearance 0", "'0' is not one number above zero"},
           {pair + "--feature-b far --clearance x", "'x' is not a number"},
           {pair + "--feature-b far --clearance 1,2", "'1,2' is not one number above zero"},
           {pair + "--feature-b far --method gjkk", "there is no method 'gjkk'; choose one of automatic, difference"},
           {pair + "--feature-b far --pose-a 1", "a pose of 1 number"},
           {pair + "--feature-b far --pose-a 1,0,0,2,0,0", "singular"},
           {pair + "--feature-b far --hull --mend", "not both"}}) {
    const Run r = run(arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_NE(r.err.find(part), std::string::npos) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  }
  const std::string picture = in_folder("pair.svg");
  EXPECT_EQ(run(pair + "--feature-b far --svg '" + picture + "' --title 'A & B'").code, 0);
  const std::string svg = read_text(picture);
  for (const char* part : {"<svg", "A &amp; B", "looked at", "two parallel lines", "stroke-dasharray", "</svg>"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
}

// Lines, rays and half-planes against a polygon: what they have in common, in either order, by all methods; and what a
// certificate says of them.
// What is no object is refused, or left out and told of, with either kind of pair.
TEST_F(Program, PlanarPairsLeaveOut) {
  const std::string file = in_folder("shed.wkt"), proof = in_folder("proof.json"), other = in_folder("other.wkt");
  write_text(file, "POLYGON ((7 1, 9 0, 9 4, 7 1))\nMULTIPOINT ((0 0), (1 1))\n");
  write_text(other, "POINT (0 1)\n");
  const std::string pair = "pair " + file + " " + other;
  expect_bad(pair,
             "shed.wkt: not read: 1 point of line 2; name the object that is asked about by --feature-a, or "
             "ask without them: --leave-out");
  EXPECT_EQ(run("pair --feature-a 1 " + file + " " + other).out.find("left out"), std::string::npos);
  const json j = report(pair + " --leave-out --certificate " + proof, 0);
  EXPECT_EQ(j["left_out"][0]["kind"], "point");
  EXPECT_EQ(j["left_out"][0]["of"], json{"line 2"});
  EXPECT_EQ(json::parse(read_text(proof))["left_out"], json{"1 point of line 2"});
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_NE(run(pair + " --leave-out").out.find("apart; left out: 1 point of line 2\n"), std::string::npos);
  write_text(other, "RAY (0 1, -1 1)\n");
  expect_bad(pair, "--leave-out");
  EXPECT_EQ(report(pair + " --leave-out --certificate " + proof, 0)["left_out"].size(), 1u);
  EXPECT_EQ(json::parse(read_text(proof))["left_out"], json{"1 point of line 2"});
  EXPECT_NE(run(pair + " --leave-out").out.find("apart; left out: 1 point of line 2\n"), std::string::npos);
}

TEST_F(Program, UnboundedPairs) {
  const std::string plate = cases + "/planar-pair/plate.wkt", paths = cases + "/planar-pair/paths.csv";
  const std::string proof = in_folder("proof.json"), picture = in_folder("cut.svg");
  struct Expected {
    const char *feature, *kind, *contact;
  };
  for (const auto& [feature, kind, contact] : std::vector<Expected>{{"diagonal", "across", "overlapping"},
                                                                    {"roof", "along", "touching"},
                                                                    {"corner", "point", "touching"},
                                                                    {"above", "nothing", "none"},
                                                                    {"beam", "across", "overlapping"},
                                                                    {"away", "nothing", "none"},
                                                                    {"tip", "point", "touching"},
                                                                    {"east", "part", "overlapping"},
                                                                    {"river", "along", "touching"},
                                                                    {"north", "whole", "overlapping"},
                                                                    {"hill", "nothing", "none"}}) {
    SCOPED_TRACE(feature);
    const std::string options = " --classify --certificate '" + proof + "' --svg '" + picture + "' --feature-";
    const int code = std::string(kind) == "nothing" ? 0 : 1;
    for (const char* method : {"automatic", "scan"}) {
      const std::string with = std::string(feature) + " --method " + method;
      const json j = report("pair " + plate + " " + paths + options + "b " + with, code);
      EXPECT_EQ(j["answer"], code == 1 ? "meet" : "apart");
      EXPECT_EQ(j["common"]["kind"], kind);
      EXPECT_EQ(j["contact"], contact);
      EXPECT_EQ(j["objects"][1]["name"], feature);
      EXPECT_EQ(j["objects"][1]["points"].size(), 2u);
      EXPECT_EQ(run("verify '" + proof + "'").code, 0);
      const json statements = json::parse(read_text(proof))["statements"];
      ASSERT_EQ(statements.size(), 1u);
      EXPECT_EQ(statements[0]["verdict"], std::string(contact) == "none" ? "apart" : contact);
      EXPECT_NE(read_text(picture).find("</svg>"), std::string::npos);
      EXPECT_EQ(read_text(picture).find("nan"), std::string::npos);
      const json other_order = report("pair " + paths + " " + plate + options + "a " + with, code);
      EXPECT_EQ(other_order["common"], j["common"]);
      EXPECT_EQ(other_order["objects"][0], j["objects"][1]);
    }
    EXPECT_TRUE(python_accepts(proof));
  }
  const std::string pair = "pair " + plate + " " + paths + " --feature-b ";
  const json across = report(pair + "diagonal --method fibonacci", 1)["common"];
  EXPECT_EQ(across["first"], json::parse(R"({"point": [1.0, 3.0], "along_line": "1/4", "edge": [2, 3],
                                             "along_edge": "3/4"})"));
  EXPECT_EQ(across["last"]["along_line"], "5/8");
  EXPECT_EQ(report(pair + "above", 0)["common"]["nearest"], 3);
  EXPECT_EQ(report(pair + "beam", 1)["common"]["first"],
            json::parse(R"({"point": [2.0, 1.0], "along_line": "0", "inside": true, "beginning": true})"));
  EXPECT_EQ(report(pair + "hill", 0)["common"]["nearest"], 3);
  for (const auto& [feature, part] : std::vector<std::pair<std::string, std::string>>{
           {"diagonal", "a segment, from about (1, 3), edge 2-3 of A, t = 1/4\n"},
           {"roof", "edge 2-3 of A, from about (0, 3), vertex 3 of A, t = 0\n"},
           {"corner", "one point, about (4, 3), vertex 2 of A, t = 1/2"},
           {"above", "nothing; vertex 3 of A is nearest to the line"},
           {"beam", "the ray's beginning at about (2, 1), inside A"},
           {"east", "a part, cut off from about (1, 3)"},
           {"north", "all of A; vertex 2 of A is furthest within"}}) {
    EXPECT_NE(run(pair + feature).out.find(part), std::string::npos) << run(pair + feature).out;
  }

  // Segments and points; poses of both; WKT.
  const std::string site = " " + cases + "/planar-pair/site.geojson ", wkt = cases + "/planar-pair/paths.wkt";
  EXPECT_EQ(report("pair " + wkt + site + "--classify --feature-a 1 --feature-b cable", 1)["contact"], "overlapping");
  EXPECT_EQ(report("pair " + wkt + site + "--classify --feature-a 3 --feature-b mast --pose-a 4,0", 0)["contact"],
            "none");
  EXPECT_EQ(report("pair " + wkt + site + "--classify --feature-a 3 --feature-b mast --pose-a 3,0", 1)["contact"],
            "touching");
  EXPECT_EQ(report("pair " + wkt + site + "--feature-a 3 --feature-b mast --pose-a -1,0,2,0,1,0", 0)["answer"],
            "apart");
  EXPECT_EQ(report(pair + "above --pose-a 0,1", 0)["common"]["nearest"], 3);
  EXPECT_EQ(report(pair + "above --pose-b 0,-5", 1)["objects"][1]["points"], json::parse("[[-3.0, 0.0], [1.0, 3.0]]"));

  for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
           {pair + "diagonal --pose-b 0.3,0,0",
            "is no pair of doubles, and is not rounded; give the line in its place"},
           {"pair " + paths + " " + paths + " --feature-a beam --feature-b hill",
            "A is a ray and B a half-plane; one of"},
           {pair + "roof --clearance 1", "--clearance: is for points, segments and polygons"},
           {pair + "roof --distance", "--distance: is for points, segments and polygons"},
           {pair + "beam --method fibonacci", "where one object is a ray; choose one of automatic, scan"},
           {pair + "roof --method gjk", "where one object is a line; choose one of automatic, fibonacci, scan"},
           {"pair " + cases + "/planar-pair/dented.wkt " + paths + " --feature-b roof", "reflex"}}) {
    expect_bad(arguments, part);
  }
}

TEST_F(Program, PairTextNamesWhatMatters) {
  const Run meet = run("pair " + cube + " " + tetrahedron);
  for (const char* part : {"meet", "cube", "tetrahedron", "common point", "about", "decided by", "probes"}) {
    EXPECT_NE(meet.out.find(part), std::string::npos) << part;
  }
  const Run apart = run("pair " + cube + " " + tetrahedron + " --pose-b 9,0,0");
  for (const char* part : {"apart", "slab", "direction", "about", "vertex"}) {
    EXPECT_NE(apart.out.find(part), std::string::npos) << part;
  }
}

TEST_F(Program, MeshesThatAreNotConvex) {
  const std::string file = in_folder("dent.off");
  write_text(file,
             "OFF\n9 9 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n0.5 0.5 0.75\n"
             "4 0 4 6 2\n4 1 3 7 5\n4 0 1 5 4\n4 2 6 7 3\n4 0 2 3 1\n3 4 5 8\n3 5 7 8\n3 7 6 8\n3 6 4 8\n");
  const Run r = run("pair " + cube + " " + file + " --json");
  EXPECT_EQ(r.code, 1);
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1);
  EXPECT_NE(r.err.find("its hull stands for it"), std::string::npos) << r.err;
  const json j = json::parse(r.out);
  EXPECT_EQ(j["objects"][0]["shape"], "convex");
  EXPECT_EQ(j["objects"][1]["shape"], "hull");
  ASSERT_EQ(j["notes"].size(), 1u);
  EXPECT_EQ("sunder: note: " + std::string(j["notes"][0]) + "\n", r.err);
  EXPECT_EQ(run("pair " + cube + " " + file + " --quiet").err, "");
  // Of hulls are distances, and that a clearance is not kept; that it is, holds of what they stand for.
  const std::string away = "pair " + cube + " " + file + " --pose-b 0,0,-3";
  EXPECT_EQ(report(away, 0)["said_of"], "bodies");
  EXPECT_EQ(report(away + " --distance", 0)["said_of"], "hulls");
  EXPECT_EQ(report(away + " --clearance 1.5", 0)["said_of"], "bodies");
  EXPECT_EQ(report(away + " --clearance 1.6", 1)["said_of"], "hulls");
  EXPECT_NE(run(away + " --distance").out.find(" (of the hulls)\n"), std::string::npos);
  for (const std::string& call : {"pair " + cube + " " + file, "scene " + file}) {
    expect_bad(call + " --require-convex",
               "not exactly convex: it bends inwards at the reflex edge from vertex 4 (0, 0, 1)");
  }
  EXPECT_EQ(run("pair " + cube + " " + cube + " --require-convex").code, 1);
  EXPECT_NE(run("info " + file).out.find("reflex edge"), std::string::npos);
}

TEST_F(Program, CertificatesAreVerified) {
  const std::string apart = in_folder("apart.json"), meet = in_folder("meet.json");
  ASSERT_EQ(run("pair " + cube + " " + tetrahedron + " --pose-b 3,0.1,0.2 --certificate " + apart).code, 0);
  ASSERT_EQ(run("pair " + cube + " " + tetrahedron + " --pose-b 0.1,0.1,0.2 --certificate " + meet).code, 1);
  EXPECT_EQ(run("verify " + apart + " " + meet).code, 0);
  EXPECT_EQ(report("verify " + apart, 0)["answer"], "accepted");

  std::string text = read_text(apart);
  const std::size_t at = text.find("\"direction\": [\"") + 15;
  ASSERT_EQ(text.substr(at, 2), "0x");  // A is at the lesser side of x
  text.insert(at, 1, '-');
  const std::string changed = in_folder("changed.json");
  write_text(changed, text);
  EXPECT_EQ(run("verify " + changed).code, 1);
  EXPECT_EQ(run("verify " + apart + " " + changed).code, 1);
  const json j = report("verify " + changed, 1);
  EXPECT_EQ(j["answer"], "refused");
  EXPECT_EQ(j["objects"][0]["refused"][0]["check"], "parted");

  expect_bad("verify " + in_folder("none.json"), "no such file");
  expect_bad("verify " + cube, "cube.obj");
  write_text(changed, text.substr(0, text.size() / 2));
  expect_bad("verify " + changed, "changed.json");
}

TEST_F(Program, HullWritesWhatInfoReads) {
  const std::string points = in_folder("points.obj");
  write_text(points,
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\nv 0.5 0.5 0.5\nv 0.5 0.5 1\n");
  for (const char* ending : {"obj", "off", "ply", "stl"}) {
    const std::string out = in_folder(std::string("hull.") + ending);
    const json j = report("hull " + points + " -o " + out, 0);
    EXPECT_EQ(j["answer"], "body");
    EXPECT_EQ(j["objects"][0]["vertices"], 8);
    EXPECT_EQ(j["objects"][0]["facets"], 6);
    EXPECT_EQ(j["objects"][0]["edges"], 12);
    const json info = report("info " + out, 0);
    EXPECT_EQ(info["objects"][0]["shape"], "convex") << ending;
    EXPECT_EQ(info["objects"][0]["facets"], 6) << ending;
  }
}

TEST_F(Program, Info) {
  const json robot = report("info " + panda, 0);
  EXPECT_EQ(robot["objects"][0]["links"].size(), 13u);
  EXPECT_EQ(robot["objects"][0]["joints"].size(), 12u);
  const json formats = report("info --formats", 0);
  EXPECT_GE(formats["formats"].size(), 5u);
  const json two = report("info " + cube + " " + cases + "/mesh/points.obj", 0);
  EXPECT_EQ(two["objects"][1]["shape"], "points");
}

}  // namespace

}  // namespace sunder::tests
