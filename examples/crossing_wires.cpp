// Wires of three nets: which of different nets meet, and how? Prints them, and a proof that these are all.
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_claims.h>

#include <cstdint>
#include <iostream>
#include <vector>

int main() {
  const std::vector<std::uint32_t> nets{0, 0, 1, 1, 2};
  const sunder::planar::Segments wires({
      {{0, 0}, {4, 0}},
      {{4, 0}, {4, 3}},  // net 0: a bend, which counts for nothing
      {{1, -1}, {1, 2}},
      {{1, 2}, {3, 0}},  // net 1: crosses net 0, and ends on it
      {{5, 5}, {6, 6}},
  });
  sunder::SetOptions options;
  options.groups = nets;
  const auto answer = sunder::planar::segments_all(wires, options);
  for (const auto& [i, j, kind] : answer.found) {
    const auto at = sunder::planar::common_point_rounded(wires[i], wires[j]);
    std::cout << "wires " << i << " and " << j << ": " << name_of(kind) << " at " << at.x << ", " << at.y << '\n';
  }
  std::cout << certificate_text(wires, options.allowed, answer, nets);
  return answer.found.size() == 2 ? 0 : 1;
}
