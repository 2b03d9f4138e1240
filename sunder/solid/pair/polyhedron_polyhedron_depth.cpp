// The polytope grows until its nearest facet is one of the difference D = A - B.
//
// Why that is enough: the polytope P is in D, and holds a ball about the origin as large as its nearest facet is far.
// If nothing of D is beyond the plane of that facet, the boundary of D is as near there: so the depth is its distance.
#include <sunder/base/contract.h>
#include <sunder/number/exact_vector.h>
#include <sunder/number/root.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>
#include <sunder/solid/search/expanding_polytope.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::solid {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

class DepthSearch {
 public:
  DepthSearch(const Placed& a, const Placed& b, PolyhedronDepth& found)
      : a_(a), b_(b), found_(found), polytope_([this](std::uint32_t corner) {
          const auto [v, w] = corners_[corner];
          return coordinates<Dyadic>(a_[v]) - coordinates<Dyadic>(b_[w]);
        }) {}

  void run() {
    if (const std::optional<Vector3<Dyadic>> normal = begin()) {
      found_.depth = {0.0};
      found_.direction = WorldDirection(*normal);
    } else {
      grow();
    }
    exact_ += polytope_.exact_signs();
  }

  std::uint32_t exact_signs() const { return exact_ + tally_.exact; }

 private:
  using Corner = std::array<std::uint32_t, 2>;

  std::uint32_t add(const Corner& corner) {
    corners_.push_back(corner);
    return polytope_.add_corner(coordinates<Estimate>(a_[corner[0]]) - coordinates<Estimate>(b_[corner[1]]));
  }

  void remove_last() {
    corners_.pop_back();
    polytope_.remove_last_corner();
  }

  // The furthest along the direction, exactly; the one given, where none is further.
  Corner furthest(const WorldDirection& direction, const Corner& from) {
    Along along_a(direction, a_.pose, a_.tame), along_b(direction, b_.pose, b_.tame);
    return {extreme_vertex_from(a_, along_a, End::greatest, from[0], found_.answer.cost, tally_),
            extreme_vertex_from(b_, along_b, End::least, from[1], found_.answer.cost, tally_)};
  }

  // Corners that are furthest along these directions and back, until one is off what the others span, as their offset
  // from the first tells.
  template <class IsOff>
  bool add_off(const std::vector<Vector3<Dyadic>>& directions, const IsOff& is_off) {
    for (const Vector3<Dyadic>& d : directions) {
      if (is_zero(d)) continue;
      for (const Vector3<Dyadic>& way : {d, Vector3<Dyadic>{-d.x, -d.y, -d.z}}) {
        exact_ += 2;
        const std::uint32_t corner = add(furthest(WorldDirection(way), corners_[0]));
        if (is_off(polytope_.exact(corner) - polytope_.exact(0))) return true;
        remove_last();
      }
    }
    return false;
  }

  // Four corners that are not of one plane; or, where there are none, a direction perpendicular to all of D.
  std::optional<Vector3<Dyadic>> begin() {
    const Dyadic zero, one(1.0);
    const std::vector<Vector3<Dyadic>> axes{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    add({0, 0});
    if (!add_off(axes, [](const Vector3<Dyadic>& way) { return !is_zero(way); })) return axes[0];
    const Vector3<Dyadic> first = polytope_.exact(1) - polytope_.exact(0);
    std::vector<Vector3<Dyadic>> across;
    for (const Vector3<Dyadic>& axis : axes) across.push_back(cross(first, axis));
    if (!add_off(across, [&](const Vector3<Dyadic>& way) { return !is_zero(cross(first, way)); })) {
      return is_zero(across[0]) ? across[1] : across[0];
    }
    Vector3<Dyadic> normal = cross(first, polytope_.exact(2) - polytope_.exact(0));
    if (!add_off({normal}, [&](const Vector3<Dyadic>& way) { return dot(normal, way).sign() != Sign::zero; })) {
      return normal;
    }
    polytope_.begin({0, 1, 2, 3});
    return std::nullopt;
  }

  // A new corner beyond the facet: the furthest along its normal as doubles have it, or else exactly. Nothing where
  // there is none; then normal_ is its normal.
  std::optional<std::uint32_t> beyond(std::uint32_t facet) {
    const ExpandingPolytope::Facet& of = polytope_.facets()[facet];
    const Corner from = corners_[of.corner[0]];
    Point3 rounded{of.normal.x.value.high, of.normal.y.value.high, of.normal.z.value.high};
    if (make_tame(rounded)) {
      const std::uint32_t corner = add(furthest(WorldDirection(rounded), from));
      if (polytope_.side(facet, corner) == Sign::positive) return corner;
      remove_last();
    }
    ++exact_;
    const WorldDirection normal(polytope_.exact_normal(facet));
    const Corner corner = furthest(normal, from);
    if (corner != from) return add(corner);
    normal_ = normal;
    return std::nullopt;
  }

  void grow() {
    const std::uint64_t pairs = std::uint64_t{a_.graph.vertices.size()} * b_.graph.vertices.size();
    const bool has_end = pairs > PolyhedronDepth::all_are_exact;
    std::optional<ExpandingPolytope::Square> best;  // of the facets of D seen
    std::uint32_t best_facet = 0;
    double best_high = unlimited;
    while (const std::optional<std::uint32_t> facet = polytope_.nearest()) {
      const Interval height = polytope_.facets()[*facet].height;
      if (best && height.low > best_high) break;
      if (best && !polytope_.square(*facet).is_less_than(*best)) {
        polytope_.close(*facet);
        continue;
      }
      if (has_end && polytope_.corner_count() >= PolyhedronDepth::most_corners) {
        return end_within(height.low, best);
      }
      ++found_.answer.cost.iterations;
      if (const std::optional<std::uint32_t> corner = beyond(*facet)) {
        polytope_.expand(*facet, *corner);
        continue;
      }
      polytope_.close(*facet);
      best = polytope_.square(*facet);
      best_facet = *facet;
      best_high = height.high;
      found_.direction = normal_;
    }
    SUNDER_REQUIRE(best.has_value());
    found_.depth = root(best->numerator, best->denominator);
    found_.squared = {best->numerator, best->denominator};
    tell_features(best_facet);
    tell_surface();
  }

  // The polytope has grown enough: its nearest facet is so far, and D has no boundary nearer; but it has along the
  // nearest facet of it.
  void end_within(double low, const std::optional<ExpandingPolytope::Square>& best) {
    found_.is_exact = false;
    found_.depth = {std::max(low, 0.0), unlimited};
    if (best) found_.depth.high = root(best->numerator, best->denominator).high;
    // The nearest facets' directions are nearest, too: the best of some of them.
    std::vector<std::uint32_t> alive;
    const auto facets = polytope_.facets();
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      if (facets[f].is_alive) alive.push_back(f);
    }
    const std::size_t count = std::min<std::size_t>(alive.size(), 64);
    std::partial_sort(alive.begin(), alive.begin() + static_cast<std::ptrdiff_t>(count), alive.end(),
                      [&](std::uint32_t x, std::uint32_t y) { return facets[x].height.low < facets[y].height.low; });
    for (std::size_t k = 0; k < count; ++k) {
      const Vector3<Dyadic> normal = polytope_.exact_normal(alive[k]);
      const WorldDirection direction(normal);
      const auto [v, w] = furthest(direction, corners_[facets[alive[k]].corner[0]]);
      const Dyadic along = dot(normal, coordinates<Dyadic>(a_[v]) - coordinates<Dyadic>(b_[w]));
      exact_ += 2;
      const double high = root(along * along, dot(normal, normal)).high;
      if (found_.direction && high >= found_.depth.high) continue;
      found_.depth.high = high;
      found_.direction = direction;
    }
    tell_surface();
  }

