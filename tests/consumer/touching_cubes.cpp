// Two unit cubes that share one face meet; moved apart by the smallest step that doubles have there, they do not.
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <cmath>
#include <vector>

namespace {

sunder::solid::ConvexPolyhedron cube(double left) {
  std::vector<sunder::Point3> points;
  for (const double x : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) points.push_back({left + x, y, z});
    }
  }
  return sunder::solid::ConvexPolyhedron(points);
}

}  // namespace

int main() {
  const sunder::solid::ConvexPolyhedron first = cube(0);
  const sunder::solid::ConvexPolyhedron second = cube(1);
  std::vector<sunder::Point3> moved;
  for (const sunder::Point3& p : second.vertices()) {
    moved.push_back({p.x == 1 ? std::nextafter(1.0, 2.0) : p.x, p.y, p.z});
  }
  const bool touching = sunder::intersect(first, second).meet();
  const bool apart = !sunder::intersect(first, sunder::solid::ConvexPolyhedron(moved)).meet();
  return touching && apart ? 0 : 1;
}
