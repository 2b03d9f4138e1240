// What is common to half-planes, discs or convex polygons; kernels; linear programs.
#include <sunder/planar/object/constraints.h>
#include <sunder/planar/object/discs.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/convex_polygon_intersection_json.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/disc_intersection_json.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/half_plane_intersection_json.h>
#include <sunder/planar/region/kernel.h>
#include <sunder/planar/region/kernel_json.h>
#include <sunder/planar/region/linear_program.h>
#include <sunder/planar/region/linear_program_json.h>
#include <sunder/planar/set/polygon_valid.h>

#include "polygons.h"

#include <cmath>

namespace sunder::python {

namespace {

using planar::Constraints;
using planar::ConvexPolygon;
using planar::Discs;

// Corners are kept exactly: each is asked for as fractions, or rounded.
struct Part : Answer {
  std::string_view kind;
  std::vector<ExactPoint2> corners;
};

struct PythonRegion : Part {
  std::vector<std::uint32_t> sides;
};

struct Program : Answer {
  planar::LinearProgramAnswer answer;
  std::optional<ExactPoint2> point;
};

Returned<double, nb::shape<-1, 2>> rounded_corners(const Part& part) {
  std::vector<Point2> points;
  for (const ExactPoint2& p : part.corners) points.push_back(rounded(p));
  return array_of<double, 2>(std::move(points));
}

nb::list exact_corners(const Part& part) {
  nb::list list;
  for (const ExactPoint2& p : part.corners) list.append(fractions_of(p));
  return list;
}

template <class Given>
PythonRegion region_of(const planar::Region& region, const Given& given, std::function<std::string()> text) {
  PythonRegion result{{{region.cost, std::move(text)}, name_of(region.kind), {}}, region.sides};
  for (const auto& [i, j] : planar::corners(region)) result.corners.push_back(exact_corner(given[i], given[j]));
  return result;
}

PythonRegion half_plane_intersection(const std::shared_ptr<Constraints>& given) {
  return unlocked([&] {
    return region_of(planar::half_plane_intersection(*given), *given, [given] {
      return planar::certificate_text(*given, planar::half_plane_intersection(*given, {.evidence = true}));
    });
  });
}

PythonRegion kernel_of(const nb::object& given) {
  const planar::PolygonRings rings = rings_of(given, "ring");
  const auto polygon = std::make_shared<const planar::Polygon>(rings);
  return unlocked([&] {
    const planar::PolygonSides sides(*polygon);
    if (!planar::polygon_defects(*polygon, {planar::PolygonRule::simple, 1}).valid()) {
      throw Error(ErrorCode::bad_shape,
                  "it is not simple, and only simple polygons have a kernel; polygon_defects tells "
                  "where",
                  "ring");
    }
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
    if (answer.feasible()) result.point = planar::point_of(*given, answer);
    return result;
  });
}

std::optional<std::uint32_t> number_of(std::uint32_t half_plane) {
  return half_plane == planar::no_half_plane ? std::nullopt : std::optional(half_plane);
}

struct DiscsPart : Answer {
  std::string_view kind;
  std::vector<std::uint32_t> arcs;
};

DiscsPart disc_intersection(const std::shared_ptr<Discs>& discs) {
  return unlocked([&] {
    const planar::DiscIntersection part = planar::disc_intersection(*discs);
    return DiscsPart{
        {part.cost, [discs, part] { return planar::certificate_text(*discs, part); }}, name_of(part.kind), part.arcs};
  });
}

Part convex_polygon_intersection(const std::vector<const ConvexPolygon*>& given) {
  const auto polygons = std::make_shared<std::vector<ConvexPolygon>>();
  for (const ConvexPolygon* polygon : given) polygons->push_back(*polygon);
  return unlocked([&] {
    const planar::PolygonsPart part = planar::convex_polygon_intersection(*polygons);
    Part result{{part.cost, [polygons] { return planar::certificate_text(*polygons); }}, name_of(part.kind), {}};
    for (const planar::PolygonsCorner& corner : part.corners) {
      result.corners.push_back(exact_point(planar::corner_point(*polygons, corner)));
    }
    return result;
  });
}

}  // namespace

void bind_regions(nb::module_& planar) {
  nb::class_<Constraints>(planar, "Constraints", "Half-planes a x + b y <= c, numbered from 0: rows a, b, c.")
      .def(
          "__init__",
          [](Constraints* self, const ArrayLike& given) {
            const Doubles rows = doubles_of(given, "constraints", {{any_length, 3}});
            const auto* const first = reinterpret_cast<const Constraint*>(rows.data());
            new (self) Constraints(std::vector<Constraint>(first, first + rows.shape(0)));
          },
          nb::arg("constraints"))
      .def("__len__", &Constraints::size);
  nb::class_<Part, Answer>(planar, "CommonPart", "What is common to all of a set.")
      .def_prop_ro(
          "kind", [](const Part& part) { return part.kind; }, "\"empty\", \"point\", \"segment\" and so on.")
      .def_prop_ro("corners", &rounded_corners, "(N, 2), counter-clockwise, each rounded to the nearest doubles.")
      .def("exact_corners", &exact_corners, "The corners as pairs of fractions.Fraction.");
  nb::class_<PythonRegion, Part>(planar, "Region", "The common part of half-planes.")
      .def_prop_ro(
          "sides", [](const PythonRegion& region) { return array_of<std::uint32_t>(region.sides); },
          "The half-planes that bound it, by angle; of an empty one, those that contradict each other.");
  planar.def("half_plane_intersection", &half_plane_intersection, nb::arg("constraints"),
             "What is common to all of these half-planes?");
  planar.def("kernel", &kernel_of, nb::arg("ring"),
             "From which points of a simple polygon is all of it seen? Sides are numbers of its edges.");

  nb::class_<Program, Answer>(planar, "LinearProgramAnswer", "The points of a region furthest in a direction.")
      .def_prop_ro(
          "outcome", [](const Program& p) { return name_of(p.answer.outcome); },
          "\"one\", \"many\", \"all\", \"unbounded\" or \"infeasible\".")
      .def_prop_ro("feasible", [](const Program& p) { return p.answer.feasible(); })
      .def_prop_ro(
          "before", [](const Program& p) { return number_of(p.answer.before); },
          "The half-planes that prove the outcome (see sunder/planar/region/linear_program.h).")
      .def_prop_ro("side", [](const Program& p) { return number_of(p.answer.side); })
      .def_prop_ro("after", [](const Program& p) { return number_of(p.answer.after); })
      .def_prop_ro(
          "point",
          [](const Program& p) -> std::optional<std::pair<double, double>> {
            if (!p.point) return std::nullopt;
            const Point2 at = rounded(*p.point);
            return std::pair(at.x, at.y);
          },
          "An optimal point (of an unbounded program, a common point), rounded to the nearest doubles.")
      .def(
          "exact_point",
          [](const Program& p) -> nb::object { return p.point ? nb::object(fractions_of(*p.point)) : nb::none(); },
          nb::sig("def exact_point(self) -> tuple[fractions.Fraction, fractions.Fraction] | None"),
          "The same as fractions.Fraction.");
  planar.def("linear_program", &linear_program, nb::arg("constraints"), nb::arg("objective"),
             "Which common points of the half-planes are furthest in the direction (p, q)?");

  nb::class_<DiscsPart, Answer>(planar, "DiscIntersection", "What is common to all of some discs.")
      .def_prop_ro(
          "kind", [](const DiscsPart& part) { return part.kind; }, "\"empty\", \"point\", \"region\", \"plane\".")
      .def_prop_ro(
          "arcs", [](const DiscsPart& part) { return array_of<std::uint32_t>(part.arcs); },
          "The discs whose arcs bound it, counter-clockwise.");
  planar.def("disc_intersection", &disc_intersection, nb::arg("discs"), "What is common to all of these discs?");
  planar.def("convex_polygon_intersection", &convex_polygon_intersection, nb::arg("polygons"),
             "What is common to all of these convex polygons?");
}

}  // namespace sunder::python
