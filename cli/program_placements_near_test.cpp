// The verb scene with --placements, by lines: how near the bodies are, and the proofs of whole placements.
#include <tests/support/program.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace sunder::tests {

namespace {

class NearPlacements : public Program {
 protected:
  // `count` rows that bend the arm to and fro.
  std::string table(int count) const {
    std::string text = "panda_joint2,panda_joint4,panda_joint6\n";
    for (int k = 0; k < count; ++k) {
      const double part = k * 37 % 100 / 100.0;
      text += std::to_string(-1.7 + 3.4 * part) + ',' + std::to_string(-3.0 + 2.9 * part * part) + ',' +
              std::to_string(3.7 * part) + '\n';
    }
    write_text(in_folder("t.csv"), text);
    return in_folder("t.csv");
  }
  const std::string arm = "scene " + panda + " --allow adjacent --allow panda_leftfinger,panda_rightfinger ";
};

TEST_F(NearPlacements, AreAsTheReportSays) {
  const std::string lines = in_folder("l.jsonl"), csv = in_folder("l.csv");
  const std::string call = arm + "--placements " + table(70) +
                           " --clearance 0.02 --margin panda_link5,panda_hand=0.03 --margin panda_link5,panda_link7=0 "
                           "--distance ";
  const json held = report(call, 1);
  std::string before;
  for (const char* threads : {"1", "3"}) {
    const std::string on = std::string("--threads ") + threads;
    EXPECT_EQ(run(call + on + " --json-lines " + lines + " --csv " + csv).code, 1);
    const std::string all = read_text(lines) + read_text(csv) + run(call + on).out;
    if (!before.empty()) {
      EXPECT_EQ(all, before);
    }
    before = all;
  }
  const auto written = lines_of(read_text(lines)), rows = lines_of(read_text(csv)), text = lines_of(run(call).out);
  ASSERT_EQ(written.size(), 71u);
  ASSERT_EQ(rows.size(), 71u);
  ASSERT_EQ(text.size(), 71u);
  const json head = json::parse(written[0]);
  EXPECT_EQ(head["clearance"]["least"], 0.02);
  EXPECT_EQ(head["clearance"]["margins"].size(), 2u);
  EXPECT_EQ(rows[0], "placement,answer,meeting,pairs,closer,closer_pairs,nearest_low,nearest_high,nearest_pair");
  std::size_t not_kept = 0, listed = 0;
  for (std::size_t k = 0; k < 70; ++k) {
    const json line = json::parse(written[k + 1]);
    std::vector<json> expected;
    for (json pair : held["clearance"]["closer"]) {
      if (pair["placement"] != k) continue;
      pair.erase("placement");
      expected.push_back(pair);
    }
    EXPECT_EQ(line["closer"], json(expected)) << k;
    json nearest = held["nearest"][k];
    nearest.erase("placement");
    EXPECT_EQ(line["nearest"], nearest) << k;
    EXPECT_FALSE(line.contains("closer_undecided"));
    EXPECT_EQ(text[k].find("; none are closer; nearest: ") != std::string::npos, expected.empty()) << text[k];
    EXPECT_NE(rows[k + 1].find("," + std::to_string(expected.size()) + ","), std::string::npos) << rows[k + 1];
    not_kept += !expected.empty();
    listed += expected.size();
  }
  EXPECT_GT(listed, not_kept);
  EXPECT_GT(not_kept, 10u);
  EXPECT_LT(not_kept, 70u);
  EXPECT_NE(text[70].find("; closer than asked for, or undecided: " + std::to_string(not_kept)), std::string::npos)
      << text[70];
}

TEST_F(NearPlacements, StopAtTheFirstThatIsCloser) {
  write_text(in_folder("t.csv"), "panda_joint4,panda_joint6\n-1.5,1.5\n-1.6,1.5\n-1.7,1.5\n");
  const std::string call = arm + "--placements " + in_folder("t.csv");
  EXPECT_EQ(run(call).code, 0);
  const Run kept = run(call + " --clearance 1e-3 --first");
  EXPECT_EQ(kept.code, 0);
  EXPECT_EQ(kept.out,
            "0: none meet; none are closer\n1: none meet; none are closer\n2: none meet; none are closer\n"
            "3 placements, of which 0 have bodies that meet; closer than asked for, or undecided: 0\n");
  const Run first = run(call + " --clearance 0.1 --first --threads 2");
  EXPECT_EQ(first.code, 1);
  EXPECT_EQ(lines_of(first.out).size(), 2u);
  EXPECT_NE(first.out.find("; not asked about, after the first that meets or is closer: 2"), std::string::npos);
  expect_bad(call + " --distance --meeting-certificate " + in_folder("p.json"), "--meeting-certificate: proves");
  expect_bad(call + " --parted", "--meeting-certificate");
}

// Two cylinders that nearly touch: listed and counted, and nothing that is known.
TEST_F(NearPlacements, TellWhatIsUndecided) {
  write_text(in_folder("t.csv"), "way\n4\n1.3853189754928872\n");
  const std::string call =
      "scene " + cases + "/scene/nearly.urdf --placements " + in_folder("t.csv") + " --clearance 1e-33 ";
  const Run done = run(call + "--json-lines -");
  EXPECT_EQ(done.code, 1);
  const auto lines = lines_of(done.out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_FALSE(json::parse(lines[1]).contains("closer_undecided"));
  const json undecided = json::parse(lines[2]);
  EXPECT_EQ(undecided["closer"].size(), 0u);
  ASSERT_EQ(undecided["closer_undecided"].size(), 1u);
  EXPECT_EQ(undecided["closer_undecided"][0]["low"], 0.0);
  const Run text = run(call);
  EXPECT_NE(text.out.find("0: none meet; none are closer\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("; none are known to be closer; undecided whether one and other are closer than 1e-33: "),
            std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("; closer than asked for, or undecided: 1"), std::string::npos) << text.out;
  EXPECT_NE(run(call + "--csv -").out.find("one and other (undecided, "), std::string::npos);
}

TEST_F(NearPlacements, ProveAllOfEach) {
  const std::string proof = in_folder("p.json"), whole = in_folder("w.json");
  const std::string call = arm + "--placements " + table(6);
  EXPECT_EQ(run(call + " --parted --meeting-certificate " + proof + " --threads 2").code, 1);
  EXPECT_EQ(run(call + " --certificate " + whole).code, 1);
  const auto verdicts = [](const std::string& file) {
    std::vector<std::string> found;
    const json all = json::parse(read_text(file));
    for (const json& statement : all["statements"]) found.push_back(statement["verdict"]);
    return found;
  };
  EXPECT_EQ(verdicts(proof), verdicts(whole));
  EXPECT_EQ(json::parse(read_text(proof))["left_out"], json::parse(read_text(whole))["left_out"]);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  // Also where nothing meets.
  write_text(in_folder("c.csv"), "panda_joint4,panda_joint6\n-1.5,1.5\n-1.6,1.5\n");
  EXPECT_EQ(run(arm + "--parted --placements " + in_folder("c.csv") + " --meeting-certificate " + proof).code, 0);
  const Run checked = run("verify " + proof);
  EXPECT_EQ(checked.code, 0);
  EXPECT_NE(checked.out.find("2 these"), std::string::npos) << checked.out;
}

// All that is told to be closer, and what meets, and nothing else; the same file for any number of threads.
TEST_F(NearPlacements, ProveWhatIsCloser) {
  const std::string proof = in_folder("p.json"), lines = in_folder("l.jsonl");
  const std::string call = arm + "--placements " + table(70) +
                           " --clearance 0.02 --margin panda_link5,panda_hand=0.03 --meeting-certificate " + proof;
  std::string before;
  for (const char* threads : {" --threads 1", " --threads 3"}) {
    EXPECT_EQ(run(call + threads + " --json-lines " + lines).code, 1);
    const std::string file = read_text(proof);
    if (!before.empty()) {
      EXPECT_EQ(file, before);
    }
    before = file;
  }
  std::size_t meeting = 0, own = 0;
  std::vector<double> least;
  for (const std::string& line : lines_of(read_text(lines))) {
    const json told = json::parse(line);
    if (!told.contains("placement")) continue;
    if (told.contains("pairs")) meeting += told["pairs"].size();
    for (const json& pair : told["closer"]) least.push_back(pair["least"]);
    for (const json& pair : told["closer"]) own += pair["least"] == 0.03;
  }
  const json all = json::parse(before);
  std::vector<double> stated;
  std::size_t met = 0;
  for (const json& statement : all["statements"]) {
    met += statement["verdict"] == "meet";
    if (statement["verdict"] == "broken") stated.push_back(std::stod(statement["least"].get<std::string>()));
  }
  EXPECT_EQ(met, meeting);
  EXPECT_EQ(stated, least);
  EXPECT_EQ(all["statements"].size(), met + stated.size());
  EXPECT_GT(meeting, 10u);
  EXPECT_GT(own, 0u);
  EXPECT_GT(least.size(), meeting + own);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  const Run done = run(call);
  EXPECT_NE(done.out.find("proofs of " + std::to_string(met) + " pairs that meet, and of " +
                          std::to_string(stated.size()) + " closer  " + proof),
            std::string::npos)
      << done.out;
}

// One pair that is closer and does not meet: what says less than the truth is accepted, no other mutant.
TEST_F(NearPlacements, ProofsOfWhatIsCloserAreLookedAt) {
  write_text(in_folder("t.csv"), "panda_joint4,panda_joint6\n-1.5,1.5\n-1.6,1.5\n");
  const std::string proof = in_folder("p.json");
  const std::string call = arm + "--placements " + in_folder("t.csv") + " --meeting-certificate " + proof;
  const Run none = run(call + " --clearance 1e-9");
  EXPECT_EQ(none.code, 0);
  EXPECT_NE(none.out.find("no proofs are written, as nothing is known to meet, or to be closer"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(proof));
  EXPECT_EQ(run(call + " --clearance 0.1").code, 1);
  const json whole = json::parse(read_text(proof));
  const auto is_accepted = [&](const json& file) {
    write_text(proof, file.dump());
    const bool accepts = run("verify " + proof).code == 0;
    EXPECT_EQ(python_accepts(proof), accepts);
    return accepts;
  };
  EXPECT_TRUE(is_accepted(whole));
  ASSERT_EQ(whole["statements"][0]["verdict"], "broken");
  json mutant = whole;
  mutant["statements"][0]["least"] = "0x1p-30";
  EXPECT_FALSE(is_accepted(mutant));
  mutant = whole;
  mutant["statements"][0]["verdict"] = "kept";
  EXPECT_FALSE(is_accepted(mutant));
  mutant = whole;
  std::swap(mutant["statements"][0]["a"], mutant["statements"][0]["b"]);
  EXPECT_FALSE(is_accepted(mutant));
  mutant = whole;
  mutant["statements"][0]["least"] = "0x1p-2";
  EXPECT_TRUE(is_accepted(mutant));
}

TEST_F(NearPlacements, ProveHowFarAllAreOfEach) {
  const std::string proof = in_folder("p.json"), whole = in_folder("w.json");
  const std::string call = arm + "--placements " + table(6) + " --clearance 0.02 --margin panda_link5,panda_hand=0.03 ";
  EXPECT_EQ(run(call + " --parted --meeting-certificate " + proof + " --threads 2").code, 1);
  EXPECT_EQ(run(call + " --certificate " + whole).code, 1);
  const auto statements = [](const std::string& file) {
    std::vector<std::string> found;
    const json all = json::parse(read_text(file));
    for (const json& statement : all["statements"]) {
      const std::string least = statement.contains("least") ? statement["least"].get<std::string>() : "";
      found.push_back(statement["question"].get<std::string>() + statement["verdict"].get<std::string>() + least);
    }
    return found;
  };
  EXPECT_EQ(statements(proof), statements(whole));
  EXPECT_EQ(json::parse(read_text(proof))["left_out"], json::parse(read_text(whole))["left_out"]);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  // Without one of the pairs that are nearer it is not all of them.
  json mutant = json::parse(read_text(proof));
  bool is_changed = false;
  for (json& statement : mutant["statements"]) {
    if (is_changed || statement["question"] != "clearances" || statement["verdict"] != "broken") continue;
    if (statement["nearer"].size() < 2) continue;
    statement["nearer"].erase(0);
    is_changed = true;
  }
  ASSERT_TRUE(is_changed);
  write_text(proof, mutant.dump());
  const Run refused = run("verify " + proof);
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.out.find("each_clearance"), std::string::npos) << refused.out;
  EXPECT_FALSE(python_accepts(proof));
}

// Two cylinders of which it is undecided are left out, and that is told.
TEST_F(NearPlacements, ProofsTellWhatIsUndecided) {
  write_text(in_folder("t.csv"), "way\n4\n1.3853189754928872\n1\n");
  const std::string proof = in_folder("p.json");
  const std::string call = "scene " + cases + "/scene/nearly.urdf --placements " + in_folder("t.csv") +
                           " --clearance 1e-33 --meeting-certificate " + proof;
  for (const char* parted : {"", " --parted"}) {
    EXPECT_EQ(run(call + parted).code, 1);
    EXPECT_EQ(run("verify " + proof).code, 0);
    EXPECT_TRUE(python_accepts(proof));
    const std::string left_out = json::parse(read_text(proof))["left_out"].dump();
    EXPECT_NE(left_out.find("1: one and other, undecided whether they are closer"), std::string::npos) << left_out;
    EXPECT_EQ(left_out.find("0: one and other"), std::string::npos) << left_out;
  }
}

}  // namespace

}  // namespace sunder::tests
