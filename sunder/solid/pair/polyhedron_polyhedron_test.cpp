// The numbered properties of the question, by hand-made cases of each way to touch, and by random ones. The
// differential test in tests/ goes on from here.
#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_batch.h>
#include <tests/support/doubles.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>
#include <tests/support/thread_sanitizer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <new>
#include <set>
#include <string>
#include <thread>
#include <vector>

// Counts what this thread allocates, in the whole program of tests. (Inlined, GCC takes the pair for a mismatch.)
static thread_local std::uint64_t allocations = 0;
static thread_local std::uint64_t most_allocations = UINT64_MAX;  // what is beyond is refused

#if !SUNDER_UNDER_THREAD_SANITIZER
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (++allocations > most_allocations) throw std::bad_alloc();
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#endif

namespace sunder::solid {
namespace {

using Points = std::vector<Point3>;
using Method = PairAnswer (*)(const ConvexPolyhedron&, const Pose&, const ConvexPolyhedron&, const Pose&);

using tests::largest, tests::least;

const std::vector<std::pair<std::string, Method>> methods{
    {"front", polyhedron_polyhedron},
    {"gjk", polyhedron_polyhedron_by_gjk},
    {"hierarchy", polyhedron_polyhedron_by_hierarchy},
    {"bounded", polyhedron_polyhedron_by_bounded},
    {"polar", polyhedron_polyhedron_by_polar},
    {"scan", polyhedron_polyhedron_by_scan},
    {"intersect", [](const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b) {
       return intersect(a, pose_a, b, pose_b);
     }}};

// P1, P3 and the swap of P2 for all methods, and the kind of contact.
void expect_contact(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                    Relation expected, const std::string& what) {
  const PlacedVertices in_a{a.vertices(), pose_a.affine(), false}, in_b{b.vertices(), pose_b.affine(), false};
  for (const auto& [name, method] : methods) {
    const PairAnswer there = method(a, pose_a, b, pose_b), back = method(b, pose_b, a, pose_a);
    EXPECT_EQ(there.meet(), expected != Relation::none) << what << " by " << name;
    EXPECT_EQ(back.meet(), expected != Relation::none) << what << " by " << name << ", swapped";
    EXPECT_EQ(name_of(check_absolutely(there.evidence, in_a, in_b)), "accepted") << what << " by " << name;
    EXPECT_EQ(name_of(check_absolutely(back.evidence, in_b, in_a)), "accepted")
        << what << " by " << name << ", swapped";
  }
  EXPECT_EQ(name_of(polyhedron_polyhedron_contact(a, pose_a, b, pose_b)), name_of(expected)) << what;
  EXPECT_EQ(name_of(polyhedron_polyhedron_contact(b, pose_b, a, pose_a)), name_of(expected)) << what << ", swapped";
}

// Bodies that touch, and a direction in which any shift of B parts them and against which any small one makes their
// interiors meet.
struct Touch {
  std::string name;
  Points a, b;
  Point3 outward;
};

Points moved_points(Points points, const Point3& by) {
  for (Point3& p : points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return points;
}

std::vector<Touch> touches() {
  return {
      {"vertex, vertex", tests::cube_corners(-1, 1), moved_points(tests::cube_corners(-1, 1), {2, 2, 2}), {1, 1, 1}},
      {"vertex, edge", tests::cube_corners(-1, 1), {{1, 1, 0.25}, {3, 2, 1}, {2, 3, 0}, {3, 3, -1}}, {1, 1, 0}},
      {"vertex, facet", tests::cube_corners(-1, 1), {{1, 0.25, -0.5}, {2, 0, 0}, {3, 1, 0}, {2, 0, 1}}, {1, 0, 0}},
      {"edge, edge crossing",
       tests::cube_corners(-1, 1),
       {{2, 0, 0.25}, {0, 2, 0.25}, {3, 3, 1}, {3, 3, -1}},
       {1, 1, 0}},
      {"edge, edge along", tests::cube_corners(-1, 1), {{1, 1, 0}, {1, 1, 5}, {3, 2, 1}, {2, 3, 1}}, {1, 1, 0}},
      {"edge, edge the same", tests::cube_corners(-1, 1), {{1, 1, -1}, {1, 1, 1}, {3, 2, 1}, {2, 3, 1}}, {1, 1, 0}},
      {"edge, facet", tests::cube_corners(-1, 1), {{1, 0.25, -0.5}, {1, 4, 0.5}, {2, 0, 0}, {3, 1, 1}}, {1, 0, 0}},
      {"edge, facet across", tests::cube_corners(-1, 1), {{1, -4, -0.5}, {1, 4, 0.5}, {2, 0, 0}, {3, 1, 1}}, {1, 0, 0}},
      {"facet, facet", tests::cube_corners(-1, 1), moved_points(tests::cube_corners(-1, 1), {2, 0.5, 0.25}), {1, 0, 0}},
      {"facet, facet the same",
       tests::cube_corners(-1, 1),
       moved_points(tests::cube_corners(-1, 1), {2, 0, 0}),
       {1, 0, 0}},
      {"facet, facet inside", tests::cube_corners(-1, 1), {{1, 0, 0}, {1, 0.5, 0}, {1, 0, 0.5}, {2, 0, 0}}, {1, 0, 0}},
      {"point, facet", tests::cube_corners(-1, 1), {{1, 0.25, -0.5}}, {1, 0, 0}},
      {"point, edge", tests::cube_corners(-1, 1), {{1, 1, -0.5}}, {1, 1, 0}},
      {"point, vertex", tests::cube_corners(-1, 1), {{1, 1, -1}}, {1, 1, -1}},
      {"segment, facet", tests::cube_corners(-1, 1), {{1, 0.25, -0.5}, {3, 0, 0}}, {1, 0, 0}},
      {"segment in facet", tests::cube_corners(-1, 1), {{1, 0.25, -0.5}, {1, -0.5, 0}}, {1, 0, 0}},
      {"segment on edge", tests::cube_corners(-1, 1), {{1, 1, -3}, {1, 1, 0}}, {1, 1, 0}},
      {"segment, edge crossing", tests::cube_corners(-1, 1), {{0, 2, 0}, {2, 0, 0}}, {1, 1, 0}},
      {"polygon on facet", tests::cube_corners(-1, 1), {{1, 0, 0}, {1, 5, 0}, {1, 0, 5}}, {1, 0, 0}},
      {"polygon, edge", tests::cube_corners(-1, 1), {{0, 2, 0}, {2, 0, 0}, {0, 2, 5}, {2, 0, 5}}, {1, 1, 0}},
      {"polygon, vertex", tests::cube_corners(-1, 1), {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, {1, 1, 1}},
      {"segment, segment crossing", {{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 0}, {0, 1, 0}}, {0, 0, 0}},
      {"segment, segment end to end", {{-1, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {2, 0, 0}}, {1, 0, 0}},
      {"triangle, triangle corner in", {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{1, 1, 0}, {1, 1, 3}, {2, 1, 3}}, {0, 0, 1}},
      {"triangle, triangle in a plane",
       {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
       {{4, 0, 0}, {0, 4, 0}, {4, 4, 0}},
       {1, 1, 0}},
  };
}

bool flat(const Touch& t) { return ConvexPolyhedron(t.a).dimension() < 3; }

// P1 at each kind of touch, and beyond and before it by gaps from the least double on.
TEST(PolyhedronPolyhedronTest, P1_TouchesAreExactForEachPairOfFeatures) {
  for (const Touch& t : touches()) {
    const ConvexPolyhedron a(t.a), b(t.b);
    if (t.outward == Point3()) continue;  // crosses: no sense is outward
    expect_contact(a, Pose(), b, Pose(), Relation::touching, t.name);
    for (const double gap : {least, 1e-310, 1e-200, 0x1p-60, 0x1p-53, 0x1p-52, 0x1p-40, 0x1p-6}) {
      const auto shift = [&](double by) {
        return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {t.outward.x * by, t.outward.y * by, t.outward.z * by});
      };
      const std::string what = t.name + ", gap " + std::to_string(std::log2(gap));
      expect_contact(a, Pose(), b, shift(gap), Relation::none, what);
      // Against it their interiors meet, where bodies have an interior about the touch.
      if (!flat(t)) expect_contact(a, Pose(), b, shift(-gap), Relation::overlapping, what + " before");
    }
  }
}

// P1: 5e-324 and 1.7e308, by coordinates or by poses.
TEST(PolyhedronPolyhedronTest, P1_TheEndsOfTheRangeOfDoubles) {
  const auto scaled = [](const Points& points, double s) {
    Points out;
    for (const Point3& p : points) out.push_back({p.x * s, p.y * s, p.z * s});
    return ConvexPolyhedron(out);
  };
  for (const double s : {4 * least, 0x1p-1060, 0x1p-500, 0x1p500, 0x1p1020}) {  // exactly, the coordinates are small
    for (const Touch& t : touches()) {
      if (t.outward == Point3()) continue;
      if (s == 4 * least && t.name.find("facet, facet") == std::string::npos) continue;  // halves and quarters only
      const auto name = t.name + ", scale " + std::to_string(std::ilogb(s));
      const Pose by_pose = Pose::from_matrix({s, 0, 0, 0, s, 0, 0, 0, s}, {0, 0, 0});
      expect_contact(scaled(t.a, s), Pose(), scaled(t.b, s), Pose(), Relation::touching, name + " points");
      expect_contact(ConvexPolyhedron(t.a), by_pose, ConvexPolyhedron(t.b), by_pose, Relation::touching,
                     name + " pose");
      const Pose beyond =
          Pose::from_matrix(by_pose.affine().linear, {t.outward.x * least, t.outward.y * least, t.outward.z * least});
      expect_contact(ConvexPolyhedron(t.a), by_pose, ConvexPolyhedron(t.b), beyond, Relation::none, name + " apart");
    }
  }
  const ConvexPolyhedron huge(
      Points{{largest, largest, largest}, {-largest, largest, largest}, {0, -largest, largest}, {0, 0, -largest}});
  const ConvexPolyhedron top(Points{{0, 0, largest}}), corner(Points{{largest, largest, largest}}),
      beside(Points{{largest, largest, std::nextafter(largest, 0)}});
  expect_contact(huge, Pose(), top, Pose(), Relation::touching, "huge, facet");
  expect_contact(huge, Pose(), corner, Pose(), Relation::touching, "huge, vertex");
  expect_contact(huge, Pose(), beside, Pose(), Relation::none, "huge, beside");
  expect_contact(huge, Pose(), huge, Pose(), Relation::overlapping, "huge, itself");
  // The image is up to 3 largest^2, or the least double's square.
  const Pose larger = Pose::from_matrix({largest, 0, 0, 0, largest, 0, 0, 0, largest}, {0, 0, 0});
  const Pose larger_on = Pose::from_matrix(larger.affine().linear, {0, 0, least});
  expect_contact(huge, larger, top, larger, Relation::touching, "squares");
  expect_contact(huge, larger, top, larger_on, Relation::none, "squares, and the least double");
  const ConvexPolyhedron tiny(Points{{least, 0, 0}, {0, least, 0}, {0, 0, least}, {0, 0, 0}}),
      dot(Points{{least, 0, 0}});
  const Pose smaller = Pose::from_matrix({least, 0, 0, 0, least, 0, 0, 0, least}, {0, 0, 0});
  expect_contact(tiny, smaller, dot, smaller, Relation::touching, "tiny squares");
  expect_contact(tiny, smaller, dot, Pose(), Relation::none, "tiny squares, and the least double");
  // A body of 1e300 and one of 1e-300 in it, on it, beside it.
  const ConvexPolyhedron large_cube = scaled(tests::cube_corners(-1, 1), 0x1p1000),
                         small_cube = scaled(tests::cube_corners(-1, 1), 0x1p-1000);
  for (const double sense : {1.0, -1.0}) {
    const auto at = [&](double y) { return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {sense * 0x1p1000, y, 0}); };
    expect_contact(large_cube, Pose(), small_cube, at(0), Relation::overlapping, "small on large");
    expect_contact(large_cube, at(0), small_cube, Pose(), Relation::overlapping, "small on shifted large");
    const ConvexPolyhedron on(
        moved_points(Points(small_cube.vertices().begin(), small_cube.vertices().end()), {sense * 0x1p-1000, 0, 0}));
    expect_contact(large_cube, at(0), on, Pose(), Relation::overlapping, "small under the facet");
    const Pose against = Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {-sense * 0x1p-1000, 0, 0});
    expect_contact(large_cube, at(0), small_cube, against, Relation::touching, "small against the facet");
  }
}

TEST(PolyhedronPolyhedronTest, P1_ContainmentAndCrossing) {
  const ConvexPolyhedron box(tests::cube_corners(-1, 1)), point(Points{{0, 0, 0}});
  const auto small = [](double s, const Point3& at) {
    return Pose::from_matrix({s, 0, 0, 0, s, 0, 0, 0, s}, {at.x, at.y, at.z});
  };
  expect_contact(box, Pose(), box, Pose(), Relation::overlapping, "itself");
  for (const double s : {0.5, 1e-9, 1e-300, 0x1p-1074}) {
    expect_contact(box, Pose(), box, small(s, {0.1, 0.2, -0.3}), Relation::overlapping, "inside");
    expect_contact(box, Pose(), box, small(s, {1, 1, 1}), Relation::overlapping, "about a vertex");
    expect_contact(box, Pose(), box, small(s, {3, 1, 1}), Relation::none, "outside");
  }
  expect_contact(box, Pose(), box, small(0.5, {0.5, 0.5, 0.5}), Relation::overlapping, "inside, sharing a vertex");
  expect_contact(box, Pose(), point, Pose(), Relation::overlapping, "a point inside");
  expect_contact(point, Pose(), point, Pose(), Relation::overlapping, "a point and itself");
  expect_contact(point, Pose(), point, small(1, {least, 0, 0}), Relation::none, "two points");
  const ConvexPolyhedron segment(Points{{-3, 0, 0}, {3, 0, 0}}), other(Points{{0, -1, 0}, {0, 1, 0}});
  expect_contact(box, Pose(), segment, Pose(), Relation::overlapping, "a segment through");
  expect_contact(segment, Pose(), other, Pose(), Relation::overlapping, "segments that cross");
  expect_contact(segment, Pose(), other, small(1, {0, 1, 0}), Relation::touching, "segments in a T");
  expect_contact(segment, Pose(), other, small(1, {3, 1, 0}), Relation::touching, "segments in an L");
  expect_contact(segment, Pose(), other, small(1, {0, 0, least}), Relation::none, "skew segments");
  expect_contact(segment, Pose(), segment, small(1, {5, 0, 0}), Relation::overlapping, "segments along");
  expect_contact(segment, Pose(), segment, small(1, {6, 0, 0}), Relation::touching, "segments end to end");
  expect_contact(segment, Pose(), segment, small(1, {6, 0, least}), Relation::none, "segments next to each other");
  expect_contact(segment, Pose(), point, small(1, {3, 0, 0}), Relation::touching, "a point at an end");
  expect_contact(segment, Pose(), point, small(1, {2, 0, 0}), Relation::overlapping, "a point on a segment");
  const ConvexPolyhedron square(Points{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const Pose upright = Pose::from_matrix({1, 0, 0, 0, 0, -1, 0, 1, 0}, {0, 0, 0});
  expect_contact(square, Pose(), square, upright, Relation::overlapping, "squares that cross");
  expect_contact(square, Pose(), square, small(1, {2, 0, 0}), Relation::touching, "squares side by side");
  expect_contact(square, Pose(), square, small(1, {1, 1, 0}), Relation::overlapping, "squares in a plane");
  expect_contact(square, Pose(), square, small(1, {0, 0, least}), Relation::none, "squares above each other");
  expect_contact(square, Pose(), segment, Pose(), Relation::overlapping, "a segment across a square");
  expect_contact(square, Pose(), other, Pose::from_matrix({1, 0, 0, 0, 0, -1, 0, 1, 0}, {0.5, 0.5, 0}),
                 Relation::overlapping, "a segment through a square");
  expect_contact(square, Pose(), other, Pose::from_matrix({1, 0, 0, 0, 0, -1, 0, 1, 0}, {1, 0.5, 0}),
                 Relation::touching, "a segment through a side");
}

// P2: scaling and shifting exactly, and reflecting; any one affine map for both keeps touches.
TEST(PolyhedronPolyhedronTest, P2_ExactMapsForBothChangeNothing) {
  Random random(tests::chosen_seed(97));
  for (const Touch& t : touches()) {
    const ConvexPolyhedron a(t.a), b(t.b);
    const Relation contact = t.outward == Point3() ? Relation::overlapping : Relation::touching;
    const std::vector<std::pair<std::string, Pose>> maps{
        {"reflected in x", Pose::from_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0})},
        {"reflected in the origin", Pose::from_matrix({-1, 0, 0, 0, -1, 0, 0, 0, -1}, {0, 0, 0})},
        {"axes exchanged", Pose::from_matrix({0, 1, 0, 1, 0, 0, 0, 0, 1}, {0, 0, 0})},
        {"scaled", Pose::from_matrix({0x1p-300, 0, 0, 0, 0x1p-300, 0, 0, 0, 0x1p-300}, {0, 0, 0})},
        {"shifted", Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {1000, -0.5, 0x1p40})},
        {"shifted far", Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {1e300, -1e300, 1e-300})},
        {"sheared", Pose::from_matrix({1, 0.3, 0, 0, 1, 0.7, 0.1, 0, 1}, {0.1, 0.2, 0.3})},
        {"rotated",
         Pose::from_quaternion(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 0.5, {0.1, 7, -3})},
        {"flattened", Pose::from_matrix({1, 0.3, 0, 0, 0x1p-40, 0, 0.1, 0, 0x1p40}, {0.1, 0.2, 0.3})}};
    for (const auto& [name, pose] : maps) expect_contact(a, pose, b, pose, contact, t.name + " " + name);
  }
}

// P3 and P1 on random bodies of all dimensions against the scan; the differential test has the nasty ones.
TEST(PolyhedronPolyhedronTest, P3_CertificatesAreAccepted) {
  Random random(tests::chosen_seed(101));
  int meets = 0;
  constexpr int count = 600;
  for (int i = 0; i < count; ++i) {
    const auto some_body = [&] {
      Points points;
      for (std::int64_t n = random.between(1, 12); n > 0; --n) {
        points.push_back(tests::in_cube(random));
      }
      return ConvexPolyhedron(points);
    };
    const ConvexPolyhedron a = some_body(), b = some_body();
    const Pose pose = Pose::from_quaternion(random.uniform(0.1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                                            random.uniform(-1, 1), {random.uniform(-1, 1), 0, 0});
    const bool meet = polyhedron_polyhedron_by_scan(a, Pose(), b, pose).meet();
    meets += meet;
    for (const auto& [name, method] : methods) {
      const PairAnswer answer = method(a, Pose(), b, pose);
      ASSERT_EQ(answer.meet(), meet) << i << " " << name;
      ASSERT_EQ(check_absolutely(answer.evidence, {a.vertices(), Pose().affine(), false},
                                 {b.vertices(), pose.affine(), false}),
                CheckResult::accepted)
          << i << " " << name;
    }
  }
  EXPECT_GT(meets, count / 5);
  EXPECT_LT(meets, count - count / 5);
}

// All of an answer as text, but for what its direction's kind leaves meaningless.
std::string text_of(const PairAnswer& answer) {
  std::string out = answer.meet() ? "meet" : "apart";
  const auto add = [&](const auto& x) { out += ' ' + std::to_string(x); };
  if (const auto* common = std::get_if<CommonVertices>(&answer.evidence)) {
    add(common->count_a);
    for (std::size_t i = 0; i < std::size_t{common->count_a} + common->count_b; ++i) add(common->vertices[i]);
  } else {
    const auto& [direction, extreme_a, extreme_b] = std::get<Separation>(answer.evidence);
    add(static_cast<int>(direction.kind));
    add(extreme_a);
    add(extreme_b);
    if (direction.kind == Direction::Kind::given) {
      for (const double x : {direction.given.x, direction.given.y, direction.given.z})
        out += ' ' + Dyadic(x).hexadecimal();
    } else if (direction.kind == Direction::Kind::exact) {
      for (const Dyadic& x : *direction.numbers) out += ' ' + x.hexadecimal();
    } else {
      add(direction.reversed ? 1 : 0);
      for (const std::uint32_t v : direction.index) add(v);
    }
  }
  out += ' ' + std::string(name_of(answer.decided_by));
  add(answer.cost.probes);
  add(answer.cost.iterations);
  add(answer.cost.exact);
  return out;
}

// P4: from many threads at once, in any order, on bodies made anew, the same answers, certificates and counts. (That
// compilers agree is for the lanes that compare builds.)
TEST(PolyhedronPolyhedronTest, P4_AnswersAreReproducible) {
  struct Question {
    Points a, b;
    Pose pose_a, pose_b;
  };
  std::vector<Question> questions;
  for (const Touch& t : touches()) questions.push_back({t.a, t.b, Pose(), Pose()});
  Random random(tests::chosen_seed(103));
  for (int i = 0; i < 100; ++i) {
    Question q;
    for (int k = 0; k < 50; ++k) {
      q.a.push_back(tests::in_cube(random));
      q.b.push_back(tests::in_cube(random));
    }
    q.pose_b = Pose::from_quaternion(0.3, random.uniform(-1, 1), 0.2, 0.1, {random.uniform(-3, 3), 0, 0});
    questions.push_back(q);
  }
  std::vector<std::pair<ConvexPolyhedron, ConvexPolyhedron>> bodies;
  for (const Question& q : questions) bodies.emplace_back(ConvexPolyhedron(q.a), ConvexPolyhedron(q.b));
  const std::size_t n = questions.size();
  std::vector<std::string> first(n);
  for (std::size_t i = 0; i < n; ++i) {
    first[i] =
        text_of(polyhedron_polyhedron(bodies[i].first, questions[i].pose_a, bodies[i].second, questions[i].pose_b));
  }
  constexpr std::size_t threads = 4;
  std::vector<std::vector<std::string>> again(threads, std::vector<std::string>(n));
  std::vector<std::thread> running;
  for (std::size_t t = 0; t < threads; ++t) {
    running.emplace_back([&, t] {
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = (k * (2 * t + 1) + t) % n;
        const Question& q = questions[i];
        again[t][i] =
            t == 0 ? text_of(polyhedron_polyhedron(ConvexPolyhedron(q.a), q.pose_a, ConvexPolyhedron(q.b), q.pose_b))
                   : text_of(polyhedron_polyhedron(bodies[i].first, q.pose_a, bodies[i].second, q.pose_b));
      }
    });
  }
  for (std::thread& t : running) t.join();
  for (std::size_t t = 0; t < threads; ++t) {
    for (std::size_t i = 0; i < n; ++i) {
      if (again[t][i].empty()) continue;  // k -> k m + t need not reach every question
      EXPECT_EQ(again[t][i], first[i]) << t << " " << i;
    }
  }
  EXPECT_EQ(std::set<std::string>(first.begin(), first.end()).count(""), 0u);
}

// General position: filters decide nearly always, the search is short, and nothing is allocated.
TEST(PolyhedronPolyhedronTest, FiltersDecideInGeneral) {
  Random random(tests::chosen_seed(107));
  int filter = 0, meets = 0;
  std::uint64_t allocated = 0;
  double iterations = 0;
  constexpr int count = 2000;
  std::vector<ConvexPolyhedron> pool;
  for (int i = 0; i < 30; ++i) {
    Points points;
    for (int k = 0; k < 10 + 10 * i; ++k) points.push_back(tests::in_cube(random));
    pool.emplace_back(points);
  }
  for (int i = 0; i < count; ++i) {
    const auto some_pose = [&](double distance) {
      return Pose::from_quaternion(
          random.uniform(0.1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
          {distance * random.uniform(-1, 1), distance * random.uniform(-1, 1), distance * random.uniform(-1, 1)});
    };
    const ConvexPolyhedron &a = pool[random.below(pool.size())], &b = pool[random.below(pool.size())];
    const Pose here = some_pose(0), there = some_pose(3);
    const std::uint64_t before = allocations;
    const PairAnswer answer = polyhedron_polyhedron(a, here, b, there);
    if (answer.decided_by == DecidedBy::filter) allocated += allocations - before;
    filter += answer.decided_by == DecidedBy::filter;
    EXPECT_EQ(answer.cost.exact == 0, answer.decided_by == DecidedBy::filter);
    meets += answer.meet();
    iterations += answer.cost.iterations;
    EXPECT_GT(answer.cost.probes, 0u);
  }
  EXPECT_GE(filter, count - count / 100);
  EXPECT_EQ(allocated, 0u);
  EXPECT_NE(allocations == 0, SUNDER_UNDER_THREAD_SANITIZER == 0);  // they are counted
  EXPECT_LT(iterations / count, 8);
  EXPECT_GT(meets, count / 10);
  EXPECT_LT(meets, count - count / 10);
}

// Here, because memory is refused here. Where there is none for more threads, those that there are do the work.
TEST(PolyhedronPolyhedronBatch, DoesWithoutTheThreadsThatThereIsNoMemoryFor) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  const Pose here, there = tests::shift(50, 0, 0);
  const std::vector<PlacedPair> pairs(1000, PlacedPair{&cube, &here, &cube, &there});
  for (std::uint64_t more = 0; more < 12; ++more) {
    std::vector<std::uint8_t> meet(pairs.size(), 7);
    bool has_thrown = false;
    most_allocations = allocations + more;
    try {
      polyhedron_polyhedron_batch(pairs, meet, {6, {}});
    } catch (const std::bad_alloc&) {
      has_thrown = true;
    }
    most_allocations = UINT64_MAX;
    EXPECT_FALSE(has_thrown) << more;
    EXPECT_EQ(meet, std::vector<std::uint8_t>(pairs.size(), 0)) << more;
  }
}

// No cliff between the tame range and the scales at which the search works in another unit.
TEST(PolyhedronPolyhedronTest, FiltersDecideAtEveryScale) {
  Random random(tests::chosen_seed(109));
  std::vector<ConvexPolyhedron> pool;
  for (int i = 0; i < 10; ++i) {
    Points points;
    for (int k = 0; k < 30; ++k) points.push_back(tests::in_cube(random));
    pool.emplace_back(points);
  }
  for (int e = -900; e <= 900; e += 15) {
    int finishing = 0;
    for (int i = 0; i < 40; ++i) {
      const double s = std::ldexp(1.0, e);
      std::array<double, 9> linear =
          Pose::from_quaternion(0.5, random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), {})
              .affine()
              .linear;
      for (double& x : linear) x *= s;
      const Pose here = Pose::from_matrix(linear, {0, 0, 0});
      const Pose there =
          Pose::from_matrix({s, 0, 0, 0, s, 0, 0, 0, s}, {s * random.uniform(-2, 2), s * random.uniform(-1, 1), 0});
      finishing += polyhedron_polyhedron(pool[random.below(10)], here, pool[random.below(10)], there).decided_by ==
                   DecidedBy::finishing;
    }
    EXPECT_LE(finishing, 1) << "scale 2^" << e;
  }
}

