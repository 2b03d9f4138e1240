#include <tests/support/half_space_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::tests {

using polytope::Polytope;

std::string_view name_of(HalfSpaceFamily family) {
  constexpr std::array<std::string_view, half_space_family_count> names{"grid", "concurrent", "few ways", "cube",
                                                                        "flat", "last bit",   "tangents", "scaled"};
  return names[static_cast<std::size_t>(family)];
}

HalfSpaceSet HalfSpaceSets::next(std::size_t most) {
  const auto family = static_cast<HalfSpaceFamily>(turn_++ % half_space_family_count);
  const std::size_t d = polytope::least_dimension + random_.below(5);
  return next(family, d, random_.below(most + 1));
}

HalfSpaceSet HalfSpaceSets::next(HalfSpaceFamily family, std::size_t d, std::size_t count) {
  using Row = std::vector<double>;
  std::vector<Row> rows;
  std::vector<double> center(d), objective(d);
  for (double& x : center) x = whole(2);
  const auto level = [&](const Row& row) {
    double sum = 0;
    for (std::size_t c = 0; c < d; ++c) sum += row[c] * center[c];
    return sum;
  };
  const auto some = [&](int size) {
    Row row(d + 1);
    for (std::size_t c = 0; c < d; ++c) row[c] = whole(size);
    return row;
  };
  std::vector<Row> ways;
  for (std::uint64_t k = random_.below(3) + 1; k-- > 0;) ways.push_back(some(1));
  if (family == HalfSpaceFamily::cube) {
    for (std::size_t c = 0; c < 2 * d; ++c) {
      Row row(d + 1);
      row[c / 2] = c % 2 == 0 ? 1 : -1;
      row[d] = 1;
      rows.push_back(std::move(row));
    }
  }
  while (rows.size() < count) {
    Row row = some(2);
    switch (family) {
      case HalfSpaceFamily::grid: row[d] = whole(2) + 1; break;
      case HalfSpaceFamily::concurrent: row[d] = level(row) + (random_.below(8) == 0 ? whole(1) : 0); break;
      case HalfSpaceFamily::few_ways: {
        const double side = random_.below(2) == 0 ? 1 : -1;
        row = ways[random_.below(ways.size())];
        for (double& x : row) x *= side;
        row[d] = level(row) + whole(2) + 1;
        break;
      }
      case HalfSpaceFamily::cube: {
        double sum = 0;
        for (std::size_t c = 0; c < d; ++c) sum += std::fabs(row[c]);
        row[d] = sum + static_cast<double>(random_.below(2));  // touches a corner, an edge, .., or is redundant
        break;
      }
      case HalfSpaceFamily::flat:
      case HalfSpaceFamily::last_bit: {
        row[d] = level(row);
        Row back;
        for (const double x : row) back.push_back(-x);
        if (family == HalfSpaceFamily::last_bit && random_.below(2) == 0) {
          for (double& x : row) x *= 0.1;
          for (std::size_t c = 0; c <= d; ++c) back[c] = -row[c];
          back[d] = std::nextafter(back[d], random_.below(3) == 0 ? -HUGE_VAL : HUGE_VAL);
        }
        rows.push_back(std::move(back));
        break;
      }
      case HalfSpaceFamily::tangents: {
        double square = 0;
        for (std::size_t c = 0; c < d; ++c) {
          row[c] = random_.uniform(-1, 1);
          square += row[c] * row[c];
        }
        row[d] = std::sqrt(square);
        break;
      }
      case HalfSpaceFamily::scaled: {
        row[d] = whole(2) + 1;
        const int power = static_cast<int>(random_.between(-900, 900));
        for (double& x : row) x = std::ldexp(x, power);
        break;
      }
    }
    rows.push_back(std::move(row));
  }
  // A direction of small whole numbers, of a row, or any.
  const std::uint64_t kind = random_.below(8);
  for (std::size_t c = 0; c < d; ++c) {
    objective[c] = kind == 0 ? 0 : kind < 4 ? whole(2) : kind == 7 ? random_.uniform(-1, 1) : 0;
  }
  if (kind >= 4 && kind < 7 && !rows.empty()) {
    const std::size_t sum = kind == 4 ? 1 : 2;
    for (std::size_t k = 0; k < sum; ++k) {
      const Row& row = rows[random_.below(rows.size())];
      for (std::size_t c = 0; c < d; ++c) objective[c] += row[c];
    }
  }
  std::vector<double> numbers;
  for (const Row& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
  return {family, Polytope::from_half_spaces(d, std::move(numbers)), std::move(objective)};
}

}  // namespace sunder::tests
