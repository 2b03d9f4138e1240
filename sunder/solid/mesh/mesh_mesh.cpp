#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_mesh_internal.h>

#include <sunder/base/interruption.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_boxes.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/mesh/placed_triangles.h>
#include <sunder/solid/search/search_vector.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace sunder::solid {

namespace {

// A piece of one that is inside of the other: a corner of it. Requires the surfaces to be apart.
// is_beyond(box): surely nothing in that box of a node is in the box of all of the other.
template <class IsBeyond>
std::optional<std::uint32_t> point_within(const PlacedMesh& of, const PlacedMesh& other, const IsBeyond& is_beyond,
                                          Cost& cost) {
  if (!other.mesh().has_inside()) return std::nullopt;
  const MeshTree& tree = of.mesh().tree();
  const auto is_outside = [&](std::uint32_t triangle) {
    const std::size_t leaf = tree.leaf_of(triangle);
    for (int level = static_cast<int>(std::bit_width(leaf)) - 1; level >= 0; --level) {
      ++cost.probes;
      if (is_beyond(tree.box(leaf >> level))) return true;
    }
    return false;
  };
  for (const Mesh::Piece& piece : of.mesh().pieces()) {
    may_be_interrupted(1);
    if (is_outside(piece.first)) continue;
    const std::uint32_t point = of.mesh().triangles()[piece.first][0];
    const MeshPoint found = mesh_point(other.mesh(), other.pose(), of.at(point));
    cost.probes += found.cost.probes;
    cost.proposals += found.cost.proposals;
    cost.exact += found.cost.exact;
    if (found.place == MeshPlace::inside) return point;
  }
  return std::nullopt;
}

class Walk {
 public:
  Walk(const PlacedMesh& a, const PlacedMesh& b, Cost& cost, StageTally& tally,
       FunctionRef<bool(const MeetingTriangles&)> of_pair)
      : a_(a),
        b_(b),
        tree_a_(a.mesh().tree()),
        tree_b_(b.mesh().tree()),
        boxes_(BoxFrame::of(a), BoxFrame::of(b)),
        of_a_(a),
        of_b_(b),
        are_apart_(a, b),
        cost_(cost),
        tally_(tally),
        of_pair_(of_pair) {}

  // The walk splits the larger one of two nodes, unless they are surely apart.
  bool any() {
    std::array<NodePair, 2 * MeshTree::deepest + 2> waiting;
    std::size_t count = 0;
    waiting[count++] = {1, 1};
    while (count > 0) {
      may_be_interrupted(1);
      const auto [node_a, node_b] = waiting[--count];
      const OrientedBox &box_a = tree_a_.box(node_a), &box_b = tree_b_.box(node_b);
      if (are_apart(box_a, box_b)) continue;
      const bool leaf_a = tree_a_.is_leaf(node_a), leaf_b = tree_b_.is_leaf(node_b);
      if (leaf_a || leaf_b) {
        if (leaf_a && leaf_b ? any_of_leaves(node_a, node_b)
            : leaf_a         ? any_below<true>(node_a, node_b)
                             : any_below<false>(node_b, node_a)) {
          return true;
        }
        continue;
      }
      const bool splits_a = boxes_.is_first_larger(box_a, box_b);
      for (const std::size_t k : {1u, 0u}) {
        waiting[count++] = splits_a ? NodePair{2 * node_a + k, node_b} : NodePair{node_a, 2 * node_b + k};
      }
    }
    return false;
  }

 private:
  struct NodePair {
    std::size_t a, b;
  };

  bool are_apart(const OrientedBox& box_a, const OrientedBox& box_b) {
    ++cost_.probes;
    return boxes_.are_apart(box_a, box_b);
  }

