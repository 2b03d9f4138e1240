// sunder polygons FILE: do any two polygons meet? Which? How many?
#include <sunder/ask/set/polygons_input.h>
#include <sunder/ask/set/set_verb.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/planar/object/convex_either_way.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/planar/polygons/polygon_contacts_in_order.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/polygons/polygons_common_point.h>

#include <fmt/ranges.h>

namespace sunder::ask {

namespace {

using planar::Polygon;
using planar::PolygonsContact;

struct PolygonsCall : SetCall {
  bool skip_invalid = false, mend = false, self_touch = false;
};

// Takes each convex polygon as a unit (Shamos and Hoey, Theorem 6), and describes a pair that meets as the other
// methods do.
planar::PolygonsAnswer of_convex(std::span<const Polygon> polygons, const SetOptions& options) {
  std::vector<planar::ConvexPolygon> convex;
  convex.reserve(polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    try {
      if (polygons[i].ring_count() > 1) throw Error(ErrorCode::bad_shape, "has holes; give convex polygons");
      convex.push_back(planar::convex_either_way(polygons[i].vertices()).polygon);
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("polygon {}: {}; or give another method", i, error.what()),
                  "--method convex");
    }
  }
  const planar::ConvexPolygonsAnswer answer = planar::convex_polygons_any_by_sweep(convex, options);
  if (!answer.found) return {std::nullopt, answer.cost};
  const auto& [i, j, kind] = static_cast<const ContactOfTwo<Relation>&>(*answer.found);
  planar::PolygonsAnswer told = planar::polygons_contact(polygons[i], polygons[j]);
  told.found->i = i;
  told.found->j = j;
  told.cost = answer.cost;
  return told;
}

using PolygonsAnyMethod = planar::PolygonsAnswer(std::span<const Polygon>, const SetOptions&);
constexpr std::array<Named<PolygonsAnyMethod>, 6> polygons_any_methods{
    {SUNDER_METHOD("automatic", planar::polygons_any),
     SUNDER_METHOD("boxes", planar::polygons_any_by_boxes),
     SUNDER_METHOD("grid", planar::polygons_any_by_grid),
     SUNDER_METHOD("sweep", planar::polygons_any_by_sweep),
     SUNDER_METHOD("scan", planar::polygons_any_by_scan),
     {"convex", of_convex, "planar::convex_polygons_any_by_sweep"}}};
constexpr std::array<Named<planar::PolygonsFinder>, 5> finders{
    {SUNDER_METHOD("automatic", planar::find_contacts_by_boxes), SUNDER_METHOD("boxes", planar::find_contacts_by_boxes),
     SUNDER_METHOD("grid", planar::find_contacts_by_grid), SUNDER_METHOD("sweep", planar::find_contacts_by_sweep),
     SUNDER_METHOD("scan", planar::find_contacts_by_scan)}};

constexpr std::uint64_t most_numbers = 100'000'000;  // of a sweep: at most some 0.8 GB

[[noreturn]] void refuse_proof(const PolygonsInput& input, const std::string& what, std::uint64_t numbers) {
  const std::size_t digits = std::to_string(input.edges()).size();
  throw Error(ErrorCode::bad_call,
              fmt::format("{}, and the proof would have {:.1f} GB or more; leave it out, or ask about less", what,
                          static_cast<double>(numbers * (digits + 1)) / 1e9),
              "--certificate");
}

// The sweep that proves all answers but `some`.
planar::SweepEvents sweep_of(const Talk& talk, const PolygonsInput& input, std::uint64_t pairs) {
  if (pairs > most_proved) {
    refuse_proof(input, fmt::format("{} pairs meet, more than {}", pairs, most_proved), 2 * pairs);
  }
  const auto progress = talk.progress("proving");
  const std::uint64_t most = std::max(most_numbers, 8 * input.edges());  // six for an edge, where none cross
  std::optional<planar::SweepEvents> events = planar::polygon_events(input.polygons, most);
  if (!events) refuse_proof(input, fmt::format("the sweep over all edges has more than {} numbers", most), most);
  return std::move(*events);
}

// A point that shows the contact, and in words what it is.
Point2 place_of(const PolygonsInput& input, const PolygonsContact& c) {
  return nearest(planar::found_point(input.polygons[c.i], input.polygons[c.j], c));
}

std::string shown_by(const PolygonsContact& c) {
  switch (c.kind) {
    case planar::ContactKind::none: return "a vertex inside";
    case planar::ContactKind::shared_endpoint: return "a vertex of both";
    case planar::ContactKind::touch: return "a vertex on an edge";
    case planar::ContactKind::crossing: return "edges that cross";
    default: return "a common border";
  }
}

// The part of polygon i that the contact shows, counted from 0; null where it shows none: of the one that a vertex of
// the other is inside of.
Json part_of(const PolygonsInput& input, const PolygonsContact& c, bool of_i) {
  if (c.kind == planar::ContactKind::none && c.i_inside != of_i) return nullptr;
  const std::uint32_t polygon = of_i ? c.i : c.j;
  const std::vector<std::uint32_t>& part = input.source[polygon].part_of_ring;
  return part.empty() ? 0 : part[input.polygons[polygon].ring_of(of_i ? c.of_i : c.of_j)];
}

// Requires that a group was asked for.
const std::string& group_of(const PolygonsInput& input, std::uint32_t polygon) {
  return input.files.front().groups[input.groups[polygon]];
}

PolygonsRequest request_of(const PolygonsCall& call) {
  return {.files = call.files,
          .drop_z = call.drop_z,
          .leave_out = call.leave_out,
          .skip_invalid = call.skip_invalid,
          .mend = call.mend,
          .rule = call.self_touch ? planar::PolygonRule::self_touch : planar::PolygonRule::valid,
          .group = call.group,
          .name = call.name,
          .properties = call.properties,
          .tell_inputs = call.proves(),
          .mixed_crs = call.mixed_crs};
}

class PolygonsSet {
 public:
  using Call = ask::PolygonsCall;
  using Contact = PolygonsContact;
  using Result = SetResult<PolygonsSet>;
  static constexpr std::string_view verb = "polygons", noun = "polygon", drawn_noun = "edge";
  static constexpr std::array kinds{sunder::Relation::overlapping, sunder::Relation::touching};

