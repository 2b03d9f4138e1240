// Which plane cuts a cell next? For the sources of solid/mesh; floating point will do, as no side of a plane is decided here.
// Also called: splitting heuristic of a binary space partition, as of a k-d tree by surface area.
#pragma once

#include <sunder/base/random.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/mesh/cut_polygons.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace sunder::solid {

struct ChosenPlane {
  int axis = -1;  // across it, at the offset, which is exact then; or
  TriangleNumber through;
  Point3 normal;  // about where it is
  double offset = 0;
};

// Of some planes it takes that which leaves the fewest pairs of a part of A and one of B in one cell, as a sample tells; or,
// where only one mesh has parts, halves them best.
class PlaneChoice {
 public:
  // Keeps references to all.
  PlaneChoice(const PlacedMesh& a, const PlacedMesh& b, const CutPolygons& cut)
      : meshes_{&a, &b}, cut_(cut), random_(20261201) {}

  // Of a mesh: how many triangles are there, or below the nodes that are there?
  std::size_t size_of(std::size_t m, const CutPolygon& part) const {
    return part.is_node() ? meshes_[m]->mesh().tree().triangles(part.of).size() : 1;
  }
  std::size_t size_of(std::size_t m, const CutPolygonList& parts) const {
    std::size_t sum = 0;
    for (const CutPolygon& part : parts) sum += size_of(m, part);
    return sum;
  }

  // Has it no area?
  bool is_needle(const TriangleNumber& of) const {
    const Mesh& mesh = meshes_[of.mesh]->mesh();
    const auto at = [&](std::size_t k) { return mesh.points()[mesh.triangles()[of.triangle][k]]; };
    return mesh.has_needles() && are_collinear(at(0), at(1), at(2));
  }

  // Candidates are planes across the axes, where they may be; those through the hints; and through some of the triangles.
  ChosenPlane choose(const std::array<CutPolygonList, 2>& parts, bool may_be_across,
                     const std::optional<std::array<TriangleNumber, 2>>& hints) {
    std::array<Sample, 2> samples;
    std::array<Box3, 2> ends;
    double size = 0;
    for (const std::size_t m : {0u, 1u}) {
      samples[m] = sample(m, parts[m]);
      ends[m] = ends_of(m, parts[m]);
      for (std::size_t c = 0; c < 3; ++c) {
        if (samples[m].all > 0) size = std::max({size, std::fabs(ends[m].low[c]), std::fabs(ends[m].high[c])});
      }
    }
    const bool are_two = samples[0].all > 0 && samples[1].all > 0;
    const double now = are_two ? samples[0].all * samples[1].all : samples[0].all + samples[1].all;
    ChosenPlane best;
    double least = never;
    const auto look = [&](const ChosenPlane& candidate) {
      if (least == 0 || (candidate.axis < 0 && is_needle(candidate.through))) return;
      const double left = left_after(samples, candidate, size);
      if (left < least) least = left, best = candidate;
    };
    for (std::size_t c = 0; may_be_across && c < 3; ++c) {
      if (are_two) look_at_ends(look, ends, c, seen_off_by * size);
      if (samples[0].all + samples[1].all > 8) look(across(c, middle_part(samples, c)));
    }
    if (least > 0.9 * now) least = never;  // too little
    if (hints) {
      for (const TriangleNumber& hint : *hints) look(through(hint));
    }
    for (const std::size_t m : {0u, 1u}) {
      const std::vector<std::uint32_t>& of = samples[m].triangles;
      const std::size_t tried = std::min<std::size_t>(8, of.size());
      for (std::size_t k = 0; k < tried && least > 0; ++k) {
        const std::size_t from = k * of.size() / tried, end = (k + 1) * of.size() / tried;
        look(through({m, of[from + random_.below(end - from)]}));
      }
    }
    return best;
  }

 private:
  // Floating point sees a corner off by less than this part of the largest coordinate.
  static constexpr double seen_off_by = 0x1p-36;

  static ChosenPlane across(std::size_t axis, double at) {
    ChosenPlane result;
    result.axis = static_cast<int>(axis);
    result.normal[axis] = 1;
    result.offset = at;
    return result;
  }

