// Planes of support through lines: all methods, and Lemma 12 itself, against the scan, on lines that miss, that touch in
// a facet, an edge or a vertex, and that go through; and what Lemma 12 costs at vertices of many edges.
#include <tests/support/doubles.h>
#include <tests/support/scale.h>
#include <tests/support/solid_lines.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_line_support.h>
#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::CutFeature;
using solid::CutPlace;
using solid::Line;
using solid::LineSupport;
using solid::Pose;
using solid::SupportOnly;
using solid::SupportPlane;
using solid::SupportRange;

bool is_same_support(const LineSupport& found, const LineSupport& scan) {
  if (found.evidence.index() != scan.evidence.index()) return false;
  const auto of_found = planes_of(found.evidence), of_scan = planes_of(scan.evidence);
  for (std::size_t k = 0; k < of_found.size(); ++k) {
    if (!(of_found[k].touches == of_scan[k].touches)) return false;
    if (of_found.size() == 2 && of_found[k].side != of_scan[k].side) return false;
  }
  const auto *range = std::get_if<SupportRange>(&found.evidence), *other = std::get_if<SupportRange>(&scan.evidence);
  return range == nullptr || range->at == other->at;
}

// What is said of a plane, about all vertices.
void expect_supports(const ConvexPolyhedron& body, const Pose& pose, const Line& line, const SupportPlane& plane) {
  const auto touched = vertices_of(body, plane.touches);
  const auto at = [&](std::uint32_t v) { return posed(body.vertices()[v], pose.affine()); };
  EXPECT_FALSE(are_collinear(line.a, line.b, at(plane.through)));
  for (std::uint32_t v = 0; v < body.vertices().size(); ++v) {
    const bool is_touched = std::find(touched.begin(), touched.end(), v) != touched.end();
    EXPECT_EQ(orient_3d(line.a, line.b, at(plane.through), at(v)), is_touched ? Sign::zero : plane.side);
  }
}

// Bodies of whole numbers, so that middles of edges and images under some poses are doubles.
class TouchingLines {
 public:
  explicit TouchingLines(SolidLines& lines) : random_(lines.random()) {
    for (const LineFamily family :
         {LineFamily::general, LineFamily::round, LineFamily::boxes, LineFamily::prisms, LineFamily::bipyramids,
          LineFamily::heights, LineFamily::shapes, LineFamily::grid}) {
      for (int i = 0; i < 12; ++i) {
        const LineCase c = lines.next(family);
        const auto [low, high] = c.body.box();
        const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
        const double by = family == LineFamily::grid ? 4 : std::ldexp(1.0, 20 - std::ilogb(size));
        std::vector<Point3> points;
        for (const Point3& p : c.body.vertices()) {
          points.push_back({2 * std::round(p.x * by), 2 * std::round(p.y * by), 2 * std::round(p.z * by)});
        }
        ConvexPolyhedron body(points);
        if (body.dimension() == 3) bodies_.push_back(std::move(body));
      }
    }
  }

