// The polygons of IHG as sequences of vertices with random access, for planar searches (planar/pair/placed.h), in
// floating point: W, whose corners are on slices; what a section has beside a corner of W; and the polygon R.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/pair/edge_runs.h>
#include <sunder/solid/section/scaled_pose.h>
#include <sunder/solid/section/section_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace sunder::solid {

// A point of the plane, rounded. The signs are those of rounded numbers. Corners of a slice may be in one place, on
// different lateral edges: these tell which way each goes, so that the side between them has a direction.
template <class Real>
struct RoundedPoint {
  Real x, y;
  double dx = 0, dy = 0;  // of a corner of a slice: as the slice goes into the drum

  // From p to q; where that is nothing, by which way it opens.
  friend std::array<Real, 2> way(const RoundedPoint& p, const RoundedPoint& q) {
    const Real along_x = q.x - p.x, along_y = q.y - p.y;
    const auto is_zero = [](const Real& r) { return !(r > Real(0)) && !(r < Real(0)); };
    if (!is_zero(along_x) || !is_zero(along_y)) return {along_x, along_y};
    return {Real(q.dx - p.dx), Real(q.dy - p.dy)};
  }
  friend Sign cross_2d(const RoundedPoint& p, const RoundedPoint& q, const RoundedPoint& r, const RoundedPoint& s,
                       StageTally* = nullptr) {
    const auto u = way(p, q), v = way(r, s);
    return sign_of_rounded<Real>(u[0] * v[1] - u[1] * v[0]);
  }
  friend Sign dot_2d(const RoundedPoint& p, const RoundedPoint& q, const RoundedPoint& r, const RoundedPoint& s,
                     StageTally* = nullptr) {
    return sign_of_rounded<Real>((q.x - p.x) * (s.x - r.x) + (q.y - p.y) * (s.y - r.y));
  }
};

// Two linear forms as coordinates in T.
template <class Real>
struct Coordinates {
  LinearForm<Real> x, y;
};

// Parts of a planar sequence that searches ask for, where they are not known beforehand: the ends of the halves.
// Derived has size() and point(k); what it makes is remembered, because searches come back to where they were.
template <class Derived, class Real>
class RoundedSequence {
 public:
  using Vertex = RoundedPoint<Real>;

  RoundedSequence() { known_.fill(none); }

  Vertex operator[](std::uint32_t k) const {
    const std::size_t place = (k * 0x9E3779B1u) >> (32 - bits);
    if (known_[place] != k) {
      at_[place] = derived().point(k);
      known_[place] = k;
    }
    return at_[place];
  }

  std::uint32_t number(std::uint32_t k) const { return k; }
  std::array<Vertex, 2> up() const { return {Vertex{0, 0}, Vertex{0, 1}}; }

  // The leftmost vertex, of two the lower one; the rightmost, of two the upper one. Cost: O(log n) vertices each.
  std::uint32_t first() const { return furthest({-1, 0, 0}); }
  std::uint32_t second() const { return furthest({1, 0, 0}); }

 private:
  std::uint32_t furthest(const Point3& d) const {
    const auto& p = *this;
    const std::uint32_t n = derived().size();
    if (n <= 2) return n == 2 && nearest((p[1].x - p[0].x)) * d.x > 0 ? 1 : 0;
    return first_past(n, {0, 0, 1}, d, [&](std::uint32_t k) {
      const auto side = way(p[k], p[k + 1 < n ? k + 1 : 0]);
      return Point3{nearest(side[1]), -nearest(side[0]), 0};
    });
  }
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  static constexpr unsigned bits = 5;
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  mutable std::array<std::uint32_t, std::size_t{1} << bits> known_;
  mutable std::array<Vertex, std::size_t{1} << bits> at_;
};

// W. Corners that are one point, at its ends, are there once.
template <class Real>
class CornerSequence : public RoundedSequence<CornerSequence<Real>, Real> {
  using Base = RoundedSequence<CornerSequence<Real>, Real>;

 public:
  using Vertex = RoundedPoint<Real>;
  using Corner = typename SectionSearch<Real>::Corner;

