#include <sunder/solid/mesh/mesh_partition.h>

#include <sunder/base/interruption.h>
#include <sunder/base/random.h>
#include <sunder/near/box_tree.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/exact_plane.h>
#include <sunder/predicate/line/space_triangles.h>
#include <sunder/solid/mesh/cut_polygons.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/mesh/plane_choice.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

// A plane of the path to a cell, and on which side of it the cell is.
struct PathSide {
  std::int32_t plane;
  Sign sign;
};

// What is known of a mesh in a cell: all is outside, or all is inside; or neither is known.
enum class Known : std::uint8_t { nothing, outside, inside };

// A point within a cell, and how often each mesh winds around it (MeshPoint::winding), unless it is on a triangle of it.
// There may be none that is known, where a cell is thin.
struct ToldPoint {
  std::optional<FinePoint> point;
  std::array<std::optional<std::int64_t>, 2> windings;
};

struct CellParts {
  std::array<CutPolygonList, 2> parts;  // of triangles of A and of B that go through the cell
  CutPolygonList facets;                // of what of the cell is in a box around both meshes
  ToldPoint told;

  // What is known of a mesh in all of the cell. Requires that it is told.
  Known known(std::size_t m) const {
    return !parts[m].empty() ? Known::nothing : *told.windings[m] != 0 ? Known::inside : Known::outside;
  }
  // All that has to be: windings of what has no part there.
  bool is_told() const { return (!parts[0].empty() || told.windings[0]) && (!parts[1].empty() || told.windings[1]); }
};

class Partitioning {
 public:
  Partitioning(const PlacedMesh& a, const PlacedMesh& b, InsideKinds known,
               const std::optional<MeetingTriangles>& meeting)
      : meshes_{&a, &b}, found_(known), random_(20261201), cut_(a, b), choice_(a, b, cut_) {
    const double n = static_cast<double>(a.mesh().triangles().size() + b.mesh().triangles().size());
    most_ = static_cast<std::uint64_t>(100 * n * (2 + std::log2(n)));
    if (meeting) hints_ = {TriangleNumber{0, meeting->of_a}, {1, meeting->of_b}};
    for (const std::size_t m : {0u, 1u}) find_needles(m);
  }

  Partitioned run() {
    Partitioned result;
    CellParts root;
    for (CutPolygonList& parts : root.parts) parts.push_back({1});
    const Box3 box = box_around();
    if (!is_spent_) root.facets = cut_.add_box(box);
    if (!is_spent_) tell(root, CellParts());
    if (!is_spent_) divide(std::move(root));
    if (!is_spent_ && !found_.are_all()) tell_needed();
    result.is_decided = !is_spent_ || found_.are_all();
    result.found = found_;
    result.in_both = in_both_;
    result.partition = std::move(partition_);
    result.cost = cut_.cost();
    result.cost.probes = probes();
    return result;
  }

 private:
  // Around both meshes, with a margin. Its planes are none of the tree.
  Box3 box_around() {
    Box3 box = hull(meshes_[0]->node_box(1), meshes_[1]->node_box(1));
    for (std::size_t c = 0; c < 3; ++c) {
      const double low = box.low[c], high = box.high[c], size = high - low;
      box.low[c] = low - size / 4 - 0x1p-1000;
      box.high[c] = high + size / 4 + 0x1p-1000;
      if (!(size < 0x1p1000 && box.low[c] < low && high < box.high[c])) is_spent_ = true;
    }
    return box;
  }

  void find_needles(std::size_t m) {
    const Mesh& mesh = meshes_[m]->mesh();
    std::vector<Box3> boxes;
    for (std::uint32_t t = 0; mesh.has_needles() && t < mesh.triangles().size(); ++t) {
      if (!choice_.is_needle({m, t})) continue;
      needles_[m].push_back(t);
      boxes.push_back(meshes_[m]->box(t));
    }
    if (!boxes.empty()) needle_boxes_[m].emplace(boxes);
  }

  bool is_on_needle(std::size_t m, const Posed3& at) {
    if (!needle_boxes_[m]) return false;
    bool is_on = false;
    cost_.probes += needle_boxes_[m]->for_each_meeting(enclosure(at), BoxTree::no_group, [&](std::uint32_t k) {
      is_on = is_on || triangles_meet({at, at, at}, meshes_[m]->triangle(needles_[m][k]));
    });
    return is_on;
  }

  const Point3& near_first(const CutPolygon& polygon) const { return cut_.near(cut_.ring(polygon)[0].corner); }

  // ---- Points.

