#include "polygons.h"

namespace sunder::python {

namespace {

using planar::Polygon;
using planar::PolygonRings;
using planar::PolygonRule;

bool is_list(nb::handle given) { return nb::isinstance<nb::list>(given) || nb::isinstance<nb::tuple>(given); }

bool is_number(nb::handle given) { return PyNumber_Check(given.ptr()) != 0 && !nb::hasattr(given, "__len__"); }

// 0 for a number, 1 for a point, 2 for a ring, 3 for a polygon, 4 for a multipolygon, by what comes first; 5 and more
// for what is none of these.
int depth_of(nb::handle given, int most = 5) {
  if (nb::hasattr(given, "ndim")) return nb::cast<int>(given.attr("ndim"));
  if (!is_list(given)) return is_number(given) ? 0 : 5;
  return nb::len(given) == 0 || most == 0 ? 1 : 1 + depth_of(given[0], most - 1);
}

std::string at(const std::string& place, std::size_t i) { return place + "[" + std::to_string(i) + "]"; }

}  // namespace

PolygonRule rule_of(std::string_view name) {
  if (name == "simple") return PolygonRule::simple;
  if (name == "valid") return PolygonRule::valid;
  if (name == "self-touch") return PolygonRule::self_touch;
  throw Error(ErrorCode::bad_call, "there is no '" + std::string(name) + "'; give one of simple, valid, self-touch",
              "rule");
}

PolygonRings rings_of(nb::handle given, const std::string& place) {
  PolygonRings rings;
  if (depth_of(given) == 2) {  // a ring alone
    rings.push_back(points_of<2>(given, place.c_str()));
    return rings;
  }
  if (depth_of(given) != 3) {
    throw Error(ErrorCode::bad_shape, "give a list of rings, each an array of (N, 2) numbers; or one such ring", place);
  }
  for (const nb::handle ring : given) rings.push_back(points_of<2>(ring, at(place, rings.size()).c_str()));
  return rings;
}

std::vector<PolygonRings> parts_of(nb::handle given) {
  std::vector<PolygonRings> parts;
  if (depth_of(given) == 4) {
    for (const nb::handle part : given) parts.push_back(rings_of(part, at("parts", parts.size())));
  } else {
    parts.push_back(rings_of(given, "parts"));
  }
  return parts;
}

void bind_polygons(nb::module_& planar) {
  nb::class_<Polygons>(planar, "Polygons",
                       "Polygons with holes, numbered from 0: a list, each a list of rings, or one ring. A ring is an "
                       "array of (N, 2) numbers. They are checked to be valid, but that rings may touch themselves.")
      .def(
          "__init__",
          [](Polygons* self, const nb::object& given) {
            std::vector<PolygonRings> all;
            if (!is_list(given)) throw Error(ErrorCode::bad_shape, "give a list of polygons", "polygons");
            for (const nb::handle one : given) all.push_back(rings_of(one, at("polygons", all.size())));
            Polygons made;
            unlocked([&] {
              for (const PolygonRings& rings : all) {
                const std::string place = at("polygons", made.size());
                try {
                  made.members.emplace_back(rings);
                } catch (const Error& error) {
                  throw Error(error.code(), error.what(), place);
                }
                const auto found = planar::polygon_defects(std::span(&rings, 1), {PolygonRule::self_touch, 1});
                if (!found.valid()) {
                  throw Error(ErrorCode::bad_shape,
                              "it is not valid: " + std::string(name_of(found.defects.front().kind)) +
                                  "; polygon_defects tells where",
                              place);
                }
              }
            });
            new (self) Polygons(std::move(made));
          },
          nb::arg("polygons"))
      .def("__len__", &Polygons::size);
}

}  // namespace sunder::python
