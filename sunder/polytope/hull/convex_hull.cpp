#include <sunder/base/contract.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/hull/full_hull.h>
#include <sunder/polytope/represent/affine_columns.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace sunder::polytope {

namespace {

using Indices = std::vector<std::uint32_t>;

// In the order of their rows; of equal ones the first.
Indices in_order(const Polytope& points) {
  Indices all(points.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto compare = [&](std::uint32_t i, std::uint32_t j) {
    const auto p = points.row(i), q = points.row(j);
    for (std::size_t c = 0; c < p.size(); ++c) {
      if (p[c] != q[c]) return p[c] < q[c] ? -1 : 1;
    }
    return 0;
  };
  std::sort(all.begin(), all.end(), [&](std::uint32_t i, std::uint32_t j) {
    const int order = compare(i, j);
    return order != 0 ? order < 0 : i < j;
  });
  all.erase(std::unique(all.begin(), all.end(), [&](std::uint32_t i, std::uint32_t j) { return compare(i, j) == 0; }),
            all.end());
  return all;
}

AffineColumns columns_of(const Polytope& points) {
  return affine_columns(points.dimension(), points.size(),
                        [&](std::size_t k) { return points.row(static_cast<std::uint32_t>(k)); });
}

std::vector<double> numbers_of(const Polytope& points, std::span<const std::size_t> columns) {
  std::vector<double> numbers;
  numbers.reserve(points.size() * columns.size());
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    for (const std::size_t c : columns) numbers.push_back(points.row(k)[c]);
  }
  return numbers;
}

}  // namespace

ConvexHull convex_hull(const Polytope& points, std::uint64_t most) {
  SUNDER_REQUIRE(points.is_of_points());
  ConvexHull hull;
  hull.space = points.dimension();
  const AffineColumns flat = columns_of(points);
  for (const AffineColumns::Column& column : flat.columns) hull.columns.push_back(column.column);
  hull.dimension = hull.columns.size();
  Indices all = in_order(points);
  if (hull.dimension >= 2) {
    std::sort(all.begin(), all.end());
    hull_of_full(PlanePoints(hull.dimension, numbers_of(points, hull.columns)), std::move(all), most, hull);
    return hull;
  }
  hull.vertices = {all.front()};  // in the order of rows: of a segment the ends
  if (hull.dimension == 0) return hull;
  hull.vertices.push_back(all.back());
  std::sort(hull.vertices.begin(), hull.vertices.end());
  for (const std::uint32_t v : hull.vertices) {
    hull.facet_corners.push_back(v);
    hull.facet_begin.push_back(hull.facet_corners.size());
    hull.simplex_corners.push_back(v);
    hull.simplex_begin.push_back(hull.simplex_begin.back() + 1);
  }
  return hull;
}

std::vector<Dyadic> facet_half_space(const ConvexHull& hull, const Polytope& points, std::size_t f) {
  const std::size_t d = hull.space, k = hull.dimension;
  std::vector<Dyadic> row(d + 1);
  if (k == 1) {
    const std::size_t c = hull.columns[0];
    const std::uint32_t here = hull.vertices[f], there = hull.vertices[1 - f];
    row[c] = Dyadic(points.row(here)[c]) - Dyadic(points.row(there)[c]);
    row[d] = row[c] * points.row(here)[c];
    return row;
  }
  const auto simplex = hull.simplices(f).subspan(0, k);
  std::vector<double> numbers;
  SimplexCorners corners{};
  for (std::uint32_t i = 0; i < k; ++i) {
    corners[i] = i;
    for (const std::size_t c : hull.columns) numbers.push_back(points.row(simplex[i])[c]);
  }
  const std::vector<Dyadic> plane = PlanePoints(k, std::move(numbers)).exact_plane(corners);
  for (std::size_t c = 0; c < k; ++c) row[hull.columns[c]] = plane[c];
  row[d] = -plane[k];
  return row;
}

std::vector<std::vector<Dyadic>> flat_equations(const ConvexHull& hull, const Polytope& points) {
  std::vector<std::vector<Dyadic>> result;
  if (hull.dimension == hull.space) return result;
  const AffineColumns flat = columns_of(points);
  const auto origin = points.row(0);
  for (std::size_t c = 0; c < hull.space; ++c) {
    if (std::find(hull.columns.begin(), hull.columns.end(), c) != hull.columns.end()) continue;
    // x_c - o_c is the sum of (x - o)_column / pivot times the vectors' component c.
    std::vector<Dyadic> row(hull.space + 1);
    row[c] = flat.pivot;
    for (const AffineColumns::Column& of : flat.columns) row[of.column] = -of.vector[c];
    for (std::size_t i = 0; i < hull.space; ++i) row[hull.space] = row[hull.space] + row[i] * origin[i];
    result.push_back(std::move(row));
  }
  return result;
}

}  // namespace sunder::polytope
