// Sets of segments, discs, polygons and convex polygons: any, all, count; and whether a polygon is valid.
#include <sunder/planar/set/convex_polygons_any.h>
#include <sunder/planar/set/convex_polygons_any_json.h>
#include <sunder/planar/set/discs_all.h>
#include <sunder/planar/set/discs_any.h>
#include <sunder/planar/set/discs_any_json.h>
#include <sunder/planar/set/polygon_simple.h>
#include <sunder/planar/set/polygon_valid.h>
#include <sunder/planar/set/polygon_valid_json.h>
#include <sunder/planar/set/polygons_all.h>
#include <sunder/planar/set/polygons_any.h>
#include <sunder/planar/set/polygons_json.h>
#include <sunder/planar/set/segments_all.h>
#include <sunder/planar/set/segments_any.h>
#include <sunder/planar/set/segments_json.h>

#include "polygons.h"

#include <algorithm>

namespace sunder::python {

namespace {

using planar::ConvexPolygon;
using planar::Discs;
using planar::PolygonDefect;
using planar::PolygonRings;
using planar::PolygonRule;
using planar::RingPlace;
using planar::Segments;

// --- Answers of all sets ------------------------------------------------------------------------------------------

using Contact = std::tuple<std::uint32_t, std::uint32_t, std::string_view>;  // i, j, kind

struct Any : YesNo {
  std::optional<Contact> found;
};

struct All : Answer {
  std::vector<std::array<std::uint32_t, 2>> pairs;  // by i, then j
  std::vector<std::string_view> kinds;
};

struct Count : Answer {
  std::uint64_t count = 0;
};

// What is asked of a set, with the members of a group for each: kept for the certificate.
template <class Set>
struct Asked {
  std::shared_ptr<Set> set;
  Allowed allowed;
  std::vector<std::uint32_t> groups;

