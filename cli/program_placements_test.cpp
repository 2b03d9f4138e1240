// The verb scene with --placements.
#include <tests/support/program.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace sunder::tests {

namespace {

class Placements : public Program {
 protected:
  // Values of the arm's joints that sweep them, `count` rows of them; every tenth row or so is folded into itself.
  std::string table(std::size_t count) const {
    std::string text = "panda_joint2,panda_joint4,panda_joint6,panda_joint1\n";
    for (std::size_t k = 0; k < count; ++k) {
      const double part = static_cast<double>(k * 37 % 100) / 100;
      text += std::to_string(-1.7 + 3.4 * part) + ',' + std::to_string(-3.0 + 2.9 * part * part) + ',' +
              std::to_string(3.7 * part) + ',' + std::to_string(static_cast<double>(k) / 500) + '\n';
    }
    write_text(in_folder("t.csv"), text);
    return in_folder("t.csv");
  }
  const std::string arm = "scene " + panda + " --allow adjacent --allow panda_leftfinger,panda_rightfinger ";
};

TEST_F(Placements, AnswerAsOneByOne) {
  const std::string call = arm + "--placements " + table(150);
  const json held = report(call + " --classify", 1);
  ASSERT_EQ(held["placements"].size(), 150u);
  const Run done = run(call + " --classify --json-lines " + in_folder("l.jsonl") + " --csv " + in_folder("l.csv"));
  EXPECT_EQ(done.code, 1);
  const auto lines = lines_of(read_text(in_folder("l.jsonl"))), rows = lines_of(read_text(in_folder("l.csv")));
  const auto text = lines_of(run(call + " --classify").out);
  ASSERT_EQ(lines.size(), 151u);
  ASSERT_EQ(rows.size(), 151u);
  ASSERT_EQ(text.size(), 151u);  // the last one sums up
  const json head = json::parse(lines[0]);
  EXPECT_EQ(head["bodies"].size(), 11u);
  EXPECT_EQ(head["placements"], 150);
  EXPECT_EQ(head["allowed_pairs"], held["allowed_pairs"]);
  EXPECT_EQ(rows[0], "placement,answer,meeting,pairs");
  std::size_t some = 0;
  for (std::size_t k = 0; k < 150; ++k) {
    const json line = json::parse(lines[k + 1]);
    EXPECT_EQ(line["placement"], k);
    EXPECT_EQ(line["answer"], held["placements"][k]["answer"]);
    std::vector<json> expected;
    for (const json& pair : held["pairs"]) {
      if (pair["placement"] == k && pair["answer"] == "meet") expected.push_back(pair);
    }
    const json pairs = line.value("pairs", json::array());
    ASSERT_EQ(pairs.size(), expected.size()) << k;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      for (const char* key : {"a", "b", "part_a", "part_b", "answer", "contact", "said_of", "counted"}) {
        EXPECT_EQ(pairs[p][key], expected[p][key]) << k << key;
      }
      const std::size_t named = pairs[p]["evidence"]["vertices_a"].size() + pairs[p]["evidence"]["vertices_b"].size();
      EXPECT_GE(named, 2u);
      EXPECT_LE(named, 5u);
    }
    EXPECT_TRUE(rows[k + 1].starts_with(std::to_string(k) + "," + line["answer"].get<std::string>() + "," +
                                        std::to_string(pairs.size()) + ","));
    EXPECT_TRUE(text[k].starts_with(std::to_string(k) + ": "));
    EXPECT_EQ(text[k].ends_with(": none meet"), pairs.empty());
    some += !pairs.empty();
  }
  EXPECT_GT(some, 10u);
  EXPECT_LT(some, 140u);
  EXPECT_EQ(text[150], "150 placements, of which " + std::to_string(some) + " have bodies that meet");
}

TEST_F(Placements, AreTheSameOnAnyNumberOfThreads) {
  const std::string call = arm + "--placements " + table(1000);
  std::vector<std::string> outputs;
  for (const char* threads : {"1", "2", "3", "16", "0"}) {
    const Run done =
        run(call + " --json-lines " + in_folder("l.jsonl") + " --csv " + in_folder("l.csv") + " --threads " + threads);
    EXPECT_EQ(done.code, 1);
    (void)run(call + " --meeting-certificate " + in_folder("p.json") + " --threads " + threads);
    outputs.push_back(read_text(in_folder("l.jsonl")) + read_text(in_folder("l.csv")) + done.out +
                      read_text(in_folder("p.json")) + run(call + " --threads " + threads).out);
  }
  for (const std::string& output : outputs) EXPECT_EQ(output, outputs.front());
}

