// How far apart bodies with a radius are, and whether so far: what round_distance and round_clearance say, against
// fractions that check their evidence by the page's definitions, and against each other.
#include <tests/support/doubles.h>
#include <tests/support/round_oracle.h>
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>

#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_distance.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {
namespace {

using solid::PlacedRound;
using solid::RoundClearance;
using solid::RoundDistance;

bool is_curved(const RoundCase& c) { return c.a.is_curved() || c.b.is_curved(); }

Triple direction_of(const WorldDirection& direction) {
  const Vector3<Dyadic> d = direction.exact();
  return triple({d.x, d.y, d.z});
}

// The direction that proves how far apart they are.
WorldDirection way_of(const RoundDistance& apart) {
  const auto* closest = std::get_if<solid::ClosestFeatures>(&apart.evidence);
  if (closest != nullptr) return solid::HullsApart{*closest}.direction();
  const auto* curved = std::get_if<solid::CurvedApart>(&apart.evidence);
  return curved != nullptr ? curved->nearest->direction : std::get<solid::HullsApart>(apart.evidence).direction();
}

// Is the evidence that of what it says? Of undecided ones: nothing is said.
bool is_right(const OracleBody& a, const OracleBody& b, double least, const RoundClearance& found) {
  if (found.undecided()) return true;
  if (const auto* kept = std::get_if<solid::ClearanceKept>(&found.evidence)) {
    return is_clear(a, b, direction_of(kept->direction), fraction(least));
  }
  const Fraction square = squared_way(a, b, *std::get<solid::ClearanceBroken>(found.evidence).points);
  return square >= 0 && square < fraction(least) * fraction(least);
}
bool is_right(const OracleBody& a, const OracleBody& b, const RoundDistance& found,
              const std::array<PointOf, 2>& points) {
  const auto [low, high] = distance_of(found);
  if (!(low >= 0 && low <= high)) return false;
  const Fraction square = squared_way(a, b, points);
  if (square < 0) return false;
  const double above = std::nextafter(high, infinity);
  if (std::isfinite(above) && square >= fraction(above) * fraction(above)) return false;
  return low == 0 || is_clear(a, b, direction_of(way_of(found)), fraction(low));
}

std::vector<double> asked_about(const Interval& d, double size, Random& random) {
  std::vector<double> all{d.low,
                          d.high,
                          std::nextafter(d.low, 0.0),
                          std::nextafter(d.high, infinity),
                          d.high * (1 + 0x1p-40),
                          d.low * (1 - 0x1p-40),
                          d.high + 0x1p-38 * size,
                          d.low - 0x1p-38 * size,
                          d.high * random.log_uniform(0.001, 1000),
                          size * random.log_uniform(1e-300, 1e3),
                          5e-324};
  std::erase_if(all, [](double c) { return !(c > 0 && std::isfinite(c)); });
  return all;
}

struct RoundDistanceTally {
  int all = 0, meet = 0, narrow = 0, within_units = 0, kept = 0, broken = 0, undecided = 0;
  double widest = 0;  // of the size
};

TEST(RoundDistanceDifferential, EachAnswerIsProved) {
  const std::uint64_t seed = chosen_seed(20261201);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  Random random(seed + 1);
  const int count = scaled_count(1500);
  std::map<std::string, RoundDistanceTally> tallies;
  for (int i = 0; i < count; ++i) {
    const RoundCase c = pairs.next();
    const PlacedRound a(c.a, c.pose_a), b(c.b, c.pose_b);
    const OracleBody of_a(a), of_b(b);
    const RoundDistance found = round_distance(a, b);
    const solid::RoundAnswer answer = round_round(a, b);
    const auto [low, high] = distance_of(found);
    const double size = std::max(size_of(a), size_of(b));
    const bool is_huge = size > 1e100 && c.family == RoundFamily::degenerate;  // a radius of 1e200
    SCOPED_TRACE(std::to_string(i) + " " + named(c));
    RoundDistanceTally& tally = tallies[std::string(name_of(c.family))];
    ++tally.all;
    ASSERT_TRUE(is_right(of_a, of_b, found, nearest_of(a, b, found.evidence))) << low << " " << high;
    // Of an undecided pair the points may be one.
    ASSERT_TRUE(found.meet() == answer.meet() || (found.meet() && answer.undecided()));
    if (found.meet()) {
      ++tally.meet;
    } else if (!is_curved(c)) {
      ASSERT_LE(high, std::nextafter(low, infinity));
    } else {
      if (!is_huge) {
        ASSERT_LE(high - low, 0x1p-40 * size) << low << " " << high;
        tally.widest = std::max(tally.widest, (high - low) / size);
      }
      if (high - low <= 0x1p-40 * high) ++tally.narrow;
      if (high - low <= 0x1p-50 * high) ++tally.within_units;
    }
    for (const double least : asked_about(distance_of(found), size, random)) {
      const RoundClearance clearance = round_clearance(a, b, least);
      const Verdict alone = clearance_verdict(a, b, least);
      ASSERT_TRUE(alone == clearance.verdict() || alone == Verdict::undecided || clearance.undecided()) << least;
      ASSERT_TRUE(is_right(of_a, of_b, least, clearance)) << least << " " << name_of(clearance.verdict());
      ++(is_kept(clearance) ? tally.kept : is_broken(clearance) ? tally.broken : tally.undecided);
      ASSERT_FALSE(clearance.undecided() && !is_curved(c)) << least << " of " << low << ", " << high;
      if (least > high) {
        ASSERT_TRUE(is_broken(clearance)) << least << " of " << low << ", " << high;
      }
      if (least <= low) {
        ASSERT_TRUE(is_kept(clearance)) << least << " of " << low << ", " << high;
      }
      if (clearance.undecided() && !is_huge) {
        const double by = 0x1p-40 * size;
        ASSERT_TRUE(least - by <= 0 || is_kept(round_clearance(a, b, least - by)))
            << least << " " << low << " " << high;
        ASSERT_TRUE(is_broken(round_clearance(a, b, least + by))) << least << " of " << low << ", " << high;
      }
    }
  }
  int all = 0, undecided = 0;
  for (const auto& [family, t] : tallies) {
    const int asked = t.kept + t.broken + t.undecided;
    all += asked;
    undecided += t.undecided;
    if (t.all >= 50) {
      EXPECT_GT(t.broken, asked / 8) << family;
      if (family != "touching") {
        EXPECT_GT(t.kept, asked / 8) << family;
      }
    }
    std::printf(
        "%-13s of %d meet %d; curved ones within 2^-40 of the distance %d, 2^-50 %d; widest %.3g of the size; "
        "clearance kept %d, broken %d, undecided %d\n",
        family.c_str(), t.all, t.meet, t.narrow, t.within_units, t.widest, t.kept, t.broken, t.undecided);
  }
  if (count >= 200) {
    EXPECT_LT(undecided, all / 50);
  }
}

// Is a file of these statements accepted by a checker that knows nothing of the library?
template <class Write>
sunder_verifier::FileResult verified(const PlacedRound& a, const PlacedRound& b, const Write& write) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims claims(file);
  const std::uint32_t index_a = add_round(claims, "a", a), index_b = add_round(claims, "b", b);
  write(claims, index_a, index_b);
  claims.end();
  return sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
}

