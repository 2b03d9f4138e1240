#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/polytope/hull/double_description_internal.h>
#include <sunder/polytope/hull/full_hull.h>
#include <sunder/polytope/hull/pulling.h>
#include <sunder/polytope/hull/vertices.h>
#include <sunder/polytope/hull/vertices_internal.h>
#include <sunder/polytope/pair/phase_one_internal.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace sunder::polytope {

namespace {

// What a half-space leaves to the point x / w, times w: b w - a x.
Dyadic slack(std::span<const double> row, std::span<const Dyadic> point) {
  const std::size_t d = row.size() - 1;
  Dyadic sum = Dyadic(row[d]) * point[d];
  for (std::size_t c = 0; c < d; ++c) {
    if (row[c] != 0) sum = sum - point[c] * row[c];
  }
  return sum;
}

// 0 x <= 0: all of space, of which no point is strictly inside.
bool is_zero(std::span<const double> row) {
  return std::all_of(row.begin(), row.end(), [](double x) { return x == 0; });
}

bool is_inside(const Polytope& half_spaces, std::span<const Dyadic> point) {
  for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
    if (!is_zero(half_spaces.row(k)) && slack(half_spaces.row(k), point).sign() != Sign::positive) return false;
  }
  return true;
}

// The nearest point of doubles, if it is inside too: numbers that are as short make all others short.
std::vector<Dyadic> rounded_inside(const Polytope& half_spaces, std::vector<Dyadic> point) {
  std::vector<Dyadic> rounded;
  for (std::size_t c = 0; c < half_spaces.dimension(); ++c) {
    const double x = nearest_ratio(point[c], point.back());
    if (!std::isfinite(x)) return point;
    rounded.emplace_back(x);
  }
  rounded.emplace_back(1.0);
  return is_inside(half_spaces, rounded) ? rounded : point;
}

constexpr const char* unbounded = "the half-spaces are not bounded; give bounded ones";

[[noreturn]] void refuse(const char* what) { throw Error(ErrorCode::bad_shape, what); }

}  // namespace

std::vector<Dyadic> point_inside(const Polytope& half_spaces) {
  SUNDER_REQUIRE(!half_spaces.is_of_points());
  const std::size_t d = half_spaces.dimension();
  // Rows: the coordinates, b, and one for the sum of the multipliers, which is 1. Columns: (a, b, 1); and (0, 1, 0).
  PhaseOne program(d + 2, 1);
  std::vector<Dyadic> unit(d + 2), column(d + 2);
  unit[d] = 1.0;
  column[d + 1] = 1.0;
  while (!program.is_solved()) {
    if (program.enter_if_it_pays({1, 0}, unit)) continue;
    const std::vector<Dyadic> y = program.multipliers();
    std::optional<std::uint32_t> best;
    Dyadic greatest;
    for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
      const auto row = half_spaces.row(k);
      if (is_zero(row)) continue;
      Dyadic price = y[d + 1];
      for (std::size_t c = 0; c <= d; ++c) {
        if (row[c] != 0) price = price + y[c] * row[c];
      }
      if (price.sign() != Sign::positive || (best && (price - greatest).sign() != Sign::positive)) continue;
      best = k;
      greatest = std::move(price);
    }
    if (!best) {  // y a + y_b b + y_1 <= 0 for all, y_b <= 0, and y_1 > 0
      std::vector<Dyadic> point(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(d));
      point.push_back(-y[d]);
      return point;
    }
    const auto row = half_spaces.row(*best);
    for (std::size_t c = 0; c <= d; ++c) column[c] = row[c];
    program.enter_if_it_pays({0, *best}, column);
  }
  return {};
}

