// polyhedron_plane_section against polyhedron_plane_section_by_scan: bodies of every kind, and planes that go through
// anything of them, or next to it.
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>
#include <tests/support/solid_shapes.h>

#include <sunder/solid/section/polyhedron_plane_section.h>
#include <sunder/solid/section/section_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Plane;
using solid::PlaneSection;
using solid::Pose;
using solid::SectionCorner;
using solid::SectionKind;

// Through what of the body the plane goes, as far as rounding lets it.
enum class Through : int { anywhere, vertex, edge, facet, three_vertices, axis, last_bit, far };
constexpr int through_count = 8;

class SectionPlanes {
 public:
  explicit SectionPlanes(Random& random) : random_(random) {}

  Plane next(Through through, const ConvexPolyhedron& body, const Pose& pose) {
    const auto vertex = [&] { return image(pose, body.vertices()[random_.below(body.vertices().size())]); };
    Point3 normal = in_cube(random_);
    if (normal == Point3{}) normal = {0, 0, 1};
    if (random_.below(3) == 0) normal = axis();
    switch (through) {
      case Through::anywhere: return Plane::through(middle(vertex(), vertex()), normal);
      case Through::vertex: return Plane::through(vertex(), normal);
      case Through::edge: {
        const auto v = static_cast<std::uint32_t>(random_.below(body.vertices().size()));
        if (body.neighbours(v).empty()) return Plane::through(vertex(), normal);
        const std::uint32_t w = body.neighbours(v)[random_.below(body.neighbours(v).size())];
        return spanned(image(pose, body.vertices()[v]), image(pose, body.vertices()[w]), vertex(), normal);
      }
      case Through::facet: {
        if (body.facet_count() == 0) return Plane::through(vertex(), normal);
        const auto facet = body.facet(static_cast<std::uint32_t>(random_.below(body.facet_count())));
        const auto corner = [&](std::size_t k) { return image(pose, body.vertices()[facet[k]]); };
        return spanned(corner(0), corner(1), corner(2), normal);
      }
      case Through::three_vertices: return spanned(vertex(), vertex(), vertex(), normal);
      case Through::axis: return Plane::through(vertex(), axis());
      case Through::last_bit: {
        Plane plane = next(Through(random_.below(6)), body, pose);
        for (std::size_t k = 0; k < 3; ++k) {
          if (random_.below(2) == 0) plane.point[k] = std::nextafter(plane.point[k], random_.below(2) ? 1e308 : -1e308);
        }
        return plane;
      }
      case Through::far: break;
    }
    const Point3 p = vertex(), q = vertex();
    return Plane::through({2 * p.x - q.x, 2 * p.y - q.y, 2 * p.z - q.z}, normal);
  }

 private:
  static Point3 image(const Pose& pose, const Point3& p) {
    const auto& [m, t] = pose.affine();
    const auto row = [&](std::size_t k) { return m[3 * k] * p.x + m[3 * k + 1] * p.y + m[3 * k + 2] * p.z + t[k]; };
    Point3 image{row(0), row(1), row(2)};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(image[k])) image[k] = 0;
    }
    return image;
  }
  static Point3 middle(const Point3& p, const Point3& q) {
    return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
  }
  Point3 axis() {
    Point3 axis;
    axis[random_.below(3)] = random_.below(2) ? std::ldexp(1, static_cast<int>(random_.below(9)) - 4) : -3;
    return axis;
  }
  static Plane spanned(const Point3& p, const Point3& q, const Point3& r, const Point3& otherwise) {
    const Point3 a{q.x - p.x, q.y - p.y, q.z - p.z}, b{r.x - p.x, r.y - p.y, r.z - p.z};
    Point3 normal{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const bool is_good = std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z);
    if (!is_good || normal == Point3{}) normal = otherwise;
    return Plane::through(p, normal);
  }

  Random& random_;
};

std::string section_proof(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                          const PlaneSection& section) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  solid::SectionClaims claims(file, "body", body, pose);
  claims.add(plane, section);
  file.end();
  return text;
}

