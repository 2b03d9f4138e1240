#include <tests/support/scale.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

constexpr std::array<Point3, 5> directions{{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {1, 2, 3}, {0x1p-600, 0x1p-601, 0}}};

ConvexPolyhedron body_of(const tests::SolidShape& shape, std::size_t n) {
  Random random(n);
  return ConvexPolyhedron(shape.make(n, random));
}

// Is w higher than v? In numbers that hold the heights exactly for the directions above, or nearly: long double, and
// only for bodies where that is sure.
long double height(const Point3& d, const Point3& v) {
  const auto product = [](double a, double b) { return static_cast<long double>(a) * static_cast<long double>(b); };
  return product(d.x, v.x) + product(d.y, v.y) + product(d.z, v.z);
}

// The facet on whose border one goes from v to w, counter-clockwise seen from outside.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> facets_by_border(const ConvexPolyhedron& body) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> result;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto facet = body.facet(f);
    for (std::size_t k = 0; k < facet.size(); ++k) result[{facet[k], facet[(k + 1) % facet.size()]}] = f;
  }
  return result;
}

// Each drum against its definition: who crosses it, and that neighbours share their facet in the right sense.
void expect_drums(const ConvexPolyhedron& body, const Drums& drums) {
  const auto facet_of = facets_by_border(body);
  const auto slice_of = [&](std::uint32_t v) {
    std::uint32_t slice = 0;
    while (slice < drums.slice_count() && height(drums.direction(), body.vertices()[drums.vertex_of(slice)]) !=
                                              height(drums.direction(), body.vertices()[v])) {
      ++slice;
    }
    return slice;
  };
  for (std::uint32_t slice = 1; slice < drums.slice_count(); ++slice) {
    ASSERT_LT(height(drums.direction(), body.vertices()[drums.vertex_of(slice - 1)]),
              height(drums.direction(), body.vertices()[drums.vertex_of(slice)]));
  }
  std::vector<std::uint32_t> sizes(drums.drum_count());
  for (const auto& [edge, f] : facet_of) {
    const std::uint32_t from = slice_of(edge.first), to = slice_of(edge.second);
    ASSERT_LT(std::max(from, to), drums.slice_count());
    for (std::uint32_t drum = from; drum < to; ++drum) ++sizes[drum];
  }
  for (std::uint32_t drum = 0; drum < drums.drum_count(); ++drum) {
    ASSERT_EQ(drums.size(drum), sizes[drum]);
    for (std::uint32_t k = 0; k < drums.size(drum); ++k) {
      const LateralEdge &e = drums.edge(drum, k), &next = drums.edge(drum, (k + 1) % drums.size(drum));
      ASSERT_EQ(slice_of(e.low), e.begin);
      ASSERT_EQ(slice_of(e.high), e.end);
      ASSERT_TRUE(e.begin <= drum && drum < e.end);
      ASSERT_EQ(facet_of.at({e.high, e.low}), e.side);
      ASSERT_EQ(facet_of.at({next.low, next.high}), e.side);
    }
  }
}

