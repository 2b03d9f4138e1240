// Convex polygons with poses: pairs, distances, common parts.
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>
#include <sunder/planar/pair/polygon_polygon_intersection.h>

#include "pairs.h"

namespace sunder::python {

namespace {

using planar::ConvexPolygon;
using planar::Pose;
using Shared = std::shared_ptr<ConvexPolygon>;

std::vector<Point3> in_space(const ConvexPolygon& polygon) {
  std::vector<Point3> vertices;
  vertices.reserve(polygon.size());
  for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
  return vertices;
}

PythonPairAnswer answer_of(const Shared& a, const Pose& pose_a, const Shared& b, const Pose& pose_b) {
  const PairAnswer answer = planar::polygon_polygon(*a, pose_a, *b, pose_b);
  const auto text = [a, pose_a, b, pose_b, certificate = answer.certificate()] {
    return pair_certificate(in_space(*a), planar::in_space(pose_a.affine()), in_space(*b),
                            planar::in_space(pose_b.affine()), certificate, PairClaims::Space::planar);
  };
  return {{{answer.cost, text}, answer.meet()}, answer.decided_by};
}

struct Distance : YesNo {
  double low = 0, high = 0;
  std::optional<planar::ClosestFeatures> closest;
  planar::PolygonDistance exact;
};

Distance distance_of(const Shared& a, const Pose& pose_a, const Shared& b, const Pose& pose_b) {
  planar::PolygonDistance found = planar::polygon_polygon_distance(*a, pose_a, *b, pose_b);
  Distance result;
  static_cast<YesNo&>(result) = answer_of(a, pose_a, b, pose_b);
  result.cost = found.answer.cost;
  result.low = found.distance().low;
  result.high = found.distance().high;
  result.closest = found.closest;
  result.exact = std::move(found);
  return result;
}

int compare(const Distance& distance, double radius) {
  if (!(radius >= 0 && radius <= std::numeric_limits<double>::max())) {
    throw Error(ErrorCode::bad_value, "give a finite number, not negative", "radius");
  }
  return static_cast<int>(compare_distance(distance.exact, radius));
}

void bind_objects(nb::module_& planar) {
  nb::class_<Pose>(planar, "Pose", "x_world = linear x_object + translation: these six doubles are the map, exactly.")
      .def(nb::init<>(), "The identity.")
      .def_static(
          "from_matrix",
          [](const ArrayLike& linear, const ArrayLike& translation) {
            return Pose::from_matrix(numbers_of<4>(linear, "linear", {{2, 2}, {4}}),
                                     numbers_of<2>(translation, "translation", {{2}}));
          },
          nb::arg("linear"), nb::arg("translation"), "An invertible linear part, row by row.")
      .def_static(
          "from_angle",
          [](double angle, const ArrayLike& translation) {
            return Pose::from_angle(angle, numbers_of<2>(translation, "translation", {{2}}));
          },
          nb::arg("angle"), nb::arg("translation"), "A rotation in radians, rounded to doubles; then the translation.")
      .def_prop_ro("linear",
                   [](const Pose& pose) {
                     return array_of<double, 2>(
                         std::vector<std::array<double, 2>>{{pose.affine().linear[0], pose.affine().linear[1]},  //
                                                            {pose.affine().linear[2], pose.affine().linear[3]}});
                   })
      .def_prop_ro("translation", [](const Pose& pose) {
        return array_of<double>(std::span<const double>(pose.affine().translation));
      });
  nb::class_<ConvexPolygon>(planar, "ConvexPolygon", "A convex polygon, closed; segments and points are some too.")
      .def_static(
          "from_vertices",
          [](const ArrayLike& vertices) { return ConvexPolygon::from_vertices(points_of<2>(vertices, "vertices")); },
          nb::arg("vertices"), "Strictly convex vertices, counter-clockwise: checked exactly.")
      .def_static(
          "mended", [](const ArrayLike& vertices) { return ConvexPolygon::mended(points_of<2>(vertices, "vertices")); },
          nb::arg("vertices"), "The same, without repeated and collinear vertices, and turned round if need be.")
      .def_static(
          "hull_of", [](const ArrayLike& points) { return ConvexPolygon::hull_of(points_of<2>(points, "points")); },
          nb::arg("points"), "The exact convex hull of any points.")
      .def("__len__", &ConvexPolygon::size)
      .def_prop_ro("vertices", [](const ConvexPolygon& polygon) { return array_of<double, 2>(polygon.vertices()); });
}

}  // namespace

std::string pair_certificate(std::span<const Point3> a, const Affine3& pose_a, std::span<const Point3> b,
                             const Affine3& pose_b, const PairCertificate& certificate, PairClaims::Space space) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims claims(file, space);
  const std::uint32_t body_a = claims.add_body("A", a), body_b = claims.add_body("B", b);
  const std::uint32_t placed_a = claims.add_placed("A", body_a, pose_a);
  claims.add_pair(placed_a, claims.add_placed("B", body_b, pose_b), certificate);
  claims.end();
  return text;
}

