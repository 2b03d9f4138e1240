// Straight-line drawings of graphs against the scan, and known ones.
#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/segments/drawing_plane.h>

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace sunder::planar {
namespace {

using Of = DrawingContact::Of;

TEST(DrawingPlaneTest, KnownDrawings) {
  // The complete graph of four vertices: with one inside of the triangle of the others, and as a square.
  const std::vector<DrawingEdge> all{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  EXPECT_FALSE(drawing_plane(std::array<Point2, 4>{{{0, 0}, {4, 0}, {0, 4}, {1, 1}}}, all).meet());
  const DrawingAnswer square = drawing_plane(std::array<Point2, 4>{{{0, 0}, {4, 0}, {0, 4}, {4, 4}}}, all);
  EXPECT_EQ(square.found->of, Of::edges);
  EXPECT_EQ(square.found->kind, ContactKind::crossing);
  EXPECT_EQ(square.found->i, 1u);
  EXPECT_EQ(square.found->j, 3u);

  const std::array<Point2, 3> three{{{0, 0}, {2, 2}, {1, 1}}};
  EXPECT_EQ(drawing_plane(three, std::array<DrawingEdge, 1>{{{0, 1}}}).found->of, Of::vertex_and_edge);
  EXPECT_EQ(drawing_plane(three, std::array<DrawingEdge, 1>{{{0, 1}}}).found->i, 2u);
  EXPECT_EQ(drawing_plane(three, std::array<DrawingEdge, 2>{{{0, 1}, {0, 2}}}).found->kind, ContactKind::overlap);
  EXPECT_FALSE(drawing_plane(three, std::array<DrawingEdge, 2>{{{0, 2}, {2, 1}}}).meet());
  EXPECT_EQ(drawing_plane(three, std::array<DrawingEdge, 2>{{{0, 2}, {2, 0}}}).found->kind, ContactKind::overlap);
  EXPECT_EQ(drawing_plane(std::array<Point2, 2>{{{0.0, 1}, {-0.0, 1}}}, {}).found->of, Of::vertices);
  EXPECT_FALSE(drawing_plane({}, {}).meet());
}

std::optional<Of> what_meets(const DrawingAnswer& answer) {
  return answer.meet() ? std::optional(answer.found->of) : std::nullopt;
}

TEST(DrawingPlaneTest, AgreesWithTheScan) {
  Random random(227);
  std::map<std::optional<Of>, int> seen;  // of plane ones: nullopt
  for (int k = 0; k < 20000; ++k) {
    const std::uint64_t side = 3 + random.below(20), count = 2 + random.below(6);
    std::vector<Point2> vertices;
    for (std::uint64_t v = 0; v < count; ++v) {
      vertices.push_back({static_cast<double>(random.below(side)), static_cast<double>(random.below(side))});
    }
    std::vector<DrawingEdge> edges;
    for (std::uint64_t e = random.below(6); e-- > 0;) {
      const std::uint32_t u = static_cast<std::uint32_t>(random.below(count));
      const std::uint32_t v = static_cast<std::uint32_t>(random.below(count));
      if (u != v) edges.push_back({u, v});
    }
    const DrawingAnswer answer = drawing_plane(vertices, edges), scan = drawing_plane_by_scan(vertices, edges);
    ASSERT_EQ(answer.meet(), scan.meet()) << k;
    const std::optional<Of> of = what_meets(answer);
    ASSERT_EQ(of == Of::vertices, what_meets(scan) == Of::vertices) << k;
    ++seen[of];
    if (of == Of::edges) {
      ASSERT_LT(answer.found->i, answer.found->j);
      ASSERT_LT(answer.found->j, edges.size());
    }
    if (of == Of::vertex_and_edge) {
      ASSERT_LT(answer.found->i, vertices.size());
      ASSERT_LT(answer.found->j, edges.size());
    }
  }
  for (const std::optional<Of> of : {std::optional<Of>(), {Of::vertices}, {Of::vertex_and_edge}, {Of::edges}}) {
    EXPECT_GT(seen[of], 100);
  }
}

TEST(DrawingPlaneTest, BadDrawingsAreRefused) {
  const std::array<Point2, 2> two{{{0, 0}, {1, 0}}};
  for (const DrawingEdge bad : {DrawingEdge{0, 2}, DrawingEdge{1, 1}}) {
    EXPECT_THROW(static_cast<void>(drawing_plane(two, std::array<DrawingEdge, 1>{bad})), Error);
  }
  EXPECT_THROW(static_cast<void>(drawing_plane(std::array<Point2, 1>{{{0, 1.0 / 0.0}}}, {})), Error);
}

}  // namespace
}  // namespace sunder::planar
