// Calls, messages and files of all verbs.
#include <tests/support/program.h>

namespace sunder::tests {

namespace {

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

}  // namespace

}  // namespace sunder::tests
