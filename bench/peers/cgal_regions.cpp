// CGAL, header only: its Boolean operations, its convex hulls, its linear programs.
#include <bench/peers/region_peer.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/General_polygon_2.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bench {
namespace {

using Constructing = CGAL::Exact_predicates_exact_constructions_kernel;
using Deciding = CGAL::Exact_predicates_inexact_constructions_kernel;

// --- Boolean operations ----------------------------------------------------------------------------------------------

using Straight = CGAL::Polygon_2<Constructing>;
using RoundTraits = CGAL::Gps_circle_segment_traits_2<Constructing>;
using Round = CGAL::General_polygon_2<RoundTraits>;

std::vector<Straight> polygons_of(const RegionInput& input) {
  std::vector<Straight> made;
  for (const Ring& ring : input.rings) {
    Straight& polygon = made.emplace_back();
    for (const Xy& p : ring) polygon.push_back({p.x, p.y});
  }
  return made;
}

std::vector<Round> discs_of(const RegionInput& input) {
  std::vector<Round> made;
  const RoundTraits traits;
  for (const Disc& d : input.discs) {
    const Constructing::FT radius(d.radius);
    const RoundTraits::Curve_2 circle(
        Constructing::Circle_2({d.center.x, d.center.y}, radius * radius, CGAL::COUNTERCLOCKWISE));
    Round& disc = made.emplace_back();
    std::list<CGAL::Object> arcs;
    traits.make_x_monotone_2_object()(circle, std::back_inserter(arcs));
    for (const CGAL::Object& object : arcs) {
      if (const auto* arc = CGAL::object_cast<RoundTraits::X_monotone_curve_2>(&object)) disc.push_back(*arc);
    }
  }
  return made;
}

std::uint64_t sides_of(const Straight& polygon) { return polygon.size(); }

std::uint64_t sides_of(const Round& figure) {
  std::uint64_t sides = 0;
  auto before = std::prev(figure.curves_end());
  for (auto at = figure.curves_begin(); at != figure.curves_end(); before = at++) {
    sides += at->supporting_circle() != before->supporting_circle();
  }
  return std::max<std::uint64_t>(sides, 1);
}

template <class Figure>
struct HolesOf;
template <>
struct HolesOf<Straight> {
  using Type = CGAL::Polygon_with_holes_2<Constructing>;
};
template <>
struct HolesOf<Round> {
  using Type = CGAL::General_polygon_with_holes_2<Round>;
};

// The one figure of the common part of the range. All are convex.
template <class Figure, class At>
Figure common_part(At begin, At end) {
  std::vector<typename HolesOf<Figure>::Type> found;
  CGAL::intersection(begin, end, std::back_inserter(found));
  if (found.size() != 1) throw std::runtime_error("CGAL found no common part, or several");
  return found.front().outer_boundary();
}

template <class Figure>
Asked by_range(std::vector<Figure> figures) {
  if (figures.empty()) return {};
  return [figures = std::move(figures)] { return sides_of(common_part<Figure>(figures.begin(), figures.end())); };
}

template <class Figure>
Asked by_pairs(std::vector<Figure> figures) {
  if (figures.empty()) return {};
  return [figures = std::move(figures)] {
    std::vector<Figure> rest = figures;
    while (rest.size() > 1) {
      std::vector<Figure> next;
      for (std::size_t i = 0; i + 1 < rest.size(); i += 2) {
        next.push_back(common_part<Figure>(rest.data() + i, rest.data() + i + 2));
      }
      if (rest.size() % 2 != 0) next.push_back(rest.back());
      rest = std::move(next);
    }
    return sides_of(rest.front());
  };
}

Asked polygons_by_range(const RegionInput& input) { return by_range(polygons_of(input)); }
Asked polygons_by_pairs(const RegionInput& input) { return by_pairs(polygons_of(input)); }
Asked discs_by_range(const RegionInput& input) { return by_range(discs_of(input)); }
Asked discs_by_pairs(const RegionInput& input) { return by_pairs(discs_of(input)); }

// --- Convex hulls ----------------------------------------------------------------------------------------------------

// The edges of polygons lie on a coarse grid: these numbers are exact.
std::vector<Inequality> half_planes_of(const RegionInput& input) {
  std::vector<Inequality> made = input.half_planes;
  for (const Ring& ring : input.rings) {
    for (std::size_t v = 0; v < ring.size(); ++v) {
      const Xy &p = ring[v], &q = ring[v + 1 == ring.size() ? 0 : v + 1];
      made.push_back({q.y - p.y, p.x - q.x, p.x * q.y - p.y * q.x});
    }
  }
  return made;
}

// The division by c is timed: it is part of the way.
template <class Kernel>
Asked by_hull(const RegionInput& input) {
  if (!input.discs.empty()) return {};
  struct Numbers {
    typename Kernel::FT a, b, c;
  };
  std::vector<Numbers> numbers;
  for (const Inequality& h : half_planes_of(input)) numbers.push_back({h.a, h.b, h.c});
  return [numbers = std::move(numbers)]() -> std::uint64_t {
    std::vector<typename Kernel::Point_2> points, hull;
    points.reserve(numbers.size());
    for (const Numbers& h : numbers) points.emplace_back(h.a / h.c, h.b / h.c);
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull), Kernel());
    return hull.size();
  };
}

}  // namespace

std::vector<RegionWay> cgal_region_ways() {
  return {{"cgal", "intersection of the range", polygons_by_range},
          {"cgal", "intersection of pairs", polygons_by_pairs},
          {"cgal", "intersection of the range of discs", discs_by_range},
          {"cgal", "intersection of pairs of discs", discs_by_pairs},
          {"hull", "convex_hull_2 of polars, exact", by_hull<Constructing>},
          {"hull", "convex_hull_2 of polars, doubles", by_hull<Deciding>}};
}

Asked cgal_linear_program(const RegionInput& input, const Objective& objective) {
  if (input.half_planes.empty()) return {};
  using Linear = CGAL::Quadratic_program<double>;
  auto program = std::make_shared<Linear>(CGAL::SMALLER, false, 0, false, 0);  // no bounds of the unknowns
  for (std::size_t i = 0; i < input.half_planes.size(); ++i) {
    const Inequality& h = input.half_planes[i];
    program->set_a(0, static_cast<int>(i), h.a);
    program->set_a(1, static_cast<int>(i), h.b);
    program->set_b(static_cast<int>(i), h.c);
  }
  program->set_c(0, -objective.x);  // it minimises
  program->set_c(1, -objective.y);
  return [program]() -> std::uint64_t {
    const auto solution = CGAL::solve_linear_program(*program, CGAL::Gmpzf());
    if (!solution.is_optimal()) return 0;
    std::vector<std::uint32_t> tight;  // those with a multiplier
    auto multiplier = solution.optimality_certificate_numerators_begin();
    for (int i = 0; i < program->get_m(); ++i, ++multiplier) {
      if (*multiplier != 0) tight.push_back(static_cast<std::uint32_t>(i));
    }
    return tight.size() == 2 ? pair_of(tight[0], tight[1]) : 0;
  };
}

}  // namespace bench
