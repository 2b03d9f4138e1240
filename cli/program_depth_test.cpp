// sunder pair --depth.
#include <tests/support/program.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace sunder::tests {
namespace {

class Depth : public Program {
 protected:
  static std::string case_file(const std::string& name) { return cases + "/" + name; }
};

TEST_F(Depth, IsToldAndProved) {
  const std::string pair = "pair '" + case_file("mesh/cube.obj") + "' '" + case_file("mesh/cube.obj") + "' --depth",
                    proof = in_folder("depth.json"), proved = " --certificate '" + proof + "'";
  const json r = report(pair + " --pose-b 0.75,0.25,0" + proved, 1);
  EXPECT_EQ(r["depth"]["low"], 0.25);
  EXPECT_EQ(r["depth"]["high"], 0.25);
  EXPECT_EQ(r["depth"]["square"], "1/16");
  EXPECT_EQ(r["depth"]["direction_about"], json::parse("[-1.0, 0.0, 0.0]"));
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
  // Touching and apart.
  const json touching = report(pair + " --pose-b 1,0,0" + proved, 1);
  EXPECT_EQ(touching["depth"]["high"], 0.0);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_FALSE(report(pair + " --pose-b 2,0,0", 0).contains("depth"));

  const std::string round = "pair '" + case_file("mesh/cube.obj") + "' '" + case_file("space/ball.json") + "' --depth";
  const json ball = report(round + " --pose-b -0.5,0.125,0" + proved, 1);  // its centre is 1 beyond the face
  EXPECT_EQ(ball["depth"]["low"], 0.5);
  EXPECT_EQ(ball["depth"]["high"], 0.5);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
  const std::string cone =
      "pair '" + case_file("space/ellipsoid.json") + "' '" + case_file("space/cone.json") + "' --depth";
  const json curved = report(cone + proved, 1);
  EXPECT_GT(curved["depth"]["low"], 0.0);
  EXPECT_GE(curved["depth"]["high"], curved["depth"]["low"]);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);

  // Beyond the range of doubles: told as that, and null.
  const std::string vast = in_folder("vast.obj");
  std::string vertices;
  for (const char* x : {"-1.7e308 ", "1.7e308 "}) {
    for (const char* y : {"-1.7e308 ", "1.7e308 "}) {
      for (const char* z : {"-1.7e308\n", "1.7e308\n"}) vertices.append("v ").append(x).append(y).append(z);
    }
  }
  write_text(vast, vertices);
  const std::string beyond = "pair '" + vast + "' '" + vast + "' --depth";
  EXPECT_TRUE(report(beyond, 1)["depth"]["high"].is_null());
  EXPECT_NE(run(beyond).out.find("at least 1.79769313486e+308, A to be moved"), std::string::npos);

  for (const char* b : {"planar-pair/plate.wkt", "space/line.json"}) {
    const std::string a = std::string(b) == "space/line.json" ? "mesh/cube.obj" : b;
    expect_bad("pair '" + case_file(a) + "' '" + case_file(b) + "' --depth", "--depth");
  }
  expect_bad(pair + " --to-b 3,0,0", "--depth");
}

}  // namespace
}  // namespace sunder::tests
