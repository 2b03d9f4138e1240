// sunder hull on half-spaces: the vertices of what they have in common.
#include <tests/support/program.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder::tests {
namespace {

const std::string folder = cases + "/polytopes/";

class Vertices : public Program {
 protected:
  std::string file(const std::string& text) const {
    write_text(in_folder("f.csv"), text);
    return in_folder("f.csv");
  }

  // The report of a call whose proof both checkers accept, where the rest of the call is the same.
  json proved(const std::string& call, int code, const std::string& statement) const {
    const std::string proof = in_folder("proof.json");
    json found = report("hull " + call + " --certificate " + proof, code);
    const json said = json::parse(read_text(proof))["statements"];
    EXPECT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0]["question"].get<std::string>() + " " + said[0]["verdict"].get<std::string>(), statement);
    EXPECT_EQ(run("verify " + proof).code, 0);
    EXPECT_TRUE(python_accepts(proof));
    return found;
  }
};

TEST_F(Vertices, AreExactAndProved) {
  const std::string all = "half_spaces_vertices vertices";
  const json apex = proved(folder + "apex.csv", 0, all);
  EXPECT_EQ(apex["answer"], "body");
  EXPECT_EQ(apex["objects"][0]["shape"], "half-spaces");
  EXPECT_EQ(apex["region"]["bounding"], json({0, 1, 2, 3, 4}));
  std::set<std::string> points;
  for (const json& vertex : apex["region"]["vertices"]) {
    points.insert(vertex["point"].dump());
    EXPECT_EQ(vertex["half_spaces"].size(), vertex["point"][2] == "1" ? 4u : 3u);
  }
  EXPECT_EQ(points, (std::set<std::string>{R"(["0","0","1"])", R"(["1/3","1/3","0"])", R"(["1/3","-1/3","0"])",
                                           R"(["-1/3","1/3","0"])", R"(["-1/3","-1/3","0"])"}));
  const json facet = proved(folder + "facet.csv", 0, all);
  EXPECT_EQ(facet["answer"], "polygon");
  EXPECT_EQ(facet["region"]["vertices"].size(), 3u);
  const json segment = proved(folder + "interval.csv", 0, all);
  EXPECT_EQ(segment["answer"], "segment");
  EXPECT_EQ(segment["region"]["vertices"][1]["point"], json({"0", "1", "0"}));
  EXPECT_EQ(segment["region"]["vertices"][0]["point"], json({"3/7", "4/7", "1/7"}));
  const json point = proved(folder + "corner.csv", 0, all);
  EXPECT_EQ(point["answer"], "point");
  EXPECT_EQ(point["region"]["dimension"], 0);
  EXPECT_EQ(point["region"]["vertices"][0]["point"], json({"1", "2"}));
  const json box = proved(folder + "box.csv", 0, all);
  EXPECT_EQ(box["answer"], "polytope");
  EXPECT_EQ(box["region"]["vertices"].size(), 16u);
  const json npy = proved(folder + "box.npy --half-spaces", 0, all);
  EXPECT_EQ(npy["region"], box["region"]);
  EXPECT_EQ(npy["objects"][0]["format"], "NPY");
  EXPECT_EQ(proved(file("1,0,1\n-1,0,1\n0,1,1\n0,-1,1\n") + " --half-spaces", 0, all)["region"]["vertices"].size(), 4u);
}

TEST_F(Vertices, OfWhatHasNoneItIsSaid) {
  const json empty = proved(folder + "empty.csv", 1, "half_spaces empty");
  EXPECT_EQ(empty["answer"], "empty");
  EXPECT_FALSE(empty["region"].contains("dimension"));
  EXPECT_EQ(empty["region"]["vertices"], json::array());
  const json wedge = proved(folder + "wedge.csv", 1, "half_spaces unbounded");
  EXPECT_EQ(wedge["answer"], "unbounded");
  EXPECT_EQ(wedge["region"]["dimension"], 3);
  for (const auto& [name, word] : {std::pair("empty.csv", "empty: "), {"wedge.csv", "unbounded, of dimension 3"}}) {
    const Run said = run("hull " + folder + name + " -o " + in_folder("v.csv"));
    EXPECT_EQ(said.code, 1);
    EXPECT_EQ(lines_of(said.out).size(), 1u) << said.out;
    EXPECT_NE(said.out.find(word), std::string::npos) << said.out;
    EXPECT_FALSE(fs::exists(in_folder("v.csv")));
  }
}

TEST_F(Vertices, AreWritten) {
  const std::string out = in_folder("v.csv");
  const Run said = run("hull " + folder + "apex.csv -o " + out);
  EXPECT_EQ(said.code, 0) << said.err;
  const std::vector<std::string> lines = lines_of(read_text(out));
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0], "x1,x2,x3,half_spaces");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "0,0,1,1 2 3 4"), 1);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "1/3,1/3,0,0 1 3"), 1);
}

TEST_F(Vertices, BeyondAllDoublesAreSaidToBeSo) {
  const std::string given = file("a1,a2,b\n5e-324,0,1e308\n-5e-324,0,1e308\n0,3,1\n0,-3,1\n");
  const json corner = proved(given, 0, "half_spaces_vertices vertices")["region"]["vertices"][0];
  EXPECT_EQ(corner["point_about"], json({std::numeric_limits<double>::max(), 1.0 / 3}));
  EXPECT_GT(corner["point"][0].get<std::string>().size(), 600u);
  const std::string said = run("hull " + given).out;
  EXPECT_NE(said.find("about (above 1.797693134e+308, 0.3333333333)"), std::string::npos) << said;
  EXPECT_NE(said.find("about (below -1.797693134e+308, 0.3333333333)"), std::string::npos) << said;
}

TEST_F(Vertices, SayWhatIsWrong) {
  const auto refused = [&](const std::string& text, const std::string& part, const std::string& more = "") {
    expect_bad("hull " + file(text) + more, part);
  };
  refused("a1,a2,b\n1,nan,3\n", "f.csv:2: 'nan' is NaN");
  refused("a1,a2,b\n1,2,3\n1,2\n", "f.csv:3: has 2 numbers, others have 3; give rows of one dimension");
  refused("1,2\n", "f.csv:1: is of 2 numbers, and a half-space of 3 to 7", " --half-spaces");
  refused("1,2,3,4,5,6,7,8\n", "f.csv:1: is of 8 numbers, and a half-space of 3 to 7", " --half-spaces");
  refused("a1,a2,a3,a4,a5,a6,a7,b\n", "f.csv:1: has names that are neither", " --half-spaces");
  refused("x1,x2\n1,2\n", "f.csv:1: names points, and half-spaces were asked for", " --half-spaces");
  expect_bad("hull " + folder + "apex.csv --leave-out", "--leave-out: is not for polytopes");
  expect_bad("hull " + folder + "apex.csv -o x.obj", "--out");
  expect_bad("hull " + folder + "simplex.csv --half-spaces -o x.obj", "--out");
}

}  // namespace
}  // namespace sunder::tests
