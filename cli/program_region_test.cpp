// The verbs region and kernel.
#include <tests/support/program.h>

namespace sunder::tests {

namespace {

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

TEST_F(Program, RegionsOfHalfSpaces) {
  const std::string box = cases + "/polytopes/box.csv", proof = in_folder("proof.json"), file = in_folder("rows.csv");
  for (const std::string method : {"automatic", "seidel", "scan"}) {
    const Run best = run("region " + box + " --maximize 1,2,3,4 --json --method " + method + " --certificate " + proof);
    EXPECT_EQ(best.code, 0) << best.err;
    EXPECT_EQ(json::parse(best.out)["best"]["outcome"], "one");
    EXPECT_EQ(json::parse(best.out)["best"]["point"], json({1, 1, 1, 1}));
    EXPECT_EQ(run("verify " + proof + " --against " + box).code, 0);
  }
  const Run part = run("region " + box + " --json --certificate " + proof);
  EXPECT_EQ(json::parse(part.out)["region"]["kind"], "bounded");
  EXPECT_EQ(json::parse(part.out)["region"]["extents"][3], json({-1, 1}));
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_EQ(run("region " + cases + "/polytopes/empty.csv").code, 1);
  EXPECT_EQ(run("region " + cases + "/polytopes/empty.csv --maximize 1,1,1,1").code, 1);
  const auto expect_refused = [&](const std::string& rows, const std::string& options, const std::string& what) {
    write_text(file, rows);
    const Run bad = run("region " + file + options);
    EXPECT_EQ(bad.code, 2);
    EXPECT_NE(bad.err.find(what), std::string::npos) << bad.err;
  };
  expect_refused("a1,a2,b\n1,nan,3\n", "", "rows.csv:2: 'nan' is NaN");
  expect_refused("a1,a2,b\n1,2,3\n1,2\n", "", "rows.csv:3: has 2 numbers");
  expect_refused("a1,b\n1,2\n", " --of half-spaces", "for a d from 2 to 6");
  expect_refused("a1,a2,a3,a4,a5,a6,a7,b\n", " --of half-spaces", "for a d from 2 to 6");
  expect_refused("x1,x2\n1,2\n", "", "points; give half-spaces");
  expect_refused("a1,a2,b\n1,2,3\n", " --maximize 1,2,3", "3 numbers; give 2");
  expect_refused("a1,a2,b\n1,2,3\n", " --method scan", "for --maximize");
  expect_refused("a1,a2,b\n1,2,3\n", " --svg x.svg", "for the plane");
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
  EXPECT_NE(run("kernel " + cases + "/planar-pair/plate.wkt").out.find("1 of 1 polygon has a kernel"),
            std::string::npos);
  for (const std::string method : {"automatic", "half-planes", "lee-preparata", "scan"}) {
    for (const std::string feature : {"1", "2"}) {
      const Run one =
          run("kernel " + file + " --feature " + feature + " --method " + method + " --certificate " + proof);
      EXPECT_EQ(one.code, feature == "1" ? 0 : 1) << one.err;
      EXPECT_EQ(run("verify " + proof).code, 0);
    }
  }
  EXPECT_EQ(run("kernel " + file + " --feature 3").code, 2);
  write_text(file, "POLYGON ((0 0, 4 0, 4 0, 0 4, 0 0))\nPOLYGON ((0 0, 4 0, 0 4, 0 0))\n");  // valid, both
  expect_bad("kernel " + file,
             "two.wkt:1: feature 1: is not strictly simple: ring 0: vertices 1 and 2 are the same, "
             "(4, 0); mend it (sunder simple --strict tells more; --mend does what is safe)");
  EXPECT_NE(run("kernel --skip-invalid " + file).out.find("said of these only: skipped: 1 not strictly simple feature"),
            std::string::npos);
  EXPECT_EQ(run("kernel --mend " + file).code, 0);
  EXPECT_EQ(run("kernel --mend --feature 1 " + file + " --certificate " + proof).code, 0);
  EXPECT_EQ(run("verify " + proof + " --against " + file).code, 0);
  EXPECT_EQ(json::parse(read_text(proof))["left_out"], json{"mended: 1 feature"});
  write_text(file, "POINT (1 1)\nPOLYGON ((0 0, 4 0, 0 4, 0 0))\nPOLYGON ((0 0, 4 0, 4 4, 1 1, 0 4, 0 0))\n");
  EXPECT_EQ(run("region --of polygons --leave-out --skip-invalid " + file + " --certificate " + proof).code, 0);
  EXPECT_EQ(run("verify " + proof + " --against " + file).code, 0);
  EXPECT_EQ(json::parse(read_text(proof))["left_out"].size(), 2u);
  write_text(file, "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n");
  EXPECT_EQ(run("kernel " + file).code, 2);
}

}  // namespace

}  // namespace sunder::tests
