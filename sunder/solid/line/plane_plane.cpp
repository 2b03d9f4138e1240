#include <sunder/number/dyadic.h>
#include <sunder/predicate/line/arrows.h>
#include <sunder/solid/line/flat_body.h>
#include <sunder/solid/line/plane_plane.h>

#include <array>
#include <utility>

namespace sunder::solid {

FlatCommon plane_plane(const Plane& a, const Plane& b) {
  StageTally tally;
  FlatCommon common{{FlatKind::line, Relation::overlapping}};
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {2, 0}}) {
    ++common.cost.probes;
    if (cross_2d(Point2{}, Point2{a.normal[i], a.normal[j]}, Point2{}, Point2{b.normal[i], b.normal[j]}, &tally) ==
        Sign::zero)
      continue;
    conclude(common, tally.exact);
    return common;
  }
  // Parallel: one where levels are as normals are. Exact.
  ++common.cost.probes;
  const std::size_t k = a.normal.x != 0 ? 0 : a.normal.y != 0 ? 1 : 2;
  const bool same = level(a) * Dyadic(b.normal[k]) == level(b) * Dyadic(a.normal[k]);
  common.evidence = same ? FlatContact{FlatKind::plane, Relation::overlapping} : FlatContact{};
  conclude(common, tally.exact + 1);
  return common;
}

}  // namespace sunder::solid