  // A point within the cell, of few digits if there is one. Each try is about another one.
  std::optional<FinePoint> point_in(const CutPolygonList& facets, int tries) {
    Point3 middle, low = near_first(facets[0]), high = low;
    double count = 0;
    for (const CutPolygon& facet : facets) {
      for (const RingCorner& of : cut_.ring(facet)) {
        const Point3& p = cut_.near(of.corner);
        const double weight = tries == 0 ? 1 : random_.uniform(0.5, 1.5);
        count += weight;
        for (std::size_t c = 0; c < 3; ++c) {
          middle[c] += (p[c] - middle[c]) * (weight / count);
          low[c] = std::min(low[c], p[c]);
          high[c] = std::max(high[c], p[c]);
        }
      }
    }
    for (const int digits : {2, 5, 10, 20}) {
      if (digits < 3 * tries) continue;
      FinePoint rounded;
      for (std::size_t c = 0; c < 3; ++c) {
        const double unit = std::ldexp(1.0, std::ilogb(std::max(high[c] - low[c], 0x1p-1000)) - digits);
        rounded.parts[0][c] = std::nearbyint(middle[c] / unit) * unit;
      }
      if (is_in_cell(rounded)) return rounded;
    }
    if (const FinePoint doubles{{middle}}; is_in_cell(doubles)) return doubles;
    for (const std::size_t digits : {2u, 3u, 4u}) {
      if (const FinePoint fine = fine_middle(facets, digits, tries); is_in_cell(fine)) return fine;
    }
    return std::nullopt;
  }

