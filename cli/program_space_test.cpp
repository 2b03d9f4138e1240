// The verb pair for objects of space: points, segments, flat polygons, lines, rays and planes beside meshes.
#include <tests/support/program.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace sunder::tests {

namespace {

class SpaceProgram : public Program {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    write_text(in_folder(name), text);
    return "'" + in_folder(name) + "'";
  }
  static std::string space(const std::string& name) { return "'" + cases + "/space/" + name + "'"; }
  // The report, whose proof both checkers accept.
  json proved(const std::string& call, int code) const {
    const std::string proof = in_folder("proof.json");
    json j = report(call + " --certificate '" + proof + "'", code);
    EXPECT_TRUE(python_accepts(proof)) << call;
    EXPECT_EQ(run("verify '" + proof + "'").code, 0) << call;
    return j;
  }
};

TEST_F(SpaceProgram, PlanesAndABody) {
  // The cube is [-1/2, 1/2]^3.
  for (const char* method : {"automatic", "drums", "scan"}) {
    const std::string with = " --classify --method " + std::string(method);
    const json cut = proved("pair " + cube + " " + space("plane.json") + with, 1);
    EXPECT_EQ(cut["contact"], "overlapping") << method;
    EXPECT_EQ(cut["evidence"]["point"][2], 0.25) << method;
    const json apart = proved("pair " + space("above.json") + " " + cube + with, 0);
    EXPECT_EQ(apart["evidence"]["side"], "below") << method;
    EXPECT_EQ(apart["evidence"]["gap_about"], 1) << method;
    EXPECT_EQ(apart["objects"][0]["shape"], "plane");
    const std::string top = file("top.json", R"({"plane": {"normal": [0, 0, -1], "point": [9, 9, 0.5]}})");
    EXPECT_EQ(proved("pair " + cube + " " + top + with, 1)["contact"], "touching") << method;
    const std::string over = file("over.json", R"({"plane": {"normal": [0, 0, 1], "offset": 0.5000000000000001}})");
    EXPECT_EQ(proved("pair " + cube + " " + over + with, 0)["contact"], "none") << method;
  }
  EXPECT_EQ(run("pair " + cube + " " + space("above.json") + " --pose-a 0,0,1").code, 1);
  EXPECT_EQ(run("pair " + cube + " " + space("above.json") + " --pose-b 0,0,-1").code, 1);
  EXPECT_EQ(run("pair " + cube + " " + space("above.json") + " --pose-b 0,0,1e-20").code, 2);  // is rounded
  // Turned about x by a quarter, the plane z = 1.5 is y = -1.5.
  const json turned = report("pair " + cube + " " + space("above.json") + " --pose-b 1,1,0,0,0,1,0", 1);
  EXPECT_EQ(turned["objects"][1]["normal"], json::parse("[0.0, -1.0, 0.0]"));
  // Reflected, the normal points the other way.
  const std::string mirror = " --pose-b 1,0,0,0,0,1,0,0,0,0,-1,0";
  const json reflected = report("pair " + cube + " " + space("above.json") + mirror, 0);
  EXPECT_EQ(reflected["evidence"]["side"], "below");
  EXPECT_EQ(reflected["objects"][1]["point"], json::parse("[0.0, 0.0, -1.5]"));
  EXPECT_EQ(reflected["objects"][1]["normal"], json::parse("[0.0, 0.0, -1.0]"));
  // A plane without a point of doubles is answered, and not proved.
  const std::string third = file("third.json", R"({"plane": {"normal": [3, 0, 0], "offset": 1}})");
  EXPECT_EQ(run("pair " + cube + " " + third).code, 1);
  expect_bad("pair " + cube + " " + third + " --certificate '" + in_folder("no.json") + "'", "no point of the plane");
}

