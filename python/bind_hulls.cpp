// Convex hulls of points of any dimension, regions of half-spaces with their vertices, linear programs over them.
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/hull/hull_claims.h>
#include <sunder/polytope/region/linear_program.h>
#include <sunder/polytope/region/region_claims.h>
#include <sunder/polytope/region/region_vertices.h>

#include "polytopes.h"

#include <cmath>
#include <optional>
#include <ranges>
#include <utility>

namespace sunder::python {

namespace {

using polytope::ConvexHull;
using polytope::ExactEvidence;
using polytope::HalfSpaceRegion;
using polytope::LinearProgramAnswer;
using polytope::Polytope;
using polytope::RegionKind;
using polytope::RegionVertices;

using SharedPolytope = std::shared_ptr<Polytope>;

struct PythonHull : Answer {
  SharedPolytope points;
  std::shared_ptr<const ConvexHull> hull;
};

struct PythonRegion : Answer {
  HalfSpaceRegion region;
};

struct PythonVertices : Answer {
  std::shared_ptr<const RegionVertices> answer;
};

struct PythonProgram : Answer {
  std::vector<double> objective;
  LinearProgramAnswer answer;
};

void require_form(const Polytope& given, bool of_points, const char* place) {
  if (given.is_of_points() == of_points) return;
  throw Error(ErrorCode::bad_call,
              of_points ? "half-spaces; give a polytope of points" : "points; give a polytope of half-spaces", place);
}

auto facets_of(const PythonHull& of) { return std::views::iota(std::size_t{0}, of.hull->facet_count()); }

std::optional<nb::tuple> place_of(const ExactPointN* place) {
  if (place == nullptr) return std::nullopt;
  return fractions_of(place->numbers, place->denominator);
}

std::optional<std::size_t> dimension_of(const HalfSpaceRegion& region) {
  const polytope::RegionExtent* extent = extent_of(region);
  return extent != nullptr ? std::optional(extent->dimension) : std::nullopt;
}

PythonHull hull_of(const SharedPolytope& points) {
  require_form(*points, true, "points");
  const auto hull = unlocked([&] { return std::make_shared<const ConvexHull>(convex_hull(*points)); });
  return {{{.probes = hull->side_tests, .exact = static_cast<std::uint32_t>(hull->exact_tests)},
           [points, hull] { return file_of([&](ClaimsWriter& file) { write_hull(file, "points", *points, *hull); }); }},
          points,
          hull};
}

PythonRegion region_of(const SharedPolytope& given) {
  require_form(*given, false, "half_spaces");
  return unlocked([&] {
    const HalfSpaceRegion region = half_space_region(*given);
    return PythonRegion{{region.cost,
                         [given, region] {
                           return file_of([&](ClaimsWriter& file) { add_claims(file, "half-spaces", *given, region); });
                         }},
                        region};
  });
}

PythonVertices vertices_of(const SharedPolytope& given) {
  require_form(*given, false, "half_spaces");
  return unlocked([&] {
    const auto answer = std::make_shared<const RegionVertices>(region_vertices(*given));
    if (answer->region.verdict() == RegionKind::unbounded) {
      throw Error(ErrorCode::bad_shape, "they are not bounded; give bounded ones", "half_spaces");
    }
    return PythonVertices{
        {answer->region.cost,
         [given, answer] {
           return file_of([&](ClaimsWriter& file) { add_claims(file, "half-spaces", *given, *answer); });
         }},
        answer};
  });
}

using ProgramMethod = LinearProgramAnswer (*)(const Polytope&, std::span<const double>);

ProgramMethod method_of(const std::string& name) {
  if (name == "automatic") return polytope::linear_program;
  if (name == "seidel") return polytope::linear_program_by_seidel;
  if (name == "scan") return polytope::linear_program_by_scan;
  throw Error(ErrorCode::bad_value, "there is no such method; give automatic, seidel or scan", "method");
}

PythonProgram program_of(const SharedPolytope& given, const ArrayLike& along, const std::string& method) {
  require_form(*given, false, "half_spaces");
  const Doubles numbers = doubles_of(along, "objective", {{static_cast<int>(given->dimension())}});
  const std::vector<double> objective(numbers.data(), numbers.data() + numbers.size());
  for (const double x : objective) {
    if (!std::isfinite(x)) {
      throw Error(ErrorCode::bad_value, "a number is not finite; give finite numbers", "objective");
    }
  }
  const ProgramMethod solve = method_of(method);
  return unlocked([&] {
    const LinearProgramAnswer answer = solve(*given, objective);
    return PythonProgram{
        {answer.cost,
         [given, objective, answer] {
           return file_of([&](ClaimsWriter& file) { add_claims(file, "half-spaces", *given, objective, answer); });
         }},
        objective,
        answer};
  });
}

std::optional<nb::object> value_of(const PythonProgram& of) {
  const ExactPointN* const point = named_point(of.answer.evidence);
  if (point == nullptr || of.answer.verdict() == Optimum::unbounded) return std::nullopt;
  Dyadic sum;
  for (std::size_t c = 0; c < of.objective.size(); ++c) sum = sum + point->numbers[c] * of.objective[c];
  return fraction_of(sum, point->denominator);
}

}  // namespace

void bind_hulls(nb::module_& polytope) {
  nb::class_<PythonHull, Answer>(polytope, "ConvexHull", "A convex hull: vertices and facets by the numbers of points.")
      .def_prop_ro(
          "dimension", [](const PythonHull& of) { return of.hull->dimension; }, "0: a point, 1: a segment, .., d.")
      .def_prop_ro(
          "vertices", [](const PythonHull& of) { return array_of<std::uint32_t>(of.hull->vertices); }, owned,
          "Ascending; of equal points the first.")
      .def_prop_ro(
          "facets",
          [](const PythonHull& of) {
            return list_of(facets_of(of), [&](auto f) { return array_of<std::uint32_t>(of.hull->facet_vertices(f)); });
          },
          "Of each facet the vertices that lie on it, ascending.")
      .def_prop_ro(
          "half_spaces",
          [](const PythonHull& of) {
            return list_of(facets_of(of), [&](std::size_t f) {
              return fractions_of(facet_half_space(*of.hull, *of.points, f), Dyadic(1.0));
            });
          },
          "Of each facet a1, .., ad, b, as fractions: all points x have a x <= b, and = just on the facet.")
      .def_prop_ro(
          "equations",
          [](const PythonHull& of) {
            return list_of(flat_equations(*of.hull, *of.points),
                           [](const auto& row) { return fractions_of(row, Dyadic(1.0)); });
          },
          "Likewise: all points have a x = b; none where the hull has all dimensions.");
  nb::class_<PythonRegion, Answer>(polytope, "HalfSpaceRegion",
                                   "What half-spaces have in common; true where something.")
      .def("__bool__", [](const PythonRegion& of) { return extent_of(of.region) != nullptr; })
      .def_prop_ro(
          "kind", [](const PythonRegion& of) { return name_of(of.region.verdict()); },
          "\"empty\", \"bounded\" or \"unbounded\".")
      .def_prop_ro(
          "dimension", [](const PythonRegion& of) { return dimension_of(of.region); },
          "Of the flat that it spans; None where it is empty.")
      .def_prop_ro(
          "points",
          [](const PythonRegion& of) {
            const polytope::RegionExtent* extent = extent_of(of.region);
            return list_of(extent != nullptr ? std::span(extent->points) : std::span<const ExactPointN>(),
                           [](const auto& point) { return fractions_of(point.numbers, point.denominator); });
          },
          "Common points as fractions, one more than the dimension, which span that flat.")
      .def_prop_ro(
          "extents",
          [](const PythonRegion& of) {
            const polytope::RegionExtent* extent = extent_of(of.region);
            const std::size_t count = extent != nullptr ? extent->points[0].numbers.size() : 0;
            return list_of(std::views::iota(std::size_t{0}, count), [&](std::size_t c) {
              return nb::make_tuple(extent->ranges[c].least, extent->ranges[c].greatest);
            });
          },
          "Of each coordinate the least and the greatest, as nearest doubles; None where there is none.")
      .def_prop_ro(
          "direction",
          [](const PythonRegion& of) {
            const auto* far = std::get_if<polytope::UnboundedRegion>(&of.region.evidence);
            return far != nullptr ? std::optional(fractions_of(far->direction, Dyadic(1.0))) : std::nullopt;
          },
          "Of an unbounded one: where it goes on for ever, as fractions; else None.")
      .def_prop_ro(
          "flat",
          [](const PythonRegion& of) {
            const polytope::RegionExtent* extent = extent_of(of.region);
            return weights_of(extent != nullptr ? extent->flat : Weights());
          },
          "Half-spaces on whose hyperplanes all of it lies, with multipliers by which they sum to zero.")
      .def_prop_ro(
          "contradiction",
          [](const PythonRegion& of) {
            const auto* empty = std::get_if<polytope::EmptyRegion>(&of.region.evidence);
            return weights_of(empty != nullptr ? empty->contradiction : Weights());
          },
          "Of an empty one: half-spaces, with multipliers by which they sum to 0 <= a negative number.");
  nb::class_<PythonVertices, Answer>(polytope, "RegionVertices", "The vertices of bounded half-spaces.")
      .def("__len__", [](const PythonVertices& of) { return of.answer->found.vertices.size(); })
      .def_prop_ro(
          "dimension", [](const PythonVertices& of) { return dimension_of(of.answer->region); },
          "Of the flat that they span; None where there are none.")
      .def_prop_ro(
          "vertices",
          [](const PythonVertices& of) {
            return list_of(of.answer->found.vertices, [](const std::span<const Dyadic> vertex) {
              return fractions_of(vertex.first(vertex.size() - 1), vertex.back());
            });
          },
          "Each as fractions.")
      .def_prop_ro(
          "half_spaces",
          [](const PythonVertices& of) {
            return list_of(of.answer->found.at, [](const auto& at) { return nb::cast(array_of<std::uint32_t>(at)); });
          },
          "Of each vertex, those of the bounding half-spaces that end there.")
      .def_prop_ro(
          "bounding", [](const PythonVertices& of) { return array_of<std::uint32_t>(of.answer->found.bounding); },
          owned, "The half-spaces that have a facet; of such that are the same, one.");
  nb::class_<PythonProgram, Answer>(polytope, "LinearProgram",
                                    "The best common point of half-spaces; true if feasible.")
      .def("__bool__", [](const PythonProgram& of) { return is_feasible(of.answer); })
      .def_prop_ro(
          "outcome", [](const PythonProgram& of) { return name_of(of.answer.verdict()); },
          "\"one\" or \"many\" points are best; \"all\", of a zero objective; \"unbounded\"; or \"infeasible\".")
      .def_prop_ro(
          "point", [](const PythonProgram& of) { return place_of(named_point(of.answer.evidence)); },
          "A best point, or a common one, as fractions; None where there is none.")
      .def_prop_ro("value", &value_of, "The greatest value, as a fraction; None where there is none.")
      .def_prop_ro(
          "other",
          [](const PythonProgram& of) {
            const auto* many = std::get_if<polytope::ManyOptima>(&of.answer.evidence);
            return place_of(many != nullptr ? &many->other : nullptr);
          },
          "Of \"many\": another best point; else None.")
      .def_prop_ro(
          "direction",
          [](const PythonProgram& of) {
            const auto* far = std::get_if<polytope::NoBound>(&of.answer.evidence);
            return far != nullptr ? std::optional(fractions_of(far->direction, Dyadic(1.0))) : std::nullopt;
          },
          "Of \"unbounded\": a way that leads further for ever; else None.")
      .def_prop_ro(
          "multipliers",
          [](const PythonProgram& of) {
            const Weights* multipliers = named_multipliers(of.answer.evidence);
            return weights_of(multipliers != nullptr ? *multipliers : Weights());
          },
          "Of half-spaces that make the objective, and bound it at the point; or that contradict each other.")
      .def_prop_ro("decided_by", [](const PythonProgram& of) { return name_of(of.answer.decided_by); });

  const nb::arg half_spaces("half_spaces");
  polytope.def("convex_hull", &hull_of, nb::arg("points"), "The convex hull of a polytope of points.");
  polytope.def("half_space_region", &region_of, half_spaces,
               "Is what half-spaces have in common empty, bounded, unbounded, of which dimension?");
  polytope.def("region_vertices", &vertices_of, half_spaces,
               "The vertices of what half-spaces have in common; refused where it is not bounded.");
  polytope.def("linear_program", &program_of, half_spaces, nb::arg("objective"), nb::arg("method") = "automatic",
               "Which common points of half-spaces are furthest along the objective?");
}

}  // namespace sunder::python
