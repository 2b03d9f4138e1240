#include <sunder/solid/mesh/mesh_partition.h>

#include <sunder/base/interruption.h>
#include <sunder/base/random.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/exact_plane.h>
#include <sunder/solid/mesh/cut_polygons.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace sunder::solid {

namespace {

// Floating point sees a corner off by less than this part of the largest coordinate. The search for a plane uses it; no
// side of a plane is decided by it.
constexpr double seen_off_by = 0x1p-36;

// A plane that may cut a cell: how it is made exactly, and about where it is.
struct Candidate {
  int axis = -1;  // across it, or
  bool is_of_b = false;
  std::uint32_t triangle = 0;  // through one of this mesh
  Point3 normal;
  double offset = 0;
};

// A plane of the path to a cell, and on which side of it the cell is.
struct PathSide {
  std::int32_t plane;
  Sign sign;
};

// What is known of a mesh in a cell: all is outside, or all is inside; or neither is known.
enum class Known : std::uint8_t { nothing, outside, inside };

struct CellParts {
  std::array<CutPolygonList, 2> parts;  // of triangles of A and of B that go through the cell
  CutPolygonList facets;                // of what of the cell is in a box around both meshes
  std::array<Known, 2> known{};
};

// From the point of a cell, where they have been made.
using Rays = std::array<std::optional<RayAway>, 2>;

struct KnownCell {
  std::array<Known, 2> known;
  Rays rays;
};

class Partitioning {
 public:
  Partitioning(const PlacedMesh& a, const PlacedMesh& b, InsideKinds known)
      : meshes_{&a, &b}, found_(known), random_(20261201) {
    const double n = static_cast<double>(a.mesh().triangles().size() + b.mesh().triangles().size());
    most_ = static_cast<std::uint64_t>(100 * n * (2 + std::log2(n)));
  }

  Partitioned run() {
    Partitioned result;
    CellParts root;
    for (const std::size_t m : {0u, 1u}) add_triangles(m, root.parts[m]);
    const Box3 box = box_around();
    if (!is_spent_) root.facets = cut_.add_box(box);
    if (!is_spent_) divide(std::move(root));
    if (!is_spent_ && !found_.are_all()) add_rays();
    result.is_decided = !is_spent_ || found_.are_all();
    result.found = found_;
    result.in_both = in_both_;
    result.partition = std::move(partition_);
    result.cost = cut_.cost();
    return result;
  }

 private:
  // ---- What there is at first.

  void add_triangles(std::size_t m, CutPolygonList& parts) {
    const Mesh& mesh = meshes_[m]->mesh();
    first_corner_[m] = static_cast<std::uint32_t>(cut_.corner_count());
    for (std::uint32_t k = 0; k < mesh.points().size(); ++k) {
      cut_.add_corner(EnclosedPoint(exact_point(coordinates<Dyadic>(meshes_[m]->at(k)))));
    }
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
      if (mesh.pieces()[mesh.piece_of(t)].kind == PieceKind::open) continue;
      const Mesh::Triangle& corners = mesh.triangles()[t];
      const auto at = [&](std::size_t k) { return mesh.points()[corners[k]]; };
      if (are_on_a_line(at(0), at(1), at(2))) {
        has_needles_[m] = true;
        continue;
      }
      const std::uint32_t first = first_corner_[m];
      const std::array<RingCorner, 3> ring{
          RingCorner{first + corners[0], -1}, {first + corners[1], -2}, {first + corners[2], -3}};
      parts.push_back(cut_.add_polygon(t, ring));
    }
  }

  static bool are_on_a_line(const Point3& p, const Point3& q, const Point3& r) {
    const ExactPlane plane =
        ExactPlane::through(coordinates<Dyadic>(p), coordinates<Dyadic>(q), coordinates<Dyadic>(r));
    return plane.has_no_normal();
  }

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

  // ---- Cuts.

