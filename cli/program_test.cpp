// Runs the program: exit codes, messages, reports, files.
// long because: it goes through the program verb by verb, with one set of helpers.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string cases = SUNDER_CASES_DIR;
const std::string cube = cases + "/mesh/cube.obj";
const std::string tetrahedron = cases + "/mesh/tetrahedron.stl";
const std::string panda = cases + "/panda/panda.urdf";
const std::string ready = " --joints-file " + cases + "/scene/ready.joints";
const std::string folded = " --joints-file " + cases + "/scene/folded.joints";

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_text(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// A folder of its own for each test, removed at the end.
class Program : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "sunder_program_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }

  struct Run {
    int code = -1;
    std::string out, err;
  };

  // The arguments as a shell reads them.
  Run run(const std::string& arguments) const {
    const std::string err = in_folder("stderr");
    const std::string command = std::string("'") + SUNDER_PROGRAM + "' " + arguments + " 2> '" + err + "'";
    Run result;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return result;
    std::array<char, 4096> buffer;
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
      result.out.append(buffer.data(), n);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) result.code = WEXITSTATUS(status);
    result.err = read_text(err);
    fs::remove(err);
    return result;
  }

  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  // Code 2, nothing on standard output, one line on standard error that holds `part`, no file left behind.
  void expect_bad(const std::string& arguments, const std::string& part) {
    const std::size_t before = files_in_folder();
    const Run r = run(arguments);
    EXPECT_EQ(r.code, 2) << arguments << "\n" << r.err;
    EXPECT_EQ(r.out, "") << arguments;
    EXPECT_TRUE(r.err.starts_with("sunder: ")) << arguments << "\n" << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << arguments << "\n" << r.err;
    EXPECT_NE(r.err.find(part), std::string::npos) << arguments << "\n" << r.err << "expected: " << part;
    EXPECT_EQ(files_in_folder(), before) << arguments;
  }

  // The report, with the keys that all verbs have.
  json report(const std::string& arguments, int code) {
    const Run r = run(arguments + " --json");
    EXPECT_EQ(r.code, code) << arguments << "\n" << r.err;
    const json j = json::parse(r.out, nullptr, false);
    EXPECT_FALSE(j.is_discarded()) << r.out;
    for (const char* key : {"sunder", "verb", "answer", "method", "decided_by", "cost", "objects"}) {
      EXPECT_TRUE(j.contains(key)) << arguments << ": " << key;
    }
    EXPECT_EQ(j.value("sunder", 0), 1);
    EXPECT_EQ(j.value("verb", ""), arguments.substr(0, arguments.find(' ')));
    return j;
  }

  // Does the Python verifier accept the file?
  static bool python_accepts(const std::string& file) {
    const std::string verifier = SUNDER_SOURCE_DIR "/verifier/sunder_verify.py";
    return std::system(("python3 '" + verifier + "' --quiet '" + file + "' > /dev/null").c_str()) == 0;
  }

  fs::path folder_;
};

TEST_F(Program, HelpAndVersion) {
  for (const char* call : {"--help", "pair --help", "scene --help", "segments --help", "simple --help", "hull --help",
                           "info --help", "verify --help"}) {
    const Run r = run(call);
    EXPECT_EQ(r.code, 0) << call;
    EXPECT_NE(r.out.find("Usage"), std::string::npos) << call;
    EXPECT_EQ(r.err, "") << call;
  }
  EXPECT_TRUE(run("--version").out.starts_with("sunder "));
}

TEST_F(Program, BadCalls) {
  expect_bad("",
             "no verb is given; verbs are pair, scene, segments, simple, circles, polygons, region, kernel, hull, "
             "info, verify");
  expect_bad("frob", "there is no verb 'frob'");
  expect_bad("--frob", "there is no option '--frob'");
  expect_bad("pair", "A is required");
  expect_bad("pair " + cube, "B is required");
  expect_bad("pair a b c", "nothing is expected at 'c'");
  expect_bad("pair a b --frob", "there is no option '--frob'; see sunder pair --help");
  expect_bad("pair a b --method", "--method");
  expect_bad("pair " + cube + " " + cube + " --method frob",
             "there is no method 'frob'; choose one of automatic, gjk, scan");
  expect_bad("hull", "FILE is required");
  expect_bad("info", "name files, or ask for --formats");
  expect_bad("verify", "FILE is required");
  expect_bad("scene", "FILE is required");
  expect_bad("hull " + cube + " -o " + in_folder("hull.xyz"), "hull.xyz");
}

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

