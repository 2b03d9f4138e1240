#include <bench/peers/sunder_regions.h>

#include <sunder/planar/object/constraints.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/discs.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>

#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace bench {
namespace {

using sunder::planar::Constraints;
using sunder::planar::ConvexPolygon;
using sunder::planar::Discs;
using sunder::planar::LinearProgramAnswer;
using sunder::planar::OneOptimum;
using sunder::planar::RegionKind;

std::shared_ptr<const Constraints> constraints_of(const RegionInput& input) {
  std::vector<sunder::Constraint> given;
  for (const Inequality& h : input.half_planes) given.push_back({h.a, h.b, h.c});
  return std::make_shared<const Constraints>(given);
}

Asked ask_half_planes(const RegionInput& input, bool evidence) {
  sunder::planar::RegionOptions options;
  options.evidence = evidence;
  return [given = constraints_of(input), options]() -> std::uint64_t {
    const sunder::planar::Region region = half_plane_intersection(*given, options);
    return region.kind == RegionKind::bounded ? region.sides.size() : 0;
  };
}

Asked ask_polygons(const RegionInput& input) {
  std::vector<ConvexPolygon> given;
  for (const Ring& ring : input.rings) {
    std::vector<sunder::Point2> points;
    for (const Xy& p : ring) points.push_back({p.x, p.y});
    given.push_back(ConvexPolygon::from_vertices(std::move(points)));
  }
  return [polygons = std::make_shared<const std::vector<ConvexPolygon>>(std::move(given))]() -> std::uint64_t {
    return convex_polygon_intersection(*polygons).corners.size();
  };
}

Asked ask_discs(const RegionInput& input) {
  std::vector<sunder::Disc> given;
  for (const Disc& d : input.discs) given.push_back({{d.center.x, d.center.y}, d.radius});
  return [circles = std::make_shared<const Discs>(given)]() -> std::uint64_t {
    return disc_intersection(*circles).arcs.size();
  };
}

std::uint64_t pair_of(const LinearProgramAnswer& answer) {
  const auto* const corner = std::get_if<OneOptimum>(&answer.evidence);
  return corner != nullptr ? bench::pair_of(corner->before, corner->after) : 0;
}

sunder::planar::Objective objective_of(const Objective& o) { return {o.x, o.y}; }

}  // namespace

Asked ask_sunder(const RegionInput& input) {
  if (!input.half_planes.empty()) return ask_half_planes(input, false);
  if (!input.discs.empty()) return ask_discs(input);
  return ask_polygons(input);
}

Asked ask_sunder_for_evidence(const RegionInput& input) { return ask_half_planes(input, true); }

Asked ask_sunder(const RegionInput& input, const Objective& objective) {
  return [given = constraints_of(input), asked = objective_of(objective)]() -> std::uint64_t {
    return pair_of(linear_program(*given, asked));
  };
}

Asked ask_sunder_by_region(const RegionInput& input, std::span<const Objective> objectives) {
  const auto given = constraints_of(input);
  std::vector<sunder::planar::Objective> asked;
  for (const Objective& o : objectives) asked.push_back(objective_of(o));
  const auto region = std::make_shared<const sunder::planar::Region>(half_plane_intersection(*given));
  return [given, region, prepared = sunder::planar::PreparedRegion(*given, *region),
          asked = std::move(asked)]() -> std::uint64_t {
    std::uint64_t sum = 0;
    for (const sunder::planar::Objective& o : asked) sum += pair_of(linear_program_by_region(prepared, o));
    return sum;
  };
}

}  // namespace bench
