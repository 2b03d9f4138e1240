// polygon_defects against GEOS' isValid, where that is exact: on small whole numbers. Built where GEOS is found.
#include <tests/support/nasty_polygons.h>
#include <tests/support/scale.h>

#include <sunder/planar/polygons/polygon_valid.h>

#include <geos_c.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using planar::PolygonDefectKind;
using planar::PolygonDefects;
using planar::PolygonRings;
using planar::PolygonRule;
using Parts = std::vector<PolygonRings>;

class Geos {
 public:
  Geos() : context_(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(context_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  struct Answer {
    bool valid;
    std::string reason;
  };
  Answer is_valid(const Parts& parts, PolygonRule rule) const {
    std::vector<GEOSGeometry*> polygons;
    for (const PolygonRings& rings : parts) polygons.push_back(polygon(rings));
    GEOSGeometry* geometry = GEOSGeom_createCollection_r(context_, GEOS_MULTIPOLYGON, polygons.data(),
                                                         static_cast<unsigned>(polygons.size()));
    const int flags = rule == PolygonRule::self_touch ? GEOSVALID_ALLOW_SELFTOUCHING_RING_FORMING_HOLE : 0;
    char* reason = nullptr;
    const char answer = GEOSisValidDetail_r(context_, geometry, flags, &reason, nullptr);
    const Answer result{answer == 1, reason == nullptr ? "" : reason};
    EXPECT_NE(answer, 2);
    if (reason) GEOSFree_r(context_, reason);
    GEOSGeom_destroy_r(context_, geometry);
    return result;
  }

 private:
  GEOSGeometry* ring(const std::vector<Point2>& vertices) const {
    const bool is_closed = vertices.size() > 1 && vertices.front() == vertices.back();
    const unsigned size = static_cast<unsigned>(vertices.size()) + (is_closed ? 0 : 1);
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, size, 2);
    for (unsigned k = 0; k < size; ++k) {
      const Point2& p = vertices[k % vertices.size()];
      GEOSCoordSeq_setXY_r(context_, sequence, k, p.x, p.y);
    }
    return GEOSGeom_createLinearRing_r(context_, sequence);
  }
  GEOSGeometry* polygon(const PolygonRings& rings) const {
    std::vector<GEOSGeometry*> holes;
    for (std::size_t r = 1; r < rings.size(); ++r) holes.push_back(ring(rings[r]));
    return GEOSGeom_createPolygon_r(context_, ring(rings[0]), holes.data(), static_cast<unsigned>(holes.size()));
  }

  GEOSContextHandle_t context_;
};

std::string wkt_of(const Parts& parts) {
  std::string text = "MULTIPOLYGON (";
  for (std::size_t p = 0; p < parts.size(); ++p) {
    text += p > 0 ? ", (" : "(";
    for (std::size_t r = 0; r < parts[p].size(); ++r) {
      text += r > 0 ? ", (" : "(";
      const std::vector<Point2>& ring = parts[p][r];
      for (std::size_t k = 0; k <= ring.size(); ++k) {
        const Point2& v = ring[k % ring.size()];
        text +=
            (k > 0 ? ", " : "") + std::to_string(static_cast<int>(v.x)) + " " + std::to_string(static_cast<int>(v.y));
      }
      text += ")";
    }
    text += ")";
  }
  return text + ")";
}

// A ring of fewer than four points, the closing one counted, cannot be made in GEOS.
bool can_be_made(const Parts& parts) {
  for (const PolygonRings& rings : parts) {
    for (const std::vector<Point2>& ring : rings) {
      const bool is_closed = ring.size() > 1 && ring.front() == ring.back();
      if (ring.size() + (is_closed ? 0 : 1) < 4) return false;
    }
  }
  return true;
}

// With rings that touch themselves GEOS 3.11 differs about the interior, and about nothing else: a ring that does, and
// touches another one, is said to part the interior, as if its touch with itself closed a cycle; and a shell of which
// two pieces hang together in its highest point only is said to be valid. The oracle decides.
bool is_explained(const Parts& parts, const PolygonDefects& answer, const Geos::Answer& expected) {
  const PolygonDefects truth = planar::polygon_defects_by_scan(parts, {PolygonRule::self_touch});
  if (planar::polygon_defects(parts).found.empty() || truth.found.empty() != answer.found.empty()) return false;
  return answer.found.empty() ? expected.reason == "Interior is disconnected"
                              : answer.found.front().kind == PolygonDefectKind::disconnected;
}

void compare(PolygonRule rule, std::uint64_t seed_by_default) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(seed_by_default);
  SCOPED_TRACE("seed " + std::to_string(seed));
  NastyPolygons polygons(seed);
  const Geos geos;
  int valid = 0, made = 0, differ = 0;
  std::map<std::string, int> reasons;
  for (int k = 0; k < count; ++k) {
    const Parts parts = polygons.next(static_cast<NastyFamily>(k % nasty_family_count));
    if (!can_be_made(parts)) continue;
    ++made;
    const PolygonDefects answer = planar::polygon_defects(parts, {rule});
    const Geos::Answer expected = geos.is_valid(parts, rule);
    if (answer.found.empty() != expected.valid && ++differ > 0) {
      ASSERT_TRUE(is_explained(parts, answer, expected)) << wkt_of(parts) << "\n  GEOS: " << expected.reason;
    }
    valid += answer.found.empty();
    ++reasons[expected.valid ? "valid" : expected.reason];
  }
  std::printf("GEOS %s: %d asked, %d valid, %d differ\n", GEOSversion(), made, valid, differ);
  for (const auto& [reason, n] : reasons) std::printf("  %-24s %6d\n", reason.c_str(), n);
  EXPECT_TRUE(differ == 0 || rule == PolygonRule::self_touch) << differ;
  if (count < 2000) return;  // too few for the rates below
  EXPECT_LE(differ, made / 100);
  EXPECT_GT(made, count * 9 / 10);
  EXPECT_GT(valid, count / 10);
  EXPECT_GT(made - valid, count / 4);
}

TEST(PolygonValidGeos, Valid) { compare(PolygonRule::valid, 20261122); }
TEST(PolygonValidGeos, SelfTouch) { compare(PolygonRule::self_touch, 20261123); }

}  // namespace
}  // namespace sunder::tests
