#include <sunder/solid/mesh/mesh_distance.h>

#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/number/root.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/exact/exact_gjk.h>
#include <sunder/solid/mesh/near_walk.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace sunder::solid {

namespace {

// Two triangles that are apart, in exact numbers: by the search of exact_gjk.h, whose support this is.
class ExactTriangles {
 public:
  ExactTriangles(const PosedTriangle& t, const PosedTriangle& u) : t_(t), u_(u) {
    for (std::size_t k = 0; k < 3; ++k) {
      a_[k] = coordinates<Dyadic>(t[k]);
      b_[k] = coordinates<Dyadic>(u[k]);
    }
  }

  ClosestWay<Dyadic> nearest(const FeatureVertices& from, Cost& cost) {
    ExactNearest search;
    for (std::size_t k = 0; k < from.count_a; ++k) search.a.add(from.of_a(k), a_[from.of_a(k)]);
    for (std::size_t k = 0; k < from.count_b; ++k) search.b.add(from.of_b(k), b_[from.of_b(k)]);
    std::uint32_t ways = 0;
    [[maybe_unused]] const bool are_apart = exact_gjk(*this, search, ways);
    SUNDER_REQUIRE(are_apart);
    cost.exact += ways;
    ++cost.iterations;
    return search.closest;
  }

  std::array<std::uint32_t, 2> extreme(const ExactNearest& search) const {
    const WorldDirection along(search.closest.way.way);
    return {furthest(t_, along, search.of_a(), Sign::positive), furthest(u_, along, search.of_b(), Sign::negative)};
  }
  void join(ExactNearest& search, const std::array<std::uint32_t, 2>& next) const {
    if (!search.a.has(next[0])) search.a.add(next[0], a_[next[0]]);
    if (!search.b.has(next[1])) search.b.add(next[1], b_[next[1]]);
  }

 private:
  static std::uint32_t furthest(const PosedTriangle& corners, const WorldDirection& along, std::uint32_t from,
                                Sign beyond) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (compare_along(along, corners[from], corners[k]) == beyond) from = k;
    }
    return from;
  }

  PosedTriangle t_, u_;
  std::array<Vector3<Dyadic>, 3> a_, b_;  // their corners
};

class Search {
 public:
  Search(const PlacedMesh& a, const PlacedMesh& b, Cost& cost) : a_(a), b_(b), cost_(cost) {}

  // The nearest two triangles. First about how near they are; then, in floating point, those that may be it; of these the
  // nearest.
  NearTriangles nearest() {
    NearWalk walk(a_, b_, cost_);
    double limit = NearWalk::unbounded;
    std::array<Candidate, 64> candidates;
    std::size_t count = 0;
    bool are_all = true;  // in `candidates`
    const auto lower = [&](std::uint32_t, std::uint32_t, const TriangleGap& gap) {
      if (gap.distance.high < limit) {
        limit = gap.distance.high;
        walk.look_along(gap.way);
      }
      return false;
    };
    const auto keep = [&](std::uint32_t t, std::uint32_t u, const TriangleGap& gap) {
      lower(t, u, gap);
      if (count == candidates.size()) {
        count = static_cast<std::size_t>(std::remove_if(candidates.begin(), candidates.end(),
                                                        [&](const Candidate& c) { return c.distance.low > limit; }) -
                                         candidates.begin());
      }
      are_all = are_all && count < candidates.size();
      if (are_all) candidates[count++] = {t, u, gap.distance, gap.features};
      return false;
    };
    double before = 0;
    do {
      before = limit;
      walk.dive(limit, lower);
    } while (limit < before);
    walk.nearest_first(limit, keep);
    if (are_all) {
      if (const auto sure = surely_nearest(std::span(candidates).first(count))) return *sure;
      for (const auto& [t, u, distance, features] : std::span(candidates).first(count)) {
        if (distance.low <= limit) look_at(t, u, features);
      }
    } else {
      walk.any(limit, [&](std::uint32_t t, std::uint32_t u, const TriangleGap& gap) {
        look_at(t, u, gap.features);
        return false;
      });
    }
    return result();
  }

