// The tables of a certificate file of version 3, as integers: docs/claims.md, "Tables". Whatever is not as it must be
// is refused by rule F.
#pragma once

#include <verifier/cpp/json.h>
#include <verifier/cpp/numbers.h>
#include <verifier/cpp/said.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {

// Integers, all in units of 2^e.
struct Scaled {
  std::vector<Integers> rows;
  std::int64_t e = 0;
  std::size_t bits = 0;  // of the longest
};

// What is around the core of a body: nothing, where it has no radius. hull: a ball. cylinder, cone: discs across its
// axis, of a cone the smaller the nearer to its apex, point 1. ellipsoid: the image of a ball.
enum class Around : std::uint8_t { nothing, hull, cylinder, cone, ellipsoid };

// What has rows, and may be the image of another one, whose rows it has.
struct Placed {
  std::string name, quoted;  // cut, as it is told; and in quotes, as in sentences
  std::string said;          // what it is said to be made of; empty: nothing
  std::shared_ptr<const Scaled> given;
  Scaled linear;       // one row: the matrix, row by row; no row where this is no image
  Scaled translation;  // one row

  bool is_image() const { return !linear.rows.empty(); }
};

// A convex hull of points, with the ways that go on from there for ever, or with a radius; or the image of one.
struct HullBody : Placed {
  std::size_t base = 0;   // its own index, or that of the body that it is the image of
  std::size_t count = 0;  // of points, which are the first rows; ways are the others
  Around around = Around::nothing;
  Number radius{};
  std::string radius_text;
  Integers axis;  // of a cylinder or cone: from point 0 to point 1, placed, times a power of two

  const std::vector<Integers>& rows() const { return given->rows; }
  std::size_t dimension() const { return rows()[0].size(); }
  bool is_way(std::size_t k) const { return k >= count; }
  bool is_round() const { return around != Around::nothing; }
  std::string title() const;  // what it is, and of how many points
  // The bits of its longest number, of the longest of what places it, and of its radius, with all exponents.
  std::size_t size() const;
};

using MeshTriangle = std::array<std::size_t, 3>;

// The triangles of a mesh, and of each its piece, a number, and whether that is closed.
struct MeshPieces {
  std::vector<MeshTriangle> triangles;
  std::vector<std::size_t> piece;
  std::vector<bool> is_closed;
  std::size_t closed = 0;  // how many are
  bool by_winding = true;  // a winding number tells what is inside of the closed pieces; if false, parity does
};

// Requires points that are all different.
MeshPieces pieces_of(std::vector<MeshTriangle> triangles, const std::vector<Integers>& points);

// A mesh, or the image of one.
struct MeshBody : HullBody {
  std::shared_ptr<const MeshPieces> pieces;

  std::string title() const;
};

Integer dot(const Integers& u, const Integers& v);
Integers cross(const Integers& u, const Integers& v);  // of three numbers each

// The transposed matrix, which is one row, times a vector, as integers * 2^matrix.e.
Integers transposed_times(const Scaled& matrix, const Integers& vector);

// The matrix times a vector, of which the first numbers count, as integers * 2^linear.e; of no image the vector.
Integers turned(const Placed& body, const Integers& vector);

// A point x, y, .. as integers, and a positive w at the end: x / w, y / w, ..
Integers projective(const Numbers& values);

// Of point or way k, as integers * 2^e; and e.
std::pair<Integers, std::int64_t> image(const HullBody& body, std::size_t k);

// The products of a direction with the points and the ways, in units of 2^e; and e. Takes the steps.
std::pair<Integers, std::int64_t> products(const HullBody& body, const Integers& direction);

// The hull of points of R^d, or the common part of half-spaces a x <= b, of rows a1, .., ad, b; or the image of one.
struct RowBody : Placed {
  std::size_t dimension = 0;
  bool is_of_points = false;

  std::string title() const;
};

struct PlanarPoint {
  Integer x, y;

