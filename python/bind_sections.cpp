// Sections of polyhedra by planes.
#include <sunder/solid/section/polyhedron_plane_section.h>
#include <sunder/solid/section/section_area.h>
#include <sunder/solid/section/section_claims.h>

#include "common.h"

namespace sunder::python {

namespace {

using solid::ConvexPolyhedron;
using solid::Plane;
using solid::PlaneSection;
using solid::Pose;
using solid::SectionCorner;

struct PythonSection {
  PlaneSection section;
  std::vector<Point3> corners;  // rounded
  ConvexPolyhedron body;
  Pose pose;
  Plane plane;
};

std::vector<PythonSection> sections(const ConvexPolyhedron& body, const ArrayLike& normal, const ArrayLike& offsets,
                                    const Pose& pose) {
  const auto n = numbers_of<3>(normal, "normal", {{3}});
  const Doubles given = doubles_of(offsets, "offsets", {{any_length}});
  const std::vector<double> at(given.data(), given.data() + given.shape(0));
  const Plane plane = Plane::at({n[0], n[1], n[2]}, 0);
  std::vector<PythonSection> found;
  unlocked([&] {
    solid::SectionPoints points(body, pose, plane);
    polyhedron_plane_sections(body, pose, plane, at, [&](std::size_t k, const PlaneSection& section) {
      found.push_back({section, {}, body, pose, plane});
      found.back().plane.offset = at[k];
      points.set_offset(at[k]);
      for (const SectionCorner& corner : section.corners) found.back().corners.push_back(points.nearest(corner));
    });
  });
  return found;
}

PythonSection section(const ConvexPolyhedron& body, const ArrayLike& normal, double offset, const Pose& pose) {
  const auto n = numbers_of<3>(normal, "normal", {{3}});
  const Plane plane = Plane::at({n[0], n[1], n[2]}, offset);
  PythonSection found{polyhedron_plane_section(body, pose, plane), {}, body, pose, plane};
  const solid::SectionPoints points(body, pose, plane);
  for (const SectionCorner& corner : found.section.corners) found.corners.push_back(points.nearest(corner));
  return found;
}

nb::bytes certificate(const PythonSection& found, const std::string& name) {
  return bytes_of_file([&](ClaimsWriter& file) {
    solid::SectionClaims claims(file, name, found.body, found.pose);
    claims.add(found.plane, found.section);
  });
}

}  // namespace

void bind_sections(nb::module_& solid) {
  nb::class_<PythonSection>(solid, "PlaneSection", "What a polyhedron and a plane have in common.")
      .def_prop_ro(
          "kind", [](const PythonSection& found) { return name_of(found.section.kind); },
          "\"nothing\", \"point\", \"segment\" or \"polygon\".")
      .def_prop_ro(
          "corners", [](const PythonSection& found) { return array_of<double, 3>(found.corners); }, owned,
          "The nearest doubles, counter-clockwise seen from where the normal points to.")
      .def_prop_ro(
          "features", [](const PythonSection& found) { return array_of<std::uint32_t, 2>(found.section.corners); },
          owned, "Of each corner the ends of its edge, above and below the plane; or twice the vertex on it.")
      .def_prop_ro(
          "area",
          [](const PythonSection& found) {
            const solid::SectionPoints points(found.body, found.pose, found.plane);
            const auto [low, high] = section_area(found.section, points, found.plane.normal);
            return std::pair(low, high);
          },
          "Two doubles that the area is between, as the certificate says; the second may be infinite.")
      .def("__len__", [](const PythonSection& found) { return found.corners.size(); })
      .def("certificate", &certificate, nb::arg("name") = "body", "The certificate file of this section.");
  solid.def("polyhedron_plane_section", &section, nb::arg("body"), nb::arg("normal"), nb::arg("offset"),
            nb::arg("pose") = Pose(), "By the plane of the points x with normal . x = offset.");
  solid.def("polyhedron_plane_sections", &sections, nb::arg("body"), nb::arg("normal"), nb::arg("offsets"),
            nb::arg("pose") = Pose(), "By parallel planes, in the order of the offsets.");
}

}  // namespace sunder::python
