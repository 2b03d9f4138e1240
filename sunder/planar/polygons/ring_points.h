// Where rings that neither cross nor overlap within their edges come together: the sweep of polygon_valid.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/planar/object/segments.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// Rings of the parts of a multipolygon; of vertices that repeat the one before the last is kept. Vertices are numbered
// over all rings in turn; edge k goes from vertex k to the next of its ring.
class RingSet {
 public:
  struct Ring {
    std::uint32_t part, number;  // as given
    std::uint32_t given;         // how many vertices it had
    std::uint32_t begin, end;    // of those that are left
  };

  // Adds a ring; a last vertex that repeats the first is left out. Throws Error bad_value where a coordinate is not
  // finite, bad_shape for 2^31 vertices and more.
  void add(std::uint32_t part, std::uint32_t number, std::span<const Point2> vertices);

  // Those rings for which `keep` is true.
  RingSet only(const std::vector<bool>& keep) const;

  const std::vector<Ring>& rings() const { return rings_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices_.size()); }  // of vertices, and of edges
  const Point2& vertex(std::uint32_t k) const { return vertices_[k]; }
  std::span<const Point2> vertices() const { return vertices_; }
  std::uint32_t given(std::uint32_t k) const { return given_[k]; }      // a vertex's number in its ring, as given
  std::uint32_t ring_of(std::uint32_t k) const { return ring_of_[k]; }  // a position in rings()
  std::uint32_t next(std::uint32_t k) const {
    const Ring& ring = rings_[ring_of_[k]];
    return k + 1 == ring.end ? ring.begin : k + 1;
  }
  Segment edge(std::uint32_t k) const { return sorted({vertices_[k], vertices_[next(k)]}); }
  std::vector<Segment> edges() const;  // all of them
  // Does the edge go, in the direction of its ring, from its lexicographically first end to its last?
  bool increases(std::uint32_t k) const { return lexicographically_less(vertices_[k], vertices_[next(k)]); }

 private:
  std::vector<Ring> rings_;
  std::vector<Point2> vertices_;
  std::vector<std::uint32_t> given_, ring_of_;
};

// A way along an edge from a point, in the direction of its ring or against it. A ring that passes through the point
// has two ways there: of two edges that follow each other, or of the edge that holds the point inside.
struct RingWay {
  std::uint32_t edge;
  bool forward;
  std::uint32_t pass;  // the same for both ways of it, and for no others at the point
};

// A point through which rings pass twice or more, or in which one begins, seen from the left: it has two ways there to
// the right. Ways are in their order around the point, counter-clockwise, from the lowest of those to the right.
struct RingPoint {
  Point2 at;
  std::uint32_t first, count;  // of its ways
  std::uint32_t right;         // how many of them go to the right
  std::uint32_t below;         // the edge just below all of these, or no_edge
};

struct RingPoints {
  static constexpr std::uint32_t no_edge = 0xffffffffu;
  std::vector<RingPoint> points;  // in lexicographic order
  std::vector<RingWay> ways;
  Cost cost{};  // probes: comparisons

  std::span<const RingWay> ways_at(const RingPoint& p) const { return std::span(ways).subspan(p.first, p.count); }
};

// Requires that each ring has three vertices at least, and that no two edges cross or overlap.
// Cost: O(n log n) comparisons, O(n) memory.
RingPoints ring_points(const RingSet& rings);

// The same where the edges and the order of their ends (as by ends_in_order) are known.
RingPoints ring_points(const RingSet& rings, std::span<const Segment> edges, std::span<const std::uint32_t> ends);

}  // namespace sunder::planar