// The distances as certificate files; and what is not true is refused: that they are further apart than the points,
// nearer than along the direction, or as far apart the other way.
TEST(RoundDistanceDifferential, TheVerifierAcceptsWhatIsTrueOnly) {
  const std::uint64_t seed = chosen_seed(20261202);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  Random random(seed + 1);
  const int count = scaled_count(1000);
  int accepted = 0, refused = 0;
  for (int i = 0; i < count; ++i) {
    const RoundCase c = pairs.next();
    SCOPED_TRACE(std::to_string(i) + " " + named(c));
    const PlacedRound a(c.a, c.pose_a), b(c.b, c.pose_b);
    const RoundDistance found = round_distance(a, b);
    const auto [low, high] = distance_of(found);
    const auto result =
        verified(a, b, [&](PairClaims& file, std::uint32_t x, std::uint32_t y) { add_claims(file, x, y, found); });
    const bool is_finite = std::isfinite(std::nextafter(high, infinity));
    if (low > 0 || is_finite) {
      ASSERT_TRUE(result.accepted()) << low << " " << high << result.failed_form << result.error;
      ASSERT_EQ(result.statements.size(), (low > 0 ? 1u : 0u) + (is_finite ? 1u : 0u));
      ++accepted;
    }
    if (low > 0) {
      const Vector3<Dyadic> d = way_of(found).exact();
      const std::array<Dyadic, 3> way{d.x, d.y, d.z}, back{-d.x, -d.y, -d.z};
      const double more = std::nextafter(high, infinity);
      const auto kept = [&](double least, const std::array<Dyadic, 3>& direction) {
        return verified(a, b,
                        [&](PairClaims& file, std::uint32_t x, std::uint32_t y) {
                          file.add_clearance(x, y, least, direction);
                        })
            .accepted();
      };
      if (std::isfinite(more)) {
        ASSERT_FALSE(kept(more, way));
        ++refused;
      }
      ASSERT_FALSE(kept(low, back));
      const auto points = nearest_of(a, b, found.evidence);
      const auto broken = verified(a, b, [&](PairClaims& file, std::uint32_t x, std::uint32_t y) {
        file.add_clearance_broken(x, y, low, points[0], points[1]);
      });
      ASSERT_FALSE(broken.accepted());
      refused += 2;
    }
    const double size = std::max(size_of(a), size_of(b)), least = size * random.log_uniform(1e-3, 1e2);
    const RoundClearance clearance = round_clearance(a, b, least);
    if (clearance.undecided() || !std::isfinite(least)) continue;
    const auto second = verified(
        a, b, [&](PairClaims& file, std::uint32_t x, std::uint32_t y) { add_claims(file, x, y, least, clearance); });
    ASSERT_TRUE(second.accepted()) << least << second.failed_form << second.error;
    ASSERT_EQ(second.statements[0].verdict, is_kept(clearance) ? "kept" : "broken");
  }
  std::printf("%d accepted, %d refused\n", accepted, refused);
  EXPECT_GT(accepted, count / 2);
  EXPECT_GT(refused, count / 2);
}

}  // namespace
}  // namespace sunder::tests