  ChosenPlane through(const TriangleNumber& of) const {
    ChosenPlane result;
    result.through = of;
    const std::array<Point3, 3> corners = near_corners(of.mesh, of.triangle);
    const auto& [p, q, r] = corners;
    result.normal = cross(minus(q, p), minus(r, p));
    result.offset = dot(result.normal, p);
    return result;
  }

  std::array<Point3, 3> near_corners(std::size_t m, std::uint32_t triangle) const {
    std::array<Point3, 3> corners;
    const PosedTriangle posed = meshes_[m]->triangle(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3<double> at = rounded_image(posed[k]);
      corners[k] = {at.x, at.y, at.z};
    }
    return corners;
  }

  // Some of the triangles of a mesh in a cell, as floating point sees what of them is there.
  struct Sample {
    std::vector<Point3> corners;
    std::vector<std::size_t> ends;  // of each, in corners
    std::vector<std::uint32_t> triangles;
    double all = 0, times = 1;  // of how many; each stands for so many
  };

  Sample sample(std::size_t m, const CutPolygonList& parts) const {
    constexpr std::size_t most = 64;
    Sample result;
    const std::size_t all = size_of(m, parts), step = 1 + all / most;
    std::size_t passed = 0, next = step / 2;
    for (const CutPolygon& part : parts) {
      const std::size_t size = size_of(m, part);
      for (; next < passed + size; next += step) {
        if (part.is_node() || part.is_triangle()) {
          const std::uint32_t first = part.is_node() ? meshes_[m]->mesh().tree().triangles(part.of).first : part.of;
          result.triangles.push_back(first + static_cast<std::uint32_t>(next - passed));
          const std::array<Point3, 3> corners = near_corners(m, result.triangles.back());
          result.corners.insert(result.corners.end(), corners.begin(), corners.end());
        } else {
          result.triangles.push_back(part.of);
          for (const RingCorner& corner : cut_.ring(part)) result.corners.push_back(cut_.near(corner.corner));
        }
        result.ends.push_back(result.corners.size());
      }
      passed += size;
    }
    result.all = static_cast<double>(all);
    result.times = static_cast<double>(step);
    return result;
  }

  struct Counts {
    double above = 0, below = 0, both = 0;
  };
  // How many triangles have points above the plane, below it, and on both sides, about.
  static Counts counts(const Sample& of, const ChosenPlane& candidate, double size) {
    Counts result;
    const double width =
        seen_off_by * size *
        (std::fabs(candidate.normal.x) + std::fabs(candidate.normal.y) + std::fabs(candidate.normal.z));
    std::size_t k = 0;
    for (const std::size_t end : of.ends) {
      bool above = false, below = false;
      for (; k < end; ++k) {
        const double height = dot(candidate.normal, of.corners[k]) - candidate.offset;
        above |= height > width;
        below |= height < -width;
      }
      result.above += above;
      result.below += below;
      result.both += above && below;
    }
    return {result.above * of.times, result.below * of.times, result.both * of.times};
  }

  static constexpr double never = std::numeric_limits<double>::infinity();

  // How much is left to do, about, behind the cut: pairs of a part of A and one of B in one cell.
  static double left_after(const std::array<Sample, 2>& samples, const ChosenPlane& candidate, double size) {
    const Counts a = counts(samples[0], candidate, size), b = counts(samples[1], candidate, size);
    if (samples[0].all == 0 || samples[1].all == 0) {
      return std::max(a.above, a.below) + std::max(b.above, b.below) + 2 * (a.both + b.both);
    }
    return a.above * b.above + a.below * b.below + 0.01 * (a.both + b.both);
  }

  // If one mesh ends before the other begins, the planes go there. Else they go around what both have in common, with a
  // margin: so cuts leave no slivers, and the planes have few digits.
  template <class Look>
  static void look_at_ends(const Look& look, const std::array<Box3, 2>& of, std::size_t axis, double hair) {
    const double low = std::max(of[0].low[axis], of[1].low[axis]), high = std::min(of[0].high[axis], of[1].high[axis]);
    if (high - low < hair) {
      look(across(axis, low));
      look(across(axis, high));
      return;
    }
    const double unit = std::ldexp(1.0, std::ilogb(high - low) - 8);
    look(across(axis, std::floor(low / unit - 0.5) * unit));
    look(across(axis, std::ceil(high / unit + 0.5) * unit));
  }

