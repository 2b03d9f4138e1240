#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace sunder::ask {
namespace {

namespace fs = std::filesystem;

Report some_report() {
  Report report{.verb = "pair", .answer = "meet", .code = exit_code::yes};
  report.notes = {"a note"};
  report.tell("a and b: meet\n");
  report.add("evidence", {{"point", {1, 2}}}, titled("evidence", "a common point"));
  report.add("count", 3);
  report.not_proved = {"the area"};
  return report;
}

TEST(Report, IsRenderedAsTextAndAsJson) {
  Report report = some_report();
  EXPECT_EQ(text_of(report), "a and b: meet\n  evidence    a common point\n");
  EXPECT_EQ(json_of(report).on_one_line(),
            R"({"sunder": 1, "verb": "pair", "answer": "meet", "method": null, "function": null, "decided_by": null, )"
            R"("cost": null, "objects": [], "notes": ["a note"], "evidence": {"point": [1, 2]}, "count": 3})");
  report.is_proved = true;
  report.proof = "p.json";
  report.cost_text = "1 probe";
  EXPECT_EQ(text_of(report),
            "a and b: meet\n  evidence    a common point\n  cost        1 probe\n  proof       p.json\n"
            "  not proved  the area\n");
  EXPECT_EQ(json_of(report)["not_proved"].on_one_line(), R"(["the area"])");
}

TEST(Talk, TellsWhatIsWanted) {
  std::string out, notes;
  Talk talk(
      {.out = [&](std::string_view text) { out += text; }, .note = [&](std::string_view text) { notes += text; }});
  EXPECT_FALSE(talk.is_output_in_use());
  talk.note("one\ntwo");
  EXPECT_EQ(notes, "one\\x0atwo");
  talk.print_for_people("a\x1b[0m\nb\n");
  EXPECT_EQ(out, "a\\x1b[0m\nb\n");
  EXPECT_TRUE(talk.is_output_in_use());
  talk.be_quiet();
  talk.print_for_people("c");
  talk.note("three");
  EXPECT_EQ(out, "a\\x1b[0m\nb\n");
  EXPECT_EQ(notes, "one\\x0atwo");
  EXPECT_EQ(talk.notes().size(), 2u);
  EXPECT_FALSE(talk.progress("reading"));
  Talk nobody{Sinks{}};
  nobody.print("a");
  nobody.note("b");
  nobody.complain("c");
}

// What a call of a verb tells, and the files that it would write.
struct Answered {
  Report report;
  std::string out;
  std::map<std::string, std::string> files;
};

Answered answered(std::string_view name, const std::map<std::string, std::string>& values) {
  std::vector<Verb> all = verbs();
  const auto verb = std::find_if(all.begin(), all.end(), [&](const Verb& v) { return v.name == name; });
  for (const Option& option : verb->options) {
    const auto value = values.find(option.name);
    if (value == values.end()) continue;
    if (auto* const* flag = std::get_if<bool*>(&option.value)) **flag = true;
    if (auto* const* text = std::get_if<std::string*>(&option.value)) **text = value->second;
    if (auto* const* list = std::get_if<std::vector<std::string>*>(&option.value)) (*list)->push_back(value->second);
  }
  Answered result;
  Talk talk({.out = [&](std::string_view text) { result.out += text; },
             .file = [&](const fs::path& file) -> TextSink {
               return [&, file](std::string_view text) { result.files[file.string()] += text; };
             }});
  result.report = run_call(*verb, talk);
  return result;
}

class Called : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / "sunder_ask_report_test";
    fs::create_directories(folder_);
    std::ofstream(folder_ / "circles.csv") << "x,y,r,name\n0,0,1,wheel\n1,0,1,axle\n";
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string file(const char* name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

// A word of the input, and a word that ask makes, are in all that is made of the answer.
TEST_F(Called, OneAnswerInAllItsForms) {
  std::map<std::string, std::string> call{
      {"FILE", file("circles.csv")}, {"--all", ""},     {"--csv", "c"}, {"--geojson", "g"}, {"--svg", "s"},
      {"--certificate", "p"},        {"--name", "name"}};
  Answered people = answered("circles", call);
  call["--json"] = "";
  Answered json = answered("circles", call);
  EXPECT_EQ(people.report.code, exit_code::yes);
  EXPECT_TRUE(people.report.is_told);
  EXPECT_EQ(people.files, json.files);
  ASSERT_EQ(people.files.size(), 4u);
  std::vector<std::string> forms{people.out, json.out};
  for (const auto& [name, text] : people.files) forms.push_back(text);
  for (const std::string& form : forms) EXPECT_NE(form.find("overlapping"), std::string::npos) << form;
  forms.erase(std::find_if(forms.begin(), forms.end(), [](const std::string& form) {
    return form.find("sunder_certificate") != std::string::npos;  // which numbers members
  }));
  for (const std::string& form : forms) EXPECT_NE(form.find("wheel"), std::string::npos) << form;
  EXPECT_TRUE(fs::is_empty(folder_) || std::distance(fs::directory_iterator(folder_), {}) == 1) << "a file was made";
}

TEST_F(Called, AtOnceOnSeveralThreads) {
  const std::map<std::string, std::string> call{{"FILE", file("circles.csv")}, {"--json", ""}, {"--certificate", "p"}};
  const Answered alone = answered("circles", call);
  std::array<Answered, 4> all;
  std::vector<std::thread> threads;
  for (Answered& one : all) {
    threads.emplace_back([&] {
      for (int k = 0; k < 20; ++k) one = answered("circles", call);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Answered& one : all) {
    EXPECT_EQ(one.out, alone.out);
    EXPECT_EQ(one.files, alone.files);
  }
}

}  // namespace
}  // namespace sunder::ask
