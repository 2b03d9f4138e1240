#include <sunder/solid/mesh/mesh_crossings.h>

#include <sunder/base/interruption.h>
#include <sunder/predicate/line/triangle_contact.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace sunder::solid {

namespace {

constexpr double beyond = std::numeric_limits<double>::infinity();
constexpr Box3 of_nothing{{beyond, beyond, beyond}, {-beyond, -beyond, -beyond}};  // no box meets it

class SelfWalk {
 public:
  SelfWalk(const Mesh& mesh, std::size_t most) : tree_(mesh.tree()), most_(most) {
    const auto& [low, high] = mesh.box();
    const Point3 extent{high.x - low.x, high.y - low.y, high.z - low.z};
    triangles_.reserve(mesh.triangles().size());
    for (const Mesh::Triangle& t : mesh.triangles()) {
      const Triangle3 corners{mesh.points()[t[0]], mesh.points()[t[1]], mesh.points()[t[2]]};
      const bool has_area =
          t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && !are_collinear(corners[0], corners[1], corners[2], &tally_);
      found_.without_area += !has_area;
      Box3 box = of_nothing;
      if (has_area) {
        box = hull(hull(Box3{corners[0], corners[0]}, Box3{corners[1], corners[1]}), Box3{corners[2], corners[2]});
      }
      triangles_.push_back({PlaneTriangle(corners, extent), box});
    }
  }

  // Pairs of nodes: first a node and itself, which is split into both halves and what is between them.
  MeshCrossings by_tree() {
    std::vector<Box3> boxes(2 * tree_.leaves());  // along the axes, of each node: two that touch are the rule
    for (std::size_t node = boxes.size() - 1; node > 0; --node) {
      boxes[node] = tree_.is_leaf(node) ? box_of(tree_.triangles(node)) : hull(boxes[2 * node], boxes[2 * node + 1]);
    }
    std::vector<std::pair<std::size_t, std::size_t>> waiting{{1, 1}};
    while (!waiting.empty() && found_.are_all) {
      may_be_interrupted(1);
      const auto [a, b] = waiting.back();
      waiting.pop_back();
      if (a == b) {
        if (tree_.is_leaf(a)) {
          look_into(a);
        } else {
          waiting.insert(waiting.end(), {{2 * a, 2 * a + 1}, {2 * a + 1, 2 * a + 1}, {2 * a, 2 * a}});
        }
        continue;
      }
      ++found_.cost.probes;
      if (!do_meet(boxes[a], boxes[b])) continue;
      if (tree_.is_leaf(a)) {  // all leaves are on one level
        look_between(a, b, boxes[b]);
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
      for (std::uint32_t u = t + 1; u < triangles_.size(); ++u) look_at(t, u);
    }
    return result();
  }

 private:
  struct Bounded {
    PlaneTriangle triangle;
    Box3 box;
  };

  void look_into(std::size_t leaf) {
    const auto [first, end] = tree_.triangles(leaf);
    for (std::uint32_t t = first; t < end; ++t) {
      for (std::uint32_t u = t + 1; u < end; ++u) look_at(t, u);
    }
  }
  // Only those of one leaf that come near the box of the other.
  void look_between(std::size_t leaf_a, std::size_t leaf_b, const Box3& around_b) {
    const TriangleRange of_a = tree_.triangles(leaf_a), of_b = tree_.triangles(leaf_b);
    std::array<std::uint32_t, MeshTree::leaf_size> near{};
    std::size_t count = 0;
    for (std::uint32_t t = of_a.first; t < of_a.end; ++t) {
      if (do_meet(triangles_[t].box, around_b)) near[count++] = t;
    }
    for (std::uint32_t u = of_b.first; u < of_b.end && count > 0; ++u) {
      for (std::size_t k = 0; k < count; ++k) look_at(near[k], u);
    }
  }
  Box3 box_of(const TriangleRange& range) const {
    Box3 box = of_nothing;
    for (std::uint32_t t = range.first; t < range.end; ++t) box = hull(box, triangles_[t].box);
    return box;
  }
  static bool do_meet(const Box3& a, const Box3& b) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (a.high[c] < b.low[c] || b.high[c] < a.low[c]) return false;
    }
    return true;
  }

  void look_at(std::uint32_t t, std::uint32_t u) {
    ++found_.cost.probes;
    const Bounded &one = triangles_[t], &other = triangles_[u];
    if (!do_meet(one.box, other.box)) return;
    const TriangleContact contact = triangle_contact(one.triangle, other.triangle, &tally_);
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
  std::size_t most_;
  std::vector<Bounded> triangles_;
  StageTally tally_;
  MeshCrossings found_;
};

}  // namespace

MeshCrossings mesh_crossings(const Mesh& mesh, std::size_t most) { return SelfWalk(mesh, most).by_tree(); }

MeshCrossings mesh_crossings_by_scan(const Mesh& mesh, std::size_t most) { return SelfWalk(mesh, most).by_scan(); }

}  // namespace sunder::solid