  NearTriangles nearest_by_scan() {
    for (std::uint32_t t = 0; t < a_.mesh().triangles().size(); ++t) {
      for (std::uint32_t u = 0; u < b_.mesh().triangles().size(); ++u) {
        may_be_interrupted(1);
        ++cost_.probes;
        take_if_nearer(t, u, ExactTriangles(a_.triangle(t), b_.triangle(u)).nearest({1, 1, {0, 0}}, cost_));
      }
    }
    return result();
  }

  // Are two triangles closer than that?
  bool any_closer(double least) {
    NearWalk walk(a_, b_, cost_);
    double limit = least;
    return walk.any(limit, [&](std::uint32_t t, std::uint32_t u, const TriangleGap& gap) {
      if (gap.distance.low >= least) return false;
      if (gap.distance.high < least) return true;
      const ClosestWay<Dyadic> closest = ExactTriangles(a_.triangle(t), b_.triangle(u)).nearest(gap.features, cost_);
      return compare_root(square_of(closest.way), least) == Sign::negative;
    });
  }

 private:
  struct Candidate {
    std::uint32_t t = 0, u = 0;
    Interval distance{};
    FeatureVertices features;
  };

  // The one that seems to be the nearest, if intervals tell that its features hold the nearest points of all of them.
  std::optional<NearTriangles> surely_nearest(std::span<const Candidate> candidates) const {
    const Candidate& best = *std::min_element(candidates.begin(), candidates.end(), [](const auto& c, const auto& d) {
      return c.distance.high < d.distance.high;
    });
    const FeatureVertices named = named_by_points(best.t, best.u, best.features);
    const std::span<const std::uint32_t> all(named.vertices), of_a = all.first(named.count_a),
                                                              of_b = all.subspan(named.count_a, named.count_b);
    std::array<Posed3, 4> at{};
    for (std::size_t k = 0; k < of_a.size(); ++k) at[k] = a_.at(of_a[k]);
    for (std::size_t k = 0; k < of_b.size(); ++k) at[of_a.size() + k] = b_.at(of_b[k]);
    const std::span<const Posed3> posed(at);
    const EnclosedWay way = enclosed_way(posed.first(of_a.size()), posed.subspan(of_a.size(), of_b.size()));
    if (way.weights != Guess::positive) return std::nullopt;
    const EnclosedAlong along_a(way.way, a_.pose().affine()), along_b(way.way, b_.pose().affine());
    const auto is_one_of = [](std::span<const std::uint32_t> features, std::uint32_t point) {
      return std::find(features.begin(), features.end(), point) != features.end();
    };
    for (const Candidate& c : candidates) {
      if (c.distance.low > best.distance.high) continue;
      for (const std::uint32_t point : a_.mesh().triangles()[c.t]) {
        if (!is_one_of(of_a, point) && !along_a.surely_less_far(at[0].point, a_.at(point).point)) return std::nullopt;
      }
      for (const std::uint32_t point : b_.mesh().triangles()[c.u]) {
        if (!is_one_of(of_b, point) && !along_b.surely_further(posed[of_a.size()].point, b_.at(point).point)) {
          return std::nullopt;
        }
      }
    }
    return NearTriangles{best.t, best.u,
                         ClosestFeatures(a_.mesh().points(), a_.pose(), b_.mesh().points(), b_.pose(), named)};
  }

  static ExactFraction square_of(const ShortestWay<Dyadic>& way) { return {way.squared(), way.denominator}; }

  // Are they nearer than what was found before? What of them is furthest along its way, and least far, tells it for
  // nearly all.
  void look_at(std::uint32_t t, std::uint32_t u, const FeatureVertices& from) {
    if (found_ && is_beyond(t, u)) return;
    take_if_nearer(t, u, ExactTriangles(a_.triangle(t), b_.triangle(u)).nearest(from, cost_));
  }

