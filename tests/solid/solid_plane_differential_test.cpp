// Every method of polyhedron_plane against polyhedron_plane_by_scan, over bodies and planes of all sorts.
#include <tests/support/solid_pairs.h>

#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/section/polyhedron_plane.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Plane;
using solid::PolyhedronPlane;
using solid::Pose;

enum class PlaneFamily : int {
  general,         // any normal, through some point between two vertices, or beyond
  through_vertex,  // through the rounded image of a vertex
  supporting,      // through that of an extreme vertex
  last_bit,        // the same, a few units in the last place away
  of_facet,        // the normal of a facet, through one of its vertices
  level,           // along an axis: of a body in its own frame, along its drums
};
constexpr int plane_family_count = 6;
constexpr std::array<const char*, plane_family_count> plane_family_names{"general",  "through vertex", "supporting",
                                                                         "last bit", "of a facet",     "level"};

Point3 rounded(const Posed3& p) {
  const auto v = rounded_image(p);
  return {v.x, v.y, v.z};
}

class Planes {
 public:
  explicit Planes(std::uint64_t seed) : random_(seed) {}

  Plane next(PlaneFamily family, const ConvexPolyhedron& body, const Pose& pose) {
    const auto n = body.vertices().size();
    const auto image = [&](std::size_t v) { return rounded(posed(body.vertices()[v], pose.affine())); };
    Point3 normal{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
    if (family == PlaneFamily::level)
      normal = std::array<Point3, 3>{{{1, 0, 0}, {0, 2, 0}, {0, 0, -1}}}[random_.below(3)];
    std::size_t at = random_.below(n);
    if (family == PlaneFamily::of_facet && body.dimension() > 1) {
      const auto facet = body.facet(static_cast<std::uint32_t>(random_.below(body.facet_count())));
      at = facet[0];
      const Point3 a = image(facet[0]), b = image(facet[1]), c = image(facet[2]);
      const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
      const Point3 cross{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
      if (usable(cross)) normal = cross;
    }
    if (family == PlaneFamily::supporting || family == PlaneFamily::last_bit) {
      const WorldDirection direction(normal);
      for (std::size_t v = 0; v < n; ++v) {
        if (compare_along(direction, posed(body.vertices()[at], pose.affine()),
                          posed(body.vertices()[v], pose.affine())) == Sign::positive) {
          at = v;
        }
      }
    }
    Point3 point = image(at);
    if (family == PlaneFamily::general || family == PlaneFamily::level) {
      const Point3 other = image(random_.below(n));
      const double t = random_.uniform(-1, 2);
      point = {point.x + t * (other.x - point.x), point.y + t * (other.y - point.y), point.z + t * (other.z - point.z)};
    }
    if (family == PlaneFamily::last_bit) {
      for (const std::size_t k : {0u, 1u, 2u}) {
        for (std::int64_t i = random_.between(0, 2); i > 0; --i) {
          point[k] = std::nextafter(point[k], random_.below(2) == 0 ? -INFINITY : INFINITY);
        }
      }
    }
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) point = {};
    const double offset = normal.x * point.x + normal.y * point.y + normal.z * point.z;
    if (random_.below(2) == 0 && std::isfinite(offset)) return Plane::at(normal, offset);
    return Plane::through(point, normal);
  }

 private:
  static bool usable(const Point3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && p != Point3{};
  }
  Random random_;
};

// What is named proves the answer: by the exact sides of all vertices.
void expect_evidence(const PolyhedronPlane& answer, const ConvexPolyhedron& body, const Pose& pose,
                     const Plane& plane) {
  const auto side = [&](std::uint32_t v) {
    return side_of_plane(plane.normal, plane.point, plane.offset, posed(body.vertices()[v], pose.affine()));
  };
  if (const auto* across = std::get_if<solid::AcrossPlane>(&answer.evidence)) {
    ASSERT_NE(side(across->below), Sign::positive);
    ASSERT_NE(side(across->above), Sign::negative);
    return;
  }
  const solid::BesidePlane& beside = std::get<solid::BesidePlane>(answer.evidence);
  ASSERT_EQ(side(beside.nearest), beside.side);
  const WorldDirection normal(plane.normal);
  for (const Point3& v : body.vertices()) {
    const Sign further =
        compare_along(normal, posed(body.vertices()[beside.nearest], pose.affine()), posed(v, pose.affine()));
    ASSERT_NE(further, -beside.side);
  }
}

struct PlaneTally {
  int cases = 0, meets = 0, above = 0, touches = 0, by_front = 0, by_drums = 0, exact = 0;
};

TEST(SolidPlaneDifferential, MethodsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261125);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  Planes planes(seed);
  std::map<std::pair<Family, PlaneFamily>, PlaneTally> tallies;
  std::map<PlaneFamily, PlaneTally> of_planes;
  std::map<Family, PlaneTally> of_bodies;
  for (int i = 0; i < count;) {
    const PairCase c = pairs.next();
    const auto [low, high] = c.a.box();
    const Point3 direction = low.x < high.x ? Point3{1, 0, 0} : Point3{0, 1, 0};
    const solid::Drums persistent(c.a, direction, solid::DrumsForm::persistent);
    for (int f = 0; f < plane_family_count && i < count; ++f, ++i) {
      const auto family = static_cast<PlaneFamily>(f);
      const Pose pose = family == PlaneFamily::level && i % 2 == 0 ? Pose() : c.pose_a;
      const Plane plane = planes.next(family, c.a, pose);
      SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)) + ", " +
                   plane_family_names[static_cast<std::size_t>(f)]);
      const PolyhedronPlane scan = polyhedron_plane_by_scan(c.a, pose, plane);
      const PolyhedronPlane front = polyhedron_plane(c.a, pose, plane);
      const PolyhedronPlane drums = polyhedron_plane_by_drums(c.a, pose, plane);
      const PolyhedronPlane others = polyhedron_plane_by_drums(c.a, persistent, pose, plane);
      for (const PolyhedronPlane* answer : {&scan, &front, &drums, &others}) {
        ASSERT_EQ(side_of(*answer), side_of(scan));
        expect_evidence(*answer, c.a, pose, plane);
        if (HasFatalFailure()) return;
      }
      const Relation contact = polyhedron_plane_contact(c.a, pose, plane);
      ASSERT_EQ(contact != Relation::none, scan.meet());
      for (PlaneTally* t : {&of_planes[family], &of_bodies[c.family]}) {
        ++t->cases;
        t->meets += scan.meet();
        t->above += side_of(scan) == Sign::positive;
        t->touches += contact == Relation::touching;
        t->by_front += front.decided_by == DecidedBy::finishing;
        t->by_drums += (drums.decided_by == DecidedBy::finishing) + (others.decided_by == DecidedBy::finishing);
        t->exact += front.decided_by == DecidedBy::evidence;
      }
    }
  }
  std::printf("%-16s %7s %7s %7s %7s %9s | %s\n", "family", "cases", "meet", "above", "touch", "evidence",
              "finishing: front door, twice by drums");
  const auto print = [](const std::string& name, const PlaneTally& t) {
    std::printf("%-16s %7d %7d %7d %7d %9d | %7d %7d\n", name.c_str(), t.cases, t.meets, t.above, t.touches, t.exact,
                t.by_front, t.by_drums);
  };
  for (const auto& [family, t] : of_planes) print(plane_family_names[static_cast<std::size_t>(family)], t);
  for (const auto& [family, t] : of_bodies) print(std::string(name_of(family)), t);
  if (count < 2000) return;
  for (const auto& [family, t] : of_planes) {
    EXPECT_GT(t.meets, t.cases / 10);
    EXPECT_LT(t.meets, t.cases);
  }
  EXPECT_GT(of_planes[PlaneFamily::supporting].touches, count / 100);
  const PlaneTally& general = of_planes[PlaneFamily::general];
  EXPECT_LE(general.by_drums, 2 * general.cases / 1000);
  EXPECT_LE(general.by_front, general.cases / 1000);
  for (const auto& [family, t] : of_bodies) {
    EXPECT_LE(t.by_drums, 2 * t.cases / 10) << name_of(family);
    EXPECT_LE(t.by_front, t.cases / (is_stretched(family) ? 7 : 10)) << name_of(family);
  }
}

}  // namespace
}  // namespace sunder::tests