  void tell_features(std::uint32_t facet) {
    const auto add_to = [](std::vector<std::uint32_t>& list, std::uint32_t v) {
      if (std::find(list.begin(), list.end(), v) == list.end()) list.push_back(v);
    };
    for (const std::uint32_t corner : polytope_.facets()[facet].corner) {
      add_to(found_.features.of_a, corners_[corner][0]);
      add_to(found_.features.of_b, corners_[corner][1]);
    }
  }

  void tell_surface() {
    if (!(found_.depth.low > 0)) return;
    DepthSurface surface;
    std::vector<std::uint32_t> number(corners_.size(), no_entry);
    for (const ExpandingPolytope::Facet& facet : polytope_.facets()) {
      if (!facet.is_alive) continue;
      std::array<std::uint32_t, 3>& triangle = surface.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t& n = number[facet.corner[k]];
        if (n == no_entry) {
          n = static_cast<std::uint32_t>(surface.corners.size());
          surface.corners.push_back(corners_[facet.corner[k]]);
        }
        triangle[k] = n;
      }
    }
    found_.surface = std::make_shared<const DepthSurface>(std::move(surface));
  }

  const Placed& a_;
  const Placed& b_;
  PolyhedronDepth& found_;
  ExpandingPolytope polytope_;
  std::vector<Corner> corners_;
  std::optional<WorldDirection> normal_;
  StageTally tally_;
  std::uint32_t exact_ = 0;
};

}  // namespace

PolyhedronDepth polyhedron_polyhedron_depth(const ConvexPolyhedron& body_a, const Pose& pose_a,
                                            const ConvexPolyhedron& body_b, const Pose& pose_b) {
  PolyhedronDepth found{polyhedron_polyhedron(body_a, pose_a, body_b, pose_b)};
  if (!found.meet()) return found;
  const bool is_finished = found.answer.decided_by == DecidedBy::finishing;
  const std::uint32_t before = found.answer.cost.exact;
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  DepthSearch search(a, b, found);
  search.run();
  conclude(found.answer, before + search.exact_signs(), is_finished);
  return found;
}

std::optional<Sign> compare_depth(const PolyhedronDepth& depth, double than) {
  SUNDER_REQUIRE(depth.meet() && std::isfinite(than) && than >= 0);
  if (than < depth.depth.low) return Sign::positive;
  if (than > depth.depth.high) return Sign::negative;
  if (!depth.is_exact) return std::nullopt;
  const Dyadic exact(than);
  return (depth.squared[0] - exact * exact * depth.squared[1]).sign();
}

void add_depth(ClaimsWriter& file, std::uint32_t index_a, std::uint32_t index_b, const PolyhedronDepth& depth) {
  if (!depth.meet()) return;
  const auto [low, high] = depth.depth;
  if (std::isfinite(high)) {
    const Vector3<Dyadic> d = depth.direction->exact();
    add_depth_at_most(file, index_a, index_b, high, std::array{d.x, d.y, d.z});
  }
  if (low > 0) add_depth_at_least(file, index_a, index_b, low, *depth.surface);
}

}  // namespace sunder::solid