  static void check(const PolygonsCall& call) {
    if (call.counts()) {
      method_by(call.method, finders, " (for lists and counts)");
    } else {
      method_by(call.method, polygons_any_methods);
    }
    allowed_by(call.allow);
    if (call.files.size() > 2) {
      throw Error(ErrorCode::bad_call, "three files or more; give one, or two to ask for pairs across them", "FILE");
    }
    require_other_than_scan(call);
  }

  PolygonsSet(const PolygonsCall& call, Talk& talk)
      : call_(call), talk_(talk), input_(read_with_progress(talk, request_of(call))) {
    options_.allowed = allowed_by(call.allow);
    options_.groups = input_.groups;
  }

  const io::CoordinateSystems& systems() const { return input_.systems; }
  std::uint64_t drawn() const { return input_.edges(); }

  void ask(Result& result) const {
    SetOptions options = options_;
    options.progress = talk_.progress("comparing");
    if (!call_.counts()) {
      const Named<PolygonsAnyMethod> method = method_by(call_.method, polygons_any_methods);
      const planar::PolygonsAnswer answer = method(input_.polygons, options);
      result.function = method.function;
      result.cost = answer.cost;
      return result.found(answer.found);
    }
    if (!call_.lists() && call_.method == "automatic") {
      result.function = "planar::polygons_count";
      const planar::PolygonsCountAnswer answer = planar::polygons_count(input_.polygons, options);
      result.count = {answer.count.overlapping, answer.count.touching};
      result.cost = answer.cost;
      return;
    }
    const Named<planar::PolygonsFinder> finder = method_by(call_.method, finders);
    result.function = finder.function;
    const auto contacts = std::make_shared<planar::PolygonContactsInOrder>(input_.polygons, options, finder.method);
    result.count = {contacts->overlapping(), contacts->touching()};
    result.cost = contacts->cost();
    if (call_.lists()) result.visit = [contacts](const Result::Visitor& visitor) { contacts->visit(visitor); };
  }

