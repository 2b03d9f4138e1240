// Writes a sample of certificate files, for checkers other than the library's: round_certificate_sample FOLDER COUNT
// [SEED].
//
// Every family of tests/support/round_pairs.h in turn, fifty pairs a file, of bodies with a radius: whether they meet,
// touch or overlap. What is undecided is left out. The last line printed says how many.
#include <sunder/solid/round/round_claims.h>
#include <tests/support/round_pairs.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

int main(int argc, char** argv) {
  using namespace sunder;
  if (argc < 3) {
    std::fprintf(stderr, "usage: round_certificate_sample FOLDER COUNT [SEED]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int count = std::atoi(argv[2]);
  tests::RoundPairs pairs(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  std::filesystem::create_directories(folder);
  int meets = 0, undecided = 0, files = 0;
  for (int i = 0; i < count;) {
    std::ofstream file(folder / ("round_" + std::to_string(files++) + ".json"), std::ios::binary);
    ClaimsWriter claims([&](std::string_view text) { file << text; });
    PairClaims written(claims);
    struct Written {
      tests::RoundCase of;
      std::unique_ptr<solid::PlacedRound> a, b;
      std::uint32_t index_a, index_b;
    };
    std::vector<std::unique_ptr<Written>> all;
    for (int k = 0; k < 50 && i < count; ++k) {
      const std::string name = std::to_string(i++);
      auto one = std::make_unique<Written>(Written{pairs.next(), nullptr, nullptr, 0, 0});
      one->a = std::make_unique<solid::PlacedRound>(one->of.a, one->of.pose_a);
      one->b = std::make_unique<solid::PlacedRound>(one->of.b, one->of.pose_b);
      one->index_a = add_round(written, name + " a", *one->a);
      one->index_b = add_round(written, name + " b", *one->b);
      all.push_back(std::move(one));
    }
    for (const auto& one : all) {
      const auto answer = round_round(one->of.a, one->of.pose_a, one->of.b, one->of.pose_b);
      meets += answer.meet();
      undecided += answer.undecided();
      if (answer.undecided()) continue;
      add_claims(written, one->index_a, *one->a, one->index_b, *one->b, answer.evidence,
                 round_round_contact(*one->a, *one->b, answer.evidence));
    }
    written.end();
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", folder.c_str());
      return 2;
    }
  }
  std::printf("%d pairs with a radius, %d of them meet, %d undecided, in %d files\n", count, meets, undecided, files);
  return 0;
}
