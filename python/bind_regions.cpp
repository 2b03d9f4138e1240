// What is common to half-planes, discs or convex polygons; kernels; linear programs.
#include <sunder/planar/object/constraints.h>
#include <sunder/planar/object/discs.h>
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/disc_intersection_claims.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/kernel.h>
#include <sunder/planar/region/linear_program.h>
#include <sunder/planar/region/linear_program_claims.h>
#include <sunder/planar/region/regions_claims.h>

#include "common.h"

#include <cmath>

namespace sunder::python {

namespace {

using planar::Constraints;
using planar::ConvexPolygon;
using planar::Discs;

// What is common to all of a set. Corners are kept exactly: they are asked for as fractions, or rounded.
struct Region : Answer {
  std::string_view kind;
  std::vector<std::uint32_t> sides;
  std::vector<ExactPoint2> corners;
};

struct Program : Answer {
  planar::LinearProgramAnswer answer;
  std::optional<ExactPoint2> point;
};

Returned<double, nb::shape<-1, 2>> rounded_corners(const Region& region) {
  std::vector<Point2> points;
  for (const ExactPoint2& p : region.corners) points.push_back(rounded(p));
  return array_of<double, 2>(std::move(points));
}

template <class Given>
Region region_of(const planar::Region& region, const Given& given, std::function<std::string()> text) {
  Region result{{region.cost, std::move(text)}, name_of(region.kind), region.sides, {}};
  for (const auto& [i, j] : planar::corners(region)) {
    may_be_interrupted(10);
    result.corners.push_back(exact_corner(given[i], given[j]));
  }
  return result;
}

Region half_plane_intersection(const std::shared_ptr<Constraints>& given) {
  return unlocked([&] {
    return region_of(planar::half_plane_intersection(*given), *given, [given] {
      return planar::certificate_text(*given, planar::half_plane_intersection(*given, {.evidence = true}));
    });
  });
}

Region kernel_of(const nb::object& given) {
  const planar::PolygonRings rings = one_polygon(given, "ring");
  return unlocked([&] {
    const auto polygon =
        std::make_shared<const planar::Polygon>(checked_polygon(rings, planar::PolygonRule::simple, "ring"));
    const planar::PolygonSides sides(*polygon);
    return region_of(planar::kernel(sides), sides, [polygon] {
      const planar::PolygonSides kept(*polygon);
      return planar::certificate_text(kept, planar::kernel(kept, {.evidence = true}));
    });
  });
}

Program linear_program(const std::shared_ptr<Constraints>& given, const ArrayLike& direction) {
  const auto [p, q] = numbers_of<2>(direction, "objective", {{2}});
  if (!std::isfinite(p) || !std::isfinite(q)) {
    throw Error(ErrorCode::bad_value, "a number is not finite; give finite numbers", "objective");
  }
  const planar::Objective objective{p, q};
  return unlocked([&] {
    const planar::LinearProgramAnswer answer = planar::linear_program(*given, objective);
    Program result{
        {answer.cost, [given, objective, answer] { return planar::certificate_text(*given, objective, answer); }},
        answer,
        std::nullopt};
    if (is_feasible(answer)) result.point = planar::point_of(*given, answer);
    return result;
  });
}

Region disc_intersection(const std::shared_ptr<Discs>& discs) {
  return unlocked([&] {
    const planar::DiscIntersection part = planar::disc_intersection(*discs);
    const auto text = [discs, part] { return planar::certificate_text(*discs, part); };
    return Region{{part.cost, text}, name_of(part.kind), part.arcs, {}};
  });
}

Region convex_polygon_intersection(const std::vector<ConvexPolygon>& given) {
  const auto polygons = std::make_shared<std::vector<ConvexPolygon>>(given);
  return unlocked([&] {
    const planar::PolygonsPart part = planar::convex_polygon_intersection(*polygons);
    const auto text = [polygons] { return planar::certificate_text(*polygons); };
    Region result{{part.cost, text}, name_of(part.kind), {}, {}};
    for (const planar::PolygonsCorner& corner : part.corners) {
      result.corners.push_back(exact_point(planar::corner_point(*polygons, corner)));
    }
    return result;
  });
}

}  // namespace

void bind_regions(nb::module_& planar) {
  nb::class_<Region, Answer>(planar, "Region", "What is common to all of a set.")
      .def_prop_ro(
          "kind", [](const Region& r) { return r.kind; }, "\"empty\", \"point\", \"segment\" and so on.")
      .def_prop_ro("corners", &rounded_corners, owned,
                   "(N, 2), counter-clockwise, each rounded to the nearest doubles; none of discs.")
      .def(
          "exact_corners", [](const Region& r) { return list_of(r.corners, fractions_of); },
          "The corners as pairs of fractions.Fraction.")
      .def_prop_ro(
          "sides", [](const Region& r) { return array_of<std::uint32_t>(r.sides); }, owned,
          "The half-planes, edges or discs that bound it, counter-clockwise, or that contradict each other; of convex "
          "polygons none.");
  planar.def("half_plane_intersection", &half_plane_intersection, nb::arg("constraints"),
             "What is common to all of these half-planes?");
  planar.def("kernel", &kernel_of, nb::arg("ring"),
             "From which points of a simple polygon is all of it seen? Sides are numbers of its edges.");
  planar.def("disc_intersection", &disc_intersection, nb::arg("discs"), "What is common to all of these discs?");
  planar.def("convex_polygon_intersection", &convex_polygon_intersection, nb::arg("polygons"),
             "What is common to all of these convex polygons?");

  const auto point = [](const Program& p) -> std::optional<std::pair<double, double>> {
    if (!p.point) return std::nullopt;
    return std::pair(rounded(*p.point).x, rounded(*p.point).y);
  };
  const auto exact_point = [](const Program& p) { return p.point ? nb::object(fractions_of(*p.point)) : nb::none(); };
  nb::class_<Program, Answer>(planar, "LinearProgramAnswer", "The points of a region furthest in a direction.")
      .def_prop_ro(
          "outcome", [](const Program& p) { return name_of(p.answer.verdict()); },
          "\"one\", \"many\", \"all\", \"unbounded\" or \"infeasible\".")
      .def_prop_ro("feasible", [](const Program& p) { return is_feasible(p.answer); })
      .def_prop_ro("point", point, "An optimal point (of an unbounded program, a common point), rounded to doubles.")
      .def("exact_point", exact_point, "The same as a pair of fractions.Fraction; None where infeasible.");
  planar.def("linear_program", &linear_program, nb::arg("constraints"), nb::arg("objective"),
             "Which common points of the half-planes are furthest in the direction (p, q)?");
}

}  // namespace sunder::python