  bool is_beyond(std::uint32_t t, std::uint32_t u) const {
    const auto is_before = [&](const Posed3& p, const Posed3& q) {
      return compare_along(*direction_, p, q) != Sign::negative;
    };
    const Posed3 last = a_.triangle(of_a_)[found_->features.of_a(0)],
                 first = b_.triangle(of_b_)[found_->features.of_b(0)];
    const PosedTriangle of_a = a_.triangle(t), of_b = b_.triangle(u);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_before(of_a[k], last) || !is_before(first, of_b[k])) return false;
    }
    return true;
  }

  void take_if_nearer(std::uint32_t t, std::uint32_t u, ClosestWay<Dyadic> closest) {
    if (found_ && !closest_features_detail::is_shorter(closest.way, found_->way)) return;
    found_ = std::move(closest);
    of_a_ = t;
    of_b_ = u;
    direction_.emplace(found_->way.way);
  }

  FeatureVertices named_by_points(std::uint32_t t, std::uint32_t u, FeatureVertices named) const {
    const std::size_t count = std::size_t{named.count_a} + named.count_b;
    for (std::size_t k = 0; k < count; ++k) {
      const bool is_a = k < named.count_a;
      named.vertices[k] = (is_a ? a_ : b_).mesh().triangles()[is_a ? t : u][named.vertices[k]];
    }
    return named;
  }

  NearTriangles result() const {
    return {of_a_, of_b_,
            ClosestFeatures(a_.mesh().points(), a_.pose(), b_.mesh().points(), b_.pose(),
                            named_by_points(of_a_, of_b_, found_->features))};
  }

  const PlacedMesh &a_, &b_;
  Cost& cost_;
  std::optional<ClosestWay<Dyadic>> found_;  // features: corners of these triangles
  std::optional<WorldDirection> direction_;
  std::uint32_t of_a_ = 0, of_b_ = 0;
};

// `met`: whether they meet; where they do not, the search finds the rest.
MeshDistance distance_by(NearTriangles (Search::*search)(), const MeshAnswer& met, const Mesh& a, const Pose& pose_a,
                         const Mesh& b, const Pose& pose_b) {
  MeshDistance answer;
  answer.cost = met.cost;
  if (const auto* triangles = std::get_if<MeetingTriangles>(&met.evidence)) {
    answer.evidence = *triangles;
  } else if (const auto* within = std::get_if<PointWithin>(&met.evidence)) {
    answer.evidence = *within;
  } else {
    const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
    answer.evidence = (Search(placed_a, placed_b, answer.cost).*search)();
  }
  conclude(answer, answer.cost.exact);
  return answer;
}

}  // namespace

MeshDistance mesh_distance(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  return distance_by(&Search::nearest, mesh_mesh(a, pose_a, b, pose_b), a, pose_a, b, pose_b);
}

MeshDistance mesh_distance_by_scan(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  MeshDistance answer =
      distance_by(&Search::nearest_by_scan, mesh_mesh_by_scan(a, pose_a, b, pose_b), a, pose_a, b, pose_b);
  answer.decided_by = DecidedBy::scan;
  return answer;
}

Sign compare_distance(const MeshDistance& distance, double radius) {
  SUNDER_REQUIRE(std::isfinite(radius) && radius >= 0);
  const NearTriangles* nearest = nearest_of(distance);
  if (nearest == nullptr) return radius > 0 ? Sign::negative : Sign::zero;
  return compare_distance(nearest->closest, radius);
}

bool are_meshes_closer(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b, double least, Cost* cost) {
  SUNDER_REQUIRE(least > 0 && std::isfinite(least));
  const MeshAnswer met = mesh_mesh(a, pose_a, b, pose_b);
  Cost sum = met.cost;
  const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
  const bool is_closer = met.meet() || Search(placed_a, placed_b, sum).any_closer(least);
  if (cost != nullptr) *cost = sum;
  return is_closer;
}

}  // namespace sunder::solid

namespace sunder {

solid::MeshDistance distance(const solid::Mesh& a, const solid::Pose& pose_a, const solid::Mesh& b,
                             const solid::Pose& pose_b) {
  solid::require_can_be_placed(a, pose_a);
  solid::require_can_be_placed(b, pose_b);
  return solid::mesh_distance(a, pose_a, b, pose_b);
}

}  // namespace sunder
