// Writes sections of a placed polyhedron by planes into a certificate file (docs/claims.md, "Sections"): the body, what
// its hull is, then a statement `section` for each, with the area of a polygon (section_area.h).
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/solid/section/polyhedron_plane_section.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunder::solid {

class SectionClaims {
 public:
  // Writes the table of bodies, and, with the first section that wants it, the hull. Keeps references to the file and
  // the body. An empty name is written as "unnamed".
  SectionClaims(ClaimsWriter& file, const std::string& name, const ConvexPolyhedron& body, const Pose& pose);

  // Requires the section of this body by this plane. Time: linear in the corners, and in the degrees of those that are
  // vertices.
  void add(const Plane& plane, const PlaneSection& section);

 private:
  bool is_touching(const PlaneSection& section) const;
  std::vector<std::uint32_t> facets_along(const Plane& plane, const PlaneSection& section) const;
  std::vector<std::uint32_t> facets_at(const SectionCorner& corner) const;
  bool is_in_plane(const Plane& plane, std::uint32_t facet) const;

  ClaimsWriter& file_;
  const ConvexPolyhedron& body_;
  Pose given_pose_;
  Affine3 pose_;
  std::uint32_t placed_ = 0;  // its index in the table
  bool has_hull_ = false;
};

}  // namespace sunder::solid