  // Keeps references. Requires a section that meets slices.
  CornerSequence(const SectionSearch<Real>& section, const Coordinates<Real>& coordinates)
      : section_(section), coordinates_(coordinates), half_(section.corner_count() / 2) {
    const auto same = [&](std::uint32_t p, std::uint32_t q) {
      const Vertex a = at(p), b = at(q);
      return !(a.x < b.x) && !(b.x < a.x) && !(a.y < b.y) && !(b.y < a.y);
    };
    one_at_top_ = same(half_ - 1, half_);
    one_at_bottom_ = half_ > 1 && same(0, 2 * half_ - 1);
    const std::uint32_t middle = half_ / 2;
    has_level_ = !same(middle, 2 * half_ - 1 - middle);
    level_ = {at(middle), at(2 * half_ - 1 - middle)};
  }

  // W goes up from its lowest corner on the right to the highest one on the left, and then down: so its halves are
  // known, beside the level line from right to left.
  std::array<Vertex, 2> up() const { return has_level_ ? level_ : Base::up(); }
  std::uint32_t first() const { return has_level_ ? 0 : Base::first(); }
  std::uint32_t second() const { return !has_level_ ? Base::second() : one_at_top_ ? half_ - 1 : half_; }

  std::uint32_t size() const { return 2 * half_ - (one_at_top_ ? 1 : 0) - (one_at_bottom_ ? 1 : 0); }
  Vertex point(std::uint32_t k) const { return at(corner(k)); }

  // What vertex k is a mean of.
  template <class Add>
  void add_parts(std::uint32_t k, const Add& add) const {
    section_.add_parts(section_.corner(corner(k)), add);
  }

  // Which pockets are beside vertex k, and behind it, up to the next vertex: at a tip that is one point there are two.
  // At most four beside a vertex.
  struct Pockets {
    std::uint32_t begin, count;
  };
  Pockets beside(std::uint32_t k) const {
    const Pockets before = behind(k > 0 ? k - 1 : size() - 1);
    return {before.begin, std::min(before.count + behind(k).count, 2 * half_)};
  }
  Pockets behind(std::uint32_t k) const {
    const std::uint32_t q = corner(k), next = corner(k + 1 < size() ? k + 1 : 0);
    return {q, next > q ? next - q : next + 2 * half_ - q};
  }

 private:
  std::uint32_t corner(std::uint32_t k) const { return one_at_top_ && k >= half_ ? k + 1 : k; }
  Vertex at(std::uint32_t q) const {
    const Corner c = section_.corner(q);
    return {section_.value(coordinates_.x, c), section_.value(coordinates_.y, c)};
  }

  const SectionSearch<Real>& section_;
  const Coordinates<Real>& coordinates_;
  std::uint32_t half_;
  bool one_at_top_ = false, one_at_bottom_ = false, has_level_ = false;
  std::array<Vertex, 2> level_;
};

// A corner of W, the section's vertices in the pocket behind it, the next corner, and so on, for one to four pockets.
// Where the section meets no slice, all of it; where it has as many corners, all round.
template <class Real>
class PocketSequence : public RoundedSequence<PocketSequence<Real>, Real> {
 public:
  using Vertex = RoundedPoint<Real>;
  using Section = SectionSearch<Real>;

  PocketSequence(const Section& section, const Coordinates<Real>& coordinates, std::uint32_t q, std::uint32_t count)
      : section_(section),
        coordinates_(coordinates),
        all_round_(!section.meets_slices()),
        closed_(count == section.corner_count()),
        count_(count) {
    const std::uint32_t n = section.corner_count();
    for (std::uint32_t k = 0; k < count; ++k) pockets_[k] = section.pocket((q + k) % n);
    if (all_round_) return;
    for (std::uint32_t k = 0; k <= count; ++k) corners_[k] = section.corner((q + k) % n);
  }

  std::uint32_t size() const {
    if (all_round_) return pockets_[0].count + 1;
    std::uint32_t size = closed_ ? count_ : count_ + 1;
    for (std::uint32_t k = 0; k < count_; ++k) size += pockets_[k].count;
    return size;
  }
  Vertex point(std::uint32_t k) const {
    const Part part = part_of(k);
    if (part.is_corner) return at(corners_[part.corner]);
    return at(edge(part));
  }

