#include <sunder/base/random.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/tree/face_trees.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace sunder::polytope {
namespace {

Polytope face_ball(Random& random, std::size_t d, std::size_t count) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count;) {
    std::vector<double> p(d);
    for (double& x : p) x = random.uniform(-1, 1);
    const double square = std::inner_product(p.begin(), p.end(), p.begin(), 0.0);
    if (square > 1 || square < 0.01) continue;
    ++k;
    for (const double x : p) rows.push_back(x / std::sqrt(square));
  }
  return Polytope::from_points(d, std::move(rows));
}

// Down a tree by any directions, each another: of the faces that reach beyond the nets of all nodes on the way, along
// the direction that was asked there, the leaf has all vertices (G1).
void expect_faces_are_kept(const FaceTree& tree, bool has_origin, std::vector<std::vector<std::uint32_t>> faces,
                           Random& random) {
  const std::size_t d = tree.dimension();
  std::uint32_t node = 0;
  while (tree.node(node).cones > 0) {
    std::vector<double> u(d);
    for (double& x : u) x = random.uniform(-1, 1);
    const auto along = [&](std::uint32_t v) {
      return std::inner_product(u.begin(), u.end(), tree.point(v).begin(), 0.0);
    };
    double most = has_origin ? 0 : -1e300;
    for (const std::uint32_t v : tree.vertices(tree.node(node))) most = std::max(most, along(v));
    std::erase_if(faces, [&](const std::vector<std::uint32_t>& face) {
      return std::none_of(face.begin(), face.end(), [&](std::uint32_t v) { return along(v) > most; });
    });
    Cost cost;
    node = tree.child_towards(tree.node(node), u, cost);
    EXPECT_GT(cost.probes, 0u);
    EXPECT_LE(faces.size(), tree.node(node).faces);
  }
  const auto leaf = tree.vertices(tree.node(node));
  const std::set<std::uint32_t> has(leaf.begin(), leaf.end());
  for (const auto& face : faces) {
    for (const std::uint32_t v : face) EXPECT_TRUE(has.contains(v));
  }
}

TEST(FaceTrees, NoFaceThatReachesBeyondANetIsLost) {
  Random random(1);
  for (const auto& [d, count] : {std::pair<std::size_t, std::size_t>{2, 400}, {3, 200}, {4, 40}}) {
    const Polytope body = face_ball(random, d, count);
    const std::uint32_t net = d == 4 ? 6 : 12;
    const FaceTrees trees(body, FaceTreesOf::both,
                          {.net = net, .leaf = 16, .share = 0.98, .levels = 5 - static_cast<std::uint32_t>(d)});
    const ConvexHull hull = convex_hull(body);
    const std::uint32_t common = hull.vertices[0];
    std::vector<std::vector<std::uint32_t>> simplices, at(body.size());
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      const auto corners = hull.facet_vertices(f);
      for (const std::uint32_t v : corners) at[v].push_back(f);
      if (std::binary_search(corners.begin(), corners.end(), common)) continue;
      for (std::size_t k = 0; k < hull.simplices(f).size(); k += d) {
        const auto simplex = hull.simplices(f).subspan(k, d);
        simplices.emplace_back(simplex.begin(), simplex.end());
      }
    }
    EXPECT_GE(trees.faces()->depth(), 1u) << d;
    EXPECT_GE(trees.polar()->depth(), 1u) << d;
    EXPECT_EQ(trees.faces()->face_count(), simplices.size());
    for (int turn = 0; turn < 60; ++turn) {
      expect_faces_are_kept(*trees.faces(), false, simplices, random);
      expect_faces_are_kept(*trees.polar(), true, at, random);
    }
  }
}

// Facet f of the body is q . y <= 1 for vertex q of the polar.
TEST(FaceTrees, ThePolarIsThatOfThePlacedBody) {
  Random random(2);
  for (std::size_t d = 2; d <= 5; ++d) {
    const Polytope body = face_ball(random, d, 20);
    const FaceTrees trees(body);
    EXPECT_TRUE(trees.is_full());
    const ConvexHull hull = convex_hull(body);
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      const auto corners = trees.corners_of(f);
      for (std::uint32_t k = 0; k < body.size(); ++k) {
        double sum = 0;
        for (std::size_t c = 0; c < d; ++c) {
          sum += trees.polar()->point(f)[c] * std::ldexp(body.row(k)[c] - trees.center(c), -trees.unit(c));
        }
        const bool is_on = std::find(corners.begin(), corners.end(), k) != corners.end();
        EXPECT_LE(sum, is_on ? 1 + 1e-9 : 1.0);
        EXPECT_GE(sum, is_on ? 1 - 1e-9 : -1e9);
      }
    }
    EXPECT_EQ(trees.center_rows().size(), d + 1);
  }
  const FaceTrees flat(Polytope::from_points(3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}));
  EXPECT_FALSE(flat.is_full());
  EXPECT_FALSE(flat.polar());
  EXPECT_EQ(flat.faces()->depth(), 0u);
  EXPECT_EQ(flat.faces()->largest_leaf(), 4u);
}

// A tree that would take too much is refused with what it would need, and soon: a lattice of five dimensions, whose
// walks take too many looks; a large body of four, whose lists are long; one of five with too many facets.
TEST(FaceTreesComplexity, AreRefusedWithWhatTheyWouldNeed) {
  Random random(3);
  std::vector<double> lattice;
  for (int k = 0; k < 250 * 5; ++k) lattice.push_back(static_cast<double>(random.between(-2, 2)));
  const auto refusal = [](const Polytope& body, const FaceTreeOptions& options) {
    const std::clock_t begin = std::clock();
    std::string said;
    try {
      const FaceTrees trees(body, FaceTreesOf::faces, options);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_shape);
      said = error.what();
    }
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10) << said;
    return said;
  };
  EXPECT_NE(refusal(Polytope::from_points(5, lattice), {}).find(" of 250 "), std::string::npos);
  const std::string long_lists = refusal(face_ball(random, 4, 500), {.leaf = 50, .most_looks = 20'000'000});
  EXPECT_NE(long_lists.find("the tree of the faces of 500 points of dimension 4 takes "), std::string::npos);
  EXPECT_NE(long_lists.find("more than the "), std::string::npos) << long_lists;
  const std::string facets = refusal(face_ball(random, 5, 100), {.most_facets = 1000});
  EXPECT_NE(facets.find("more than the 1000 simplices that it may"), std::string::npos);
}

}  // namespace
}  // namespace sunder::polytope