namespace {

// The rows of the facets: no other row is on all their vertices, but such that are the same, of which the first counts.
Bits bounding_of(std::size_t rows, const std::vector<Bits>& on) {
  std::vector<Bits> common(rows);
  std::vector<std::size_t> counts(rows);
  for (const Bits& at : on) {
    for (std::size_t row = 0; row < rows; ++row) {
      if (!has(at, row)) continue;
      if (counts[row]++ == 0) common[row] = at;
      keep_common(common[row], at);
    }
  }
  Bits result = no_bits(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    if (counts[row] == 0) continue;
    const std::vector<std::uint32_t> there = members_of(common[row]);
    const bool is_facet = std::all_of(
        there.begin(), there.end(), [&](std::uint32_t other) { return other >= row && counts[other] == counts[row]; });
    if (is_facet) add(result, row);
  }
  return result;
}

// By the rays of the cone of all (x, w), w > 0, with a x <= b w. False where that gives up.
bool add_vertices_by_rays(std::size_t d, std::span<const Dyadic> rows, IntegerKind kind, std::uint64_t most,
                          PolytopeVertices& result) {
  std::vector<Dyadic> cone(rows.begin(), rows.end());
  for (std::size_t k = 0; k < cone.size(); ++k) {
    if (k % (d + 1) != d) cone[k] = -cone[k];
  }
  std::optional<ConeRays> found = double_description(d + 1, cone, kind);
  if (!found) return false;
  const auto is_vertex = [&](const auto& ray) { return ray[d] > 0; };
  if (found->has_lines || !std::all_of(found->rays.begin(), found->rays.end(), is_vertex)) refuse(unbounded);
  const Bits bounding = bounding_of(rows.size() / (d + 1), found->on);
  for (Bits& on : found->on) keep_common(on, bounding);
  std::vector<std::vector<std::uint32_t>> fans;
  if (!pulled_simplices(d, found->on, found->next, most, fans)) return false;
  result.bounding = members_of(bounding);
  std::vector<std::vector<std::uint32_t>> at;
  for (const Bits& on : found->on) at.push_back(members_of(on));
  std::vector<std::uint32_t> order(at.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t k, std::uint32_t m) { return at[k] < at[m]; });
  for (const std::uint32_t k : order) {
    result.vertices.emplace_back();
    for (const Integer& x : found->rays[k]) result.vertices.back().push_back(dyadic_of(x, 0));
    result.at.push_back(std::move(at[k]));
    result.fans.push_back(std::move(fans[k]));
  }
  result.side_tests = found->signs;
  result.exact_tests = kind == IntegerKind::any ? found->signs : 0;
  return true;
}

}  // namespace

void add_vertices(std::size_t d, std::span<const Dyadic> rows, std::uint64_t most, PolytopeVertices& result) {
  if (add_vertices_by_rays(d, rows, IntegerKind::words, most, result)) return;
  // Seen from the point c = n / w inside, a half-space is a (x - c) <= b - a c = s / w, so its point of the polar is
  // a w / s. A plane n y = h of the polar, h > 0, is the point c + n / h.
  const Dyadic& w = result.inside[d];
  std::vector<Dyadic> polar;
  for (std::size_t k = 0; k < rows.size(); k += d + 1) {
    Dyadic slack = rows[k + d] * w;
    for (std::size_t c = 0; c < d; ++c) {
      polar.push_back(w * rows[k + c]);
      slack = slack - result.inside[c] * rows[k + c];
    }
    polar.push_back(std::move(slack));
  }
  std::vector<std::uint32_t> all(rows.size() / (d + 1));
  const PlanePoints points(d, std::move(polar));
  std::iota(all.begin(), all.end(), 0u);
  if (spanning(points, all).size() <= d) refuse(unbounded);
  ConvexHull hull;
  hull.space = hull.dimension = d;
  if (!hull_of_full(points, all, most, hull, Degenerate::gives_up)) {
    if (add_vertices_by_rays(d, rows, IntegerKind::any, most, result)) return;
    hull_of_full(points, std::move(all), most, hull);
  }
  result.side_tests = hull.side_tests;
  result.exact_tests = hull.exact_tests;
  result.bounding = hull.vertices;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    may_be_interrupted(100);
    const auto simplices = hull.simplices(f);
    SimplexCorners corners{};
    std::copy_n(simplices.begin(), d, corners.begin());
    const std::vector<Dyadic> plane = points.exact_plane(corners);
    const Dyadic height = -plane[d];
    if (height.sign() != Sign::positive) refuse(unbounded);
    std::vector<Dyadic> vertex;
    for (std::size_t c = 0; c < d; ++c) vertex.push_back(result.inside[c] * height + plane[c] * w);
    vertex.push_back(w * height);
    result.vertices.push_back(std::move(vertex));
    const auto on = hull.facet_vertices(f);
    result.at.emplace_back(on.begin(), on.end());
    result.fans.emplace_back(simplices.begin(), simplices.end());
  }
}

PolytopeVertices vertices_of(const Polytope& half_spaces, std::uint64_t most) {
  const std::size_t d = half_spaces.dimension();
  PolytopeVertices result;
  result.inside = point_inside(half_spaces);
  if (result.inside.empty()) {
    const bool is_empty = !polytope_polytope(half_spaces, Pose(d), half_spaces, Pose(d)).meet();
    refuse(is_empty ? "the half-spaces have no common point"
                    : "what the half-spaces have in common lies in a hyperplane");
  }
  if (result.inside[d].sign() == Sign::zero) refuse(unbounded);
  result.inside = rounded_inside(half_spaces, std::move(result.inside));
  std::vector<Dyadic> rows;
  for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
    const auto row = half_spaces.row(k);
    rows.insert(rows.end(), row.begin(), row.end());
    if (is_zero(row)) rows.back() = 1.0;
  }
  add_vertices(d, rows, most, result);
  return result;
}

}  // namespace sunder::polytope
