// Lines, rays and segments: the front doors against the scans, each answer with a certificate that the checker accepts.
#include <tests/support/scale.h>
#include <tests/support/solid_lines.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>

#include <gtest/gtest.h>
#include <verifier/cpp/verify.h>

#include <array>
#include <cstdio>
#include <map>
#include <string>

namespace sunder::tests {
namespace {

using solid::LineLike;
using solid::PolyhedronCut;

constexpr std::array<const char*, 3> kinds{"line", "ray", "segment"};

LineLike other_of(std::size_t kind, const Point3& a, const Point3& b) {
  if (kind == 0) return solid::Line::through(a, b);
  if (kind == 1) return solid::Ray::from(a, b);
  return solid::Segment::between(a, b);
}

PolyhedronCut by_scan(const LineCase& c, const LineLike& other) {
  if (const auto* line = std::get_if<solid::Line>(&other)) return polyhedron_line_by_scan(c.body, c.pose, *line);
  if (const auto* ray = std::get_if<solid::Ray>(&other)) return polyhedron_ray_by_scan(c.body, c.pose, *ray);
  return polyhedron_segment_by_scan(c.body, c.pose, std::get<solid::Segment>(other));
}

std::string certificate_of(const LineCase& c, const LineLike& other, const PolyhedronCut& cut, bool tells_contact) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims pairs(file);
  const solid::LineBody straight = body_of(other);
  const std::uint32_t a = pairs.add_placed("body", pairs.add_body("body", c.body.vertices()), c.pose.affine());
  const std::uint32_t b = pairs.add_body("other", straight.points, straight.ways);
  add_claims(pairs, a, b, c.body, c.pose, other, cut, tells_contact);
  pairs.end();
  return text;
}

std::string text(const Point3& p) {
  char buffer[100];
  std::snprintf(buffer, sizeof buffer, "(%a, %a, %a)", p.x, p.y, p.z);
  return buffer;
}

std::string text(const solid::CutEnd& end) {
  return std::string(name_of(end.at.place)) + " " + std::to_string(end.at.feature) + " " +
         std::to_string(end.at.other) + " own " + std::to_string(static_cast<int>(end.own));
}

std::string text(const PolyhedronCut& c) {
  const auto ends = ends_of(c.evidence);
  return std::string(name_of(kind_of(c))) + " [" + (ends ? text(ends->first) + " | " + text(ends->last) : "") +
         "] decided by " + std::string(name_of(c.decided_by));
}

struct LineTally {
  int cases = 0;
  std::array<int, 4> of_kind{};
  std::array<int, 4> of_decision{};
};

TEST(SolidLineDifferential, FrontDoorsAgreeWithTheScans) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261124);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidLines lines(seed);
  std::map<LineFamily, LineTally> tallies;
  std::map<std::string, int> verdicts;
  for (int i = 0; i < count; ++i) {
    LineCase c = lines.next();
    for (std::size_t kind = 0; kind < 3; ++kind) {
      if (kind == 2 && i % 16 == 0) c.b = c.a;
      const LineLike other = other_of(kind, c.a, c.b);
      const PolyhedronCut found = polyhedron_line_like(c.body, c.pose, other), scan = by_scan(c, other);
      SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)) + " " + kinds[kind] + " " + text(c.a) +
                   " " + text(c.b) + "\nfound " + text(found) + "\nscan  " + text(scan));
      ASSERT_TRUE(is_same_cut(found, scan));
      LineTally& tally = tallies[c.family];
      ++tally.cases;
      ++tally.of_kind[static_cast<std::size_t>(kind_of(found))];
      ++tally.of_decision[static_cast<std::size_t>(found.decided_by)];
      if ((i / line_family_count) % 4 != 0) continue;  // each family, but not each of its cases: to save time
      const bool tells_contact = (i / 64) % 4 != 0;
      const std::string file = certificate_of(c, other, found, tells_contact);
      const auto verified = sunder_verifier::verify_text(file, "certificate", sunder_verifier::Limit::none);
      ASSERT_TRUE(verified.accepted()) << (verified.statements.empty() ? verified.error + verified.failed_form
                                                                       : verified.statements[0].reason)
                                       << file.substr(0, 4000);
      const Relation contact = contact_of(c.body, other, found);
      const std::string verdict = !found.meet() ? "apart" : tells_contact ? std::string(name_of(contact)) : "meet";
      ASSERT_EQ(verified.statements.at(0).verdict, verdict);
      ++verdicts[std::string(kinds[kind]) + " " + verdict];
    }
  }
  std::printf("%-15s %7s | %7s %7s %7s %7s | %7s %8s %9s\n", "family", "cases", "nothing", "point", "along", "across",
              "filter", "evidence", "finishing");
  for (const auto& [family, t] : tallies) {
    std::printf("%-15s %7d | %7d %7d %7d %7d | %7d %8d %9d\n", std::string(name_of(family)).c_str(), t.cases,
                t.of_kind[0], t.of_kind[1], t.of_kind[2], t.of_kind[3], t.of_decision[0], t.of_decision[1],
                t.of_decision[2]);
  }
  for (const auto& [verdict, number] : verdicts) std::printf("%s: %d\n", verdict.c_str(), number);
  if (count < 4000) return;  // too few for the rates below
  // Proposals hold: in general position at least 99.9 %, elsewhere 90 %, of needles of 1e300 : 1 : 1e-300, half of
  // whose lines go through features, 7 in 8; but not where what decides lies hundreds of digits below the coordinates.
  for (const auto& [family, t] : tallies) {
    if (family == LineFamily::stretched_turned) continue;
    const int part = family == LineFamily::general || family == LineFamily::round ? 1000
                     : family == LineFamily::stretched                            ? 8
                                                                                  : 10;
    EXPECT_LE(t.of_decision[static_cast<std::size_t>(DecidedBy::finishing)], t.cases / part) << name_of(family);
    // The test tested something.
    EXPECT_GE(t.cases, 3 * (count / line_family_count));
    EXPECT_GT(t.of_kind[static_cast<std::size_t>(CutKind::nothing)], t.cases / 100) << name_of(family);
    if (family == LineFamily::flat) continue;  // nothing goes through the inside
    EXPECT_GT(t.of_kind[static_cast<std::size_t>(CutKind::across)], t.cases / 10) << name_of(family);
  }
  EXPECT_GT(tallies[LineFamily::features].of_kind[static_cast<std::size_t>(CutKind::along)], count / 100);
  EXPECT_GT(tallies[LineFamily::features].of_kind[static_cast<std::size_t>(CutKind::point)], count / 200);
  EXPECT_GT(tallies[LineFamily::stretched_turned].of_decision[static_cast<std::size_t>(DecidedBy::finishing)], 0);
  for (const char* kind : kinds) {
    for (const char* verdict : {"apart", "meet", "touching", "overlapping"}) {
      EXPECT_GT(verdicts[std::string(kind) + " " + verdict], count / 400) << kind << " " << verdict;
    }
  }
}

}  // namespace
}  // namespace sunder::tests