TEST(Drums, EveryFamilyAlongEveryDirection) {
  std::size_t drums_seen = 0;
  for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
    if (shape.name == "needle") continue;  // heights beyond long doubles; see SmallWholeNumbers and SameInBothForms
    for (const std::size_t n : {8u, 9u, 20u, 60u}) {
      const ConvexPolyhedron body = body_of(shape, n);
      for (const Point3& direction : directions) {
        if (direction.z == 3 && shape.name != "grid" && shape.name != "bipyramid") continue;  // the same
        for (const DrumsForm form : {DrumsForm::listed, DrumsForm::persistent}) {
          SCOPED_TRACE(std::string(shape.name) + " " + std::to_string(n));
          const Drums drums(body, direction, form);
          if (direction.x != 0x1p-600) expect_drums(body, drums);
          drums_seen += drums.drum_count();
          if (HasFatalFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(drums_seen, 5000u);
}

// Many vertices at one height, level facets, edges and tips, bodies of every dimension.
TEST(Drums, SmallWholeNumbers) {
  Random random(11);
  std::array<int, 4> dimensions{};
  const int count = tests::scaled_count(3000, 600);
  for (int round = 0; round < count; ++round) {
    std::vector<Point3> points;
    const std::int64_t side = random.between(1, 4);
    for (std::int64_t i = random.between(1, 20); i > 0; --i) {
      const auto number = [&] { return static_cast<double>(random.between(0, side)); };
      points.push_back({number(), number(), round % 5 == 0 ? 1 : number()});
    }
    const ConvexPolyhedron body(points);
    ++dimensions[static_cast<std::size_t>(body.dimension())];
    const Point3 direction = directions[random.below(4)];
    for (const DrumsForm form : {DrumsForm::listed, DrumsForm::persistent}) {
      const Drums drums(body, direction, form);
      if (body.dimension() >= 2) expect_drums(body, drums);
      if (body.dimension() == 1 && drums.drum_count() == 1) {
        EXPECT_EQ(drums.size(0), 1u);
      }
      if (HasFatalFailure()) return;
    }
  }
  for (const int of_dimension : dimensions) EXPECT_GT(of_dimension, count / 150);
}

TEST(Drums, SameInBothFormsAndSmallInOne) {
  for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
    for (const std::size_t n : {100u, 1000u, 4000u}) {
      if (n > 1000 && tests::is_scaled_down()) continue;
      const ConvexPolyhedron body = body_of(shape, n);
      const auto vertices = static_cast<double>(body.vertices().size());
      const Drums persistent(body, {0, 0, 1}, DrumsForm::persistent);
      if (n <= 1000) {
        EXPECT_EQ(represent::of<Drums>(body).form(), DrumsForm::listed) << shape.name;
      }
      EXPECT_LE(static_cast<double>(persistent.memory()), 64 * vertices * std::log2(vertices))
          << shape.name << " " << n;
      EXPECT_LE(persistent.steps_of_access(), 2 * std::log2(vertices));
      const Drums listed(body, {0, 0, 1}, DrumsForm::listed);
      ASSERT_EQ(persistent.drum_count(), listed.drum_count());
      for (std::uint32_t drum = 0; drum < listed.drum_count(); ++drum) {
        ASSERT_EQ(persistent.size(drum), listed.size(drum));
        const std::uint32_t step = n == 4000 || (n == 1000 && tests::is_scaled_down()) ? 97 : 1;
        for (std::uint32_t k = 0; k < listed.size(drum); k += step) {
          ASSERT_EQ(&persistent.edge(drum, k) - &persistent.edge(0, 0), &listed.edge(drum, k) - &listed.edge(0, 0));
        }
      }
    }
  }
}

TEST(Drums, Refused) {
  const ConvexPolyhedron body(std::array{Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}});
  EXPECT_THROW(Drums(body, {0, 0, 0}, DrumsForm::persistent), Error);
  EXPECT_THROW(Drums(body, {0, std::nan(""), 0}, DrumsForm::persistent), Error);
}

// Two helices about one axis have n^2 / 2 edges in all their drums; so a body of 40,000 vertices is too much for lists.
TEST(Drums, ListsThatAreTooLong) {
  std::vector<Point3> points;
  const int n = 40000;
  for (int i = 0; i < n; ++i) {
    const double t = 2.8 * i / n;
    points.push_back({std::cos(t), std::sin(t), t});
  }
  const ConvexPolyhedron body(points);
  try {
    const Drums drums(body, {0, 0, 1}, DrumsForm::listed);
    FAIL() << "listed " << drums.memory();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_shape);
    EXPECT_NE(std::string(error.what()).find("persistent"), std::string::npos) << error.what();
  }
  EXPECT_LT(represent::of<Drums>(body).memory(), 64u * n * 15);
}

}  // namespace
}  // namespace sunder::solid
