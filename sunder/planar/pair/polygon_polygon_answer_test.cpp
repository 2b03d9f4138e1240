// Proposals, right and wrong: the right ones are believed, the wrong ones are not, and the answer stays right whatever
// is proposed.
#include <sunder/planar/pair/cone_search.h>
#include <sunder/planar/pair/halving.h>
#include <sunder/planar/pair/nearest_search.h>
#include <sunder/planar/pair/polygon_polygon_answer.h>
#include <sunder/planar/pair/proposal_test.h>

#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <array>
#include <map>
#include <string>

namespace sunder::planar::proposal_test {
namespace {

using Claim = Proposal::Claim;

// A 4-square, and a unit square to the right of it whose leftmost corner, number 0, is on the level of its middle.
struct Squares {
  explicit Squares(double x)
      : of_a(ConvexPolygon::from_vertices({{0, 0}, {4, 0}, {4, 4}, {0, 4}})),
        of_b(ConvexPolygon::from_vertices({{x, 2}, {x + 1, 1}, {x + 2, 2}, {x + 1, 3}})) {}

  bool holds(const Proposal& p) const {
    PairAnswer answer;
    StageTally tally;
    const bool held = dispose(PlainPolygon(of_a), PlainPolygon(of_b), p, answer.evidence, tally);
    EXPECT_TRUE(!held || is_proved(answer, of_a, Pose(), of_b, Pose()));
    return held;
  }

  ConvexPolygon of_a, of_b;
};

TEST(PolygonPolygonAnswer, RightProposalsHold) {
  const Squares apart(5), meeting(3);
  EXPECT_TRUE(apart.holds(apart_by_edge_of_a(1, 0)));
  EXPECT_TRUE(apart.holds(apart_by_edge_of_a(1 + 4, 0 + 4)));  // positions plus n
  EXPECT_TRUE(apart.holds(apart_at_vertices(1, 0)));
  EXPECT_TRUE(apart.holds(apart_at_vertices(2, 0)));
  const std::array<std::uint32_t, 3> lower{0, 1, 2}, upper{0, 2, 3};
  EXPECT_TRUE(meeting.holds(meet(lower, std::array{0u})));
  EXPECT_TRUE(meeting.holds(meet(std::array{1u, 2u}, std::array{0u, 1u})));
  EXPECT_TRUE(meeting.holds(meet(lower, upper)));
  EXPECT_TRUE(Squares(2.5).holds(meet_plainly(lower, upper)));
  // The other way round.
  const ConvexPolygon a = ConvexPolygon::from_vertices({{5, 2}, {6, 1}, {7, 2}, {6, 3}});
  PairCertificate certificate;
  StageTally tally;
  EXPECT_TRUE(dispose(PlainPolygon(a), PlainPolygon(apart.of_a), apart_by_edge_of_b(0, 1), certificate, tally));
}

TEST(PolygonPolygonAnswer, WrongProposalsDoNotHold) {
  const Squares apart(5), touching(4), meeting(3);
  // A wrong direction: every edge but the one between them.
  for (const std::uint32_t edge : {0u, 2u, 3u}) EXPECT_FALSE(apart.holds(apart_by_edge_of_a(edge, 0)));
  for (const std::uint32_t edge : {0u, 1u, 2u, 3u}) EXPECT_FALSE(apart.holds(apart_by_edge_of_b(1, edge)));
  // A wrong vertex: beyond the edge as well, but not nearest to it. And vertices that no edge between them has.
  for (const std::uint32_t near : {1u, 2u, 3u}) EXPECT_FALSE(apart.holds(apart_by_edge_of_a(1, near)));
  EXPECT_FALSE(apart.holds(apart_at_vertices(0, 2)));
  // A wrong claim: apart what touches or meets, and the reverse.
  const std::array<std::uint32_t, 3> lower{0, 1, 2}, upper{0, 2, 3};
  for (const Squares* squares : {&touching, &meeting}) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      for (std::uint32_t j = 0; j < 4; ++j) {
        EXPECT_FALSE(squares->holds(apart_by_edge_of_a(i, j)));
        EXPECT_FALSE(squares->holds(apart_by_edge_of_b(i, j)));
        EXPECT_FALSE(squares->holds(apart_at_vertices(i, j)));
        EXPECT_FALSE(apart.holds(meet(std::array{i}, std::array{j})));
      }
    }
  }
  EXPECT_FALSE(apart.holds(meet(lower, upper)));
  EXPECT_FALSE(apart.holds(meet_plainly(lower, upper)));
  EXPECT_FALSE(meeting.holds(meet(std::array{0u, 3u}, upper)));  // the edge on the far side
  EXPECT_FALSE(touching.holds(meet_plainly(lower, upper)));      // true, but not plain
  EXPECT_FALSE(Squares(2.5).holds(meet_plainly({2, 1, 0}, {0, 1, 3})) &&
               Squares(9).holds(meet_plainly({2, 1, 0}, {3, 1, 0})));
  // Features that there are not, and numbers of them.
  for (const std::uint32_t k : {8u, 1000u, 0xffffffffu}) {
    EXPECT_FALSE(apart.holds(apart_by_edge_of_a(k, 0)));
    EXPECT_FALSE(apart.holds(apart_by_edge_of_b(0, k)));
    EXPECT_FALSE(apart.holds(apart_at_vertices(k, k)));
    EXPECT_FALSE(meeting.holds(meet(std::array{0u, 1u, k}, std::array{0u})));
    EXPECT_FALSE(meeting.holds(meet_plainly({0, 1, k}, {0, k, 3})));
  }
  for (const Claim claim : {Claim::meet, Claim::meet_plainly}) {
    EXPECT_FALSE(meeting.holds({claim, 0, 0, {}, {}}));
    EXPECT_FALSE(meeting.holds({claim, 200, 200, lower, upper}));
  }
}

