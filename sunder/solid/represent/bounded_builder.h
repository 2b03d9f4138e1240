// How bounded hierarchies are made, of whatever has vertices that are exactly in convex position: see
// bounded_hierarchy.h.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/number/double_double.h>
#include <sunder/number/estimate.h>
#include <sunder/predicate/point/exact_orient.h>
#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/hierarchy_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid::hierarchy_detail {

// Times the denominators of both points, which are positive.
inline Vector3<Dyadic> direction_between(const ExactPoint3& from, const ExactPoint3& to) {
  const auto axis = [&](const Dyadic& t, const Dyadic& f) { return t * from.denominator - f * to.denominator; };
  return {axis(to.x, from.x), axis(to.y, from.y), axis(to.z, from.z)};
}

// The point in which the line from w to u crosses the plane of the cut. With w = W / a, u - w = D / (a b) and
// C = direction . D, that is w + 2^exponent D / C.
inline ExactPoint3 cut_point(const BoundedHierarchy::Cut& cut, const ExactPoint3& w, const ExactPoint3& u) {
  const Vector3<Dyadic> d = direction_between(w, u);
  const Dyadic c = dot(cut.direction, d);
  const auto axis = [&](const Dyadic& at, const Dyadic& along) {
    return at * c + (w.denominator * along).scaled(cut.exponent);
  };
  return {axis(w.x, d.x), axis(w.y, d.y), axis(w.z, d.z), w.denominator * c};
}

// About the nearest doubles, and what that leaves: together to about 100 bits.
inline std::array<Point3, 2> rounded_and_rest(const ExactPoint3& p, const EstimatedPoint3& estimate) {
  const Vector3<Estimate>& x = estimate.numerators;
  const Estimate& w = estimate.denominator;
  const std::array<DoubleDouble, 3> q{x.x.value / w.value, x.y.value / w.value, x.z.value / w.value};
  const bool is_ordinary = std::isfinite(q[0].high) && std::isfinite(q[1].high) && std::isfinite(q[2].high);
  if (!is_ordinary) return {nearest(p), Point3{}};  // beyond the range of doubles on the way
  return {{{q[0].high, q[1].high, q[2].high}, {q[0].low, q[1].low, q[2].low}}};
}

// What a hierarchy is made of, and after it the cut points, as the surface asks about them. Base: size(); rounded(v), a
// Point3; exact(v), an ExactPoint3, and estimated(v); orient(a, b, c, d), exactly; and what nodes hold of v, at(v), and
// of cut points, at(p, estimated(p)), of an exact point: two Point3, doubles and the rest.
template <class Base>
class BoundedVertices {
 public:
  struct Of {
    std::uint32_t parent, toward, cut, generation;
    double share;
    Point3 rounded, at, rest;
    EstimatedPoint3 estimated;
  };

  BoundedVertices(const Base& base, const std::vector<BoundedHierarchy::Cut>& cuts) : base_(base), cuts_(cuts) {}

  std::uint32_t size() const { return base_.size() + static_cast<std::uint32_t>(of_.size()); }
  bool is_cut_point(std::uint32_t v) const { return v >= base_.size(); }
  const Of& of(std::uint32_t v) const { return of_[v - base_.size()]; }
  std::uint32_t generation(std::uint32_t v) const { return is_cut_point(v) ? of(v).generation : 0; }
  Point3 at(std::uint32_t v) const { return is_cut_point(v) ? of(v).at : base_.at(v); }
  Point3 rounded(std::uint32_t v) const { return is_cut_point(v) ? of(v).rounded : base_.rounded(v); }

  void add(std::uint32_t parent, std::uint32_t toward, std::uint32_t cut) {
    const ExactPoint3 w = exact(parent), u = exact(toward), p = cut_point(cuts_[cut], w, u);
    const EstimatedPoint3 estimate = estimated(p);
    const auto [at, rest] = base_.at(p, estimate);
    // The height of the plane over w in that of u.
    const Dyadic height = (w.denominator * u.denominator).scaled(cuts_[cut].exponent);
    const double share = nearest_ratio(height, dot(cuts_[cut].direction, direction_between(w, u)));
    const std::uint32_t generation_of_it = 1 + std::max(generation(parent), generation(toward));
    of_.push_back({parent, toward, cut, generation_of_it, share, rounded_and_rest(p, estimate)[0], at, rest, estimate});
  }

  ExactPoint3 exact(std::uint32_t v) const {
    if (!is_cut_point(v)) return base_.exact(v);
    const Of& o = of(v);
    return cut_point(cuts_[o.cut], exact(o.parent), exact(o.toward));
  }