  // What vertex k is a mean of.
  template <class Add>
  void add_parts(std::uint32_t k, const Add& add) const {
    const Part part = part_of(k);
    if (part.is_corner) return section_.add_parts(corners_[part.corner], add);
    section_.add_parts(edge(part), add);
  }

  // The facet of the side behind vertex k; none behind the last one, where it is no side of the section, and where it
  // goes through a point.
  std::optional<std::uint32_t> facet_behind(std::uint32_t k) const {
    const Part part = part_of(k);
    if (all_round_) return section_.facet(pockets_[0], part.j);
    if (k + 1 == size() && !closed_) return std::nullopt;
    return section_.facet(pockets_[part.pocket], part.is_corner ? 0 : part.j);
  }

  // The ends of the body's edge that vertex k is on; none for corners, but on level edges.
  std::optional<std::array<std::uint32_t, 2>> edge_at(std::uint32_t k) const {
    const Part part = part_of(k);
    if (!part.is_corner) {
      const LateralEdge e = edge(part);
      return std::array{e.low, e.high};
    }
    const auto& [e, f, slice] = corners_[part.corner];
    const auto ends_here = [at = slice](const LateralEdge& x) { return x.begin == at || x.end == at; };
    if (!ends_here(e) || !ends_here(f)) return std::nullopt;
    const std::array<std::uint32_t, 2> ends{e.begin == slice ? e.low : e.high, f.begin == slice ? f.low : f.high};
    if (ends[0] == ends[1]) return std::nullopt;
    return ends;
  }

 private:
  // Edge j of a pocket, or a corner, behind which the pocket is.
  struct Part {
    bool is_corner;
    std::uint32_t corner, pocket, j;
  };
  Part part_of(std::uint32_t k) const {
    if (all_round_) return {false, 0, 0, k};
    std::uint32_t pocket = 0;
    while (pocket < count_ && k > pockets_[pocket].count) k -= pockets_[pocket++].count + 1;
    return k == 0 ? Part{true, pocket, pocket, 0} : Part{false, 0, pocket, k};
  }
  LateralEdge edge(const Part& part) const { return section_.edge(pockets_[part.pocket], part.j); }
  template <class Place>
  Vertex at(const Place& place) const {
    return {section_.value(coordinates_.x, place), section_.value(coordinates_.y, place)};
  }

  const Section& section_;
  const Coordinates<Real>& coordinates_;
  bool all_round_, closed_;
  std::uint32_t count_;
  std::array<typename Section::Pocket, 4> pockets_{};
  std::array<typename Section::Corner, 5> corners_{};
};

// R, in coordinates of the scaled world counted from a point of it; turned round where it runs clockwise there.
template <class Real>
class FlatSequence : public RoundedSequence<FlatSequence<Real>, Real> {
 public:
  using Vertex = RoundedPoint<Real>;

  FlatSequence(const Placed& polygon, const ScaledPose& frame, const Point3& from, std::size_t x, std::size_t y,
               bool turned, Cost& cost)
      : polygon_(polygon),
        cycle_(polygon.body.facet(0)),
        frame_(frame),
        from_(from),
        x_(x),
        y_(y),
        turned_(turned),
        cost_(cost) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(cycle_.size()); }
  Vertex point(std::uint32_t k) const {
    ++cost_.probes;
    const VectorOf<Real> at =
        frame_.template way_to_image<Real>(from_, polygon_.pose, polygon_.graph.vertices[vertex(k)]);
    const std::array<Real, 3> all{at.x, at.y, at.z};
    return {all[x_], all[y_]};
  }
  std::uint32_t vertex(std::uint32_t k) const { return cycle_[turned_ ? size() - 1 - k : k]; }

  template <class Add>
  void add_parts(std::uint32_t k, const Add& add) const {
    add(vertex(k), Real(1));
  }

 private:
  const Placed& polygon_;
  std::span<const std::uint32_t> cycle_;
  const ScaledPose& frame_;
  Point3 from_;
  std::size_t x_, y_;
  bool turned_;
  Cost& cost_;
};

}  // namespace sunder::solid
