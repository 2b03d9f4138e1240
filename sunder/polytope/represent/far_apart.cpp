#include <sunder/polytope/represent/far_apart.h>
#include <sunder/predicate/filter/along_columns.h>

#include <algorithm>
#include <array>

namespace sunder::polytope {

std::vector<std::uint32_t> far_apart(std::size_t d, std::vector<double> points, std::optional<std::uint32_t> first,
                                     double least) {
  const auto count = static_cast<std::uint32_t>(points.size() / d);
  std::vector<std::uint32_t> result;
  for (std::size_t turn = 0; turn <= d; ++turn) {
    std::uint32_t next = first.value_or(0);
    double greatest = -1;
    for (std::uint32_t i = 0; i < count && (turn > 0 || !first); ++i) {
      double square = 0;
      for (std::size_t c = 0; c < d; ++c) square += points[i * d + c] * points[i * d + c];
      if (square > greatest) {
        greatest = square;
        next = i;
      }
    }
    if (turn > 0 && !(greatest > least)) break;
    if (std::find(result.begin(), result.end(), next) != result.end()) break;
    result.push_back(next);
    std::array<double, most_columns> axis{};
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(next * d), d, axis.begin());
    for (std::uint32_t i = 0; i < count; ++i) {
      double along = 1;  // the first point becomes the origin, the others lose their part along the axis
      if (turn > 0) {
        along = 0;
        for (std::size_t c = 0; c < d; ++c) along += points[i * d + c] * axis[c] / greatest;
      }
      for (std::size_t c = 0; c < d; ++c) points[i * d + c] -= along * axis[c];
    }
  }
  return result;
}

}  // namespace sunder::polytope
