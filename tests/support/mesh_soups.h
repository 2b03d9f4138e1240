// Meshes for tests: boxes and loose triangles with whole coordinates, and spheres with bumps.
#pragma once

#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::tests {

struct Soup {
  std::vector<Point3> points;
  std::vector<std::uint32_t> begin{0}, corners;

  void add_face(const std::vector<std::uint32_t>& face) {
    corners.insert(corners.end(), face.begin(), face.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  // A box of this size, turned inwards or outwards, perhaps without a face.
  void add_box(const Point3& low, const Point3& size, bool outwards, bool is_open) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t k = 0; k < 8; ++k) {
      points.push_back({low.x + (k & 1 ? size.x : 0), low.y + (k & 2 ? size.y : 0), low.z + (k & 4 ? size.z : 0)});
    }
    const std::array<std::array<std::uint32_t, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (std::size_t f = is_open ? 1 : 0; f < 6; ++f) {
      std::vector<std::uint32_t> face;
      for (const std::uint32_t corner : faces[f]) face.push_back(first + corner);
      if (!outwards) std::reverse(face.begin(), face.end());
      add_face(face);
    }
  }
  solid::Mesh mesh() const { return solid::Mesh(solid::MeshView{points, begin, corners}); }
};

// Some boxes with whole coordinates, and loose triangles.
inline Soup some_soup(Random& random) {
  Soup soup;
  const auto whole = [&](int low, int high) { return static_cast<double>(random.between(low, high)); };
  const std::uint64_t boxes = 1 + random.below(4);
  for (std::uint64_t k = 0; k < boxes; ++k) {
    soup.add_box({whole(-3, 3), whole(-3, 3), whole(-3, 3)}, {whole(1, 4), whole(1, 4), whole(1, 4)},
                 random.below(4) > 0, random.below(5) == 0);
  }
  const std::uint64_t loose = random.below(4);
  for (std::uint64_t k = 0; k < loose; ++k) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (int c = 0; c < 3; ++c) soup.points.push_back({whole(-4, 4), whole(-4, 4), whole(-4, 4)});
    soup.add_face({first, first + 1, first + 2});
  }
  return soup;
}

inline solid::Pose soup_pose(Random& random, int i) {
  const auto whole = [&] { return static_cast<double>(random.between(-5, 5)); };
  std::array<double, 3> shift{whole(), whole(), whole()};
  if (i % 3 == 1) shift[random.below(3)] += std::ldexp(random.below(2) == 0 ? 1.0 : -1.0, -50);
  if (i % 3 == 2) {
    return solid::Pose::from_quaternion(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1, shift);
  }
  return solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, shift);
}

// A 64th as large, somewhere.
inline solid::Pose small_pose(Random& random) {
  return solid::Pose::from_matrix({0x1p-6, 0, 0, 0, 0x1p-6, 0, 0, 0, 0x1p-6},
                                  {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)});
}

// A sphere with bumps.
inline solid::Mesh bumpy(std::size_t n, Random& random) {
  const solid::ConvexPolyhedron sphere(solid_shapes::sphere(n, random));
  Soup soup;
  for (const Point3& p : sphere.vertices()) {
    const double size = 1 + 0.1 * std::sin(9 * p.x + 1) * std::sin(8 * p.y) * std::sin(10 * p.z + 2);
    soup.points.push_back({p.x * size, p.y * size, p.z * size});
  }
  for (std::uint32_t f = 0; f < sphere.facet_count(); ++f) {
    soup.add_face({sphere.facet(f).begin(), sphere.facet(f).end()});
  }
  return soup.mesh();
}

// How far b has to be moved from a, to a millionth, until they are apart: at(t) is where it is. They meet at 1.5, and do not
// at 2.5.
template <class At>
double just_apart(const solid::Mesh& a, const solid::Mesh& b, const At& at) {
  double meeting = 1.5, apart = 2.5;
  while (apart - meeting > 1e-6) {
    const double middle = (meeting + apart) / 2;
    (mesh_mesh(a, solid::Pose(), b, at(middle)).meet() ? meeting : apart) = middle;
  }
  return apart;
}

}  // namespace sunder::tests