TEST_F(SpaceProgram, LinesAndABody) {
  for (const char* method : {"automatic", "drums", "scan"}) {
    const std::string with = " --classify --method " + std::string(method);
    const json line = proved("pair " + cube + " " + space("line.json") + with, 1);
    EXPECT_EQ(line["common"]["kind"], "across") << method;
    EXPECT_EQ(line["common"]["first"]["point"], json::parse("[-0.125, -0.25, -0.5]"));
    EXPECT_EQ(line["common"]["last"]["along_line"], "1/8");
    EXPECT_EQ(line["contact"], "overlapping") << method;
    const json ray = proved("pair " + space("ray.json") + " " + cube + with, 1);
    EXPECT_EQ(ray["common"]["first"]["beginning"], true) << method;
    EXPECT_EQ(ray["common"]["first"]["inside"], true) << method;
    EXPECT_EQ(ray["common"]["last"]["point"][0], 0.5) << method;
    const json edge = proved("pair " + cube + " " + space("edge.json") + with, 1);
    EXPECT_EQ(edge["common"]["kind"], "along") << method;
    EXPECT_EQ(edge["contact"], "touching") << method;
    EXPECT_EQ(edge["common"]["surface"]["edge"].size(), 2u) << method;
    const json apart = proved("pair " + cube + " " + space("line.json") + with + " --pose-a 3,0,0", 0);
    EXPECT_EQ(apart["common"], json::parse(R"({"kind": "nothing"})")) << method;
  }
  const json segment = proved("pair " + cube + " " + space("diagonal.wkt") + " --classify", 1);
  EXPECT_EQ(segment["cut"]["kind"], "across");
  EXPECT_EQ(segment["contact"], "overlapping");
  const json needle = report("pair " + space("needle.json") + " " + cube, 1);
  EXPECT_EQ(needle["cut"]["first"]["beginning"], true);
  EXPECT_EQ(needle["cut"]["last"]["end"], true);
  EXPECT_EQ(report("pair " + cube + " " + space("edge.wkt"), 1)["cut"]["kind"], "along");
}

// Each of the seven kinds against each: all are answered and proved, and swapping changes nothing.
TEST_F(SpaceProgram, EveryCombination) {
  const std::vector<std::string> files{space("point.wkt"),  space("needle.json"), space("ray.json"), space("line.json"),
                                       space("plane.json"), space("kite.json"),   space("kite.wkt"), cube};
  int meet = 0, apart = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::size_t j = i; j < files.size(); ++j) {
      const int code = run("pair " + files[i] + " " + files[j]).code;
      ASSERT_TRUE(code == 0 || code == 1) << files[i] << files[j];
      ++(code == 1 ? meet : apart);
      const json there = proved("pair " + files[i] + " " + files[j] + " --classify", code);
      const json back = report("pair " + files[j] + " " + files[i] + " --classify", code);
      EXPECT_EQ(there["contact"], back["contact"]) << files[i] << files[j];
    }
  }
  EXPECT_GT(meet, 12);
  EXPECT_GT(apart, 8);
}

TEST_F(SpaceProgram, FlatPolygons) {
  const json framed = proved("pair " + cube + " " + space("kite.json") + " --distance", 1);
  EXPECT_EQ(framed["objects"][1]["frame"]["u"], json::parse("[1.0, 0.1, 0.3]"));
  EXPECT_EQ(framed["objects"][1]["dimension"], 2);
  for (const char* method : {"automatic", "drums", "gjk", "hierarchy", "polar", "scan"}) {
    EXPECT_EQ(run("pair " + cube + " " + space("kite.json") + " --method " + method).code, 1) << method;
    EXPECT_EQ(run("pair " + cube + " " + space("kite.wkt") + " --pose-a 5,0,0 --method " + method).code, 0) << method;
  }
  proved("pair " + space("kite.json") + " " + cube + " --method drums", 1);
  proved("pair " + space("kite.wkt") + " " + cube + " --pose-b 5,0,0 --method drums", 0);
  expect_bad("pair " + space("kite.json") + " " + space("kite.wkt") + " --method drums",
             "--method: drums is for a body");
  // The frame moves with a pose, where that is exact.
  EXPECT_EQ(run("pair " + cube + " " + space("kite.json") + " --pose-b 0,0,4").code, 2);  // 4.1 is rounded
  EXPECT_EQ(run("pair " + cube + " " + space("kite.json") + " --pose-a 0,0,4").code, 0);
  EXPECT_EQ(run("pair " + cube + " " + space("kite.json") + " --pose-b -1,0,0,0,0,-1,0,0,0,0,1,0").code, 1);
  // What is not planar is refused, or projected.
  expect_bad("pair " + cube + " " + space("bent.json"), "is about 2.22e-16 off the plane of vertices 0, 2 and 1");
  const json projected = proved("pair " + cube + " " + space("bent.json") + " --project 0,0,0,1,0,0,0,1,0", 1);
  EXPECT_EQ(projected["objects"][1]["moved_about"], 0x1p-52);
  expect_bad("pair " + cube + " " + cube + " --project 0,0,0,1,0,0,0,1,0", "--project: neither is a polygon");
  expect_bad("pair " + cube + " " + space("bent.json") + " --project 0,0,0,1,0,0,2,0,0",
             "--project: frame: u and v are");
  expect_bad("pair " + cube + " " + space("bent.json") + " --project 0,0,0,1", "--project: a frame of 4 numbers");
  // One that is not convex is stood for by its hull.
  const std::string dart = file("dart.json", R"({"polygon": [[0,0,0], [4,4,4], [1,0.5,0.75], [0,4,2]]})");
  const json hull = report("pair " + dart + " " + cube, 1);
  EXPECT_EQ(hull["said_of"], "hulls");
  EXPECT_EQ(hull["objects"][0]["shape"], "hull");
  expect_bad("pair " + dart + " " + cube + " --require-convex", "is not exactly convex");
}

