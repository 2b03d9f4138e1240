// One header has all front doors; nothing of one hides another.
#include <sunder/sunder.h>

#include <vector>

int main() {
  static_assert(sunder::version == "0.1.0" && SUNDER_VERSION_MAJOR == 0);
  const std::vector<sunder::Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const sunder::solid::ConvexPolyhedron body(corners);
  const bool bodies = sunder::intersect(body, {}, body, {}).meet();
  const auto square = sunder::planar::ConvexPolygon::from_vertices({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const bool polygons = sunder::intersect(square, {}, square, {}).meet();
  const bool wires = segments_any(sunder::planar::Segments({{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}})).meet();
  const bool discs = discs_any(sunder::planar::Discs({{{0, 0}, 1}, {{3, 0}, 1}})).meet();
  try {
    static_cast<void>(sunder::planar::Discs({{{0, 0}, -1}}));
  } catch (const sunder::Error&) {
    return bodies && polygons && wires && !discs ? 0 : 1;
  }
  return 1;
}
