// Counted probes of what goes by the drums of two objects, p and q vertices of either from 8 to 100,000 independently:
// of IHH at most a constant times log2 p log2 q log2 (p + q) steps of an access (CD87, Theorem 13), of IHG at most a
// constant times log2 p log2 (p + q), p of the body (Theorem 10). On every family of hard bodies, at random, near
// contact and to the last bit. What the exact method finishes is counted apart, and its share is bounded.
#include <tests/support/near_contact.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;

// Of one question: the greatest ratios by sizes, families and placements.
class PairRatios {
 public:
  // column: what docs/images/plot_solid_probes.py knows it as.
  PairRatios(std::string_view question, std::string_view column, double most)
      : question_(question), column_(column), bound_(most) {}

  void add(std::string_view family, Placement placement, std::size_t p, std::size_t q, double of,
           const PairAnswer& answer) {
    Share& share = shares_[placement];
    ++share.asked;
    ++(answer.meet() ? meet_ : apart_);
    if (answer.decided_by == DecidedBy::finishing) {  // exact pivots more
      ++share.finished;
      return;
    }
    const double ratio = static_cast<double>(answer.cost.probes) / of;
    EXPECT_LE(ratio, bound_) << question_ << " " << family << ", p = " << p << ", q = " << q << ", "
                             << placement_names[static_cast<std::size_t>(placement)];
    const auto raise = [&](double& greatest) { greatest = std::max(greatest, ratio); };
    raise(by_size_[{p, q}]);
    raise(by_family_[{std::string(family), std::max(p, q)}]);
    raise(by_placement_[{std::string(family), placement}]);
    raise(greatest_);
    if (std::max(p, q) >= 1000 && std::max(p, q) <= 1100) raise(at_a_thousand_);
  }

  void print_and_check(bool is_of_many, const std::map<Placement, double>& most_finished) const {
    std::printf("%.*s: greatest %.2f, at 1,000 %.2f; %d apart, %d meet\n", static_cast<int>(question_.size()),
                question_.data(), greatest_, at_a_thousand_, apart_, meet_);
    std::printf("%-14s %7s %9.*s\n", "family", "n", static_cast<int>(column_.size()), column_.data());
    for (const auto& [key, ratio] : by_family_) {
      std::printf("%-14s %7zu %9.2f\n", key.first.c_str(), key.second, ratio);
    }
    for (const auto& [sizes, ratio] : by_size_)
      std::printf("p %6zu, q %6zu: %6.1f\n", sizes.first, sizes.second, ratio);
    for (const auto& [key, ratio] : by_placement_) {
      std::printf("%s, %s: %6.1f\n", key.first.c_str(), placement_names[static_cast<std::size_t>(key.second)].data(),
                  ratio);
    }
    for (const auto& [placement, share] : shares_) {
      const double part = share.finished / static_cast<double>(share.asked);
      std::printf("%s: %d of %d finished (%.2f %%)\n", placement_names[static_cast<std::size_t>(placement)].data(),
                  share.finished, share.asked, 100 * part);
      if (is_of_many) {
        EXPECT_LE(part, most_finished.at(placement)) << question_;
      }
    }
    if (is_of_many) {
      EXPECT_LE(bound_, 1.5 * at_a_thousand_) << question_;
    }
    EXPECT_GT(apart_, meet_ / 4) << question_;
    EXPECT_GT(meet_, apart_ / 10) << question_;
  }

 private:
  struct Share {
    int asked = 0, finished = 0;
  };
  std::string_view question_, column_;
  double bound_, greatest_ = 0, at_a_thousand_ = 0;
  int apart_ = 0, meet_ = 0;
  std::map<Placement, Share> shares_;
  std::map<std::pair<std::size_t, std::size_t>, double> by_size_;
  std::map<std::pair<std::string, std::size_t>, double> by_family_;
  std::map<std::pair<std::string, Placement>, double> by_placement_;
};

std::uint32_t steps_of_drums(const ConvexPolyhedron& body) {
  return solid::represent::of<solid::Drums>(body).steps_of_access();
}
double log2_of(std::size_t n) { return std::log2(static_cast<double>(n)); }

constexpr std::array<Placement, 5> all_placements{Placement::random, Placement::near, Placement::last_bit,
                                                  Placement::tilted, Placement::touching};

std::vector<std::size_t> sizes_of(bool all) {
  return all ? std::vector<std::size_t>{8, 30, 100, 1000, 10000, 100000} : std::vector<std::size_t>{8, 30, 100, 1000};
}