  // About the box of what is there. Below nodes it is searched where boxes go further than what is found so far, by more
  // than they are wide themselves where a face lies across the axis.
  Box3 ends_of(std::size_t m, const CutPolygonList& parts) const {
    constexpr double beyond = std::numeric_limits<double>::infinity();
    Box3 ends{{beyond, beyond, beyond}, {-beyond, -beyond, -beyond}};
    std::vector<std::size_t> nodes;
    for (const CutPolygon& part : parts) {
      if (part.is_node()) {
        nodes.push_back(part.of);
      } else if (part.is_triangle()) {
        for (const Point3& p : near_corners(m, part.of)) ends = hull(ends, {p, p});
      } else {
        for (const RingCorner& corner : cut_.ring(part)) {
          ends = hull(ends, {cut_.near(corner.corner), cut_.near(corner.corner)});
        }
      }
    }
    const MeshTree& tree = meshes_[m]->mesh().tree();
    for (std::size_t axis = 0; axis < 3 && !nodes.empty(); ++axis) {
      for (const double way : {-1.0, 1.0}) {
        const Reach reach(*meshes_[m], axis, way);
        std::vector<std::size_t> waiting = nodes;
        while (!waiting.empty()) {
          const std::size_t node = waiting.back();
          waiting.pop_back();
          const double found = way < 0 ? -ends.low[axis] : ends.high[axis];
          if (reach.of(tree.box(node)) <= found + reach.hair) continue;
          if (!tree.is_leaf(node)) {
            const bool is_second = reach.of(tree.box(2 * node)) < reach.of(tree.box(2 * node + 1));
            waiting.push_back(2 * node + (is_second ? 0 : 1));
            waiting.push_back(2 * node + (is_second ? 1 : 0));
            continue;
          }
          const auto [first, end] = tree.triangles(node);
          for (std::uint32_t t = first; t < end; ++t) {
            for (const Point3& p : near_corners(m, t)) ends = hull(ends, {p, p});
          }
        }
      }
    }
    return ends;
  }

  // How far boxes go along an axis of the world, one way, about.
  struct Reach {
    Point3 along;  // in the frame of the mesh
    double from, unit, hair;

    Reach(const PlacedMesh& placed, std::size_t axis, double way) {
      const auto& [linear, move] = placed.pose().affine();
      for (std::size_t c = 0; c < 3; ++c) along[c] = way * linear[3 * axis + c];
      const MeshTree& tree = placed.mesh().tree();
      from = dot(along, tree.middle()) + way * move[axis];
      unit = tree.unit();
      hair = 0x1p-18 * unit * (std::fabs(along.x) + std::fabs(along.y) + std::fabs(along.z));
    }
    double of(const OrientedBox& box) const {
      const auto at = [&](std::size_t k) {
        return along.x * static_cast<double>(box.x[k]) + along.y * static_cast<double>(box.y[k]) +
               along.z * static_cast<double>(box.z[k]);
      };
      double sum = at(3);
      for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(at(k)) * static_cast<double>(box.half[k]);
      return from + unit * sum;
    }
  };

  // About the median of where triangles are along an axis, with few digits.
  static double middle_part(const std::array<Sample, 2>& samples, std::size_t axis) {
    std::vector<double> places;
    for (const Sample& of : samples) {
      for (const std::size_t end : of.ends) places.push_back(of.corners[end - 1][axis]);
    }
    const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), middle, places.end());
    const auto [least, greatest] = std::minmax_element(places.begin(), places.end());
    const double unit = std::ldexp(1.0, std::ilogb(std::max(*greatest - *least, 0x1p-1000)) - 8);
    return std::nearbyint(*middle / unit) * unit + unit / 4;
  }

  std::array<const PlacedMesh*, 2> meshes_;
  const CutPolygons& cut_;
  Random random_;
};

}  // namespace sunder::solid
