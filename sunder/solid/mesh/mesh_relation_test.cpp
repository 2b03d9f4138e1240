// The table of mesh_relation.h, a case for each row, and what is not told.
#include <sunder/solid/mesh/mesh_relation.h>

#include <sunder/solid/mesh/mesh_partition.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder::solid {
namespace {

struct Boxes {
  std::vector<Point3> points;
  std::vector<std::uint32_t> begin{0}, corners;

  Boxes& face(const std::vector<std::uint32_t>& of) {
    corners.insert(corners.end(), of.begin(), of.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
    return *this;
  }
  Boxes& box(const Point3& low, const Point3& high, bool outwards = true) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t k = 0; k < 8; ++k) {
      points.push_back({(k & 1 ? high : low).x, (k & 2 ? high : low).y, (k & 4 ? high : low).z});
    }
    for (std::vector<std::uint32_t> f : {std::vector<std::uint32_t>{0, 2, 3, 1},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 6, 7, 3},
                                         {0, 4, 6, 2},
                                         {1, 3, 7, 5}}) {
      if (!outwards) f = {f.rbegin(), f.rend()};
      for (std::uint32_t& corner : f) corner += first;
      face(f);
    }
    return *this;
  }
  Boxes& triangle(const Point3& p, const Point3& q, const Point3& r) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), {p, q, r});
    return face({first, first + 1, first + 2});
  }
  Mesh mesh() const { return Mesh(MeshView{points, begin, corners}); }
};

Mesh box_mesh(const Point3& low, const Point3& high) { return Boxes().box(low, high).mesh(); }

MeshRelation relation_between(const Mesh& a, const Mesh& b, const Pose& pose = {}) {
  return mesh_relation(a, pose, b, pose, mesh_mesh(a, pose, b, pose));
}

void expect_relation(const Mesh& a, const Mesh& b, Relation wanted, Relation back) {
  for (const Pose& pose : {Pose(), Pose::from_quaternion(0.3, -0.2, 0.7, 1, {5, 6, 7}),
                           Pose::from_matrix({-2, 1, 0, 0, 3, 0.1, 1, 0, 1}, {0.1, 0.2, 0.3})}) {
    const MeshRelation found = relation_between(a, b, pose), other = relation_between(b, a, pose);
    EXPECT_TRUE(found.is_known && other.is_known);
    EXPECT_EQ(name_of(found.relation), name_of(wanted));
    EXPECT_EQ(name_of(other.relation), name_of(back));
    EXPECT_EQ(found.inside.has_value(), wanted == Relation::overlapping);
    const bool by_planes = wanted == Relation::touching || wanted == Relation::equal ||
                           wanted == Relation::a_part_of_b || wanted == Relation::b_part_of_a;
    EXPECT_EQ(found.partition.has_value(), by_planes);
  }
}

TEST(MeshRelation, EachRowOfTheTable) {
  const Mesh unit = box_mesh({0, 0, 0}, {1, 1, 1});
  expect_relation(unit, box_mesh({2, 0, 0}, {3, 1, 1}), Relation::none, Relation::none);
  expect_relation(unit, box_mesh({1, 0, 0}, {2, 1, 1}), Relation::touching, Relation::touching);
  expect_relation(unit, box_mesh({1, 1, 0.5}, {2, 2, 3}), Relation::touching, Relation::touching);
  expect_relation(unit, box_mesh({1, 1, 1}, {2, 2, 2}), Relation::touching, Relation::touching);
  expect_relation(unit, box_mesh({0.5, 0.5, 0.5}, {2, 2, 2}), Relation::overlapping, Relation::overlapping);
  expect_relation(unit, box_mesh({-1, 0.25, 0.25}, {2, 0.75, 0.75}), Relation::overlapping, Relation::overlapping);
  expect_relation(box_mesh({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}), unit, Relation::a_inside_b, Relation::b_inside_a);
  expect_relation(box_mesh({0, 0.25, 0.25}, {0.75, 0.75, 0.75}), unit, Relation::a_part_of_b, Relation::b_part_of_a);
  expect_relation(unit, unit, Relation::equal, Relation::equal);
  // The same inside by other triangles, and with a wall within.
  expect_relation(Boxes().box({0, 0, 0}, {0.5, 1, 1}).box({0.5, 0, 0}, {1, 1, 1}).mesh(), unit, Relation::equal,
                  Relation::equal);
}

TEST(MeshRelation, ToTheLastBit) {
  const Mesh unit = box_mesh({0, 0, 0}, {1, 1, 1});
  const double before = std::nextafter(1.0, 0.0), after = std::nextafter(1.0, 2.0);
  EXPECT_EQ(relation_between(unit, box_mesh({before, 0, 0}, {2, 1, 1})).relation, Relation::overlapping);
  EXPECT_EQ(relation_between(unit, box_mesh({1, 0, 0}, {2, 1, 1})).relation, Relation::touching);
  EXPECT_EQ(relation_between(unit, box_mesh({after, 0, 0}, {2, 1, 1})).relation, Relation::none);
  EXPECT_EQ(relation_between(unit, box_mesh({0, 0, 0}, {before, 1, 1})).relation, Relation::b_part_of_a);
  EXPECT_EQ(relation_between(unit, box_mesh({0, 0, 0}, {after, 1, 1})).relation, Relation::a_part_of_b);
  EXPECT_EQ(relation_between(unit, box_mesh({-1e-300, 0, 0}, {1, 1, 1})).relation, Relation::a_part_of_b);
}

