// Every kind of contact, by hand and against fractions.
#include <sunder/base/random.h>
#include <sunder/number/integer_internal.h>
#include <sunder/planar/pair/segment_segment.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace sunder::planar {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Segment sorted(const Point2& p, const Point2& q) {
  return lexicographically_less(q, p) ? Segment{q, p} : Segment{p, q};
}

ContactKind contact_kind(const Segment& s, const Segment& t) {
  const ContactKind found = segment_segment(s, t);
  EXPECT_EQ(segment_segment(t, s), found);
  const auto mirrored = [](const Segment& u) { return sorted({-u.a.x, u.a.y}, {-u.b.x, u.b.y}); };
  const auto turned = [](const Segment& u) { return sorted({u.a.y, u.a.x}, {u.b.y, u.b.x}); };
  EXPECT_EQ(segment_segment(mirrored(s), mirrored(t)), found);
  EXPECT_EQ(segment_segment(turned(s), turned(t)), found);
  return found;
}

TEST(SegmentSegmentTest, ByHand) {
  const Segment s = sorted({0, 0}, {4, 2});
  EXPECT_EQ(contact_kind(s, sorted({0, 2}, {4, 0})), ContactKind::crossing);
  EXPECT_EQ(contact_kind(s, sorted({2, 1}, {2, 5})), ContactKind::touch);
  EXPECT_EQ(contact_kind(s, sorted({2, 5}, {2, -1})), ContactKind::crossing);  // vertical
  EXPECT_EQ(contact_kind(s, sorted({0, 1}, {4, 1})), ContactKind::crossing);   // horizontal
  EXPECT_EQ(contact_kind(s, sorted({4, 2}, {9, 9})), ContactKind::shared_endpoint);
  EXPECT_EQ(contact_kind(s, sorted({4, 2}, {8, 4})), ContactKind::shared_endpoint);  // one straight on from the other
  EXPECT_EQ(contact_kind(s, sorted({2, 1}, {8, 4})), ContactKind::overlap);
  EXPECT_EQ(contact_kind(s, sorted({0, 0}, {2, 1})), ContactKind::overlap);  // within, with an end in common
  EXPECT_EQ(contact_kind(s, s), ContactKind::overlap);
  EXPECT_EQ(contact_kind(s, sorted({6, 3}, {8, 4})), ContactKind::none);  // on its line
  EXPECT_EQ(contact_kind(s, sorted({0, 1}, {4, 3})), ContactKind::none);  // parallel
  EXPECT_EQ(contact_kind(s, sorted({3, 1}, {9, 0})), ContactKind::none);
}

TEST(SegmentSegmentTest, OfLengthZero) {
  const Segment s = sorted({0, 0}, {4, 2}), point{{2, 1}, {2, 1}};
  EXPECT_EQ(contact_kind(point, s), ContactKind::touch);
  EXPECT_EQ(contact_kind(Segment{{4, 2}, {4, 2}}, s), ContactKind::shared_endpoint);
  EXPECT_EQ(contact_kind(point, point), ContactKind::shared_endpoint);
  EXPECT_EQ(contact_kind(point, Segment{{2, 1.5}, {2, 1.5}}), ContactKind::none);
  EXPECT_EQ(contact_kind(Segment{{2, std::nextafter(1, 2)}, {2, std::nextafter(1, 2)}}, s), ContactKind::none);
  EXPECT_EQ(contact_kind(Segment{{6, 3}, {6, 3}}, s), ContactKind::none);
  EXPECT_EQ(contact_kind(Segment{{-0.0, 0.0}, {0.0, -0.0}}, s), ContactKind::shared_endpoint);
}

TEST(SegmentSegmentTest, TheLastBitAndTheEndsOfTheRange) {
  // A point on a segment's line exactly, and one unit in the last place beside it.
  const Segment s = sorted({0, 0}, {3, 1});
  EXPECT_EQ(contact_kind(s, sorted({1.5, 0.5}, {1, 5})), ContactKind::touch);
  EXPECT_EQ(contact_kind(s, sorted({1.5, std::nextafter(0.5, 1)}, {1, 5})), ContactKind::none);
  EXPECT_EQ(contact_kind(s, sorted({1.5, std::nextafter(0.5, 0)}, {1, 5})), ContactKind::crossing);
  for (const double scale : {5e-324, 0x1p-1060, 1e-300, 1e300, 0x1p1022}) {
    const auto at = [&](double x, double y) { return Point2{x * scale, y * scale}; };
    EXPECT_EQ(contact_kind(sorted(at(-1, -1), at(1, 1)), sorted(at(-1, 1), at(1, -1))), ContactKind::crossing) << scale;
    EXPECT_EQ(contact_kind(sorted(at(-1, -1), at(1, 1)), sorted(at(0, 0), at(1, -1))), ContactKind::touch) << scale;
    EXPECT_EQ(contact_kind(sorted(at(-1, -1), at(1, 1)), sorted(at(0, -1), at(1, 0))), ContactKind::none) << scale;
  }
}

