// Calls, messages and files of all verbs.
#include <tests/support/program.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

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
  EXPECT_EQ(run("help").out, run("--help").out);
  EXPECT_EQ(run("help pair").out, run("pair --help").out);
  expect_bad("help frob", "there is no verb 'frob'");
  expect_bad("help pair scene", "name one verb");
}

TEST_F(Program, WhatWasMeant) {
  expect_bad("par a b", "there is no verb 'par'; did you mean pair?");
  expect_bad("help polgons", "did you mean polygons?");
  expect_bad("pair a b --jsno", "there is no option '--jsno'; did you mean --json?; see sunder pair --help");
  EXPECT_EQ(run("frob").err.find("did you mean"), std::string::npos);
  expect_bad("helpp", "there is no verb 'helpp'; did you mean help?");
  expect_bad("--vers", "there is no option '--vers'; did you mean --version?");
  expect_bad("segments a --methd=scan", "there is no option '--methd'; did you mean --method?");
  expect_bad("segments -dash.csv", "there is no option '-dash.csv'; a file of that name is './-dash.csv'");
}

TEST_F(Program, WhereWordsStand) {
  expect_bad("--json pair a b", "the verb comes first, before '--json'");
  expect_bad("-- pair a b", "the verb comes first, before '--'");
  expect_bad("--completion", "--completion: name the shell: bash, zsh, or fish");
  expect_bad("--completion bash --json", "--completion: nothing is expected at '--json'");
  expect_bad("--completion zsh segments a", "--completion: nothing is expected at 'segments'");
  expect_bad("--man pair", "--man: nothing is expected at 'pair'");
  expect_bad("--version pair", "--version: nothing is expected at 'pair'");
  EXPECT_EQ(run("--help pair").out, run("help pair").out);
  EXPECT_EQ(run("--completion=fish").out, run("--completion fish").out);
  EXPECT_EQ(json::parse(run("--json pair a b").out)["verb"], nullptr);
}

TEST_F(Program, ValuesOfOptions) {
  expect_bad("segments a --svg b --svg c", "segments: --svg is given twice; leave one out; see sunder segments --help");
  expect_bad("segments a --name", "segments: --name has no value; give FIELD");
  expect_bad("hull a -o", "hull: -o has no value; give FILE");
  expect_bad("pair a b --json=true", "pair: --json takes no value");
  expect_bad("segments a b", "segments: one FILE is expected, and more are named");
  for (const char* number : {"-1", "99999999999999999999", "many", "1e6"}) {
    expect_bad("circles " + cases + "/circles/moon.csv --svg " + in_folder("m.svg") + " --svg-limit " + number,
               "--svg-limit: '" + std::string(number) + "' is no number of things");
  }
  const std::string titled = "circles none.csv --svg " + in_folder("m.svg") + " --title --json";
  EXPECT_EQ(run(titled).out, "");
  EXPECT_EQ(run(titled).code, 2);
  const std::string is_long(300, 'x');
  for (const std::string& call :
       {"segments a --" + is_long, "segments " + cube + " --method " + is_long, "pair a b " + is_long, is_long}) {
    EXPECT_LT(run(call).err.size(), 250u) << call;
  }
  expect_bad("scene " + is_long, "cannot be opened");
  expect_bad("scene " + cube + " --allow " + is_long, "is no file");
}

TEST_F(Program, QuietSaysNothing) {
  const std::string apart = "pair " + cube + " " + cube + " --pose-b 5,0,0";
  for (const auto& [call, code] : {std::pair(apart, 0), std::pair("pair " + cube + " " + cube, 1)}) {
    EXPECT_NE(run(call).out, "");
    const Run r = run(call + " --quiet");
    EXPECT_EQ(r.code, code) << call;
    EXPECT_EQ(r.out + r.err, "") << call;
  }
  expect_bad("pair " + cube + " none.obj --quiet", "none.obj");
  expect_bad(apart + " --quiet --json", "--json and --quiet: a report is not quiet");
}

TEST_F(Program, ErrorsAreInTheReport) {
  const std::string none = in_folder("none.obj");
  for (const auto& [call, verb, kind, place] :
       {std::array<std::string, 4>{"pair " + cube + " " + none + " --json", "pair", "bad-file", none},
        std::array<std::string, 4>{"pair " + cube + " --json", "pair", "bad-call", ""},
        std::array<std::string, 4>{"segments --json --allow frob " + cube, "segments", "bad-call", "--allow"}}) {
    const Run r = run(call);
    EXPECT_EQ(r.code, 2) << call;
    const json report = json::parse(r.out);
    EXPECT_EQ(report["verb"], verb);
    EXPECT_EQ(report["answer"], nullptr);
    EXPECT_EQ(report["error"]["kind"], kind);
    EXPECT_EQ(report["error"]["place"], place);
    EXPECT_EQ("sunder: " + std::string(report["error"]["text"]) + "\n", r.err);
  }
}