TEST_F(SpaceProgram, SectionsByPlanesOfFiles) {
  // x + 2 y + 2 z = 1/2 + 2/10, through a point that is not the origin.
  const json tilted = proved("section " + cube + " --plane " + space("tilted.json") + " --plane z=0.25", 1)["sections"];
  EXPECT_EQ(tilted[0]["through"], json::parse("[0.5, 0.1, 0.0]"));
  EXPECT_EQ(tilted[0]["kind"], "polygon");
  for (const json& corner : tilted[0]["corners"]) {
    const json& p = corner["point"];
    EXPECT_NEAR(p[0].get<double>() + 2 * p[1].get<double>() + 2 * p[2].get<double>(), 0.7, 1e-15);
  }
  const json level = report("section " + cube + " --plane " + space("plane.json"), 1)["sections"];
  EXPECT_EQ(level[0], tilted[1]);  // offset 0.25, through the origin
  expect_bad("section " + cube + " --plane " + space("line.json"), "line.json: is a line; give a plane");
  expect_bad("section " + cube + " --plane no.json", "no such file");
  const std::string zero = file("zero.json", R"({"plane": {"normal": [0, 0, 0], "offset": 1}})");
  expect_bad("section " + cube + " --plane " + zero, "zero.json");
}

TEST_F(SpaceProgram, WhatDoesNotApply) {
  const std::string plane = space("plane.json"), line = space("line.json"),
                    planar = "'" + cases + "/planar-pair/plate.wkt'";
  expect_bad("pair " + cube + " " + plane + " --distance", "--distance: is for bodies, polygons, segments and points");
  expect_bad("pair " + line + " " + plane + " --clearance 1", "--clearance: is for bodies");
  expect_bad("pair " + cube + " " + plane + " --method gjk", "choose one of automatic, drums, scan (with a plane)");
  expect_bad("pair " + cube + " " + line + " --method polar", "(with a line or a ray)");
  expect_bad("pair " + line + " " + plane + " --method scan", "(of lines, rays and planes)");
  expect_bad("pair " + cube + " " + plane + " --svg x.svg", "--svg: is for planar objects only");
  expect_bad("pair " + plane + " " + planar, "is an object of space, the other one is planar");
  expect_bad("pair " + planar + " " + space("kite.wkt"), "--drop-z ignores third coordinates");
  EXPECT_EQ(run("pair " + planar + " " + space("kite.wkt") + " --drop-z").code, 1);
  expect_bad("pair " + planar + " " + planar + " --project 0,0,0,1,0,0,0,1,0", "--project: is for polygons of space");
  expect_bad("pair " + cube + " " + line + " --pose-b 0,0,0.1,1e-20,0,0,0",
             "is not of doubles, and is not rounded; give the line in its place");
}

TEST_F(SpaceProgram, StandardInput) {
  EXPECT_EQ(run("pair " + cube + " - < " + space("plane.json")).code, 1);
  EXPECT_EQ(run("pair - " + space("above.json") + " < " + space("line.json")).code, 1);
  EXPECT_EQ(run("pair - " + space("above.json") + " < '" + cases + "/mesh/cube.obj'").code, 0);
}

}  // namespace

}  // namespace sunder::tests