  LineCase next(CutPlace where) {
    const ConvexPolyhedron& body = bodies_[random_.below(bodies_.size())];
    const auto vertices = body.vertices();
    const auto v = static_cast<std::uint32_t>(random_.below(vertices.size()));
    const auto around = body.neighbours(v);
    const std::size_t k = random_.below(around.size());
    const Point3 p = vertices[v], q = vertices[around[k]], r = vertices[around[(k + 1) % around.size()]];
    Point3 a = p, b = q;
    if (where == CutPlace::facet) {
      // Through two points of the facet's boundary.
      a = random_.below(2) == 0 ? middle(p, q) : middle(p, r), b = random_.below(2) == 0 ? middle(q, r)
                                                                   : a == q              ? r
                                                                                         : q;
      if (random_.below(3) == 0) b = random_.below(2) == 0 ? Point3{2 * q.x - r.x, 2 * q.y - r.y, 2 * q.z - r.z} : b;
    } else if (where == CutPlace::vertex || random_.below(2) == 0) {
      Point3 out{};  // across which the line goes
      for (const std::uint32_t w : around) {
        const Point3 d = minus(p, vertices[w]);
        const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        for (std::size_t i = 0; i < 3; ++i) out[i] += d[i] / length;
      }
      const Point3 e = minus(q, p);
      if (where == CutPlace::edge) a = middle(p, q);
      Point3 way{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
      if (where == CutPlace::edge) {
        const double share = dot(out, e) / dot(e, e);
        for (std::size_t i = 0; i < 3; ++i) out[i] -= share * e[i];
      }
      const double share = dot(way, out) / dot(out, out);
      for (std::size_t i = 0; i < 3; ++i) way[i] = std::round(0x1p18 * (way[i] - share * out[i]));
      b = {a.x + way.x, a.y + way.y, a.z + way.z};
    }
    if (random_.below(3) == 0) std::swap(a, b);
    if (random_.below(4) == 0) {  // further away
      const double by = std::ldexp(1.0, static_cast<int>(random_.below(20)));
      b = {a.x + by * (b.x - a.x), a.y + by * (b.y - a.y), a.z + by * (b.z - a.z)};
    }
    const Pose pose = random_.below(2) == 0 ? Pose() : turned_exactly();
    a = image(pose, a), b = image(pose, b);
    if (random_.below(8) == 0) b[random_.below(3)] = moved_by_bits(b[random_.below(3)], random_.between(-2, 2));
    if (random_.below(8) == 0) {
      const std::size_t axis = random_.below(3);
      a[axis] = moved_by_bits(a[axis], random_.between(-2, 2));
    }
    if (a == b) return next(where);
    return {LineFamily::grid, body, pose, a, b};
  }

 private:
  static Point3 middle(const Point3& p, const Point3& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2}; }
  static Point3 minus(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
  static double dot(const Point3& p, const Point3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
  static Point3 image(const Pose& pose, const Point3& p) {
    const auto& [m, t] = pose.affine();
    const auto row = [&](std::size_t i) { return m[3 * i] * p.x + m[3 * i + 1] * p.y + m[3 * i + 2] * p.z + t[i]; };
    return {row(0), row(1), row(2)};
  }
  Pose turned_exactly() {
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::swap(axes[0], axes[random_.below(3)]);
    std::swap(axes[1], axes[1 + random_.below(2)]);
    std::array<double, 9> m{};
    std::array<double, 3> shift{};
    for (std::size_t i = 0; i < 3; ++i) {
      m[3 * i + axes[i]] = random_.below(2) == 0 ? 0.5 : -2;
      shift[i] = static_cast<double>(random_.between(-1000, 1000));
    }
    m[3 * 0 + (axes[0] + 1) % 3] = random_.below(2) == 0 ? 0 : 1;
    return Pose::from_matrix(m, shift);
  }

  Random& random_;
  std::vector<ConvexPolyhedron> bodies_;
};

std::string support_certificate(const LineCase& c, const Line& line, const LineSupport& found) {
  return claims_text({}, [&](ClaimsWriter& file) {
    PairClaims pairs(file);
    const std::uint32_t body = pairs.add_placed("body", pairs.add_body("body", c.body.vertices()), c.pose.affine());
    const solid::LineBody of_line = body_of(solid::LineLike(line));
    add_support(pairs, body, pairs.add_body("line", of_line.points, of_line.ways), c.body, c.pose, line, found);
  });
}

// Lines that miss or go through; the same, made to touch and some bits away from that; lines that touch.
constexpr std::array<std::string_view, 3> asked_parts{"random lines", "some bits away from touching", "touching"};

struct SupportTally {
  std::array<int, asked_parts.size()> cases{}, finished{};
  std::uint64_t probes = 0;
};

// What is asked for in turn: lines that miss, that go through, that touch at a vertex, an edge and a facet.
constexpr std::array<std::string_view, 5> asked_kinds{"misses", "goes through", "vertex", "edge", "facet"};

std::size_t asked_kind_of(const LineSupport& found) {
  if (!found.meet()) return 0;
  const auto* range = std::get_if<SupportRange>(&found.evidence);
  const auto* only = std::get_if<SupportOnly>(&found.evidence);
  if (range == nullptr && only == nullptr) return 1;
  switch ((range != nullptr ? range->at : only->plane.touches).place) {
    case CutPlace::vertex: return 2;
    case CutPlace::edge: return 3;
    default: return 4;
  }
}

TEST(SolidLineSupportDifferential, AllMethodsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261129);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidLines lines(seed);
  TouchingLines touching(lines);
  std::map<std::string, int> outcomes;
  std::array<int, asked_kinds.size()> cases_of{};
  std::array<SupportTally, 3> tallies;
  constexpr std::array places{CutPlace::vertex, CutPlace::edge, CutPlace::facet};
  for (int i = 0; i < count; ++i) {
    // A half of those that miss or go through are made to touch, and some bits away from that.
    const std::size_t kind = static_cast<std::size_t>(i) % asked_kinds.size();
    const bool is_made_to_touch = kind > 1 || lines.random().below(2) == 0;
    const auto next = [&] {
      if (!is_made_to_touch) return lines.next();
      return touching.next(places[kind > 1 ? kind - 2 : lines.random().below(3)]);
    };
    std::optional<LineCase> drawn;
    LineSupport scan;
    do {
      drawn.emplace(next());
      if (drawn->body.dimension() < 3) continue;
      scan = polyhedron_line_support_by_scan(drawn->body, drawn->pose, Line::through(drawn->a, drawn->b));
    } while (drawn->body.dimension() < 3 || asked_kind_of(scan) != kind);
    const LineCase& c = *drawn;
    ++cases_of[kind];
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)));
    const Line line = Line::through(c.a, c.b);
    const std::array found{polyhedron_line_support(c.body, c.pose, line),
                           polyhedron_line_support_by_hierarchy(c.body, c.pose, line),
                           polyhedron_line_support_by_drums(c.body, c.pose, line)};
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_TRUE(is_same_support(found[k], scan))
          << k << " " << name_of(found[k].evidence) << ", scan: " << name_of(scan.evidence);
      if (c.family == LineFamily::stretched_turned) continue;  // see solid_line_by_drums_differential_test.cpp
      const std::size_t part = kind > 1 ? 2 : is_made_to_touch ? 1 : 0;
      ++tallies[k].cases[part];
      tallies[k].finished[part] += found[k].decided_by == DecidedBy::finishing;
      tallies[k].probes += found[k].cost.probes;
    }
    for (const SupportPlane& plane : planes_of(found[static_cast<std::size_t>(i) % 3].evidence)) {
      expect_supports(c.body, c.pose, line, plane);
    }
    if (i % 16 == 0) {
      const std::string file = support_certificate(c, line, found[static_cast<std::size_t>(i / 16) % 3]);
      const auto verified = sunder_verifier::verify_text(file, "certificate", sunder_verifier::Limit::none);
      ASSERT_TRUE(verified.accepted()) << (verified.statements.empty() ? verified.error + verified.failed_form
                                                                       : verified.statements[0].reason);
    }
    std::optional<CutFeature> at;
    if (const auto* range = std::get_if<SupportRange>(&scan.evidence)) at = range->at;
    if (const auto* only = std::get_if<SupportOnly>(&scan.evidence)) at = only->plane.touches;
    std::string outcome(name_of(scan.evidence));
    if (at) {
      ASSERT_TRUE(is_same_support(planes_of_support_at(c.body, c.pose, line, *at), scan));
      outcome += " at " + std::string(name_of(at->place));
    }
    if (HasFailure()) return;
    ++outcomes[outcome];
  }
  for (const auto& [outcome, n] : outcomes) std::printf("%-28s %6d\n", outcome.c_str(), n);
  for (const SupportTally& t : tallies) {
    for (std::size_t part = 0; part < asked_parts.size(); ++part) {
      std::printf("%s: finished %d of %d\n", asked_parts[part].data(), t.finished[part], t.cases[part]);
    }
    std::printf("%.0f probes\n", static_cast<double>(t.probes) / std::reduce(t.cases.begin(), t.cases.end()));
  }
  for (const int cases : cases_of) EXPECT_GE(cases, count / static_cast<int>(asked_kinds.size()));
  if (count < 2000) return;
  EXPECT_GT(outcomes["one plane at edge"], count / 30);
  EXPECT_GT(outcomes["a range of planes at edge"], count / 30);
  // Floating point does not tell of most lines that touch what they have in common with the body.
  for (const SupportTally& t : tallies) {
    EXPECT_LT(t.finished[0], t.cases[0] / 30);
    EXPECT_LT(t.finished[1], t.cases[1] / 8);
    EXPECT_LT(t.finished[2], t.cases[2] / 3);
  }
}

