#include <sunder/certificate/claims.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace sunder {
namespace {

TEST(ClaimsWriter, WritesTheFileInItsOrder) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_input("a \"b\"\n.csv", "00ff");
  file.add_left_out("1 point of line 2");
  file.add_left_out(std::string(5000, 'x'));
  file.begin_table("segments");
  file.add_row(std::array{0.0, -1.5, 2.0, 0x1p-1074});
  file.add_row(std::array{1.0, 1.0, 1.0, 1.0});
  file.end_table();
  file.begin_statement("segments");
  file.indices("groups", std::array<std::uint32_t, 2>{7, no_entry});
  file.text("verdict", "none");
  file.number("number", 12345678901u);
  file.begin_claims();
  file.begin_claim("none_counts");
  file.begin_list("events");
  file.add_list(std::array<std::uint32_t, 3>{0, no_entry, 0});
  file.add_null();
  file.add_contact(1, 2, "inside");
  file.add_weight(3, Dyadic(0.75));
  file.add_fractions_and_index(std::array{Dyadic(1.0), Dyadic(2.0)}, 4.0, 5);
  file.end_list();
  file.fractions("point", std::array{Dyadic(1.0)}, 3.0);
  file.end_claim();
  file.end_statement();
  file.end();
  EXPECT_EQ(
      text,
      "{\"sunder_certificate\": 3,\n"
      " \"inputs\": [\n  {\"name\": \"a \\\"b\\\"\\u000a.csv\", \"sha256\": \"00ff\"}],\n"
      " \"call\": [],\n"
      " \"left_out\": [\n  \"1 point of line 2\",\n  \"" +
          std::string(3997, 'x') +
          "...\"],\n"
          " \"tables\": {\n  \"segments\": [\n  [\"0x0p+0\",\"-0x1.8p+0\",\"0x1p+1\",\"0x0.0000000000001p-1022\"],\n"
          "  [\"0x1p+0\",\"0x1p+0\",\"0x1p+0\",\"0x1p+0\"]]},\n"
          " \"statements\": [\n  {\"question\": \"segments\", \"groups\": [7,-1], \"verdict\": \"none\", \"number\": "
          "12345678901, "
          "\"claims\": [\n  {\"claim\": \"none_counts\", \"events\": [[0,-1,0], null, [1,2,\"inside\"], [3, "
          "\"0x3p-2\"], "
          "[[\"1/4\",\"1/2\"], 5]], \"point\": [\"1/3\"]}]}]}\n");
}

TEST(ClaimsWriter, WritesWhatIsSaid) {
  const Said lines = Said::all(Said::Source::lines, 0, "layer 1", {"1 point"}).dropped("z");
  const std::string text = claims_text(
      {{{"a.csv", "00ff"}}, {}, {"segments", "a.csv"}, {{"segments", {{1, lines}, {2, Said::given("0,0,1,1")}}}}},
      [](ClaimsWriter& file) {
        file.begin_table("bodies");
        file.say(Said::all(Said::Source::vertices, 0).scaled(std::array{0.5, 2.0}).hull());
        file.begin_entry();
        file.text("name", "said");
        file.end_entry();
        file.begin_entry();
        file.text("name", "not said");
        file.end_entry();
        file.end_table();
        file.note(SaidNote::joint_values({{"j", 0.5}}, 7, 0));
        file.note(SaidNote::allowed({{"Never", 2}, {"Adjacent", 1}}));
        for (int k = 0; k < 2; ++k) {
          file.begin_statement("bodies");
          file.begin_claims();
          file.end_statement();
        }
      });
  EXPECT_EQ(
      text,
      "{\"sunder_certificate\": 3,\n \"inputs\": [\n  {\"name\": \"a.csv\", \"sha256\": \"00ff\"}],\n"
      " \"call\": [\"segments\", \"a.csv\"],\n \"left_out\": [],\n \"said\": {\n  \"segments\": [[1, {\"is\": "
      "\"dropped\", \"axis\": \"z\", \"of\": {\"is\": \"lines\", \"input\": 0, \"part\": \"layer 1\", \"without\": "
      "[\"1 point\"]}}],[2, {\"is\": \"given\", \"text\": \"0,0,1,1\"}]]},\n \"tables\": {\n  \"bodies\": [\n  "
      "{\"said\": {\"is\": \"hull\", \"of\": {\"is\": \"scaled\", \"by\": [\"0x1p-1\", \"0x1p+1\"], \"of\": {\"is\": "
      "\"vertices\", \"input\": 0, \"part\": null, \"without\": []}}}, \"name\": \"said\"},\n  {\"name\": \"not "
      "said\"}]},\n \"statements\": [\n  {\"question\": \"bodies\", \"said\": [{\"is\": \"joint_values\", \"values\": "
      "[[\"j\", \"0x1p-1\"]], \"row\": 7, \"from\": 0}, {\"is\": \"allowed\", \"pairs\": [[\"Never\", 2], "
      "[\"Adjacent\", 1]]}], \"claims\": []},\n  {\"question\": \"bodies\", \"claims\": []}]}\n");
}

// Long files are given away piece by piece, and none of them is lost.
TEST(ClaimsWriter, GivesAwayWhatIsWritten) {
  std::size_t pieces = 0, longest = 0, size = 0;
  ClaimsWriter file([&](std::string_view piece) {
    ++pieces;
    longest = std::max(longest, piece.size());
    size += piece.size();
  });
  file.begin_table("segments");
  for (int i = 0; i < 100000; ++i) file.add_row(std::array{1.0, 1.0, 1.0, 1.0});
  file.end_table();
  file.end();
  EXPECT_GT(pieces, 10u);
  EXPECT_LT(longest, 70000u);
  EXPECT_GT(size, 3000000u);
}

}  // namespace
}  // namespace sunder
