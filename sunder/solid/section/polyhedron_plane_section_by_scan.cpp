// Every vertex's sign, then every facet's part of the section, joined end to end. Shares no code with the walk.
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/predicate/point/plane_sides.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/section/polyhedron_plane_section.h>

#include <algorithm>
#include <map>
#include <optional>

namespace sunder::solid {

namespace {

// The parts of facets that are not above the plane, along it: from each corner to the next.
class Joined {
 public:
  Joined(const ConvexPolyhedron& body, const std::vector<Sign>& signs) : signs_(signs) {
    for (std::uint32_t f = 0; f < body.facet_count(); ++f) add(body.facet(f));
  }

  // The one cycle, from its least corner; nothing where there is none.
  std::vector<SectionCorner> cycle() const {
    std::vector<SectionCorner> corners;
    if (next_.empty()) return corners;
    const SectionCorner first = next_.begin()->first;
    for (SectionCorner at = first; corners.empty() || at != first; at = next_.at(at)) corners.push_back(at);
    return corners;
  }

 private:
  bool is_below(std::uint32_t v) const { return signs_[v] == Sign::negative; }

  // What is below in a facet, which is convex, is entered once and left once: there, from end to start, runs the plane.
  void add(std::span<const std::uint32_t> facet) {
    std::optional<SectionCorner> entered, left;
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const std::uint32_t v = facet[k], w = facet[k + 1 < facet.size() ? k + 1 : 0];
      if (!is_below(v) && is_below(w)) entered = corner(v, w);
      if (is_below(v) && !is_below(w)) left = corner(w, v);
    }
    if (entered && left && *entered != *left) next_.emplace(*entered, *left);
  }

  SectionCorner corner(std::uint32_t not_below, std::uint32_t below) const {
    return signs_[not_below] == Sign::zero ? SectionCorner{not_below, not_below} : SectionCorner{not_below, below};
  }

  const std::vector<Sign>& signs_;
  std::map<SectionCorner, SectionCorner> next_;
};

void reverse_after_first(std::vector<SectionCorner>& corners) {
  if (!corners.empty()) std::reverse(corners.begin() + 1, corners.end());
}

}  // namespace

PlaneSection polyhedron_plane_section_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  const Placed placed(body, pose);
  const auto n = static_cast<std::uint32_t>(body.vertices().size());
  std::vector<Sign> signs;
  std::vector<SectionCorner> on_plane;
  std::uint32_t above = n, below = n;
  for (std::uint32_t v = 0; v < n; ++v) {
    signs.push_back(side_of_plane(plane.normal, plane.point, plane.offset, placed[v]));
    if (signs[v] == Sign::positive) above = v;
    if (signs[v] == Sign::negative) below = v;
    if (signs[v] == Sign::zero) on_plane.push_back({v, v});
  }
  PlaneSection section;
  section.decided_by = DecidedBy::scan;
  section.cost.probes = n;
  const auto conclude_with = [&](std::vector<SectionCorner> corners) {
    section.corners = std::move(corners);
    const std::size_t k = section.corners.size();
    section.kind = k == 0   ? SectionKind::nothing
                   : k == 1 ? SectionKind::point
                   : k == 2 ? SectionKind::segment
                            : SectionKind::polygon;
    return section;
  };
  if (on_plane.empty() && (above == n || below == n)) {
    section.side = below == n ? Sign::positive : Sign::negative;
    const WorldDirection normal(plane.normal);
    for (std::uint32_t v = 1; v < n; ++v) {
      if (compare_along(normal, placed[section.nearest], placed[v]) == -section.side) section.nearest = v;
    }
    return section;
  }
  if (n <= 2) return conclude_with(on_plane.empty() ? std::vector<SectionCorner>{{above, below}} : on_plane);
  if (above == n && below == n) {  // a flat one in the plane
    std::vector<SectionCorner> corners;
    for (const std::uint32_t v : body.facet(0)) corners.push_back({v, v});
    const Sign turn =
        turn_seen_from(plane.normal, placed[corners[0].above], placed[corners[1].above], placed[corners[2].above]);
    if (turn == Sign::negative) std::reverse(corners.begin(), corners.end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return conclude_with(std::move(corners));
  }
  // Where nothing is below, the plane is turned over: then there is; and the way round is the other one.
  const bool is_turned = below == n;
  if (is_turned) {
    for (Sign& sign : signs) sign = -sign;
  }
  std::vector<SectionCorner> corners = Joined(body, signs).cycle();
  if (corners.empty()) corners = on_plane;  // one vertex
  if (is_turned != (determinant_sign(placed.pose) == Sign::negative)) reverse_after_first(corners);
  return conclude_with(std::move(corners));
}

}  // namespace sunder::solid
