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
#include <variant>

namespace sunder::solid {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

class DepthSearch {
 public:
  DepthSearch(const Placed& a, const Placed& b, Cost& cost)
      : a_(a), b_(b), cost_(cost), polytope_([this](std::uint32_t corner) {
          const auto [v, w] = corners_[corner];
          return coordinates<Dyadic>(a_[v]) - coordinates<Dyadic>(b_[w]);
        }) {}

  // How deep bodies are that have a point of these in common.
  PolyhedraOverlap run(const CommonVertices& common) {
    const std::optional<Vector3<Dyadic>> normal = begin();
    PolyhedraOverlap found =
        normal ? PolyhedraOverlap{{{0, 0}, WorldDirection(*normal), {}}, common, PolyhedraOverlap::Exact{}}
               : grow(common);
    exact_ += polytope_.exact_signs();
    return found;
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
    return {extreme_vertex_from(a_, along_a, End::greatest, from[0], cost_, tally_),
            extreme_vertex_from(b_, along_b, End::least, from[1], cost_, tally_)};
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

  PolyhedraOverlap grow(const CommonVertices& common) {
    const std::uint64_t pairs = std::uint64_t{a_.graph.vertices.size()} * b_.graph.vertices.size();
    const bool has_end = pairs > PolyhedraOverlap::all_are_exact;
    std::optional<ExactFraction> best;  // of the facets of D seen
    std::optional<WorldDirection> best_direction;
    std::uint32_t best_facet = 0;
    double best_high = unlimited;
    while (const std::optional<std::uint32_t> facet = polytope_.nearest()) {
      const Interval height = polytope_.facets()[*facet].height;
      if (best && height.low > best_high) break;
      if (best && polytope_.square(*facet) >= *best) {
        polytope_.close(*facet);
        continue;
      }
      if (has_end && polytope_.corner_count() >= PolyhedraOverlap::most_corners) {
        return grown_within(height.low, best, std::move(best_direction), common);
      }
      ++cost_.iterations;
      if (const std::optional<std::uint32_t> corner = beyond(*facet)) {
        polytope_.expand(*facet, *corner);
        continue;
      }
      polytope_.close(*facet);
      best = polytope_.square(*facet);
      best_facet = *facet;
      best_high = height.high;
      best_direction = normal_;
    }
    SUNDER_REQUIRE(best.has_value());
    const Interval depth = root(*best);
    return {{depth, *std::move(best_direction), proof_of_low(depth)},
            common,
            PolyhedraOverlap::Exact{*std::move(best), features_of(best_facet)}};
  }

  // The polytope has grown enough: its nearest facet is so far, and D has no boundary nearer; but it has along the
  // nearest facet of it.
  PolyhedraOverlap grown_within(double low, const std::optional<ExactFraction>& best,
                                std::optional<WorldDirection> direction, const CommonVertices& common) {
    Interval depth{std::max(low, 0.0), unlimited};
    if (best) depth.high = root(*best).high;
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
      const WorldDirection along_normal(normal);
      const auto [v, w] = furthest(along_normal, corners_[facets[alive[k]].corner[0]]);
      const Dyadic along = dot(normal, coordinates<Dyadic>(a_[v]) - coordinates<Dyadic>(b_[w]));
      exact_ += 2;
      const double high = root({along * along, dot(normal, normal)}).high;
      if (direction && high >= depth.high) continue;
      depth.high = high;
      direction = along_normal;
    }
    return {{depth, *std::move(direction), proof_of_low(depth)}, common, std::nullopt};
  }

  DepthFeatures features_of(std::uint32_t facet) const {
    DepthFeatures features;
    const auto add_to = [](std::vector<std::uint32_t>& list, std::uint32_t v) {
      if (std::find(list.begin(), list.end(), v) == list.end()) list.push_back(v);
    };
    for (const std::uint32_t corner : polytope_.facets()[facet].corner) {
      add_to(features.of_a, corners_[corner][0]);
      add_to(features.of_b, corners_[corner][1]);
    }
    return features;
  }

  // The polytope as it is, around the origin.
  DepthProof proof_of_low(const Interval& depth) const {
    if (!(depth.low > 0)) return {};
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
    return surface;
  }

  const Placed& a_;
  const Placed& b_;
  Cost& cost_;
  ExpandingPolytope polytope_;
  std::vector<Corner> corners_;
  std::optional<WorldDirection> normal_;
  StageTally tally_;
  std::uint32_t exact_ = 0;
};

}  // namespace

PolyhedronDepth polyhedron_polyhedron_depth(const ConvexPolyhedron& body_a, const Pose& pose_a,
                                            const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const PairAnswer answer = polyhedron_polyhedron(body_a, pose_a, body_b, pose_b);
  PolyhedronDepth found{{}, answer.decided_by, answer.cost};
  if (const auto* apart = std::get_if<Separation>(&answer.evidence)) {
    found.evidence = *apart;
    return found;
  }
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  DepthSearch search(a, b, found.cost);
  found.evidence = search.run(std::get<CommonVertices>(answer.evidence));
  conclude(found, answer.cost.exact + search.exact_signs(), answer.decided_by == DecidedBy::finishing);
  return found;
}

std::optional<Sign> compare_depth(const PolyhedraOverlap& overlap, double than) {
  SUNDER_REQUIRE(std::isfinite(than) && than >= 0);
  if (than < overlap.depth.low) return Sign::positive;
  if (than > overlap.depth.high) return Sign::negative;
  if (!overlap.exact) return std::nullopt;
  return compare_root(overlap.exact->squared, than);
}

}  // namespace sunder::solid