  // A mean of the corners, in sums of so many doubles.
  FinePoint fine_middle(const CutPolygonList& facets, std::size_t doubles, int tries) {
    std::array<Dyadic, 3> sum;
    double count = 0;
    for (const CutPolygon& facet : facets) {
      for (const RingCorner& of : cut_.ring(facet)) {
        const double weight = tries == 0 ? 1 : static_cast<double>(random_.between(1, 8));
        count += weight;
        const ExactPoint3 p = cut_.exact(of.corner);
        for (std::size_t c = 0; c < 3; ++c) {
          for (const double part : in_doubles(p[c], p.denominator, doubles)) {
            if (std::isfinite(part)) sum[c] = sum[c] + Dyadic(weight) * Dyadic(part);
          }
        }
      }
    }
    FinePoint result;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<double, 4> parts = in_doubles(sum[c], Dyadic(count), doubles);
      for (std::size_t k = 0; k < parts.size(); ++k) result.parts[k][c] = parts[k];
    }
    return result;
  }

  // The sum of the first `doubles` is about the fraction; the others are zero.
  static std::array<double, 4> in_doubles(Dyadic numerator, const Dyadic& denominator, std::size_t doubles) {
    std::array<double, 4> parts{};
    for (std::size_t k = 0; k < doubles; ++k) {
      parts[k] = nearest_ratio(numerator, denominator);
      if (!std::isfinite(parts[k])) break;  // is in no cell
      numerator = numerator - Dyadic(parts[k]) * denominator;
    }
    return parts;
  }

  static EnclosedPoint exact_of(const FinePoint& p) {
    const std::array<Dyadic, 3> at = exact(p);
    return EnclosedPoint(ExactPoint3{at[0], at[1], at[2], Dyadic(1.0)});
  }

  bool is_in_cell(const FinePoint& point) const {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!std::isfinite(point.parts[0][c])) return false;
    }
    const EnclosedPoint at = exact_of(point);
    return std::all_of(path_.begin(), path_.end(),
                       [&](const PathSide& side) { return cut_.plane(side.plane).side_of(at) == side.sign; });
  }

  // Finds a point of a part of a cell that is told. What the segment to the point of that crosses is in that. A few points
  // are tried, until none meets an edge; then rays tell, of any cell. is_spent_, where what has to be told is not.
  void tell(CellParts& part, const CellParts& of) {
    Affine3 pose, pose_of;
    const Posed3 to = of.told.point ? posed_at(*of.told.point, pose_of) : Posed3{};
    std::array<std::vector<std::uint32_t>, 2> nodes, triangles;
    for (const std::size_t m : {0u, 1u}) {
      for (const CutPolygon& each : of.parts[m]) (each.is_node() ? nodes : triangles)[m].push_back(each.of);
    }
    for (int tries = 0; tries < 20; ++tries) {
      part.told = {point_in(part.facets, tries), {}};
      if (!part.told.point) break;
      const Posed3 at = posed_at(*part.told.point, pose);
      for (const std::size_t m : {0u, 1u}) {
        if (is_on_needle(m, at)) continue;
        std::optional<std::int64_t>& winding = part.told.windings[m];
        if (of.told.windings[m]) {
          winding = crossings_among(*meshes_[m], at, to, nodes[m], triangles[m], cost_);
          if (winding) *winding += *of.told.windings[m];
        }
        if (!winding && (tries >= 2 || !of.told.windings[m]) && !is_on_triangle(*meshes_[m], at, cost_)) {
          winding = ray_away(*meshes_[m], at).winding;
        }
        if (winding && !meshes_[m]->mesh().is_by_winding()) winding = std::int64_t{*winding % 2 != 0};
      }
      if (part.told.windings[0] && part.told.windings[1]) break;
      if (tries >= 4 && part.is_told()) break;
    }
    if (!part.is_told()) is_spent_ = true;
    if (!part.told.windings[0] || !part.told.windings[1]) return;
    const bool in_a = *part.told.windings[0] != 0, in_b = *part.told.windings[1] != 0;
    if (in_a && in_b && !found_.both) in_both_ = part.told.point;
    found_.both |= in_a && in_b;
    found_.only_a |= in_a && !in_b;
    found_.only_b |= in_b && !in_a;
  }

  // ---- The walk.

  std::int32_t add_plane(const CellParts& cell, bool may_be_across) {
    const bool is_first = path_.empty() && may_be_across;
    const ChosenPlane chosen = choice_.choose(cell.parts, may_be_across, is_first ? hints_ : std::nullopt);
    return chosen.axis >= 0
               ? cut_.add_plane(ExactPlane::across_axis(static_cast<std::size_t>(chosen.axis), chosen.offset))
               : cut_.add_plane(chosen.through);
  }

  bool may_be(Known a, Known b) const {
    return (!found_.both && a != Known::outside && b != Known::outside) ||
           (!found_.only_a && a != Known::outside && b != Known::inside) ||
           (!found_.only_b && a != Known::inside && b != Known::outside);
  }

  void divide(CellParts cell) {
    may_be_interrupted(10);
    for (const std::size_t m : {0u, 1u}) {
      if (choice_.size_of(m, cell.parts[m]) <= few) cell.parts[m] = cut_.opened(m, cell.parts[m]);
    }
    if (!cell.is_told()) tell(cell, CellParts());  // nothing but needles was there
    if (is_spent_ || found_.are_all()) return;
    const std::array<Known, 2> known{cell.known(0), cell.known(1)};
    if (!may_be(known[0], known[1])) {
      partition_.cuts.push_back(0);
      partition_.cells.push_back({*cell.told.point});
      known_.push_back(known);
      return;
    }
    if (path_.size() > 2000) is_spent_ = true;
    if (is_spent_) return;
    std::int32_t plane = add_plane(cell, true);
    if (!cut_.goes_through(cell.facets)) {  // floating point did not see that it does not
      cut_.remove_plane();
      plane = add_plane(cell, false);
    }
    const ExactPlane& made = cut_.plane(plane);
    partition_.cuts.push_back(1);
    partition_.planes.push_back({{made.normal.x, made.normal.y, made.normal.z, made.offset}});
    std::array<CellParts, 2> sides;
    for (const std::size_t m : {0u, 1u}) {
      auto [above, below] = cut_.split(m, cell.parts[m]);
      sides[0].parts[m] = std::move(above);
      sides[1].parts[m] = std::move(below);
    }
    const Sign of_told = cell.told.point ? made.side_of(exact_of(*cell.told.point)) : Sign::zero;
    for (const std::size_t k : {0u, 1u}) {
      const Sign side = k == 0 ? Sign::positive : Sign::negative;
      sides[k].facets = cut_.cut_cell(cell.facets, side);
      if (sides[k].facets.empty() || probes() > most_) is_spent_ = true;
      if (is_spent_) return;
      path_.push_back({plane, side});
      if (of_told == side) sides[k].told = cell.told;
      if (of_told != side || !sides[k].is_told()) tell(sides[k], cell);
      path_.pop_back();
      if (is_spent_ || found_.are_all()) return;
    }
    cell = {};
    for (const std::size_t k : {0u, 1u}) {
      path_.push_back({plane, k == 0 ? Sign::positive : Sign::negative});
      divide(std::move(sides[k]));
      path_.pop_back();
      if (is_spent_ || found_.are_all()) return;
    }
  }

  // For each cell one or two of what is known of it, which tell that what is not found is not in it.
  void tell_needed() {
    for (std::size_t k = 0; k < known_.size(); ++k) {
      const auto [a, b] = known_[k];
      MeshPartition::Cell& cell = partition_.cells[k];
      const auto need = [&](bool is_found, bool by_a, bool by_b) {
        if (is_found || (cell.tells_a && by_a) || (cell.tells_b && by_b)) return;
        (by_a ? cell.tells_a : cell.tells_b) = true;
      };
      need(found_.both, a == Known::outside, b == Known::outside);
      need(found_.only_a, a == Known::outside, b == Known::inside);
      need(found_.only_b, a == Known::inside, b == Known::outside);
    }
  }

  std::uint64_t probes() const { return cut_.cost().probes + cost_.probes; }

  static constexpr std::size_t few = 16;  // so many triangles of a mesh in a cell are not left as nodes

  std::array<const PlacedMesh*, 2> meshes_;
  InsideKinds found_;
  Random random_;
  CutPolygons cut_;
  PlaneChoice choice_;
  std::uint64_t most_ = 0;
  bool is_spent_ = false;  // the budget is, or a point in a cell was not found
  std::optional<std::array<TriangleNumber, 2>> hints_;
  std::optional<FinePoint> in_both_;

  std::vector<PathSide> path_;
  MeshPartition partition_;
  std::vector<std::array<Known, 2>> known_;  // of each cell
  Cost cost_;                                // of segments between points, and of needles

  std::array<std::vector<std::uint32_t>, 2> needles_;  // triangles without area, of which no part is kept
  std::array<std::optional<BoxTree>, 2> needle_boxes_;
};

}  // namespace

Partitioned mesh_partition(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b, InsideKinds known,
                           const std::optional<MeetingTriangles>& meeting) {
  const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
  return Partitioning(placed_a, placed_b, known, meeting).run();
}

}  // namespace sunder::solid