// Contact is where evidence is hard to find. These are the rates that the design has reached, with some slack: filters
// decide near contact because directions are tilted, and the search's evidence holds at contact because negligible
// weights are dropped.
TEST(PolyhedronPolyhedronTest, EvidenceHoldsNearContact) {
  tests::SolidPairs pairs(tests::chosen_seed(113));
  const int count = tests::scaled_count(1000, 200);
  const auto shares = [&](tests::Family family) {
    std::array<double, 3> share{};
    for (int i = 0; i < count; ++i) {
      const tests::PairCase c = pairs.next(family);
      const PairAnswer answer = polyhedron_polyhedron(c.a, c.pose_a, c.b, c.pose_b);
      share[static_cast<std::size_t>(answer.decided_by)] += 1.0 / count;
    }
    return share;
  };
  EXPECT_LE(shares(tests::Family::touching)[2], 0.005);
  EXPECT_LE(shares(tests::Family::grid)[2], 0.005);
  EXPECT_LE(shares(tests::Family::contained)[2], 0.005);
  EXPECT_LE(shares(tests::Family::last_bit)[2], 0.005);
  const auto near_contact = shares(tests::Family::near_contact);
  EXPECT_GE(near_contact[0], 0.75);
  EXPECT_LE(near_contact[2], 0.005);
}