  // Each triangle of a leaf of one, which is flat, down the other tree from that node.
  template <bool IsLeafOfA>
  bool any_below(std::size_t leaf, std::size_t top) {
    const PlacedMesh& of = IsLeafOfA ? a_ : b_;
    const MeshTree &tree = IsLeafOfA ? tree_a_ : tree_b_, &other = IsLeafOfA ? tree_b_ : tree_a_;
    const TriangleRange range = tree.triangles(leaf);
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      const Mesh::Triangle& corners = of.mesh().triangles()[t];
      const auto at = [&](std::size_t k) { return of.mesh().points()[corners[k]]; };
      const OrientedBox box = tree.box_around_triangle({at(0), at(1), at(2)});
      std::array<std::size_t, MeshTree::deepest + 2> waiting;
      std::size_t count = 0;
      waiting[count++] = top;
      while (count > 0) {
        const std::size_t node = waiting[--count];
        if (IsLeafOfA ? are_apart(box, other.box(node)) : are_apart(other.box(node), box)) continue;
        if (other.is_leaf(node)) {
          if (IsLeafOfA ? any_of(leaf, t, node) : any_of(node, leaf, t)) return true;
          continue;
        }
        waiting[count++] = 2 * node + 1;
        waiting[count++] = 2 * node;
      }
    }
    return false;
  }

  bool any_of_leaves(std::size_t leaf_a, std::size_t leaf_b) {
    const TriangleRange in_a = of_a_.take(leaf_a), in_b = of_b_.take(leaf_b);
    for (std::uint32_t t = in_a.first; t < in_a.end; ++t) {
      for (std::uint32_t u = in_b.first; u < in_b.end; ++u) {
        if (do_meet(t, u)) return true;
      }
    }
    return false;
  }
  bool any_of(std::size_t leaf_a, std::uint32_t t, std::size_t leaf_b) {
    of_a_.take(leaf_a);
    const TriangleRange in_b = of_b_.take(leaf_b);
    for (std::uint32_t u = in_b.first; u < in_b.end; ++u) {
      if (do_meet(t, u)) return true;
    }
    return false;
  }
  bool any_of(std::size_t leaf_a, std::size_t leaf_b, std::uint32_t u) {
    of_b_.take(leaf_b);
    const TriangleRange in_a = of_a_.take(leaf_a);
    for (std::uint32_t t = in_a.first; t < in_a.end; ++t) {
      if (do_meet(t, u)) return true;
    }
    return false;
  }

  // What floating point does not part, signs decide. Both triangles are of the leaves that were taken last.
  bool do_meet(std::uint32_t t, std::uint32_t u) {
    ++cost_.probes;
    if (are_apart_(of_a_[t], of_b_[u])) return false;
    ++cost_.iterations;
    return triangles_meet(a_.triangle(t), b_.triangle(u), &tally_) && of_pair_({t, u});
  }

  const PlacedMesh &a_, &b_;
  const MeshTree &tree_a_, &tree_b_;
  PlacedBoxes boxes_;
  LeafTriangles of_a_, of_b_;
  TrianglesApart are_apart_;
  Cost& cost_;
  StageTally& tally_;
  FunctionRef<bool(const MeetingTriangles&)> of_pair_;
};

}  // namespace

bool any_meeting_triangles(const PlacedMesh& a, const PlacedMesh& b, Cost& cost, StageTally& tally,
                           FunctionRef<bool(const MeetingTriangles&)> of_pair) {
  return Walk(a, b, cost, tally, of_pair).any();
}

