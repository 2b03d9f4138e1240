// Planes, lines, rays and segments of space, against polyhedra and against each other.
#include <sunder/solid/line/flat_flat.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_line_support.h>
#include <sunder/solid/section/polyhedron_plane.h>
#include <sunder/solid/section/polyhedron_plane_claims.h>

#include <nanobind/stl/variant.h>

#include "common.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace sunder::python {

namespace {

using solid::ConvexPolyhedron;
using solid::Flat;
using solid::FlatBody;
using solid::Line;
using solid::LineLike;
using solid::Plane;
using solid::Pose;
using solid::Ray;
using solid::Segment;
using Shared = std::shared_ptr<ConvexPolyhedron>;

Point3 point_of(const ArrayLike& given, const char* place) {
  const auto [x, y, z] = numbers_of<3>(given, place, {{3}});
  return {x + 0.0, y + 0.0, z + 0.0};
}

auto array_of_point(const Point3& p) { return array_of<double>(std::vector<double>{p.x, p.y, p.z}); }

FlatBody body_in_file(const Flat& flat) {
  auto body = solid::body_of(flat);
  if (!body) {
    throw Error(ErrorCode::bad_value,
                "no point of the plane was found that is three doubles, which a certificate needs; make it by one",
                "plane");
  }
  return *std::move(body);
}

// The file about a placed body A, and B: add(pairs, a, b) states and proves.
template <class Add>
std::string proof_of(const ConvexPolyhedron& body, const Pose& pose, const FlatBody& other, const Add& add) {
  return claims_text({}, [&](ClaimsWriter& file) {
    PairClaims pairs(file);
    const std::uint32_t a = pairs.add_placed("A", pairs.add_body("A", body.vertices()), pose.affine());
    const std::uint32_t b = pairs.add_body("B", other.points, other.ways);
    add(pairs, a, b);
  });
}

struct PythonPlaneAnswer : YesNo {
  solid::PolyhedronPlane answer;
  Relation contact = Relation::none;
};

PythonPlaneAnswer polyhedron_plane(const Shared& body, const Pose& pose, const Plane& plane) {
  const solid::PolyhedronPlane answer = solid::polyhedron_plane(*body, pose, plane);
  const Relation contact = answer.meet() ? solid::polyhedron_plane_contact(*body, pose, plane) : Relation::none;
  const auto text = [=] {
    const FlatBody other = body_in_file(plane);
    return proof_of(*body, pose, other, [&](PairClaims& pairs, std::uint32_t a, std::uint32_t b) {
      add_claims(pairs, a, b, *body, pose, plane, other, answer, contact);
    });
  };
  return {{{answer.cost, text}, answer.meet()}, answer, contact};
}

struct PythonCut : YesNo {
  solid::PolyhedronCut cut;
  Relation contact = Relation::none;
  std::optional<std::array<solid::ExactEnd, 2>> ends;
};

PythonCut polyhedron_line(const Shared& body, const Pose& pose, const LineLike& other) {
  const solid::PolyhedronCut cut = polyhedron_line_like(*body, pose, other);
  const Relation contact = contact_of(*body, other, cut);
  const auto text = [=] {
    const Flat flat = std::visit([](const auto& line) { return Flat(line); }, other);
    return proof_of(*body, pose, body_in_file(flat), [&](PairClaims& pairs, std::uint32_t a, std::uint32_t b) {
      add_claims(pairs, a, b, *body, pose, other, cut, true);
    });
  };
  PythonCut answer{{{cut.cost, text}, cut.meet()}, cut, contact, {}};
  const auto ends = ends_of(cut.evidence);
  if (!ends) return answer;
  const auto [p, q] = std::visit([](const auto& line) { return std::pair(line.a, line.b); }, other);
  answer.ends = {exact_end(*body, pose, p, q, ends->first), exact_end(*body, pose, p, q, ends->last)};
  return answer;
}

struct PythonLineSupport : YesNo {
  Shared body;
  solid::LineSupport support;
};

PythonLineSupport polyhedron_line_support(const Shared& body, const Pose& pose, const Line& line) {
  if (body->dimension() < 3) {
    throw Error(ErrorCode::bad_shape, "the body has no inside; give one that has", "body");
  }
  const solid::LineSupport support = solid::polyhedron_line_support(*body, pose, line);
  const auto text = [=] {
    return proof_of(*body, pose, body_in_file(line), [&](PairClaims& pairs, std::uint32_t a, std::uint32_t b) {
      add_support(pairs, a, b, *body, pose, line, support);
    });
  };
  return {{{support.cost, text}, support.meet()}, body, support};
}

struct PythonFlatAnswer : YesNo {
  solid::FlatCommon common;
  std::optional<Point3> point;
};

PythonFlatAnswer flat_flat(const Flat& a, const Flat& b) {
  const solid::FlatCommon common = solid::flat_flat(a, b);
  const auto text = [=] {
    const FlatBody body_a = body_in_file(a), body_b = body_in_file(b);
    return claims_text({}, [&](ClaimsWriter& file) {
      PairClaims pairs(file);
      const std::uint32_t i = pairs.add_body("A", body_a.points, body_a.ways);
      const std::uint32_t j = pairs.add_body("B", body_b.points, body_b.ways);
      add_claims(pairs, i, j, a, body_a, b, body_b, common, true);
    });
  };
  PythonFlatAnswer answer{{{common.cost, text}, common.meet()}, common, {}};
  if (common.meet()) answer.point = nearest(common_point(a, b, common));
  return answer;
}

// What makes one out of two points, and gives them back.
template <class LineKind>
nb::class_<LineKind> bind_line(nb::module_& solid, const char* name, const char* doc, const char* factory,
                               LineKind (*make)(const Point3&, const Point3&)) {
  nb::class_<LineKind> line(solid, name, doc);
  line.def_static(
          factory, [make](const ArrayLike& a, const ArrayLike& b) { return make(point_of(a, "a"), point_of(b, "b")); },
          nb::arg("a"), nb::arg("b"))
      .def_prop_ro(
          "a", [](const LineKind& l) { return array_of_point(l.a); }, owned)
      .def_prop_ro("b", [](const LineKind& l) { return array_of_point(l.b); }, owned);
  return line;
}

}  // namespace