// The content tells the format; the output stands alone, also where standard output is a file.
TEST_F(Program, StandardInputAndOutput) {
  const std::string wires = cases + "/segments/wires.csv", paths = cases + "/segments/paths.wkt";
  EXPECT_EQ(run("segments - < " + wires).out.substr(1), run("segments " + wires).out.substr(wires.size()));
  EXPECT_EQ(run("segments - < " + paths).code, run("segments " + paths).code);
  EXPECT_EQ(run("hull - --json < " + cube).code, 0);
  const std::string ask = "segments " + wires + " --certificate ", proof = in_folder("proof.json");
  run(ask + proof);
  const Run r = run(ask + "-");
  EXPECT_EQ(r.out, read_text(proof));
  EXPECT_EQ(r.code, 1);
  const std::string redirected = in_folder("redirected.json");
  run(ask + "- > " + redirected);
  EXPECT_EQ(read_text(redirected), read_text(proof));
  EXPECT_EQ(run("verify - < " + proof).code, 0);
  expect_bad(ask + "- --svg -", "--svg: standard output is taken by --certificate");
  expect_bad(ask + "- --json", "--certificate: standard output is taken by --json");
}

// Also where there is no ending to tell the format.
TEST_F(Program, KindsOfStandardInput) {
  const std::string plate = cases + "/planar-pair/plate.wkt", paths = cases + "/planar-pair/paths.csv",
                    wheel = cases + "/planar-pair/wheel.wkt";
  for (const std::string& file : {plate, paths}) {
    const std::string option = file == paths ? " --feature-a beam" : "";
    EXPECT_EQ(run("pair - " + wheel + option + " --json < " + file).code,
              run("pair " + file + " " + wheel + option).code);
  }
  EXPECT_EQ(run("pair " + plate + " - < " + wheel).code, 0);
  EXPECT_EQ(run("pair - " + tetrahedron + " < " + cube).code, 1);
  const std::string pairs = in_folder("pairs");
  write_text(pairs, "cube tetrahedron\n");
  EXPECT_EQ(run("scene " + cube + " " + tetrahedron + " --allow - < " + pairs).code, 0);
  for (const std::string name :
       {"segments/wires.csv", "segments/pond.geojson", "planar-pair/plate.wkt", "planar-pair/paths.csv",
        "circles/moon.csv", "mesh/cube.obj", "mesh/cube_binary.stl", "mesh/arm.urdf", "mesh/tetrahedron.ply"}) {
    const std::string file = cases + "/" + name;
    const Run named = run("info " + file), read = run("info - < " + file);
    EXPECT_EQ(named.code, 0) << named.err;
    EXPECT_EQ(read.out, "-" + named.out.substr(file.size())) << read.err;
  }
}

// As bash asks for it: the words of the call, the last one to be completed.
TEST_F(Program, CompletionOfBash) {
  const std::string script = in_folder("sunder.bash");
  write_text(script, run("--completion bash").out);
  const auto completed = [&](const std::string& words, int number) {
    const std::string ask = in_folder("ask.bash");
    write_text(ask, "source " + script + "\ncd " + folder_.string() + "\nCOMP_WORDS=(" + words +
                        ")\nCOMP_CWORD=" + std::to_string(number) + "\n_sunder\necho \"${COMPREPLY[*]}\"\n");
    const std::string out = in_folder("out.txt");
    EXPECT_EQ(std::system(("bash " + ask + " > " + out).c_str()), 0);
    return read_text(out);
  };
  fs::create_directory(folder_ / "circles");
  EXPECT_EQ(completed("sunder circ", 1), "circles\n");
  EXPECT_EQ(completed("sunder --completion ba", 2), "bash\n");
  EXPECT_EQ(completed("sunder --completion bash ''", 3), "\n");
  EXPECT_EQ(completed("sunder segments --method gr", 3), "grid\n");
  EXPECT_EQ(completed("sunder pair --method fi", 3), "fibonacci\n");
  EXPECT_EQ(completed("sunder segments --name sund", 3), "\n");
  EXPECT_EQ(completed("sunder hull --certificate sund", 3), "sunder.bash\n");
  EXPECT_EQ(completed("sunder hull -o", 2), "-o\n");
  EXPECT_EQ(run("--completion bash").out.find("complete -o"), std::string::npos);
  EXPECT_EQ(completed("sunder p", 1), "pair polygons\n");
  EXPECT_EQ(completed("sunder help ker", 2), "kernel\n");
  EXPECT_EQ(completed("sunder verify --ag", 2), "--against\n");
  EXPECT_EQ(completed("sunder verify sund", 2), "sunder.bash\n");
  EXPECT_NE(run("--completion fish").out.find("-l against -d "), std::string::npos);
  for (const char* part :
       {"'*--joints[", "'*--against[", "'-o[", "'--version:", "'--man:", "'--help:", "(automatic grid sweep "}) {
    EXPECT_NE(run("--completion zsh").out.find(part), std::string::npos) << part;
  }
  for (const char* part :
       {"-l version", "-l man", "-l completion", "-s h -l help", "-s o -l out", "-a 'bash zsh fish'"}) {
    EXPECT_NE(run("--completion fish").out.find(part), std::string::npos) << part;
  }
  expect_bad("--completion tcsh", "there is no completion for 'tcsh'; there are bash, zsh, fish");
}

