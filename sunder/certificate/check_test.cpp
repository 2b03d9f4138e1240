// The quick check against the definition of a true certificate, in integers and fractions: true ones of each kind, and
// every sort of mutation of them, are accepted or refused as the definition says, and for its reason.
#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/certificate/fractions_test.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sunder {
namespace {

using Whole3 = std::array<std::int64_t, 3>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Points and poses of small integers, so that 64 bits hold whatever the definition needs.
struct Body {
  std::vector<Point3> vertices;
  Affine3 pose;

  PlacedVertices placed(bool tame) const { return {vertices, pose, tame}; }

  Whole3 image(std::size_t v) const {
    const Point3& p = vertices[v];
    Whole3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const double* row = &pose.linear[3 * i];
      out[i] = static_cast<std::int64_t>(row[0] * p.x + row[1] * p.y + row[2] * p.z + pose.translation[i]);
    }
    return out;
  }
};

Whole3 minus(const Whole3& a, const Whole3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Whole3 cross(const Whole3& a, const Whole3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Whole3 turned_right(const Whole3& v) { return {v[1], -v[0], 0}; }  // as seen on the plane z = 0
std::int64_t dot(const Whole3& a, const Whole3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The direction that a certificate names; requires indices in range. `given` and `exact` hold small integers here.
Whole3 direction_of(const Direction& d, const Body& a, const Body& b) {
  const auto p = [&](std::size_t k) { return a.image(d.index[k]); };
  const auto q = [&](std::size_t k) { return b.image(d.index[k]); };
  const auto whole = [](const Dyadic& x) { return static_cast<std::int64_t>(x.nearest()); };
  Whole3 forward{};
  switch (d.kind) {
    case Direction::Kind::given:
      return {static_cast<std::int64_t>(d.given.x), static_cast<std::int64_t>(d.given.y),
              static_cast<std::int64_t>(d.given.z)};
    case Direction::Kind::exact: return {whole((*d.numbers)[0]), whole((*d.numbers)[1]), whole((*d.numbers)[2])};
    case Direction::Kind::normal_of_a: forward = cross(minus(p(1), p(0)), minus(p(2), p(0))); break;
    case Direction::Kind::normal_of_b: forward = cross(minus(q(1), q(0)), minus(q(2), q(0))); break;
    case Direction::Kind::edge_cross_edge: forward = cross(minus(p(1), p(0)), minus(q(3), q(2))); break;
    case Direction::Kind::difference: forward = minus(q(1), p(0)); break;
    case Direction::Kind::side_of_a: forward = turned_right(minus(p(1), p(0))); break;
    case Direction::Kind::side_of_b: forward = turned_right(minus(q(1), q(0))); break;
  }
  return d.reversed ? minus({}, forward) : forward;
}

// Which places of the index a kind uses, and whether they are A's.
std::vector<std::pair<std::size_t, bool>> places_of(Direction::Kind kind) {
  switch (kind) {
    case Direction::Kind::normal_of_a: return {{0, true}, {1, true}, {2, true}};
    case Direction::Kind::normal_of_b: return {{0, false}, {1, false}, {2, false}};
    case Direction::Kind::edge_cross_edge: return {{0, true}, {1, true}, {2, false}, {3, false}};
    case Direction::Kind::difference: return {{0, true}, {1, false}};
    case Direction::Kind::side_of_a: return {{0, true}, {1, true}};
    case Direction::Kind::side_of_b: return {{0, false}, {1, false}};
    default: return {};
  }
}

CheckResult definition_of(const Separation& c, const Body& a, const Body& b) {
  if (c.extreme_a >= a.vertices.size() || c.extreme_b >= b.vertices.size()) return CheckResult::bad_index;
  for (const auto& [k, of_a] : places_of(c.direction.kind)) {
    if (c.direction.index[k] >= (of_a ? a : b).vertices.size()) return CheckResult::bad_index;
  }
  const Whole3 d = direction_of(c.direction, a, b);
  const std::int64_t at_a = dot(d, a.image(c.extreme_a)), at_b = dot(d, b.image(c.extreme_b));
  if (at_a >= at_b) return CheckResult::not_strictly_apart;
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    if (dot(d, a.image(v)) > at_a) return CheckResult::not_extreme_in_a;
  }
  for (std::size_t v = 0; v < b.vertices.size(); ++v) {
    if (dot(d, b.image(v)) < at_b) return CheckResult::not_extreme_in_b;
  }
  return CheckResult::accepted;
}

// Has  sum l_i a_i = sum m_j b_j, sum l_i = 1, sum m_j = 1  one solution, and is that positive? By Gauss's elimination.
CheckResult definition_of(const CommonVertices& c, const Body& a, const Body& b) {
  const std::size_t n = std::size_t{c.count_a} + c.count_b;
  if (c.count_a == 0 || c.count_b == 0 || n > 5) return CheckResult::bad_index;
  std::vector<std::vector<Fraction>> m(5, std::vector<Fraction>(n + 1));
  for (std::size_t j = 0; j < n; ++j) {
    const bool of_a = j < c.count_a;
    if (c.vertices[j] >= (of_a ? a : b).vertices.size()) return CheckResult::bad_index;
    const Whole3 x = (of_a ? a : b).image(c.vertices[j]);
    for (std::size_t i = 0; i < 3; ++i) m[i][j] = of_a ? x[i] : -x[i];
    m[3][j] = of_a ? 1 : 0;
    m[4][j] = of_a ? 0 : 1;
  }
  m[3][n] = m[4][n] = 1;
  std::size_t rank = 0;
  for (std::size_t j = 0; j < n; ++j) {
    std::size_t r = rank;
    while (r < 5 && m[r][j] == 0) ++r;
    if (r == 5) return CheckResult::no_common_point;  // not unique, if there is one
    std::swap(m[r], m[rank]);
    for (std::size_t i = 0; i < 5; ++i) {
      if (i == rank || m[i][j] == 0) continue;
      const Fraction factor = m[i][j] / m[rank][j];
      for (std::size_t k = 0; k <= n; ++k) m[i][k] -= factor * m[rank][k];
    }
    ++rank;
  }
  for (std::size_t i = rank; i < 5; ++i) {
    if (m[i][n] != 0) return CheckResult::no_common_point;
  }
  for (std::size_t i = 0; i < rank; ++i) {
    if (m[i][n] / m[i][i] <= 0) return CheckResult::no_common_point;
  }
  return CheckResult::accepted;
}

CheckResult definition(const PairCertificate& c, const Body& a, const Body& b) {
  return std::visit([&](const auto& held) { return definition_of(held, a, b); }, c);
}

class CheckTest : public testing::Test {
 protected:
  static constexpr std::array<Direction::Kind, 8> kinds{Direction::Kind::given,       Direction::Kind::normal_of_a,
                                                        Direction::Kind::normal_of_b, Direction::Kind::edge_cross_edge,
                                                        Direction::Kind::difference,  Direction::Kind::exact,
                                                        Direction::Kind::side_of_a,   Direction::Kind::side_of_b};

  // Integers about the origin, and moved by about `where`.
  Body some_body(std::int64_t where) {
    Body body;
    const std::int64_t side = random_.below(2) ? 1 : random_.between(2, 4);
    const int n = static_cast<int>(random_.between(1, 9));
    const auto coordinate = [&](std::int64_t half) { return static_cast<double>(random_.between(-half, half)); };
    for (int i = 0; i < n; ++i) body.vertices.push_back({coordinate(side), coordinate(side), coordinate(side)});
    if (random_.below(3) == 0) {
      for (double& x : body.pose.linear) x += coordinate(1);
    }
    body.pose.translation = {static_cast<double>(where), 0, 0};
    if (random_.below(2)) body.pose.translation[1] = coordinate(1);
    return body;
  }

  std::uint32_t some_vertex(const Body& body) {
    return static_cast<std::uint32_t>(random_.below(body.vertices.size()));
  }

  // Extreme vertices along the direction, and the sense in which B is beyond A, if it is in one.
  void complete(Separation& c, const Body& a, const Body& b) {
    for (int turn = 0;; ++turn) {
      const Whole3 d = direction_of(c.direction, a, b);
      for (std::uint32_t v = 0; v < a.vertices.size(); ++v) {
        if (dot(d, a.image(v)) > dot(d, a.image(c.extreme_a))) c.extreme_a = v;
      }
      for (std::uint32_t v = 0; v < b.vertices.size(); ++v) {
        if (dot(d, b.image(v)) < dot(d, b.image(c.extreme_b))) c.extreme_b = v;
      }
      if (turn == 1 || dot(d, a.image(c.extreme_a)) < dot(d, b.image(c.extreme_b))) return;
      c.direction.reversed = !c.direction.reversed;
      c.direction.given = {-c.direction.given.x, -c.direction.given.y, -c.direction.given.z};
      if (c.direction.numbers) {
        const auto& n = *c.direction.numbers;
        c.direction.numbers = std::make_shared<const std::array<Dyadic, 3>>(std::array<Dyadic, 3>{-n[0], -n[1], -n[2]});
      }
    }
  }

  Separation some_apart(Direction::Kind kind, const Body& a, const Body& b) {
    Separation c;
    c.direction.kind = kind;
    const auto component = [&] { return static_cast<double>(random_.between(-3, 3)); };
    c.direction.given = {component() + 2, component(), component()};
    if (kind == Direction::Kind::exact) {
      c.direction.numbers = std::make_shared<const std::array<Dyadic, 3>>(
          std::array<Dyadic, 3>{Dyadic(component() + 2), Dyadic(component() * 64).scaled(-6), Dyadic(component())});
    }
    for (const auto& [k, of_a] : places_of(kind)) c.direction.index[k] = some_vertex(of_a ? a : b);
    complete(c, a, b);
    return c;
  }

  // Two to five vertices. With a common point in most cases: the mean of those of A is that of those of B.
  CommonVertices some_meet(Body& a, Body& b) {
    CommonVertices c;
    c.count_a = static_cast<std::uint8_t>(random_.between(1, 4));
    c.count_b = static_cast<std::uint8_t>(random_.between(1, 5 - c.count_a));
    const std::size_t n = std::size_t{c.count_a} + c.count_b;
    for (std::size_t i = 0; i < n; ++i) c.vertices[i] = some_vertex(i < c.count_a ? a : b);
    if (random_.below(2)) return c;
    b.pose = a.pose;
    Point3 mean, last;
    for (std::size_t i = 0; i < n; ++i) {
      const auto coordinate = [&] { return static_cast<double>(random_.between(-2, 2)); };
      const bool of_a = i < c.count_a;
      Point3 p{coordinate(), coordinate(), coordinate()};
      if (of_a) {
        mean = {mean.x + p.x, mean.y + p.y, mean.z + p.z};
        p = {c.count_a * p.x, c.count_a * p.y, c.count_a * p.z};
      } else if (i + 1 == n) {
        p = {c.count_b * mean.x - last.x, c.count_b * mean.y - last.y, c.count_b * mean.z - last.z};
      } else {
        last = {last.x + p.x, last.y + p.y, last.z + p.z};
      }
      Body& body = of_a ? a : b;
      c.vertices[i] = static_cast<std::uint32_t>(body.vertices.size());
      body.vertices.push_back(p);
    }
    return c;
  }

  Random random_{tests::chosen_seed(6)};
};

TEST_F(CheckTest, AcceptsWhatTheDefinitionAcceptsAndNothingElse) {
  std::map<std::string, int> seen;
  for (int i = 0; i < tests::scaled_count(8000, 1500); ++i) {
    const bool meet = random_.below(2);
    Body a = some_body(0), b = some_body(meet ? 0 : random_.between(0, 9));
    const Direction::Kind kind = kinds[random_.below(kinds.size())];
    PairCertificate c;
    std::string what = "apart " + std::to_string(static_cast<int>(kind));
    if (meet) {
      const CommonVertices common = some_meet(a, b);
      what = "meet " + std::to_string(common.count_a) + std::to_string(common.count_b);
      c = common;
    } else {
      c = some_apart(kind, a, b);
    }
    const CheckResult expected = definition(c, a, b);
    for (const bool tame : {true, false}) {
      ASSERT_EQ(name_of(check_absolutely(c, a.placed(tame), b.placed(tame))), name_of(expected)) << i << " " << what;
    }
    ++seen[what + " " + std::string(name_of(expected))];
  }
  // Every kind was accepted often, and refused often. (Rates of a small run say little.)
  if (tests::scaled_count(8000, 1500) < 8000) return;
  for (const Direction::Kind kind : kinds) {
    const std::string what = "apart " + std::to_string(static_cast<int>(kind));
    EXPECT_GT(seen[what + " accepted"], 5 * tests::scaled_count(8000, 1500) / 1000) << what;
    EXPECT_GT(seen[what + " not strictly apart"], 5 * tests::scaled_count(8000, 1500) / 1000) << what;
  }
  for (const std::string counts : {"11", "12", "21", "13", "22", "31", "14", "23", "32", "41"}) {
    EXPECT_GT(seen["meet " + counts + " accepted"], tests::scaled_count(8000, 1500) / 1000) << counts;
    EXPECT_GT(seen["meet " + counts + " no common point"], tests::scaled_count(8000, 1500) / 1000) << counts;
  }
}

// Each sort of mutation of a true certificate, by name; the definition says what must come out.
TEST_F(CheckTest, RefusesEveryUntrueMutation) {
  using OfApart = void (*)(Separation&, const Body&, const Body&, Random&);
  using OfMeet = void (*)(CommonVertices&, const Body&, const Body&, Random&);
  const auto other = [](std::uint32_t v, const Body& body, Random& random) {
    return static_cast<std::uint32_t>((v + 1 + random.below(body.vertices.size())) % body.vertices.size());
  };
  static const auto another = other;
  const std::vector<std::pair<std::string, OfApart>> of_apart{
      {"extreme of a", [](auto& c, auto& a, auto&, auto& random) { c.extreme_a = another(c.extreme_a, a, random); }},
      {"extreme of b", [](auto& c, auto&, auto& b, auto& random) { c.extreme_b = another(c.extreme_b, b, random); }},
      {"extremes exchanged", [](auto& c, auto&, auto&, auto&) { std::swap(c.extreme_a, c.extreme_b); }},
      {"extreme of a out of range",
       [](auto& c, auto& a, auto&, auto&) { c.extreme_a = static_cast<std::uint32_t>(a.vertices.size()); }},
      {"extreme of b out of range",
       [](auto& c, auto&, auto& b, auto&) { c.extreme_b = static_cast<std::uint32_t>(b.vertices.size()); }},
      {"reversed", [](auto& c, auto&, auto&, auto&) { c.direction.reversed = !c.direction.reversed; }},
      {"negated",
       [](auto& c, auto&, auto&, auto&) {
         c.direction.given = {-c.direction.given.x, -c.direction.given.y, -c.direction.given.z};
         if (!c.direction.numbers) return;
         const auto& n = *c.direction.numbers;
         c.direction.numbers =
             std::make_shared<const std::array<Dyadic, 3>>(std::array<Dyadic, 3>{-n[0], -n[1], -n[2]});
       }},
      {"component exchanged",
       [](auto& c, auto&, auto&, auto&) { std::swap(c.direction.given.x, c.direction.given.z); }},
      {"index changed",
       [](auto& c, auto& a, auto& b, auto& random) {
         for (const auto& [k, of_a] : places_of(c.direction.kind)) {
           if (random.below(2)) c.direction.index[k] = another(c.direction.index[k], of_a ? a : b, random);
         }
       }},
      {"indices exchanged",
       [](auto& c, auto&, auto&, auto&) { std::swap(c.direction.index[0], c.direction.index[1]); }},
      {"index out of range",
       [](auto& c, auto& a, auto& b, auto& random) {
         const auto places = places_of(c.direction.kind);
         if (places.empty()) return;
         const auto [k, of_a] = places[random.below(places.size())];
         c.direction.index[k] =
             static_cast<std::uint32_t>((of_a ? a : b).vertices.size() + random.below(2) * 0xffff0000u);
       }},
      {"another kind",
       [](auto& c, auto& a, auto& b, auto& random) {
         c.direction.kind = static_cast<Direction::Kind>(random.below(5));
         for (auto& v : c.direction.index)
           v = static_cast<std::uint32_t>(v % std::min(a.vertices.size(), b.vertices.size()));
       }},
  };
  const std::vector<std::pair<std::string, OfMeet>> of_meet{
      {"count of a",
       [](auto& c, auto&, auto&, auto& random) {
         c.count_a = static_cast<std::uint8_t>(c.count_a + (random.below(2) ? 1 : -1));
       }},
      {"count of b",
       [](auto& c, auto&, auto&, auto& random) {
         c.count_b = static_cast<std::uint8_t>(c.count_b + (random.below(2) ? 1 : -1));
       }},
      {"counts exchanged", [](auto& c, auto&, auto&, auto&) { std::swap(c.count_a, c.count_b); }},
      {"counts huge", [](auto& c, auto&, auto&, auto&) { c.count_a = c.count_b = 255; }},
      {"vertex changed",
       [](auto& c, auto& a, auto& b, auto& random) {
         const std::size_t n = std::min<std::size_t>(5, std::size_t{c.count_a} + c.count_b);
         const std::size_t i = n == 0 ? 0 : random.below(n);
         c.vertices[i] = another(c.vertices[i], i < c.count_a ? a : b, random);
       }},
      {"vertex twice", [](auto& c, auto&, auto&, auto&) { c.vertices[c.count_a > 1 ? 1 : 2] = c.vertices[0]; }},
      {"vertex out of range",
       [](auto& c, auto& a, auto& b, auto&) {
         c.vertices[c.count_a > 1 ? 1 : 0] = static_cast<std::uint32_t>(a.vertices.size() + b.vertices.size());
       }},
  };
  std::map<std::string, std::map<CheckResult, int>> seen;
  std::set<Direction::Kind> kinds_refused;
  int true_ones = 0;
  for (int i = 0; i < tests::scaled_count(3000, 600); ++i) {
    const bool meet = random_.below(3) > 0;
    Body a = some_body(0), b = some_body(meet ? 0 : random_.between(0, 9));
    const auto refuse = [&](const auto& c, const auto& mutations) {
      if (definition(c, a, b) != CheckResult::accepted) return;
      ++true_ones;
      for (const auto& [name, mutate] : mutations) {
        auto mutant = c;
        mutate(mutant, a, b, random_);
        const CheckResult expected = definition(mutant, a, b);
        ASSERT_EQ(name_of(check_absolutely(mutant, a.placed(true), b.placed(true))), name_of(expected))
            << i << " " << name;
        ++seen[name][expected];
        if constexpr (std::is_same_v<decltype(mutant), Separation>) {
          if (expected != CheckResult::accepted) kinds_refused.insert(c.direction.kind);
        }
      }
    };
    if (meet) {
      refuse(some_meet(a, b), of_meet);
    } else {
      refuse(some_apart(kinds[random_.below(kinds.size())], a, b), of_apart);
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(true_ones, tests::scaled_count(3000, 600) / 10);
  EXPECT_EQ(kinds_refused.size(), kinds.size());
  for (const auto& [name, results] : seen) {
    int refused = 0;
    for (const auto& [result, count] : results) refused += result == CheckResult::accepted ? 0 : count;
    EXPECT_GT(refused, true_ones / 100) << name;
  }
  EXPECT_GT(seen["extreme of a"][CheckResult::not_extreme_in_a], 0);
  EXPECT_GT(seen["extreme of b"][CheckResult::not_extreme_in_b], 0);
}

TEST_F(CheckTest, RefusesDirectionsThatAreNone) {
  const Body a{{{0, 0, 0}}, {}}, b{{{1, 1, 1}}, {}};
  const auto result = [&](const PairCertificate& c) { return check_absolutely(c, a.placed(true), b.placed(true)); };
  Separation c;
  c.direction.given = {1, 1, 1};
  EXPECT_EQ(result(c), CheckResult::accepted);
  c.direction.given = {0, 0, 0};
  EXPECT_EQ(result(c), CheckResult::not_strictly_apart);
  for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    for (const Point3& d : {Point3{x, 1, 1}, Point3{1, x, 1}, Point3{1, 1, x}}) {
      c.direction.given = d;
      EXPECT_EQ(result(c), CheckResult::bad_index) << x;
    }
  }
  c.direction.given = {5e-324, 0, 0};
  EXPECT_EQ(result(c), CheckResult::accepted);
  c.direction.given = {std::numeric_limits<double>::max(), -5e-324, 0};
  EXPECT_EQ(result(c), CheckResult::accepted);
  c.direction.kind = Direction::Kind::exact;
  EXPECT_EQ(result(c), CheckResult::bad_index);  // null
  const auto with = [&](Dyadic x) {
    c.direction.numbers = std::make_shared<const std::array<Dyadic, 3>>(std::array<Dyadic, 3>{std::move(x), 0.0, 1.0});
    return result(c);
  };
  EXPECT_EQ(with(1.0), CheckResult::accepted);
  EXPECT_EQ(with(Dyadic(1.0).scaled(9000)), CheckResult::accepted);
  EXPECT_EQ(with(Dyadic(-1.0).scaled(9000)), CheckResult::not_strictly_apart);
  for (const std::int64_t e : {std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
    EXPECT_EQ(with(Dyadic(1.0).scaled(e)), CheckResult::bad_index);  // and no attempt to shift by that
  }
  c.direction.kind = static_cast<Direction::Kind>(99);
  EXPECT_EQ(result(c), CheckResult::bad_index);
}

// Bodies apart by less than any double near them: exact comparisons, at the ends of the range of doubles.
TEST_F(CheckTest, StrictnessIsExact) {
  constexpr double largest = std::numeric_limits<double>::max();
  for (const double x : {0.0, 1.0, largest}) {
    Body a{{{x, 0, 0}, {x / 2, 1, 1}}, {}}, b{{{x, 0, 0}, {x, 5, -5}}, {}};
    Separation c;
    c.direction.given = {1, 0, 0};
    EXPECT_EQ(check_absolutely(c, a.placed(false), b.placed(false)), CheckResult::not_strictly_apart);
    b.pose.translation[0] = 5e-324;
    EXPECT_EQ(check_absolutely(c, a.placed(false), b.placed(false)), CheckResult::accepted);
    a.pose.translation[0] = 5e-324;
    EXPECT_EQ(check_absolutely(c, a.placed(false), b.placed(false)), CheckResult::not_strictly_apart);
  }
}

TEST_F(CheckTest, ResultsHaveDifferentNames) {
  std::set<std::string_view> names;
  for (int i = 0; i < 6; ++i) names.insert(name_of(static_cast<CheckResult>(i)));
  EXPECT_EQ(names.size(), 6u);
  EXPECT_EQ(names.count(""), 0u);
}

}  // namespace
}  // namespace sunder
