// Bodies that move: the verb pair with --to-a and --to-b, and the verb scene with --between.
#include <tests/support/program.h>

#include <sstream>
#include <string>

namespace sunder::tests {

namespace {

class Motion : public Program {
 protected:
  const std::string cubes = "pair " + cube + " " + cube + " ";
};

TEST_F(Motion, MeetsBetweenTheEnds) {
  const std::string call = cubes + "--pose-b -3,0.5,0.25 --to-b 5,0.5,0.25 ";
  EXPECT_EQ(run(cubes + "--pose-b -3,0.5,0.25").code, 0);
  EXPECT_EQ(run(cubes + "--pose-b 5,0.5,0.25").code, 0);
  const json told = report(call, 1);
  EXPECT_EQ(told["answer"], "meet");
  EXPECT_EQ(told["time"]["low"], 0.25);
  EXPECT_EQ(told["time"]["high"], 0.25);
  EXPECT_EQ(told["evidence"]["point"][0], -0.5);
  EXPECT_EQ(told["objects"][1]["moves"]["to"], json::parse("[5.0, 0.5, 0.25]"));
  EXPECT_FALSE(told["objects"][0].contains("moves"));
  const Run text = run(call + "--certificate " + in_folder("p.json"));
  EXPECT_EQ(text.code, 1);
  EXPECT_NE(text.out.find(": meet on the way"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("0.25 of 0 to 1: they meet then, and not before"), std::string::npos) << text.out;
  const Run checked = run("verify " + in_folder("p.json"));
  EXPECT_EQ(checked.code, 0);
  EXPECT_NE(checked.out.find("first meet on their ways at time 1/4"), std::string::npos) << checked.out;
  // Whoever of the two moves, and however the motion is shared.
  EXPECT_EQ(report(cubes + "--to-a -8,0,0 --pose-b -3,0.5,0.25", 1)["time"]["low"], 0.25);
  EXPECT_EQ(report(cubes + "--to-a -4,7,0 --pose-b -3,0.5,0.25 --to-b 1,7.5,0.25", 1)["time"]["low"], 0.25);
}

TEST_F(Motion, IsApartAllTheWay) {
  const std::string call = cubes + "--pose-b 3,1.25,0 --to-b -3,1.25,0 ";
  const json told = report(call, 0);
  EXPECT_EQ(told["answer"], "apart");
  EXPECT_EQ(told["evidence"]["gap_about"], 0.25);
  EXPECT_EQ(run(call + "--certificate " + in_folder("p.json")).code, 0);
  EXPECT_NE(run("verify " + in_folder("p.json")).out.find("are apart all along their ways"), std::string::npos);
  EXPECT_EQ(report(cubes + "--pose-b 3,1,0 --to-b -3,1,0", 1)["time"]["low"], 1.0 / 3);  // they touch
  EXPECT_EQ(report(cubes + "--pose-b 3,1.0000000000000002,0 --to-b -3,1.0000000000000002,0", 0)["answer"], "apart");
}

TEST_F(Motion, TakesBodiesWithARadius) {
  const std::string proof = in_folder("p.json");
  const std::string call = cubes + "--radius-a 0.5 --radius-b 0.25 --pose-b -5,1.75,0 --certificate " + proof;
  EXPECT_EQ(report(call + " --to-b 5,1.75,0", 1)["answer"], "meet");  // they touch
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  const json apart = report(cubes + "--radius-a 0.5 --radius-b 0.25 --pose-b -5,1.7500000000000002,0 " +
                                "--to-b 5,1.7500000000000002,0 --certificate " + proof,
                            0);
  EXPECT_EQ(apart["answer"], "apart");
  EXPECT_NE(run("verify " + proof).out.find("are apart all along their ways"), std::string::npos);
  for (const std::string shape : {"ball", "capsule", "cylinder", "cone", "ellipsoid"}) {
    const std::string past = shape == "ball" ? "0.2,0.1" : "0.2,-2.2";
    const std::string through = "pair " + cube + " " + cases + "/space/" + shape + ".json --pose-b -20," + past;
    const json told = report(through + " --to-b 20," + past + " --certificate " + proof, 1);
    EXPECT_EQ(told["answer"], "meet") << shape;
    EXPECT_LE(told["time"]["low"], told["time"]["high"]) << shape;
    EXPECT_LT(told["time"]["high"].get<double>() - told["time"]["low"].get<double>(), 0x1p-40) << shape;
    const Run checked = run("verify " + proof);
    EXPECT_EQ(checked.code, 0) << shape;
    EXPECT_NE(checked.out.find("meet on their ways, at time "), std::string::npos) << checked.out;
    EXPECT_TRUE(python_accepts(proof)) << shape;
    EXPECT_EQ(run(through + " --to-b -20,20,0").code, 0) << shape;
  }
}

TEST_F(Motion, RefusesWhatItDoesNotAnswer) {
  expect_bad(cubes + "--to-b 1,0,0.1,0,3,0,0", "--to-b: the body turns");
  expect_bad(cubes + "--to-b 2,0,0,0,0,2,0,0,0,0,2,0", "--to-b: the body turns, or changes its size");
  expect_bad(cubes + "--to-b nonsense", "--to-b");
  expect_bad(cubes + "--to-b 3,0,0 --distance", "--distance");
  expect_bad(cubes + "--to-b 3,0,0 --clearance 1", "--clearance");
  expect_bad(cubes + "--to-b 3,0,0 --classify", "--classify");
  expect_bad(cubes + "--to-b 3,0,0 --method gjk", "--method");
  const std::string space = cases + "/space/";
  expect_bad("pair " + cube + " " + space + "ball.json --to-b 1,0,0 --classify", "--classify");
  expect_bad("pair " + cube + " " + space + "ball.json --to-b 1,0,0.1,0,3,0,0", "--to-b: the body turns");
  expect_bad("pair " + cube + " " + space + "line.json --to-a 1,0,0", "--to-a");
  const std::string planar = cases + "/outcomes/";
  expect_bad("pair " + planar + "square.wkt " + planar + "far.wkt --to-b 1,0", "--to-b");
}

// Boxes on two rails, and one on an arm that turns.
class Between : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    const auto link = [](const std::string& name) {
      return "<link name='" + name + "'><collision><geometry><box size='1 1 1'/></geometry></collision></link>";
    };
    const auto joint = [](const std::string& name, const std::string& type, const std::string& axis,
                          const std::string& origin) {
      return "<joint name='to_" + name + "' type='" + type + "'><parent link='base'/><child link='" + name +
             "'/><axis xyz='" + axis + "'/><origin xyz='" + origin + "'/><limit lower='-20' upper='20'/></joint>";
    };
    write_text(in_folder("r.urdf"), "<robot name='r'><link name='base'/>" + link("x") + link("y") + link("arm") +
                                        joint("x", "prismatic", "1 0 0", "0 0 0") +
                                        joint("y", "prismatic", "0 1 0", "0 0 0") +
                                        joint("arm", "revolute", "0 0 1", "0 0 9") + "</robot>");
  }
  Run ask(const std::string& rows, const std::string& options = "") {
    write_text(in_folder("t.csv"), "to_x,to_y,to_arm\n" + rows);
    return run("scene " + in_folder("r.urdf") + " --between --placements " + in_folder("t.csv") + " " + options);
  }
};

TEST_F(Between, SeesWhatSuccessivePlacementsDoNot) {
  // x goes from 5 to -3 through y, which rests at 0; then y goes away, and they pass at a distance.
  const Run done = ask("5,0,0\n-3,0,0\n-3,8,0\n5,8,0\n");
  EXPECT_EQ(done.out,
            "0 to 1: x and y meet from 0.5 of the way on\n1 to 2: none meet\n2 to 3: none meet\n"
            "3 steps, of which 1 have bodies that meet on the way; pairs asked about all the way: 9\n");
  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(ask("-3,8,0\n5,8,0\n").code, 0);
  EXPECT_EQ(ask("5,0,0\n-3,0,0\n", "--allow x,y").code, 0);
}

// Lines, tables and proofs, for both checkers; the same for any number of threads.
TEST_F(Between, WritesLinesAndProofs) {
  std::string rows;
  for (int k = 0; k < 90; ++k) {
    rows += std::to_string((k * 7) % 11 - 5) + "," + std::to_string((k * 5) % 7 - 3) + "," +
            std::to_string(k % 50 == 0 ? 1 : 0) + "\n";
  }
  const std::string lines = in_folder("l.jsonl"), csv = in_folder("l.csv"), proof = in_folder("p.json");
  std::string before;
  for (const char* threads : {"1", "2", "3"}) {
    const std::string options = std::string("--threads ") + threads;
    const Run done =
        ask(rows, options + " --json-lines " + lines + " --csv " + csv + " --meeting-certificate " + proof);
    EXPECT_EQ(done.code, 1);
    const std::string all = done.out + ask(rows, options).out + read_text(lines) + read_text(csv) + read_text(proof);
    if (!before.empty()) {
      EXPECT_EQ(all, before) << threads;
    }
    before = all;
  }
  std::size_t meeting = 0, listed = 0;
  std::istringstream stream(read_text(lines)), table(read_text(csv));
  std::string line, row;
  ASSERT_TRUE(std::getline(stream, line) && std::getline(table, row));
  EXPECT_EQ(json::parse(line)["placements"], 90);
  EXPECT_EQ(row, "step,answer,meeting,pairs");
  for (int k = 0; std::getline(stream, line); ++k) {
    const json step = json::parse(line);
    EXPECT_EQ(step["step"], k);
    const json pairs = step.value("pairs", json::array());
    for (const json& pair : pairs) {
      EXPECT_EQ(pair["answer"], "meet");
      EXPECT_LE(pair["time"]["low"], pair["time"]["high"]);
    }
    meeting += pairs.size();
    ASSERT_TRUE(std::getline(table, row));
    EXPECT_TRUE(row.starts_with(std::to_string(k) + "," + step["answer"].get<std::string>() + "," +
                                std::to_string(pairs.size()) + ","))
        << row;
    ++listed;
  }
  EXPECT_EQ(listed, 89u);
  EXPECT_GT(meeting, 10u);
  const json file = json::parse(read_text(proof));
  EXPECT_EQ(file["statements"].size(), meeting);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  // With what is apart: of the 3 pairs all, but for what turns and does not meet.
  EXPECT_EQ(ask(rows, "--parted --meeting-certificate " + proof).code, 1);
  const json whole = json::parse(read_text(proof));
  std::size_t apart = 0;
  for (const json& statement : whole["statements"]) apart += statement["verdict"] == "apart";
  EXPECT_EQ(apart + meeting, whole["statements"].size());
  EXPECT_EQ(apart + meeting, 3u * 89 - 2u * 3);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  // The first.
  const Run first = ask("9,8,0\n8,8,0\n5,0,0\n-3,0,0\n-3,8,0\n", "--first");
  EXPECT_NE(first.out.find("2 to 3: x and y meet"), std::string::npos) << first.out;
  EXPECT_NE(first.out.find("not asked about, after the first that meets: 1;"), std::string::npos) << first.out;
  EXPECT_NE(ask("5,8,0\n-3,8,0\n", "--meeting-certificate " + in_folder("q.json")).out.find("no proofs are written"),
            std::string::npos);
}

TEST_F(Between, SaysWhatTurns) {
  const Run done = ask("5,0,0\n5,0,1\n-3,0,1\n");
  EXPECT_EQ(
      done.out,
      "0 to 1: none is known to meet\n1 to 2: x and y meet from 0.5 of the way on\n"
      "2 steps, of which 1 have bodies that meet on the way; where that is not known: 1; pairs asked about all the "
      "way: 4; at their ends only, as a part turns: 2\n");
  EXPECT_EQ(ask("5,0,0\n5,0,1\n").code, 1);  // what it does between is not known
  for (const char* option : {"--classify", "--json", "--clearance 1", "--distance", "--parted"}) {
    EXPECT_EQ(ask("5,0,0\n-3,0,0\n", option).code, 2) << option;
  }
  EXPECT_EQ(ask("5,0,0\n").code, 2);
  EXPECT_EQ(run("scene " + in_folder("r.urdf") + " --between").code, 2);
}

}  // namespace

}  // namespace sunder::tests
