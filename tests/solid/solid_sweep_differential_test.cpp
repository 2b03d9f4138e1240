// polyhedron_polyhedron_sweep and polyhedron_polyhedron_first_contact against a simplex method on fractions over all
// vertices (support/sweep_oracle.h), and their evidence by plain sums of fractions; and against each other under
// symmetries.
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/sweep_oracle.h>

#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_sweep.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::CommonVerticesAtAnEnd;
using solid::ContactOnTheWay;
using solid::ConvexPolyhedron;
using solid::Pose;
using solid::SweepAnswer;
using solid::SweepContact;
using solid::Translation;

struct Moving {
  ConvexPolyhedron a, b;
  Translation of_a, of_b;

  MovingHull hull_a() const { return {a.vertices(), of_a.begin().affine(), of_a.end().affine()}; }
  MovingHull hull_b() const { return {b.vertices(), of_b.begin().affine(), of_b.end().affine()}; }
};

Pose pose_at(const Pose& turned, const Point3& t) { return Pose::from_matrix(turned.affine().linear, {t.x, t.y, t.z}); }
Translation along(const Pose& turned, const Point3& from, const Point3& to) {
  return {pose_at(turned, from), pose_at(turned, to)};
}

ConvexPolyhedron some_body(Random& random) {
  if (random.below(8) == 0) return ConvexPolyhedron(points_in_cube(1 + random.below(3), random));  // flat
  return ConvexPolyhedron(points_in_cube(4 + random.below(7), random));
}
ConvexPolyhedron grid_body(Random& random) {
  std::vector<Point3> points;
  for (std::size_t n = 1 + random.below(8); n > 0; --n) points.push_back(on_grid(random, 2));
  return ConvexPolyhedron(points);
}
Pose some_turn(Random& random) {
  if (random.below(3) == 0) return Pose();
  return Pose::from_quaternion(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 0.7, {});
}
Point3 times(const Point3& p, double by) { return {p.x * by, p.y * by, p.z * by}; }
Point3 sum(const Point3& p, const Point3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }

