// Flat polygons against polyhedra: by drums, and the front door, against the scan.
#include <tests/support/solid_pairs.h>

#include <sunder/certificate/check.h>
#include <sunder/solid/pair/polyhedron_polygon.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;

enum class PolygonFamily : int {
  general,    // any frame near the body, up to as long as it is
  inside,     // the same, small, in the middle
  piercing,   // long, through the middle
  of_facet,   // a facet of another body, in its place: the families of solid_pairs.h
  own_facet,  // one of the body itself, where it is
  at_vertex,  // with a vertex at one of the body, as far as rounding lets it be
  last_bit,   // the same, a few units in the last place away
  level,      // along the slices of a body in its own frame, at the height of a vertex or between
};
constexpr int polygon_family_count = 8;
constexpr std::array<const char*, polygon_family_count> polygon_family_names{
    "general", "inside", "piercing", "of facet", "own facet", "at vertex", "last bit", "level"};

struct Flat {
  ConvexPolyhedron polygon;
  Pose pose;
};

class Polygons {
 public:
  explicit Polygons(std::uint64_t seed) : random_(seed) {}

  Flat next(PolygonFamily family, const PairCase& c, const Pose& pose_a) {
    if (family == PolygonFamily::of_facet) return {facet_of(c.b), c.pose_b};
    if (family == PolygonFamily::own_facet) return {facet_of(c.a), pose_a};
    const auto image = [&](std::uint64_t v) {
      const auto p = rounded_image(posed(c.a.vertices()[v], pose_a.affine()));
      return Point3{p.x, p.y, p.z};
    };
    const std::uint64_t n = c.a.vertices().size();
    const Point3 p = image(random_.below(n)), q = image(random_.below(n)), r = image(random_.below(n));
    double size = 0;
    for (const std::size_t k : {0u, 1u, 2u}) size = std::max({size, std::fabs(p[k] - q[k]), std::fabs(p[k] - r[k])});
    if (!(size > 0) || !std::isfinite(size)) size = 1;
    Point3 at = p;
    double length = size * random_.log_uniform(0.05, 1);
    if (family == PolygonFamily::general) {
      for (const std::size_t k : {0u, 1u, 2u}) at[k] += size * random_.uniform(-1, 1);
    } else if (family == PolygonFamily::inside || family == PolygonFamily::piercing) {
      for (const std::size_t k : {0u, 1u, 2u}) at[k] = p[k] / 3 + q[k] / 3 + r[k] / 3;
      length = size * (family == PolygonFamily::inside ? 1e-3 : 10);
    } else if (family == PolygonFamily::level && random_.below(2) == 0) {
      at.z = (p.z + q.z) / 2;
    }
    if (family == PolygonFamily::last_bit) {
      for (const std::size_t k : {0u, 1u, 2u}) {
        for (std::int64_t i = random_.between(0, 2); i > 0; --i) {
          at[k] = std::nextafter(at[k], random_.below(2) == 0 ? -INFINITY : INFINITY);
        }
      }
    }
    const bool has_corner_there = family == PolygonFamily::at_vertex || family == PolygonFamily::last_bit;
    std::vector<Point3> points;
    const std::uint64_t corners = random_.below(8) == 0 ? 200 : 3 + random_.below(10);
    for (std::uint64_t k = 0; k < corners; ++k) {
      const double t =
          6.283185307179586 * (static_cast<double>(k) + 0.5 * random_.unit()) / static_cast<double>(corners);
      points.push_back({std::cos(t), std::sin(t), 0});
    }
    if (has_corner_there) {
      for (Point3& v : points) v.x += 1.5, v.y *= 0.5;
      points.push_back({0, 0, 0});
    }
    std::array<double, 9> frame{};
    for (double& x : frame) x = length * random_.uniform(-1, 1);
    if (family == PolygonFamily::level) frame = {length, 0, 0, 0, length, 0, 0, 0, length};
    for (double& x : frame) x = std::isfinite(x) ? x : 1;
    for (const std::size_t k : {0u, 1u, 2u}) at[k] = std::isfinite(at[k]) ? at[k] : 0;
    try {
      return {ConvexPolyhedron(points), Pose::from_matrix(frame, {at.x, at.y, at.z})};
    } catch (const Error&) {  // a frame that is singular in doubles: tiny bodies
      return {ConvexPolyhedron(points), Pose()};
    }
  }

 private:
  ConvexPolyhedron facet_of(const ConvexPolyhedron& body) {
    if (body.dimension() < 2) return body;
    std::vector<Point3> points;
    for (const std::uint32_t v : body.facet(static_cast<std::uint32_t>(random_.below(body.facet_count())))) {
      points.push_back(body.vertices()[v]);
    }
    return ConvexPolyhedron(points);
  }

  Random random_;
};

struct PolygonTally {
  int cases = 0, meets = 0, finished = 0, finished_by_front = 0, meets_finished = 0;
  std::uint64_t probes = 0;
};

