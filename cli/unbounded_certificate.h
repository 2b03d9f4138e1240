// Certificates about lines, rays and half-planes, in the format of bounded bodies (docs/certificates.md).
//
// The unbounded object stands in the file as the hull of the points that define it, and the statements are such that
// what they say of this piece holds of the whole:
//   line, ray     its two points a and b, as vertices 0 and 1; they are doubles, and as given.
//   half-plane    the triangle of a, b and a point c to the left of the way from a to b: the half-plane is bounded by
//                 the line through a and b, and c is in it.
//   meet          a point of the piece is a point of the whole.
//   apart, ray    the least far vertex of the piece is a: then b, and all of the ray behind it, is no less far.
//   apart, else   two statements with one direction, one with a, one with b as the least far vertex: then a and b are
//                 equally far, so the direction is across the line, and the whole line is as far; so is what is on the
//                 side of c.
#pragma once

#include <cli/pair_planar_input.h>

#include <sunder/planar/pair/polygon_cut.h>
#include <sunder/planar/pair/polygon_half_plane.h>

#include <cstdint>
#include <optional>
#include <string>

namespace sunder::cli {

// A line, ray or half-plane in the world.
struct Unbounded {
  io::PlanarObject::Kind kind = io::PlanarObject::Kind::line;
  Point2 a, b;
  std::string name;
};

// The file, with the body as A and the unbounded object as B of each pair. meet: the answer. line_cut: what the line
// through a and b has in common with the body. witness: of a half-plane, as in polygon_half_plane.h.
// Throws Error bad_call where they meet, but not in the piece; or where no c is found.
std::string certificate_of_unbounded(const PlanarBody& body, const Unbounded& unbounded, bool meet,
                                     const planar::PolygonCut& line_cut, std::uint32_t witness);

// The image under the pose, if its coordinates are doubles. (Decided exactly.)
std::optional<Point2> exact_image(const planar::Pose& pose, const Point2& p);

}  // namespace sunder::cli