Fraction dot_product(const FractionPoint& p, const FractionPoint& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

FractionPoint fractions(const std::array<Dyadic, 3>& d) {
  return {fraction_of(d[0]), fraction_of(d[1]), fraction_of(d[2])};
}

// How much further B begins along the direction than A ends, at that time.
Fraction gap(const MovingHull& a, const MovingHull& b, const FractionPoint& d, const Fraction& time) {
  Fraction last = dot_product(a.point(0, time), d), first = dot_product(b.point(0, time), d);
  for (std::size_t i = 0; i < a.turned.size(); ++i) last = std::max(last, dot_product(a.point(i, time), d));
  for (std::size_t j = 0; j < b.turned.size(); ++j) first = std::min(first, dot_product(b.point(j, time), d));
  return first - last;
}

FractionPoint mean(const MovingHull& hull, const Combination& of, const Fraction& time) {
  FractionPoint p{0, 0, 0};
  Fraction whole = 0;
  for (const auto& [entry, numerator] : of.parts) {
    const Fraction weight = fraction_of(numerator) / fraction_of(of.denominator);
    EXPECT_GT(weight, 0);
    whole += weight;
    const FractionPoint q = hull.point(entry, time);
    for (std::size_t k = 0; k < 3; ++k) p[k] += weight * q[k];
  }
  EXPECT_EQ(whole, 1);
  return p;
}

// Returns the time.
Fraction expect_contact(const Moving& m, const SweepContact& contact) {
  const Fraction time = fraction_of(contact.time.numerator) / fraction_of(contact.time.denominator);
  EXPECT_TRUE(time >= 0 && time <= 1);
  const MovingHull a = m.hull_a(), b = m.hull_b();
  const auto& [x, y, z, denominator] = contact.point.at;
  FractionPoint point = fractions({x, y, z});
  for (Fraction& number : point) number /= fraction_of(denominator);
  EXPECT_EQ(mean(a, contact.point.of_a, time), point);
  EXPECT_EQ(mean(b, contact.point.of_b, time), point);
  const Interval about = contact.time.enclosure();
  EXPECT_TRUE(fraction_of(about.low) <= time && time <= fraction_of(about.high));
  EXPECT_LE(about.high, std::nextafter(about.low, 2.0));
  return time;
}

// What the library says of the motion, as a file: the answer's own evidence, and the first contact.
std::string motion_certificate(const Moving& m, const SweepAnswer& answer, const std::optional<SweepContact>& first) {
  return claims_text({}, [&](ClaimsWriter& file) {
    PairClaims pairs(file);
    const auto add = [&](const ConvexPolyhedron& body, const Translation& of) {
      const std::uint32_t base = pairs.add_body("body", body.vertices());
      const std::uint32_t begin = pairs.add_placed("begin", base, of.begin().affine());
      return std::pair(begin, of.rests() ? begin : pairs.add_placed("end", base, of.end().affine()));
    };
    const auto [a, to_a] = add(m.a, m.of_a);
    const auto [b, to_b] = add(m.b, m.of_b);
    const auto add_meet = [&](const SweepContact& c, const std::array<Dyadic, 3>* along) {
      pairs.add_motion_meet(a, b, to_a, to_b, c.time, c.point, along);
    };
    if (!answer.meet()) {
      pairs.add_motion_apart(a, b, to_a, to_b, solid::parting_direction(answer, m.a, m.of_a, m.b, m.of_b));
    } else if (const auto* between = std::get_if<ContactOnTheWay>(&answer.evidence)) {
      add_meet(*between->contact, nullptr);
    }
    if (first) add_meet(*first, first->time.numerator.sign() == Sign::zero ? nullptr : &first->direction);
  });
}

// Returns how it was decided.
SweepAnswer expect_right(const Moving& m, const std::optional<Fraction>& first) {
  const MovingHull a = m.hull_a(), b = m.hull_b();
  SweepAnswer answer = solid::polyhedron_polyhedron_sweep(m.a, m.of_a, m.b, m.of_b);
  EXPECT_EQ(answer.meet(), first.has_value());
  const auto contact = solid::polyhedron_polyhedron_first_contact(m.a, m.of_a, m.b, m.of_b);
  EXPECT_EQ(contact.has_value(), first.has_value());
  if (!answer.meet()) {
    const FractionPoint d = fractions(solid::parting_direction(answer, m.a, m.of_a, m.b, m.of_b));
    EXPECT_GT(gap(a, b, d, 0), 0);
    EXPECT_GT(gap(a, b, d, 1), 0);
  } else if (const auto* between = std::get_if<ContactOnTheWay>(&answer.evidence)) {
    expect_contact(m, *between->contact);
  } else {
    const bool at_end = std::get<CommonVerticesAtAnEnd>(answer.evidence).is_at_end;
    EXPECT_TRUE(solid::polyhedron_polyhedron(m.a, at_end ? m.of_a.end() : m.of_a.begin(), m.b,
                                             at_end ? m.of_b.end() : m.of_b.begin())
                    .meet());
  }
  if (contact && first) {
    const Fraction time = expect_contact(m, *contact);
    EXPECT_EQ(time, *first);
    const FractionPoint d = fractions(contact->direction);
    if (time > 0) {
      EXPECT_GT(gap(a, b, d, 0), 0);
      EXPECT_EQ(gap(a, b, d, time), 0);
    } else {
      EXPECT_EQ(d, (FractionPoint{0, 0, 0}));
    }
  }
  const auto checked = sunder_verifier::verify_text(motion_certificate(m, answer, contact), "motion");
  EXPECT_TRUE(checked.accepted()) << checked.error << checked.failed_form;
  return answer;
}

struct SweepTally {
  int apart = 0, at_begin = 0, at_end = 0, between = 0, finished = 0;

  void count(const SweepAnswer& answer) {
    const auto* end = std::get_if<CommonVerticesAtAnEnd>(&answer.evidence);
    ++(!answer.meet() ? apart : end == nullptr ? between : end->is_at_end ? at_end : at_begin);
    finished += answer.decided_by == DecidedBy::finishing;
  }
  void print(const char* what) const {
    std::printf("%s: apart %d, meet at the begin %d, at the end %d, between %d; finished exactly %d\n", what, apart,
                at_begin, at_end, between, finished);
  }
};

TEST(SolidSweepDifferential, GeneralMotionsOfBoth) {
  const int count = scaled_count(1000, 60);
  const std::uint64_t seed = chosen_seed(20270101);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  SweepTally tally;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    // From one side to about the other one.
    const auto near = [&](double side) { return sum(times(in_cube(random), 1.5), {side, 0, 0}); };
    const Moving m{some_body(random), some_body(random), along(some_turn(random), near(-1), near(1)),
                   along(some_turn(random), near(2), near(-2))};
    tally.count(expect_right(m, first_time(m.hull_a(), m.hull_b())));
  }
  tally.print("general");
  EXPECT_GT(tally.apart, count / 8);
  EXPECT_GT(tally.between, count / 8);
  EXPECT_GE(tally.at_begin, count / 500);
  EXPECT_LT(tally.finished, tally.between + count / 8);  // what is apart is mostly found by the search
}

