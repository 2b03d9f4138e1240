// sunder pair on polytopes of any dimension: CSV and NPY, several hyperplanes, and what is refused.
#include <tests/support/program.h>
#include <tests/support/scale.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

const std::string folder = cases + "/polytopes/";
const std::string cross = folder + "cross.csv", box = folder + "box.csv", box_npy = folder + "box.npy";

class Polytopes : public Program {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    write_text(in_folder(name), text);
    return in_folder(name);
  }
};

// Points of a sphere of d dimensions.
std::string sphere(std::size_t d, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::string text;
  for (int k = 0; k < count; ++k) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = static_cast<double>(random()) / 0x1p31 - 1;
      square += x * x;
    }
    for (std::size_t c = 0; c < d; ++c) text += (c == 0 ? "" : ",") + std::to_string(p[c] / std::sqrt(square));
    text += '\n';
  }
  return text;
}

TEST_F(Polytopes, NpyIsAsCsv) {
  const std::string at = " --pose-b 2,0,0,0 ";
  const json csv = report("pair " + cross + " " + box + at, 1);
  const json npy = report("pair " + cross + " " + box_npy + at + "--half-spaces-b", 1);
  EXPECT_EQ(csv["evidence"], npy["evidence"]);
  EXPECT_EQ(npy["objects"][1]["format"], "NPY");
  EXPECT_EQ(npy["objects"][1]["shape"], "half-spaces");
  const json points = report("pair " + box_npy + " " + box_npy, 1);  // of five dimensions, points
  EXPECT_EQ(points["objects"][0]["dimension"], 5);
  EXPECT_EQ(points["objects"][0]["shape"], "points");
  const std::string unnamed = file("h.csv", "1,0,1\n-1,0,1\n");
  EXPECT_EQ(report("pair " + unnamed + " " + unnamed + " --polytopes --half-spaces-a --half-spaces-b",
                   1)["objects"][0]["dimension"],
            2);
  expect_bad("pair " + cross + " " + box + " --half-spaces-a", "cross.csv:1: names points, and half-spaces were asked");
  expect_bad("pair " + cube + " " + cube + " --half-spaces-a", "--half-spaces-a");
}

TEST_F(Polytopes, SeveralHyperplanes) {
  for (const std::size_t d : {2u, 3u, 4u}) {
    const std::string a = file("a.csv", sphere(d, 200, 1)), b = file("b.csv", sphere(d, 200, 2));
    std::string away = "2.2";
    for (std::size_t c = 1; c < d; ++c) away += ",0";
    const std::string proof = in_folder("p.json");
    const std::string call = "pair " + a + " " + b + " --polytopes --method tree --hyperplanes --pose-b ";
    const json apart = report(call + away + " --certificate " + proof, 0);
    const auto planes = apart["planes"];
    EXPECT_LE(planes["a"], static_cast<double>(d) * std::log2(200) + 1);
    EXPECT_LE(planes["b"], static_cast<double>(d) * std::log2(200) + 1);
    EXPECT_GE(planes["a"], d);
    EXPECT_LE(planes["multiplied"], d + 1);
    EXPECT_EQ(json::parse(read_text(proof))["statements"][0]["verdict"], "apart_by_hyperplanes");
    EXPECT_EQ(run("verify " + proof).code, 0);
    EXPECT_TRUE(python_accepts(proof));
    away[0] = '1';
    const json meet = report(call + away + " --certificate " + proof, 1);
    EXPECT_FALSE(meet.contains("planes"));
    EXPECT_EQ(run("verify " + proof).code, 0);
  }
  expect_bad("pair " + cross + " " + box + " --hyperplanes", "--hyperplanes: is of --method tree");
  expect_bad("pair " + cube + " " + cube + " --hyperplanes", "--hyperplanes");
}

TEST_F(Polytopes, SayWhatIsWrong) {
  const std::string call = "pair " + cross + " ";
  const auto refused = [&](const std::string& text, const std::string& part) {
    expect_bad(call + file("f.csv", text) + " --polytopes", part);
  };
  refused("1\n", "f.csv:1: is a point of dimension 1; give points of dimension 2 to 6");
  refused("1,2,3,4,5,6,7\n", "f.csv:1: is a point of dimension 7; give points of dimension 2 to 6");
  refused("x1,x2,x3,x4,x5,x6,x7\n1,2,3,4,5,6,7\n", "f.csv:1: has names that are neither");
  refused("a1,b\n1,2\n", "f.csv:1: has names that are neither");
  refused("1,2,3,4\n1,2,3\n", "f.csv:2: has 3 numbers, others have 4; give rows of one dimension");
  refused("a1,a2,a3,a4,b\n1,2,3,4\n", "f.csv:2: has 4 numbers, others have 5; give rows of one dimension");
  refused("1,2,3,4\n1,2,nan,4\n", "f.csv:2: 'nan' is NaN");
  refused("a1,a2,a3,a4,b\n1,2,3,4,inf\n", "f.csv:2: 'inf' is infinite");
  refused("1,2,3,4\n1,x,3,4\n", "f.csv:2: 'x' is not a number");
  refused("1,2,3\n", "A is of dimension 4, B of 3; give two of one dimension");
  refused("x1,x2,x3,x4\n", "f.csv: has no points");
  refused("", "f.csv: the file is empty");
  expect_bad(call + box + " --pose-b 1,2,3", "--pose-b: a pose of 3 numbers; of dimension 4 give 4");
  expect_bad(call + box + " --pose-b 1,2,nan,4", "--pose-b");
  expect_bad(call + box + " --pose-b 0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0", "--pose-b");
  expect_bad(call + box + " --method drums", "--method");
  for (const char* option : {"--classify", "--distance", "--clearance 1", "--hull", "--mend"}) {
    expect_bad(call + box + " " + option, "is not for polytopes");
  }
  const std::string npy = read_text(box_npy);
  const auto wrong = [&](const std::string& bytes, const std::string& part) {
    write_text(in_folder("f.npy"), bytes);
    expect_bad(call + in_folder("f.npy") + " --half-spaces-b", part);
  };
  wrong(npy.substr(0, npy.size() - 1), "319 bytes of numbers, but the header says 8 x 5 of 8");
  std::string bytes = npy;
  wrong(bytes.replace(bytes.size() - 8, 8, std::string("\0\0\0\0\0\0\xf8\x7f", 8)), "row 7: column 4 is not finite");
  bytes = npy;
  wrong(bytes.replace(bytes.find("(8, 5)"), 6, "(4,10)"), "a row is of 10 numbers, and a half-space of 3 to 7");
  bytes = npy;
  wrong(bytes.replace(bytes.find("<f8"), 3, "<c8"), "its numbers are of kind");
  wrong("no array", "f.npy");
}

TEST_F(Polytopes, ATreeThatIsTooLargeIsRefusedByAnEstimate) {
  if (scaled_count(100, 1) < 5) GTEST_SKIP() << "takes a while; the unit test of trees refuses smaller ones, too";
  const std::string a = file("a.csv", sphere(6, 300, 1));
  expect_bad("pair " + a + " " + a + " --polytopes --method tree", "the tree of 300 rows of dimension 6 takes about ");
}

}  // namespace
}  // namespace sunder::tests
