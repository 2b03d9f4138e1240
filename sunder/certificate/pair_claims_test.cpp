// The certificate file, read back by a foreign JSON parser and an own reader of its numbers, in fractions.
#include <sunder/base/random.h>
#include <sunder/certificate/fractions_test.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/predicate/point/common_point.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <regex>

namespace sunder {
namespace {

using nlohmann::json;

// A number of docs/claims.md; throws for anything else.
Fraction number(const json& text) {
  static const std::regex hexadecimal("(-?)0x([0-9a-fA-F]+)(\\.([0-9a-fA-F]+))?p([-+]?[0-9]+)");
  static const std::regex fraction("(-?)([0-9]+)(/([0-9]+))?");
  const std::string s = text.get<std::string>();
  if (s.size() > 20000) throw std::runtime_error("too long");
  std::smatch m;
  Fraction size;
  if (std::regex_match(s, m, hexadecimal)) {
    const std::string digits = m[2].str() + m[4].str();
    const long e = std::stol(m[5]);
    if (std::abs(e) > 20000) throw std::runtime_error("exponent: " + s);
    size = times_power(Whole("0x" + digits), e - 4 * m[4].length());
  } else if (std::regex_match(s, m, fraction)) {
    // A leading zero would make the rest octal for cpp_int: none is written.
    if (m[2].length() > 1 && m[2].str()[0] == '0') throw std::runtime_error("leading zero: " + s);
    size = Fraction(Whole(m[2].str()), m[4].matched ? Whole(m[4].str()) : Whole(1));
  } else {
    throw std::runtime_error("no number: " + s);
  }
  return m[1].length() ? -size : size;
}

Exact3 numbers(const json& list) {
  EXPECT_EQ(list.size(), 3u);
  return {number(list.at(0)), number(list.at(1)), number(list.at(2))};
}

// Is it, as a double, this very double?
bool is_exactly(const json& text, double x) { return number(text) == exact(x); }

const std::vector<double> odd_doubles{0.0,
                                      -0.0,
                                      1,
                                      -1,
                                      0.1,
                                      1.0 / 3,
                                      5e-324,
                                      -5e-324,
                                      2.2250738585072014e-308,
                                      2.225073858507201e-308,
                                      std::numeric_limits<double>::max(),
                                      -std::numeric_limits<double>::max(),
                                      0x1.fffffffffffffp-1,
                                      1e-300,
                                      123456789};

// A file as text, piece by piece.
class File {
 public:
  explicit File(PairClaims::Space space = PairClaims::Space::solid)
      : claims_([this](std::string_view piece) { text_ += piece; }), pairs(claims_, space) {}

  json end() {
    pairs.end();
    return json::parse(text_);  // throws unless the text is UTF-8
  }

 private:
  std::string text_;
  ClaimsWriter claims_;

 public:
  PairClaims pairs;
};

TEST(PairClaimsTest, DoublesAreExact) {
  Random random(3);
  std::vector<Point3> points;
  for (const double x : odd_doubles) points.push_back({x, -x, 1});
  for (int i = 0; i < 300; ++i) {
    const auto any = [&] { return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-1074, 1023))); };
    points.push_back({any(), any(), any()});
  }
  Affine3 pose;
  for (std::size_t i = 0; i < 9; ++i) pose.linear[i] = odd_doubles[i + 4];
  pose.translation = {5e-324, -0.1, -0.0};
  const std::vector<Point3> one{{1, 2, 3}};
  File written;
  EXPECT_EQ(written.pairs.add_body("first", one), 0u);
  EXPECT_EQ(written.pairs.add_body("second", points), 1u);
  EXPECT_EQ(written.pairs.add_placed("here", 1, pose), 2u);
  EXPECT_EQ(written.pairs.add_placed("there", 0, Affine3()), 3u);
  EXPECT_EQ(written.pairs.add_placed("first", 0, Affine3()), 0u);
  EXPECT_EQ(written.pairs.add_placed("first", 0, pose), 4u);
  EXPECT_FALSE(written.pairs.states_something());
  const json file = written.end();
  EXPECT_EQ(file.at("sunder_certificate"), 3);
  EXPECT_EQ(file.at("statements").size(), 0u);
  const json& bodies = file.at("tables").at("bodies");
  ASSERT_EQ(bodies.size(), 5u);
  EXPECT_EQ(bodies[0]["name"], "first");
  EXPECT_FALSE(bodies[0].contains("ways"));
  const json& vertices = bodies[1]["points"];
  ASSERT_EQ(vertices.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(is_exactly(vertices[i][0], points[i].x)) << vertices[i];
    ASSERT_TRUE(is_exactly(vertices[i][1], points[i].y)) << vertices[i];
    ASSERT_TRUE(is_exactly(vertices[i][2], points[i].z)) << vertices[i];
    ASSERT_EQ(vertices[i].size(), 3u);
  }
  const json& placed = bodies[2];
  EXPECT_EQ(placed.at("name"), "here");
  EXPECT_EQ(placed.at("of"), 1);
  ASSERT_EQ(placed.at("linear").size(), 9u);
  ASSERT_EQ(placed.at("translation").size(), 3u);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_TRUE(is_exactly(placed["linear"][i], pose.linear[i]));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(is_exactly(placed["translation"][i], pose.translation[i]));
  EXPECT_EQ(bodies[4]["name"], "first");
}