void bind_planar(nb::module_& module, nb::module_& planar) {
  nb::class_<PythonPairAnswer, YesNo>(module, "PairAnswer", "Do two placed objects meet? True where they do.")
      .def_prop_ro("decided_by", [](const PythonPairAnswer& answer) { return name_of(answer.decided_by); })
      .def("__repr__", [](const PythonPairAnswer& answer) {
        return std::string("PairAnswer(meet=") + (answer.yes ? "True" : "False") + ")";
      });
  bind_objects(planar);
  bind_pair<ConvexPolygon, Pose>(module, planar, "polygon_polygon", answer_of);
  planar.def(
      "polygon_polygon_contact",
      [](const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b) {
        return name_of(planar::polygon_polygon_contact(a, pose_a, b, pose_b));
      },
      nb::arg("a"), nb::arg("pose_a"), nb::arg("b"), nb::arg("pose_b"), "\"none\", \"touching\" or \"overlapping\".");
  nb::class_<Distance, YesNo>(planar, "PolygonDistance", "How far apart are two polygons? True where they meet.")
      .def_ro("low", &Distance::low, "The exact distance is from low to high.")
      .def_ro("high", &Distance::high)
      .def_prop_ro(
          "closest",
          [](const Distance& distance)
              -> std::optional<std::tuple<std::string_view, std::uint32_t, std::string_view, std::uint32_t>> {
            const auto kind = [](bool is_edge) -> std::string_view { return is_edge ? "edge" : "vertex"; };
            if (!distance.closest) return std::nullopt;
            const planar::ClosestFeatures& c = *distance.closest;
            return std::tuple(kind(c.edge_of_a), c.a, kind(c.edge_of_b), c.b);
          },
          "The closest features, such as (\"edge\", 2, \"vertex\", 0); None where they meet.")
      .def("compare", &compare, nb::arg("radius"),
           "Exactly: 1 where they are further apart than the radius, 0 where just so far, -1 where closer.");
  planar.def("polygon_polygon_distance", &distance_of, nb::arg("a"), nb::arg("pose_a"), nb::arg("b"), nb::arg("pose_b"),
             "How far apart are two placed polygons? Its certificate says whether they meet.");
  planar.def(
      "polygon_polygon_intersection",
      [](const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b) {
        std::vector<Point2> points;
        for (const planar::CommonCorner& c : planar::polygon_polygon_intersection(a, pose_a, b, pose_b).corners) {
          points.push_back(rounded(planar::exact_corner(c, a, pose_a, b, pose_b)));
        }
        return array_of<double, 2>(std::move(points));
      },
      nb::arg("a"), nb::arg("pose_a"), nb::arg("b"), nb::arg("pose_b"),
      "The corners of the common part, counter-clockwise, each rounded to the nearest doubles.");
}

}  // namespace sunder::python