TEST_F(Program, BadFilesOfAllKinds) {
  expect_bad("pair " + cube + " " + in_folder("none.obj"), "none.obj: no such file");
  expect_bad("pair " + cube + " " + folder_.string(), "is a folder");
  std::size_t meshes = 0, robots = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(cases + "/broken")) {
    const std::string name = entry.path().filename().string();
    if (name == "README.md" || name == "EXPECTED.tsv") continue;
    const std::string file = "'" + entry.path().string() + "'";
    if (entry.path().extension() == ".urdf") {
      expect_bad("scene " + file + " --svg " + in_folder("s.svg"), name);
      ++robots;
    } else {
      expect_bad("pair " + cube + " " + file + " --certificate " + in_folder("c.json"), name);
      ++meshes;
    }
  }
  EXPECT_GE(meshes, 60u);
  EXPECT_GE(robots, 15u);
  const std::string broken = cases + "/broken/nan.obj";
  for (const std::string& call :
       {"hull " + broken + " -o " + in_folder("h.obj"), "info " + broken, "scene " + broken}) {
    expect_bad(call, "nan.obj:2");
  }
}

TEST_F(Program, NothingIsHalfWritten) {
  const std::string pair = "pair " + cube + " " + tetrahedron;
  expect_bad(pair + " --certificate " + in_folder("no/such/folder/c.json"), "c.json");
  expect_bad(pair + " --certificate " + folder_.string(), "is a folder");
  const std::string old = in_folder("old.json");
  write_text(old, "old");
  expect_bad("pair " + cube + " " + in_folder("none.obj") + " --certificate " + old, "none.obj");
  EXPECT_EQ(read_text(old), "old");
  if (fs::exists("/dev/full")) {
    const Run r = run(pair + " > /dev/full");
    EXPECT_EQ(r.code, 2);
    EXPECT_NE(r.err.find("standard output: cannot be written"), std::string::npos) << r.err;
  }
}

