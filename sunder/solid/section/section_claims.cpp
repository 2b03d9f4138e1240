#include <sunder/base/contract.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/solid/object/hull_claims.h>
#include <sunder/solid/represent/half_edges.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/section/section_area.h>
#include <sunder/solid/section/section_claims.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sunder::solid {

SectionClaims::SectionClaims(ClaimsWriter& file, const std::string& name, const ConvexPolyhedron& body,
                             const Pose& pose)
    : file_(file), body_(body), given_pose_(pose), pose_(pose.affine()) {
  const std::string text = name.empty() ? "unnamed" : cut_text(name);
  file_.begin_table("bodies");
  file_.begin_entry();
  file_.text("name", text);
  file_.begin_list("points");
  for (const Point3& p : body.vertices()) file_.add_row(std::array{p.x, p.y, p.z});
  file_.end_list();
  file_.end_entry();
  if (pose_ != Affine3()) {
    placed_ = 1;
    file_.begin_entry();
    file_.text("name", text);
    file_.index("of", 0);
    file_.doubles("linear", pose_.linear);
    file_.doubles("translation", pose_.translation);
    file_.end_entry();
  }
  file_.end_table();
}

void SectionClaims::add(const Plane& plane, const PlaneSection& section) {
  const bool is_nothing = section.kind == SectionKind::nothing;
  const bool is_outlined = !is_nothing && !is_touching(section);
  if (is_outlined && !has_hull_) {
    write_hull_of_vertices(file_, body_);
    has_hull_ = true;
  }
  const AreaBounds area = section_area(section, SectionPoints(body_, given_pose_, plane), plane.normal);
  const bool is_measured = section.kind == SectionKind::polygon && std::isfinite(area.high);
  file_.begin_statement("section");
  file_.index("of", placed_);
  const auto& [n, p, offset] = plane;
  file_.doubles("plane", std::array{n.x, n.y, n.z, p.x, p.y, p.z, offset});
  file_.text("verdict", is_nothing ? "nothing" : is_measured ? "measured" : is_outlined ? "outlined" : "touching");
  if (!is_nothing) {
    file_.begin_list("corners");
    for (const SectionCorner& corner : section.corners) file_.add_list(std::array{corner.above, corner.below});
    file_.end_list();
  }
  if (is_measured) {
    file_.real("area_from", area.low);
    file_.real("area_to", area.high);
  }
  file_.begin_claims();
  file_.begin_claim(is_nothing ? "beyond" : is_outlined ? "outlined" : "touches");
  if (is_outlined) file_.indices("along", facets_along(plane, section));
  file_.end_claim();
  if (is_measured) file_.claim("area");
  file_.end_statement();
}

// One or two vertices, and all others on one side: but two may be those between which a plane goes through a flat body.
bool SectionClaims::is_touching(const PlaneSection& section) const {
  const auto& corners = section.corners;
  if (corners.size() > 2 ||
      !std::all_of(corners.begin(), corners.end(), [](const SectionCorner& corner) { return corner.is_vertex(); })) {
    return false;
  }
  if (body_.dimension() != 2 || corners.size() == 1) return true;
  // Of a flat body: an edge, whose ends are neighbours.
  const auto around = body_.neighbours(corners[0].above);
  return std::find(around.begin(), around.end(), corners[1].above) != around.end();
}

// For each corner the facet that holds it and the next one, and is not in the plane.
std::vector<std::uint32_t> SectionClaims::facets_along(const Plane& plane, const PlaneSection& section) const {
  std::vector<std::uint32_t> along(section.corners.size(), 0);
  if (body_.dimension() != 3) return along;
  std::vector<std::uint32_t> here = facets_at(section.corners[0]);
  for (std::size_t k = 0; k < along.size(); ++k) {
    std::vector<std::uint32_t> next = facets_at(section.corners[k + 1 < along.size() ? k + 1 : 0]);
    const auto is_along = [&](std::uint32_t f) {
      return std::binary_search(next.begin(), next.end(), f) && !is_in_plane(plane, f);
    };
    const auto found = std::find_if(here.begin(), here.end(), is_along);
    SUNDER_REQUIRE(found != here.end());
    along[k] = *found;
    here = std::move(next);
  }
  return along;
}

// In order.
std::vector<std::uint32_t> SectionClaims::facets_at(const SectionCorner& corner) const {
  const HalfEdges& edges = represent::of<HalfEdges>(body_);
  const bool is_shorter = edges.degree(corner.above) <= edges.degree(corner.below);
  const std::uint32_t v = is_shorter ? corner.above : corner.below, w = is_shorter ? corner.below : corner.above;
  std::vector<std::uint32_t> facets;
  for (std::uint32_t k = edges.begin[v]; k < edges.begin[v + 1]; ++k) {
    const std::uint32_t e = edges.out[k];
    if (corner.is_vertex()) {
      facets.push_back(edges.facet[e]);
    } else if (edges.tip(e) == w) {
      facets = {edges.facet[e], edges.facet[edges.twin[e]]};
      break;
    }
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

bool SectionClaims::is_in_plane(const Plane& plane, std::uint32_t facet) const {
  const auto corners = body_.facet(facet).first(3);
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
    return side_of_plane(plane.normal, plane.point, plane.offset, posed(body_.vertices()[v], pose_)) == Sign::zero;
  });
}

}  // namespace sunder::solid
