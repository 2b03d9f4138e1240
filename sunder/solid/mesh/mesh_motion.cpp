#include <sunder/solid/mesh/mesh_motion.h>

#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/exact/sweep_simplex.h>
#include <sunder/solid/mesh/swept_boxes.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace sunder::solid {

namespace {

// A mesh that moves.
struct MovingMesh {
  const Translation& of;
  PlacedMesh begin, end;

  MovingMesh(const Mesh& mesh, const Translation& motion)
      : of(motion), begin(mesh, motion.begin()), end(mesh, motion.end()) {}
  const Mesh& mesh() const { return begin.mesh(); }
};

ConvexPolyhedron hull_of_triangle(const Mesh& mesh, std::uint32_t triangle) {
  const auto& [i, j, k] = mesh.triangles()[triangle];
  return ConvexPolyhedron(std::array{mesh.points()[i], mesh.points()[j], mesh.points()[k]});
}

// Vertices of the hull of a triangle by the numbers of the points of its mesh.
void name_points(const Mesh& mesh, std::uint32_t triangle, const ConvexPolyhedron& hull, Combination& of) {
  for (Weights::Part& part : of.parts) part.index = mesh.triangles()[triangle][hull.source()[part.index]];
}

// The first two triangles that meet, of meshes that are apart at time 0.
class FirstContact {
 public:
  FirstContact(const MovingMesh& a, const MovingMesh& b, Cost& cost, StageTally& tally)
      : a_(a), b_(b), cost_(cost), tally_(tally) {}

  // Pairs of boxes, and of triangles, in the order of the first time at which they may meet, as floating point tells.
  void by_trees() {
    const MeshTree &tree_a = a_.mesh().tree(), &tree_b = b_.mesh().tree();
    const RelativePath path(a_.of, b_.of);
    const SweptBoxes boxes(BoxFrame::of(a_.begin), BoxFrame::of(b_.begin), path);
    const SweptTriangles triangles(a_.begin, a_.end, b_.begin, b_.end, path);
    LeafTriangles of_a(a_.begin), of_b(b_.begin);
    add({boxes.first_time(tree_a.box(1), tree_b.box(1)), 1, 1, false});
    while (!waiting_.empty()) {
      may_be_interrupted(1);
      std::pop_heap(waiting_.begin(), waiting_.end(), is_later);
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      if (next.time >= limit_) return;
      if (next.is_triangles) {
        look_at(next.a, next.b);
        continue;
      }
      const bool leaf_a = tree_a.is_leaf(next.a), leaf_b = tree_b.is_leaf(next.b);
      if (leaf_a && leaf_b) {
        const TriangleRange in_a = of_a.take(next.a), in_b = of_b.take(next.b);
        for (std::uint32_t t = in_a.first; t < in_a.end; ++t) {
          for (std::uint32_t u = in_b.first; u < in_b.end; ++u) {
            add({triangles.first_time(of_a[t], of_b[u]), t, u, true});
          }
        }
        continue;
      }
      const bool splits_a = leaf_b || (!leaf_a && boxes.is_first_larger(tree_a.box(next.a), tree_b.box(next.b)));
      for (const std::uint32_t k : {0u, 1u}) {
        const std::uint32_t a = splits_a ? 2 * next.a + k : next.a, b = splits_a ? next.b : 2 * next.b + k;
        add({boxes.first_time(tree_a.box(a), tree_b.box(b)), a, b, false});
      }
    }
  }

  void by_scan() {
    for (std::uint32_t t = 0; t < a_.mesh().triangles().size(); ++t) {
      for (std::uint32_t u = 0; u < b_.mesh().triangles().size(); ++u) {
        may_be_interrupted(1);
        ++cost_.probes;
        decide(t, u);
      }
    }
  }

  std::optional<TrianglesOnTheWay> found;

 private:
  // Two nodes, or two triangles, that do not meet before that time.
  struct Waiting {
    double time;
    std::uint32_t a, b;
    bool is_triangles;
  };
  // Of those of one time, the deepest comes first.
  static bool is_later(const Waiting& p, const Waiting& q) {
    if (p.time != q.time) return p.time > q.time;
    if (p.is_triangles != q.is_triangles) return q.is_triangles;
    return std::uint64_t{p.a} + p.b < std::uint64_t{q.a} + q.b;
  }

  void add(const Waiting& pair) {
    ++cost_.probes;
    if (!(pair.time < limit_)) return;
    waiting_.push_back(pair);
    std::push_heap(waiting_.begin(), waiting_.end(), is_later);
  }

  // A direction along which two triangles that meet at the first time so far are parted before. What is A's, and no
  // further along it than the first one, is parted by it from what is B's, and no less far than the other one: so they
  // meet no earlier.
  struct Parting {
    WorldDirection direction;
    Posed3 last, first;  // of A, and of B; both at time 0