  // The end of the line from w through v, a neighbour: v, or if that was cut from the line's other end, this.
  std::uint32_t line_end(std::uint32_t w, std::uint32_t v) const {
    return is_cut_point(v) && of(v).toward == w ? of(v).parent : v;
  }

  Sign orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const std::array<std::uint32_t, 4> all{a, b, c, d};
    if (std::none_of(all.begin(), all.end(), [&](std::uint32_t v) { return is_cut_point(v); })) {
      return base_.orient(a, b, c, d);
    }
    const auto is_of_plane_of_a = [&](std::uint32_t v) { return is_cut_point(v) && of(v).cut == of(a).cut; };
    if (is_cut_point(a) && std::all_of(all.begin(), all.end(), is_of_plane_of_a)) return Sign::zero;
    const Guess guess = guess_orient_3d(estimate(a), estimate(b), estimate(c), estimate(d));
    if (is_sure(guess)) return to_sign(guess);
    return orient_3d(exact(a), exact(b), exact(c), exact(d));
  }

 private:
  EstimatedPoint3 estimate(std::uint32_t v) const { return is_cut_point(v) ? of(v).estimated : base_.estimated(v); }

  const Base& base_;
  const std::vector<BoundedHierarchy::Cut>& cuts_;
  std::vector<Of> of_;
};

template <class Base>
class BoundedBuilder {
 public:
  using Limits = BoundedHierarchy::Limits;

  using Surfaces = std::vector<BoundedHierarchy::Surface>;

  // Facets as ConvexPolyhedron has them.
  BoundedBuilder(const Base& base, std::span<const std::uint32_t> facet_begin,
                 std::span<const std::uint32_t> facet_vertices, const Limits& limits, Surfaces* surfaces)
      : base_(base),
        surfaces_(surfaces),
        limits_(limits),
        vertices_(base, cuts_),
        surface_(vertices_, vertices_.size(), facet_begin, facet_vertices),
        here_(vertices_.size()),
        stretch_{stretch_along(&Point3::x), stretch_along(&Point3::y), stretch_along(&Point3::z)} {
    std::iota(here_.begin(), here_.end(), 0u);
  }

  BoundedHierarchy run() {
    while (here_.size() > 4) {
      const std::uint32_t degree = begin_level();
      if (degree <= limits_.most_kept || !cut_off_large()) take_independent();
    }
    begin_level();
    return history();
  }

 private:
  // Returns the greatest degree.
  std::uint32_t begin_level() {
    std::uint32_t degree = 0;
    for (const std::uint32_t v : here_) degree = std::max(degree, surface_.degree(v));
    taken_before_.push_back(static_cast<std::uint32_t>(taken_.size()));
    levels_.push_back({0, static_cast<std::uint32_t>(here_.size()), degree});
    if (surfaces_ != nullptr) add_surface();
    return degree;
  }

  void add_surface() {
    BoundedHierarchy::Surface& triangles = surfaces_->emplace_back();
    for (const std::uint32_t v : here_) {
      surface_.for_each_around(v, [&](std::uint32_t t, std::uint32_t) {
        const auto& corner = surface_.face(t).corner;
        if (v == *std::min_element(corner.begin(), corner.end())) triangles.push_back(corner);
      });
    }
  }

  void leave_taken() {
    std::erase_if(here_, [&](std::uint32_t v) { return surface_.face_at(v) == none; });
  }

  // --- Vertices that go ----------------------------------------------------------------------------------------------

  void take_independent() {
    std::vector<std::vector<std::uint32_t>> by_degree(limits_.most_taken + 1);
    for (const std::uint32_t v : here_) {
      if (surface_.degree(v) <= limits_.most_taken) by_degree[surface_.degree(v)].push_back(v);
    }
    std::vector<bool> is_blocked(vertices_.size(), false);
    std::size_t left = here_.size();
    for (const std::vector<std::uint32_t>& some : by_degree) {
      for (const std::uint32_t v : some) {
        if (is_blocked[v] || left == 4 || is_apex_of_pyramid(v, left)) continue;
        surface_.take_out(v, [](std::uint32_t, std::uint32_t) {});
        for (const std::uint32_t u : surface_.rim()) is_blocked[u] = true;
        take(v, surface_.rim());
        --left;
      }
    }
    SUNDER_REQUIRE(left < here_.size());
    leave_taken();
  }

