#include <sunder/base/random.h>
#include <sunder/solid/line/flat_flat.h>
#include <sunder/solid/line/plane_line.h>
#include <sunder/solid/line/plane_plane.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>
#include <verifier/cpp/verify.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>

namespace sunder::solid {
namespace {

using nlohmann::json;

constexpr std::array kind_names{"point", "segment", "ray", "line", "plane"};

TEST(FlatFlat, KnownKinds) {
  const Line x = Line::through({0, 0, 0}, {1, 0, 0}), y = Line::through({0, -5, 0}, {0, 5, 0});
  EXPECT_EQ(line_line(x, y).evidence.kind, FlatKind::point);
  EXPECT_EQ(line_line(x, x).evidence.kind, FlatKind::line);
  EXPECT_EQ(line_line(x, Line::through({0, 0, 1}, {1, 0, 1})).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(line_line(x, Line::through({0, 0, 5e-324}, {0, 1, 5e-324})).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(line_ray(x, Ray::from({3, 0, 0}, {4, 0, 0})).evidence.kind, FlatKind::ray);
  EXPECT_EQ(line_ray(x, Ray::from({3, 1, 0}, {3, 2, 0})).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(line_ray(x, Ray::from({3, 0, 0}, {3, 2, 0})).evidence.contact, Relation::touching);
  EXPECT_EQ(line_segment(x, Segment::between({3, -1, 0}, {3, 2, 0})).evidence.contact, Relation::overlapping);
  EXPECT_EQ(line_segment(x, Segment::between({3, 0, 0}, {9, 0, 0})).evidence.kind, FlatKind::segment);
  const Ray right = Ray::from({0, 0, 0}, {1, 0, 0}), left = Ray::from({0, 0, 0}, {-1, 0, 0});
  EXPECT_EQ(ray_ray(right, left).evidence.kind, FlatKind::point);
  EXPECT_EQ(ray_ray(right, left).evidence.contact, Relation::touching);
  EXPECT_EQ(ray_ray(right, Ray::from({5, 0, 0}, {4, 0, 0})).evidence.kind, FlatKind::segment);
  EXPECT_EQ(ray_ray(right, Ray::from({-5, 0, 0}, {-6, 0, 0})).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(ray_segment(right, Segment::between({-1, 0, 0}, {2, 0, 0})).evidence.kind, FlatKind::segment);
  EXPECT_EQ(
      segment_segment(Segment::between({0, 0, 0}, {1, 1, 1}), Segment::between({1, 0, 0}, {0, 1, 1})).evidence.contact,
      Relation::overlapping);
  EXPECT_EQ(line_point(x, {7, 0, 0}).evidence.contact, Relation::overlapping);
  EXPECT_EQ(ray_point(right, {0, 0, 0}).evidence.contact, Relation::touching);
  EXPECT_EQ(ray_point(right, {-1, 0, 0}).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(segment_point(Segment::between({1, 2, 3}, {1, 2, 3}), {1, 2, 3}).evidence.contact, Relation::overlapping);
  const Plane floor = Plane::at({0, 0, 2}, 1);
  EXPECT_EQ(plane_line(floor, x).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(plane_ray(floor, Ray::from({0, 0, 1}, {0, 0, 2})).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(plane_ray(floor, Ray::from({0, 0, 1}, {0, 0, 0.75})).evidence.kind, FlatKind::point);
  EXPECT_EQ(plane_segment(floor, Segment::between({0, 0, 1}, {0, 0, 0.75})).evidence.kind, FlatKind::nothing);
  EXPECT_EQ(plane_segment(floor, Segment::between({0, 0, 0.5}, {3, 0, 0.5})).evidence.kind, FlatKind::segment);
  EXPECT_EQ(plane_point(floor, {1e300, 0, 0.5}).evidence.kind, FlatKind::point);
  EXPECT_EQ(plane_plane(floor, Plane::through({1, 1, 0.5}, {0, 0, -3})).evidence.kind, FlatKind::plane);
  EXPECT_EQ(plane_plane(floor, Plane::through({1, 1, std::nextafter(0.5, 1)}, {0, 0, -3})).evidence.kind,
            FlatKind::nothing);
  EXPECT_EQ(plane_plane(floor, Plane::at({0, 5e-324, 2}, 1)).evidence.kind, FlatKind::line);
  EXPECT_EQ(plane_plane(floor, floor).decided_by, DecidedBy::evidence);  // levels are compared exactly
  EXPECT_EQ(plane_plane(floor, Plane::at({1, 0, 0}, 1)).decided_by, DecidedBy::filter);
}

bool is_on_line(const Flat& flat) {
  const auto* const segment = std::get_if<Segment>(&flat);
  return segment != nullptr ? segment->a != segment->b
                            : std::holds_alternative<Ray>(flat) || std::holds_alternative<Line>(flat);
}

std::string flat_certificate(const Flat& a, const Flat& b, const FlatCommon& common, bool tells_contact) {
  std::string text;
  const FlatBody body_a = body_of(a).value(), body_b = body_of(b).value();
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims pairs(file);
  const std::uint32_t p = pairs.add_body("a", body_a.points, body_a.ways);
  const std::uint32_t q = pairs.add_body("b", body_b.points, body_b.ways);
  add_claims(pairs, p, q, a, body_a, b, body_b, common, tells_contact);
  if (const auto part = common_part(a, b, common)) add_common_part(pairs, p, q, a, body_a, b, body_b, *part);
  pairs.end();
  return text;
}

// Small integers, so that touching, parallel and collinear are frequent; some scaled to sizes at which doubles overflow
// or are rounded. Each answer is proved, so that none can be wrong; and swapping changes nothing.
TEST(FlatFlat, Random) {
  const int count = tests::scaled_count(12000);
  Random random(tests::chosen_seed(20261126));
  std::map<std::string, int> tally;
  std::map<FlatKind, int> kinds;
  for (int i = 0; i < count; ++i) {
    const std::int64_t size = random.below(3) == 0 ? 1 : 2;
    const double scale = random.below(4) == 0 ? 1e-170 : random.below(3) == 0 ? 0x1.8p500 : 1;
    const auto point = [&] {
      const auto small = [&] { return scale * static_cast<double>(random.between(-size, size)); };
      const double x = small(), y = small(), z = random.below(3) == 0 ? small() : 0;
      return Point3{x, y, z};
    };
    const auto any = [&](std::size_t kind) -> Flat {
      const Point3 p = point();
      Point3 q = point();
      while (q == p && kind >= 2) q = point();
      while (q == Point3{}) q = point();
      if (kind == 0) return p;
      if (kind == 1) return Segment::between(p, random.below(9) == 0 ? p : q);
      if (kind == 4) return Plane::through(p, q);
      if (q == p) q.x = p.x + scale;
      if (kind == 2) return Ray::from(p, q);
      return Line::through(p, q);
    };
    const std::size_t i_a = random.below(5), i_b = random.below(5);
    const Flat a = any(i_a), b = any(i_b);
    const FlatCommon common = flat_flat(a, b), swapped = flat_flat(b, a);
    ASSERT_EQ(common.evidence.kind, swapped.evidence.kind);
    ASSERT_EQ(common.evidence.contact, swapped.evidence.contact);
    ASSERT_EQ(common.meet(), common.evidence.kind != FlatKind::nothing);
    ASSERT_LE(common.cost.probes, 13u);
    const bool tells = random.below(2) == 0;
    const std::string text = flat_certificate(a, b, common, tells);
    const auto verified = sunder_verifier::verify_text(text, "certificate");
    ASSERT_TRUE(verified.accepted()) << text;
    const std::string verdict = !common.meet() ? "apart"
                                : tells        ? std::string(name_of(common.evidence.contact))
                                               : "meet";
    ASSERT_EQ(verified.statements[0].verdict, verdict);
    const bool is_short = common.evidence.kind == FlatKind::point || common.evidence.kind == FlatKind::segment;
    const bool has_part = is_short && (is_on_line(a) || is_on_line(b));  // it is proved what they have in common, too
    ASSERT_EQ(verified.statements.size(), has_part ? 2u : 1u) << text;
    ASSERT_TRUE(!has_part || verified.statements[1].verdict == "between");
    if (common.evidence.contact == Relation::touching) {
      ASSERT_EQ(common.evidence.kind, FlatKind::point);
    }
    ++tally[std::string(kind_names[std::min(i_a, i_b)]) + " " + kind_names[std::max(i_a, i_b)] + " " + verdict];
    ++kinds[common.evidence.kind];
    if (i % 16 != 0) continue;
    // Another verdict, or the opposite direction, is refused.
    for (const char* other : {"apart", "meet", "touching", "overlapping"}) {
      if (other == verdict) continue;
      json file = json::parse(text);
      file["statements"][0]["verdict"] = other;
      EXPECT_FALSE(sunder_verifier::verify_text(file.dump(), "certificate").accepted());
    }
    json file = json::parse(text);
    if (has_part && common.evidence.kind == FlatKind::segment) {
      std::swap(file["statements"][1]["first"], file["statements"][1]["last"]);
      EXPECT_FALSE(sunder_verifier::verify_text(file.dump(), "certificate").accepted());
      file = json::parse(text);
    }
    json& last = file["statements"][0]["claims"].back();
    if (!last.contains("direction")) continue;
    for (json& x : last["direction"]) {
      const std::string number = x;
      x = number[0] == '-' ? number.substr(1) : "-" + number;
    }
    EXPECT_FALSE(sunder_verifier::verify_text(file.dump(), "certificate").accepted());
  }
  if (count < 3000) return;
  EXPECT_EQ(kinds.size(), 6u);
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = i; j < 5; ++j) {
      for (const char* verdict : {"apart", "meet", "touching", "overlapping"}) {
        const std::string key = std::string(kind_names[i]) + " " + kind_names[j] + " " + verdict;
        const bool never = verdict == std::string("touching") && (i == j   ? i == 0 || i >= 3
                                                                  : i == 0 ? j >= 3
                                                                           : j == 4 && i == 3);
        if (!never) {
          EXPECT_GT(tally[key], 2) << key;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sunder::solid
