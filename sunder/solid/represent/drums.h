// A convex polyhedron as a stack of drums: the parts between its cross-sections at the heights of its vertices.
// Also called: slab decomposition; parallel cross-sections, slices; preprocessing polygons.
//
// Slice i goes through all vertices of the i-th height along a direction, counted from the lowest; drum i is what lies
// between slices i and i + 1. No vertex is inside of a drum, so it is told by the edges of the body that cross it, its
// lateral edges, in their cyclic order: counter-clockwise seen from above. Corner k of its lower slice is where edge k
// leaves that, corner k of its upper slice is where the same edge enters that: so corners match one to one, and a
// vertex from which several edges go up is as many corners in one place (the paper's dummy vertices). Side k is the
// facet between edges k and k + 1: it is a side of both slices, where it may have length zero.
//
// All of this is combinatorial and exact, whatever the heights are. Only corners are rounded, when they are asked for.
//
// Two forms, behind one interface:
//   listed: the edges of each drum in a list, in all about n^1.5 for round bodies, n^2 at worst.
//   persistent: O(n log n) bits. Edges have one order that is right in every drum (sideways along the surface, cut open
//     along one path upwards); edge k of drum i is the k-th of those that have begun and not ended there, found by
//     halving in two wavelet trees, one of beginnings and one of ends.
// Source: CD87 section 3.2. Departures: lateral edges in place of refined vertices; in place of the paper's reference 7
// for the persistent form, ranks in bit vectors (wavelet trees: Grossi, Gupta, Vitter 2003).
#pragma once

#include <sunder/base/contract.h>
#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/represent/ranked_bits.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::solid {

class ConvexPolyhedron;

struct LateralEdge {
  std::uint32_t low = 0, high = 0;  // its vertices
  std::uint32_t begin = 0;          // it crosses drums begin .. end - 1: these are the slices of its vertices
  std::uint32_t end = 0;
  std::uint32_t side = 0;  // the facet after it, counter-clockwise seen from above
};

enum class DrumsForm : std::uint8_t { listed, persistent };

class Drums {
 public:
  static constexpr std::size_t slot = 5;  // see solid/represent/of.h

  // Bottom up along z (a body in one level plane along x, or y), in the form that fits.
  static Drums make(const ConvexPolyhedron& body);

  // Entries of lists that the listed form may have in all: 1 GiB; and with which it is the one that fits: 32 MiB.
  static constexpr std::uint64_t most_listed = std::uint64_t{1} << 28;
  static constexpr std::uint64_t most_listed_unasked = std::uint64_t{1} << 23;

  // Along a direction of the body's frame, of any length. No form: the one that fits.
  // Throws Error: bad_value where a number is not finite, bad_shape where all are zero, and for more than most_listed
  // entries in lists. Cost: O(n log n), and the entries of lists.
  Drums(const ConvexPolyhedron& body, const Point3& direction, std::optional<DrumsForm> form);

  const Point3& direction() const { return direction_; }

  std::uint32_t slice_count() const { return static_cast<std::uint32_t>(slices_.size()); }
  std::uint32_t drum_count() const { return slice_count() - 1; }

  // Lateral edges of a drum. Requires drum < drum_count().
  std::uint32_t size(std::uint32_t drum) const { return begun_[drum] - ended_[drum]; }

  // Edge k of a drum: the access that costs are counted in, by its steps. Requires k < size(drum).
  const LateralEdge& edge(std::uint32_t drum, std::uint32_t k) const {
    SUNDER_REQUIRE(drum < drum_count() && k < size(drum));
    return edges_[form_ == DrumsForm::listed ? lists_[list_begin_[drum] + k] : select(drum, k)];
  }

  // Steps of an access: of the persistent form its levels, log2 of the number of edges, rounded up; else 1.
  std::uint32_t steps_of_access() const { return form_ == DrumsForm::listed ? 1 : levels_; }

  // The slice of a vertex. Requires a vertex of the body.
  std::uint32_t slice_of(std::uint32_t vertex) const { return slice_of_[vertex]; }

  // A vertex of a slice. Requires slice < slice_count().
  std::uint32_t vertex_of(std::uint32_t slice) const { return slices_[slice]; }

  // The level facet that is the lowest slice (0) or the highest (1), if it is one.
  std::optional<std::uint32_t> level_facet(std::size_t end) const { return level_facets_[end]; }

  // For searches, the body is seen in a frame of its own, in which it is about one long along each axis: points are
  // multiplied by these powers of two, normals and other directions of measuring divided by them.
  const Point3& shrink() const { return shrink_; }

  // So seen: outwards, rounded, its greatest component of size 1; and the direction that is up.
  const Point3& normal(std::uint32_t facet) const { return normals_[facet]; }
  const Point3& up() const { return up_; }

  DrumsForm form() const { return form_; }
  std::size_t memory() const;  // bytes

 private:
  void find_slices(std::span<const Point3> vertices);
  void find_edges(const ConvexPolyhedron& body);
  std::uint64_t listed_size() const;
  void make_lists();
  void make_trees();
  std::uint32_t select(std::uint32_t drum, std::uint32_t k) const;

  Point3 direction_;
  DrumsForm form_ = DrumsForm::persistent;
  std::vector<std::uint32_t> slices_;    // a vertex of each
  std::vector<std::uint32_t> slice_of_;  // of each vertex
  std::array<std::optional<std::uint32_t>, 2> level_facets_;
  std::vector<LateralEdge> edges_;            // in an order that is right in every drum
  std::vector<std::uint32_t> begun_, ended_;  // by drum: how many have begun there or below, or ended
  Point3 shrink_;                             // along each axis, so that the body's box has sides of about 1
  Point3 up_;
  std::vector<Point3> normals_;  // of facets

  std::vector<std::uint64_t> list_begin_;  // listed: by drum
  std::vector<std::uint32_t> lists_;

  std::uint32_t levels_ = 0;  // persistent
  RankedBits bits_;           // of level l: vector 2 l of beginnings, 2 l + 1 of ends
};

}  // namespace sunder::solid