TEST_F(Program, TheManualPage) {
  const Run r = run("--man");
  EXPECT_TRUE(r.out.starts_with(".TH SUNDER 1 "));
  for (const char* part : {".SS \"sunder pair\"", "\\fB\\-\\-certificate\\fR \\fIFILE\\fR", ".SH \"EXIT STATUS\""}) {
    EXPECT_NE(r.out.find(part), std::string::npos) << part;
  }
  std::istringstream lines(r.out);
  for (std::string line; std::getline(lines, line);) {
    const bool is_known = line.empty() || line[0] != '.' || line.starts_with(".SS ") || line.starts_with(".SH ") ||
                          line == ".PP" || line == ".TP" || line == ".br" || line.starts_with(".TH ");
    EXPECT_TRUE(is_known) << line;
  }
}

// The page has a section for each verb, which names each of its options.
TEST_F(Program, TheGuideNamesAllOptions) {
  const std::string page = read_text(source_folder() + "/docs/guide/program.md");
  for (const char* verb : {"pair", "scene", "segments", "simple", "circles", "boxes", "polygons", "region", "kernel",
                           "hull", "section", "info", "verify"}) {
    EXPECT_NE(page.find(std::string("[") + verb + "](#sunder-" + verb + ")"), std::string::npos) << verb;
    const std::size_t begin = page.find(std::string("\n## sunder ") + verb + "\n");
    ASSERT_NE(begin, std::string::npos) << verb;
    const std::string section = page.substr(begin, page.find("\n## ", begin + 1) - begin);
    EXPECT_NE(section.find(std::string("\n    sunder ") + verb + " "), std::string::npos) << verb;
    std::istringstream lines(run(std::string("help ") + verb).out);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t name = line.starts_with("  -") ? line.find("--") : std::string::npos;
      if (name == std::string::npos) continue;
      const std::string option = line.substr(name, line.find_first_of(" ,", name) - name);
      const bool is_of_all = option == "--help" || option == "--quiet";
      EXPECT_TRUE(is_of_all || option == "--out" || section.find(option) != std::string::npos) << verb << " " << option;
    }
  }
}

// Each verb says what its codes 0 and 1 are.
TEST_F(Program, ExitCodesOfVerbs) {
  for (const auto& [verb, codes] : {std::pair("pair", "0 apart, or with --clearance that far apart; 1 meet, or not"),
                                    {"scene", "0 none meet; 1 some meet"},
                                    {"segments", "0 none meet; 1 some meet"},
                                    {"simple", "0 all are valid; 1 some are not"},
                                    {"circles", "0 none meet; 1 some meet"},
                                    {"boxes", "0 none meet; 1 some meet"},
                                    {"polygons", "0 none meet; 1 some meet"},
                                    {"region", "0 something is common to all; 1 nothing is"},
                                    {"kernel", "0 each polygon has a kernel; 1 some have none"},
                                    {"hull", "0; of half-spaces 1 if they are empty, or unbounded"},
                                    {"section", "0 no plane meets the body; 1 some do"},
                                    {"info", "0; 2 bad"},
                                    {"verify", "0 all accepted; 1 some refused"}}) {
    const std::string line = std::string("Exit code: ") + codes;
    EXPECT_NE(run(std::string("help ") + verb).out.find(line), std::string::npos) << verb;
    EXPECT_NE(read_text(source_folder() + "/docs/guide/program.md").find(std::string("| `") + verb + "` |"),
              std::string::npos)
        << verb;
  }
  std::istringstream lines(run("--help").out.substr(run("--help").out.find("Subcommands:")));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ") || line[2] == ' ') continue;
    const std::string verb = line.substr(2, line.find(' ', 2) - 2);
    EXPECT_NE(run("help " + verb).out.find("Exit code: 0"), std::string::npos) << verb;
  }
  EXPECT_NE(run("--man").out.find("Exit code: 0 something is common to all"), std::string::npos);
}

TEST_F(Program, BadCalls) {
  expect_bad("",
             "no verb is given; verbs are pair, scene, segments, simple, circles, boxes, polygons, region, kernel, "
             "hull, section, info, verify");
  expect_bad("frob", "there is no verb 'frob'");
  expect_bad("--frob", "there is no option '--frob'");
  expect_bad("pair", "A is required");
  expect_bad("pair " + cube, "B is required");
  expect_bad("pair a b c", "nothing is expected at 'c'");
  expect_bad("pair a b --frob", "there is no option '--frob'; see sunder pair --help");
  expect_bad("pair a b --method", "--method");
  expect_bad("pair " + cube + " " + cube + " --method frob",
             "there is no method 'frob'; choose one of automatic, gjk, hierarchy, polar, scan");
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