    bool tells(const PosedTriangle& of_a, const PosedTriangle& of_b) const {
      const auto is_before = [&](const Posed3& p, const Posed3& q) {
        return compare_along(direction, p, q) != Sign::negative;
      };
      return std::all_of(of_a.begin(), of_a.end(), [&](const Posed3& p) { return is_before(p, last); }) &&
             std::all_of(of_b.begin(), of_b.end(), [&](const Posed3& p) { return is_before(first, p); });
    }
  };

  // What is told to be no earlier is not asked about. The direction that told it last is tried first.
  void look_at(std::uint32_t t, std::uint32_t u) {
    const PosedTriangle of_a = a_.begin.triangle(t), of_b = b_.begin.triangle(u);
    const auto told = std::find_if(partings_.begin(), partings_.end(),
                                   [&](const Parting& parting) { return parting.tells(of_a, of_b); });
    if (told == partings_.end()) return decide(t, u);
    std::rotate(partings_.begin(), told, told + 1);
  }

  void decide(std::uint32_t t, std::uint32_t u) {
    const ConvexPolyhedron of_a = hull_of_triangle(a_.mesh(), t), of_b = hull_of_triangle(b_.mesh(), u);
    ++cost_.iterations;
    SweepOutcome outcome = decide_by_sweep_simplex(of_a, a_.of, of_b, b_.of, SweepTime::first, 0, 0, cost_, tally_);
    if (!outcome.contact) return;
    const Sign order = found ? compare(outcome.contact->time, found->contact->time) : Sign::negative;
    if (order == Sign::positive) return;
    name_points(a_.mesh(), t, of_a, outcome.contact->point.of_a);
    name_points(b_.mesh(), u, of_b, outcome.contact->point.of_b);
    const auto contact = std::make_shared<const SweepContact>(*std::move(outcome.contact));
    if (order == Sign::negative) {
      found = {t, u, contact};
      limit_ = contact->time.enclosure().high;
      partings_.clear();
    }
    if (partings_.size() == most_partings) partings_.pop_back();
    const auto& [x, y, z] = contact->direction;
    partings_.insert(partings_.begin(),
                     {WorldDirection(Vector3<Dyadic>{x, y, z}), a_.begin.at(contact->point.of_a.parts.front().index),
                      b_.begin.at(contact->point.of_b.parts.front().index)});
  }

  static constexpr std::size_t most_partings = 8;
  const MovingMesh &a_, &b_;
  Cost& cost_;
  StageTally& tally_;
  double limit_ = never;  // not less than the first time so far
  std::vector<Parting> partings_;
  std::vector<Waiting> waiting_;  // a heap
};

MeshMotion motion_by(void (FirstContact::*search)(), const MeshAnswer& met, const Mesh& a, const Translation& of_a,
                     const Mesh& b, const Translation& of_b) {
  MeshMotion answer;
  answer.cost = met.cost;
  StageTally tally;
  if (const auto* triangles = std::get_if<MeetingTriangles>(&met.evidence)) {
    answer.evidence = *triangles;
  } else if (const auto* within = std::get_if<PointWithin>(&met.evidence)) {
    answer.evidence = *within;
  } else if (!of_a.rests() || !of_b.rests()) {
    const MovingMesh moving_a(a, of_a), moving_b(b, of_b);
    FirstContact first(moving_a, moving_b, answer.cost, tally);
    (first.*search)();
    if (first.found) answer.evidence = *std::move(first.found);
  }
  conclude(answer, met.cost.exact + tally.exact);
  return answer;
}

}  // namespace

MeshEvidence evidence_at_start(const MeshMotion& answer) {
  SUNDER_REQUIRE(answer.meet() && contact_on_the_way(answer) == nullptr);
  if (const auto* triangles = std::get_if<MeetingTriangles>(&answer.evidence)) return *triangles;
  return std::get<PointWithin>(answer.evidence);
}

ExactFraction first_time_of(const MeshMotion& answer) {
  SUNDER_REQUIRE(answer.meet());
  const SweepContact* const contact = contact_on_the_way(answer);
  return contact != nullptr ? contact->time : ExactFraction{};
}

MeshMotion mesh_motion(const Mesh& a, const Translation& of_a, const Mesh& b, const Translation& of_b) {
  return motion_by(&FirstContact::by_trees, mesh_mesh(a, of_a.begin(), b, of_b.begin()), a, of_a, b, of_b);
}

MeshMotion mesh_motion_by_scan(const Mesh& a, const Translation& of_a, const Mesh& b, const Translation& of_b) {
  MeshMotion answer =
      motion_by(&FirstContact::by_scan, mesh_mesh_by_scan(a, of_a.begin(), b, of_b.begin()), a, of_a, b, of_b);
  answer.decided_by = DecidedBy::scan;
  return answer;
}

}  // namespace sunder::solid
