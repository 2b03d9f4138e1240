#include <sunder/solid/mesh/mesh_crossings.h>

#include <sunder/base/interruption.h>
#include <sunder/base/lanes.h>
#include <sunder/predicate/line/triangle_contact.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

constexpr double beyond = std::numeric_limits<double>::infinity();
constexpr Box3 of_nothing{{beyond, beyond, beyond}, {-beyond, -beyond, -beyond}};  // no box meets it

// The boxes of the triangles of a leaf, by their coordinates; of less than four, some of nothing.
struct LeafBoxes {
  static_assert(MeshTree::leaf_size == 4);
  std::array<std::array<double, 4>, 3> low, high;

  LeafBoxes() {
    for (std::size_t k = 0; k < 4; ++k) set(k, of_nothing);
  }
  void set(std::size_t k, const Box3& box) {
    for (std::size_t c = 0; c < 3; ++c) {
      low[c][k] = box.low[c];
      high[c][k] = box.high[c];
    }
  }
  Box3 operator[](std::size_t k) const {
    return {{low[0][k], low[1][k], low[2][k]}, {high[0][k], high[1][k], high[2][k]}};
  }
  // Which ones meet this box: bit k tells of number k.
  std::uint32_t meeting(const Box3& box) const {
    std::array<LanesMask, 2> meet{LanesMask{-1, -1}, LanesMask{-1, -1}};
    for (std::size_t c = 0; c < 3; ++c) {
      const Lanes from{box.low[c], box.low[c]}, to{box.high[c], box.high[c]};
      for (const std::size_t half : {0u, 1u}) {
        meet[half] &= is_at_most(lanes_at(&low[c][2 * half]), to) & is_at_most(from, lanes_at(&high[c][2 * half]));
      }
    }
    return bits_of(meet[0]) | bits_of(meet[1]) << 2;
  }
};

class SelfWalk {
 public:
  SelfWalk(const Mesh& mesh, std::size_t most)
      : tree_(mesh.tree()), numbers_(mesh.triangles()), most_(most), leaf_boxes_(tree_.leaves()) {
    const auto& [low, high] = mesh.box();
    const Point3 extent{high.x - low.x, high.y - low.y, high.z - low.z};
    triangles_.reserve(numbers_.size());
    for (std::size_t leaf = 0; leaf < tree_.leaves(); ++leaf) {
      const TriangleRange range = tree_.triangles(tree_.leaves() + leaf);
      for (std::uint32_t t = range.first; t < range.end; ++t) {
        const auto& [i, j, k] = numbers_[t];
        const Point3 &p = mesh.points()[i], &q = mesh.points()[j], &r = mesh.points()[k];
        triangles_.emplace_back(Triangle3{p, q, r}, extent);
        if (i == j || j == k || k == i || are_collinear(p, q, r, &tally_)) {
          ++found_.without_area;
        } else {
          leaf_boxes_[leaf].set(t - range.first, hull(hull(Box3{p, p}, Box3{q, q}), Box3{r, r}));
        }
      }
    }
  }

  // Pairs of nodes: first a node and itself, which is split into both halves and what is between them.
  MeshCrossings by_tree() {
    std::vector<Box3> boxes(2 * tree_.leaves());  // along the axes, of each node: two that touch are the rule
    for (std::size_t node = boxes.size() - 1; node > 0; --node) {
      if (tree_.is_leaf(node)) {
        const LeafBoxes& of = leaf_boxes_[node - tree_.leaves()];
        boxes[node] = hull(hull(of[0], of[1]), hull(of[2], of[3]));
      } else {
        boxes[node] = hull(boxes[2 * node], boxes[2 * node + 1]);
      }
    }
    std::vector<std::pair<std::size_t, std::size_t>> waiting{{1, 1}};
    while (!waiting.empty() && found_.are_all) {
      may_be_interrupted(1);
      const auto [a, b] = waiting.back();
      waiting.pop_back();
      if (a == b) {
        if (tree_.is_leaf(a)) {
          look_into(a - tree_.leaves());
        } else {
          waiting.insert(waiting.end(), {{2 * a, 2 * a + 1}, {2 * a + 1, 2 * a + 1}, {2 * a, 2 * a}});
        }
        continue;
      }
      ++found_.cost.probes;
      if (!do_meet(boxes[a], boxes[b])) continue;
      if (tree_.is_leaf(a)) {  // all leaves are on one level
        look_between(a - tree_.leaves(), b - tree_.leaves(), boxes[a], boxes[b]);
      } else {
        for (const std::size_t k : {0u, 1u})
          waiting.insert(waiting.end(), {{2 * a + k, 2 * b}, {2 * a + k, 2 * b + 1}});
      }
    }
    return result();
  }