TEST(SolidSweepDifferential, GridsWhereAllIsDegenerate) {
  const int count = scaled_count(2500, 100);
  const std::uint64_t seed = chosen_seed(20270102);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  SweepTally tally;
  int at_one_time = 0, first_at_end = 0, rational = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    const auto at = [&] { return on_grid(random, 5); };
    const Point3 a0 = at(), a1 = random.below(2) ? a0 : at(), b0 = at(), b1 = at();
    const Moving m{grid_body(random), grid_body(random), along(Pose(), a0, a1), along(Pose(), b0, b1)};
    const Moving back{m.a, m.b, along(Pose(), a1, a0), along(Pose(), b1, b0)};
    const auto first = first_time(m.hull_a(), m.hull_b()), last = first_time(back.hull_a(), back.hull_b());
    tally.count(expect_right(m, first));
    if (!first) continue;
    at_one_time += *first + *last == 1;
    first_at_end += *first == 1;
    rational += !first->is_dyadic();
  }
  tally.print("grid");
  std::printf("at one time only %d, not before the end %d, at a time that is no double %d\n", at_one_time, first_at_end,
              rational);
  EXPECT_GE(at_one_time, count / 250);
  EXPECT_GE(first_at_end, count / 2500);
  EXPECT_GT(rational, count / 100);
  EXPECT_GT(tally.apart, count / 10);
}

// B goes by at a height; the greatest height at which it still meets A, to the last bit, and the next one.
TEST(SolidSweepDifferential, MissesByTheLastBit) {
  const int count = scaled_count(250, 12);
  const std::uint64_t seed = chosen_seed(20270103);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  SweepTally tally;
  int pairs = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    const ConvexPolyhedron a = some_body(random), b = some_body(random);
    const Pose turn_a = some_turn(random), turn_b = some_turn(random);
    const Point3 way = on_sphere(random), up = on_sphere(random), slip = times(on_sphere(random), random.unit());
    const auto at = [&](double height) {
      const Point3 from = sum(times(way, -4), times(up, height)), to = sum(times(way, 4), times(up, height));
      return Moving{a, b, along(turn_a, {}, slip), along(turn_b, from, to)};
    };
    const auto meet = [&](double height) {
      const Moving m = at(height);
      return solid::polyhedron_polyhedron_sweep(m.a, m.of_a, m.b, m.of_b).meet();
    };
    if (!meet(0)) continue;
    double low = 0, high = 8;
    for (int k = 0; k < 60 && std::nextafter(low, 8.0) < high; ++k) {
      const double middle = (low + high) / 2;
      (meet(middle) ? low : high) = middle;
    }
    ++pairs;
    for (const double height : {low, high}) {
      const Moving m = at(height);
      tally.count(expect_right(m, first_time(m.hull_a(), m.hull_b())));
    }
  }
  tally.print("last bit");
  EXPECT_GT(pairs, count / 8);
  EXPECT_EQ(tally.apart, pairs);  // the rounding of a height may, but never did, make verdicts come back
}

// Cubes: exact touch in passing, by face, by edge and by corner; and an ulp beside.
TEST(SolidSweepDifferential, TouchesInPassing) {
  const ConvexPolyhedron cube(cube_corners(0, 1));
  const auto from_to = [&](const Point3& from, const Point3& to) {
    return Moving{cube, cube, along(Pose(), {}, {}), along(Pose(), from, to)};
  };
  constexpr double one = 1, beside = one + std::numeric_limits<double>::epsilon();
  for (const auto& [from, to, meet] :
       std::vector<std::tuple<Point3, Point3, bool>>{{{-3, one, 0.25}, {3, one, 0.25}, true},
                                                     {{-3, beside, 0.25}, {3, beside, 0.25}, false},
                                                     {{-3, one, one}, {3, one, one}, true},
                                                     {{-3, one, beside}, {3, one, beside}, false},
                                                     {{-3, -1, 0}, {-1, 0.5, 0}, true},  // a face, at the end only
                                                     {{-3, -1, 0}, {-beside, 0.5, 0}, false},
                                                     {{-2, 0, 1}, {0, 2, 1}, true},  // corners pass at one time
                                                     {{-2, 0, one}, {0, 2, beside}, true},
                                                     {{-2, 1, 0}, {1, 4, 0}, false},
                                                     {{-2, -2, -2}, {2, 2, 2}, true},
                                                     {{5e-324, 1, 0}, {5e-324, 1, 0}, true},
                                                     {{beside, 0, 0}, {beside, 0, 0}, false},
                                                     {{-1e300, 0, 0}, {1e300, 0, 0}, true},
                                                     {{-1e300, beside, 0}, {1e300, beside, 0}, false},
                                                     {{-1e300, 1, 0}, {1e300, 1, 5e-324}, true}}) {
    SCOPED_TRACE(std::to_string(from.x) + " to " + std::to_string(to.x) + " at " + std::to_string(from.y));
    const Moving m = from_to(from, to);
    const auto first = first_time(m.hull_a(), m.hull_b());
    if (!(from == Point3{-2, 0, 1} && to.z == beside)) {
      EXPECT_EQ(first.has_value(), meet);
    }
    static_cast<void>(expect_right(m, first));
  }
}

