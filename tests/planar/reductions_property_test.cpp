// The reductions that Shamos and Hoey 1976 prove their lower bounds by, run: other problems are solved by asking ours.
//
//   Theorems 1, 3 and 8: are N numbers distinct? As points on a line, which are intervals, segments and circles: none
//   meet. Of segments there are crosses, too: segments of one height that meet nowhere but where their feet are one.
//   Theorems 9 and 13: N numbers in order. As half-planes above the tangents of the parabola y = x^2, whose slopes they
//   give: the sides of the common part come by slope. As discs of radius 1 about the points (x, x^2), |x| <= 1/4: the
//   parabola bends less sharply than a circle of radius 1, so each centre has a circle through it with all others
//   inside, whose centre is a point of that disc's arc: all have an arc, one, and these come as the centres do.
//
// Departure from the paper, whose lines are tangent to the unit circle: their offsets are irrational, and a rounded one
// may make a line redundant. Squares of floats are doubles. For the same reason what is sorted are floats, and what is
// told apart are doubles.
#include <sunder/base/random.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/segments/intervals_any.h>
#include <sunder/planar/segments/segments_any.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder::planar {
namespace {

enum class NumberFamily : std::uint8_t { any, near_one, few, last_bits, all_equal, any_scale };
constexpr int number_family_count = 6;

// Real is float or double. Of few numbers some are equal; those of last_bits are next to each other, or equal.
template <class Real>
std::vector<Real> random_numbers(NumberFamily family, std::size_t n, Random& random) {
  const Real start = static_cast<Real>(random.uniform(-2, 2));
  const auto make = [&]() -> Real {
    switch (family) {
      case NumberFamily::any: return static_cast<Real>(random.uniform(-1000, 1000));
      case NumberFamily::near_one: return static_cast<Real>(1 + random.uniform(-0x1p-12, 0x1p-12));
      case NumberFamily::few:
        return static_cast<Real>(random.between(-8, 8)) * (random.below(2) == 0 ? Real(1) : Real(-1));
      case NumberFamily::last_bits: {
        Real x = start;
        for (std::uint64_t steps = random.below(2 * n); steps > 0; --steps) {
          x = std::nextafter(x, std::numeric_limits<Real>::infinity());
        }
        return x;
      }
      case NumberFamily::all_equal: return start;
      case NumberFamily::any_scale: break;
    }
    const int exponent = std::numeric_limits<Real>::max_exponent - 3;
    return std::ldexp(static_cast<Real>(random.uniform(-1, 1)),
                      static_cast<int>(random.between(-exponent - 30, exponent)));
  };
  std::vector<Real> numbers(n);
  for (Real& x : numbers) x = make();
  return numbers;
}

// The same: made distinct in every second round of the families, and with a copy of one of them in the others.
std::vector<double> numbers_to_tell_apart(int run, Random& random) {
  const auto family = static_cast<NumberFamily>(run % number_family_count);
  std::vector<double> numbers = random_numbers<double>(family, 1 + random.below(24), random);
  if (run / number_family_count % 2 == 0) {
    const std::set<double> distinct(numbers.begin(), numbers.end());
    numbers.assign(distinct.begin(), distinct.end());
  } else {
    numbers.push_back(numbers[random.below(numbers.size())]);
  }
  for (std::size_t i = numbers.size(); i > 1; --i) std::swap(numbers[i - 1], numbers[random.below(i)]);
  return numbers;
}

template <class Found>
void expect_equal_numbers(const std::vector<double>& numbers, const Found& found, bool has_equal) {
  ASSERT_EQ(found.has_value(), has_equal);
  if (has_equal) {
    ASSERT_EQ(numbers[found->i], numbers[found->j]);
  }
}

// Asks of random numbers whether two are equal; `ask` is given them and whether two are.
template <class Ask>
void tell_apart(std::uint64_t own_seed, const Ask& ask) {
  const std::uint64_t seed = tests::chosen_seed(own_seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(6000);
  std::array<int, 2> hits{};
  for (int run = 0; run < runs; ++run) {
    const std::vector<double> numbers = numbers_to_tell_apart(run, random);
    const bool has_equal = std::set<double>(numbers.begin(), numbers.end()).size() < numbers.size();
    ASSERT_NO_FATAL_FAILURE(ask(numbers, has_equal)) << "run " << run;
    ++hits[has_equal ? 1 : 0];
  }
  for (const int n : hits) EXPECT_GE(n, runs / (2 * number_family_count) * number_family_count);
}

TEST(Reductions, ElementUniquenessByIntervals) {
  tell_apart(51, [](const std::vector<double>& numbers, bool has_equal) {
    std::vector<LineInterval> points;
    for (const double x : std::vector<double>(numbers.begin(), numbers.end())) points.push_back({x, x});
    expect_equal_numbers(numbers, intervals_any(points).found, has_equal);
  });
}

TEST(Reductions, ElementUniquenessBySegments) {
  tell_apart(52, [](const std::vector<double>& numbers, bool has_equal) {
    std::vector<Segment> points, upright;
    for (const double x : std::vector<double>(numbers.begin(), numbers.end())) {
      points.push_back({{x, 0}, {x, 0}});
      upright.push_back({{x, 0}, {x, 1}});
    }
    for (const auto method : {segments_any, segments_any_by_sweep, segments_any_by_grid}) {
      ASSERT_NO_FATAL_FAILURE(expect_equal_numbers(numbers, method(Segments(points), {}).found, has_equal));
      ASSERT_NO_FATAL_FAILURE(expect_equal_numbers(numbers, method(Segments(upright), {}).found, has_equal));
    }
  });
}

TEST(Reductions, ElementUniquenessByCircles) {
  tell_apart(53, [](const std::vector<double>& numbers, bool has_equal) {
    std::vector<Disc> points;
    for (const double x : std::vector<double>(numbers.begin(), numbers.end())) points.push_back({{x, 0}, 0});
    for (const auto method : {discs_any, discs_any_by_sweep, discs_any_by_grid}) {
      ASSERT_NO_FATAL_FAILURE(expect_equal_numbers(numbers, method(Discs(points), {}).found, has_equal));
    }
  });
}

// Sorts random floats; `sort` gives the distinct ones from the least on.
template <class Sort>
void sort_by(std::uint64_t own_seed, int full_count, const Sort& sort) {
  const std::uint64_t seed = tests::chosen_seed(own_seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(full_count);
  for (int run = 0; run < runs; ++run) {
    const auto family = static_cast<NumberFamily>(run % number_family_count);
    const std::vector<float> numbers = random_numbers<float>(family, 1 + random.below(24), random);
    ASSERT_NO_FATAL_FAILURE(sort(numbers)) << "run " << run;
  }
}

std::vector<float> in_order(std::vector<float> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

// With repetitions: the evidence names for each half-plane the two sides of which it is one.
TEST(Reductions, SortingByHalfPlanes) {
  sort_by(54, 3000, [](const std::vector<float>& numbers) {
    std::vector<Constraint> above;  // y >= 2 x0 x - x0^2
    for (const double x : std::vector<double>(numbers.begin(), numbers.end())) above.push_back({2 * x, -1, x * x});
    for (const auto method : {half_plane_intersection<Constraints>, half_plane_intersection_by_sort<Constraints>,
                              half_plane_intersection_by_division<Constraints>}) {
      const Region region = method(Constraints(above), {.evidence = true});
      ASSERT_EQ(region.kind, region.sides.size() == 1 ? RegionKind::half_plane : RegionKind::unbounded);
      std::vector<std::uint32_t> repeated(region.sides.size());
      ASSERT_EQ(region.cones.size(), numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i) {  // side p, or the next one
        const std::uint32_t p = region.cones[i];
        ++repeated[numbers[i] == numbers[region.sides[p]] ? p : p + 1];
      }
      std::vector<float> sorted;
      for (std::size_t k = 0; k < repeated.size(); ++k) {
        sorted.insert(sorted.end(), repeated[k], numbers[region.sides[k]]);
      }
      ASSERT_EQ(sorted, in_order(numbers));
    }
  });
}

TEST(Reductions, SortingByCircles) {
  sort_by(55, 1000, [](const std::vector<float>& numbers) {
    // All times a power of two, so that the greatest is at most 1/4: still exact, and so are the squares.
    double greatest = 0;
    for (const double x : std::vector<double>(numbers.begin(), numbers.end()))
      greatest = std::max(greatest, std::fabs(x));
    const int exponent = greatest == 0 ? 0 : -std::ilogb(greatest) - 3;
    std::vector<Disc> discs;
    for (const double number : std::vector<double>(numbers.begin(), numbers.end())) {
      const double x = std::ldexp(number, exponent);
      discs.push_back({{x, x * x}, 1});
    }
    const std::set<float> distinct(numbers.begin(), numbers.end());
    for (const auto method : {disc_intersection, disc_intersection_by_division}) {
      const DiscIntersection part = method(Discs(discs));
      ASSERT_EQ(part.kind, DiscIntersectionKind::region);
      std::vector<float> sorted;
      for (const std::uint32_t i : part.arcs) sorted.push_back(numbers[i]);
      std::rotate(sorted.begin(), std::min_element(sorted.begin(), sorted.end()), sorted.end());
      ASSERT_EQ(sorted, std::vector<float>(distinct.begin(), distinct.end()));
    }
  });
}

}  // namespace
}  // namespace sunder::planar
