// The upper boundary of a common part of convex polygons between two abscissas, as pieces of their edges' lines.
// Also called: lower envelope of concave chains.
//
// Between the greatest abscissa of the polygons' leftmost vertices and the least of their rightmost ones the upper
// boundary of each polygon is a concave function of x, and that of a common part is the least of these. Lower
// boundaries are upper ones of the polygons turned upside down: (x, y) becomes (x, -y), which is exact.
//   E1. Pieces run from left to right, with falling slopes, each over more than one abscissa.
//   E2. A piece begins where its line crosses that of the piece before.
// Of pieces in one line the lowest polygon's, and of one polygon the lowest edge, serves.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/base/cost.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/predicate/line/line_points.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

struct EdgePiece {
  Point2 a, b;  // of the line, a.x < b.x
  std::uint32_t polygon = 0, edge = 0;
  Enclosure2 begin;  // holds where the piece begins; one point where this is a vertex; meaningless for the first piece
};

// Where piece m of a chain begins. Requires m > 0.
inline LinePoint beginning(std::span<const EdgePiece> chain, std::size_t m) {
  SUNDER_REQUIRE(m > 0 && m < chain.size());
  const EdgePiece &before = chain[m - 1], &piece = chain[m];
  LinePoint p{{before.a, before.b, piece.a, piece.b}, piece.begin};
  if (p.is_double()) p.lines.a = {p.in.x.low, p.in.y.low};
  return p;
}

struct Abscissas {
  double low = 0, high = 0;
};

enum class Boundary : std::uint8_t { upper, lower };

class EdgeChains {
 public:
  // Requires low < high.
  EdgeChains(std::span<const ConvexPolygon> polygons, const Abscissas& between)
      : polygons_(polygons), between_(between) {
    SUNDER_REQUIRE(between.low < between.high);
  }

  // Appends the chain of one polygon. Requires that it reaches over the abscissas. Cost: linear.
  void append(std::uint32_t polygon, Boundary boundary, std::vector<EdgePiece>& out);

  // The chain of the common part of these polygons, one at least. Cost: O(n k log n) probes, for n of k vertices.
  std::vector<EdgePiece> divide(std::span<const std::uint32_t> polygons, Boundary boundary);

  // The same, each edge's line by itself. Cost: O(n k log (n k)) probes.
  std::vector<EdgePiece> divide_edges(std::span<const std::uint32_t> polygons, Boundary boundary);

  // The least of both. Cost: as many probes as there are pieces in all, at most.
  void merge(std::span<const EdgePiece> p, std::span<const EdgePiece> q, std::vector<EdgePiece>& out);

  const Abscissas& between() const { return between_; }

  // probes: vertices looked at, and stretches of abscissas in which two lines were compared.
  Cost cost() const { return {probes_, 0, tally_.exact}; }
  StageTally& tally() { return tally_; }

 private:
  std::vector<EdgePiece> merge_all(std::vector<EdgePiece> chains, std::vector<std::size_t> ends);

  std::span<const ConvexPolygon> polygons_;
  Abscissas between_;
  std::uint64_t probes_ = 0;
  StageTally tally_;
};

}  // namespace sunder::planar