  friend bool operator==(const PlanarPoint& p, const PlanarPoint& q) { return p.x == q.x && p.y == q.y; }
};

bool is_less(const PlanarPoint& p, const PlanarPoint& q);  // lexicographically

// The first end is lexicographically not after the last.
struct PlanarSegment {
  PlanarPoint first, last;
};

struct PlanarBox {
  Integer low_x, low_y, high_x, high_y;
  friend bool operator==(const PlanarBox&, const PlanarBox&) = default;
};

// Closed. r >= 0.
struct PlanarDisc {
  Integer x, y, r;
};

// Members of a set, in units of 2^exponent.
template <class Member>
struct MemberTable : std::vector<Member> {
  std::int64_t exponent = 0;
  std::size_t bits = 0;  // of the longest number
};

// a x + b y <= c; each number in units of 2^e.
struct LinearConstraint {
  Integer a, b, c;
  std::int64_t e = 0;
};

using Constraints = MemberTable<LinearConstraint>;  // each has a unit of its own
using Circles = MemberTable<PlanarDisc>;
using Boxes = MemberTable<PlanarBox>;
using Segments = MemberTable<PlanarSegment>;

// Positive: the normal of k is less than half a turn counter-clockwise from that of h.
Integer turn(const LinearConstraint& h, const LinearConstraint& k);
// Does each turn to the next, and all by one turn?
bool goes_round_once(const Constraints& sides);
// Edges begin to end - 1; their blocks are first_block and those after it.
struct EdgeRange {
  std::size_t begin, end;
  std::size_t first_block = 0;
};

constexpr std::size_t edges_of_block = 32;

// Some edges of a ring that follow each other: these are between two abscissas, and not below an ordinate.
struct EdgeBlock {
  Integer left, right, low;
};

// Edge k goes from vertex k to the next one of its ring.
struct PolygonTable {
  bool is_flat(std::size_t polygon) const;  // fewer than three edges: a point, or a segment
  bool is_point(std::size_t polygon) const;

  std::vector<std::vector<EdgeRange>> rings;  // of each polygon
  Segments edges;
  std::vector<std::size_t> owner;  // the polygon of each edge
  std::vector<EdgeBlock> blocks;   // of all rings
};

// Some polygons, with edges and rings numbered anew.
struct PartTable {
  PolygonTable polygons;
  std::vector<EdgeRange> rings;
  std::vector<std::size_t> ring_of;                // of each edge
  std::vector<std::size_t> part;                   // of each ring
  std::vector<std::size_t> shell;                  // of each part, its first ring
  std::vector<std::array<std::size_t, 2>> beside;  // of each edge of some length those before and after it on its
                                                   // ring, those of no length left out
};

struct Tables {
  InputNames inputs;
  std::map<std::string, std::size_t> sizes;  // of those that the file has: numbers of entries
  std::map<std::string, std::string> said;   // of tables of rows: what these are said to be made of, in words
  std::vector<HullBody> bodies;
  std::vector<RowBody> polytopes;
  std::vector<MeshBody> meshes;
  Segments segments;
  Circles circles;
  Boxes boxes;
  Constraints half_planes;
  PolygonTable polygons;
  std::vector<Constraints> rings;                            // what is on the inner side of the edges of each
  std::vector<std::shared_ptr<const PartTable>> ring_parts;  // each as the one ring of a polygon
  Constraints convex_polygons;                               // the sides of all

  // Those of the call before, if it named the same: statements that follow each other mostly do.
  std::shared_ptr<const PartTable> parts_of(const std::vector<std::size_t>& which) const;
  std::size_t part_tables_made() const { return part_tables_made_; }

 private:
  mutable std::vector<std::size_t> last_named_;
  mutable std::shared_ptr<const PartTable> last_parts_;
  mutable std::size_t part_tables_made_ = 0;
};

Tables read_tables(const Json& item, InputNames inputs);
// What rows are said to be made of.
void read_said(const Json& item, Tables& tables);

}  // namespace sunder_verifier
