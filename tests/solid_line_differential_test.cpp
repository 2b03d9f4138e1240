// Lines, rays and segments: the front doors against the scans.
#include <tests/support/scale.h>
#include <tests/support/solid_lines.h>

#include <sunder/solid/pair/polyhedron_line.h>
#include <sunder/solid/pair/polyhedron_ray.h>
#include <sunder/solid/pair/polyhedron_segment.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <map>
#include <string>

namespace sunder::tests {
namespace {

using solid::CutKind;
using solid::PolyhedronCut;

enum class Other : int { line, ray, segment };

PolyhedronCut cut(Other other, const LineCase& c, bool by_scan) {
  switch (other) {
    case Other::line: {
      const solid::Line line = solid::Line::through(c.a, c.b);
      return by_scan ? polyhedron_line_by_scan(c.body, c.pose, line) : polyhedron_line(c.body, c.pose, line);
    }
    case Other::ray: {
      const solid::Ray ray = solid::Ray::from(c.a, c.b);
      return by_scan ? polyhedron_ray_by_scan(c.body, c.pose, ray) : polyhedron_ray(c.body, c.pose, ray);
    }
    case Other::segment: break;
  }
  const solid::Segment segment = solid::Segment::between(c.a, c.b);
  return by_scan ? polyhedron_segment_by_scan(c.body, c.pose, segment) : polyhedron_segment(c.body, c.pose, segment);
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
  return std::string(name_of(c.kind)) + " [" + text(c.first) + " | " + text(c.last) + "] decided by " +
         std::string(name_of(c.decided_by));
}

struct Tally {
  int cases = 0, finished = 0;
  std::array<int, 4> of_kind{};
  std::array<int, 4> of_decision{};
};

TEST(SolidLineDifferential, FrontDoorsAgreeWithTheScans) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261124);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidLines lines(seed);
  std::map<LineFamily, Tally> tallies;
  for (int i = 0; i < count; ++i) {
    LineCase c = lines.next();
    for (const Other other : {Other::line, Other::ray, Other::segment}) {
      if (other == Other::segment && i % 16 == 0) c.b = c.a;
      const PolyhedronCut found = cut(other, c, false), scan = cut(other, c, true);
      SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)) + " " +
                   std::to_string(static_cast<int>(other)) + " " + text(c.a) + " " + text(c.b) + "\nfound " +
                   text(found) + "\nscan  " + text(scan));
      ASSERT_EQ(found.kind, scan.kind);
      if (found.meet()) {
        ASSERT_EQ(found.first, scan.first);
        ASSERT_EQ(found.last, scan.last);
        ASSERT_EQ(found.surface, scan.kind == CutKind::along ? scan.surface : found.surface);
      }
      Tally& tally = tallies[c.family];
      ++tally.cases;
      ++tally.of_kind[static_cast<std::size_t>(found.kind)];
      ++tally.of_decision[static_cast<std::size_t>(found.decided_by)];
    }
  }
  std::printf("%-15s %7s | %7s %7s %7s %7s | %7s %8s %9s\n", "family", "cases", "nothing", "point", "along", "across",
              "filter", "evidence", "finishing");
  for (const auto& [family, t] : tallies) {
    std::printf("%-15s %7d | %7d %7d %7d %7d | %7d %8d %9d\n", std::string(name_of(family)).c_str(), t.cases,
                t.of_kind[0], t.of_kind[1], t.of_kind[2], t.of_kind[3], t.of_decision[0], t.of_decision[1],
                t.of_decision[2]);
  }
}

}  // namespace
}  // namespace sunder::tests
