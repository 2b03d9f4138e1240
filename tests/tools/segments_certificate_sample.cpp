// Writes a sample of certificate files about sets of segments, for checkers other than the library's:
// segments_certificate_sample FOLDER COUNT [SEED].
//
// Every family of tests/support/segment_sets.h in turn, under every rule, a set each; every second one with groups. In
// turn: does any pair meet, which, how many.
#include <sunder/planar/segments/segments_claims.h>
#include <tests/support/segment_sets.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  using namespace sunder;
  if (argc < 3) {
    std::fprintf(stderr, "usage: segments_certificate_sample FOLDER COUNT [SEED]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int count = std::atoi(argv[2]);
  tests::SegmentSets sets(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  std::filesystem::create_directories(folder);
  int meets = 0;
  std::size_t crossings = 0;
  for (int i = 0; i < count; ++i) {
    const planar::Segments segments(sets.next().segments);
    const Allowed allowed = i % 3 == 0 ? Allowed::nothing : i % 3 == 1 ? Allowed::shared_endpoint : Allowed::touch;
    std::vector<std::uint32_t> groups;
    const std::uint64_t group_count = 1 + sets.random().below(3);
    for (std::uint32_t k = 0; i % 2 == 1 && k < segments.size(); ++k) {
      groups.push_back(static_cast<std::uint32_t>(sets.random().below(group_count)));
    }
    const SetOptions options{allowed, groups, nullptr};
    std::ofstream file(folder / ("segments_" + std::to_string(i) + ".json"), std::ios::binary);
    const auto write = [&](const auto& answer) {
      crossings +=
          static_cast<std::size_t>(std::ranges::count(planar::sweep_events(segments)->at, planar::at_crossing));
      file << planar::certificate_text(segments, allowed, answer, groups);
    };
    if (i / 6 % 3 == 0) {
      const planar::SegmentsAnswer answer = planar::segments_any(segments, options);
      meets += answer.meet();
      write(answer);
    } else if (i / 6 % 3 == 1) {
      write(planar::segments_all(segments, options));
    } else {
      write(planar::segments_count(segments, options));
    }
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", folder.c_str());
      return 2;
    }
  }
  std::printf("%d certificates of sets of segments, some meet in %d; %zu crossings\n", count, meets, crossings);
  return 0;
}