  std::vector<std::string> prove(const Result& result) const {
    const planar::PolygonsAsked asked{input_.polygons, options_.allowed, options_.groups};
    const bool is_some = !call_.counts() && result.some();
    const planar::SweepEvents events = is_some ? planar::SweepEvents() : sweep_of(talk_, input_, result.pairs());
    write_proof(talk_, call_.certificate, origin_of(input_, "polygons", call_.drop_z), [&](ClaimsWriter& claims) {
      if (is_some) {
        result.for_each([&](const PolygonsContact& c) { write_some(claims, asked, c); });
      } else if (call_.lists()) {
        write_these(claims, asked, events,
                    [&](const auto& take) { result.for_each([&](const PolygonsContact& c) { take(c); }); });
      } else if (call_.count) {
        write_count(claims, asked, events, result.count[0], result.count[1]);
      } else {
        write_none(claims, asked, events);
      }
    });
    return {call_.certificate};
  }

  SetFacts facts(const Result&) const {
    SetFacts facts;
    for (std::uint32_t f = 0; f < input_.files.size(); ++f) {
      const std::string name = io::one_line(input_.names[f]);
      const io::LineFile& file = input_.files[f];
      const auto [polygons, edges] = sizes(f);
      const std::string groups = grouped() ? ", " + count_of(file.groups.size(), "group") : "";
      facts.head += fmt::format("{}: {}, {}, {}{}\n", name, count_of(polygons, "polygon"), count_of(edges, "edge"),
                                file.format, groups);
      facts.first["objects"].push_back({{"file", name},
                                        {"format", file.format},
                                        {"features", file.features.size()},
                                        {"polygons", polygons},
                                        {"edges", edges}});
    }
    if (input_.files.size() > 1) facts.rules = {"those of one file may meet"};
    if (grouped()) facts.rules = {fmt::format("those of one {} may meet", call_.group)};
    const std::string without = input_.left_out_words();
    if (!without.empty()) {
      facts.clause = fmt::format(", among {} only: {}", count_of(input_.polygons.size(), "feature"), without);
    }
    for (const auto& [key, json, told] : facts_of(input_)) {
      facts.tail += told;
      facts.last[key] = json;
    }
    return facts;
  }

  std::string text(const PolygonsContact& c) const {
    return fmt::format("{}: {} and {}: {} at about {}\n", name_of(c.contact), polygon_text(c, true),
                       polygon_text(c, false), shown_by(c), place_text(place_of(input_, c)));
  }
  static sunder::Relation kind_of(const PolygonsContact& c) { return c.contact; }

  ContactRow row(const PolygonsContact& c) const {
    const PolygonSource &i = input_.source[c.i], &j = input_.source[c.j];
    ContactRow row{i.feature, j.feature, name_of(c.contact), place_of(input_, c)};
    const auto add = [&](std::string_view key, const auto& of_i, const auto& of_j) {
      row.properties.push_back({key, {fmt::format("{}", of_i), fmt::format("{}", of_j)}, false});
    };
    if (input_.files.size() > 1) add("files", i.file, j.file);
    row.properties.push_back({"shown_by", {shown_by(c)}});
    row.properties.push_back({"names", {input_.name(c.i), input_.name(c.j)}});
    add("parts", part_of(input_, c, true).compact(), part_of(input_, c, false).compact());
    if (i.line > 0) add("lines", i.line, j.line);
    if (grouped()) row.properties.push_back({"groups", {group_of(input_, c.i), group_of(input_, c.j)}});
    row.fields = fields_of(call_.properties, input_.files[i.file].properties, i.feature,
                           input_.files[j.file].properties, j.feature);
    return row;
  }

