// The verb segments.
#include <tests/support/program.h>

namespace sunder::tests {

namespace {

TEST_F(Program, SegmentsSomeMeet) {
  const std::string proof = in_folder("proof.json");
  const json r = report("segments " + cases + "/segments/wires.csv --certificate '" + proof + "'", 1);
  EXPECT_EQ(r["answer"], "some");
  ASSERT_EQ(r["contacts"].size(), 1u);
  EXPECT_EQ(r["contacts"][0]["contact"], "crossing");
  EXPECT_EQ(r["contacts"][0]["names"], (json{"clock", "reset"}));
  EXPECT_EQ(r["contacts"][0]["lines"], (json{3, 5}));
  EXPECT_NEAR(r["contacts"][0]["point"][0], 2.0, 1e-12);
  EXPECT_NEAR(r["contacts"][0]["point"][1], 1.5, 1e-12);
  EXPECT_TRUE(python_accepts(proof));
  const Run text = run("segments " + cases + "/segments/wires.csv");
  EXPECT_EQ(text.code, 1);
  EXPECT_NE(text.out.find("some meet\n  crossing at about (2, 1.5)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("feature reset, line 5: (1, 0.5) to (3, 2.5)"), std::string::npos) << text.out;
}

TEST_F(Program, SegmentsUnderRules) {
  const std::string paths = cases + "/segments/paths.wkt", pond = cases + "/segments/pond.geojson";
  const std::string proof = in_folder("proof.json");
  for (const char* method : {"automatic", "grid", "sweep", "bentley-ottmann", "scan"}) {
    const std::string by = std::string(" --method ") + method;
    EXPECT_EQ(run("segments " + paths + by).code, 1);
    EXPECT_EQ(run("segments " + paths + by + " --allow shared-endpoint").code, 0);
    EXPECT_EQ(run("segments " + pond + by + " --allow shared-endpoint").code, 1);
    EXPECT_EQ(run("segments " + pond + by + " --allow touch").code, 0);
  }
  const Run r = run("segments " + pond + " --allow touch --certificate '" + proof + "'");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.out.find("none meet (touch allowed)"), std::string::npos) << r.out;
  EXPECT_TRUE(python_accepts(proof));
  const Run verdict = run("verify '" + proof + "'");
  EXPECT_EQ(verdict.code, 0);
  EXPECT_NE(verdict.out.find("1 of 1 statement accepted\n  proved: no two segments meet"), std::string::npos)
      << verdict.out;
  // The same transcript does not prove more than it does.
  std::string text = read_text(proof);
  text.replace(text.find("\"touch\""), 7, "\"shared-endpoint\"");
  write_text(proof, text);
  EXPECT_FALSE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 1);
}

TEST_F(Program, SegmentsAllAndCount) {
  const std::string pond = cases + "/segments/pond.geojson";
  const json list = report("segments " + pond + " --all --allow shared-endpoint", 1);
  ASSERT_GT(list["count"], 0);
  EXPECT_EQ(list["count"], list["contacts"].size());
  for (const char* method : {"automatic", "grid", "bentley-ottmann", "balaban", "scan"}) {
    const std::string by = std::string(" --allow shared-endpoint --method ") + method;
    EXPECT_EQ(report("segments " + pond + " --all" + by, 1)["contacts"], list["contacts"]) << method;
    const json counted = report("segments " + pond + " --count" + by, 1);
    EXPECT_EQ(counted["count"], list["count"]) << method;
    EXPECT_TRUE(counted["contacts"].empty());
  }
  EXPECT_EQ(report("segments " + pond + " --count --allow touch", 0)["count"], 0);
}

TEST_F(Program, SegmentsOfABoard) {
  const std::string two = cases + "/boards/two_nets.kicad_pcb", crossing = cases + "/boards/crossing_nets.kicad_pcb";
  EXPECT_EQ(run("segments " + two + " --centre-lines").code, 0);
  EXPECT_EQ(run("segments " + two + " --centre-lines --layer B.Cu").code, 0);
  EXPECT_EQ(run("segments " + two + " --centre-lines --certificate '" + in_folder("two.json") + "'").code, 0);
  for (const char* layer : {"F.Cu", "B.Cu"}) {
    const std::string proof = in_folder(std::string("two.") + layer + ".json");
    EXPECT_TRUE(python_accepts(proof)) << layer;
    EXPECT_EQ(run("verify '" + proof + "'").code, 0) << layer;
  }
  const json across = report("segments " + two + " --centre-lines --all --across-layers", 1);
  ASSERT_EQ(across["contacts"].size(), 1u);
  EXPECT_NE(across["contacts"][0]["layers"][0], across["contacts"][0]["layers"][1]);
  EXPECT_NE(across["contacts"][0]["groups"][0], across["contacts"][0]["groups"][1]);
  const json r = report("segments " + crossing + " --centre-lines", 1);
  EXPECT_EQ(r["group"], "net");
  EXPECT_EQ(r["contacts"][0]["groups"], (json{"GND", "CLOCK"}));
  EXPECT_EQ(r["contacts"][0]["lines"], (json{11, 13}));
  EXPECT_EQ(r["contacts"][0]["i"], 0);
  EXPECT_EQ(r["contacts"][0]["j"], 2);
  EXPECT_EQ(report("segments " + crossing + " --centre-lines --group layer --all", 0)["contacts"].size(), 0u);
  EXPECT_EQ(
      report("segments " + crossing + " --centre-lines --group feature --count --allow shared-endpoint", 1)["count"],
      1);
}

// Members of a group that cross and overlap, three of them in one point: each such point is in the proof.
TEST_F(Program, SegmentsOfGroupsAreProvedApart) {
  const std::string file = in_folder("nets.csv"), proof = in_folder("nets.json");
  write_text(file,
             "x1,y1,x2,y2,net\n0,0,4,4,a\n0,4,4,0,a\n0,2,4,2,a\n1,2,3,2,a\n2.5,0,2.5,1,b\n3,0.5,2.75,1,b\n"
             "0,5,4,5,b\n1,4.5,1,6,b\n");
  EXPECT_EQ(report("segments '" + file + "' --count", 1)["count"], 7);  // one an overlap
  const Run r = run("segments '" + file + "' --group net --certificate '" + proof + "'");
  EXPECT_EQ(r.code, 0) << r.out;
  int crossings = 0;
  const json top = json::parse(read_text(proof));
  for (const json& event : top["statements"][0]["claims"][0]["events"]) {
    crossings += event[0] == -1;
  }
  EXPECT_EQ(crossings, 2);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
}

// A list and its length are proved: with groups, under each rule, by layers; and no other list or length is.
TEST_F(Program, SegmentsListsAreProved) {
  const std::string proof = in_folder("list.json"), with = " --certificate '" + proof + "'";
  for (const char* rule : {"nothing", "shared-endpoint", "touch"}) {
    const std::string call = "segments " + cases + "/segments/pond.geojson --allow " + std::string(rule);
    const json list = report(call + " --all", rule == std::string("touch") ? 0 : 1);
    const json proved = report(call + " --all" + with, rule == std::string("touch") ? 0 : 1);
    EXPECT_EQ(proved["contacts"], list["contacts"]);
    EXPECT_TRUE(python_accepts(proof));
    EXPECT_EQ(run("verify '" + proof + "'").code, 0);
    json top = json::parse(read_text(proof));
    json& said = top["statements"][0];
    EXPECT_EQ(said["contacts"].size(), list["contacts"].size());
    said["contacts"].push_back({0, said["contacts"].empty() ? 1 : 2000, "crossing"});
    write_text(proof, top.dump());
    EXPECT_EQ(run("verify '" + proof + "'").code, 1);

    const json counted = report(call + " --count" + with, rule == std::string("touch") ? 0 : 1);
    EXPECT_EQ(counted["count"], list["count"]);
    EXPECT_TRUE(python_accepts(proof));
    top = json::parse(read_text(proof));
    EXPECT_EQ(top["statements"][0]["number"], list["count"]);
    top["statements"][0]["number"] = list["count"].get<int>() + 1;
    write_text(proof, top.dump());
    EXPECT_FALSE(python_accepts(proof));
    EXPECT_EQ(run("verify '" + proof + "'").code, 1);
  }
  const std::string board = "segments " + cases + "/boards/crossing_nets.kicad_pcb --centre-lines --all --svg '" +
                            in_folder("board.svg") + "'";
  EXPECT_EQ(run(board + with).code, 1);
}

TEST_F(Program, SegmentsNearTheEndOfTheRange) {
  write_text(in_folder("large.csv"), "1.5e308,1.5e308,1.7e308,1.71e308\n1.5e308,1.7e308,1.7e308,1.52e308\n");
  const json r = report("segments '" + in_folder("large.csv") + "'", 1);
  EXPECT_GT(r["contacts"][0]["point"][0], 1.5e308);
  EXPECT_LT(r["contacts"][0]["point"][0], 1.7e308);
}

TEST_F(Program, SegmentsBadCallsAndFiles) {
  const std::string wires = cases + "/segments/wires.csv";
  expect_bad("segments " + wires + " --allow crossing", "there is nothing named 'crossing' to allow");
  expect_bad("segments " + wires + " --method fast", "choose one of automatic, grid, sweep, bentley-ottmann, scan");
  expect_bad("segments " + wires + " --count --method sweep",
             "choose one of automatic, grid, bentley-ottmann, balaban, scan (for");
  expect_bad("segments " + wires + " --count --method balaban --certificate '" + in_folder("p.json") + "'",
             "balaban proves no lists");
  expect_bad("segments " + wires + " --any --count", "excludes");
  expect_bad("segments " + wires + " --layer F.Cu", "has no layers");
  expect_bad("segments " + wires + " --across-layers", "has no layers");
  expect_bad("segments " + wires + " --group net", "no column 'net' to group by");
  expect_bad("segments " + cases + "/boards/two_nets.kicad_pcb --centre-lines --layer Top", "layers are F.Cu, B.Cu");
  expect_bad("segments " + wires + " --method scan --certificate '" + in_folder("p.json") + "'", "scan writes no");
  expect_bad("segments " + in_folder("none.csv"), "none.csv");
  write_text(in_folder("bad.wkt"), "LINESTRING (0 0, 1 nan)\n");
  expect_bad("segments '" + in_folder("bad.wkt") + "'", "bad.wkt:1: 'nan' is NaN");
}

}  // namespace

}  // namespace sunder::tests
