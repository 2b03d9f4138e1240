#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_point.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace sunder::solid {
namespace {

struct Given {
  std::vector<Point3> points;
  std::vector<std::vector<std::uint32_t>> faces;

  Mesh mesh() const {
    std::vector<std::uint32_t> begin{0}, corners;
    for (const auto& face : faces) {
      corners.insert(corners.end(), face.begin(), face.end());
      begin.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    return Mesh(MeshView{points, begin, corners});
  }
  // With another one's points and faces.
  Given& add(const Given& other) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (std::vector<std::uint32_t> face : other.faces) {
      for (std::uint32_t& corner : face) corner += first;
      faces.push_back(face);
    }
    return *this;
  }
};

// A box whose faces are turned outwards, or inwards.
Given box(const Point3& low, const Point3& high, bool outwards = true) {
  Given given;
  for (std::uint32_t k = 0; k < 8; ++k) {
    given.points.push_back({(k & 1 ? high : low).x, (k & 2 ? high : low).y, (k & 4 ? high : low).z});
  }
  given.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  if (!outwards) {
    for (auto& face : given.faces) face = {face.rbegin(), face.rend()};
  }
  return given;
}

MeshPlace place_of(const Mesh& mesh, const Point3& p) { return mesh_point(mesh, Pose(), p).place; }

TEST(Mesh, ABoxIsOnePieceThatIsClosed) {
  const Mesh mesh = box({0, 0, 0}, {1, 1, 1}).mesh();
  EXPECT_EQ(mesh.points().size(), 8u);
  EXPECT_EQ(mesh.triangles().size(), 12u);
  ASSERT_EQ(mesh.pieces().size(), 1u);
  EXPECT_EQ(mesh.pieces()[0].kind, PieceKind::oriented);
  EXPECT_EQ(mesh.pieces()[0].triangles, 12u);
  EXPECT_TRUE(mesh.is_closed() && mesh.has_inside() && mesh.is_by_winding());
  std::array<int, 6> of_face{};
  for (std::uint32_t t = 0; t < 12; ++t) ++of_face.at(mesh.face_of(t));
  EXPECT_EQ(of_face, (std::array<int, 6>{2, 2, 2, 2, 2, 2}));
}

TEST(Mesh, EqualPointsAreOne) {
  Given given = box({0, 0, 0}, {1, 1, 1}), soup;
  for (const auto& face : given.faces) {
    Given one;
    for (const std::uint32_t corner : face) one.points.push_back(given.points[corner]);
    one.faces = {{0, 1, 2, 3}};
    soup.add(one);
  }
  soup.points.push_back({5, 5, 5});  // in no face
  soup.faces.push_back({0, 0, 1, 1, 0});
  const Mesh mesh = soup.mesh();
  EXPECT_EQ(mesh.points().size(), 8u);
  EXPECT_EQ(mesh.triangles().size(), 13u);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.box().high, (Point3{1, 1, 1}));
}

TEST(Mesh, WithoutAFaceItIsOpen) {
  Given given = box({0, 0, 0}, {1, 1, 1});
  given.faces.pop_back();
  const Mesh mesh = given.mesh();
  ASSERT_EQ(mesh.pieces().size(), 1u);
  EXPECT_EQ(mesh.pieces()[0].kind, PieceKind::open);
  EXPECT_EQ(mesh.pieces()[0].open_edges, 4u);
  EXPECT_FALSE(mesh.is_closed() || mesh.has_inside());
  EXPECT_EQ(place_of(mesh, {0.5, 0.5, 0.5}), MeshPlace::outside);
  EXPECT_EQ(place_of(mesh, {0.5, 0.5, 0}), MeshPlace::on);
}

TEST(Mesh, OneFaceTurnedInwardsLeavesAParity) {
  Given given = box({0, 0, 0}, {1, 1, 1});
  given.faces[2] = {given.faces[2].rbegin(), given.faces[2].rend()};
  const Mesh mesh = given.mesh();
  EXPECT_EQ(mesh.pieces()[0].kind, PieceKind::unoriented);
  EXPECT_TRUE(mesh.is_closed() && mesh.has_inside());
  EXPECT_FALSE(mesh.is_by_winding());
  for (int k = 0; k < 7 * 7 * 7; ++k) {  // from all sides, so that some segments go through that face
    const Point3 p{0.375 * (k % 7) - 0.6, 0.375 * (k / 7 % 7) - 0.6, 0.375 * (k / 49) - 0.6};
    const auto is_within = [](double x) { return x > 0 && x < 1; };
    const bool is_inside = is_within(p.x) && is_within(p.y) && is_within(p.z);
    EXPECT_EQ(place_of(mesh, p), is_inside ? MeshPlace::inside : MeshPlace::outside) << k;
  }
}

