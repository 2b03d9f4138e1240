// The hierarchical tree of the faces of a polytope: a half-space beyond a plane that supports a net leads to a child
// whose faces are all that reach into it.
// Also called: hierarchical tree by epsilon-nets; cutting tree of simplices.
//
// The polytope is the union of its faces: the hulls of a common point and of a simplex or facet of the boundary each.
// A node is about some of the faces, F. Some vertices of faces of F, chosen at random, and the common point are its
// net; the directions are cut into cones, along each of which one point of the net, the apex, is furthest
// (normal_fan.h). The half-spaces {x: r . x <= r . apex} of the rays r of a cone are a shell-simplex. Its child has the
// faces of F with a vertex out of it.
//   G1. Let u be a direction of the cone, and h the greatest product of u with the net. A face of F that has a point
//       with a product above h is one of the child's: a vertex of it has a product above h, is not of the net, and
//       is out of the shell-simplex, as within it no product exceeds that of the apex.
//   G2. So if a plane has all of the net weakly on one side, and a body strictly on the other, then the body meets a
//       face of F just if it meets one of the child's.
//   G3. No child has more than a share of the faces of its node: the net is an epsilon-net for these shell-simplices.
//       It is counted, not assumed: where it does not hold, the node takes another sample; where no sample is good, it
//       is a leaf. So the depth is at most log n by log of 1 / share.
// All in floating point: it proposes, and who asks checks what comes of it.
// Departures from the paper: a cone of the polar, triangulated from the origin, has d half-spaces, not d + 1; a net has
// at most d vertices of a sampled face; a node keeps the vertices of its net, a leaf those of all its faces.
// Source: BL15 section 6, Lemmas 6.1 and 6.2; Haussler & Welzl 1987.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder::polytope {

// The vertices, d numbers each, about of size 1; face f has those of face_vertices from face_begin[f] to
// face_begin[f + 1]. All faces have the common point, too: a vertex, or else the origin.
struct FaceSet {
  static constexpr std::uint32_t origin = 0xffffffff;
  std::size_t dimension = 0;
  std::uint32_t common = origin;
  std::vector<double> vertices{};
  std::vector<std::uint32_t> face_begin{0}, face_vertices{};

  std::size_t face_count() const { return face_begin.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(face_vertices).subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
  }
};

// A zero in one of the first four lets the dimension choose the value.
struct FaceTreeOptions {
  std::uint32_t net = 0;                          // faces that are sampled
  std::uint32_t leaf = 0;                         // faces of a leaf
  double share = 0;                               // of a node's faces, at most so many are a child's; below 1
  std::uint32_t levels = 0;                       // of cones, at most
  std::uint32_t samples = 8;                      // that a node takes at most
  std::size_t most_bytes = std::size_t{1} << 30;  // of memory
  std::uint64_t most_looks = 200'000'000;         // that it takes to make the tree: at a cone and a vertex or a face
  std::uint64_t most_facets = 200'000;            // simplices of the boundary
  std::uint64_t seed = 20150615;
};

// Immutable; any number of threads may use it.
class FaceTree {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  // One leaf: all vertices.
  FaceTree(std::size_t dimension, std::vector<double> vertices, std::vector<std::uint32_t> named);
  // `name` is said where the tree is refused. Throws Error bad_shape where it would take more memory or looks than it
  // may, by an estimate from the lists of its root, or does.
  FaceTree(FaceSet faces, const FaceTreeOptions& options, const std::string& name);

  struct Node {
    std::uint32_t first_vertex = 0, vertices = 0;  // of the net; of a leaf, of all its faces
    std::uint32_t first_cone = 0, cones = 0;       // none: a leaf
    std::uint32_t faces = 0;
  };
  const Node& node(std::uint32_t k) const { return nodes_[k]; }
  std::span<const std::uint32_t> vertices(const Node& node) const {
    return std::span(names_).subspan(node.first_vertex, node.vertices);
  }
  std::span<const double> point(std::uint32_t vertex) const { return std::span(vertices_).subspan(vertex * d_, d_); }
  std::size_t dimension() const { return d_; }

  // The child for the direction, by the cone that has it. Requires a node that is no leaf. cost.probes grows by the
  // vertices and cones that were looked at.
  std::uint32_t child_towards(const Node& node, std::span<const double> direction, Cost& cost) const;

  std::uint32_t depth() const { return depth_; }
  std::size_t node_count() const { return nodes_.size(); }
  std::size_t cone_count() const { return children_.size(); }
  std::size_t face_count() const { return face_count_; }
  std::size_t root_list() const { return root_list_; }          // faces of the root's children, in total
  std::uint32_t largest_leaf() const { return largest_leaf_; }  // vertices
  std::size_t unverified() const { return unverified_; }        // nodes for which no sample was good: leaves
  std::uint64_t looks() const { return looks_; }
  std::size_t memory() const;  // bytes

 private:
  friend class FaceTreeBuilder;

  std::size_t d_ = 0, face_count_ = 0, root_list_ = 0, unverified_ = 0;
  std::uint32_t depth_ = 0, largest_leaf_ = 0;
  std::uint64_t looks_ = 0;
  std::vector<double> vertices_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> names_;
  std::vector<std::uint32_t> children_, apexes_;  // an apex is a place in the node's list; behind it, the origin
  std::vector<double> inverses_;
};

}  // namespace sunder::polytope