  // Are the others in one plane? Of five vertices and more, one at most is such an apex, and four have a degree of at
  // most five: so there is always one that can go.
  bool is_apex_of_pyramid(std::uint32_t w, std::size_t count) const {
    if (surface_.degree(w) + 1 < count) return false;
    std::vector<std::uint32_t> others;
    surface_.for_each_around(
        w, [&](std::uint32_t t, std::uint32_t place) { others.push_back(surface_.face(t).corner[after(place)]); });
    return std::all_of(others.begin() + 3, others.end(), [&](std::uint32_t v) {
      return vertices_.orient(others[0], others[1], others[2], v) == Sign::zero;
    });
  }

  void take(std::uint32_t w, std::span<const std::uint32_t> rim) {
    taken_.push_back(w);
    rims_.insert(rims_.end(), rim.begin(), rim.end());
    rim_end_.push_back(static_cast<std::uint32_t>(rims_.size()));
  }

  // --- Vertices that are cut off -------------------------------------------------------------------------------------

  // False: there was none, or none that may be.
  bool cut_off_large() {
    std::vector<std::uint32_t> large;
    for (const std::uint32_t v : here_) {
      if (surface_.degree(v) > limits_.most_kept && vertices_.generation(v) < limits_.most_generation) {
        large.push_back(v);
      }
    }
    for (const std::uint32_t w : large) cut_off(w);
    leave_taken();
    return !large.empty();
  }

  void cut_off(std::uint32_t w) {
    const std::vector<std::uint32_t> ends = surface_.true_neighbours(w);
    const std::uint32_t cut = static_cast<std::uint32_t>(cuts_.size());
    cuts_.push_back(plane_of(w, ends));
    std::vector<std::uint32_t> rim;
    for (const std::uint32_t u : ends) {
      rim.push_back(vertices_.size());
      vertices_.add(w, vertices_.line_end(w, u), cut);
    }
    surface_.cut_off(w, ends);
    here_.insert(here_.end(), rim.begin(), rim.end());
    take(w, rim);
  }

  // The plane is less than half-way to the nearest end along its normal: so where the other end is cut off too, both
  // planes are apart on the edge.
  BoundedHierarchy::Cut plane_of(std::uint32_t w, std::span<const std::uint32_t> ends) const {
    const ExactPoint3 at = vertices_.exact(w);
    std::vector<ExactPoint3> others;
    for (const std::uint32_t u : ends) others.push_back(vertices_.exact(vertices_.line_end(w, u)));
    const Point3 mean = inwards(w);
    if (std::isfinite(mean.x) && std::isfinite(mean.y) && std::isfinite(mean.z)) {
      BoundedHierarchy::Cut cut{{mean.x, mean.y, mean.z}, 0};
      if (set_exponent(cut, at, others)) return cut;
    }
    // The normals of three neighbouring facets are independent, so their sum is inside the cone of all normals.
    const auto normal = [&](std::size_t k) {
      return cross(direction_between(at, others[(k + 1) % others.size()]), direction_between(at, others[k]));
    };
    const Vector3<Dyadic> i = normal(0), j = normal(1), k = normal(2);
    BoundedHierarchy::Cut cut{{i.x + j.x + k.x, i.y + j.y + k.y, i.z + j.z + k.z}, 0};
    [[maybe_unused]] const bool is_below_all = set_exponent(cut, at, others);
    SUNDER_REQUIRE(is_below_all);
    return cut;
  }