// A side of the top is cut in three, and the top is not; on one line a corner more.
TEST(Mesh, TJunctionsAreClosed) {
  Given given = box({0, 0, 0}, {3, 3, 3});
  given.points.push_back({1, 0, 3});
  given.points.push_back({2, 0, 3});
  given.faces[2] = {0, 1, 5, 9, 8, 4};
  const Mesh mesh = given.mesh();
  ASSERT_EQ(mesh.pieces().size(), 1u);
  EXPECT_EQ(mesh.pieces()[0].kind, PieceKind::oriented);
  EXPECT_EQ(mesh.pieces()[0].t_junctions, 2u);
  EXPECT_EQ(place_of(mesh, {1, 1, 1}), MeshPlace::inside);
  Given mirrored = given;  // the edge that is cut goes the other way
  for (Point3& p : mirrored.points) p.x = -p.x;
  EXPECT_EQ(mirrored.mesh().pieces()[0].kind, PieceKind::oriented);
  given.points.back().y = 0x1p-52;  // off the line by a last bit
  EXPECT_EQ(given.mesh().pieces()[0].kind, PieceKind::open);
}

// The lower half of a box has the four sides as they are, the upper one in halves.
TEST(Mesh, PiecesAreConnectedWhereCornersCutEdges) {
  Given given;
  given.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}};
  given.faces = {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3}};
  const Mesh mesh = given.mesh();
  ASSERT_EQ(mesh.pieces().size(), 1u);
  EXPECT_EQ(mesh.pieces()[0].kind, PieceKind::oriented);
  EXPECT_EQ(mesh.pieces()[0].t_junctions, 1u);
}

TEST(Mesh, OnePieceByASingleCorner) {
  const Given last{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {6, 5, 0}}, {{0, 1, 2}, {3, 4, 2}}};
  EXPECT_EQ(last.mesh().pieces().size(), 1u);
  // The edge of one lies within that of the other, and no corner is common.
  const Given cut{{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 1}}, {{0, 1, 2}, {3, 4, 5}}};
  ASSERT_EQ(cut.mesh().pieces().size(), 1u);
  EXPECT_EQ(cut.mesh().pieces()[0].t_junctions, 2u);
}

TEST(Mesh, PiecesShareNoPoint) {
  Given given = box({0, 0, 0}, {1, 1, 1});
  given.add(box({2, 0, 0}, {3, 1, 1}));
  given.add({{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}}});
  const Mesh mesh = given.mesh();
  ASSERT_EQ(mesh.pieces().size(), 3u);
  EXPECT_EQ(mesh.pieces()[2].kind, PieceKind::open);
  EXPECT_EQ(mesh.pieces()[2].triangles, 1u);
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    EXPECT_EQ(mesh.points()[mesh.triangles()[t][0]].x < 2, mesh.piece_of(t) == 0) << t;
    EXPECT_GE(t, mesh.pieces()[mesh.piece_of(t)].first);
  }
  EXPECT_EQ(mesh.piece_of(mesh.pieces()[1].first), 1u);
  EXPECT_TRUE(mesh.has_inside());
  EXPECT_FALSE(mesh.is_closed());
}

TEST(Mesh, FacesWithoutAreaAreBalanced) {
  Given given = box({0, 0, 0}, {1, 1, 1});
  given.points.push_back({0.5, 0, 0});
  given.faces.push_back({0, 8, 1});
  EXPECT_TRUE(given.mesh().is_closed());
}

TEST(Mesh, AFaceThatCrossesItselfIsNamed) {
  Given given;
  given.points = {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 5, 0}};
  given.faces = {{0, 1, 2}, {0, 1, 2, 3}};
  const Mesh mesh = given.mesh();
  ASSERT_EQ(mesh.crossing_faces().size(), 1u);
  EXPECT_EQ(mesh.crossing_faces()[0], 1u);
}