// In the plane there are two coordinates, and matrices of four numbers; a way is an arrow of four.
TEST(PairClaimsTest, PlanarBodies) {
  const std::vector<Point3> points{{1, 2, 0}, {3, 4, 0}};
  const std::vector<Way3> ways{{{1, 2, 0}, {3, 4, 0}}, {{3, 4, 0}, {1, 2, 0}}};
  File written(PairClaims::Space::planar);
  const auto line = written.pairs.add_body("", points, ways);
  const auto moved = written.pairs.add_placed("moved", line, {{2, 3, 0, 4, 5, 0, 0, 0, 1}, {6, 7, 0}});
  CommonPoint point{{1.0, 3.0, 0.0, 2.0}, {{{0, 1.0}, {2, 5.0}}, 3.0}, {{{1, 1.0}}, 1.0}};
  written.pairs.add_touching(line, moved, point, {1.0, -0.5, 0.0});
  written.pairs.add_overlapping(moved, line, point);
  EXPECT_TRUE(written.pairs.states_something());
  const json file = written.end();
  const json wanted = json::parse(R"({"bodies": [
      {"name": "unnamed", "points": [["0x1p+0", "0x1p+1"], ["0x1.8p+1", "0x1p+2"]],
       "ways": [["0x1p+0", "0x1p+1", "0x1.8p+1", "0x1p+2"], ["0x1.8p+1", "0x1p+2", "0x1p+0", "0x1p+1"]]},
      {"name": "moved", "of": 0, "linear": ["0x1p+1", "0x1.8p+1", "0x1p+2", "0x1.4p+2"],
       "translation": ["0x1.8p+2", "0x1.cp+2"]}]})");
  EXPECT_EQ(file.at("tables"), wanted);
  const json statements = json::parse(R"([
      {"question": "pair", "a": 0, "b": 1, "verdict": "touching", "point": ["1/2", "3/2"], "claims": [
        {"claim": "holds", "weights": [[0, "1/3"], [2, "5/3"]]}, {"claim": "holds", "weights": [[1, "1"]]},
        {"claim": "parted_weakly", "direction": ["0x1p+0", "-0x1p-1"]}]},
      {"question": "pair", "a": 1, "b": 0, "verdict": "overlapping", "point": ["1/2", "3/2"], "claims": [
        {"claim": "inside", "weights": [[0, "1/3"], [2, "5/3"]]}, {"claim": "inside", "weights": [[1, "1"]]}]}])");
  EXPECT_EQ(file.at("statements"), statements);
}

