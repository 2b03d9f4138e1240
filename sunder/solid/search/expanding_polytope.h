// A polytope of points of the difference A - B, of facets that are triangles, which grows outwards point by point, and
// knows its facet that is nearest to the origin: the distance of that one is how deep the origin is in the polytope.
// Also called: expanding polytope algorithm (EPA); incremental convex hull.
//
//   X1. It is the convex hull of its corners, exactly: which facets a corner is beyond is decided by exact signs.
//       Facets may be of one plane; none is flat; each is counterclockwise from outside.
//   X2. `height` of a facet encloses the distance of the origin to its plane, negative where the origin is beyond it.
// Allocates as it grows. Source: van den Bergen 2001; here each sign is exact, so no step can break the surface.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/estimate.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/number/interval.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace sunder::solid {

class ExpandingPolytope {
 public:
  struct Facet {
    std::array<std::uint32_t, 3> corner{}, neighbour{};  // neighbour k has the edge from corner k to the next one
    Vector3<Estimate> normal{};                          // outwards, not of length 1
    Interval height{};
    bool is_alive = true;    // of the hull as it is
    bool is_closed = false;  // known to be a facet of the difference: not told of again by nearest()
  };

  // Tells a corner's exact coordinates, asked for where estimates do not do.
  using ExactOf = std::function<Vector3<Dyadic>(std::uint32_t corner)>;
  explicit ExpandingPolytope(ExactOf exact_of) : exact_of_(std::move(exact_of)) {}

  std::uint32_t add_corner(const Vector3<Estimate>& at);
  // Of corners that no facet has.
  void remove_last_corner();
  std::uint32_t corner_count() const { return static_cast<std::uint32_t>(at_.size()); }
  const Vector3<Dyadic>& exact(std::uint32_t corner);

  // Begins with these four. Requires that they are not of one plane.
  void begin(const std::array<std::uint32_t, 4>& corners);

  // The alive facet that is not closed and whose height's lower end is the least; nothing where all are closed.
  std::optional<std::uint32_t> nearest();
  // Puts it back, as nearest() takes it out.
  void put_back(std::uint32_t facet);
  void close(std::uint32_t facet) { facets_[facet].is_closed = true; }

  // positive: the corner is beyond the facet.
  Sign side(std::uint32_t facet, std::uint32_t corner);
  // Takes in a corner that is beyond the facet, which nearest() gave.
  void expand(std::uint32_t facet, std::uint32_t corner);

  Vector3<Dyadic> exact_normal(std::uint32_t facet);
  // Of the facet's height. Requires that this is not negative.
  ExactFraction square(std::uint32_t facet);

  std::span<const Facet> facets() const { return facets_; }
  std::uint32_t alive_count() const { return alive_; }
  std::uint32_t exact_signs() const { return tally_.exact; }

 private:
  std::uint32_t add_facet(const std::array<std::uint32_t, 3>& corner);
  Interval exact_height(const Facet& facet);
  Vector3<Dyadic> exact_normal_of(const std::array<std::uint32_t, 3>& corner);

  ExactOf exact_of_;
  std::vector<Vector3<Estimate>> at_;
  std::vector<std::optional<Vector3<Dyadic>>> exact_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> heap_;  // of facets, the nearest first; some are not alive any more
  std::uint32_t alive_ = 0;
  StageTally tally_;

  // Of expand(), kept for their memory.
  struct Edge {
    std::uint32_t from, to, beyond;  // beyond: the facet that stays
  };
  std::vector<std::uint32_t> seen_, visible_, facet_from_;
  std::vector<Edge> horizon_;
  std::vector<std::uint8_t> mark_;
};

}  // namespace sunder::solid