TEST(Mesh, WithoutFacesIsRefused) {
  Given given;
  given.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(given.mesh(), Error);
  const auto wrong = [&](const std::vector<std::uint32_t>& face) {
    Given bad = given;
    bad.faces = {{0, 1, 2}, face};
    try {
      static_cast<void>(bad.mesh());
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(wrong({}), "face 1: it has no corner; leave it out");
  EXPECT_EQ(wrong({0, 1, 7}), "face 1: it names vertex 7, which is not there");
  given.points[1].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(wrong({0, 1, 2}), "vertex 1: a coordinate is not finite; give finite ones");
}

TEST(MeshPoint, WindingsOfCavitiesAndOfTwoBoxesInOne) {
  Given hollow = box({0, 0, 0}, {4, 4, 4}), twice = hollow;
  const Mesh with_cavity = hollow.add(box({1, 1, 1}, {3, 3, 3}, false)).mesh();
  const Mesh of_two = twice.add(box({1, 1, 1}, {3, 3, 3})).mesh();
  EXPECT_EQ(mesh_point(with_cavity, Pose(), Point3{2, 2, 2}).winding, 0);
  EXPECT_EQ(mesh_point(with_cavity, Pose(), Point3{0.5, 2, 2}).winding, 1);
  EXPECT_EQ(mesh_point(of_two, Pose(), Point3{2, 2, 2}).winding, 2);
  EXPECT_EQ(mesh_point(of_two, Pose(), Point3{2, 2, 5}).winding, 0);
  EXPECT_FALSE(mesh_point(of_two, Pose(), Point3{2, 2, 4}).winding.has_value());
}

// A few last bits wide; and as wide as the doubles, or wider.
TEST(MeshPoint, OfMeshesAtTheEndsOfTheRange) {
  for (const double x : {1.0, 2.0, 3.0, 7.0, 64.0}) {
    const double low = 1 - x * 0x1p-52, high = 1 + x * 0x1p-52;
    const Mesh mesh = box({low, low, low}, {high, high, high}).mesh();
    EXPECT_EQ(place_of(mesh, {1, 1, 1}), MeshPlace::inside) << x;
    EXPECT_EQ(place_of(mesh, {1, 1, 2}), MeshPlace::outside) << x;
  }
  const Mesh five = box({-1, -1, -1}, {4, 4, 4}).mesh();
  const Pose tiny = Pose::from_matrix({1e-200, 0, 0, 0, 1e-200, 0, 0, 0, 1e-200}, {2, 3, 3});
  EXPECT_EQ(mesh_point(five, tiny, posed({0, 0, 0}, tiny.affine())).place, MeshPlace::inside);
  EXPECT_EQ(mesh_point(five, tiny, posed({5, 0, 0}, tiny.affine())).place, MeshPlace::outside);
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_EQ(place_of(box({-most, -most, -most}, {most, most, most}).mesh(), {0.3, 0.2, 0.1}), MeshPlace::inside);
  EXPECT_EQ(place_of(box({0, 0, 0}, {most, most, most}).mesh(), {-1, -1, -1}), MeshPlace::outside);
  const Mesh two = box({0, 0, 0}, {2, 2, 2}).mesh();
  const Pose huge = Pose::from_matrix({0x1p1023, 0, 0, 0, 0x1p1023, 0, 0, 0, 0x1p1023}, {0, 0, 0});
  EXPECT_EQ(mesh_point(two, huge, posed({1, 1.25, 1.5}, huge.affine())).place, MeshPlace::inside);
  EXPECT_FALSE(mesh_mesh(box({0, 0, 0}, {1, 1, 1}).mesh(), Pose(), box({2, 2, 2}, {4, 4, 4}).mesh(), huge).meet());
}

// The last bit of a coordinate that is subnormal, times 2^1000.
TEST(MeshPoint, BoxesOfNodesHoldWhatHalvingLoses) {
  const double a = 5e-324;
  const Given thin{{{a, 0, 0}, {a, 1e-300, 0}, {a, 0, 1e-300}}, {{0, 1, 2}}},
      other{{{0x1p-74, 0, 0}, {0x1p-74, 1, 0}, {0x1p-74, 0, 1}}, {{0, 1, 2}}};
  const Pose pose = Pose::from_matrix({0x1p1000, 0, 0, 0, 0x1p1000, 0, 0, 0, 0x1p1000}, {0, 0, 0});
  EXPECT_TRUE(mesh_mesh_by_scan(thin.mesh(), pose, other.mesh(), Pose()).meet());
  EXPECT_TRUE(mesh_mesh(thin.mesh(), pose, other.mesh(), Pose()).meet());
  EXPECT_EQ(mesh_point(thin.mesh(), pose, Point3{0x1p-74, 0, 0}).place, MeshPlace::on);
}

TEST(MeshPoint, SegmentsThatTouchTellNothing) {
  const Mesh mesh = box({0, 0, 0}, {2, 2, 2}).mesh();
  const Pose pose;
  const PlacedMesh placed(mesh, pose);
  const auto along = [&](const Point3& from, const Point3& to) {
    Cost cost;
    return crossings_along(placed, posed(from, pose.affine()), posed(to, pose.affine()), cost);
  };
  const Point3 inner{1, 1.25, 0.5};
  EXPECT_EQ(along(inner, {1.25, 1.5, 9}), 1);
  EXPECT_EQ(along({1.25, 1.5, 9}, inner), -1);
  EXPECT_EQ(along({1.25, 1.5, 9}, {1.5, 1.375, -9}), 0);
  EXPECT_FALSE(along(inner, {9, 1.25, 12.5}));  // the edge x = z = 2
  EXPECT_FALSE(along(inner, {2, 2, 2}));        // a corner
  EXPECT_FALSE(along({2, 0.5, 0.25}, inner));   // from a face
  EXPECT_FALSE(along({-1, 0, 1}, {3, 0, 1}));   // in a face
}

// A mirrored box winds the other way around its points, and has the same inside.
TEST(MeshPoint, UnderPoses) {
  const Mesh mesh = box({0, 0, 0}, {1, 1, 1}).mesh();
  const Pose mirrored = Pose::from_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, {10, 0, 0});
  EXPECT_EQ(mesh_point(mesh, mirrored, Point3{9.5, 0.5, 0.5}).winding, -1);
  EXPECT_EQ(mesh_point(mesh, mirrored, Point3{10.5, 0.5, 0.5}).winding, 0);
  for (const double size : {0x1p-900, 0x1p-300, 0x1p300, 0x1p900}) {
    const Mesh scaled = box({0, 0, 0}, {size, size, size}).mesh();
    EXPECT_EQ(place_of(scaled, {size / 2, size / 3, size / 5}), MeshPlace::inside) << size;
    EXPECT_EQ(place_of(scaled, {size * 2, size / 3, size / 5}), MeshPlace::outside) << size;
    EXPECT_EQ(place_of(scaled, {size, size / 3, size / 5}), MeshPlace::on) << size;
  }
}

TEST(MeshMesh, InsideOfEachOther) {
  Given given = box({0, 0, 0}, {4, 4, 4});
  const Mesh outer = given.mesh(), small = box({1, 1, 1}, {2, 2, 2}).mesh(),
             hollow = given.add(box({0.5, 0.5, 0.5}, {3, 3, 3}, false)).mesh();
  const MeshAnswer within = mesh_mesh(outer, Pose(), small, Pose());
  ASSERT_TRUE(within.meet());
  EXPECT_FALSE(std::get<PointWithin>(within.evidence).is_of_a);
  EXPECT_FALSE(mesh_mesh(hollow, Pose(), small, Pose()).meet());  // in its cavity
  EXPECT_FALSE(mesh_mesh_by_scan(small, Pose(), hollow, Pose()).meet());
  const MeshAnswer touch = mesh_mesh(hollow, Pose(), small, Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {1, 0, 0}));
  EXPECT_TRUE(std::holds_alternative<MeetingTriangles>(touch.evidence));
  Given two = box({9, 9, 9}, {10, 10, 10});  // the second piece is inside
  const Mesh of_two = two.add(box({1, 1, 1}, {2, 2, 2})).mesh();
  EXPECT_TRUE(mesh_mesh(of_two, Pose(), outer, Pose()).meet());
  EXPECT_TRUE(mesh_mesh(outer, Pose(), of_two, Pose()).meet());
  EXPECT_EQ(name_of(MeshPlace::on), "on");
  EXPECT_EQ(name_of(PieceKind::unoriented), "unoriented");
}

}  // namespace
}  // namespace sunder::solid