// Any bytes may be in a name: what is UTF-8 comes back as it was, what is not does not spoil the file.
// Each kind under its key, the radius as it is, and where a point of an ellipsoid comes from.
TEST(PairClaimsTest, BodiesWithARadius) {
  const std::vector<Point3> ends{{0, 0, 0}, {0, 0, 0.1}}, one{{1, 2, 3}};
  File written;
  const std::uint32_t first = written.pairs.add_body("plain", one);
  const std::uint32_t capsule = written.pairs.add_round_body("capsule", ends, RoundKind::hull, 5e-324);
  const std::uint32_t cylinder = written.pairs.add_round_body("cylinder", ends, RoundKind::cylinder, 0.1);
  const std::uint32_t cone = written.pairs.add_round_body("cone", ends, RoundKind::cone, 0);
  const std::uint32_t ellipsoid = written.pairs.add_round_body("", one, RoundKind::ellipsoid, 1.5);
  Affine3 pose;
  pose.linear[0] = 2;
  const std::uint32_t placed = written.pairs.add_placed("placed", ellipsoid, pose);
  EXPECT_EQ(std::vector({first, capsule, cylinder, cone, ellipsoid, placed}),
            (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(written.pairs.add_placed("cone", cone, Affine3()), cone);
  const CommonPoint point{
      {3.0, 2.0, 4.0}, {{{0, 1.0}}, 1.0, ExactPoint3{3.0, 4.0, 8.0, 2.0}}, {{{0, 1.0}, {1, 2.0}}, 3.0}};
  written.pairs.add_meet(placed, capsule, point);
  const json file = written.end();
  const json& bodies = file.at("tables").at("bodies");
  const auto expect = [&](std::size_t k, const char* key, double radius, std::size_t count) {
    ASSERT_EQ(bodies.at(k).size(), 3u);  // name, points, and this
    EXPECT_TRUE(is_exactly(bodies[k].at(key), radius));
    EXPECT_EQ(bodies[k].at("points").size(), count);
  };
  expect(1, "radius", 5e-324, 2);
  expect(2, "cylinder", 0.1, 2);
  expect(3, "cone", 0, 2);
  expect(4, "ellipsoid", 1.5, 1);
  EXPECT_EQ(bodies[0].size(), 2u);
  EXPECT_EQ(bodies.at(5).at("of"), 4);
  EXPECT_EQ(bodies[5].size(), 4u);
  const json& claims = file.at("statements").at(0).at("claims");
  EXPECT_EQ(numbers(claims.at(0).at("from")), (Exact3{Fraction(3, 2), 2, 4}));
  EXPECT_EQ(claims[0].at("weights").size(), 1u);
  EXPECT_EQ(number(claims[0]["weights"][0][1]), 1);
  EXPECT_EQ(number(claims.at(1).at("weights").at(1).at(1)), Fraction(2, 3));
  EXPECT_FALSE(claims[1].contains("from"));
}

TEST(PairClaimsTest, NamesMayHoldAnything) {
  std::string control;
  for (char c = 0; c < 0x20; ++c) control += c;
  const std::vector<std::string> good{"plain",
                                      "a \"quoted\" name",
                                      "back\\slash\\",
                                      control + "\x7f",
                                      "</script>",
                                      "gr\xc3\xbc\xc3\x9f",
                                      "\xe2\x82\xac \xf0\x9f\x98\x80 \xf4\x8f\xbf\xbf \xed\x9f\xbf"};
  const std::vector<std::string> bad{"latin \xfc",       "\xc3",     "\xe2\x82", "\xc0\xaf",         "\xe0\x80\xaf",
                                     "\xed\xa0\x80",     "\xff\xfe", "\x80",     "\xf5\x80\x80\x80", "\xf4\x90\x80\x80",
                                     "\xf0\x80\x80\x80", "\xc3\"\\"};
  const std::vector<Point3> point{{}};
  Affine3 away;
  away.translation = {1, 2, 3};
  File written;
  for (const auto* names : {&good, &bad}) {
    for (const std::string& name : *names) written.pairs.add_placed(name, written.pairs.add_body(name, point), away);
  }
  const json bodies = written.end().at("tables").at("bodies");
  ASSERT_EQ(bodies.size(), 2 * (good.size() + bad.size()));
  for (std::size_t i = 0; i < good.size(); ++i) {
    EXPECT_EQ(bodies[2 * i].at("name"), good[i]) << i;
    EXPECT_EQ(bodies[2 * i + 1].at("name"), good[i]) << i;
  }
  for (std::size_t i = 2 * good.size(); i < bodies.size(); ++i) {
    EXPECT_NE(bodies[i].at("name").get<std::string>().find("\xef\xbf\xbd"), std::string::npos) << i;
  }
  EXPECT_EQ(bodies.back()["name"], "\xef\xbf\xbd\"\\");
}

class PairClaimsAnswerTest : public testing::Test {
 protected:
  json pair(const PairCertificate& c) const {
    File written;
    const auto a = written.pairs.add_placed("a", written.pairs.add_body("cube", cube_), pose_a_);
    const auto b = written.pairs.add_placed("b", written.pairs.add_body("point", other_), pose_b_);
    written.pairs.add_pair(a, b, c);
    const json statements = written.end().at("statements");
    EXPECT_EQ(statements.size(), 1u);
    EXPECT_EQ(statements.at(0).at("question"), "pair");
    EXPECT_EQ(statements.at(0).at("a"), 1);
    EXPECT_EQ(statements.at(0).at("b"), 3);
    return statements.at(0);
  }

  json direction(const PairCertificate& c) const {
    const json p = pair(c);
    EXPECT_EQ(p.at("verdict"), "apart");
    EXPECT_EQ(p.at("claims").size(), 1u);
    EXPECT_EQ(p["claims"][0].at("claim"), "parted");
    return p["claims"][0].at("direction");
  }

  // Parallel, and not against each other.
  static bool same_ray(const Exact3& a, const Exact3& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (a[i] * b[j] != a[j] * b[i]) return false;
      }
    }
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > 0;
  }

  const std::vector<Point3> cube_{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
  const std::vector<Point3> other_{{0.1, 0.2, 0.3}, {0.7, 5e-324, 1e300}, {3, -2, 1e-200}, {0.3, -0.1, 2}};
  const Affine3 pose_a_{{1, 0.1, 0, 0, 0.3, -0.1, 0.7, 0, 1}, {0.1, -5e-324, 1}};
  const Affine3 pose_b_{{0.5, 0.25, 0, 1e-9, 1, 0, 0, 0, 1}, {1, 1, 1}};
};

TEST_F(PairClaimsAnswerTest, DirectionsAreExact) {
  Separation c;
  c.extreme_a = 5;
  c.extreme_b = 3;
  Direction& d = c.direction;
  d.given = {5e-324, 0.1, -std::numeric_limits<double>::max()};
  EXPECT_EQ(numbers(direction(c)), (Exact3{exact(d.given.x), exact(d.given.y), exact(d.given.z)}));

  const auto minus = [](const Exact3& a, const Exact3& b) { return Exact3{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  const auto cross = [](const Exact3& a, const Exact3& b) {
    return Exact3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto at_a = [&](std::size_t i) { return image(pose_a_, cube_[i]); };
  const auto at_b = [&](std::size_t i) { return image(pose_b_, other_[i]); };
  const auto expect = [&](Direction::Kind kind, std::array<std::uint32_t, 4> index, const Exact3& forward) {
    d.kind = kind;
    d.index = index;
    d.reversed = false;
    EXPECT_TRUE(same_ray(numbers(direction(c)), forward)) << static_cast<int>(kind);
    d.reversed = true;
    EXPECT_TRUE(same_ray(numbers(direction(c)), minus({}, forward))) << static_cast<int>(kind);
  };
  expect(Direction::Kind::normal_of_a, {0, 3, 6, 0}, cross(minus(at_a(3), at_a(0)), minus(at_a(6), at_a(0))));
  expect(Direction::Kind::normal_of_b, {1, 2, 3, 0}, cross(minus(at_b(2), at_b(1)), minus(at_b(3), at_b(1))));
  expect(Direction::Kind::edge_cross_edge, {7, 2, 0, 3}, cross(minus(at_a(2), at_a(7)), minus(at_b(3), at_b(0))));
  expect(Direction::Kind::difference, {4, 2, 0, 0}, minus(at_b(2), at_a(4)));

  d.kind = Direction::Kind::exact;
  d.numbers = std::make_shared<const std::array<Dyadic, 3>>(
      std::array<Dyadic, 3>{dyadic_of((Integer(1) << 3000) + 1, -4000), 0.0, dyadic_of(-12, 5)});
  EXPECT_TRUE(same_ray(numbers(direction(c)), {times_power((Whole(1) << 3000) + 1, -4000), 0, times_power(-12, 5)}));
}

// The weights sum to 1 and give the point, exactly: for each way to share out two to five vertices.
TEST_F(PairClaimsAnswerTest, WeightsAndPointAreExact) {
  struct Case {
    std::vector<Point3> a, b;
  };
  const std::vector<Case> cases{
      {{{1, 2, 3}}, {{1, 2, 3}}},
      {{{0, 0, 0}}, {{-1, -1, -1}, {2, 2, 2}}},
      {{{0, 0, 0}, {3, 3, 3}}, {{1, 1, 1}}},
      {{{-1, 0, 0}, {2, 0, 0}}, {{0, -0.1, 0}, {0, 0.3, 0}}},
      {{{0, 0, 0}, {5, 0, 0}, {0, 7, 0}}, {{1, 1, 0}}},
      {{{0.25, 0, 0}}, {{0, -1, 0}, {1, -1, 0}, {0, 2, 0}}},
      {{{0, 0, -1}, {0, 0, 2}}, {{-1, -1, 0}, {3, -1, 0}, {0, 2, 0}}},
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{1, 1, -0.1}, {1.5, 1, 0.7}}},
      {{{0.1, 0.1, 0.1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {{{-1, -1, -1}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, {{0.1, 0.2, 0.3}}},
  };
  int seen = 0;
  for (const Case& k : cases) {
    // Under one map for both, the common point stays.
    for (const Affine3& pose : {Affine3(), pose_a_}) {
      File written;
      const auto a = written.pairs.add_placed("a", written.pairs.add_body("", k.a), pose);
      const auto b = written.pairs.add_placed("b", written.pairs.add_body("", k.b), pose);
      CommonVertices c;
      c.count_a = static_cast<std::uint8_t>(k.a.size());
      c.count_b = static_cast<std::uint8_t>(k.b.size());
      for (std::uint32_t i = 0; i < c.count_a; ++i) c.vertices[i] = c.count_a - 1 - i;
      for (std::uint32_t i = 0; i < c.count_b; ++i) c.vertices[c.count_a + i] = c.count_b - 1 - i;
      std::vector<Posed3> posed_a, posed_b;
      for (std::uint32_t i = c.count_a; i-- > 0;) posed_a.push_back(posed(k.a[i], pose));
      for (std::uint32_t i = c.count_b; i-- > 0;) posed_b.push_back(posed(k.b[i], pose));
      if (!have_common_point(posed_a, posed_b)) continue;
      ++seen;
      written.pairs.add_pair(a, b, c);
      const json p = written.end().at("statements").at(0);
      EXPECT_EQ(p.at("verdict"), "meet");
      const Exact3 point = numbers(p.at("point"));
      ASSERT_EQ(p.at("claims").size(), 2u);
      const auto expect = [&](const json& claim, const std::vector<Point3>& points) {
        EXPECT_EQ(claim.at("claim"), "holds");
        const json& weights = claim.at("weights");
        ASSERT_EQ(weights.size(), points.size());
        Fraction total = 0;
        Exact3 sum{0, 0, 0};
        for (const json& w : weights) {
          ASSERT_EQ(w.size(), 2u);
          ASSERT_TRUE(w[0].is_number_integer());
          const Fraction weight = number(w[1]);
          EXPECT_GT(weight, 0);
          total += weight;
          const Exact3 x = image(pose, points.at(w[0].get<std::size_t>()));
          for (std::size_t i = 0; i < 3; ++i) sum[i] += weight * x[i];
        }
        EXPECT_EQ(total, 1);
        EXPECT_EQ(sum, point);
      };
      expect(p["claims"][0], k.a);
      expect(p["claims"][1], k.b);
    }
  }
  EXPECT_GE(seen, 16);
}

}  // namespace
}  // namespace sunder