// The list of numbers behind a key of the last statement: where it begins and ends, and they.
struct List {
  std::size_t begin = std::string::npos, end = 0;
  std::vector<std::uint32_t> numbers;
};
List list_of(const std::string& text, const std::string& key) {
  List list;
  const std::size_t at = text.rfind("\"" + key + "\"");
  if (at == std::string::npos || at < text.rfind("\"section\"")) return list;
  list.begin = text.find('[', at);
  int depth = 0;
  for (list.end = list.begin;; ++list.end) {
    const char x = text[list.end];
    depth += x == '[' ? 1 : x == ']' ? -1 : 0;
    if (depth == 0) break;
    if (std::isdigit(x) == 0) continue;
    if (std::isdigit(text[list.end - 1]) == 0) list.numbers.push_back(0);
    list.numbers.back() = 10 * list.numbers.back() + static_cast<std::uint32_t>(x - '0');
  }
  return list;
}

// The corners that a proof states, from the least on.
std::vector<SectionCorner> said(const std::string& proof) {
  std::vector<SectionCorner> corners;
  const List list = list_of(proof, "corners");
  for (std::size_t k = 0; k + 1 < list.numbers.size(); k += 2) {
    corners.push_back({list.numbers[k], list.numbers[k + 1]});
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// The proof with one or two of its corners, or the facets along them, changed.
std::string forged(std::string proof, std::uint32_t facets, Random& random) {
  List corners = list_of(proof, "corners"), along = list_of(proof, "along");
  const auto some = [&](std::size_t size) {
    return static_cast<std::uint32_t>(random.below(std::max<std::size_t>(size, 1)));
  };
  std::uint32_t most = 0;
  for (const std::uint32_t v : corners.numbers) most = std::max(most, v);
  for (std::size_t times = 1 + random.below(2); times > 0 && corners.begin != std::string::npos; --times) {
    std::vector<std::uint32_t>& numbers = corners.numbers;
    const std::size_t n = numbers.size() / 2, k = some(n);
    const auto at = [](auto& of, std::size_t place) { return of.begin() + static_cast<std::ptrdiff_t>(place); };
    switch (random.below(6)) {
      case 0:
        numbers.erase(at(numbers, 2 * k), at(numbers, 2 * k + 2));
        if (!along.numbers.empty()) along.numbers.erase(at(along.numbers, k));
        break;
      case 1:
        if (!numbers.empty()) numbers[some(numbers.size())] = some(most + 2);
        break;
      case 2:
        if (!along.numbers.empty()) along.numbers[some(along.numbers.size())] = some(facets);
        break;
      case 3: {  // the other way round
        std::vector<std::uint32_t> turned;
        for (std::size_t j = n; j-- > 0;) turned.insert(turned.end(), {numbers[2 * j], numbers[2 * j + 1]});
        numbers = turned;
        std::reverse(along.numbers.begin(), along.numbers.end());
        if (!along.numbers.empty()) std::rotate(along.numbers.begin(), along.numbers.begin() + 1, along.numbers.end());
        break;
      }
      case 4: {  // one more
        const std::uint32_t v = some(most + 2);
        numbers.insert(at(numbers, 2 * k), {v, random.below(2) == 0 ? v : some(most + 2)});
        if (along.begin != std::string::npos) along.numbers.insert(at(along.numbers, k), some(facets));
        break;
      }
      default:
        if (n > 0) std::rotate(numbers.begin(), at(numbers, 2 * k), numbers.end());
        if (!along.numbers.empty()) std::rotate(along.numbers.begin(), at(along.numbers, k), along.numbers.end());
    }
    if (numbers.empty()) break;
  }
  const auto put = [&](const List& list, std::size_t row) {
    if (list.begin == std::string::npos) return;
    std::string text = "[";
    for (std::size_t k = 0; k < list.numbers.size(); k += row) {
      text += k > 0 ? ", " : "";
      text += row == 1 ? std::to_string(list.numbers[k])
                       : "[" + std::to_string(list.numbers[k]) + ", " + std::to_string(list.numbers[k + 1]) + "]";
    }
    proof.replace(list.begin, list.end - list.begin, text);
  };
  put(along, 1);  // the later one first
  put(corners, 2);
  return proof;
}

struct SectionTally {
  int cases = 0, nothing = 0, point = 0, segment = 0, polygon = 0, at_vertices = 0, exact = 0;
};

TEST(PolyhedronPlaneSectionDifferential, AgreesWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20260301);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  SectionPlanes planes(pairs.random());
  std::map<Family, SectionTally> tallies;
  std::map<Through, SectionTally> ways;
  std::map<std::string, int> proofs;
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next();
    const bool second = pairs.random().below(2) == 0;
    const ConvexPolyhedron& body = second ? c.b : c.a;
    Affine3 m = (second ? c.pose_b : c.pose_a).affine();
    if (pairs.random().below(4) == 0) m = Affine3{};
    if (pairs.random().below(4) == 0) {
      for (std::size_t k = 0; k < 3; ++k) m.linear[k] = -m.linear[k];
    }
    const Pose pose = Pose::from_matrix(m.linear, m.translation);
    const Through through = Through(pairs.random().below(through_count));
    const Plane plane = planes.next(through, body, pose);
    const PlaneSection scan = polyhedron_plane_section_by_scan(body, pose, plane);
    const PlaneSection found = polyhedron_plane_section(body, pose, plane);
    ASSERT_EQ(scan.kind, found.kind) << i << " " << name_of(c.family) << " " << static_cast<int>(through);
    ASSERT_EQ(scan.corners, found.corners) << i << " " << name_of(c.family) << " " << static_cast<int>(through);
    ASSERT_EQ(scan.side, found.side) << i;
    const solid::SectionPoints points(body, pose, plane);
    for (std::size_t k = 0; k < std::min<std::size_t>(found.corners.size(), 4); ++k) {
      const ExactPoint3 exact = points.exact(found.corners[k]);
      const Point3 nearest = points.nearest(found.corners[k]);
      ASSERT_EQ(nearest.x, nearest_ratio(exact.x, exact.denominator)) << i;
      ASSERT_EQ(nearest.y, nearest_ratio(exact.y, exact.denominator)) << i;
      ASSERT_EQ(nearest.z, nearest_ratio(exact.z, exact.denominator)) << i;
    }
    if (body.vertices().size() <= 100 || i % 20 == 0) {
      const std::string proof = section_proof(body, pose, plane, found);
      const auto result = sunder_verifier::verify_text(proof, "proof", sunder_verifier::Limit::none);
      ASSERT_TRUE(result.accepted()) << i << " " << name_of(c.family) << " " << static_cast<int>(through) << " "
                                     << result.failed_form
                                     << (result.statements.empty() ? "" : result.statements.back().reason) << "\n"
                                     << proof;
      ++proofs[result.statements.back().verdict];
    }
    for (SectionTally* t : {&tallies[c.family], &ways[through]}) {
      ++t->cases;
      t->nothing += found.kind == SectionKind::nothing;
      t->point += found.kind == SectionKind::point;
      t->segment += found.kind == SectionKind::segment;
      t->polygon += found.kind == SectionKind::polygon;
      t->at_vertices += std::ranges::any_of(found.corners, &solid::SectionCorner::is_vertex);
      t->exact += found.cost.exact > 0;
    }
  }
  std::printf("%-17s %8s %8s %8s %8s %8s %8s %8s\n", "family", "cases", "nothing", "point", "segment", "polygon",
              "vertices", "exact");
  const auto print = [](const std::string& name, const SectionTally& t) {
    std::printf("%-17s %8d %8d %8d %8d %8d %8d %8d\n", name.c_str(), t.cases, t.nothing, t.point, t.segment, t.polygon,
                t.at_vertices, t.exact);
  };
  for (const auto& [family, t] : tallies) print(std::string(name_of(family)), t);
  for (const auto& [verdict, n] : proofs) std::printf("proved: %s %d\n", verdict.c_str(), n);
  for (const auto& [through, t] : ways) print("way " + std::to_string(static_cast<int>(through)), t);
}

// A false section has no proof: of statements that say something else, a checker accepts only those that are true.
TEST(PolyhedronPlaneSectionDifferential, NoFalseSectionIsAccepted) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20260302);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  Random& random = pairs.random();
  SectionPlanes planes(random);
  int accepted = 0, refused = 0;
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next(i % 2 == 0 ? Family::grid : Family::flat);
    const ConvexPolyhedron& body = c.a;
    const Plane plane = planes.next(Through(random.below(through_count)), body, c.pose_a);
    const PlaneSection scan = polyhedron_plane_section_by_scan(body, c.pose_a, plane);
    const std::string proof = forged(section_proof(body, c.pose_a, plane, scan), body.facet_count(), random);
    const auto result = sunder_verifier::verify_text(proof, "proof", sunder_verifier::Limit::none);
    if (!result.accepted()) {
      ++refused;
      continue;
    }
    ++accepted;
    ASSERT_EQ(said(proof), scan.corners) << i << "\n" << proof;
  }
  std::printf("forged: %d accepted, %d refused\n", accepted, refused);
  EXPECT_GT(accepted, count / 100);
  EXPECT_GT(refused, count / 2);
}

}  // namespace
}  // namespace sunder::tests