void bind_flats(nb::module_& module, nb::module_& solid) {
  nb::class_<Plane>(solid, "Plane", "The points x with normal . (x - point) = offset; above it there is more.")
      .def_static(
          "through",
          [](const ArrayLike& point, const ArrayLike& normal) {
            return Plane::through(point_of(point, "point"), point_of(normal, "normal"));
          },
          nb::arg("point"), nb::arg("normal"), "Through a point.")
      .def_static(
          "at", [](const ArrayLike& normal, double offset) { return Plane::at(point_of(normal, "normal"), offset); },
          nb::arg("normal"), nb::arg("offset"), "The points x with normal . x = offset.")
      .def_prop_ro(
          "normal", [](const Plane& plane) { return array_of_point(plane.normal); }, owned)
      .def_prop_ro(
          "point", [](const Plane& plane) { return array_of_point(plane.point); }, owned)
      .def_ro("offset", &Plane::offset);
  bind_line<Line>(solid, "Line", "The line through two points, with the direction from a to b.", "through",
                  &Line::through);
  bind_line<Ray>(solid, "Ray", "The points from a on, in the direction of b.", "through", &Ray::from);
  bind_line<Segment>(solid, "Segment", "The points from a to b.", "between", &Segment::between);

  nb::class_<PythonPlaneAnswer, YesNo>(solid, "PolyhedronPlane", "Do a body and a plane meet? True where they do.")
      .def_prop_ro(
          "side",
          [](const PythonPlaneAnswer& a) -> std::optional<std::string_view> {
            if (a.answer.meet()) return std::nullopt;
            return side_of(a.answer) == Sign::positive ? "above" : "below";
          },
          "\"above\" or \"below\": where all of the body is; None where they meet.")
      .def_prop_ro("contact", [](const PythonPlaneAnswer& a) { return name_of(a.contact); })
      .def_prop_ro("decided_by", [](const PythonPlaneAnswer& a) { return name_of(a.answer.decided_by); });
  nb::class_<PythonCut, YesNo>(solid, "PolyhedronCut",
                               "What a body has in common with a line, a ray or a segment. True where they meet.")
      .def_prop_ro(
          "kind", [](const PythonCut& a) { return name_of(kind_of(a.cut)); },
          "\"nothing\", \"point\", \"along\" an edge or a facet, or \"across\" the inside.")
      .def_prop_ro("contact", [](const PythonCut& a) { return name_of(a.contact); })
      .def_prop_ro("decided_by", [](const PythonCut& a) { return name_of(a.cut.decided_by); })
      .def_prop_ro(
          "points",
          [](const PythonCut& a) {
            std::vector<Point3> points;
            if (a.ends) points = {(*a.ends)[0].rounded(), (*a.ends)[1].rounded()};
            return array_of<double, 3>(std::move(points));
          },
          owned, "Where it comes in and where it goes out, the nearest doubles; empty where they are apart.")
      .def_prop_ro(
          "along_line",
          [](const PythonCut& a) {
            return list_of(
                a.ends ? std::span<const solid::ExactEnd>(*a.ends) : std::span<const solid::ExactEnd>(),
                [](const auto& end) { return fraction_of(end.along_line.numerator, end.along_line.denominator); });
          },
          "Of these points t, as fractions.Fraction: a + t (b - a), exactly.");
  nb::class_<PythonLineSupport, YesNo>(
      solid, "LineSupport", "The planes through a line that touch a body and do not cut it. True where the two meet.")
      .def_prop_ro(
          "kind", [](const PythonLineSupport& a) { return name_of(a.support.evidence); },
          "\"two planes\", \"a range of planes\", \"one plane\" or \"none\".")
      .def_prop_ro("decided_by", [](const PythonLineSupport& a) { return name_of(a.support.decided_by); })
      .def_prop_ro(
          "touches",
          [](const PythonLineSupport& a) {
            return list_of(planes_of(a.support.evidence),
                           [&](const auto& plane) { return vertices_of(*a.body, plane.touches); });
          },
          "Of each plane, the first and the last of a range, the vertices of the body that are on it.");
  nb::class_<PythonFlatAnswer, YesNo>(solid, "FlatCommon", "What two flat things have in common. True where they meet.")
      .def_prop_ro(
          "kind", [](const PythonFlatAnswer& a) { return name_of(a.common.evidence.kind); },
          "\"nothing\", \"point\", \"segment\", \"ray\", \"line\" or \"plane\".")
      .def_prop_ro("contact", [](const PythonFlatAnswer& a) { return name_of(a.common.evidence.contact); })
      .def_prop_ro("decided_by", [](const PythonFlatAnswer& a) { return name_of(a.common.decided_by); })
      .def_prop_ro(
          "point",
          [](const PythonFlatAnswer& a) -> nb::object {
            return a.point ? nb::cast(array_of_point(*a.point)) : nb::none();
          },
          "A common point, rounded; None where they are apart.");

  const nb::arg body("body"), pose("pose"), plane("plane"), line("line"), a("a"), b("b");
  solid.def("polyhedron_plane", &polyhedron_plane, body, pose, plane, "On which side of the plane is the body?");
  solid.def("polyhedron_line", &polyhedron_line, body, pose, line, "Of a line, a ray or a segment.");
  solid.def("polyhedron_line_support", &polyhedron_line_support, body, pose, line,
            "Which planes through the line support the body, which has an inside?");
  solid.def("flat_flat", &flat_flat, a, b, "Of segments, rays, lines and planes.");
  module.def("intersect", &polyhedron_plane, body, pose, plane);
  module.def(
      "intersect", [](const Shared& of, const Plane& with) { return polyhedron_plane(of, Pose(), with); }, body, plane);
  module.def("intersect", &polyhedron_line, body, pose, line);
  module.def(
      "intersect", [](const Shared& of, const LineLike& with) { return polyhedron_line(of, Pose(), with); }, body,
      line);
}

}  // namespace sunder::python