TEST_F(Program, PairAnswers) {
  const std::string pair = "pair " + cube + " " + cube;
  for (const char* method : {"automatic", "gjk", "scan"}) {
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
  EXPECT_EQ(j["evidence"]["point_about"].size(), 3u);
  EXPECT_EQ(report("pair " + cube + " " + tetrahedron + " --classify", 1)["contact"], "overlapping");
  EXPECT_EQ(report("pair " + cube + " " + tetrahedron + " --classify --pose-b 0.6,0,0", 0)["contact"], "none");
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
           {"pair " + cube + " " + cube + " --distance", "is for planar objects only"},
           {pair + "--feature-b far --method gjkk", "there is no method 'gjkk' for planar objects"},
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
TEST_F(Program, UnboundedPairs) {
  const std::string plate = cases + "/planar-pair/plate.wkt", paths = cases + "/planar-pair/paths.csv";
  const std::string proof = in_folder("proof.json"), picture = in_folder("cut.svg");
  struct Expected {
    const char *feature, *kind, *contact;
    std::size_t statements;
  };
  for (const auto& [feature, kind, contact, statements] :
       std::vector<Expected>{{"diagonal", "across", "overlapping", 1},
                             {"roof", "along", "touching", 1},
                             {"corner", "point", "touching", 1},
                             {"above", "nothing", "none", 2},
                             {"beam", "across", "overlapping", 1},
                             {"away", "nothing", "none", 1},
                             {"tip", "point", "touching", 1},
                             {"east", "part", "overlapping", 1},
                             {"river", "along", "touching", 1},
                             {"north", "whole", "overlapping", 1},
                             {"hill", "nothing", "none", 2}}) {
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
      EXPECT_EQ(json::parse(read_text(proof))["pairs"].size(), statements);
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
  EXPECT_EQ(across["first"], json::parse(R"({"point_about": [1.0, 3.0], "along_line": "1/4", "edge": [2, 3],
                                             "along_edge": "3/4"})"));
  EXPECT_EQ(across["last"]["along_line"], "5/8");
  EXPECT_EQ(report(pair + "above", 0)["common"]["nearest"], 3);
  EXPECT_EQ(report(pair + "beam", 1)["common"]["first"],
            json::parse(R"({"point_about": [2.0, 1.0], "along_line": "0", "inside": true, "beginning": true})"));
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
           {pair + "roof --distance", "--distance: is for points, segments and polygons"},
           {pair + "beam --method fibonacci", "where one object is a ray; choose one of automatic, scan"},
           {pair + "roof --method gjk", "where one object is a line; choose one of automatic, fibonacci, scan"},
           {pair + "roof --pose-a 9,0 --certificate '" + in_folder("none.json") + "'", "between the two points given"},
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
  const std::size_t at = text.find("\"extreme_b\": ") + 13;
  text[at] = text[at] == '0' ? '1' : '0';
  const std::string changed = in_folder("changed.json");
  write_text(changed, text);
  EXPECT_EQ(run("verify " + changed).code, 1);
  EXPECT_EQ(run("verify " + apart + " " + changed).code, 1);
  const json j = report("verify " + changed, 1);
  EXPECT_EQ(j["answer"], "refused");
  EXPECT_EQ(j["objects"][0]["refused"][0]["check"], "A2");

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
    EXPECT_EQ(j["edges"], 12);
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

TEST_F(Program, SceneOfTheArm) {
  const std::string call = "scene " + panda + ready + folded + " --allow adjacent --classify";
  const std::string proofs = in_folder("proofs.json"), svg = in_folder("arm.svg");
  const json j = report(call + " --certificate " + proofs + " --svg " + svg, 1);
  EXPECT_EQ(j["answer"], "some");
  EXPECT_EQ(j["bodies"].size(), 11u);
  ASSERT_EQ(j["placements"].size(), 2u);
  EXPECT_EQ(j["placements"][0]["name"], "ready");
  EXPECT_EQ(j["placements"][0]["answer"], "none");
  EXPECT_EQ(j["placements"][1]["answer"], "some");
  std::vector<json> meeting;
  for (const json& pair : j["pairs"]) {
    if (pair["answer"] == "meet") meeting.push_back(pair);
  }
  ASSERT_EQ(meeting.size(), 1u);
  EXPECT_EQ(meeting[0]["a"], "panda_link1");
  EXPECT_EQ(meeting[0]["b"], "panda_hand");
  EXPECT_EQ(meeting[0]["contact"], "overlapping");
  EXPECT_EQ(meeting[0]["placement"], 1);
  EXPECT_EQ(j["counts"]["pairs"].get<int>(), 248);
  EXPECT_EQ(j["pairs"].size(), j["counts"]["pairs"].get<std::size_t>() - j["counts"]["allowed"].get<std::size_t>());

  const json verified = report("verify " + proofs, 0);
  EXPECT_EQ(verified["objects"][0]["pairs"], j["pairs"].size());
  EXPECT_EQ(verified["objects"][0]["meet"], 1);

  const std::string picture = read_text(svg);
  EXPECT_TRUE(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"));
  EXPECT_NE(picture.find("panda_link1 meets panda_hand"), std::string::npos);
  EXPECT_EQ(picture.find("nan"), std::string::npos);

  EXPECT_EQ(run("scene " + panda + ready + " --allow adjacent").code, 0);
  EXPECT_EQ(run("scene " + panda + ready).code, 1);  // neighbours meet
  EXPECT_EQ(run("scene " + panda + folded + " --allow adjacent --allow panda_hand,panda_link1").code, 0);
  write_text(in_folder("allow"), "# what may meet\npanda_link1 panda_hand\n");
  EXPECT_EQ(run("scene " + panda + folded + " --allow adjacent --allow " + in_folder("allow")).code, 0);
}

TEST_F(Program, SceneOfMeshes) {
  EXPECT_EQ(run("scene " + cube + " " + cube + "@3,0,0").code, 0);
  EXPECT_EQ(run("scene " + cube + " " + cube + "@1,0,0").code, 1);
  EXPECT_EQ(run("scene " + cube + " " + cube + "@1,0,0 --allow touch").code, 0);
  EXPECT_EQ(run("scene " + cube + " " + cube + " --pose 'cube#2=1,0.5,3'").code, 0);
  const json j = report("scene " + cases + "/mesh/two_parts.obj " + tetrahedron + "@20,0,0", 0);
  EXPECT_EQ(j["bodies"][0]["parts"].size(), 2u);
  EXPECT_EQ(j["counts"]["pairs"], 2);
  EXPECT_EQ(j["pairs"].size(), 0u);
  const json far = report("scene " + cube + " " + cube + "@3,0,0 --certificate " + in_folder("c.json"), 0);
  ASSERT_EQ(far["pairs"].size(), 1u);
  EXPECT_EQ(far["pairs"][0]["decided_by"], "boxes");
  EXPECT_EQ(run("verify " + in_folder("c.json")).code, 0);
  EXPECT_EQ(run("scene " + panda + ready + " --allow adjacent " + cube + "@0,0,-0.45").code, 1);  // under its base
}

TEST_F(Program, BadScenes) {
  const std::string arm = "scene " + panda;
  expect_bad(arm + " --joints panda_joint1", "'panda_joint1' is no joint with a value");
  expect_bad(arm + " --joints panda_joint1=x", "'x' is not a number");
  expect_bad(arm + " --joints panda_joint1=9", "out of the limits");
  expect_bad(arm + " --joints elbow=1", "joint 'elbow'");
  expect_bad(arm + " --joints panda_joint1=0,panda_joint1=1", "comes twice");
  expect_bad(arm + " --joints-file " + in_folder("none"), "no such file");
  expect_bad(arm + " --allow neighbours", "give adjacent, touch, NAME,NAME, or a file");
  expect_bad(arm + " --allow panda_link1,elbow", "no body is named 'elbow'");
  expect_bad(arm + " " + panda, "a second robot");
  expect_bad("scene " + cube + " --joints a=1", "there is no robot");
  expect_bad("scene " + cube + " --allow adjacent", "there is no robot");
  expect_bad("scene " + cube + "@1,2", "a pose of 2 numbers");
  expect_bad("scene " + cube + " --pose sphere=1,2,3", "nothing is named 'sphere'; names are cube");
  expect_bad("scene " + cube + " --pose cube", "is not of the form NAME=POSE");
  expect_bad("scene " + cube + " --method frob", "choose one of automatic, gjk, scan");
  write_text(in_folder("bad.joints"), "# fine\npanda_joint1 = 0.1\npanda_joint2 = far\n");
  expect_bad(arm + " --joints-file " + in_folder("bad.joints"), "bad.joints:3");
}

TEST_F(Program, SegmentsSomeMeet) {
  const std::string proof = in_folder("proof.json");
  const json r = report("segments " + cases + "/segments/wires.csv --certificate '" + proof + "'", 1);
  EXPECT_EQ(r["answer"], "some");
  ASSERT_EQ(r["contacts"].size(), 1u);
  EXPECT_EQ(r["contacts"][0]["kind"], "crossing");
  EXPECT_EQ(r["contacts"][0]["features"], (json{"clock", "reset"}));
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
  EXPECT_NE(verdict.out.find("1 of 1 statement accepted (1 none, 0 some)"), std::string::npos) << verdict.out;
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
  EXPECT_EQ(run("segments " + two).code, 0);
  EXPECT_EQ(run("segments " + two + " --layer B.Cu").code, 0);
  EXPECT_EQ(run("segments " + two + " --certificate '" + in_folder("two.json") + "'").code, 0);
  for (const char* layer : {"F.Cu", "B.Cu"}) {
    const std::string proof = in_folder(std::string("two.") + layer + ".json");
    EXPECT_TRUE(python_accepts(proof)) << layer;
    EXPECT_EQ(run("verify '" + proof + "'").code, 0) << layer;
  }
  const json across = report("segments " + two + " --all --across-layers", 1);
  ASSERT_EQ(across["contacts"].size(), 1u);
  EXPECT_NE(across["contacts"][0]["layers"][0], across["contacts"][0]["layers"][1]);
  EXPECT_NE(across["contacts"][0]["groups"][0], across["contacts"][0]["groups"][1]);
  const json r = report("segments " + crossing, 1);
  EXPECT_EQ(r["group"], "net");
  EXPECT_EQ(r["contacts"][0]["groups"], (json{"GND", "CLOCK"}));
  EXPECT_EQ(r["contacts"][0]["lines"], (json{11, 13}));
  EXPECT_EQ(r["contacts"][0]["i"], 0);
  EXPECT_EQ(r["contacts"][0]["j"], 2);
  EXPECT_EQ(report("segments " + crossing + " --group layer --all", 0)["contacts"].size(), 0u);
  EXPECT_EQ(report("segments " + crossing + " --group feature --count --allow shared-endpoint", 1)["count"], 1);
}

// Members of a group that cross and overlap, three of them in one point: each crossing is in the proof, as an exchange.
TEST_F(Program, SegmentsOfGroupsAreProvedApart) {
  const std::string file = in_folder("nets.csv"), proof = in_folder("nets.json");
  write_text(file,
             "x1,y1,x2,y2,net\n0,0,4,4,a\n0,4,4,0,a\n0,2,4,2,a\n1,2,3,2,a\n2.5,0,2.5,1,b\n3,0.5,2.75,1,b\n"
             "0,5,4,5,b\n1,4.5,1,6,b\n");
  EXPECT_EQ(report("segments '" + file + "' --count", 1)["count"], 7);  // one an overlap
  const Run r = run("segments '" + file + "' --group net --certificate '" + proof + "'");
  EXPECT_EQ(r.code, 0) << r.out;
  EXPECT_EQ(json::parse(read_text(proof))["statements"][0]["exchanges"].size(), 6u);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
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
  expect_bad("segments " + wires + " --count --certificate '" + in_folder("p.json") + "'", "counts have no proof");
  expect_bad("segments " + wires + " --any --count", "excludes");
  expect_bad("segments " + wires + " --layer F.Cu", "has no layers");
  expect_bad("segments " + wires + " --across-layers", "has no layers");
  expect_bad("segments " + wires + " --group net", "no field 'net' to group by");
  expect_bad("segments " + cases + "/boards/two_nets.kicad_pcb --layer Top", "layers are F.Cu, B.Cu");
  expect_bad("segments " + wires + " --method scan --certificate '" + in_folder("p.json") + "'", "scan writes no");
  expect_bad("segments " + in_folder("none.csv"), "none.csv");
  write_text(in_folder("bad.wkt"), "LINESTRING (0 0, 1 nan)\n");
  expect_bad("segments '" + in_folder("bad.wkt") + "'", "bad.wkt:1: 'nan' is NaN");
}

TEST_F(Program, SimplePolygons) {
  EXPECT_EQ(run("simple " + cases + "/segments/paths.wkt").code, 0);
  EXPECT_EQ(run("simple " + cases + "/segments/pond.geojson --method scan").code, 0);
  expect_bad("simple " + cases + "/segments/wires.csv", "has no polygons; for lines, ask sunder segments");
  expect_bad("simple " + cases + "/segments/paths.wkt --method fast", "choose one of automatic, grid, sweep, scan");
  const std::string file = in_folder("two.wkt");
  write_text(file, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((0 0, 4 4, 4 0, 0 4, 0 0), (9 9, 8 9, 8 8, 9 9))\n");
  const json r = report("simple '" + file + "'", 1);
  EXPECT_EQ(r["answer"], "not simple");
  ASSERT_EQ(r["objects"].size(), 2u);
  EXPECT_EQ(r["objects"][0]["answer"], "simple");
  EXPECT_EQ(r["objects"][1]["contact"]["kind"], "crossing");
  EXPECT_EQ(r["objects"][1]["rings"], 2);
  const Run text = run("simple '" + file + "'");
  EXPECT_NE(text.out.find("feature 2: not simple: crossing"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("ring 0, edge 0, line 2: (0, 0) to (4, 4)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("1 of 2 polygons simple, 11 edges"), std::string::npos) << text.out;
  // A vertex repeated just where the ring is closed counts as anywhere else.
  write_text(file, "POLYGON ((0 0, 1 0, 0 1, 0 0, 0 0))\n");
  EXPECT_EQ(run("simple '" + file + "'").code, 1);
  write_text(file, "POLYGON ((0 0, 0 0, 0 0, 0 0, 0 0))\n");
  EXPECT_EQ(run("simple '" + file + "'").code, 1);
  write_text(file, "POLYGON ((0 0, 1 0, 0 1, 0 0))\nLINESTRING (0 0, 1 1)\n");
  EXPECT_NE(run("simple '" + file + "'").out.find("1 segment of lines passed over"), std::string::npos);
}

TEST_F(Program, Circles) {
  const std::string moon = cases + "/circles/moon.csv";
  const Run count = run("circles " + moon + " --count --json");
  EXPECT_EQ(count.code, 1) << count.err;
  const json report = json::parse(count.out);
  EXPECT_EQ(report["count"], 86);
  EXPECT_EQ(report["counts"]["overlapping"], 74);
  for (const std::string method : {"grid", "sweep", "scan"}) {
    EXPECT_EQ(json::parse(run("circles " + moon + " --all --json --method " + method).out)["contacts"].size(), 86u);
  }
  const std::string apart = in_folder("apart.csv"), proof = in_folder("proof.json");
  write_text(apart, "0,0,1\n2,0,1\n");
  EXPECT_EQ(run("circles " + apart).code, 1);
  EXPECT_EQ(run("circles " + apart + " --allow touch --certificate " + proof).code, 0);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_EQ(run("circles " + moon + " --svg " + in_folder("moon.svg")).code, 1);
  EXPECT_NE(read_text(in_folder("moon.svg")).find("inside 12"), std::string::npos);
  write_text(apart, "0,0,1\n2,0,-1\n");
  const Run negative = run("circles " + apart);
  EXPECT_EQ(negative.code, 2);
  EXPECT_NE(negative.err.find("apart.csv:2: has a negative radius"), std::string::npos) << negative.err;
  EXPECT_EQ(run("circles " + moon + " --all --certificate " + proof).code, 2);
}

TEST_F(Program, Polygons) {
  const std::string tracts = cases + "/tracts/tracts.wkt";
  const Run count = run("polygons " + tracts + " --count --json");
  EXPECT_EQ(count.code, 1) << count.err;
  EXPECT_EQ(json::parse(count.out)["counts"]["touching"], 607);
  EXPECT_EQ(run("polygons " + tracts + " --allow touch").code, 0);
  const std::string proof = in_folder("proof.json");
  for (const std::string rule : {"nothing", "shared-endpoint", "touch"}) {
    EXPECT_EQ(run("polygons " + tracts + " --certificate " + proof + " --allow " + rule).code, rule == "touch" ? 0 : 1);
    EXPECT_EQ(run("verify " + proof).code, 0) << rule;
    EXPECT_TRUE(python_accepts(proof)) << rule;
  }
  expect_bad("polygons " + tracts + " --all --certificate " + in_folder("none.json"), "have no proof");
  expect_bad("polygons " + tracts + " --method scan --certificate " + in_folder("none.json"), "scan writes no");
  const std::string two = in_folder("two.wkt");
  write_text(two, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((1 1, 2 1, 2 2, 1 1))\n");
  for (const std::string method : {"automatic", "grid", "sweep", "scan"}) {
    const Run inside = run("polygons " + two + " --allow touch --method " + method);
    EXPECT_EQ(inside.code, 1) << inside.err;
    EXPECT_NE(inside.out.find("overlapping: 1 (line 1) and 2 (line 2): a vertex inside"), std::string::npos)
        << inside.out;
  }
  EXPECT_EQ(run("polygons " + two + " --svg " + in_folder("two.svg")).code, 1);
  write_text(two, "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n");
  const Run crossed = run("polygons " + two);
  EXPECT_EQ(crossed.code, 2);
  EXPECT_NE(crossed.err.find("feature 1: is not simple: edge 0 of ring 0"), std::string::npos) << crossed.err;
}

// Pads of one net may meet; the one pair of two nets is found.
TEST_F(Program, CirclesOfGroups) {
  const std::string pads = in_folder("pads.csv");
  write_text(pads, "x,y,r,net,name\n0,0,2,GND,a\n3,0,2,GND,b\n6,0,2,VCC,c\n20,0,1,VCC,d\n");
  EXPECT_EQ(run("circles " + pads).code, 2);
  for (const std::string method : {"automatic", "grid", "sweep", "scan"}) {
    const json all = report("circles " + pads + " --all --group net --method " + method, 1);
    ASSERT_EQ(all["count"], 1) << method;
    EXPECT_EQ(all["contacts"][0]["names"], (json{"b", "c"}));
    EXPECT_EQ(all["contacts"][0]["groups"], (json{"GND", "VCC"}));
    EXPECT_EQ(report("circles " + pads + " --group net --method " + method, 1)["contacts"].size(), 1u);
  }
  EXPECT_EQ(report("circles " + pads + " --count --group name", 1)["count"], 2);
  const Run text = run("circles " + pads + " --group net");
  EXPECT_NE(text.out.find("2 groups; those of one net may meet\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("circle b of GND, line 3: "), std::string::npos) << text.out;
  expect_bad("circles " + pads + " --group layer", "no column 'layer' to group by; there are net, name");
  expect_bad("circles " + pads + " --group net --certificate " + in_folder("none.json"), "has no proof yet");
}

// Two layers of a map: parcels may meet one another, and zones too; the one parcel in a zone is found.
TEST_F(Program, PolygonsOfGroups) {
  const std::string map = in_folder("map.geojson");
  const auto feature = [](const std::string& layer, const std::string& rings) {
    return R"({"type": "Feature", "properties": {"layer": ")" + layer + R"("}, "geometry": {"type": "MultiPolygon", )" +
           R"("coordinates": [)" + rings + "]}}";
  };
  const std::string left = "[[[0,0],[4,0],[4,4],[0,4],[0,0]]]", right = "[[[4,0],[8,0],[8,4],[4,4],[4,0]]]",
                    zone = "[[[6,3],[9,3],[9,9],[6,9],[6,3]]]", other = "[[[7,8],[10,8],[10,10],[7,10],[7,8]]]";
  write_text(map, R"({"type": "FeatureCollection", "features": [)" + feature("parcels", left + "," + right) + "," +
                      feature("zones", zone) + "," + feature("zones", other) + "]}");
  const json all = report("polygons " + map + " --all", 1),
             by_layer = report("polygons " + map + " --all --group layer", 1);
  EXPECT_EQ(all["count"], 3);
  EXPECT_EQ(by_layer["count"], 1);
  EXPECT_EQ(by_layer["contacts"][0]["i"], 1);
  EXPECT_EQ(by_layer["contacts"][0]["j"], 2);
  EXPECT_EQ(by_layer["contacts"][0]["groups"], (json{"parcels", "zones"}));
  EXPECT_EQ(report("polygons " + map + " --count --group feature", 1)["count"], 2);
  const Run text = run("polygons " + map + " --group layer");
  EXPECT_NE(text.out.find("2 groups; those of one layer may meet\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find(" of parcels and "), std::string::npos) << text.out;
  expect_bad("polygons " + map + " --group colour", "has no property 'colour'");
  expect_bad("polygons " + map + " --group ring", "rings belong to polygons");
  expect_bad("polygons " + map + " --group layer --certificate " + in_folder("none.json"), "has no proof yet");
}

TEST_F(Program, Regions) {
  const std::string some = cases + "/half-planes/co2-five-years.csv", none = cases + "/half-planes/co2.csv";
  const std::string proof = in_folder("proof.json");
  for (const std::string method : {"automatic", "sort", "division", "scan"}) {
    const Run region = run("region " + some + " --json --method " + method + " --certificate " + proof);
    EXPECT_EQ(region.code, 0) << region.err;
    EXPECT_EQ(json::parse(region.out)["region"]["corners"].size(), 4u);
    EXPECT_EQ(run("verify " + proof).code, 0);
  }
  const Run best = run("region " + some + " --maximize 1,0 --certificate " + proof);
  EXPECT_NE(best.out.find("is greatest, about 0.7733333333"), std::string::npos) << best.out;
  EXPECT_EQ(run("verify " + proof).code, 0);
  const Run empty = run("region " + none + " --certificate " + proof + " --svg " + in_folder("none.svg"));
  EXPECT_EQ(empty.code, 1);
  EXPECT_NE(empty.out.find("contradict each other"), std::string::npos);
  EXPECT_EQ(run("verify " + proof).code, 0);
  const std::string file = in_folder("rows.csv");
  write_text(file, "1,0,1\n0,0,1\n");
  const Run zero = run("region " + file);
  EXPECT_EQ(zero.code, 2);
  EXPECT_NE(zero.err.find("rows.csv:2: a and b are zero"), std::string::npos) << zero.err;
  write_text(file, "0,0,5\n3,0,5\n0,4,5\n");
  const Run circles = run("region --of circles " + file + " --json --certificate " + proof);
  EXPECT_EQ(circles.code, 0) << circles.err;
  EXPECT_EQ(json::parse(circles.out)["region"]["arcs"].size(), 3u);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_EQ(run("region --of circles " + file + " --svg " + in_folder("part.svg")).code, 0);
  EXPECT_EQ(run("region --of squares " + file).code, 2);
  EXPECT_EQ(run("region " + some + " --maximize 1").code, 2);
}

TEST_F(Program, RegionsOfPolygons) {
  const std::string file = in_folder("convex.wkt"), proof = in_folder("proof.json");
  const auto ask = [&](const std::string& rest) {
    return run("region --of polygons " + file + " --certificate " + proof + rest);
  };
  write_text(file, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((3 1, 7 1, 7 3, 3 3, 3 1))\n");
  for (const std::string method : {"automatic", "division", "edges", "scan"}) {
    const Run some = ask(" --json --method " + method);
    EXPECT_EQ(some.code, 0) << some.err;
    const json region = json::parse(some.out)["region"];
    EXPECT_EQ(region["kind"], "polygon");
    EXPECT_EQ(region["corners"].size(), 4u);
    EXPECT_EQ(run("verify " + proof).code, 0);
  }
  EXPECT_NE(ask(" --svg " + in_folder("convex.svg")).out.find("edge 1 of 1 (line 1)"), std::string::npos)
      << ask("").out;
  write_text(file, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((4 4, 7 4, 7 5, 4 4))\n");
  EXPECT_NE(ask("").out.find("one point"), std::string::npos);
  EXPECT_EQ(run("verify " + proof).code, 0);
  write_text(file, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((4 5, 7 4, 7 5, 4 5))\n");
  const Run empty = ask(" --svg " + in_folder("none.svg"));
  EXPECT_EQ(empty.code, 1);
  EXPECT_NE(empty.out.find("nothing in common"), std::string::npos);
  EXPECT_EQ(run("verify " + proof).code, 0);
  write_text(file, "POLYGON ((0 0, 0 4, 4 4, 4 0, 0 0))\n");
  EXPECT_NE(ask("").err.find("clockwise"), std::string::npos) << ask("").err;
  EXPECT_EQ(ask(" --mend").code, 0);
  EXPECT_EQ(ask(" --maximize 1,0").code, 2);
  EXPECT_EQ(run("region --mend " + cases + "/half-planes/co2.csv").code, 2);
  write_text(file, "POLYGON ((0 0, 9 0, 9 9, 0 0), (5 1, 6 1, 6 2, 5 1))\n");
  EXPECT_NE(ask("").err.find("has holes"), std::string::npos);
}

TEST_F(Program, Kernels) {
  const std::string file = in_folder("two.wkt"), proof = in_folder("proof.json");
  write_text(file,
             "POLYGON ((0 0, 10 0, 10 10, 5 4, 0 10, 0 0))\n"
             "POLYGON ((0 0, 10 0, 10 10, 9 1, 1 1, 0 10, 0 0))\n");
  const Run both = run("kernel " + file + " --svg " + in_folder("two.svg"));
  EXPECT_EQ(both.code, 1) << both.err;
  EXPECT_NE(both.out.find("1 of 2 polygons have a kernel"), std::string::npos) << both.out;
  for (const std::string method : {"automatic", "half-planes", "lee-preparata", "scan"}) {
    for (const std::string feature : {"1", "2"}) {
      const Run one =
          run("kernel " + file + " --feature " + feature + " --method " + method + " --certificate " + proof);
      EXPECT_EQ(one.code, feature == "1" ? 0 : 1) << one.err;
      EXPECT_EQ(run("verify " + proof).code, 0);
    }
  }
  EXPECT_EQ(run("kernel " + file + " --feature 3").code, 2);
  write_text(file, "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n");
  EXPECT_EQ(run("kernel " + file).code, 2);
}

}  // namespace