namespace {

std::optional<MeetingTriangles> first_pair_by_trees(const PlacedMesh& a, const PlacedMesh& b, Cost& cost,
                                                    StageTally& tally) {
  std::optional<MeetingTriangles> first;
  any_meeting_triangles(a, b, cost, tally, [&](const MeetingTriangles& pair) {
    first = pair;
    return true;
  });
  return first;
}

std::optional<MeetingTriangles> first_pair_by_scan(const PlacedMesh& a, const PlacedMesh& b, Cost& cost,
                                                   StageTally& tally) {
  for (std::uint32_t t = 0; t < a.mesh().triangles().size(); ++t) {
    for (std::uint32_t u = 0; u < b.mesh().triangles().size(); ++u) {
      may_be_interrupted(1);
      ++cost.probes;
      if (triangles_meet(a.triangle(t), b.triangle(u), &tally)) return MeetingTriangles{t, u};
    }
  }
  return std::nullopt;
}

// Around the middle of the tree, in the world: nothing of the mesh is further from there. In floating point, a little
// more than that; not finite, where numbers are too large.
struct Ball {
  Point3 middle;
  double radius = 0;
};

Ball ball_around(const PlacedMesh& placed) {
  const MeshTree& tree = placed.mesh().tree();
  const auto& [m, t] = placed.pose().affine();
  Ball ball;
  std::array<Point3, 3> columns;
  double sum = 0;
  for (std::size_t r = 0; r < 3; ++r) {
    ball.middle[r] = t[r];
    sum += std::fabs(t[r]);
    for (std::size_t c = 0; c < 3; ++c) {
      columns[c][r] = m[3 * r + c];
      ball.middle[r] += m[3 * r + c] * tree.middle()[c];
      sum += std::fabs(m[3 * r + c] * tree.middle()[c]);
    }
  }
  double longest = 0;  // the square of what the pose makes of a length 1, at most
  for (const Point3& u : columns) {
    longest = std::max(longest,
                       std::fabs(dot(u, columns[0])) + std::fabs(dot(u, columns[1])) + std::fabs(dot(u, columns[2])));
  }
  ball.radius = tree.radius() * std::sqrt(longest) * (1 + 0x1p-40) + sum * 0x1p-45;
  return ball;
}

bool are_surely_apart(const Ball& a, const Ball& b) {
  const Point3 way{b.middle.x - a.middle.x, b.middle.y - a.middle.y, b.middle.z - a.middle.z};
  const double reach = a.radius + b.radius, far = dot(way, way) * (1 - 0x1p-40);
  return reach > 0x1p-400 && far <= std::numeric_limits<double>::max() && far > reach * reach;
}

MeshAnswer answer_by(decltype(first_pair_by_scan)* first_pair, const Mesh& a, const Pose& pose_a, const Mesh& b,
                     const Pose& pose_b) {
  const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
  MeshAnswer answer;
  StageTally tally;
  const bool is_scan = first_pair == first_pair_by_scan;
  if (!is_scan && are_surely_apart(ball_around(placed_a), ball_around(placed_b))) {
    answer.cost.probes = 1;
    conclude(answer, 0);
    return answer;
  }
  const PlacedBoxes boxes(BoxFrame::of(placed_a), BoxFrame::of(placed_b));
  const OrientedBox &all_a = a.tree().box(1), &all_b = b.tree().box(1);
  const auto beyond_b = [&](const OrientedBox& box) { return !is_scan && boxes.are_apart(box, all_b); };
  const auto beyond_a = [&](const OrientedBox& box) { return !is_scan && boxes.are_apart(all_a, box); };
  if (beyond_b(all_a)) {
    answer.cost.probes = 2;
  } else if (const auto found = first_pair(placed_a, placed_b, answer.cost, tally)) {
    answer.evidence = *found;
  } else if (const auto of_a = point_within(placed_a, placed_b, beyond_b, answer.cost)) {
    answer.evidence = PointWithin{true, *of_a};
  } else if (const auto of_b = point_within(placed_b, placed_a, beyond_a, answer.cost)) {
    answer.evidence = PointWithin{false, *of_b};
  }
  conclude(answer, answer.cost.exact + tally.exact);
  return answer;
}

}  // namespace

bool can_be_placed(const Mesh& mesh, const Pose& pose) {
  return pose.linear_range().greatest < 0x1p1000 || mesh.sizes().greatest < 0x1p1020;
}

void require_can_be_placed(const Mesh& mesh, const Pose& pose) {
  if (can_be_placed(mesh, pose)) return;
  throw Error(ErrorCode::bad_pose,
              "entries of 2^1000 and more, of a mesh with coordinates of 2^1020; give smaller ones");
}

MeshAnswer mesh_mesh(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  return answer_by(first_pair_by_trees, a, pose_a, b, pose_b);
}

MeshAnswer mesh_mesh_by_scan(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  MeshAnswer answer = answer_by(first_pair_by_scan, a, pose_a, b, pose_b);
  answer.decided_by = DecidedBy::scan;
  return answer;
}

}  // namespace sunder::solid

namespace sunder {

solid::MeshAnswer intersect(const solid::Mesh& a, const solid::Pose& pose_a, const solid::Mesh& b,
                            const solid::Pose& pose_b) {
  solid::require_can_be_placed(a, pose_a);
  solid::require_can_be_placed(b, pose_b);
  return mesh_mesh(a, pose_a, b, pose_b);
}

}  // namespace sunder