  const ExactPlane& plane_of(std::size_t m, std::uint32_t triangle) {
    auto found = triangle_planes_[m].find(triangle);
    if (found == triangle_planes_[m].end()) {
      const PosedTriangle corners = meshes_[m]->triangle(triangle);
      found =
          triangle_planes_[m]
              .emplace(triangle, ExactPlane::through(coordinates<Dyadic>(corners[0]), coordinates<Dyadic>(corners[1]),
                                                     coordinates<Dyadic>(corners[2])))
              .first;
    }
    return found->second;
  }

  void cut_parts(std::size_t m, const CutPolygonList& parts, std::int32_t plane, CutPolygonList& above,
                 CutPolygonList& below) {
    for (const CutPolygon& part : parts) {
      const auto [has_above, has_below] = cut_.above_and_below(part, plane);
      if (has_above && has_below) {
        std::vector<RingCorner> made;  // two edges are crossed at most, once for both sides
        const auto corner_on = [&](std::int32_t edge) {
          for (const RingCorner& known : made) {
            if (known.edge == edge) return known.corner;
          }
          made.push_back({cut_.add_corner(part_corner(m, part.of, edge, plane)), edge});
          return made.back().corner;
        };
        above.push_back(cut_.clipped(part, plane, Sign::positive, corner_on));
        below.push_back(cut_.clipped(part, plane, Sign::negative, corner_on));
      } else if (has_above) {
        above.push_back(part);
      } else if (has_below) {
        below.push_back(part);
      }
    }
  }

  EnclosedPoint part_corner(std::size_t m, std::uint32_t triangle, std::int32_t edge, std::int32_t plane) {
    const ExactPlane& cut = cut_.plane(plane);
    if (edge >= 0) return common_point(plane_of(m, triangle), cut_.plane(edge), cut);
    const Mesh::Triangle& corners = meshes_[m]->mesh().triangles()[triangle];
    const auto k = static_cast<std::size_t>(-1 - edge);
    return crossing_of(cut, cut_.corner(first_corner_[m] + corners[k]).exact,
                       cut_.corner(first_corner_[m] + corners[(k + 1) % 3]).exact);
  }

  const Point3& near_first(const CutPolygon& polygon) const { return cut_.near(cut_.ring(polygon)[0].corner); }

  // ---- Points.

  // A point within the cell, of few digits if there is one; any, where is_spent_ is set. Each try is about another one.
  FinePoint point_in(const CutPolygonList& facets, int tries) {
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
    FinePoint fine;
    for (const std::size_t digits : {2u, 3u, 4u}) {
      fine = fine_middle(facets, digits);
      if (is_in_cell(fine)) return fine;
    }
    is_spent_ = true;
    return fine;
  }