// S2.
TEST(SolidSweepDifferential, Symmetries) {
  const int count = scaled_count(3000, 100);
  const std::uint64_t seed = chosen_seed(20270104);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int meet = 0, rest = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    const ConvexPolyhedron a = random.below(2) ? grid_body(random) : some_body(random), b = grid_body(random);
    const Point3 a0 = on_grid(random, 4), a1 = on_grid(random, 4), b0 = on_grid(random, 4), b1 = on_grid(random, 4),
                 shift0 = on_grid(random, 9), shift1 = on_grid(random, 9);
    const Translation of_a = along(Pose(), a0, a1), of_b = along(Pose(), b0, b1);
    const bool there = solid::polyhedron_polyhedron_sweep(a, of_a, b, of_b).meet();
    meet += there;
    EXPECT_EQ(solid::polyhedron_polyhedron_sweep(b, of_b, a, of_a).meet(), there);
    EXPECT_EQ(solid::polyhedron_polyhedron_sweep(a, along(Pose(), a1, a0), b, along(Pose(), b1, b0)).meet(), there);
    EXPECT_EQ(solid::polyhedron_polyhedron_sweep(a, along(Pose(), sum(a0, shift0), sum(a1, shift1)), b,
                                                 along(Pose(), sum(b0, shift0), sum(b1, shift1)))
                  .meet(),
              there);
    // At another scale: poses and bodies alike.
    const double by = random.below(2) ? 0x1p-900 : 0x1p900;
    const Pose scale = Pose::from_matrix({by, 0, 0, 0, by, 0, 0, 0, by}, {});
    const Translation big_a = along(scale, times(a0, by), times(a1, by)),
                      big_b = along(scale, times(b0, by), times(b1, by));
    EXPECT_EQ(solid::polyhedron_polyhedron_sweep(a, big_a, b, big_b).meet(), there);
    const auto first = solid::polyhedron_polyhedron_first_contact(a, of_a, b, of_b),
               scaled = solid::polyhedron_polyhedron_first_contact(a, big_a, b, big_b);
    EXPECT_EQ(first.has_value(), there);
    EXPECT_EQ(scaled.has_value(), there);
    if (first && scaled) {
      EXPECT_EQ(first->time, scaled->time);
    }
    // At rest.
    const Translation rests_a(pose_at(Pose(), a0)), rests_b(pose_at(Pose(), b0));
    const bool now = solid::polyhedron_polyhedron(a, rests_a.begin(), b, rests_b.begin()).meet();
    rest += now;
    EXPECT_EQ(solid::polyhedron_polyhedron_sweep(a, rests_a, b, rests_b).meet(), now);
    EXPECT_EQ(solid::polyhedron_polyhedron_first_contact(a, rests_a, b, rests_b).has_value(), now);
    EXPECT_TRUE(!now || there);
  }
  std::printf("meet in motion %d, at rest %d of %d\n", meet, rest, count);
  EXPECT_GT(meet, count / 10);
  EXPECT_LT(meet, count);
  EXPECT_GT(rest, 0);
}

TEST(SolidSweepDifferential, RefusesWhatTurns) {
  const Pose turned = Pose::from_quaternion(1, 0.1, 0, 0, {});
  EXPECT_FALSE(solid::is_translation(Pose(), turned));
  EXPECT_TRUE(solid::is_translation(turned, pose_at(turned, {1, 2, 3})));
  try {
    const Translation moves(Pose(), turned);
    FAIL() << "a turn was taken for a translation";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_pose);
  }
}

}  // namespace
}  // namespace sunder::tests