TEST(SolidPolygonDifferential, MethodsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261127);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  Polygons polygons(seed);
  std::map<PolygonFamily, PolygonTally> of_polygons;
  std::map<Family, PolygonTally> of_bodies;
  PolygonTally in_general_position;  // any frame near a body of random points, or through it
  for (int i = 0; i < count;) {
    const PairCase c = pairs.next();
    for (int f = 0; f < polygon_family_count && i < count; ++f, ++i) {
      const auto family = static_cast<PolygonFamily>(f);
      const Pose pose = family == PolygonFamily::level ? Pose() : c.pose_a;
      const Flat flat = polygons.next(family, c, pose);
      SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)) + ", " +
                   polygon_family_names[static_cast<std::size_t>(f)]);
      const PairAnswer scan = polyhedron_polygon_by_scan(c.a, pose, flat.polygon, flat.pose);
      const PairAnswer front = polyhedron_polygon(c.a, pose, flat.polygon, flat.pose);
      const PairAnswer drums = polyhedron_polygon_by_drums(c.a, pose, flat.polygon, flat.pose);
      ASSERT_EQ(front.meet(), scan.meet());
      ASSERT_EQ(drums.meet(), scan.meet());
      ASSERT_EQ(check_absolutely(drums.evidence, {c.a.vertices(), pose.affine(), false},
                                 {flat.polygon.vertices(), flat.pose.affine(), false}),
                CheckResult::accepted);
      if (c.a.dimension() < 3 || flat.polygon.dimension() != 2) continue;  // left to the front door
      const bool is_general = c.family == Family::general && family <= PolygonFamily::piercing;
      for (PolygonTally* t :
           {&of_polygons[family], &of_bodies[c.family], is_general ? &in_general_position : nullptr}) {
        if (t == nullptr) continue;
        ++t->cases;
        t->meets += scan.meet();
        t->finished += drums.decided_by == DecidedBy::finishing;
        t->meets_finished += scan.meet() && drums.decided_by == DecidedBy::finishing;
        t->finished_by_front += front.decided_by == DecidedBy::finishing;
        t->probes += drums.cost.probes;
      }
    }
  }
  std::printf("%-16s %7s %7s | %s\n", "family", "cases", "meet",
              "finishing: front door, by drums (meeting); probes by drums");
  const auto print = [](const std::string& name, const PolygonTally& t) {
    std::printf("%-16s %7d %7d | %7d %7d (%d) %7.0f\n", name.c_str(), t.cases, t.meets, t.finished_by_front, t.finished,
                t.meets_finished, static_cast<double>(t.probes) / t.cases);
  };
  for (const auto& [family, t] : of_polygons) print(polygon_family_names[static_cast<std::size_t>(family)], t);
  for (const auto& [family, t] : of_bodies) print(std::string(name_of(family)), t);
  print("general position", in_general_position);
  if (count < 2000) return;
  EXPECT_LE(in_general_position.finished, 1 + in_general_position.cases / 1000);
  for (const auto& [family, t] : of_polygons) EXPECT_GT(t.meets, t.cases / 10);
  const PolygonTally& general = of_polygons[PolygonFamily::general];
  EXPECT_LT(general.meets, general.cases - general.cases / 10);
  for (const auto& [family, t] : of_bodies) {
    if (is_stretched(family)) continue;  // no search in floating point reaches across 600 decimal digits
    EXPECT_LE(t.finished, t.cases / 10) << name_of(family);
  }
}

// A plane through a lowest and a highest vertex: at both tips of W two corners are one point, and from a vertex between
// them four pockets are beside it.
TEST(SolidPolygonDifferential, TipsThatArePoints) {
  int apart = 0, meet = 0;
  for (const double belt : {0.0, 0.25}) {  // one or two slices between the tips
    const ConvexPolyhedron body(std::vector<Point3>{
        {0, 0, -1}, {1, 0.25, -belt}, {-0.5, 1, belt}, {-1, -0.25, -belt}, {0.5, -1, belt}, {0, 0, 1}});
    for (int turn = 0; turn < 16; ++turn) {
      const double x = std::cos(turn), y = std::sin(turn);
      for (const double from : {-3.0, -2.0, -1.25, -0.5, 0.75, 1.25}) {
        const ConvexPolyhedron polygon(
            std::vector<Point3>{{from, -1, 0}, {from + 1, -0.75, 0}, {from + 1, 0.75, 0}, {from, 1, 0}});
        for (const double height : {-1.5, 0.0, 1.5}) {
          const Pose pose = Pose::from_matrix({x, 0, y, y, 0, -x, 0, 1, 0}, {0, 0, height});
          const PairAnswer scan = polyhedron_polygon_by_scan(body, Pose(), polygon, pose);
          const PairAnswer drums = polyhedron_polygon_by_drums(body, Pose(), polygon, pose);
          EXPECT_EQ(drums.meet(), scan.meet());
          EXPECT_NE(drums.decided_by, DecidedBy::finishing) << belt << " " << turn << " " << from << " " << height;
          ++(scan.meet() ? meet : apart);
        }
      }
    }
  }
  EXPECT_GT(meet, 50);
  EXPECT_GT(apart, 50);
}

}  // namespace
}  // namespace sunder::tests