TEST_F(Placements, StopAtTheFirst) {
  const std::string call = arm + "--placements " + table(1000);
  const auto all = lines_of(run(call).out);
  const auto meets =
      std::find_if(all.begin(), all.end(), [](const auto& line) { return !line.ends_with(": none meet"); });
  ASSERT_NE(meets, all.end());
  for (const char* threads : {" --threads 1", " --threads 4"}) {
    const Run done = run(call + " --first" + threads);
    const auto lines = lines_of(done.out);
    ASSERT_EQ(lines.size(), static_cast<std::size_t>(meets - all.begin()) + 2);
    EXPECT_TRUE(std::equal(all.begin(), meets + 1, lines.begin()));
    EXPECT_NE(lines.back().find("; not asked about, after the first that meets: "), std::string::npos);
    EXPECT_EQ(done.code, 1);
  }
  const std::string clear = "panda_joint4,panda_joint6\n-1.5,1.5\n-1.6,1.5\n";
  write_text(in_folder("clear.csv"), clear);
  const Run none = run(arm + "--first --placements " + in_folder("clear.csv"));
  EXPECT_EQ(none.code, 0);
  EXPECT_EQ(none.out, "0: none meet\n1: none meet\n2 placements, of which 0 have bodies that meet\n");
}

TEST_F(Placements, ProveWhatTheySay) {
  const std::string proofs = in_folder("proofs.json");
  EXPECT_EQ(run(arm + "--placements " + table(3) + " --certificate " + proofs).code, 1);
  EXPECT_EQ(run("verify " + proofs).code, 0);
  EXPECT_NE(read_text(proofs).find("t.csv"), std::string::npos);  // among the inputs
  EXPECT_TRUE(python_accepts(proofs));
}

// What meets, and nothing else, for both checkers.
TEST_F(Placements, ProveWhatMeets) {
  const std::string proofs = in_folder("proofs.json"), lines = in_folder("l.jsonl");
  const std::string call = arm + "--placements " + table(150) + " --meeting-certificate " + proofs;
  const Run done = run(call + " --json-lines " + lines);
  EXPECT_EQ(done.code, 1);
  std::size_t pairs = 0;
  for (const std::string& line : lines_of(read_text(lines))) pairs += json::parse(line).value("pairs", json()).size();
  ASSERT_GT(pairs, 10u);
  EXPECT_NE(done.out.find("  proofs of " + std::to_string(pairs) + " pairs  " + proofs), std::string::npos) << done.out;
  const json file = json::parse(read_text(proofs));
  EXPECT_EQ(file["statements"].size(), pairs);
  for (const json& statement : file["statements"]) EXPECT_EQ(statement["verdict"], "meet");
  EXPECT_EQ(file["left_out"], json::array({"all pairs of bodies that no statement is about"}));
  EXPECT_NE(read_text(proofs).find("t.csv"), std::string::npos);  // among the inputs
  EXPECT_EQ(run("verify " + proofs).code, 0);
  EXPECT_TRUE(python_accepts(proofs));

  EXPECT_EQ(run(call + " --classify").code, 1);
  const json classified = json::parse(read_text(proofs));
  for (const json& statement : classified["statements"]) {
    EXPECT_TRUE(statement["verdict"] == "touching" || statement["verdict"] == "overlapping");
  }
  EXPECT_EQ(run("verify " + proofs).code, 0);
}

TEST_F(Placements, ProveNothingWhereNothingMeets) {
  write_text(in_folder("clear.csv"), "panda_joint4,panda_joint6\n-1.5,1.5\n-1.6,1.5\n");
  const Run none =
      run(arm + "--placements " + in_folder("clear.csv") + " --meeting-certificate " + in_folder("p.json"));
  EXPECT_EQ(none.code, 0);
  EXPECT_EQ(none.out,
            "2 placements, of which 0 have bodies that meet\n  no proofs are written, as nothing is known to meet\n");
  EXPECT_FALSE(std::filesystem::exists(in_folder("p.json")));
}

