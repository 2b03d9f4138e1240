// When meshes first meet that move straight: down their trees against each triangle with each, by the simplex method on
// fractions of support/sweep_oracle.h; and where meshes are at single times, as mesh_mesh() decides. With proofs. And how
// many boxes and triangles that takes, over three decades.
#include <tests/support/mesh_proofs.h>
#include <tests/support/mesh_soups.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/sweep_oracle.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_motion.h>
#include <sunder/solid/object/translation.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <vector>

namespace sunder::tests {
namespace {

using solid::Mesh;
using solid::MeshMotion;
using solid::Pose;
using solid::SweepContact;
using solid::Translation;

using Numbers = std::array<double, 3>;

Pose moved(const Pose& pose, const Numbers& by) {
  Numbers at = pose.affine().translation;
  for (std::size_t c = 0; c < 3; ++c) at[c] += by[c];
  return Pose::from_matrix(pose.affine().linear, at);
}

// Where it is at a time that is a double, if that is exactly so in doubles: of whole numbers, and a time of few digits.
Pose at_time(const Translation& of, double time) {
  Numbers at{};
  for (std::size_t c = 0; c < 3; ++c) {
    at[c] = (1 - time) * of.begin().affine().translation[c] + time * of.end().affine().translation[c];
  }
  return Pose::from_matrix(of.begin().affine().linear, at);
}

struct Moving {
  Mesh a, b;
  Translation of_a, of_b;

