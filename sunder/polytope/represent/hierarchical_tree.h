// A polytope of R^d, so that what is furthest along a direction is found in some log n looks: the point of a hull, or,
// of half-spaces, the one that a point breaks most.
// Also called: extreme-point query, ray shooting among hyperplanes, by epsilon-nets; the tree of Clarkson, of
// Matousek & Schwarzkopf.
//
// A node has rows. Some of them, at random, are its net; the directions are cut into cones, along each of which one of
// the net, its apex, is furthest (represent/normal_fan.h). The half-spaces {x: r . x <= r . apex} of the rays r of a
// cone are a shell-simplex: a row in it is along no direction of the cone further than the apex. Those out of it are
// its conflicts; they are the rows of the cone's child, with the apex.
//   H1. For any direction, the rows of a node have a furthest one among the rows of the child of each cone that has the
//       direction, if the node has. So the leaves that a walk comes to are right, whatever the net.
//   H2. No cone's conflicts are more than a share of the node's rows: then the net is an epsilon-net for these
//       shell-simplices. It is counted, not assumed: where it does not hold, the node takes another sample. A cone for
//       which no sample did is a leaf, if the child has more than the share: it may be large (largest_leaf()).
//   H3. The depth is at most log n by log of 1 / share, a leaf of at most `leaf` rows but for H2.
// Departures from the paper. Nets are of vertices, not of faces: what is pruned is never the end of the body along a
// direction of the cone, which is all that a walk asks. A child loses, too, each row that another is as far as along
// all rays of the cone: lists that are far shorter (docs/design/polytope.md has figures). A cone that has no direction
// in common with the cone of its node is left out.
// A polytope of half-spaces a . x <= b has rows (a, b) of R^(d+1); a point p has the direction (p, -1). Rows that lie
// in a flat are points of the flat, exactly: so are lower-dimensional bodies, and half-spaces that all have b = 1. Of
// other half-spaces, those that no point of a cone breaks are lost, too: where none is broken, a walk ends at any.
// Source: BL15 section 6, Lemmas 6.1 and 6.2; Haussler & Welzl 1987.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/number/dyadic.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/represent/affine_columns.h>
#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::polytope {

// For net, leaf and share 0 stands for what serves rows of this dimension:
//   dimensions    2    3    4     5     6    7
//   net           8   16   32    16    12   11
//   leaf          8   24   96    40    56   64
//   share       1/2  1/2  1/2   3/4  0.85  0.9
struct TreeOptions {
  static constexpr std::uint32_t most_levels = 32;

  std::uint32_t net = 0;               // rows of a net; at least d + 2, of half-spaces d + 3
  std::uint32_t leaf = 0;              // rows of a leaf
  double share = 0;                    // of a node's rows, at most so many are in conflict with a cone; below 1
  std::uint32_t levels = most_levels;  // of cones, at most; leaves may be large then
  std::uint32_t samples = 64;          // that a node takes at most, until one is good
  std::size_t most_bytes = std::size_t{1} << 30;  // of memory
  std::uint64_t most_looks = 60'000'000;          // that it takes to make the tree (looks())
  std::uint64_t seed = 20150615;
};

// Immutable; any number of threads may use it.
class HierarchicalTree {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  // Throws Error bad_shape where the tree would take, by an estimate from the lists of its root, or does take more
  // memory than it may, or more looks. Cost: some cones of a net looks at each row of each node.
  explicit HierarchicalTree(Polytope body, const TreeOptions& options = {});

  const Polytope& body() const { return body_; }
  // Of the flat of the rows; of half-spaces it may be one more than the body's. A flat of at most one dimension has no
  // cones.
  std::size_t dimension() const { return d_; }
  // A direction of the body (of half-spaces with one component more), as one of the flat; and a row as a point of it:
  // some of its numbers.
  std::vector<Dyadic> reduced(std::span<const Dyadic> direction) const;
  std::span<const double> point(std::uint32_t row) const {
    return is_flat() ? std::span(points_).subspan(row * d_, d_) : body_.row(row);
  }
  // Of a flat set, which numbers of a row are those of the point.
  std::vector<std::size_t> columns() const;
  bool is_flat() const { return d_ < body_.columns().dimension; }
  std::uint32_t depth() const { return depth_; }
  std::size_t node_count() const { return nodes_.size(); }
  std::size_t cone_count() const { return apexes_.size(); }
  std::size_t row_count() const { return rows_.size(); }  // of all nodes
  std::size_t leaf_count() const { return leaf_count_; }
  std::uint32_t largest_leaf() const { return largest_leaf_; }
  // Conflicts of the root's cones, in total, before rows are lost that others are as far as.
  std::size_t root_conflicts() const { return root_conflicts_; }
  std::size_t samples() const { return samples_; }        // that all nodes took
  std::size_t unverified() const { return unverified_; }  // cones that have more conflicts than the share
  std::size_t estimate() const { return estimate_; }      // bytes, from the root's lists
  std::size_t memory() const;                             // bytes, without the body
  // What it cost to make: a cone of a sample is compared with a row or with its node's cone, or 64 rows with others
  // along a cone; and the looks of normal_fan(). Some ten million of them take a second.
  std::uint64_t looks() const { return looks_; }