TEST(MeshRelation, OfTinyAndVastMeshes) {
  for (const double size : {1e-300, 1e-150, 1e150, 1e300}) {
    const Mesh a = box_mesh({0, 0, 0}, {size, size, size}), b = box_mesh({size, 0, 0}, {2 * size, size, size});
    EXPECT_EQ(relation_between(a, b).relation, Relation::touching) << size;
    EXPECT_EQ(relation_between(a, a).relation, Relation::equal) << size;
  }
}

TEST(MeshRelation, OfCavities) {
  const Mesh shell = Boxes().box({0, 0, 0}, {4, 4, 4}).box({1, 1, 1}, {3, 3, 3}, false).mesh();
  expect_relation(shell, box_mesh({1, 1, 1}, {3, 3, 3}), Relation::touching, Relation::touching);
  expect_relation(shell, box_mesh({1.5, 1.5, 1.5}, {2.5, 2.5, 2.5}), Relation::none, Relation::none);
  expect_relation(shell, box_mesh({0.25, 0.25, 0.25}, {3.75, 3.75, 3.75}), Relation::overlapping,
                  Relation::overlapping);
  expect_relation(shell, box_mesh({0, 0, 0}, {4, 4, 4}), Relation::a_part_of_b, Relation::b_part_of_a);
}

TEST(MeshRelation, SurfacesMeetAndNoMoreIsTold) {
  const Mesh unit = box_mesh({0, 0, 0}, {1, 1, 1});
  const Mesh open = Boxes().triangle({0.5, 0.5, -1}, {0.5, 0.5, 2}, {3, 0.5, 0}).mesh();
  EXPECT_EQ(relation_between(unit, open).relation, Relation::meeting);
  const Mesh flat = Boxes().triangle({1, 0, 0}, {1, 1, 0}, {1, 0, 1}).triangle({1, 0, 0}, {1, 0, 1}, {1, 1, 0}).mesh();
  EXPECT_TRUE(flat.is_closed());
  EXPECT_EQ(relation_between(unit, flat).relation, Relation::meeting);
  // One mesh has an open piece, too. A point that is inside of both is found nevertheless.
  const Mesh mixed = Boxes().box({0.5, 0.5, 0.5}, {2, 2, 2}).triangle({9, 9, 9}, {9, 9, 8}, {9, 8, 9}).mesh();
  const MeshRelation found = relation_between(unit, mixed);
  EXPECT_EQ(found.relation, Relation::overlapping);
  EXPECT_FALSE(found.is_known);
  EXPECT_TRUE(found.inside.has_value());
}

// A fin of two triangles back to back has no inside: that it goes into the other solid is not told to be touching.
TEST(MeshRelation, OfSheets) {
  Boxes fin;
  fin.box({0, 0, 0}, {1, 1, 1});
  fin.triangle({1, 0, 0}, {3, 0.5, 0.5}, {1, 1, 0}).triangle({1, 0, 0}, {1, 1, 0}, {3, 0.5, 0.5});
  const Mesh mesh = fin.mesh();
  ASSERT_TRUE(mesh.is_closed());
  EXPECT_EQ(relation_between(mesh, box_mesh({2, 0, 0}, {4, 1, 1})).relation, Relation::meeting);
  EXPECT_EQ(relation_between(mesh, box_mesh({0.5, 0.5, 0.5}, {4, 1, 1})).relation, Relation::overlapping);
}

// Triangles without area do not count, wherever they are, and a cell's point is beside them.
TEST(MeshRelation, NeedlesDoNotCount) {
  Boxes needles;
  needles.box({0, 0, 0}, {1, 1, 1});
  for (const double x : {-0.5, 0.25, 0.5, 1.5}) {
    needles.triangle({x, -1, 0.5}, {x, 3, 0.5}, {x, -1, 0.5});
    needles.triangle({-1, x, 0.5}, {3, x, 0.5}, {1, x, 0.5});
  }
  const Mesh mesh = needles.mesh();
  ASSERT_TRUE(mesh.is_closed());
  expect_relation(mesh, box_mesh({1, 0, 0}, {2, 1, 1}), Relation::touching, Relation::touching);
  expect_relation(mesh, box_mesh({0, 0, 0}, {1, 1, 1}), Relation::equal, Relation::equal);
}

// A box goes into another one by 2^-53. Nothing is known before, so the tree finds all three kinds.
TEST(MeshPartition, FindsAPointThatIsInsideOfBoth) {
  const Mesh a = box_mesh({0, 0, 0}, {1, 1, 1}), b = box_mesh({1 - 0x1p-53, 0, 0}, {2, 1, 1});
  const Partitioned found = mesh_partition(a, {}, b, {}, {});
  EXPECT_TRUE(found.is_decided);
  EXPECT_TRUE(found.found.are_all());
  EXPECT_TRUE(found.in_both.has_value());
}

TEST(MeshPartition, WhatIsKnownIsNotAsked) {
  const Mesh a = box_mesh({0, 0, 0}, {1, 1, 1}), b = box_mesh({1, 0, 0}, {2, 1, 1});
  const Partitioned all = mesh_partition(a, {}, b, {}, {}), two = mesh_partition(a, {}, b, {}, {false, true, true});
  EXPECT_FALSE(all.found.both || two.found.both);
  EXPECT_TRUE(all.found.only_a && all.found.only_b);
  EXPECT_EQ(two.partition.planes.size(), 1u);
  EXPECT_EQ(two.partition.cells.size(), 2u);
  EXPECT_LE(two.cost.probes, all.cost.probes);
  for (const MeshPartition::Cell& cell : two.partition.cells) EXPECT_NE(cell.tells_a, cell.tells_b);
}

}  // namespace
}  // namespace sunder::solid