  MovingHull triangle(bool is_a, std::uint32_t t) const {
    const Mesh& mesh = is_a ? a : b;
    const Translation& of = is_a ? of_a : of_b;
    std::vector<Point3> corners;
    for (const std::uint32_t k : mesh.triangles()[t]) corners.push_back(mesh.points()[k]);
    return {corners, of.begin().affine(), of.end().affine()};
  }
  bool meet_at(double time) const { return mesh_mesh(a, at_time(of_a, time), b, at_time(of_b, time)).meet(); }
};

Fraction fraction_of(const ExactFraction& x) {
  return tests::fraction_of(x.numerator) / tests::fraction_of(x.denominator);
}

std::optional<Fraction> first_of_triangles(const Moving& m) {
  std::vector<MovingHull> of_a, of_b;
  for (std::uint32_t t = 0; t < m.a.triangles().size(); ++t) of_a.push_back(m.triangle(true, t));
  for (std::uint32_t u = 0; u < m.b.triangles().size(); ++u) of_b.push_back(m.triangle(false, u));
  std::optional<Fraction> first;
  for (const MovingHull& t : of_a) {
    for (const MovingHull& u : of_b) {
      const auto time = first_time(t, u);
      if (time && (!first || *time < *first)) first = time;
    }
  }
  return first;
}

// The weights are those of corners of the triangle, and make the point.
void expect_point(const Moving& m, bool is_a, std::uint32_t triangle, const SweepContact& contact) {
  const Mesh::Triangle& corners = (is_a ? m.a : m.b).triangles()[triangle];
  const MovingHull hull = m.triangle(is_a, triangle);
  const Combination& of = is_a ? contact.point.of_a : contact.point.of_b;
  FractionPoint sum{0, 0, 0};
  Fraction whole = 0;
  for (const auto& [point, numerator] : of.parts) {
    const Fraction weight = tests::fraction_of(numerator) / tests::fraction_of(of.denominator);
    EXPECT_GT(weight, 0);
    whole += weight;
    std::size_t k = 0;
    while (k < 3 && corners[k] != point) ++k;
    ASSERT_LT(k, 3u);
    const FractionPoint p = hull.point(k, fraction_of(contact.time));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * p[c];
  }
  EXPECT_EQ(whole, 1);
  const auto& [x, y, z, denominator] = contact.point.at;
  const std::array<Dyadic, 3> at{x, y, z};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(sum[c], tests::fraction_of(at[c]) / tests::fraction_of(denominator));
  }
}

// Some are pressed flat, into one plane or onto one line: there bounds of boxes and triangles tell little.
Mesh some_mesh(Random& random, int i) {
  Soup soup = some_soup(random);
  for (Point3& p : soup.points) {
    if (i % 8 == 7) p.z = 0;
    if (i % 16 == 15) p.y = 0;
  }
  return soup.mesh();
}

Moving some_motion(Random& random, int i) {
  const auto whole = [&](int size) { return static_cast<double>(random.between(-size, size)); };
  const bool is_flat = i % 8 == 7;
  const Pose pose_a = i % 4 < 2 || is_flat ? Pose() : soup_pose(random, i),
             pose_b = i % 4 < 2 ? small_pose(random) : Pose();
  const double in_plane = is_flat ? 0 : 1;
  const Numbers by{is_flat ? 9 : whole(12), whole(12), in_plane * whole(12)}, rest{};
  const bool both = random.below(2) == 0;
  return {some_mesh(random, i),
          some_mesh(random, i),
          {pose_a, moved(pose_a, both ? Numbers{whole(3), whole(3), in_plane * whole(3)} : rest)},
          {moved(pose_b, by), moved(pose_b, {is_flat ? -9 : whole(12), whole(12), in_plane * whole(12)})}};
}

TEST(MeshMotionDifferential, TreesAgreeWithAllPairs) {
  Random random(chosen_seed(4131));
  const int times = scaled_count(40);
  int later = 0, apart = 0;
  for (int i = 0; i < times; ++i) {
    const Moving m = some_motion(random, i);
    const MeshMotion found = mesh_motion(m.a, m.of_a, m.b, m.of_b);
    const bool meet_at_start = mesh_mesh(m.a, m.of_a.begin(), m.b, m.of_b.begin()).meet();
    const SweepContact* const contact = contact_on_the_way(found);
    ASSERT_EQ(found.meet() && contact == nullptr, meet_at_start) << i;
    if (meet_at_start) {
      EXPECT_EQ(first_time_of(found), ExactFraction{});
      const auto* within = std::get_if<solid::PointWithin>(&found.evidence);
      EXPECT_EQ(proved_motion(m.a, m.of_a, m.b, m.of_b, found), within == nullptr ? "meet"
                                                                : within->is_of_a ? "a_within"
                                                                                  : "b_within");
      continue;
    }
    EXPECT_EQ(proved_motion(m.a, m.of_a, m.b, m.of_b, found), !found.meet() ? "apart" : "first") << i;
    const MeshMotion exchanged = mesh_motion(m.b, m.of_b, m.a, m.of_a);
    ASSERT_EQ(exchanged.meet(), found.meet()) << i;
    if (i % 3 == 0) {
      const std::optional<Fraction> first = first_of_triangles(m);
      ASSERT_EQ(first.has_value(), found.meet()) << i;
      if (first) {
        ASSERT_EQ(*first, fraction_of(contact->time)) << i;
      }
    } else {
      const MeshMotion scan = mesh_motion_by_scan(m.a, m.of_a, m.b, m.of_b);
      ASSERT_EQ(scan.meet(), found.meet()) << i;
      if (found.meet()) {
        ASSERT_EQ(first_time_of(scan), contact->time) << i;
      }
    }
    if (contact == nullptr) {
      ++apart;
      continue;
    }
    ++later;
    ASSERT_EQ(contact->time, first_time_of(exchanged)) << i;
    const auto& [of_a, of_b, shared] = std::get<solid::TrianglesOnTheWay>(found.evidence);
    expect_point(m, true, of_a, *contact);
    expect_point(m, false, of_b, *contact);
  }
  EXPECT_GE(later, times / 6);
  EXPECT_GE(apart, times / 6);
}

// Whole coordinates, and ways that are powers of two: so times of one moving mesh are doubles, and what is placed at such
// a time is so exactly. There they touch, and are apart just before.
TEST(MeshMotionDifferential, TheyTouchThenAndNotBefore) {
  Random random(chosen_seed(4132));
  const int times = scaled_count(400);
  int touching = 0;
  for (int i = 0; i < times; ++i) {
    const Mesh a = some_soup(random).mesh(), b = some_soup(random).mesh();
    const auto whole = [&](int size) { return static_cast<double>(random.between(-size, size)); };
    Numbers from{whole(6), whole(6), whole(6)}, to = from;
    const std::size_t along = random.below(3);
    from[along] = -8;
    to[along] = 8;
    const auto at = [](const Numbers& t) { return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, t); };
    const Moving m{a, b, Translation(Pose()), {at(from), at(to)}};
    const MeshMotion found = mesh_motion(m.a, m.of_a, m.b, m.of_b);
    const SweepContact* const contact = contact_on_the_way(found);
    for (int k = 0; k <= 64 && !found.meet(); ++k) ASSERT_FALSE(m.meet_at(k / 64.0)) << i << " " << k;
    if (contact == nullptr) continue;
    const double time = contact->time.nearest();
    for (int k = 0; k / 64.0 < time; ++k) ASSERT_FALSE(m.meet_at(k / 64.0)) << i << " " << k;
    if (contact->time != ExactFraction{Dyadic(time)} || std::ldexp(time, 40) != std::floor(std::ldexp(time, 40)))
      continue;
    ++touching;
    ASSERT_TRUE(m.meet_at(time)) << i;
    ASSERT_FALSE(m.meet_at(time - 0x1p-44)) << i;
  }
  EXPECT_GE(touching, times / 8);
}

