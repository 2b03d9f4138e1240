// Certificates about lines, rays and half-planes (docs/claims.md, "pair"): each is one body, of a point and the ways
// that go on from it, so that what is said of it is said of the whole.
#pragma once

#include <sunder/ask/pair/pair_planar_input.h>

#include <sunder/certificate/origin.h>
#include <sunder/planar/pair/polygon_cut.h>
#include <sunder/planar/pair/polygon_half_plane.h>

#include <cstdint>
#include <optional>
#include <string>

namespace sunder::ask {

// A line, ray or half-plane in the world.
struct Unbounded {
  io::PlanarObject::Kind kind = io::PlanarObject::Kind::line;
  Point2 a, b;
  std::string name;
};

// What was found.
struct UnboundedAnswer {
  Contact contact = Contact::none;
  bool tells_contact = false;  // else only whether they meet is stated
  planar::PolygonCut cut;      // by the line or ray; by the half-plane's line
  planar::PolygonCut of_line;  // by the line through a and b
  std::uint32_t witness = 0;   // of a half-plane, as in polygon_half_plane.h
};

// Of a body and what a line has in common with it. A vertex is its own relative interior; a segment's is without its
// ends, a ray's without its beginning.
Contact contact_of(const planar::PolygonCut& cut, std::uint32_t vertices);

// The file, with the body as A and the unbounded object as B of the pair. Requires a true answer.
std::string certificate_of_unbounded(const PlanarBody& body, const Unbounded& unbounded, const UnboundedAnswer& answer,
                                     const Origin& origin = {});

// The image under the pose, if its coordinates are doubles. (Decided exactly.)
std::optional<Point2> exact_image(const planar::Pose& pose, const Point2& p);

}  // namespace sunder::ask
