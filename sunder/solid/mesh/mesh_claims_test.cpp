#include <sunder/solid/mesh/face_mesh_test.h>
#include <sunder/solid/mesh/mesh_claims.h>
#include <sunder/solid/object/hull_claims.h>

#include <gtest/gtest.h>
#include <verifier/cpp/verify.h>

#include <string>
#include <vector>

namespace sunder::solid {
namespace {

bool is_claim_accepted(const MeshView& mesh, const ConvexPolyhedron& hull) {
  const std::string text = claims_text({}, [&](ClaimsWriter& file) {
    write_hull(file, "mesh", mesh.vertices, hull);
    write_mesh(file, mesh, hull);
  });
  return sunder_verifier::verify_text(text, "mesh").accepted();
}

bool is_proved(const FaceMesh& mesh) { return asked_of(mesh, is_claim_accepted); }

TEST(MeshClaims, OfConvexMeshesAlone) {
  FaceMesh cube{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {-0.0, 0, 0}},
                {{0, 4, 6, 2}, {1, 3, 7, 5}, {8, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  EXPECT_TRUE(is_proved(cube));
  cube.vertices.push_back({0.5, 0.5, 1});
  cube.faces.back() = {4, 5, 9};
  cube.faces.insert(cube.faces.end(), {{5, 7, 9}, {7, 6, 9}});
  EXPECT_FALSE(is_proved(cube));
  cube.faces.push_back({9, 4, 6});
  EXPECT_TRUE(is_proved(cube));
  cube.vertices.back().z = 0.75;
  EXPECT_FALSE(is_proved(cube));
}

}  // namespace
}  // namespace sunder::solid
