#include <sunder/base/interruption.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/hull/full_hull.h>
#include <sunder/polytope/hull/quickhull.h>
#include <sunder/polytope/represent/far_apart.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace sunder::polytope {

namespace {

using Indices = std::vector<std::uint32_t>;

// As far_apart.h says, of some of the points.
Indices far_apart_of(const PlanePoints& points, const Indices& among) {
  std::vector<double> rounded;
  for (const std::uint32_t p : among) {
    rounded.insert(rounded.end(), points.rounded(p), points.rounded(p) + points.dimension());
  }
  Indices result = far_apart(points.dimension(), std::move(rounded), std::nullopt, 0);
  for (std::uint32_t& k : result) k = among[k];
  return result;
}

bool span_space(const PlanePoints& points, const Indices& some) {
  const std::size_t k = points.dimension();
  if (some.size() != k + 1) return false;
  SimplexCorners corners{};
  std::copy_n(some.begin(), k, corners.begin());
  const Guess guess = points.closer_side(corners, some[k]);
  const Sign sign = is_sure(guess) ? to_sign(guess) : points.exact_side(points.exact_plane(corners), some[k]);
  return sign != Sign::zero;
}

// Simplices that lie in one plane are one face.
class Faces {
 public:
  Faces(const PlanePoints& points, std::vector<BoundarySimplex> boundary)
      : points_(points), k_(points.dimension()), boundary_(std::move(boundary)), face_of_(boundary_.size()) {
    std::iota(face_of_.begin(), face_of_.end(), 0u);
    for (std::uint32_t s = 0; s < boundary_.size(); ++s) {
      may_be_interrupted(20);
      const RoundedPlane plane = points_.rounded_plane(boundary_[s].corners);
      std::optional<std::vector<Dyadic>> exact;
      for (std::size_t i = 0; i < k_; ++i) {
        const std::uint32_t other = boundary_[s].across[i];
        if (s < other && holds(plane, exact, s, opposite(other, s))) join(s, other);
      }
    }
    simplices_of_.resize(boundary_.size());
    for (std::uint32_t s = 0; s < boundary_.size(); ++s) simplices_of_[find(s)].push_back(s);
    corners_.resize(boundary_.size());
    for (std::uint32_t f = 0; f < boundary_.size(); ++f) {
      for (const std::uint32_t s : simplices_of_[f]) {
        const auto begin = boundary_[s].corners.begin();
        corners_[f].insert(corners_[f].end(), begin, begin + static_cast<std::ptrdiff_t>(k_));
      }
      std::sort(corners_[f].begin(), corners_[f].end());
      corners_[f].erase(std::unique(corners_[f].begin(), corners_[f].end()), corners_[f].end());
    }
  }

  // The corners, ascending; all of them where `are_vertices` comes out true. The faces at a vertex have no other corner
  // in common: all of them that hold one that is between others hold these. A corner of simplices only is a vertex.
  Indices vertices(bool& are_vertices) const {
    std::vector<Indices> faces_at(points_.size());
    for (std::uint32_t f = 0; f < corners_.size(); ++f) {
      for (const std::uint32_t v : corners_[f]) faces_at[v].push_back(f);
    }
    Indices result;
    are_vertices = true;
    for (std::uint32_t v = 0; v < faces_at.size(); ++v) {
      Indices& faces = faces_at[v];
      if (faces.empty()) continue;
      const bool are_simplices =
          std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return corners_[f].size() == k_; });
      if (are_simplices || is_alone(v, faces)) {
        result.push_back(v);
      } else {
        are_vertices = false;
      }
    }
    return result;
  }

  void write(ConvexHull& hull) const {
    Indices order;
    for (std::uint32_t f = 0; f < corners_.size(); ++f) {
      if (!corners_[f].empty()) order.push_back(f);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) { return corners_[f] < corners_[g]; });
    for (const std::uint32_t f : order) {
      hull.facet_corners.insert(hull.facet_corners.end(), corners_[f].begin(), corners_[f].end());
      hull.facet_begin.push_back(hull.facet_corners.size());
      for (const std::uint32_t s : simplices_of_[f]) {
        const auto begin = boundary_[s].corners.begin();
        hull.simplex_corners.insert(hull.simplex_corners.end(), begin, begin + static_cast<std::ptrdiff_t>(k_));
      }
      hull.simplex_begin.push_back(hull.simplex_begin.back() + simplices_of_[f].size());
    }
  }

 private:
  // The corner of simplex s that simplex `other` has not.
  std::uint32_t opposite(std::uint32_t s, std::uint32_t other) const {
    std::size_t i = 0;
    while (boundary_[s].across[i] != other) ++i;
    return boundary_[s].corners[i];
  }

  bool holds(const RoundedPlane& plane, std::optional<std::vector<Dyadic>>& exact, std::uint32_t s,
             std::uint32_t k) const {
    Guess guess = points_.rounded_side(plane, k);
    if (!is_sure(guess)) guess = points_.closer_side(boundary_[s].corners, k);
    if (is_sure(guess)) return guess == Guess::zero;
    if (!exact) exact = points_.exact_plane(boundary_[s].corners);
    return points_.exact_side(*exact, k) == Sign::zero;
  }

  std::uint32_t find(std::uint32_t s) {
    while (face_of_[s] != s) s = face_of_[s] = face_of_[face_of_[s]];
    return s;
  }

  void join(std::uint32_t s, std::uint32_t t) { face_of_[find(t)] = find(s); }

  bool is_alone(std::uint32_t v, const Indices& faces) const {
    const auto least = *std::min_element(faces.begin(), faces.end(), [&](std::uint32_t f, std::uint32_t g) {
      return corners_[f].size() < corners_[g].size();
    });
    return std::none_of(corners_[least].begin(), corners_[least].end(), [&](std::uint32_t w) {
      return w != v && std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
               return std::binary_search(corners_[f].begin(), corners_[f].end(), w);
             });
    });
  }

  const PlanePoints& points_;
  std::size_t k_;
  std::vector<BoundarySimplex> boundary_;
  Indices face_of_;                    // of a simplex another one of its face, or itself
  std::vector<Indices> simplices_of_;  // of each face, which has the number of one of its simplices
  std::vector<Indices> corners_;       // ascending
};

}  // namespace

Indices spanning(const PlanePoints& points, const Indices& among) {
  Elimination rows(points.dimension() + 1);
  Indices result;
  for (const std::uint32_t k : among) {
    if (rows.add(points.row(k))) result.push_back(k);
    if (result.size() == points.dimension() + 1) break;
  }
  return result;
}

bool hull_of_full(const PlanePoints& points, Indices all, std::uint64_t most, ConvexHull& hull, Degenerate degenerate) {
  QuickhullCost cost;
  cost.gives_up = degenerate == Degenerate::gives_up;
  bool are_vertices = false;
  while (!are_vertices) {  // twice at most: then all corners are vertices
    Indices first = far_apart_of(points, all);
    if (!span_space(points, first)) first = spanning(points, all);
    std::vector<BoundarySimplex> boundary = quickhull(points, all, first, most, cost);
    if (boundary.empty()) return false;
    const Faces faces(points, std::move(boundary));
    hull.vertices = faces.vertices(are_vertices);
    if (are_vertices) faces.write(hull);
    all = hull.vertices;
  }
  hull.side_tests = cost.side_tests;
  hull.exact_tests = cost.exact_tests;
  return true;
}

}  // namespace sunder::polytope
