// Convex polygons and polyhedra, and meshes, with poses: one pair with its answer, many pairs in one call.
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/object/hull_claims.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_batch.h>

#include "common.h"

#include <algorithm>

namespace sunder::python {

namespace {

using planar::ConvexPolygon;
using solid::ConvexPolyhedron;

struct PythonPairAnswer : YesNo {
  DecidedBy decided_by = DecidedBy::filter;
};

// What differs between the plane and space, where polygons have z = 0.
struct Planar {
  static constexpr std::size_t dimension = 2;
  static constexpr auto contact = planar::polygon_polygon_contact;
  using Object = ConvexPolygon;
  using Pose = planar::Pose;
};

struct Solid {
  static constexpr std::size_t dimension = 3;
  static constexpr auto contact = solid::polyhedron_polyhedron_contact;
  using Object = ConvexPolyhedron;
  using Pose = solid::Pose;
};

// Objects and poses are kept for the certificate.
template <class Object, class Pose>
PythonPairAnswer answer_of(const std::shared_ptr<Object>& a, const Pose& pose_a, const std::shared_ptr<Object>& b,
                           const Pose& pose_b) {
  using Found = decltype(intersect(*a, pose_a, *b, pose_b));
  const auto answer = std::make_shared<const Found>(unlocked([&] { return intersect(*a, pose_a, *b, pose_b); }));
  const auto text = [=] { return proof_of(AskedPair{*a, pose_a, *b, pose_b}, *answer); };
  return {{{answer->cost, text}, answer->meet()}, answer->decided_by};
}

template <class Object, class Pose>
void bind_intersect(nb::module_& module, const char* doc) {
  const nb::arg a("a"), pose_a("pose_a"), b("b"), pose_b("pose_b");
  module.def("intersect", &answer_of<Object, Pose>, a, pose_a, b, pose_b, doc);
  using Shared = std::shared_ptr<Object>;
  module.def("intersect", [](const Shared& x, const Shared& y) { return answer_of(x, Pose(), y, Pose()); }, a, b, doc);
}

// Binds the class Pose, but for what only one dimension has.
template <std::size_t D, class Pose>
nb::class_<Pose> bind_pose(nb::module_& chapter) {
  constexpr int d = D;
  nb::class_<Pose> pose(chapter, "Pose",
                        "x_world = linear x_object + translation: these doubles are the map, exactly.");
  pose.def(nb::init<>(), "The identity.");
  pose.def_static(
      "from_matrix",
      [](const ArrayLike& linear, const ArrayLike& translation) {
        return Pose::from_matrix(numbers_of<D * D>(linear, "linear", {{d, d}, {d * d}}),
                                 numbers_of<D>(translation, "translation", {{d}}));
      },
      nb::arg("linear"), nb::arg("translation"), "An invertible linear part, row by row.");
  pose.def_prop_ro("linear", [](const Pose& p) { return matrix_of<D>(p.affine().linear); }, owned);
  pose.def_prop_ro(
      "translation", [](const Pose& p) { return array_of<double>(std::span<const double>(p.affine().translation)); },
      owned);
  return pose;
}

// The pose of D rows of D + 1 numbers, each a row of the linear part and a number of the translation. Throws Error
// bad_pose that names it.
template <class Kind>
typename Kind::Pose pose_of_rows(const double* numbers, const char* place, std::size_t k) {
  constexpr std::size_t D = Kind::dimension;
  std::array<double, D * D> linear;
  std::array<double, D> translation;
  for (std::size_t i = 0; i < D; ++i) {
    std::copy_n(numbers + (D + 1) * i, D, &linear[D * i]);
    translation[i] = numbers[(D + 1) * i + D];
  }
  try {
    return Kind::Pose::from_matrix(linear, translation);
  } catch (const Error& error) {
    throw Error(error.code(), error.text(), place + ("[" + std::to_string(k) + "]"));
  }
}

// Which pairs meet? For python/sunder/_many.py: objects and poses are one, or as many as pairs, and lists are its own.
template <class Kind>
auto meet_many(const std::vector<const typename Kind::Object*>& a, const Doubles& poses_a,
               const std::vector<const typename Kind::Object*>& b, const Doubles& poses_b, std::size_t count) {
  constexpr std::size_t numbers = Kind::dimension * (Kind::dimension + 1);
  const auto fits = [count](std::size_t size) { return size == 1 || size == count; };
  const bool are_objects = std::count(a.begin(), a.end(), nullptr) == 0 && std::count(b.begin(), b.end(), nullptr) == 0;
  const std::size_t at_a = poses_a.size() / numbers, at_b = poses_b.size() / numbers;
  if (!are_objects || !fits(a.size()) || !fits(b.size()) || !fits(at_a) || !fits(at_b)) {
    throw nb::type_error("give objects, none of them None, and one of each or as many as pairs");
  }
  std::vector<std::uint8_t> meet(count);
  unlocked([&] {
    std::optional<typename Kind::Pose> one_a, one_b;
    if (at_a == 1) one_a = pose_of_rows<Kind>(poses_a.data(), "poses_a", 0);
    if (at_b == 1) one_b = pose_of_rows<Kind>(poses_b.data(), "poses_b", 0);
    const auto object_a = [&](std::size_t k) -> const auto& { return *a[a.size() == 1 ? 0 : k]; };
    const auto object_b = [&](std::size_t k) -> const auto& { return *b[b.size() == 1 ? 0 : k]; };
    const auto pose_a = [&](std::size_t k) {
      return one_a ? *one_a : pose_of_rows<Kind>(poses_a.data() + numbers * k, "poses_a", k);
    };
    const auto pose_b = [&](std::size_t k) {
      return one_b ? *one_b : pose_of_rows<Kind>(poses_b.data() + numbers * k, "poses_b", k);
    };
    if constexpr (Kind::dimension == 3) {
      // In blocks, so that memory does not grow with the poses.
      constexpr std::size_t block = 1024;
      std::vector<solid::Pose> poses(2 * std::min(block, count));
      std::vector<solid::PlacedPair> pairs(std::min(block, count));
      for (std::size_t begin = 0; begin < count; begin += block) {
        may_be_interrupted(10 * block);
        const std::size_t length = std::min(block, count - begin);
        for (std::size_t k = 0; k < length; ++k) {
          poses[2 * k] = pose_a(begin + k);
          poses[2 * k + 1] = pose_b(begin + k);
          pairs[k] = {&object_a(begin + k), &poses[2 * k], &object_b(begin + k), &poses[2 * k + 1]};
        }
        polyhedron_polyhedron_batch(std::span(pairs).first(length), std::span(meet).subspan(begin, length));
      }
    } else {
      for (std::size_t k = 0; k < count; ++k) {
        may_be_interrupted(5);
        meet[k] = intersect(object_a(k), pose_a(k), object_b(k), pose_b(k)).meet();
      }
    }
  });
  return array_of<bool>(std::move(meet));
}

template <class Kind>
void bind_pair(nb::module_& module, nb::module_& chapter, const char* name, const char* name_of_contact) {
  using Object = typename Kind::Object;
  using Pose = typename Kind::Pose;
  const auto contact = [](const Object& a, const Pose& pose_a, const Object& b, const Pose& pose_b) {
    return name_of(Kind::contact(a, pose_a, b, pose_b));
  };
  constexpr const char* doc = "Do two convex objects meet, placed or as they are? Touching is meeting.";
  const nb::arg a("a"), pose_a("pose_a"), b("b"), pose_b("pose_b");
  chapter.def(name, &answer_of<Object, Pose>, a, pose_a, b, pose_b, doc);
  bind_intersect<Object, Pose>(module, doc);
  chapter.def(name_of_contact, contact, a, pose_a, b, pose_b, "\"none\", \"touching\" or \"overlapping\".");
  chapter.def("_meet", &meet_many<Kind>);
}

nb::bytes hull_certificate(const ArrayLike& given, const std::string& name) {
  if (name.empty()) throw Error(ErrorCode::bad_value, "give a name that is not empty", "name");
  const std::vector<Point3> points = entries_of<Point3>(given, "points");
  return bytes_of_file([&](ClaimsWriter& file) { solid::write_hull(file, name, points, ConvexPolyhedron(points)); });
}

std::vector<std::vector<std::uint32_t>> facets_of(const ConvexPolyhedron& body) {
  std::vector<std::vector<std::uint32_t>> facets;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f)
    facets.emplace_back(body.facet(f).begin(), body.facet(f).end());
  return facets;
}

std::shared_ptr<solid::Mesh> mesh_of(const ArrayLike& vertices, const std::vector<std::vector<std::uint32_t>>& faces) {
  const std::vector<Point3> points = entries_of<Point3>(vertices, "vertices");
  std::vector<std::uint32_t> begin{0}, corners;
  for (const std::vector<std::uint32_t>& face : faces) {
    corners.insert(corners.end(), face.begin(), face.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return unlocked([&] { return std::make_shared<solid::Mesh>(solid::MeshView{points, begin, corners}); });
}

}  // namespace

void bind_planar(nb::module_& module, nb::module_& planar) {
  nb::class_<PythonPairAnswer, YesNo>(module, "PairAnswer", "Do two placed objects meet? True where they do.")
      .def_prop_ro("decided_by", [](const PythonPairAnswer& answer) { return name_of(answer.decided_by); });
  bind_pose<2, planar::Pose>(planar).def_static(
      "from_angle",
      [](double angle, const ArrayLike& translation) {
        return planar::Pose::from_angle(angle, numbers_of<2>(translation, "translation", {{2}}));
      },
      nb::arg("angle"), nb::arg("translation"), "A rotation in radians, rounded to doubles; then the translation.");
  const nb::arg vertices("vertices"), points("points");
  nb::class_<ConvexPolygon>(planar, "ConvexPolygon", "A convex polygon, closed; segments and points are some too.")
      .def_static(
          "from_vertices",
          [](const ArrayLike& given) { return ConvexPolygon::from_vertices(entries_of<Point2>(given, "vertices")); },
          vertices, "Strictly convex vertices, counter-clockwise: checked exactly.")
      .def_static(
          "mended", [](const ArrayLike& given) { return ConvexPolygon::mended(entries_of<Point2>(given, "vertices")); },
          vertices, "The same, without repeated and collinear vertices, and turned round if need be.")
      .def_static(
          "hull_of", [](const ArrayLike& given) { return ConvexPolygon::hull_of(entries_of<Point2>(given, "points")); },
          points, "The exact convex hull of any points.")
      .def("__len__", &ConvexPolygon::size)
      .def_prop_ro(
          "vertices", [](const ConvexPolygon& polygon) { return array_of<double, 2>(polygon.vertices()); }, owned);
  bind_pair<Planar>(module, planar, "polygon_polygon", "polygon_polygon_contact");
}

void bind_solid(nb::module_& module, nb::module_& solid) {
  bind_pose<3, solid::Pose>(solid)
      .def_static(
          "from_matrix4",
          [](const ArrayLike& rows) { return solid::Pose::from_matrix4(numbers_of<16>(rows, "rows", {{4, 4}, {16}})); },
          nb::arg("rows"), "A matrix whose last row is 0 0 0 1.")
      .def_static(
          "from_quaternion",
          [](double w, double x, double y, double z, const ArrayLike& translation) {
            return solid::Pose::from_quaternion(w, x, y, z, numbers_of<3>(translation, "translation", {{3}}));
          },
          nb::arg("w"), nb::arg("x"), nb::arg("y"), nb::arg("z"), nb::arg("translation"),
          "The rotation of w + x i + y j + z k, of any length but zero, rounded to doubles; then the translation.");
  solid.def("compose", &solid::compose, nb::arg("outer"), nb::arg("inner"), "First inner, then outer, rounded.");
  nb::class_<ConvexPolyhedron>(solid, "ConvexPolyhedron", "The exact convex hull of any points of space, closed.")
      .def(
          "__init__",
          [](ConvexPolyhedron* self, const ArrayLike& given) {
            const std::vector<Point3> points = entries_of<Point3>(given, "points");
            unlocked([&] { new (self) ConvexPolyhedron(points); });
          },
          nb::arg("points"))
      .def_prop_ro("dimension", &ConvexPolyhedron::dimension, "0 a point, 1 a segment, 2 a flat polygon, 3 a body.")
      .def_prop_ro(
          "vertices", [](const ConvexPolyhedron& body) { return array_of<double, 3>(body.vertices()); }, owned)
      .def_prop_ro(
          "source", [](const ConvexPolyhedron& body) { return array_of<std::uint32_t>(body.source()); }, owned,
          "For each vertex, its index among the points given.")
      .def_prop_ro("facets", &facets_of, "The vertices of each facet, counter-clockwise from outside.")
      .def("__len__", [](const ConvexPolyhedron& body) { return body.vertices().size(); });
  bind_pair<Solid>(module, solid, "polyhedron_polyhedron", "polyhedron_polyhedron_contact");
  nb::class_<solid::Mesh>(solid, "Mesh", "Triangles as they are, and what is inside of their closed pieces.")
      .def(nb::new_(&mesh_of), nb::arg("vertices"), nb::arg("faces"), "Faces are lists of numbers of vertices.")
      .def_prop_ro("closed", &solid::Mesh::is_closed, "Is no piece open?")
      .def_prop_ro("pieces", [](const solid::Mesh& mesh) { return mesh.pieces().size(); })
      .def("__len__", [](const solid::Mesh& mesh) { return mesh.triangles().size(); }, "How many triangles it has.");
  bind_intersect<solid::Mesh, solid::Pose>(module,
                                           "Do two meshes meet, as they are, placed or not? Touching is meeting.");
  solid.def("hull_certificate", &hull_certificate, nb::arg("points"), nb::arg("name") = "body",
            "The certificate file of what the convex hull of these points is, facet by facet.");
  bind_sections(solid);
}

}  // namespace sunder::python