// A search that proposes anything: what holds is true, and where nothing does, the answer is right all the same.
TEST(PolygonPolygonAnswer, AnswersAreRightWhateverIsProposed) {
  tests::PlanarPairs pairs(tests::chosen_seed(31));
  Random random(tests::chosen_seed(32));
  std::map<Claim, int> held;
  int finished = 0;
  const int count = tests::scaled_count(5000);
  for (int t = 0; t < count; ++t) {
    const tests::PlanarCase c = pairs.next();
    if (c.a.size() + c.b.size() > 60) continue;
    const auto some = [&](const ConvexPolygon& p) {
      return static_cast<std::uint32_t>(random.below(2 * p.size() + 1));
    };
    const auto rubbish = [&](const auto& holds, Cost&, StageTally&) {
      for (int k = 0; k < 6; ++k) {
        Proposal p{static_cast<Claim>(random.below(5)),
                   static_cast<std::uint8_t>(random.below(5)),
                   static_cast<std::uint8_t>(random.below(5)),
                   {some(c.a), some(c.a), some(c.a)},
                   {some(c.b), some(c.b), some(c.b)}};
        if (random.below(2) == 0) {  // three corners of each, mostly in order
          p.count_a = p.count_b = 3;
          const std::uint32_t n = c.a.size(), m = c.b.size();
          p.of_a = {some(c.a) % n, n / 3, n - n / 3}, p.of_b = {some(c.b) % m, m / 3, m - m / 3};
        }
        if (!holds(p)) continue;
        ++held[p.claim];
        return true;
      }
      return false;
    };
    const PairAnswer answer = with_placed(c.a, c.pose_a, c.b, c.pose_b, [&](const auto& in_a, const auto& in_b) {
      return answer_by(in_a, in_b, rubbish);
    });
    ASSERT_EQ(answer.meet(), polygon_polygon_by_scan(c.a, c.pose_a, c.b, c.pose_b).meet()) << t;
    ASSERT_TRUE(is_proved(answer, c.a, c.pose_a, c.b, c.pose_b)) << t;
    const bool flat = c.a.size() < 3 || c.b.size() < 3;
    ASSERT_EQ(answer.cost.proposals == 0, flat);
    if (answer.decided_by == DecidedBy::finishing) {
      EXPECT_EQ(answer.cost.proposals, 6u);
      ++finished;
    }
  }
  if (count < 2000) return;
  for (int k = 0; k < 5; ++k) EXPECT_GT(held[static_cast<Claim>(k)], 5) << k;
  EXPECT_GT(finished, count / 10);
}