  MeshCrossings by_scan() {
    for (std::uint32_t t = 0; t < triangles_.size() && found_.are_all; ++t) {
      may_be_interrupted(1);
      for (std::uint32_t u = t + 1; u < triangles_.size(); ++u) {
        ++found_.cost.probes;
        if (do_meet(box_of(t), box_of(u))) add(t, u, exact_triangle_contact(triangles_[t], triangles_[u], &tally_));
      }
    }
    return result();
  }

 private:
  void look_into(std::size_t leaf) {
    const auto [first, end] = tree_.triangles(tree_.leaves() + leaf);
    for (std::uint32_t t = first; t + 1 < end; ++t) {
      const std::uint32_t after = 2u << (t - first);  // and all higher bits
      look_at(t, first, leaf_boxes_[leaf].meeting(leaf_boxes_[leaf][t - first]) & ~(after - 1));
      found_.cost.probes += end - t - 1;
    }
  }
  // Only those of each leaf that come near the box of the other.
  void look_between(std::size_t leaf_a, std::size_t leaf_b, const Box3& around_a, const Box3& around_b) {
    const LeafBoxes &of_a = leaf_boxes_[leaf_a], &of_b = leaf_boxes_[leaf_b];
    const std::uint32_t near_a = of_a.meeting(around_b), near_b = of_b.meeting(around_a);
    const std::uint32_t first_a = tree_.triangles(tree_.leaves() + leaf_a).first,
                        first_b = tree_.triangles(tree_.leaves() + leaf_b).first;
    for (std::uint32_t rest = near_a; rest != 0; rest &= rest - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(rest));
      found_.cost.probes += static_cast<std::uint64_t>(std::popcount(near_b));
      look_at(first_a + k, first_b, of_b.meeting(of_a[k]) & near_b);
    }
  }
  static bool do_meet(const Box3& a, const Box3& b) {
    unsigned meet = 1;  // without branches
    for (std::size_t c = 0; c < 3; ++c) {
      meet &= static_cast<unsigned>(a.low[c] <= b.high[c]) & static_cast<unsigned>(b.low[c] <= a.high[c]);
    }
    return meet != 0;
  }
  Box3 box_of(std::uint32_t t) const {
    const std::size_t node = tree_.leaf_of(t);
    return leaf_boxes_[node - tree_.leaves()][t - tree_.triangles(node).first];
  }

  // At one triangle and those from `first` on whose bits are set.
  void look_at(std::uint32_t t, std::uint32_t first, std::uint32_t bits) {
    for (; bits != 0; bits &= bits - 1) {
      const std::uint32_t u = first + static_cast<std::uint32_t>(std::countr_zero(bits));
      const SharedCorners shared(numbers_[t], numbers_[u]);
      add(t, u, triangle_contact(triangles_[t], triangles_[u], shared, &tally_));
    }
  }

  void add(std::uint32_t t, std::uint32_t u, TriangleContact contact) {
    if (contact == TriangleContact::proper) return;
    if (contact == TriangleContact::t_junction) {
      ++found_.t_junctions;
    } else if (found_.pairs.size() < most_) {
      found_.pairs.push_back({std::min(t, u), std::max(t, u)});
    } else {
      found_.are_all = false;
    }
  }

  MeshCrossings result() {
    std::sort(found_.pairs.begin(), found_.pairs.end());
    found_.cost.exact = tally_.exact;
    return std::move(found_);
  }

  const MeshTree& tree_;
  std::span<const Mesh::Triangle> numbers_;  // of their corners
  std::size_t most_;
  std::vector<PlaneTriangle> triangles_;
  std::vector<LeafBoxes> leaf_boxes_;  // of triangles with an area
  StageTally tally_;
  MeshCrossings found_;
};

}  // namespace

MeshCrossings mesh_crossings(const Mesh& mesh, std::size_t most) { return SelfWalk(mesh, most).by_tree(); }

MeshCrossings mesh_crossings_by_scan(const Mesh& mesh, std::size_t most) { return SelfWalk(mesh, most).by_scan(); }

}  // namespace sunder::solid
