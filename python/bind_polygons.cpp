// One polygon or multipolygon: is it valid, and its kernel; and sets of polygons that are valid.
#include <sunder/planar/polygons/polygon_valid_claims.h>

#include "common.h"

namespace sunder::python {

namespace {

using planar::PolygonDefect;
using planar::PolygonRings;
using planar::PolygonRule;
using planar::RingPlace;

struct Defects : Answer {
  std::vector<PolygonDefect> defects;
};

PolygonRings rings_of(nb::handle checked) {
  PolygonRings rings;
  for (const nb::handle ring : checked) rings.push_back(entries_of<Point2>(nb::cast<Doubles>(ring)));
  return rings;
}

// Lists of lists of rings, as a function of python/sunder/_arrays.py checks them.
std::vector<PolygonRings> all_rings_of(const char* checker, nb::handle given, const char* place) {
  std::vector<PolygonRings> all;
  const nb::object checked = nb::module_::import_("sunder._arrays").attr(checker)(given, place);
  for (const nb::handle one : checked) all.push_back(rings_of(one));
  return all;
}

PolygonRule rule_of(std::string_view name) {
  if (name == "simple") return PolygonRule::simple;
  if (name == "valid") return PolygonRule::valid;
  if (name == "self-touch") return PolygonRule::self_touch;
  throw Error(ErrorCode::bad_call, "give one of simple, valid, self-touch", "rule");
}

std::string proof_of(const std::vector<PolygonRings>& parts, PolygonRule rule,
                     const std::vector<PolygonDefect>& defects) {
  return file_of([&](ClaimsWriter& file) {
    file.begin_table("polygons");
    planar::write_parts(file, parts);
    file.end_table();
    planar::ValidClaims claims(file, parts, 0, rule);
    bool stated = defects.empty();
    if (stated) claims.write_valid();
    for (const PolygonDefect& defect : defects) stated |= claims.write_defect(defect);
    if (!stated) throw Error(ErrorCode::bad_call, "these defects have no proof that a file can hold", "certificate");
  });
}

Defects polygon_defects(const nb::object& given, std::string_view rule_name) {
  const PolygonRule rule = rule_of(rule_name);
  const auto parts = std::make_shared<const std::vector<PolygonRings>>(all_rings_of("parts", given, "parts"));
  return unlocked([&] {
    planar::PolygonDefects found = planar::polygon_defects(*parts, {rule});
    const auto text = [parts, rule, defects = found.found] { return proof_of(*parts, rule, defects); };
    return Defects{{found.cost, text}, std::move(found.found)};
  });
}

nb::list listed(const Defects& found) {
  const auto place = [](const RingPlace& p) { return nb::make_tuple(p.part, p.ring, p.edge); };
  return list_of(found.defects, [&](const PolygonDefect& d) {
    return nb::make_tuple(name_of(d.kind), place(d.a), place(d.b), nb::make_tuple(d.place.a.x, d.place.a.y));
  });
}

}  // namespace

planar::Polygon checked_polygon(const PolygonRings& rings, PolygonRule rule, const std::string& place) {
  try {
    const auto found = planar::polygon_defects(std::span(&rings, 1), {rule, 1});
    if (found.found.empty()) return planar::Polygon(rings);
    const std::string is_not = rule == PolygonRule::simple ? "it is not simple: " : "it is not valid: ";
    throw Error(ErrorCode::bad_shape,
                is_not + std::string(name_of(found.found.front().kind)) + "; polygon_defects tells where");
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), place);
  }
}

PolygonRings one_polygon(nb::handle given, const char* place) {
  return rings_of(nb::module_::import_("sunder._arrays").attr("rings")(given, place));
}

void bind_polygons(nb::module_& planar) {
  nb::class_<Polygons>(planar, "Polygons",
                       "Polygons with holes, numbered from 0: a list, each a list of rings, or one ring. A ring is an "
                       "array of (N, 2) numbers. They are checked to be valid, but that rings may touch themselves.")
      .def(
          "__init__",
          [](Polygons* self, const nb::object& given) {
            const std::vector<PolygonRings> all = all_rings_of("polygons", given, "polygons");
            Polygons made;
            unlocked([&] {
              for (const PolygonRings& rings : all) {
                const std::string place = "polygons[" + std::to_string(made.size()) + "]";
                made.members.push_back(checked_polygon(rings, PolygonRule::self_touch, place));
              }
            });
            new (self) Polygons(std::move(made));
          },
          nb::arg("polygons"))
      .def("__len__", &Polygons::size);
  nb::class_<Defects, Answer>(planar, "PolygonDefects", "What is wrong with a polygon.")
      .def_prop_ro("valid", [](const Defects& found) { return found.defects.empty(); })
      .def_prop_ro("defects", &listed, "(kind, a, b, (x, y)), where a and b are (part, ring, edge).");
  planar.def(
      "polygon_defects", &polygon_defects, nb::arg("parts"), nb::arg("rule") = "valid",
      "Is a polygon, a list of rings, or a multipolygon, a list of such, valid? rule: \"simple\", \"valid\" as by "
      "OGC, or \"self-touch\", where rings may touch themselves.");
}

}  // namespace sunder::python
