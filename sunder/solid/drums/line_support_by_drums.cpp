// Which planes through a line support a body, by drums: each step of the search around the line is a search in slices
// for an extreme vertex (Lemmas 6 and 7).
#include <sunder/solid/line/line_support_search.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/drum_search.h>

namespace sunder::solid {

namespace {

struct FurthestByDrums {
  template <class Real>
  static std::uint32_t along(const Placed& body, const VectorOf<Real>& d, std::uint32_t, Cost& cost) {
    const Drums& drums = represent::of<Drums>(body.body);
    const Point3& by = drums.shrink();
    const VectorOf<Real> seen{d.x * Real(1 / by.x), d.y * Real(1 / by.y), d.z * Real(1 / by.z)};
    return DrumSearch(drums, body.body.vertices(), cost).furthest_vertex<Real>(seen, [](std::uint32_t) {
      return false;
    });
  }
};

}  // namespace

LineSupport polyhedron_line_support_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  return line_support_by(body, pose, line, polyhedron_line_by_drums(body, pose, line), FurthestByDrums{});
}

}  // namespace sunder::solid
