// A polytope of points, prepared for the question of Theorem 6.3: the tree of its faces, that of the faces of its
// polar, and the walks that tell exactly which point is furthest (hierarchical_tree.h).
// Also called: preprocessed polyhedron.
//
// Its faces are the simplices from one vertex to those of a triangulation of the boundary that are in no facet of that
// vertex. The polar is about a point inside; its vertices are the facets, its faces the hulls of the origin and of all
// facets at one vertex. The facets are exact (hull/convex_hull.h), what the trees hold of them is rounded.
// Source: BL15 section 6.
#pragma once

#include <sunder/base/error.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <sunder/polytope/tree/face_tree.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::polytope {

// Which trees to make. A question needs one tree of each body: the faces of one, the polar of the other.
enum class FaceTreesOf : std::uint8_t { both, faces, polar };

// Immutable; any number of threads may use it.
class FaceTrees {
 public:
  // Requires points. Throws Error bad_shape where a tree, or the hull, would take more than it may.
  explicit FaceTrees(Polytope body, FaceTreesOf which = FaceTreesOf::both, const FaceTreeOptions& options = {},
                     const TreeOptions& walks = {.most_looks = 20'000'000});

  const Polytope& body() const { return walks_.body(); }
  const HierarchicalTree& walks() const { return walks_; }
  // Each is about the body moved and scaled, as floating point has it: x_c = center_c + 2^unit_c y_c. A body of fewer
  // dimensions has no polar, and its tree of faces is one leaf, of all its vertices. Empty, too, where not asked for.
  const std::optional<FaceTree>& faces() const { return faces_; }  // vertices: rows of the body
  const std::optional<FaceTree>& polar() const { return polar_; }  // vertices: facets
  bool is_full() const { return hull_.dimension == body().dimension(); }
  double center(std::size_t c) const { return center_[c]; }
  int unit(std::size_t c) const { return unit_[c]; }

  // The corners of a simplex of the body that has the point near it: of the facet behind which the ray to it ends, and
  // of a simplex whose mean is the center. The point is one of y.
  void add_simplex_of(std::uint32_t facet, std::span<const double> y, std::vector<std::uint32_t>& rows) const;
  std::span<const std::uint32_t> center_rows() const { return center_rows_; }
  std::span<const std::uint32_t> corners_of(std::uint32_t facet) const { return hull_.facet_vertices(facet); }

  std::size_t memory() const;  // bytes, without the body
  std::uint64_t looks() const;

 private:
  void place();
  void make_faces(const FaceTreeOptions& options, const std::string& name);
  void make_polar(const FaceTreeOptions& options, const std::string& name);
  std::vector<double> placed_rows() const;

  HierarchicalTree walks_;
  ConvexHull hull_;
  std::array<double, most_dimension> center_{};
  std::array<int, most_dimension> unit_{};
  std::vector<std::uint32_t> center_rows_;
  std::vector<double> rows_;  // y of each row
  std::optional<FaceTree> faces_, polar_;
};

}  // namespace sunder::polytope