// Proposing for many at once, and disposing of them later: what the first proposal of a search is good for.
TEST(PolygonPolygonAnswer, FirstProposalsOfManyPairsAreDisposedOfLater) {
  tests::PlanarPairs pairs(tests::chosen_seed(33));
  std::vector<tests::PlanarCase> cases;
  std::vector<Proposal> proposals;
  const int count = tests::scaled_count(1000);
  for (int t = 0; t < count; ++t) {
    cases.push_back(pairs.next(tests::PlanarFamily::general));
    const tests::PlanarCase& c = cases.back();
    Proposal first;
    Cost cost;
    const auto keep = [&](const Proposal& p) { return first = p, true; };
    propose_by_nearest(PosedPolygon(c.a, c.pose_a), PosedPolygon(c.b, c.pose_b), keep, cost);
    proposals.push_back(first);
  }
  int held = 0;
  for (std::size_t t = 0; t < cases.size(); ++t) {
    const tests::PlanarCase& c = cases[t];
    PairAnswer answer;
    StageTally tally;
    if (!dispose(PosedPolygon(c.a, c.pose_a), PosedPolygon(c.b, c.pose_b), proposals[t], answer.evidence, tally))
      continue;
    ++held;
    ASSERT_EQ(answer.meet(), polygon_polygon(c.a, c.pose_a, c.b, c.pose_b).meet());
    ASSERT_TRUE(is_proved(answer, c.a, c.pose_a, c.b, c.pose_b));
  }
  EXPECT_EQ(held, count);
}

// The share of answers that a method's proposals give, by family: in general position all. Elsewhere about what was
// reached.
TEST(PolygonPolygonAnswer, HitRateByFamily) {
  struct Named {
    const char* name;
    Method method;
  };
  constexpr std::array methods{Named{"front door", polygon_polygon}, Named{"halving", polygon_polygon_by_halving},
                               Named{"triangles", polygon_polygon_by_triangles}, Named{"gjk", polygon_polygon_by_gjk}};
  tests::PlanarPairs pairs(tests::chosen_seed(34));
  const int count = tests::scaled_count(1000);
  std::printf("%-14s", "per mille");
  for (const Named& m : methods) std::printf(" %11s", m.name);
  std::printf("\n");
  for (int f = 0; f < tests::planar_family_count; ++f) {
    const auto family = static_cast<tests::PlanarFamily>(f);
    std::array<int, 4> hits{};
    int asked = 0;
    for (int t = 0; t < count; ++t) {
      const tests::PlanarCase c = pairs.next(family);
      if (c.a.size() < 3 || c.b.size() < 3) continue;  // not proposed about
      ++asked;
      for (std::size_t m = 0; m < 4; ++m) {
        const PairAnswer answer = methods[m].method(c.a, c.pose_a, c.b, c.pose_b);
        EXPECT_GT(answer.cost.proposals, 0u);
        hits[m] += answer.decided_by != DecidedBy::finishing;
      }
    }
    if (asked == 0) continue;
    std::printf("%-14s", std::string(name_of(family)).c_str());
    for (std::size_t m = 0; m < 4; ++m) std::printf(" %11d", hits[m] * 1000 / asked);
    std::printf("\n");
    for (std::size_t m = 0; m < 4; ++m) {
      SCOPED_TRACE(methods[m].name);
      const bool plain = family == tests::PlanarFamily::general || family == tests::PlanarFamily::contained;
      EXPECT_GE(1000 * hits[m], (plain ? 1000 : family == tests::PlanarFamily::any_scale ? 800 : 980) * asked);
    }
  }
}

}  // namespace
}  // namespace sunder::planar::proposal_test
