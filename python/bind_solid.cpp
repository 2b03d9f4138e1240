// Convex polyhedra with poses.
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/hull_json.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include "pairs.h"

namespace sunder::python {

namespace {

using solid::ConvexPolyhedron;
using solid::Pose;
using Shared = std::shared_ptr<ConvexPolyhedron>;

PythonPairAnswer answer_of(const Shared& a, const Pose& pose_a, const Shared& b, const Pose& pose_b) {
  const PairAnswer answer = solid::polyhedron_polyhedron(*a, pose_a, *b, pose_b);
  // Polyhedra share their data: what is kept are these, not Python's objects.
  const auto text = [a = *a, pose_a, b = *b, pose_b, certificate = answer.certificate()] {
    return pair_certificate(a.vertices(), pose_a.affine(), b.vertices(), pose_b.affine(), certificate,
                            PairClaims::Space::solid);
  };
  return {{{answer.cost, text}, answer.meet()}, answer.decided_by};
}

nb::bytes hull_certificate(const ArrayLike& given, const std::string& name) {
  if (name.empty()) throw Error(ErrorCode::bad_value, "give a name that is not empty", "name");
  const std::vector<Point3> points = points_of<3>(given, "points");
  const std::string text = unlocked([&] {
    std::string pieces;
    ClaimsWriter file([&](std::string_view piece) { pieces += piece; });
    solid::write_hull(file, name, points, ConvexPolyhedron(points));
    file.end();
    return pieces;
  });
  return nb::bytes(text.data(), text.size());
}

}  // namespace

void bind_solid(nb::module_& module, nb::module_& solid) {
  nb::class_<Pose>(solid, "Pose", "x_world = linear x_body + translation: these twelve doubles are the map, exactly.")
      .def(nb::init<>(), "The identity.")
      .def_static(
          "from_matrix",
          [](const ArrayLike& linear, const ArrayLike& translation) {
            return Pose::from_matrix(numbers_of<9>(linear, "linear", {{3, 3}, {9}}),
                                     numbers_of<3>(translation, "translation", {{3}}));
          },
          nb::arg("linear"), nb::arg("translation"), "An invertible linear part, row by row.")
      .def_static(
          "from_matrix4",
          [](const ArrayLike& rows) { return Pose::from_matrix4(numbers_of<16>(rows, "rows", {{4, 4}, {16}})); },
          nb::arg("rows"), "A matrix whose last row is 0 0 0 1.")
      .def_static(
          "from_quaternion",
          [](double w, double x, double y, double z, const ArrayLike& translation) {
            return Pose::from_quaternion(w, x, y, z, numbers_of<3>(translation, "translation", {{3}}));
          },
          nb::arg("w"), nb::arg("x"), nb::arg("y"), nb::arg("z"), nb::arg("translation"),
          "The rotation of w + x i + y j + z k, of any length but zero, rounded to doubles; then the translation.")
      .def_prop_ro("linear",
                   [](const Pose& pose) {
                     std::vector<std::array<double, 3>> rows(3);
                     for (std::size_t k = 0; k < 9; ++k) rows[k / 3][k % 3] = pose.affine().linear[k];
                     return array_of<double, 3>(std::move(rows));
                   })
      .def_prop_ro("translation", [](const Pose& pose) {
        return array_of<double>(std::span<const double>(pose.affine().translation));
      });
  solid.def("compose", &solid::compose, nb::arg("outer"), nb::arg("inner"), "First inner, then outer, rounded.");

  nb::class_<ConvexPolyhedron>(solid, "ConvexPolyhedron", "The exact convex hull of any points of space, closed.")
      .def(
          "__init__",
          [](ConvexPolyhedron* self, const ArrayLike& given) {
            const std::vector<Point3> points = points_of<3>(given, "points");
            unlocked([&] { new (self) ConvexPolyhedron(points); });
          },
          nb::arg("points"))
      .def_prop_ro("dimension", &ConvexPolyhedron::dimension, "0 a point, 1 a segment, 2 a flat polygon, 3 a body.")
      .def_prop_ro("vertices", [](const ConvexPolyhedron& body) { return array_of<double, 3>(body.vertices()); })
      .def_prop_ro(
          "source", [](const ConvexPolyhedron& body) { return array_of<std::uint32_t>(body.source()); },
          "For each vertex, its index among the points given.")
      .def_prop_ro(
          "facets",
          [](const ConvexPolyhedron& body) {
            std::vector<std::vector<std::uint32_t>> facets;
            for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
              const std::span<const std::uint32_t> facet = body.facet(f);
              facets.emplace_back(facet.begin(), facet.end());
            }
            return facets;
          },
          "The vertices of each facet, counter-clockwise from outside.")
      .def("__len__", [](const ConvexPolyhedron& body) { return body.vertices().size(); });
  bind_pair<ConvexPolyhedron, Pose>(module, solid, "polyhedron_polyhedron", answer_of);
  solid.def(
      "polyhedron_polyhedron_contact",
      [](const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b) {
        return name_of(solid::polyhedron_polyhedron_contact(a, pose_a, b, pose_b));
      },
      nb::arg("a"), nb::arg("pose_a"), nb::arg("b"), nb::arg("pose_b"), "\"none\", \"touching\" or \"overlapping\".");
  solid.def("hull_certificate", &hull_certificate, nb::arg("points"), nb::arg("name") = "body",
            "The certificate file of what the convex hull of these points is, facet by facet.");
}

}  // namespace sunder::python