  SetOptions options(bool transcript = false) const { return {allowed, groups, nullptr, transcript}; }
};
template <class Set>
using Shared = std::shared_ptr<const Asked<Set>>;

// only_touch: sets of which `shared-endpoint` says nothing of its own.
template <class Set>
Shared<Set> asked_of(const std::shared_ptr<Set>& set, std::string_view allowed, nb::handle groups, bool only_touch) {
  using enum Allowed;
  const Allowed rule = only_touch ? named(allowed, {nothing, touch}, "allowed")
                                  : named(allowed, {nothing, shared_endpoint, touch}, "allowed");
  return std::make_shared<const Asked<Set>>(Asked<Set>{set, rule, groups_of(groups, set->size())});
}

std::string_view kind_of(const planar::SegmentsContact& c) { return name_of(c.kind); }
std::string_view kind_of(const planar::DiscsContact& c) { return name_of(c.kind); }
std::string_view kind_of(const planar::ConvexPolygonsContact& c) { return name_of(c.kind); }
std::string_view kind_of(const planar::PolygonsContact& c) { return name_of(c.contact); }

template <class Found>
Any any_of(const AnyAnswer<Found>& answer, std::function<std::string()> text) {
  Any result;
  result.cost = answer.cost;
  result.certificate_text = std::move(text);
  result.yes = answer.meet();
  if (answer.found) result.found = Contact(answer.found->i, answer.found->j, kind_of(*answer.found));
  return result;
}

template <class Found>
All all_of(AllAnswer<Found>&& answer, std::function<std::string()> text) {
  std::sort(answer.contacts.begin(), answer.contacts.end(),
            [](const Found& a, const Found& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
  All result{{answer.cost, std::move(text)}, {}, {}};
  for (const Found& c : answer.contacts) {
    result.pairs.push_back({c.i, c.j});
    result.kinds.push_back(kind_of(c));
  }
  return result;
}

// --- Segments and discs -------------------------------------------------------------------------------------------

Any segments_any(const Shared<Segments>& asked) {
  const planar::SegmentsAnswer answer = planar::segments_any(*asked->set, asked->options());
  const auto text = [asked, found = answer.found] {
    planar::SegmentsAnswer proved;
    proved.found = found;
    if (!found) proved = planar::segments_any(*asked->set, asked->options(true));
    return certificate_text(*asked->set, asked->allowed, proved, asked->groups);
  };
  return any_of(answer, text);
}

All segments_all(const Shared<Segments>& asked) {
  return all_of(planar::segments_all(*asked->set, asked->options()), [asked] {
    const auto answer = planar::segments_all(*asked->set, asked->options(true));
    return certificate_text(*asked->set, asked->allowed, answer, asked->groups);
  });
}

Count segments_count(const Shared<Segments>& asked) {
  const auto answer = planar::segments_count(*asked->set, asked->options());
  const auto text = [asked] {
    const auto proved = planar::segments_count(*asked->set, asked->options(true));
    return certificate_text(*asked->set, asked->allowed, proved, asked->groups);
  };
  return {{answer.cost, text}, answer.count};
}

Any discs_any(const Shared<Discs>& asked) {
  const planar::DiscsAnswer answer = planar::discs_any(*asked->set, asked->options());
  return any_of(answer,
                [asked, answer] { return certificate_text(*asked->set, asked->allowed, answer, asked->groups); });
}

All discs_all(const Shared<Discs>& asked) {
  return all_of(planar::discs_all(*asked->set, asked->options()), [asked] {
    return certificate_text(*asked->set, asked->allowed, planar::discs_all(*asked->set, asked->options()),
                            asked->groups);
  });
}

Count discs_count(const Shared<Discs>& asked) {
  const CountAnswer answer = planar::discs_count(*asked->set, asked->options());
  const auto text = [asked, answer] { return certificate_text(*asked->set, asked->allowed, answer, asked->groups); };
  return {{answer.cost, text}, answer.count};
}

// --- Polygons -----------------------------------------------------------------------------------------------------

planar::PolygonsAsked question(const Asked<Polygons>& asked) {
  return {asked.set->members, asked.allowed, asked.groups};
}

// The file with one statement, which `write` writes.
template <class Write>
std::string file_of(const Write& write) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  write(file);
  file.end();
  return text;
}

Any polygons_any(const Shared<Polygons>& asked) {
  const planar::PolygonsAnswer answer = planar::polygons_any(asked->set->members, asked->options());
  return any_of(answer, [asked, answer] {
    return certificate_text(std::span<const planar::Polygon>(asked->set->members), asked->allowed, answer,
                            asked->groups);
  });
}

All polygons_all(const Shared<Polygons>& asked) {
  return all_of(planar::polygons_all(asked->set->members, asked->options()), [asked] {
    const auto answer = planar::polygons_all(asked->set->members, asked->options());
    return file_of([&](ClaimsWriter& file) {
      write_these(file, question(*asked), *planar::polygon_events(asked->set->members), [&](const auto& take) {
        for (const planar::PolygonsContact& c : answer.contacts) take(c.i, c.j);
      });
    });
  });
}

Count polygons_count(const Shared<Polygons>& asked) {
  const planar::PolygonsCountAnswer answer = planar::polygons_count(asked->set->members, asked->options());
  const std::uint64_t count = answer.touching + answer.overlapping;
  const auto text = [asked, count] {
    return file_of([&](ClaimsWriter& file) {
      write_count(file, question(*asked), *planar::polygon_events(asked->set->members), count);
    });
  };
  return {{answer.cost, text}, count};
}

Any convex_polygons_any(const std::vector<const ConvexPolygon*>& given, std::string_view allowed,
                        const nb::object& groups) {
  auto polygons = std::make_shared<std::vector<ConvexPolygon>>();
  for (const ConvexPolygon* polygon : given) polygons->push_back(*polygon);
  const auto asked = asked_of(polygons, allowed, groups, true);
  return unlocked([&] {
    const auto answer = planar::convex_polygons_any(*asked->set, asked->options());
    return any_of(answer,
                  [asked, answer] { return certificate_text(*asked->set, asked->allowed, answer, asked->groups); });
  });
}

// --- One polygon --------------------------------------------------------------------------------------------------

struct Defects : Answer {
  std::vector<PolygonDefect> defects;
};

Defects defects_of(const nb::object& given, std::string_view rule_name) {
  const PolygonRule rule = rule_of(rule_name);
  const auto parts = std::make_shared<const std::vector<PolygonRings>>(parts_of(given));
  return unlocked([&] {
    planar::PolygonDefects found = planar::polygon_defects(*parts, {rule});
    const auto text = [parts, rule, defects = found.defects] {
      return file_of([&](ClaimsWriter& file) {
        file.begin_table("polygons");
        planar::write_parts(file, *parts);
        file.end_table();
        bool stated = defects.empty();
        if (stated) planar::write_valid(file, *parts, 0, rule);
        for (const PolygonDefect& defect : defects) stated |= planar::write_defect(file, *parts, 0, rule, defect);
        if (!stated)
          throw Error(ErrorCode::bad_call, "these defects have no proof that a file could hold", "certificate");
      });
    };
    return Defects{{found.cost, text}, std::move(found.defects)};
  });
}

using Place = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // part, ring, edge
Place place(const RingPlace& p) { return {p.part, p.ring, p.edge}; }

std::vector<std::tuple<std::string_view, Place, Place, std::pair<double, double>>> listed(const Defects& found) {
  std::vector<std::tuple<std::string_view, Place, Place, std::pair<double, double>>> list;
  for (const PolygonDefect& d : found.defects) {
    list.emplace_back(name_of(d.kind), place(d.a), place(d.b), std::pair(d.place.a.x, d.place.a.y));
  }
  return list;
}

// --- Binding ------------------------------------------------------------------------------------------------------

constexpr const char* any_doc =
    "Do any two meet, in a way that counts? allowed: what does not count. groups: members of "
    "one group may meet.";
constexpr const char* all_doc = "Which pairs meet, in a way that counts? By i, then j.";
constexpr const char* count_doc = "How many pairs meet, in a way that counts?";

template <class Set, class Result>
void bind_question(nb::module_& planar, const char* name, const char* members, const char* doc, bool only_touch,
                   Result (*ask)(const Shared<Set>&)) {
  planar.def(
      name,
      [ask, only_touch](const std::shared_ptr<Set>& set, std::string_view allowed, const nb::object& groups) {
        const Shared<Set> asked = asked_of(set, allowed, groups, only_touch);
        return unlocked([&] { return ask(asked); });
      },
      nb::arg(members), nb::arg("allowed") = "nothing", nb::arg("groups").none() = nb::none(), doc);
}

void bind_objects(nb::module_& planar) {
  nb::class_<Segments>(planar, "Segments", "Closed segments, numbered from 0: rows x1, y1, x2, y2.")
      .def(
          "__init__",
          [](Segments* self, const ArrayLike& given) {
            const Doubles rows = doubles_of(given, "segments", {{any_length, 4}, {any_length, 2, 2}});
            const auto* const first = reinterpret_cast<const planar::Segment*>(rows.data());
            new (self) Segments(std::vector<planar::Segment>(first, first + rows.shape(0)));
          },
          nb::arg("segments"))
      .def("__len__", &Segments::size);
  nb::class_<Discs>(planar, "Discs", "Circles with their insides, numbered from 0: rows x, y, radius.")
      .def(
          "__init__",
          [](Discs* self, const ArrayLike& given) {
            const Doubles rows = doubles_of(given, "discs", {{any_length, 3}});
            const auto* const first = reinterpret_cast<const Disc*>(rows.data());
            new (self) Discs(std::vector<Disc>(first, first + rows.shape(0)));
          },
          nb::arg("discs"))
      .def("__len__", &Discs::size);
}

void bind_set_answers(nb::module_& planar) {
  nb::class_<Any, YesNo>(planar, "AnyAnswer", "Do any two meet? True where some do.")
      .def_ro("found", &Any::found, "Two that meet and how, (i, j, kind), with i < j; None where none meet.");
  nb::class_<All, Answer>(planar, "AllAnswer", "All pairs that meet, by i, then j.")
      .def_prop_ro(
          "pairs", [](const All& all) { return array_of<std::uint32_t, 2>(all.pairs); },
          "(N, 2) numbers of members, i < j.")
      .def_ro("kinds", &All::kinds, "How each pair meets.")
      .def("__len__", [](const All& all) { return all.pairs.size(); });
  nb::class_<Count, Answer>(planar, "CountAnswer", "How many pairs meet.").def_ro("count", &Count::count);
}

}  // namespace

void bind_sets(nb::module_& planar) {
  bind_objects(planar);
  bind_polygons(planar);
  bind_set_answers(planar);
  bind_question(planar, "segments_any", "segments", any_doc, false, segments_any);
  bind_question(planar, "segments_all", "segments", all_doc, false, segments_all);
  bind_question(planar, "segments_count", "segments", count_doc, false, segments_count);
  bind_question(planar, "discs_any", "discs", any_doc, true, discs_any);
  bind_question(planar, "discs_all", "discs", all_doc, true, discs_all);
  bind_question(planar, "discs_count", "discs", count_doc, true, discs_count);
  bind_question(planar, "polygons_any", "polygons", any_doc, false, polygons_any);
  bind_question(planar, "polygons_all", "polygons", all_doc, false, polygons_all);
  bind_question(planar, "polygons_count", "polygons", count_doc, false, polygons_count);
  planar.def("convex_polygons_any", &convex_polygons_any, nb::arg("polygons"), nb::arg("allowed") = "nothing",
             nb::arg("groups").none() = nb::none(), any_doc);
  nb::class_<Defects, Answer>(planar, "PolygonDefects", "What is wrong with a polygon.")
      .def_prop_ro("valid", [](const Defects& found) { return found.defects.empty(); })
      .def_prop_ro("defects", &listed, "(kind, a, b, (x, y)), where a and b are (part, ring, edge).");
  planar.def(
      "polygon_defects", &defects_of, nb::arg("parts"), nb::arg("rule") = "valid",
      "Is a polygon, a list of rings, or a multipolygon, a list of such, valid? rule: \"simple\", \"valid\" as by "
      "OGC, or \"self-touch\", where rings may touch themselves.");
}

}  // namespace sunder::python