// The largest bodies only of families whose ratios are great, unless much is asked for.
bool goes_to(std::string_view family, std::size_t n) {
  constexpr std::array<std::string_view, 6> hard{"sphere", "wedge", "moment curve", "helix", "saddle", "needle"};
  return n < 100000 || scaled_count(10) > 10 || std::find(hard.begin(), hard.end(), family) != hard.end();
}

TEST(SolidPairByDrumsComplexity, ProbesOfTwoBodiesGrowAsTheProductOfThreeLogarithms) {
  const bool is_of_many = !is_scaled_down();
  const std::uint64_t seed = chosen_seed(20261130);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const std::vector<std::size_t> sizes = sizes_of(is_of_many);
  PairRatios bodies("two bodies", "bodies", 140);
  std::vector<ConvexPolyhedron> spheres;
  for (const std::size_t n : sizes) spheres.emplace_back(solid_shapes::sphere(n, random));
  for (const SolidShape& shape : all_solid_shapes()) {
    if (shape.name == "flat") continue;
    const bool is_needle = shape.name == "needle";
    std::vector<ConvexPolyhedron> some;
    for (const std::size_t n : sizes) {
      if (goes_to(shape.name, n)) some.emplace_back(shape.make(n, random));
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      for (std::size_t j = 0; j < some.size(); ++j) {
        const std::size_t n = std::max(sizes[i], sizes[j]);
        if (n == 100000 && sizes[i] != 8 && sizes[j] != 8 && i != j) continue;
        const auto times = static_cast<std::size_t>(scaled_count(n == 1000 ? 16 : n < 1000 ? 4 : 1));
        for (const Placement placement : all_placements) {
          for (std::size_t k = 0; k < times; ++k) {
            const ConvexPolyhedron& a = some[i];
            const ConvexPolyhedron& b = placement == Placement::touching    ? a
                                        : is_needle || (k + i + j) % 2 == 0 ? some[j]
                                                                            : spheres[j];
            const std::size_t p = a.vertices().size(), q = b.vertices().size();
            const double of = log2_of(p) * log2_of(q) * log2_of(p + q) * std::max(steps_of_drums(a), steps_of_drums(b));
            for (const PlacedPair& at : places_of(placement, a, b, is_needle, random)) {
              bodies.add(shape.name, placement, p, q, of, polyhedron_polyhedron_by_drums(a, at.a, b, at.b));
            }
          }
        }
      }
    }
  }
  bodies.print_and_check(is_of_many, {{Placement::random, 0.02},
                                      {Placement::near, 0.04},
                                      {Placement::last_bit, 0.1},
                                      {Placement::tilted, 0.1},
                                      {Placement::touching, 0.03}});
}

ConvexPolyhedron polygon_of_corners(std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 p = on_circle(static_cast<double>(k) / static_cast<double>(n));
    points.push_back({p.x, p.y, 0});
  }
  return ConvexPolyhedron(points);
}

TEST(SolidPairByDrumsComplexity, ProbesOfABodyAndAPolygonGrowAsTheProductOfTwoLogarithms) {
  const bool is_of_many = !is_scaled_down();
  const std::uint64_t seed = chosen_seed(20261132);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const std::vector<std::size_t> sizes = sizes_of(is_of_many);
  PairRatios polygons("body and polygon", "polygon", 75);
  std::vector<ConvexPolyhedron> flats;
  for (const std::size_t n : sizes) flats.push_back(polygon_of_corners(n));
  for (const SolidShape& shape : all_solid_shapes()) {
    if (shape.name == "flat" || shape.name == "needle") continue;  // a polygon turned beside a needle is a needle too
    for (const std::size_t n : sizes) {
      if (!goes_to(shape.name, n)) continue;
      const ConvexPolyhedron a(shape.make(n, random));
      for (const ConvexPolyhedron& b : flats) {
        const std::size_t p = a.vertices().size(), q = b.vertices().size(), most = std::max(p, q);
        const auto times = static_cast<std::size_t>(scaled_count(most == 1000 ? 16 : most < 1000 ? 4 : 1));
        const double of = log2_of(p) * log2_of(p + q) * steps_of_drums(a);
        for (const Placement placement : {Placement::random, Placement::near, Placement::last_bit, Placement::tilted}) {
          for (std::size_t k = 0; k < times; ++k) {
            for (const PlacedPair& at : places_of(placement, a, b, false, random)) {
              polygons.add(shape.name, placement, p, q, of, polyhedron_polygon_by_drums(a, at.a, b, at.b));
            }
          }
        }
      }
    }
  }
  polygons.print_and_check(
      is_of_many,
      {{Placement::random, 0.01}, {Placement::near, 0.01}, {Placement::last_bit, 0.01}, {Placement::tilted, 0.01}});
}

}  // namespace
}  // namespace sunder::tests