TEST_F(Placements, AreReadFromNpy) {
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2), }";
  header.resize(117, ' ');
  const std::string bytes = std::string("\x93NUMPY\1\0\x76\0", 10) + header + "\n" +
                            std::string("\0\0\xc0\xbf\0\0\xc0\x3f", 8) +
                            std::string("\0\0\xe0\xbf\0\0\xc0\x3f", 8);  // -1.5, 1.5; -1.75, 1.5
  write_text(in_folder("t.npy"), bytes);
  const Run done = run(arm + "--placements " + in_folder("t.npy") + " --joint-names panda_joint4,panda_joint6");
  EXPECT_EQ(done.out, "0: none meet\n1: none meet\n2 placements, of which 0 have bodies that meet\n");
  expect_bad(arm + "--placements " + in_folder("t.npy"), "has 2 columns, but there are 8 joints: panda_joint1, ");
  expect_bad(arm + "--placements " + in_folder("t.npy") + " --joint-names a", "has 2 columns, but there is 1 joint");
  expect_bad(arm + "--placements " + in_folder("t.npy") + " --joint-names elbow,panda_joint4", "joint 'elbow'");
}

TEST_F(Placements, SayWhatIsWrong) {
  const std::string given = table(10), call = arm + "--placements " + given;
  expect_bad("scene " + cube + " --placements " + given, "there is no robot to move");
  expect_bad(call + " --joint-names a", "names its joints itself");
  expect_bad(call + " --joints panda_joint1=0", "--joints");
  expect_bad(arm + "--first", "--placements");
  expect_bad(call + " --json --csv " + in_folder("l.csv"), "--json");
  expect_bad(call + " --csv " + given, "is the same file as");
  EXPECT_EQ(run(call + " --csv " + in_folder("l") + " --meeting-certificate " + in_folder("l")).code, 2);
  EXPECT_EQ(run(arm + " --meeting-certificate " + in_folder("l")).code, 2);
  EXPECT_EQ(run(call + " --csv " + in_folder("l") + " --json-lines " + in_folder("l")).code, 2);
  expect_bad(arm + "--json --placements " + table(10001), "10001 placements are too many");
  write_text(in_folder("t.csv"), "panda_joint1,elbow\n0,0\n");
  expect_bad(call, "joint 'elbow'");
  write_text(in_folder("t.csv"), "panda_joint1\n0\nx\n");
  expect_bad(call, "t.csv:3: joint 'panda_joint1': 'x' is not a number");
  // A pose that overflows, after lines that have been written.
  const std::string box = "<collision><geometry><box size='1 1 1'/></geometry></collision>";
  write_text(in_folder("r.urdf"), "<robot name='r'><link name='a'>" + box + "</link><link name='b'>" + box +
                                      "</link><joint name='j' type='prismatic'><parent link='a'/><child link='b'/>"
                                      "<origin xyz='1e308 0 0'/><axis xyz='1 0 0'/>"
                                      "<limit lower='0' upper='1e308'/></joint></robot>");
  std::string far = "j\n";
  for (int k = 0; k < 500; ++k) far += k == 400 ? "1e308\n" : "1\n";
  write_text(in_folder("t.csv"), far);
  for (const char* threads : {"1", "3"}) {
    const Run overflow = run("scene " + in_folder("r.urdf") + " --placements " + given + " --csv " +
                             in_folder("l.csv") + " --threads " + threads);
    EXPECT_EQ(overflow.code, 2);
    EXPECT_TRUE(overflow.err.starts_with("sunder: " + given + ":402: joint 'j'")) << overflow.err;
    EXPECT_FALSE(fs::exists(in_folder("l.csv")));
  }
  write_text(in_folder("t.csv"), "panda_joint1,panda_joint4,panda_joint6\n0,-1.5,1.5\n9,-1.5,1.5\n-9,-1.5,1.5\n");
  const Run beyond = run(call);
  EXPECT_EQ(beyond.code, 0);
  EXPECT_NE(beyond.err.find("2 values are out of the limits, asked about as they are; the first: "), std::string::npos);
  EXPECT_NE(beyond.err.find("t.csv:3: joint 'panda_joint1': 9 is not from -2.8973 to 2.8973"), std::string::npos);
}

}  // namespace

}  // namespace sunder::tests