  // Are all others strictly on the upper side?
  static bool set_exponent(BoundedHierarchy::Cut& cut, const ExactPoint3& w, std::span<const ExactPoint3> others) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const ExactPoint3& u : others) {
      const Dyadic height = dot(cut.direction, direction_between(w, u));
      if (height.sign() != Sign::positive) return false;
      least = std::min(least, height.top() - (w.denominator * u.denominator).top() - 1);  // 2^least: below it
    }
    cut.exponent = least - 1;
    return true;
  }

  // About the mean of the normals at w, in doubles.
  Point3 inwards(std::uint32_t w) const {
    Vector3<double> sum{0, 0, 0};
    surface_.for_each_around(w, [&](std::uint32_t t, std::uint32_t) {
      const auto& [i, j, k] = surface_.face(t).corner;
      const Vector3<double> n = cross(edge(i, k), edge(i, j));
      const double size = std::sqrt(dot(n, n));
      if (size > 0) sum = {sum.x + n.x / size, sum.y + n.y / size, sum.z + n.z / size};
    });
    return {sum.x * stretch_.x, sum.y * stretch_.y, sum.z * stretch_.z};
  }
  Vector3<double> edge(std::uint32_t from, std::uint32_t to) const {
    const Point3 p = vertices_.rounded(from), q = vertices_.rounded(to);
    return {(q.x - p.x) * stretch_.x, (q.y - p.y) * stretch_.y, (q.z - p.z) * stretch_.z};
  }
  // A power of two that makes the body about 1 long along the axis.
  double stretch_along(double Point3::* axis) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::uint32_t v = 0; v < base_.size(); ++v) {
      low = std::min(low, base_.rounded(v).*axis);
      high = std::max(high, base_.rounded(v).*axis);
    }
    const double size = high - low;
    return size > 0 && std::isfinite(size) ? std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022)) : 1;
  }

  // --- The history ---------------------------------------------------------------------------------------------------

  BoundedHierarchy history() {
    const std::uint32_t size = vertices_.size();
    std::vector<std::uint32_t> rank(size), vertex(here_);
    vertex.insert(vertex.end(), taken_.rbegin(), taken_.rend());  // by ranks
    for (std::uint32_t k = 0; k < size; ++k) rank[vertex[k]] = k;
    BoundedHierarchy made;
    for (std::size_t i = levels_.size(); i-- > 0;) {
      levels_[i].end = size - taken_before_[i];
      made.levels.push_back(levels_[i]);
    }
    // Of each vertex that went, its rank on the lists of its rim; a cut point knows its parent.
    const auto is_listed = [&](std::size_t k, std::uint32_t v) {
      return !vertices_.is_cut_point(v) || vertices_.of(v).parent != taken_[k];
    };
    const auto rim_of = [&](std::size_t k) {
      const std::uint32_t from = k > 0 ? rim_end_[k - 1] : 0;
      return std::span(rims_).subspan(from, rim_end_[k] - from);
    };
    std::vector<std::uint32_t> end(size, 0);
    for (std::size_t k = 0; k < taken_.size(); ++k) {
      for (const std::uint32_t v : rim_of(k)) end[rank[v]] += is_listed(k, v) ? 1u : 0u;
    }
    std::uint32_t begin = 0;
    for (std::uint32_t k = 0; k < size; ++k) {
      const std::uint32_t v = vertex[k], count = end[k];
      made.nodes.push_back({vertices_.at(v), v, none, begin, begin + count, 0, 0});
      end[k] = begin;
      begin += count;
      if (!vertices_.is_cut_point(v)) continue;
      const auto& of = vertices_.of(v);
      std::uint32_t& of_polyhedron = made.nodes.back().vertex;
      while (vertices_.is_cut_point(of_polyhedron)) of_polyhedron = vertices_.of(of_polyhedron).parent;
      made.nodes.back().copy = static_cast<std::uint32_t>(made.copies.size());
      made.copies.push_back({of.rest, of.share, rank[of.parent], rank[of.toward], of.cut});
    }
    made.comers.resize(begin);
    for (std::size_t k = taken_.size(); k-- > 0;) {  // by ascending ranks
      BoundedHierarchy::Node& node = made.nodes[rank[taken_[k]]];
      node.rim_begin = static_cast<std::uint32_t>(made.rims.size());
      for (const std::uint32_t v : rim_of(k)) {
        if (is_listed(k, v)) made.comers[end[rank[v]]++] = rank[taken_[k]];
        made.rims.push_back(rank[v]);
      }
      node.rim_end = static_cast<std::uint32_t>(made.rims.size());
    }
    made.cuts = std::move(cuts_);
    if (surfaces_ == nullptr) return made;
    std::reverse(surfaces_->begin(), surfaces_->end());
    for (BoundedHierarchy::Surface& triangles : *surfaces_) {
      for (auto& triangle : triangles) {
        for (std::uint32_t& v : triangle) v = rank[v];
      }
    }
    return made;
  }

  const Base& base_;
  Surfaces* const surfaces_;
  const Limits limits_;
  std::vector<BoundedHierarchy::Cut> cuts_;
  BoundedVertices<Base> vertices_;
  HierarchySurface<BoundedVertices<Base>> surface_;
  std::vector<std::uint32_t> here_;  // the vertices of the level
  const Point3 stretch_;

  std::vector<std::uint32_t> taken_;           // in the order in which they went
  std::vector<std::uint32_t> rims_, rim_end_;  // of each; of those that were cut off the new vertices
  std::vector<std::uint32_t> taken_before_;    // each level
  std::vector<BoundedHierarchy::Level> levels_;
};

}  // namespace sunder::solid::hierarchy_detail