// A vertex of B rounded into a facet of A, all coordinates of 53 irregular bits: searches then walk over differences
// that are rounding noise.
TEST(PolyhedronPolyhedronTest, TheNoiseOfIrregularNumbers) {
  Random random(tests::chosen_seed(131));
  const int count = tests::scaled_count(4000);
  int meets = 0, finished = 0;
  for (int i = 0; i < count; ++i) {
    const auto point = [&] { return tests::in_cube(random); };
    const std::array<Point3, 4> p{point(), point(), point(), point()};
    double s = random.unit(), t = random.unit();
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const auto inside = [&](double x, double y, double z) { return x + s * (y - x) + t * (z - x); };
    const Point3 tip{inside(p[0].x, p[1].x, p[2].x), inside(p[0].y, p[1].y, p[2].y), inside(p[0].z, p[1].z, p[2].z)};
    Points q{tip};
    for (int k = 0; k < 3; ++k) {  // away from A's fourth vertex
      const Point3 off = point();
      q.push_back(
          {2 * tip.x - p[3].x + 0.1 * off.x, 2 * tip.y - p[3].y + 0.1 * off.y, 2 * tip.z - p[3].z + 0.1 * off.z});
    }
    const ConvexPolyhedron a(p), b(q);
    const PairAnswer answer = polyhedron_polyhedron(a, Pose(), b, Pose());
    ASSERT_EQ(answer.meet(), polyhedron_polyhedron_by_scan(a, Pose(), b, Pose()).meet()) << i;
    ASSERT_EQ(check_absolutely(answer.evidence, {a.vertices(), Pose().affine(), false},
                               {b.vertices(), Pose().affine(), false}),
              CheckResult::accepted)
        << i;
    meets += answer.meet();
    finished += answer.decided_by == DecidedBy::finishing;
  }
  if (count < 1000) return;
  EXPECT_GT(meets, count / 4);
  EXPECT_LT(meets, count - count / 4);
  EXPECT_LE(finished, count / 200);
}

TEST(PolyhedronPolyhedronTest, NamesAreDifferent) {
  EXPECT_EQ(name_of(DecidedBy::filter), "filter");
  EXPECT_EQ(name_of(DecidedBy::evidence), "evidence");
  EXPECT_EQ(name_of(DecidedBy::finishing), "finishing");
  EXPECT_EQ(name_of(Relation::none), "none");
  EXPECT_EQ(name_of(Relation::touching), "touching");
  EXPECT_EQ(name_of(Relation::overlapping), "overlapping");
}

TEST(PolyhedronPolyhedronTest, TheShortNameAnswersTheSame) {
  const ConvexPolyhedron box(tests::cube_corners(-1, 1));
  EXPECT_TRUE(intersect(box, box).meet());
  EXPECT_FALSE(intersect(box, ConvexPolyhedron(moved_points(tests::cube_corners(-1, 1), {3, 0, 0}))).meet());
}

}  // namespace
}  // namespace sunder::solid
