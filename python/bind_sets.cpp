// Sets of segments, discs, polygons and convex polygons: any, all, count.
#include <sunder/planar/discs/discs_any_claims.h>
#include <sunder/planar/object/constraints.h>
#include <sunder/planar/polygons/convex_polygons_any_claims.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/segments/segments_claims.h>

#include "common.h"

#include <algorithm>

namespace sunder::python {

namespace {

using planar::ConvexPolygon;
using planar::Discs;
using planar::Segments;

struct Any : YesNo {
  std::optional<std::tuple<std::uint32_t, std::uint32_t, std::string_view>> found;  // i, j, kind
};

struct All : Answer {
  std::vector<std::array<std::uint32_t, 2>> pairs;  // by i, then j
  std::vector<std::string_view> kinds;
};

struct Count : Answer {
  std::uint64_t count = 0;
};

// What is asked of a set: kept for the certificate.
template <class Set>
struct Asked {
  std::shared_ptr<Set> set;
  Allowed allowed;
  std::vector<std::uint32_t> groups;

  SetOptions options() const { return {allowed, groups, nullptr}; }
};

const Segments& members_of(const Segments& set) { return set; }
const Discs& members_of(const Discs& set) { return set; }
std::span<const planar::Polygon> members_of(const Polygons& set) { return set.members; }
std::span<const ConvexPolygon> members_of(const std::vector<ConvexPolygon>& set) { return set; }

template <class Set, class Found>
std::string proof_of(const Asked<Set>& asked, const Found& answer) {
  return certificate_text(members_of(*asked.set), asked.allowed, answer, asked.groups);
}
template <class Write>
std::string proof_of_polygons(const Asked<Polygons>& asked, const Write& write) {
  const std::span<const planar::Polygon> polygons = members_of(*asked.set);
  return file_of([&](ClaimsWriter& file) {
    write(file, planar::PolygonsAsked{polygons, asked.allowed, asked.groups}, *planar::polygon_events(polygons));
  });
}
std::string proof_of(const Asked<Polygons>& asked, const planar::PolygonsAllAnswer& answer) {
  return proof_of_polygons(asked, [&](ClaimsWriter& file, const auto& of, const auto& events) {
    write_these(file, of, events, [&](const auto& take) {
      for (const planar::PolygonsContact& c : answer.found) take(c);
    });
  });
}
std::string proof_of(const Asked<Polygons>& asked, const planar::PolygonsCountAnswer& answer) {
  return proof_of_polygons(asked, [&](ClaimsWriter& file, const auto& of, const auto& events) {
    write_count(file, of, events, answer.count.overlapping, answer.count.touching);
  });
}

template <class Contact>
std::string_view kind_of(const Contact& c) {
  return name_of(c.kind);
}
std::string_view kind_of(const planar::PolygonsContact& c) { return name_of(c.contact); }

std::uint64_t sum_of(std::uint64_t count) { return count; }
std::uint64_t sum_of(const planar::PolygonsCount& count) { return count.touching + count.overlapping; }

// Asks by the method; the certificate is of the contact that was found, or of the same answer, asked for again.
template <auto Method, class Set>
auto answer_of(const std::shared_ptr<const Asked<Set>>& asked) {
  auto answer = Method(members_of(*asked->set), asked->options());
  const auto text = [asked] { return proof_of(*asked, Method(members_of(*asked->set), asked->options())); };
  if constexpr (requires { answer.meet(); }) {
    Any result{{{answer.cost, text}, answer.meet()}, {}};
    if (answer.found) {
      result.found = {answer.found->i, answer.found->j, kind_of(*answer.found)};
      result.certificate_text = [asked, answer] { return proof_of(*asked, answer); };
    }
    return result;
  } else if constexpr (requires { answer.found; }) {  // all of them
    std::sort(answer.found.begin(), answer.found.end(),
              [](const auto& a, const auto& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
    All result{{answer.cost, text}, {}, {}};
    for (const auto& c : answer.found) {
      result.pairs.push_back({c.i, c.j});
      result.kinds.push_back(kind_of(c));
    }
    return result;
  } else {
    return Count{{answer.cost, text}, sum_of(answer.count)};
  }
}

Allowed allowed_of(std::string_view name, bool has_ends) {
  for (const Allowed allowed : {Allowed::nothing, Allowed::touch, Allowed::shared_endpoint}) {
    if (name_of(allowed) == name && (has_ends || allowed != Allowed::shared_endpoint)) return allowed;
  }
  throw Error(ErrorCode::bad_call, has_ends ? "give nothing, shared-endpoint or touch" : "give nothing or touch",
              "allowed");
}

using ConvexPolygons = std::vector<ConvexPolygon>;
template <class Set>
std::shared_ptr<Set> kept(const std::shared_ptr<Set>& set) {
  return set;
}
std::shared_ptr<ConvexPolygons> kept(const ConvexPolygons& set) { return std::make_shared<ConvexPolygons>(set); }

// Given: the set, or what holds it.
template <auto Method, class Set, class Given = std::shared_ptr<Set>>
void bind_question(nb::module_& planar, const char* name, const char* members, const char* doc) {
  const auto ask = [](const Given& given, std::string_view allowed, const nb::object& groups) {
    constexpr bool has_ends = !std::is_same_v<Set, Discs> && !std::is_same_v<Set, ConvexPolygons>;
    const Allowed allowing = allowed_of(allowed, has_ends);
    const std::shared_ptr<Set> set = kept(given);
    const auto asked = std::make_shared<const Asked<Set>>(Asked<Set>{set, allowing, groups_of(groups, set->size())});
    return unlocked([&] { return answer_of<Method, Set>(asked); });
  };
  planar.def(name, ask, nb::arg(members), nb::arg("allowed") = "nothing", nb::arg("groups").none() = nb::none(), doc);
}

// Rows of numbers, as a class of sets of entries of as many.
template <class Set, class Entry>
void bind_rows(nb::module_& planar, const char* name, const char* members, const char* doc) {
  nb::class_<Set>(planar, name, doc)
      .def(
          "__init__",
          [members](Set* self, const ArrayLike& given) {
            constexpr int width = sizeof(Entry) / sizeof(double);
            const std::vector<int> flat{any_length, width}, ends{any_length, 2, 2};
            new (self) Set(entries_of<Entry>(width == 4 ? doubles_of(given, members, {flat, ends})
                                                        : doubles_of(given, members, {flat})));
          },
          nb::arg(members))
      .def("__len__", &Set::size);
}

}  // namespace

void bind_sets(nb::module_& planar) {
  bind_rows<Segments, planar::Segment>(planar, "Segments", "segments",
                                       "Closed segments, numbered from 0: rows x1, y1, x2, y2.");
  bind_rows<Discs, Disc>(planar, "Discs", "discs", "Circles with their insides, numbered from 0: rows x, y, radius.");
  bind_rows<planar::Constraints, Constraint>(planar, "Constraints", "constraints",
                                             "Half-planes a x + b y <= c, numbered from 0: rows a, b, c.");
  nb::class_<Any, YesNo>(planar, "AnyAnswer", "Do any two meet? True where some do.")
      .def_ro("found", &Any::found, "Two that meet and how, (i, j, kind), with i < j; None where none meet.");
  nb::class_<All, Answer>(planar, "AllAnswer", "All pairs that meet, by i, then j.")
      .def_prop_ro(
          "pairs", [](const All& all) { return array_of<std::uint32_t, 2>(all.pairs); }, owned,
          "(N, 2) numbers of members, i < j.")
      .def_ro("kinds", &All::kinds, "How each pair meets.")
      .def("__len__", [](const All& all) { return all.pairs.size(); });
  nb::class_<Count, Answer>(planar, "CountAnswer", "How many pairs meet.").def_ro("count", &Count::count);
  constexpr const char* any =
      "Do any two meet, in a way that counts? allowed: what does not count, \"touch\" or "
      "\"shared-endpoint\". groups: members of one group may meet.";
  constexpr const char* all = "Which pairs meet, in a way that counts? By i, then j.";
  constexpr const char* count = "How many pairs meet, in a way that counts?";
  bind_question<planar::segments_any, Segments>(planar, "segments_any", "segments", any);
  bind_question<planar::segments_all, Segments>(planar, "segments_all", "segments", all);
  bind_question<planar::segments_count, Segments>(planar, "segments_count", "segments", count);
  bind_question<planar::discs_any, Discs>(planar, "discs_any", "discs", any);
  bind_question<planar::discs_all, Discs>(planar, "discs_all", "discs", all);
  bind_question<planar::discs_count, Discs>(planar, "discs_count", "discs", count);
  bind_question<planar::polygons_any, Polygons>(planar, "polygons_any", "polygons", any);
  bind_question<planar::polygons_all, Polygons>(planar, "polygons_all", "polygons", all);
  bind_question<planar::polygons_count, Polygons>(planar, "polygons_count", "polygons", count);
  bind_question<planar::convex_polygons_any, ConvexPolygons, ConvexPolygons>(planar, "convex_polygons_any", "polygons",
                                                                             any);
}

}  // namespace sunder::python