// Scaled by powers of two, near to the ends of the doubles, too, the time stays the same.
TEST(MeshMotionDifferential, OfAnySize) {
  Random random(chosen_seed(4133));
  const int times = scaled_count(20);
  int met = 0;
  for (int i = 0; i < times; ++i) {
    const Moving m = some_motion(random, i);
    const MeshMotion found = mesh_motion(m.a, m.of_a, m.b, m.of_b);
    for (const int k : {-1000, -150, 300, 900}) {
      if (i % 4 != 0 && (k == -1000 || k == 900)) continue;  // where exact numbers decide about all
      const auto scaled = [&](const Pose& pose) {
        auto [linear, translation] = pose.affine();
        for (double& entry : linear) entry = std::ldexp(entry, k);
        for (double& entry : translation) entry = std::ldexp(entry, k);
        return Pose::from_matrix(linear, translation);
      };
      const MeshMotion other = mesh_motion(m.a, {scaled(m.of_a.begin()), scaled(m.of_a.end())}, m.b,
                                           {scaled(m.of_b.begin()), scaled(m.of_b.end())});
      ASSERT_EQ(other.meet(), found.meet()) << i << " " << k;
      if (!found.meet()) continue;
      ++met;
      ASSERT_EQ(first_time_of(other), first_time_of(found)) << i << " " << k;
    }
  }
  EXPECT_GE(met, times / 4);
}

// Four triangles of one leaf, one behind the other, from either side: which comes first is told by floating point, or, near
// the ends of the doubles, found by looking at each; also where one that is met later was looked at before.
TEST(MeshMotionDifferential, TheFirstOfOneLeaf) {
  Soup one, four;
  for (const double x : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    Soup& soup = x == 0 ? one : four;
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    soup.add_face({first, first + 1, first + 2});
  }
  const Mesh a = one.mesh(), b = four.mesh();
  for (const int k : {0, 900}) {
    for (const double way : {10.0, -10.0}) {
      const double size = std::ldexp(1.0, k);
      const auto at = [&](double x) {
        return Pose::from_matrix({size, 0, 0, 0, size, 0, 0, 0, size}, {size * x, 0, 0});
      };
      const double from = way > 0 ? 0 : 5;
      const MeshMotion found = mesh_motion(a, {at(from), at(from + way)}, b, Translation(at(0)));
      EXPECT_TRUE(found.meet());
      EXPECT_EQ(first_time_of(found), (ExactFraction{Dyadic(1.0), Dyadic(10.0)})) << k << " " << way;
    }
  }
}

// A sphere with bumps comes to another one from afar: into its middle; and past it, by a thousandth of its size.
TEST(MeshMotionDifferential, LooksAreFew) {
  Random random(chosen_seed(4134));
  for (const std::size_t n : {100u, 1000u, 10000u, 50000u}) {
    if (is_scaled_down() && n > 1000) break;
    const Mesh a = bumpy(n, random), b = bumpy(n, random);
    constexpr int times = 10;
    double into = 0, past = 0, exact = 0;
    for (int i = 0; i < times; ++i) {
      const Point3 d = on_sphere(random), e = on_sphere(random);
      const double along = d.x * e.x + d.y * e.y + d.z * e.z;
      const Point3 f{e.x - along * d.x, e.y - along * d.y, e.z - along * d.z};  // across d
      const double length = std::sqrt(f.x * f.x + f.y * f.y + f.z * f.z);
      const double w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const auto at = [&](double t, double aside) {
        return Pose::from_quaternion(
            w, x, y, 1,
            {t * d.x + aside * f.x / length, t * d.y + aside * f.y / length, t * d.z + aside * f.z / length});
      };
      const auto ask = [&](double aside) {
        return mesh_motion(a, Translation(Pose()), b, {at(-5, aside), at(5, aside)});
      };
      const MeshMotion found = ask(0);
      EXPECT_TRUE(found.meet());
      into += static_cast<double>(found.cost.probes) / times;
      exact += static_cast<double>(found.cost.iterations) / times;
      double meeting = 1, apart = 2.5;
      while (apart - meeting > 1e-3) {
        const double middle = (meeting + apart) / 2;
        (ask(middle).meet() ? meeting : apart) = middle;
      }
      past += static_cast<double>(ask(apart).cost.probes) / times;
    }
    const double log_n = std::log2(static_cast<double>(n));
    std::printf("n %6zu: %8.0f probes into, %8.0f past, %4.1f exact; %.1f, %.1f times log2 n\n", n, into, past, exact,
                into / log_n, past / log_n);
    EXPECT_LE(into, 180 * log_n);
    EXPECT_LE(past, 370 * log_n);
    EXPECT_LE(exact, 3);
  }
}

}  // namespace
}  // namespace sunder::tests
