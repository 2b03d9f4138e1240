// Pairs of triangles of two placed meshes that are near each other, as boxes tell and floating point measures.
// Also called: proximity query, branch and bound over two bounding volume hierarchies.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/interruption.h>
#include <sunder/solid/mesh/near_triangles.h>
#include <sunder/solid/mesh/placed_boxes.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace sunder::solid {

namespace near_walk_detail {

constexpr double unbounded = std::numeric_limits<double>::infinity();

struct NodePair {
  std::size_t a = 1, b = 1;
  double at_least = 0;        // as boxes tell
  double along = -unbounded;  // the same along the way
};

}  // namespace near_walk_detail

// Walks down both trees. Keeps references to both meshes, and to the cost: probes grows by pairs of boxes and triangles.
class NearWalk {
  using NodePair = near_walk_detail::NodePair;

 public:
  static constexpr double unbounded = near_walk_detail::unbounded;

  NearWalk(const PlacedMesh& a, const PlacedMesh& b, Cost& cost)
      : tree_a_(a.mesh().tree()),
        tree_b_(b.mesh().tree()),
        frame_a_(BoxFrame::of(a)),
        frame_b_(BoxFrame::of(b)),
        boxes_(frame_a_, frame_b_),
        of_a_(a),
        of_b_(b),
        gaps_(a, b),
        cost_(cost) {
    const Point3 &p = frame_a_.middle, &q = frame_b_.middle;
    look_along({q.x - p.x, q.y - p.y, q.z - p.z});
  }

  // Compares boxes along this way, too: that between the nearest points so far. Along it, even large boxes of two curved
  // surfaces are further apart than the nearest points; along their own axes only small ones are.
  void look_along(const Point3& way) {
    const double length = std::sqrt(dot(way, way));
    if (!(length > 0x1p-400 && length < 0x1p400)) return;
    way_ = {way.x / length, way.y / length, way.z / length};
    along_.emplace(frame_a_, frame_b_, way_);
  }

  // Calls of_pair(t, u, gap) with the triangles of two leaves, down to which the boxes are less far apart along the way.
  template <class OfPair>
  void dive(double& limit, const OfPair& of_pair) {
    NodePair pair;
    while (!is_of_leaves(pair)) {
      const auto halves = halves_of(pair, unbounded);
      pair = halves[is_second_nearer(halves) ? 1 : 0];
    }
    any_of_leaves(pair, limit, of_pair);
  }

  // The same with each two triangles that may be no further apart than `limit`, which of_pair may lower; the nearest boxes
  // first of all, so that few are looked at that are further apart than what is nearest.
  template <class OfPair>
  void nearest_first(double& limit, const OfPair& of_pair) {
    std::array<NodePair, 512> waiting;  // a heap; what finds no place in it is gone through at once
    std::size_t count = 0;
    const auto is_later = [](const NodePair& p, const NodePair& q) { return p.at_least > q.at_least; };
    waiting[count++] = NodePair{};
    while (count > 0 && !(waiting[0].at_least > limit)) {
      may_be_interrupted(1);
      std::pop_heap(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(count), is_later);
      const NodePair pair = waiting[--count];
      if (is_of_leaves(pair)) {
        any_of_leaves(pair, limit, of_pair);
        continue;
      }
      for (const NodePair& half : halves_of(pair, limit)) {
        if (half.at_least > limit) continue;
        if (count == waiting.size()) {
          any(limit, of_pair, half);
          continue;
        }
        waiting[count++] = half;
        std::push_heap(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(count), is_later);
      }
    }
  }

  // The same below two nodes, in a space that does not grow, until of_pair returns true. Returns whether it did.
  template <class OfPair>
  bool any(double& limit, const OfPair& of_pair, const NodePair& from = {}) {
    std::array<NodePair, 2 * MeshTree::deepest + 2> waiting;
    std::size_t count = 0;
    waiting[count++] = from;
    while (count > 0) {
      may_be_interrupted(1);
      const NodePair pair = waiting[--count];
      if (pair.at_least > limit) continue;
      if (is_of_leaves(pair)) {
        if (any_of_leaves(pair, limit, of_pair)) return true;
        continue;
      }
      const auto halves = halves_of(pair, limit);
      const std::size_t nearer = is_second_nearer(halves) ? 1 : 0;
      for (const std::size_t k : {1 - nearer, nearer}) {
        if (halves[k].at_least <= limit) waiting[count++] = halves[k];
      }
    }
    return false;
  }

 private:
  bool is_of_leaves(const NodePair& pair) const { return tree_a_.is_leaf(pair.a) && tree_b_.is_leaf(pair.b); }

  // Boxes that are further apart along the way than the limit are not compared otherwise.
  std::array<NodePair, 2> halves_of(const NodePair& pair, double limit) {
    const bool splits_a = tree_b_.is_leaf(pair.b) || (!tree_a_.is_leaf(pair.a) &&
                                                      boxes_.is_first_larger(tree_a_.box(pair.a), tree_b_.box(pair.b)));
    std::array<NodePair, 2> halves;
    for (const std::size_t k : {0u, 1u}) {
      NodePair& half = halves[k];
      half = splits_a ? NodePair{2 * pair.a + k, pair.b} : NodePair{pair.a, 2 * pair.b + k};
      ++cost_.probes;
      const OrientedBox &box_a = tree_a_.box(half.a), &box_b = tree_b_.box(half.b);
      if (along_) half.along = along_->at_least(box_a, box_b);
      half.at_least = std::max(0.0, half.along);  // 0 where it is no number
      if (half.at_least <= limit) half.at_least = std::max(half.at_least, boxes_.at_least(box_a, box_b));
    }
    return halves;
  }
  static bool is_second_nearer(const std::array<NodePair, 2>& halves) { return halves[1].along < halves[0].along; }

  template <class OfPair>
  bool any_of_leaves(const NodePair& pair, double& limit, const OfPair& of_pair) {
    const TriangleRange in_a = of_a_.take(pair.a), in_b = of_b_.take(pair.b);
    for (std::uint32_t t = in_a.first; t < in_a.end; ++t) {
      for (std::uint32_t u = in_b.first; u < in_b.end; ++u) {
        ++cost_.probes;
        if (gaps_.along(way_, of_a_[t], of_b_[u]) > limit) continue;
        const TriangleGap gap = gaps_(of_a_[t], of_b_[u], limit);
        if (gap.distance.low <= limit && of_pair(t, u, gap)) return true;
      }
    }
    return false;
  }

  const MeshTree &tree_a_, &tree_b_;
  BoxFrame frame_a_, frame_b_;
  PlacedBoxes boxes_;
  Point3 way_;  // of length 1, or 0 where there is none
  std::optional<BoxesAlong> along_;
  LeafTriangles of_a_, of_b_;
  TriangleGaps gaps_;
  Cost& cost_;
};

}  // namespace sunder::solid
