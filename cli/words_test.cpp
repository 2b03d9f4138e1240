#include <cli/words.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sunder::cli {
namespace {

TEST(Words, EditsBetweenThem) {
  EXPECT_EQ(edits_between("", ""), 0u);
  EXPECT_EQ(edits_between("", "pair"), 4u);
  EXPECT_EQ(edits_between("pair", "pair"), 0u);
  EXPECT_EQ(edits_between("piar", "pair"), 1u);   // swapped
  EXPECT_EQ(edits_between("pars", "pairs"), 1u);  // left out
  EXPECT_EQ(edits_between("paiir", "pair"), 1u);  // put in
  EXPECT_EQ(edits_between("bair", "pair"), 1u);   // changed
  EXPECT_EQ(edits_between("ca", "abc"), 3u);      // what was swapped is not changed again
  EXPECT_EQ(edits_between("kernel", "colonel"), 4u);
}

TEST(Words, TheNearest) {
  const std::vector<std::string> words{"pair", "polygons", "region", "--json", "--group", "--geojson"};
  const auto nearest = [&](const char* word) { return nearest_word(word, words); };
  EXPECT_EQ(nearest("apir"), "pair");
  EXPECT_EQ(nearest("polygno"), "polygons");
  EXPECT_EQ(nearest("regions"), "region");
  EXPECT_EQ(nearest("--jsno"), "--json");
  EXPECT_EQ(nearest("--geo"), "--geojson");  // its beginning
  EXPECT_EQ(nearest("--g"), "");             // of two
  EXPECT_EQ(nearest("p"), "");
  EXPECT_EQ(nearest("ab"), "");
  EXPECT_EQ(nearest(""), "");
  EXPECT_EQ(nearest("--frob"), "");
  EXPECT_EQ(did_you_mean("parr", words), "; did you mean pair?");
  EXPECT_EQ(did_you_mean("frob", words), "");
}

}  // namespace
}  // namespace sunder::cli
