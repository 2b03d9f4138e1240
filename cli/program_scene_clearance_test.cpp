// The verb scene: --clearance, --margin, --distance.
#include <tests/support/program.h>

#include <string>
#include <utility>
#include <vector>

namespace sunder::tests {

namespace {

// Both checkers accept what the call writes; returns it.
class SceneClearance : public Program {
 protected:
  json proof_of(const std::string& file) const {
    EXPECT_EQ(run("verify '" + file + "'").code, 0) << file;
    EXPECT_TRUE(python_accepts(file));
    return json::parse(read_text(file));
  }
};

TEST_F(SceneClearance, TellsTheLastBit) {
  const std::string proof = in_folder("proof.json"), lines = "scene " + cube + " " + cube + "@";
  for (const auto& [at, code] : {std::pair("1.25", 0), std::pair("1.2499999999999998", 1), std::pair("0.5", 1)}) {
    const json r = report(lines + at + ",0,0 --clearance 0.25 --certificate '" + proof + "'", code);
    EXPECT_EQ(r["clearance"]["kept"], code == 0);
    EXPECT_EQ(r["clearance"]["least"], 0.25);
    EXPECT_EQ(r["clearance"]["closer"].size(), code == 0 ? 0u : 1u);
    const json whole = proof_of(proof), last = whole["statements"].back();
    EXPECT_EQ(last["question"], "clearances");
    EXPECT_EQ(last["verdict"], code == 0 ? "kept" : "broken");
  }
  // Touching is closer than any margin, however small.
  EXPECT_EQ(run(lines + "1,0,0 --clearance 1e-300 --allow touch").code, 1);
  EXPECT_EQ(run(lines + "1,0,0 --allow touch").code, 0);
}

TEST_F(SceneClearance, Margins) {
  const std::string three = "scene " + cube + " " + cube + "@2,0,0 " + cube + "@5,0,0", proof = in_folder("proof.json");
  EXPECT_EQ(run(three + " --clearance 1").code, 0);
  const json r = report(three + " --clearance 1.5 --margin 'cube, cube#3=4.5' --certificate '" + proof + "'", 1);
  ASSERT_EQ(r["clearance"]["closer"].size(), 2u);
  EXPECT_EQ(r["clearance"]["closer"][0]["b"], "cube#2");
  EXPECT_EQ(r["clearance"]["closer"][0]["least"], 1.5);
  EXPECT_EQ(r["clearance"]["closer"][1]["b"], "cube#3");
  EXPECT_EQ(r["clearance"]["closer"][1]["least"], 4.5);
  EXPECT_EQ(r["clearance"]["closer"][1]["high"], 4.0);
  EXPECT_EQ(r["clearance"]["totals"]["closer"], 2);
  EXPECT_EQ(r["clearance"]["totals"]["pairs"], 3);
  const json whole = proof_of(proof);
  std::vector<json> all;
  for (const json& s : whole["statements"]) {
    if (s["question"] == "clearances") all.push_back(s);
  }
  ASSERT_EQ(all.size(), 2u);  // of all but the one; of it
  EXPECT_EQ(all[0]["except"], json::parse("[[0, 2]]"));
  EXPECT_EQ(all[1]["members"].size(), 2u);
  EXPECT_EQ(all[1]["nearer"], json::parse("[[0, 1]]"));

  // Only the margin is asked about; none, of a pair that would be closer.
  EXPECT_EQ(report(three + " --margin cube#3,cube=4", 0)["clearance"]["least"], 0.0);
  EXPECT_EQ(run(three + " --margin cube#3,cube=4.5").code, 1);
  EXPECT_EQ(run(three + " --clearance 1.5 --margin cube,cube#2=0").code, 0);
  const Run allowed = run(three + " --allow cube,cube#2 --clearance 1.5 --margin cube#2,cube=9");
  EXPECT_EQ(allowed.code, 0) << allowed.out;
  EXPECT_NE(allowed.err.find("--margin cube#2,cube=9: these may meet, so they are not asked about"), std::string::npos);
  EXPECT_NE(allowed.out.find("none of 3 pairs (allowed 1, "), std::string::npos) << allowed.out;
}

TEST_F(SceneClearance, Distance) {
  const std::string proof = in_folder("proof.json"), three = "scene " + cube + " " + cube + "@2,0,0 " + cube + "@5,0,0";
  const json r = report(three + " --distance --certificate '" + proof + "'", 0);
  ASSERT_EQ(r["nearest"].size(), 1u);
  EXPECT_EQ(r["nearest"][0]["a"], "cube");
  EXPECT_EQ(r["nearest"][0]["b"], "cube#2");
  EXPECT_EQ(r["nearest"][0]["low"], 1.0);
  EXPECT_EQ(r["nearest"][0]["high"], 1.0);
  EXPECT_FALSE(r.contains("clearance"));
  const json whole = proof_of(proof), statements = whole["statements"];
  EXPECT_EQ(statements.back()["question"], "distance");
  EXPECT_EQ(statements[statements.size() - 2]["question"], "clearances");
  EXPECT_NE(run(three + " --distance --allow cube,cube#2").out.find("nearest: cube#2 and cube#3: about 2 apart"),
            std::string::npos);
  EXPECT_NE(run("scene " + cube + " --distance").out.find("nearest: no pair is asked about"), std::string::npos);
  const json within = report("scene " + cube + " " + cube + "@0.5,0,0 --distance", 1), meet = within["nearest"][0];
  EXPECT_EQ(meet["high"], 0.0);
  EXPECT_FALSE(meet.contains("points_about"));
}

// What a checker must refuse, if a true proof is made to say something else.
TEST_F(SceneClearance, ProofsThatAreChanged) {
  const std::string proof = in_folder("proof.json");
  const std::string three = "scene " + cube + " " + cube + "@2,0,0 " + cube + "@5,0,0 --clearance 1.5";
  EXPECT_EQ(run(three + " --margin cube,cube#3=4.5 --certificate '" + proof + "'").code, 1);
  const json whole = proof_of(proof);
  std::size_t at = 0;
  while (whole["statements"][at]["question"] != "clearances") ++at;
  std::vector<json> mutants;
  const auto with = [&](const auto& change) { change(mutants.emplace_back(whole)["statements"]); };
  with([&](json& s) { s[at]["nearer"] = json::parse("[[0, 1], [1, 2]]"); });
  with([&](json& s) { s[at]["nearer"] = json::parse("[[1, 2]]"); });
  with([&](json& s) { s[at]["verdict"] = "kept", s[at].erase("nearer"); });
  with([&](json& s) { s[at]["except"] = json::array(); });
  with([&](json& s) { s[at]["least"] = "0x1p+0"; });
  with([&](json& s) { s[at]["least"] = "0x1.8000000000001p+0"; });
  for (std::size_t k = 0; k < whole["statements"].size(); ++k) {
    if (whole["statements"][k]["question"] == "clearance") with([&](json& s) { s.erase(k); });
  }
  EXPECT_EQ(mutants.size(), 9u);
  for (const json& mutant : mutants) {
    write_text(proof, mutant.dump());
    const Run refused = run("verify '" + proof + "'");
    EXPECT_EQ(refused.code, 1) << mutant.dump();
    EXPECT_NE(refused.out.find("each_clearance"), std::string::npos) << refused.out;
    EXPECT_FALSE(python_accepts(proof));
  }
}

TEST_F(SceneClearance, IsOfTheArm) {
  const std::string arm = "scene " + panda + " --allow adjacent" + ready + folded, proof = in_folder("proof.json");
  const json r = report(arm + " --clearance 0.01 --distance --certificate '" + proof + "'", 1);
  ASSERT_EQ(r["nearest"].size(), 2u);
  EXPECT_GT(r["nearest"][0]["low"], 0.01);
  EXPECT_EQ(r["nearest"][1]["high"], 0.0);
  EXPECT_GT(r["clearance"]["closer"].size(), 1u);
  for (const json& pair : r["clearance"]["closer"]) EXPECT_EQ(pair["placement"], 1);
  proof_of(proof);
  // As many placements as one likes, where the report is of all.
  const std::string bends = " --placements " + cases + "/scene/bends.csv";
  const json all = report("scene " + panda + " --allow adjacent --clearance 0.01" + bends, 1);
  EXPECT_GT(all["placements"].size(), 2u);
  EXPECT_GT(all["clearance"]["closer"].size(), 0u);
}

TEST_F(SceneClearance, OfBallsAndCapsules) {
  const std::string balls = in_folder("balls.urdf"), proof = in_folder("proof.json");
  const auto link = [](const std::string& name, const std::string& shape) {
    return "<link name='" + name + "'><collision><geometry>" + shape + "</geometry></collision></link>";
  };
  const auto joint = [](const std::string& name, const std::string& at) {
    return "<joint name='j" + name + "' type='fixed'><origin xyz='" + at + "'/><parent link='a'/><child link='" + name +
           "'/></joint>";
  };
  write_text(balls, "<robot name='r'>" + link("a", "<sphere radius='0.5'/>") + link("b", "<sphere radius='0.25'/>") +
                        link("c", "<capsule radius='0.5' length='2'/>") + joint("b", "3 0 0") + joint("c", "0 2 0") +
                        "</robot>");
  for (const auto& [least, code] : {std::pair("1", 0), std::pair("1.0000000000000002", 1), std::pair("2.5", 1)}) {
    const json r =
        report("scene '" + balls + "' --clearance " + least + " --distance --certificate '" + proof + "'", code);
    EXPECT_EQ(r["nearest"][0]["a"], "a");
    EXPECT_EQ(r["nearest"][0]["b"], "c");
    EXPECT_EQ(r["nearest"][0]["low"], 1.0);
    EXPECT_EQ(r["nearest"][0]["high"], 1.0);
    EXPECT_EQ(r["nearest"][0]["points_about"], json::parse("[[0.0, 0.5, 0.0], [0.0, 1.5, 0.0]]"));
    proof_of(proof);
  }
}

// A cylinder and a ball whose distance is a double; two cylinders so near that nothing is said that is not known.
TEST_F(SceneClearance, OfCurvedBodies) {
  const std::string proof = in_folder("proof.json");
  const std::string crane = "scene " + cases + "/scene/primitives.urdf --allow adjacent --joints hoist=0.5";
  const json far = report(crane + " --clearance 1e-3 --distance --certificate '" + proof + "'", 0);
  EXPECT_TRUE(far["clearance"]["kept"].get<bool>());
  const json near = far["nearest"][0];
  EXPECT_LE(near["high"].get<double>() - near["low"].get<double>(), 1e-15);
  EXPECT_GT(near["low"], 1e-3);
  EXPECT_EQ(proof_of(proof)["statements"].back()["verdict"], "broken");
  EXPECT_EQ(run(crane + " --clearance " + near["low"].dump()).code, 0);
  EXPECT_EQ(run(crane + " --clearance " + std::to_string(near["high"].get<double>() + 1e-5)).code, 1);

  const std::string nearly = "scene " + cases + "/scene/nearly.urdf " + cube + "@9,0,0 --joints way=1.3853189754928872";
  const json r = report(nearly + " --clearance 1e-33 --distance --certificate '" + proof + "'", 1);
  EXPECT_FALSE(r["clearance"]["kept"].get<bool>());
  EXPECT_EQ(r["clearance"]["closer"].size(), 0u);
  ASSERT_EQ(r["clearance"]["undecided"].size(), 1u);
  EXPECT_EQ(r["clearance"]["undecided"][0]["low"], 0.0);
  EXPECT_GT(r["clearance"]["undecided"][0]["high"], 1e-33);
  EXPECT_EQ(r["clearance"]["totals"]["undecided"], 1);
  EXPECT_EQ(r["nearest"][0]["low"], 0.0);
  EXPECT_EQ(proof_of(proof)["left_out"],
            (json{"one and other, undecided whether they meet", "one and other, undecided whether they are closer"}));
  EXPECT_NE(run(nearly + " --clearance 1e-33").out.find("none that is known of 3 pairs"), std::string::npos);
  EXPECT_EQ(report(nearly + " --clearance 1e-29", 1)["clearance"]["closer"].size(), 1u);
}

TEST_F(SceneClearance, ThatIsNone) {
  const std::string two = "scene " + cube + " " + cube + "@2,0,0 ";
  for (const auto& [options, words] : std::vector<std::pair<std::string, std::string>>{
           {"--clearance -1", "--clearance: '-1' is not one number above zero"},
           {"--clearance 0", "'0' is not one number above zero"},
           {"--clearance nan", "--clearance"},
           {"--clearance inf", "--clearance"},
           {"--clearance 1,2", "'1,2' is not one number above zero"},
           {"--margin cube,cube#2=-1", "--margin: '-1' is not one number of zero or more"},
           {"--margin cube,cube#2=nan", "--margin"},
           {"--margin cube,cube#2=", "--margin"},
           {"--margin cube,cube#2", "is not NAME,NAME=NUMBER"},
           {"--margin cube=1", "is not NAME,NAME=NUMBER"},
           {"--margin cube,cone=1", "no body is named 'cone'; bodies are cube, cube#2"},
           {"--margin cube,cube=1", "names one body twice"},
           {"--margin cube,cube#2=1 --margin cube#2,cube=2", "has a margin already"}}) {
    expect_bad(two + options, words);
  }
  expect_bad("scene " + panda + " --distance --meeting-certificate p.json --placements " + cases + "/scene/bends.csv",
             "--meeting-certificate: proves what meets");
}

}  // namespace

}  // namespace sunder::tests