// Lines beside and through a vertex of many edges, in the planes of its facets, and along its edges.
TEST(SolidLineSupportDifferential, AtVerticesOfManyEdges) {
  Random random(chosen_seed(20261201));
  for (const int n : {6, 40, 100, 300}) {
    std::vector<Point3> points{{0, 0, 0x1p18}, {0, 0, -0x1p18}};
    for (int k = 0; k < n; ++k) {
      const double t = 6.283185307179586 * k / n;
      points.push_back({2 * std::round(0x1p20 * std::cos(t)), 2 * std::round(0x1p20 * std::sin(t)), 0});
    }
    const ConvexPolyhedron body(points);
    std::uint32_t hub = 0;
    while (body.vertices()[hub].z <= 0) ++hub;
    const auto around = body.neighbours(hub);
    const Point3 v = body.vertices()[hub];
    const auto moved = [](const Point3& p, const Point3& from, const Point3& to) {
      return Point3{p.x + (to.x - from.x), p.y + (to.y - from.y), p.z + (to.z - from.z)};
    };
    for (int i = scaled_count(800); i > 0; --i) {
      const std::size_t k = random.below(around.size());
      const Point3 u = body.vertices()[around[k]], w = body.vertices()[around[(k + 1) % around.size()]];
      const auto whole = [&](double size) { return std::round(random.uniform(-size, size)); };
      const Point3 any{whole(0x1p20), whole(0x1p20), whole(0x1p16)}, beyond = moved(v, u, v);
      const std::array<Line, 8> lines{Line{beyond, moved(beyond, u, w)},  // in a facet's plane, beside it
                                      Line{moved(w, u, w), moved(v, u, moved(w, u, w))},
                                      Line{beyond, moved(beyond, {}, any)},            // in the plane of an edge, too
                                      Line{v, u},                                      // along an edge
                                      Line{v, {(u.x + w.x) / 2, (u.y + w.y) / 2, 0}},  // in a facet
                                      Line{v, moved(v, u, w)},                         // in its plane, at the vertex
                                      Line{v, moved(v, {}, any)},                      // through the vertex
                                      Line{moved(v, {}, {0, 0, 1}), moved(v, {}, any)}};
      const std::size_t which = static_cast<std::size_t>(i) % lines.size();
      const Line& line = lines[which];
      if (line.a == line.b) continue;
      SCOPED_TRACE(std::to_string(n) + " edges, " + std::to_string(which) + ", " + std::to_string(i));
      const LineSupport scan = polyhedron_line_support_by_scan(body, Pose(), line);
      ASSERT_TRUE(is_same_support(polyhedron_line_support(body, Pose(), line), scan));
      ASSERT_TRUE(is_same_support(polyhedron_line_support_by_hierarchy(body, Pose(), line), scan));
      ASSERT_TRUE(is_same_support(polyhedron_line_support_by_drums(body, Pose(), line), scan));
      if (which < 3 || which == 7 || std::holds_alternative<solid::SupportNone>(scan.evidence)) continue;
      ASSERT_TRUE(is_same_support(planes_of_support_at(body, Pose(), line, {CutPlace::vertex, hub, 0}), scan));
    }
  }
}

}  // namespace
}  // namespace sunder::tests