  struct Node {
    std::uint32_t first_row = 0, rows = 0;
    std::uint32_t first_cone = 0, cones = 0;  // none: a leaf
  };
  const Node& node(std::uint32_t k) const { return nodes_[k]; }
  std::span<const std::uint32_t> rows(const Node& node) const {
    return std::span(rows_).subspan(node.first_row, node.rows);
  }
  std::uint32_t child(std::uint32_t cone) const { return step(cone)[d_ * d_ + d_]; }
  std::uint32_t apex(std::uint32_t cone) const { return apexes_[cone]; }
  double slack(std::uint32_t cone) const { return slacks_[cone]; }
  std::uint32_t across(std::uint32_t cone, std::size_t ray) const { return step(cone)[d_ * d_ + ray]; }
  std::span<const double> inverse(std::uint32_t cone) const {
    return std::span(inverses_).subspan(cone * d_ * d_, d_ * d_);
  }
  std::span<const double> ray(std::uint32_t cone, std::size_t k) const {
    return std::span(rays_).subspan(cone_rays_[cone * d_ + k] * d_, d_);
  }
  // What a walk in floating point looks at, of a cone: d^2 numbers of single precision, each row of the inverse times a
  // positive number; d cones across; the child.
  const std::uint32_t* step(std::uint32_t cone) const { return &steps_[cone * (d_ * d_ + d_ + 1)]; }
  // The points of the root's net, in columns, and of each a cone whose apex it is. Empty where the root is a leaf.
  PointColumns net() const { return {net_.data(), net_stride_, static_cast<std::uint32_t>(net_cones_.size()), d_, {}}; }
  std::uint32_t net_cone(std::uint32_t k) const { return net_cones_[k]; }

 private:
  friend class TreeBuilder;

  Polytope body_;
  std::size_t d_ = 0;
  AffineColumns flat_;
  std::vector<double> points_;  // of a flat set: d_ each
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> rows_;
  std::vector<std::uint32_t> apexes_;
  std::vector<double> slacks_, inverses_;
  std::vector<std::uint32_t> cone_rays_;
  std::vector<double> rays_, net_;
  std::vector<std::uint32_t> steps_, net_cones_;
  std::size_t net_stride_ = 0;
  std::uint32_t depth_ = 0, largest_leaf_ = 0;
  std::size_t leaf_count_ = 0, samples_ = 0, unverified_ = 0, estimate_ = 0, root_conflicts_ = 0;
  std::uint64_t looks_ = 0;
};

// Walks down a tree, from one direction to the next that is like it: at each level the cone of the direction is found
// from the last one of that node, across facets. Keeps a reference to the tree.
class TreeWalk {
 public:
  explicit TreeWalk(const HierarchicalTree& tree);

  // One of the rows that are furthest along the direction, of half-spaces if it has a positive product; before deepen()
  // said no, of the apexes down to the level of walks, at the root to begin with. cost.probes grows by the cones and
  // rows that were looked at, cost.exact by the signs that took exact numbers.
  ExactFurthest furthest(std::span<const Dyadic> direction, Cost& cost);

  bool deepen();

  // How far a walk in floating point goes: to a row of the net of the root; to the rows of a leaf; or no further than
  // to those that the last walk looked at.
  enum class Reach : std::uint8_t { net, leaf, last_leaf };

  // A row that is about the furthest one along the direction, as floating point has it. Where the rows are in a flat,
  // exact numbers find it, always among those of a leaf.
  FurthestPoint likely_furthest(const ColumnNumbers& direction, Reach reach, Cost& cost);
  // After a walk to a leaf along this direction: is no row further than what it found, surely, but for the error of
  // products of floating point (product_error())?
  bool was_to_the_end(const ColumnNumbers& direction, Cost& cost) const;

  // The cones of the last walk, from the root on: their shell-simplices are all that proves where the body ends.
  std::span<const std::uint32_t> path() const { return std::span(path_.cones).first(path_.size); }
  // Nodes of which all rows were looked at although they are no leaves: no cone was found in floating point.
  std::uint32_t scans() const { return scans_; }

 private:
  struct Path {
    std::array<std::uint32_t, TreeOptions::most_levels> cones;
    std::size_t size = 0;
  };

  std::uint32_t cone_of(const HierarchicalTree::Node& node, std::uint32_t from, std::span<const Dyadic> direction,
                        std::span<const double> rounded, Cost& cost) const;
  // Down to the node whose rows have the end, or to a level: cone_of(node, from) finds the next cone.
  template <class ConeOf>
  const HierarchicalTree::Node& walk(std::size_t levels, const ConeOf& cone_of);
  template <std::size_t d>
  std::uint32_t likely_cone_of(const HierarchicalTree::Node& node, std::uint32_t from,
                               const std::array<float, d>& along, Cost& cost) const;
  template <std::size_t d>
  FurthestPoint likely_of_leaf(const ColumnNumbers& direction, bool of_last, Cost& cost);
  std::uint32_t furthest_of(std::span<const std::uint32_t> rows, std::span<const Dyadic> direction,
                            std::span<const double> rounded, Cost& cost);

  ExactFurthest named(std::uint32_t row, std::span<const Dyadic> direction) const;

  const HierarchicalTree* tree_;
  std::uint32_t level_ = 1, scans_ = 0;
  Path path_, last_path_;
  const HierarchicalTree::Node* last_leaf_ = nullptr;
  std::vector<BoundedProduct> products_;
};

}  // namespace sunder::polytope