  // The mean of the corners, in sums of so many doubles.
  FinePoint fine_middle(const CutPolygonList& facets, std::size_t doubles) const {
    std::array<Dyadic, 3> sum;
    double count = 0;
    for (const CutPolygon& facet : facets) {
      for (const RingCorner& of : cut_.ring(facet)) {
        ++count;
        const ExactPoint3& p = cut_.corner(of.corner).exact;
        for (std::size_t c = 0; c < 3; ++c) {
          for (const double part : in_doubles(p[c], p.denominator, doubles)) {
            if (std::isfinite(part)) sum[c] = sum[c] + Dyadic(part);
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

  // A point within the cell which is on no triangle without an area of a mesh that has no other ones there.
  FinePoint clear_point(const CellParts& cell) {
    for (int tries = 0; tries < 20 && !is_spent_; ++tries) {
      const FinePoint point = point_in(cell.facets, tries);
      const auto is_clear = [&](std::size_t m) {
        return !has_needles_[m] || !cell.parts[m].empty() || place_of(point, m) != MeshPlace::on;
      };
      if (is_spent_ || (is_clear(0) && is_clear(1))) return point;
    }
    is_spent_ = true;
    return {};
  }

  MeshPlace place_of(const FinePoint& point, std::size_t m) const {
    Affine3 pose;
    return mesh_point(meshes_[m]->mesh(), meshes_[m]->pose(), posed_at(point, pose)).place;
  }

  // ---- Which plane?

  struct Extent {
    Point3 low{most, most, most}, high{-most, -most, -most};
    static constexpr double most = std::numeric_limits<double>::infinity();
  };
  Extent extent(const CutPolygonList& parts) const {
    Extent result;
    for (const CutPolygon& part : parts) {
      for (const RingCorner& corner : cut_.ring(part)) {
        const Point3& p = cut_.near(corner.corner);
        for (std::size_t c = 0; c < 3; ++c) {
          result.low[c] = std::min(result.low[c], p[c]);
          result.high[c] = std::max(result.high[c], p[c]);
        }
      }
    }
    return result;
  }

  static Candidate across(std::size_t axis, double at) {
    Candidate result;
    result.axis = static_cast<int>(axis);
    result.normal[axis] = 1;
    result.offset = at;
    return result;
  }

  Candidate through(std::size_t m, std::uint32_t triangle) const {
    Candidate result;
    result.is_of_b = m == 1;
    result.triangle = triangle;
    const Mesh::Triangle& of = meshes_[m]->mesh().triangles()[triangle];
    const auto corner = [&](std::size_t k) { return cut_.near(first_corner_[m] + of[k]); };
    const Point3 p = corner(0), q = corner(1), r = corner(2);
    const Point3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
    result.normal = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    result.offset = dot(result.normal, p);
    return result;
  }

  struct Counts {
    double above = 0, below = 0, both = 0;
  };
  // How many parts have points above the plane, below it, and on both sides. Looks at some of them in floating point, and
  // counts the others in proportion.
  Counts counts(const CutPolygonList& parts, const Candidate& candidate, double size) const {
    Counts result;
    const std::size_t step = 1 + parts.size() / 128;
    const double width =
        seen_off_by * size *
        (std::fabs(candidate.normal.x) + std::fabs(candidate.normal.y) + std::fabs(candidate.normal.z));
    for (std::size_t i = 0; i < parts.size(); i += step) {
      bool above = false, below = false;
      for (const RingCorner& corner : cut_.ring(parts[i])) {
        const double height = dot(candidate.normal, cut_.near(corner.corner)) - candidate.offset;
        above |= height > width;
        below |= height < -width;
      }
      result.above += above;
      result.below += below;
      result.both += above && below;
    }
    const double times = static_cast<double>(step);
    return {result.above * times, result.below * times, result.both * times};
  }

  static constexpr double never = std::numeric_limits<double>::infinity();

  // How much is left to do, about, behind the cut: pairs of a part of A and one of B in one cell.
  double left_after(const CellParts& cell, const Candidate& candidate, double size) const {
    const Counts a = counts(cell.parts[0], candidate, size), b = counts(cell.parts[1], candidate, size);
    if (cell.parts[0].empty() || cell.parts[1].empty()) {
      return std::max(a.above, a.below) + std::max(b.above, b.below) + 2 * (a.both + b.both);
    }
    return a.above * b.above + a.below * b.below + 0.01 * (a.both + b.both);
  }

  Candidate choose(const CellParts& cell, bool may_be_across) {
    const std::array<Extent, 2> of{extent(cell.parts[0]), extent(cell.parts[1])};
    double size = 0;
    std::vector<Candidate> candidates;
    const bool are_two = !cell.parts[0].empty() && !cell.parts[1].empty();
    const double now = are_two ? static_cast<double>(cell.parts[0].size()) * static_cast<double>(cell.parts[1].size())
                               : static_cast<double>(cell.parts[0].size() + cell.parts[1].size());
    for (std::size_t c = 0; c < 3; ++c) {
      for (const Extent& e : of) {
        if (e.low.x <= e.high.x) size = std::max({size, std::fabs(e.low[c]), std::fabs(e.high[c])});
      }
    }
    for (std::size_t c = 0; may_be_across && c < 3; ++c) {
      if (are_two) add_ends(candidates, of, c, seen_off_by * size);
      if (cell.parts[0].size() + cell.parts[1].size() > 8) candidates.push_back(across(c, middle_part(cell, c)));
    }
    Candidate best;
    double least = never;
    const auto look = [&](const Candidate& candidate) {
      const double left = left_after(cell, candidate, size);
      if (left < least) least = left, best = candidate;
    };
    for (const Candidate& candidate : candidates) look(candidate);
    if (least > 0.9 * now) least = never;  // too little
    for (const std::size_t m : {0u, 1u}) {
      const CutPolygonList& parts = cell.parts[m];
      const std::size_t tried = std::min<std::size_t>(8, parts.size());
      for (std::size_t k = 0; k < tried; ++k) {
        if (least == 0) break;
        const std::size_t from = k * parts.size() / tried, end = (k + 1) * parts.size() / tried;
        look(through(m, parts[from + random_.below(end - from)].of));
      }
    }
    return best;
  }

  // If one mesh ends before the other begins, the planes go there. Else they go around what both have in common, with a
  // margin: so cuts leave no slivers, and the planes have few digits.
  static void add_ends(std::vector<Candidate>& candidates, const std::array<Extent, 2>& of, std::size_t axis,
                       double hair) {
    const double low = std::max(of[0].low[axis], of[1].low[axis]), high = std::min(of[0].high[axis], of[1].high[axis]);
    if (high - low < hair) {
      candidates.push_back(across(axis, low));
      candidates.push_back(across(axis, high));
      return;
    }
    const double unit = std::ldexp(1.0, std::ilogb(high - low) - 8);
    candidates.push_back(across(axis, std::floor(low / unit - 0.5) * unit));
    candidates.push_back(across(axis, std::ceil(high / unit + 0.5) * unit));
  }

  // About the median of where parts are along an axis, with few digits.
  double middle_part(const CellParts& cell, std::size_t axis) {
    std::vector<double> places;
    for (const CutPolygonList& parts : cell.parts) {
      const std::size_t step = 1 + parts.size() / 64;
      for (std::size_t i = 0; i < parts.size(); i += step) places.push_back(near_first(parts[i])[axis]);
    }
    const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), middle, places.end());
    const auto [least, greatest] = std::minmax_element(places.begin(), places.end());
    const double unit = std::ldexp(1.0, std::ilogb(std::max(*greatest - *least, 0x1p-1000)) - 8);
    return std::nearbyint(*middle / unit) * unit + unit / 4;
  }

  ExactPlane exact_of(const Candidate& candidate) {
    return candidate.axis >= 0 ? ExactPlane::across_axis(static_cast<std::size_t>(candidate.axis), candidate.offset)
                               : plane_of(candidate.is_of_b ? 1 : 0, candidate.triangle);
  }

  // ---- The walk.

  bool may_be(Known a, Known b) const {
    return (!found_.both && a != Known::outside && b != Known::outside) ||
           (!found_.only_a && a != Known::outside && b != Known::inside) ||
           (!found_.only_b && a != Known::inside && b != Known::outside);
  }

  void divide(CellParts cell) {
    may_be_interrupted(10);
    std::optional<FinePoint> point;
    Rays rays;
    for (const std::size_t m : {0u, 1u}) {
      if (!cell.parts[m].empty() || cell.known[m] != Known::nothing) continue;
      if (!point) point = clear_point(cell);
      if (is_spent_) return;
      Affine3 pose;
      rays[m] = ray_away(*meshes_[m], posed_at(*point, pose));
      cell.known[m] = rays[m]->winding != 0 ? Known::inside : Known::outside;
    }
    if (point && cell.known[0] != Known::nothing && cell.known[1] != Known::nothing) {
      const bool in_a = cell.known[0] == Known::inside, in_b = cell.known[1] == Known::inside;
      if (in_a && in_b && !found_.both) in_both_ = point;
      found_.both |= in_a && in_b;
      found_.only_a |= in_a && !in_b;
      found_.only_b |= in_b && !in_a;
    }
    if (found_.are_all()) return;
    if (!may_be(cell.known[0], cell.known[1])) {
      partition_.cuts.push_back(0);
      partition_.cells.push_back({point ? *point : clear_point(cell), {}, {}});
      known_.push_back({cell.known, std::move(rays)});
      return;
    }
    if (path_.size() > 2000) is_spent_ = true;
    if (is_spent_) return;
    const std::int32_t plane = cut_.add_plane(exact_of(choose(cell, true)));
    if (!cut_.goes_through(cell.facets, plane)) {  // floating point did not see that it does not
      cut_.replace_plane(exact_of(choose(cell, false)));
    }
    const ExactPlane& made = cut_.plane(plane);
    partition_.cuts.push_back(1);
    partition_.planes.push_back({{made.normal.x, made.normal.y, made.normal.z, made.offset}});
    std::array<CellParts, 2> sides;
    for (CellParts& side : sides) side.known = cell.known;
    for (const std::size_t m : {0u, 1u}) {
      cut_parts(m, cell.parts[m], plane, sides[0].parts[m], sides[1].parts[m]);
    }
    for (const std::size_t k : {0u, 1u}) {
      sides[k].facets = cut_.cut_cell(cell.facets, plane, k == 0 ? Sign::positive : Sign::negative);
      if (sides[k].facets.empty()) is_spent_ = true;
    }
    if (cut_.cost().probes > most_ || is_spent_) {
      is_spent_ = true;
      return;
    }
    cell = {};
    for (const std::size_t k : {0u, 1u}) {
      path_.push_back({plane, k == 0 ? Sign::positive : Sign::negative});
      divide(std::move(sides[k]));
      path_.pop_back();
      if (is_spent_ || found_.are_all()) return;
    }
  }

  // For each cell rays that tell that what is not found is not in it.
  void add_rays() {
    for (std::size_t k = 0; k < known_.size(); ++k) {
      const auto [a, b] = known_[k].known;
      bool of_a = false, of_b = false;
      const auto need = [&](bool is_found, bool by_a, bool by_b) {
        if (is_found || (of_a && by_a) || (of_b && by_b)) return;
        (by_a ? of_a : of_b) = true;
      };
      need(found_.both, a == Known::outside, b == Known::outside);
      need(found_.only_a, a == Known::outside, b == Known::inside);
      need(found_.only_b, a == Known::inside, b == Known::outside);
      MeshPartition::Cell& cell = partition_.cells[k];
      const auto along = [&](std::size_t m) {
        Affine3 pose;
        const std::optional<RayAway>& ray = known_[k].rays[m];
        return ray ? ray->along : ray_away(*meshes_[m], posed_at(cell.point, pose)).along;
      };
      if (of_a) cell.ray_a = along(0);
      if (of_b) cell.ray_b = along(1);
    }
  }

  std::array<const PlacedMesh*, 2> meshes_;
  InsideKinds found_;
  Random random_;
  std::uint64_t most_ = 0;
  bool is_spent_ = false;              // the budget is, or a point in a cell was not found
  std::array<bool, 2> has_needles_{};  // triangles without an area
  std::optional<FinePoint> in_both_;

  CutPolygons cut_;
  std::array<std::uint32_t, 2> first_corner_{};
  std::array<std::unordered_map<std::uint32_t, ExactPlane>, 2> triangle_planes_;

  std::vector<PathSide> path_;
  MeshPartition partition_;
  std::vector<KnownCell> known_;  // of each cell
};

}  // namespace

Partitioned mesh_partition(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b, InsideKinds known) {
  const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
  return Partitioning(placed_a, placed_b, known).run();
}

}  // namespace sunder::solid