// An independent answer: the parameter ranges of both segments, in fractions.
ContactKind by_fractions(const Segment& s, const Segment& t) {
  const auto vector = [](const Point2& from, const Point2& to) {
    return std::array{Rational(to.x) - Rational(from.x), Rational(to.y) - Rational(from.y)};
  };
  const auto cross = [](const auto& u, const auto& v) { return Rational(u[0] * v[1] - u[1] * v[0]); };
  const auto d = vector(s.a, s.b), e = vector(t.a, t.b), w = vector(s.a, t.a);
  const auto inner = [](const Rational& f) { return f > 0 && f < 1; };
  const auto within = [](const Rational& f) { return f >= 0 && f <= 1; };
  const Rational across = cross(d, e);
  if (across != 0) {  // one common point of the lines
    const Rational of_s = cross(w, e) / across, of_t = cross(w, d) / across;
    if (!within(of_s) || !within(of_t)) return ContactKind::none;
    return inner(of_s) && inner(of_t)   ? ContactKind::crossing
           : inner(of_s) || inner(of_t) ? ContactKind::touch
                                        : ContactKind::shared_endpoint;
  }
  // Parallel, or of length zero: project on the longer one.
  const bool s_is_point = s.a == s.b, t_is_point = t.a == t.b;
  if (s_is_point && t_is_point) return s.a == t.a ? ContactKind::shared_endpoint : ContactKind::none;
  const Segment &base = s_is_point ? t : s, &other = s_is_point ? s : t;
  const auto along = vector(base.a, base.b), to_a = vector(base.a, other.a), to_b = vector(base.a, other.b);
  if (cross(along, to_a) != 0) return ContactKind::none;
  const Rational length2 = along[0] * along[0] + along[1] * along[1];
  Rational from = (along[0] * to_a[0] + along[1] * to_a[1]) / length2;
  Rational to = (along[0] * to_b[0] + along[1] * to_b[1]) / length2;
  if (from > to) std::swap(from, to);
  if (to < 0 || from > 1) return ContactKind::none;
  if (from == to) return inner(from) ? ContactKind::touch : ContactKind::shared_endpoint;
  return to == 0 || from == 1 ? ContactKind::shared_endpoint : ContactKind::overlap;
}

bool holds(const Segment& s, const Rational& x, const Rational& y) {
  const Rational dx = Rational(s.b.x) - Rational(s.a.x), dy = Rational(s.b.y) - Rational(s.a.y);
  const Rational px = x - Rational(s.a.x), py = y - Rational(s.a.y);
  const Rational along = dx * px + dy * py;
  return dx * py == dy * px && along >= 0 && along <= dx * dx + dy * dy && (dx != 0 || dy != 0 || (px == 0 && py == 0));
}

Rational fraction(const Dyadic& x) {
  Rational f(boost::multiprecision::cpp_int(mantissa_of(x)));
  const boost::multiprecision::cpp_int power = boost::multiprecision::cpp_int(1)
                                               << static_cast<unsigned>(std::abs(x.exponent()));
  return x.exponent() < 0 ? Rational(f / power) : Rational(f * power);
}

TEST(SegmentSegmentTest, AgainstFractions) {
  Random random(97);
  std::map<ContactKind, int> seen;
  std::set<bool> last_bits;
  const int count = tests::scaled_count(20000, 3000);
  for (int i = 0; i < count; ++i) {
    const auto whole = [&] { return static_cast<double>(random.between(-3, 3)); };
    Segment s = sorted({whole(), whole()}, {whole(), whole()}), t = sorted({whole(), whole()}, {whole(), whole()});
    if (i % 3 == 0) {  // an end nearly on the other segment
      const double u = random.unit();
      const double way = random.below(2) ? 4 : -4;
      const Point2 on{std::nextafter(s.a.x + u * (s.b.x - s.a.x), way), s.a.y + u * (s.b.y - s.a.y)};
      t = sorted(on, t.b);
    }
    const ContactKind found = contact_kind(s, t);
    ASSERT_EQ(found, by_fractions(s, t)) << i;
    ++seen[found];
    if (found == ContactKind::none) continue;
    const ExactPoint2 p = common_point(s, t);
    ASSERT_EQ(p.denominator.sign(), Sign::positive);
    const Rational d = fraction(p.denominator), x = fraction(p.x) / d, y = fraction(p.y) / d;
    ASSERT_TRUE(holds(s, x, y) && holds(t, x, y)) << i;
  }
  if (count < 20000) return;  // rates of a small run say little
  for (const ContactKind k : {ContactKind::none, ContactKind::shared_endpoint, ContactKind::touch,
                              ContactKind::crossing, ContactKind::overlap}) {
    EXPECT_GT(seen[k], 200) << name_of(k);
  }
}

TEST(SegmentSegmentTest, NamesAreDifferent) {
  std::set<std::string_view> names;
  for (const ContactKind k : {ContactKind::none, ContactKind::shared_endpoint, ContactKind::touch,
                              ContactKind::crossing, ContactKind::overlap}) {
    names.insert(name_of(k));
  }
  EXPECT_EQ(names.size(), 5u);
}

}  // namespace
}  // namespace sunder::planar