  std::string picture(const Result& result, const std::vector<PolygonsContact>& contacts,
                      const std::string& said) const {
    std::vector<Point2> seen;
    for (const Polygon& polygon : input_.polygons) {
      seen.insert(seen.end(), polygon.vertices().begin(), polygon.vertices().end());
    }
    return picture_of_members(
        call_, result, contacts, seen, static_cast<std::uint32_t>(input_.polygons.size()), said,
        [this](std::uint32_t i) { return input_.name(i); },
        [this](PlanePicture& drawing, std::uint32_t i, Ink ink) { draw(drawing, input_.polygons[i], ink); },
        [this](const PolygonsContact& c) {
          return c.contact == sunder::Relation::overlapping ? std::optional(place_of(input_, c)) : std::nullopt;
        });
  }

 private:
  bool grouped() const { return !call_.group.empty(); }

  // Of a file: polygons, edges.
  std::array<std::uint64_t, 2> sizes(std::uint32_t file) const {
    std::array<std::uint64_t, 2> sum{};
    for (std::size_t k = 0; k < input_.polygons.size(); ++k) {
      if (input_.source[k].file != file) continue;
      ++sum[0];
      sum[1] += input_.polygons[k].size();
    }
    return sum;
  }

  // "Chad of farms, part 2 (a.wkt, line 7), owner X"
  std::string polygon_text(const PolygonsContact& c, bool of_i) const {
    const std::uint32_t i = of_i ? c.i : c.j, line = input_.line(i);
    std::string text = input_.name(i);
    if (grouped()) text += fmt::format(" of {}", group_of(input_, i));
    const Json part = part_of(input_, c, of_i);
    if (!input_.source[i].part_of_ring.empty() && !part.is_null()) text += fmt::format(", part {}", part.compact());
    std::vector<std::string> place;
    if (input_.files.size() > 1) place.push_back(io::one_line(input_.names[input_.source[i].file]));
    if (line > 0) place.push_back(fmt::format("line {}", line));
    if (!place.empty()) text += fmt::format(" ({})", fmt::join(place, ", "));
    const PolygonSource& source = input_.source[i];
    return text + words_of(call_.properties, input_.files[source.file].properties, source.feature);
  }

  static void draw(PlanePicture& drawing, const Polygon& polygon, Ink ink) {
    std::vector<std::vector<Point2>> rings;
    for (std::uint32_t r = 0; r < polygon.ring_count(); ++r) {
      rings.emplace_back(polygon.vertices().begin() + polygon.ring_begin(r),
                         polygon.vertices().begin() + polygon.ring_begin(r + 1));
    }
    drawing.polygon(rings, ink);
  }

  const PolygonsCall& call_;
  Talk& talk_;
  PolygonsInput input_;
  SetOptions options_;
};

}  // namespace

Verb polygons_verb() {
  const auto call = std::make_shared<PolygonsCall>();
  Verb verb = set_verb<PolygonsSet>(
      call, {"polygons", "Do any two polygons (with their interiors) in a file meet? Do they touch or overlap?",
             "polygons, possibly with holes and several parts: WKT, GeoJSON. With two files, only polygons of "
             "different files "
             "are compared",
             "polygons", "nothing, shared-endpoint, or touch",
             "features with the same value of FIELD, a property of the GeoJSON, may meet", name_help,
             fmt::format("for --any: {}; for --all and --count: {}", method_names(polygons_any_methods),
                         method_names(finders)),
             0});
  add_file_options(verb, *call);
  verb.options.push_back({"--skip-invalid", &call->skip_invalid, skip_invalid_help});
  verb.options.push_back({"--self-touch", &call->self_touch, "accept rings that touch themselves in points"});
  verb.options.push_back({"--mend", &call->mend, mend_help});
  return verb;
}

}  // namespace sunder::ask
