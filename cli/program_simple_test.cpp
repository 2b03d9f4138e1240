// The verb simple.
#include <tests/support/program.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace sunder::tests {
namespace {

TEST_F(Program, SimplePolygons) {
  EXPECT_EQ(run("simple --leave-out " + cases + "/segments/paths.wkt").code, 0);
  EXPECT_EQ(run("simple --leave-out " + cases + "/segments/pond.geojson --method scan").code, 0);
  expect_bad("simple " + cases + "/segments/wires.csv", "CSV has no polygons here; for segments, ask sunder segments");
  expect_bad("simple --leave-out " + cases + "/segments/paths.wkt --method fast", "choose one of automatic, scan");
  expect_bad("simple " + cases + "/segments/paths.wkt --strict --self-touch", "excludes");
  const std::string file = in_folder("two.wkt");
  write_text(file, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((0 0, 4 4, 4 0, 0 4, 0 0), (9 9, 8 9, 8 8, 9 9))\n");
  const json r = report("simple '" + file + "'", 1);
  EXPECT_EQ(r["answer"], "not valid");
  ASSERT_EQ(r["objects"].size(), 2u);
  EXPECT_EQ(r["objects"][0]["answer"], "valid");
  EXPECT_EQ(r["objects"][1]["defects"][0]["kind"], "crossing");
  EXPECT_EQ(r["objects"][1]["defects"][0]["at"], json::parse("[[2.0, 2.0]]"));
  EXPECT_EQ(r["objects"][1]["rings"], 2);
  std::string keys;  // those that all reports begin with, in their order
  const auto ordered = nlohmann::ordered_json::parse(run("simple '" + file + "' --json").out);
  for (const auto& [key, value] : ordered.items()) keys += key + " ";
  EXPECT_EQ(keys, "sunder verb answer method decided_by cost objects notes rule ");
  const Run text = run("simple '" + file + "'");
  EXPECT_EQ(text.out,
            "feature 2, line 2: not valid\n  crossing        ring 0 crosses itself at about (2, 2): edges 0 and 2\n" +
                file + ": 1 of 2 features valid, 11 edges, WKT\none defect of each is named; --all lists all\n");
  // A vertex that is repeated has a name of its own, and is valid.
  write_text(file, "POLYGON ((0 0, 1 0, 0 1, 0 0, 0 0))\n");
  EXPECT_EQ(run("simple '" + file + "'").code, 0);
  EXPECT_NE(run("simple --strict '" + file + "'").out.find("ring 0: vertices 3 and 0 are the same, (0, 0)"),
            std::string::npos);
  write_text(file, "POLYGON ((0 0, 0 0, 0 0, 0 0, 0 0))\n");
  EXPECT_EQ(run("simple '" + file + "'").code, 1);
  write_text(file, "POLYGON ((0 0, 1 0, 0 1, 0 0))\nLINESTRING (0 0, 1 1)\n");
  expect_bad("simple '" + file + "'", "--leave-out");
  const json left_out = report("simple --leave-out '" + file + "'", 0);
  EXPECT_EQ(left_out["left_out"][0]["kind"], "line");
}

// Each case by each rule: that it is valid, or each defect, is accepted by both verifiers, and of nothing else.
TEST_F(Program, ValidPolygonsAreProved) {
  const std::string proof = in_folder("proof.json");
  std::map<std::string, int> verdicts;
  for (const auto& entry : std::filesystem::directory_iterator(cases + "/valid-polygons")) {
    const std::string file = entry.path().string();
    if (!file.ends_with("wkt") && !file.ends_with("json")) continue;
    for (const std::string option : {"--all ", "--strict --all ", "--self-touch --all ", ""}) {
      const Run r = run("simple --json " + option + file + " --certificate " + proof);
      ASSERT_LT(r.code, 2) << r.err;
      EXPECT_EQ(run("verify " + proof).code, 0) << option << file;
      EXPECT_TRUE(python_accepts(proof)) << option << file;
      std::size_t statements = 0;
      const json told = json::parse(r.out);
      for (const json& feature : told["objects"]) {
        statements += std::max<std::size_t>(feature["defects"].size(), 1);
      }
      const json top = json::parse(read_text(proof));
      EXPECT_EQ(top["statements"].size(), statements) << option << file;
      for (const json& statement : top["statements"]) ++verdicts[statement["verdict"]];
    }
  }
  for (const char* verdict : {"valid", "too_few_points", "edges_meet", "comes_twice", "crosses", "misplaced", "circle",
                              "falls_apart", "repeated", "rings_touch"}) {
    EXPECT_GT(verdicts[verdict], 0) << verdict;
  }
  const std::string tracts = cases + "/tracts/tracts.wkt";
  EXPECT_EQ(run("simple " + tracts + " --certificate " + proof).code, 0);
  EXPECT_EQ(run("verify " + proof).code, 0);
  json top = json::parse(read_text(proof));
  top["tables"]["polygons"][7][0].erase(3);
  write_text(proof, top.dump());
  EXPECT_EQ(run("verify " + proof).code, 1);
}

// A spike, a repeated vertex and a hole without area: what is left is valid. Edges that cross stay.
TEST_F(Program, MendedPolygonsAreAskedAbout) {
  const std::string file = in_folder("spike.wkt");
  write_text(file,
             "POLYGON ((0 0, 9 0, 9 9, 9 12, 9 9, 9 9, 0 9, 0 0), (2 2, 3 3, 4 4, 2 2))\n"
             "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n");
  EXPECT_EQ(report("simple '" + file + "'", 1)["objects"][0]["answer"], "not valid");
  const json r = report("simple --mend '" + file + "'", 1);
  EXPECT_EQ(r["objects"][0]["answer"], "valid");
  EXPECT_EQ(r["mended"][0]["spikes"], 2);
  EXPECT_EQ(r["mended"][0]["rings_left_out"], 1);
  EXPECT_EQ(r["objects"][1]["answer"], "not valid");
  EXPECT_EQ(r["mended"].size(), 1u);
  const Run text = run("simple --mend '" + file + "'");
  EXPECT_NE(text.out.find("feature 1, line 1: mended: "), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("said of what was mended: 1 feature\n"), std::string::npos) << text.out;
  expect_bad("simple --mend '" + file + "' --svg " + in_folder("x.svg"), "excludes");
}

// The kinds of defects of the first feature, in their order, each once.
std::string kinds_of(const json& report) {
  std::string kinds, last;
  for (const json& defect : report["objects"][0]["defects"]) {
    const std::string kind = defect["kind"];
    if (kind != last) kinds += (kinds.empty() ? "" : " ") + kind;
    last = kind;
  }
  return kinds.empty() ? "-" : kinds;
}

TEST_F(Program, DefectsOfTheCases) {
  std::ifstream expected(cases + "/valid-polygons/EXPECTED.tsv");
  int files = 0;
  for (std::string line; std::getline(expected, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream columns(line);
    std::string file;
    std::getline(columns, file, '\t');
    SCOPED_TRACE(file);
    for (const std::string option : {"--strict ", "", "--self-touch "}) {
      std::string kinds;
      std::getline(columns, kinds, '\t');
      for (const std::string method : {"automatic", "scan"}) {
        const std::string call = "simple --all --method " + method + " " + option + cases + "/valid-polygons/" + file;
        EXPECT_EQ(kinds_of(report(call, kinds == "-" ? 0 : 1)), kinds) << call;
      }
    }
    ++files;
  }
  EXPECT_EQ(files, 20);
}

TEST_F(Program, AllDefectsAreNamedByFeature) {
  const Run text = run("simple --all " + cases + "/valid-polygons/several.wkt");
  EXPECT_EQ(text.code, 1);
  for (const char* part :
       {"feature 1, line 1: not valid\n", "ring 4 has fewer than three different vertices, at (1, 1)\n",
        "ring 3 crosses itself at about (4.5, 4.5): edges 0 and 2\n",
        "ring 2 is a hole inside of a hole, ring 1, at (2, 2)\n", "1 of 2 features valid"}) {
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
  }
  EXPECT_NE(run("simple " + cases + "/valid-polygons/sudan.geojson").out.find("feature 1 (Sudan): not valid"),
            std::string::npos);
  const Run outside = run("simple " + cases + "/valid-polygons/hole_outside.wkt");
  EXPECT_NE(outside.out.find("ring 1 is a hole outside of its shell, at (9, 1): edge 0\n"), std::string::npos)
      << outside.out;
  const Run parts = run("simple " + cases + "/valid-polygons/parts_share_border.wkt");
  EXPECT_NE(parts.out.find("part 0, ring 0 and part 1, ring 0 have a piece in common from about (4, 1) to (4, 3)"),
            std::string::npos)
      << parts.out;
}

// Rings that are none are refused with their line, closed, or passed over and listed.
TEST_F(Program, OpenRings) {
  const std::string file = in_folder("open.wkt");
  write_text(file,
             "POLYGON ((0 0, 4 0, 4 4, 0 4), (1 1, 2 1, 1 2, 1 1))\nPOLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n"
             "MULTIPOLYGON (((0 0, 1 0, 0 0)), ((5 5, 6 5, 6 6, 5 5)))\n");
  expect_bad("simple " + file, "open.wkt:1: ring 0: does not end where it began; repeat its first point at its end");
  const json mended = report("simple --mend --all " + file, 1);
  ASSERT_EQ(mended["objects"].size(), 3u);
  EXPECT_EQ(mended["objects"][0]["answer"], "valid");
  EXPECT_EQ(mended["mended"][0]["closed_rings"], 1);
  EXPECT_EQ(mended["objects"][1]["defects"][0]["places"][1]["edge"], 2);
  EXPECT_EQ(mended["objects"][2]["answer"], "valid");
  EXPECT_EQ(mended["mended"][1]["rings_left_out"], 1);
  EXPECT_NE(run("simple --mend " + file).out.find("feature 1, line 1: mended: 1 ring closed\n"), std::string::npos);
  const json skipped = report("simple --skip-invalid " + file, 1);
  ASSERT_EQ(skipped["objects"].size(), 1u);
  EXPECT_EQ(skipped["objects"][0]["feature"], 1);
  ASSERT_EQ(skipped["skipped"].size(), 2u);
  EXPECT_EQ(skipped["skipped"][1]["feature"], 2);
  EXPECT_EQ(skipped["skipped"][0]["why"], "ring 0: does not end where it began");
  const Run text = run("simple --skip-invalid " + file + " --svg " + in_folder("x.svg"));
  EXPECT_NE(text.out.find("feature 1, line 1: skipped: ring 0: does not end where it began\n"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("said of these only; skipped: 2 invalid features\n"), std::string::npos) << text.out;
  write_text(file, "POLYGON ((0 0, 4 0, 4 4, 0 4))\n");
  expect_bad("simple --skip-invalid " + file, "no polygon has all its rings, so nothing is left to ask about");
}

TEST_F(Program, SimpleNamesFeatures) {
  const std::string file = in_folder("map.geojson");
  write_text(file, R"({"type": "Feature", "properties": {"name": "x", "code": "D-7"}, "geometry": )"
                   R"({"type": "Polygon", "coordinates": [[[0,0],[4,4],[4,0],[0,4],[0,0]]]}})");
  EXPECT_EQ(report("simple " + file, 1)["objects"][0]["name"], "x");
  EXPECT_EQ(report("simple --name code " + file, 1)["objects"][0]["name"], "D-7");
  expect_bad("simple --name colour " + file, "colour");
}

TEST_F(Program, DefectsAsGeoJson) {
  const std::string file = in_folder("defects.geojson");
  EXPECT_EQ(run("simple " + cases + "/valid-polygons/several.wkt --geojson " + file).code, 1);
  const json defects = json::parse(read_text(file));
  ASSERT_EQ(defects["type"], "FeatureCollection");
  std::set<std::string> kinds;
  for (const json& feature : defects["features"]) {
    kinds.insert(feature["properties"]["kind"]);
    EXPECT_EQ(feature["properties"]["feature"], 0);
    EXPECT_EQ(feature["geometry"]["type"], feature["properties"]["kind"] == "overlap" ? "LineString" : "Point");
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"too-few-points", "crossing", "overlap", "nested-holes"}));
  const std::string picture = in_folder("picture.svg");
  EXPECT_EQ(run("simple " + cases + "/valid-polygons/several.wkt --svg " + picture).code, 1);
  EXPECT_NE(read_text(picture).find("Are these polygons valid?"), std::string::npos);
}

}  // namespace
}  // namespace sunder::tests
