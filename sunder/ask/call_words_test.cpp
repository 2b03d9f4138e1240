// The words of calls: what is said of how a proof was made, and what is taken as a call that makes one.
#include <sunder/ask/call_words.h>

#include <sunder/base/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {
namespace {

using Words = std::vector<std::string>;

Verb verb_of(std::string_view name) {
  std::vector<Verb> all = verbs();
  return *std::find_if(all.begin(), all.end(), [&](const Verb& verb) { return verb.name == name; });
}

template <class Value>
void set(const Verb& verb, std::string_view option, Value value) {
  const auto found = std::find_if(verb.options.begin(), verb.options.end(), [&](const Option& o) {
    return o.name == option || o.name.ends_with("," + std::string(option));
  });
  *std::get<Value*>(found->value) = std::move(value);
}

TEST(CallWords, AreWhatChangesTheProof) {
  const Verb pair = verb_of("pair");
  set<std::string>(pair, "A", "a.obj");
  set<std::string>(pair, "B", "--b.obj");
  set<std::string>(pair, "--pose-b", "1, 2, 3");
  set<std::string>(pair, "--certificate", "somewhere/proof.json");
  set<std::string>(pair, "--svg", "picture.svg");
  set(pair, "--json", true);
  set(pair, "--distance", true);
  const Words words = words_of(pair);
  EXPECT_EQ(words, (Words{"pair", "--pose-b", "1, 2, 3", "--certificate", "-", "--distance", "a.obj", "--b.obj"}));
  EXPECT_EQ(call_text(words), "sunder pair --pose-b '1, 2, 3' --certificate - --distance a.obj --b.obj");
  EXPECT_EQ(call_text(Words{"it's", "", "\n"}), "sunder 'it'\\''s' '' '\\x0a'");

  const Verb polygons = verb_of("polygons");
  set<Words>(polygons, "FILE", {"--first.wkt", "second.wkt"});
  set<std::uint64_t>(polygons, "--svg-limit", 7);
  EXPECT_EQ(words_of(polygons), (Words{"polygons", "--", "--first.wkt", "second.wkt"}));
}

const std::string square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n", far = "POLYGON ((7 0, 8 0, 8 1, 7 0))\n";

std::string proof_of(const Words& words, const std::string& a = square, const std::string& b = far) {
  std::string proof;
  run_again(words, {{"a.wkt", &a}, {"b.wkt", &b}}, [&](const auto&, std::string_view text) { proof += text; });
  return proof;
}

TEST(CallWords, RunAgain) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::string proof = proof_of({"pair", "--certificate", "-", "a.wkt", "b.wkt"});
  EXPECT_EQ(proof, proof_of({"pair", "--certificate", "-", "a.wkt", "b.wkt"}));
  EXPECT_NE(proof, proof_of({"pair", "--certificate", "-", "b.wkt", "a.wkt"}));
  EXPECT_NE(proof, proof_of({"pair", "--certificate", "-", "a.wkt", "b.wkt"}, square, square));
  EXPECT_NE(proof, proof_of({"pair", "--pose-b", "2,0", "--certificate", "-", "a.wkt", "b.wkt"}));
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(proof.starts_with("{\"sunder_certificate\"")) << proof;
}

TEST(CallWords, NothingElseIsACall) {
  const auto refused = [](const Words& words, std::string_view part) {
    try {
      proof_of(words);
      ADD_FAILURE() << "taken: " << call_text(words);
    } catch (const Error& error) {
      EXPECT_NE(std::string_view(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  refused({}, "no such verb");
  refused({"frob"}, "no such verb");
  refused({"verify", "a.wkt"}, "no proof is asked for");
  refused({"pair", "a.wkt", "b.wkt"}, "no proof is asked for");
  refused({"pair", "--certificate", "stolen.json", "a.wkt", "b.wkt"}, "has a name");
  refused({"pair", "--certificate", "-", "--svg", "stolen.svg", "a.wkt", "b.wkt"}, "changes no proof");
  refused({"hull", "--out", "stolen.obj", "--certificate", "-", "a.wkt"}, "changes no proof");
  refused({"pair", "--certificate", "-", "--frob", "a.wkt", "b.wkt"}, "no option");
  refused({"pair", "--certificate", "-", "a.wkt"}, "B is missing");
  refused({"pair", "--certificate", "-", "a.wkt", "b.wkt", "c.wkt"}, "nothing is expected");
  refused({"pair", "--certificate"}, "a value is missing");
  refused({"pair", "--certificate", "-", "--certificate", "-", "a.wkt", "b.wkt"}, "given twice");
  refused({"scene", "--parted", "--certificate", "-", "a.wkt"}, "needs");
  refused({"polygons", "--any", "--all", "--certificate", "-", "a.wkt"}, "excludes");
  refused({"pair", "--certificate", "-", "a.wkt", "/etc/other.wkt"}, "none of the files");
}

}  // namespace
}  // namespace sunder::ask
