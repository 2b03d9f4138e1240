#include <sunder/ask/evidence.h>
#include <sunder/ask/scene/row_lines.h>
#include <sunder/ask/scene/scene_clearance.h>
#include <sunder/ask/scene/scene_report.h>

#include <sunder/base/json_line.h>
#include <sunder/certificate/rounded_evidence.h>

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

namespace sunder::ask {

namespace {

using scene::CloserParts;
using scene::PartDistance;
using scene::PartPair;
using scene::SweptPair;

bool is_apart(const SweptPair& pair) { return pair.verdict() == Verdict::apart; }

std::string time_text(const SweptPair& pair) {
  const Interval time = pair.time();
  if (!pair.all_the_way()) return fmt::format("at the {}", time.low == 0 ? "beginning" : "end");
  return fmt::format("from {}{:.6g} of the way on", time.low == time.high ? "" : "about ", time.high);
}

std::string short_distance_text(const PartDistance& pair) {
  return pair.meet() ? "they meet" : about_length(pair.distance) + " apart";
}

std::string quoted_csv(std::string_view list) {
  if (list.empty()) return "";
  std::string text = "\"";
  for (const char c : list) text.append(c == '"' ? 2 : 1, c);
  return text + '"';
}

std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

template <class... Arguments>
void add_to(std::string& text, fmt::format_string<Arguments...> form, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), form, std::forward<Arguments>(arguments)...);
}

}  // namespace

// The names of a pair of parts ("A and B"), and whether a hull replaces one of them (" as hulls").
struct RowLines::Names {
  const PartName &a, &b;

  std::string both() const { return a.name + " and " + b.name; }
  bool are_hulls() const { return a.is_hull || b.is_hull; }
  std::string_view said_of() const { return are_hulls() ? "hulls" : "bodies"; }
  const char* hulls(const char* words = " as hulls") const { return are_hulls() ? words : ""; }
};

template <class Pair>
RowLines::Names RowLines::of(const Pair& pair) const {
  return {names_[pair.body_a][pair.part_a], names_[pair.body_b][pair.part_b]};
}

RowLines::RowLines(const robot::Cell& cell, std::span<const scene::Body> bodies, const scene::Question& question,
                   scene::NearnessQuestion near, LineKinds wanted)
    : question_(question), near_(std::move(near)), wanted_(wanted) {
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    names_.emplace_back();
    for (std::uint32_t p = 0; p < bodies[b].parts.size(); ++p) {
      names_.back().push_back({part_name(bodies[b], p), json_string(bodies[b].name), cell.is_hull(b, p)});
    }
  }
}

LineTexts RowLines::header(Json head, std::string_view row_name) const {
  LineTexts lines;
  add_to(lines.csv, "{},answer,meeting,pairs", row_name);
  if (near_.clearance) {
    Json margins = Json::array();
    const auto name = [&](std::uint32_t body) { return Json::written(names_[body].front().body_json); };
    for (const auto& [a, b, least] : near_.clearance->margins) {
      margins.push_back({{"a", name(a)}, {"b", name(b)}, {"least", least}});
    }
    head["clearance"] = {{"least", near_.clearance->least}, {"margins", std::move(margins)}};
    lines.csv += ",closer,closer_pairs";
  }
  if (near_.nearest) lines.csv += ",nearest_low,nearest_high,nearest_pair";
  lines.csv += '\n';
  lines.json = head.on_one_line() + "\n";
  return lines;
}

void RowLines::add(std::size_t row, const scene::Moment& moment, LineTexts& lines) const {
  const scene::Answer& answer = moment.meeting;
  if (wanted_.text) {
    add_to(lines.text, "{}: ", row);
    add_text(answer, lines.text);
    add_text(moment.near, moment.bodies, lines.text);
    lines.text += '\n';
  }
  if (wanted_.json) {
    JsonLine json(lines.json);
    json.open('{').member("placement", row).member("answer", answer.verdict());
    const auto add_list = [&](std::string_view key, const auto& list, const auto& add_entry) {
      json.key(key).open('[');
      for (const auto& pair : list) add_entry(pair);
      json.close(']');
    };
    if (!answer.pairs.empty()) {
      add_list("pairs", answer.pairs, [&](const PartPair& pair) { add_json(pair, moment.bodies, json); });
    }
    const auto add_distance = [&](const CloserParts& pair) { add_json(pair, pair.least, moment.bodies, json); };
    if (const auto& near = moment.near.clearance) {
      add_list("closer", near->closer, add_distance);
      if (!near->undecided.empty()) add_list("closer_undecided", near->undecided, add_distance);
    }
    if (moment.near.nearest) {
      json.key("nearest");
      add_json(*moment.near.nearest, {}, moment.bodies, json);
    }
    json.close('}');
    lines.json += '\n';
  }
  if (wanted_.csv) {
    std::string list;
    for (const PartPair& pair : answer.pairs) {
      const Names names = of(pair);
      std::string said = pair.undecided() ? "undecided" : question_.contacts ? std::string(contact_name(pair)) : "";
      if (!pair.meshes) said += names.hulls(said.empty() ? "as hulls" : ", as hulls");
      add_to(list, "{}{}", list.empty() ? "" : "; ", names.both());
      if (!said.empty()) add_to(list, " ({})", said);
    }
    add_to(lines.csv, "{},{},{},{}", row, answer.verdict(), answer.counts.meeting - answer.counts.touching_only,
           quoted_csv(list));
    add_csv(moment.near, moment.bodies, lines.csv);
    lines.csv += '\n';
  }
}

void RowLines::add(std::size_t step, const scene::SweptAnswer& answer, LineTexts& lines) const {
  const auto each = [&](const auto& add_pair) {
    for (const SweptPair& pair : answer.pairs) {
      if (!is_apart(pair)) add_pair(pair);
    }
  };
  if (wanted_.text) {
    std::string list;
    each([&](const SweptPair& pair) {
      const Names names = of(pair);
      add_to(list, "{}{} {}{}", list.empty() ? "" : "; ", names.both(), pair.meet() ? "meet" : "undecided",
             pair.is_of_meshes() ? "" : names.hulls());
      if (pair.meet()) list += " " + time_text(pair);
    });
    if (list.empty()) list = answer.none_meet() ? "none meet" : "none is known to meet";
    add_to(lines.text, "{} to {}: {}\n", step, step + 1, list);
  }
  if (wanted_.json) {
    JsonLine json(lines.json);
    json.open('{').member("step", step).member("answer", answer.verdict());
    json.member("at_ends_only", answer.counts.at_ends_only);
    bool is_first = true;
    each([&](const SweptPair& pair) {
      if (std::exchange(is_first, false)) json.key("pairs").open('[');
      add_json(pair, json);
    });
    if (!is_first) json.close(']');
    json.close('}');
    lines.json += '\n';
  }
  if (wanted_.csv) {
    std::string list;
    each([&](const SweptPair& pair) {
      const Names names = of(pair);
      add_to(list, "{}{} ({}{})", list.empty() ? "" : "; ", names.both(), pair.meet() ? time_text(pair) : "undecided",
             pair.is_of_meshes() ? "" : names.hulls(", as hulls"));
    });
    add_to(lines.csv, "{},{},{},{}\n", step, answer.verdict(), answer.counts.meeting, quoted_csv(list));
  }
}

// "hand and link1 meet; hand and link2 meet as hulls, touching"
void RowLines::add_text(const scene::Answer& answer, std::string& text) const {
  if (answer.pairs.empty()) text += "none meet";
  const char* between = "";
  for (const PartPair& pair : answer.pairs) {
    const Names names = of(pair);
    add_to(text, "{}{} {}{}", std::exchange(between, "; "), names.both(), pair.undecided() ? "undecided" : "meet",
           pair.meshes ? "" : names.hulls());
    if (question_.contacts && pair.meet()) add_to(text, ", {}{}", contact_name(pair), pair.counts ? "" : " (allowed)");
  }
}

// "; none are closer", "; hand and post are closer than 0.1: about 0.07 apart; nearest: hand and post: about 0.07
// apart"
void RowLines::add_text(const scene::Nearness& near, std::span<const scene::Body> bodies, std::string& text) const {
  if (near.clearance) {
    const auto& [closer, undecided] = std::tie(near.clearance->closer, near.clearance->undecided);
    if (closer.empty()) text += undecided.empty() ? "; none are closer" : "; none are known to be closer";
    const auto add_pair = [&](const CloserParts& pair, const char* what) {
      add_to(text, "; {}{} are closer than {}{}: {}", what, of(pair).both(), pair.least,
             is_of_meshes(pair, bodies) ? "" : of(pair).hulls(), short_distance_text(pair));
    };
    for (const CloserParts& pair : closer) add_pair(pair, "");
    for (const CloserParts& pair : undecided) add_pair(pair, "undecided whether ");
  }
  if (near.nearest) {
    add_to(text, "; nearest: {}{}: {}", of(*near.nearest).both(),
           is_of_meshes(*near.nearest, bodies) ? "" : of(*near.nearest).hulls(), short_distance_text(*near.nearest));
  } else if (near_.nearest) {
    text += "; nearest: no pair is asked about";
  }
}

// {"a": "hand", "b": "post", "part_a": 0, "part_b": 2
template <class Pair>
void RowLines::open_pair(const Pair& pair, JsonLine& json) const {
  json.open('{').key("a").written(of(pair).a.body_json).key("b").written(of(pair).b.body_json);
  json.member("part_a", pair.part_a).member("part_b", pair.part_b);
}

void RowLines::add_json(const PartPair& pair, std::span<const scene::Body> bodies, JsonLine& json) const {
  open_pair(pair, json);
  json.member("answer", name_of(pair.verdict()));
  if (question_.contacts && pair.meet()) {
    has_unknown_contact(pair) ? json.member("contact_unknown", true) : json.member("contact", name_of(pair.relation));
  }
  json.member("said_of", pair.meshes ? "meshes" : of(pair).said_of()).member("counted", pair.counts).key("evidence");
  const auto* common = std::get_if<CommonVertices>(&pair.answer.evidence);
  if (common == nullptr || pair.meshes) {
    const scene::Part &a = bodies[pair.body_a].parts[pair.part_a], &b = bodies[pair.body_b].parts[pair.part_b];
    json.written(pair_evidence_json(pair, a, b).on_one_line()).close('}');
    return;
  }
  const std::span<const std::uint32_t> vertices(common->vertices);
  json.open('{').member("vertices_a", vertices.first(common->count_a));
  json.member("vertices_b", vertices.subspan(common->count_a, common->count_b)).close('}').close('}');
}

void RowLines::add_json(const PartDistance& pair, std::optional<double> margin, std::span<const scene::Body> bodies,
                        JsonLine& json) const {
  open_pair(pair, json);
  json.member("said_of", is_of_meshes(pair, bodies) ? "meshes" : of(pair).said_of());
  json.member("low", pair.distance.low).member("high", pair.distance.high);
  if (margin) json.member("least", *margin);
  if (const auto points = rounded_nearest(pair.evidence)) {
    json.member("points_about", std::array{coordinates((*points)[0]), coordinates((*points)[1])});
  }
  json.close('}');
}

void RowLines::add_json(const SweptPair& pair, JsonLine& json) const {
  open_pair(pair, json);
  json.member("answer", pair.meet() ? "meet" : "undecided")
      .member("said_of", pair.is_of_meshes() ? "meshes" : of(pair).said_of());
  json.member("all_the_way", pair.all_the_way());
  if (pair.meet()) {
    const Interval time = pair.time();
    json.key("time").open('{').member("low", time.low).member("high", time.high).close('}');
  }
  const auto add_point = [&](const Point3& p) {
    json.key("evidence").open('{').member("point", std::array{p.x + 0.0, p.y + 0.0, p.z + 0.0}).close('}');
  };
  if (const auto* meet = std::get_if<scene::MeetOnTheWay>(&pair.evidence)) {
    add_point(nearest(meet->first->contact.point.at));
  } else if (const auto* meshes = std::get_if<scene::MeshesMeetOnTheWay>(&pair.evidence)) {
    add_point(meshes->point);
  }
  json.close('}');
}

void RowLines::add_csv(const scene::Nearness& near, std::span<const scene::Body> bodies, std::string& csv) const {
  if (near.clearance) {
    std::string list;
    const auto add_pair = [&](const CloserParts& pair, const char* what) {
      add_to(list, "{}{} ({}{} of {}{})", list.empty() ? "" : "; ", of(pair).both(), what, pair.distance.high,
             pair.least, is_of_meshes(pair, bodies) ? "" : of(pair).hulls(", as hulls"));
    };
    for (const CloserParts& pair : near.clearance->closer) add_pair(pair, "");
    for (const CloserParts& pair : near.clearance->undecided) add_pair(pair, "undecided, ");
    add_to(csv, ",{},{}", near.clearance->closer.size(), quoted_csv(list));
  }
  if (near.nearest) {
    add_to(csv, ",{},{},{}", near.nearest->distance.low, near.nearest->distance.high,
           quoted_csv(of(*near.nearest).both() +
                      (is_of_meshes(*near.nearest, bodies) ? "" : of(*near.nearest).hulls(" (as hulls)"))));
  } else if (near_.nearest) {
    csv += ",,,";
  }
}

}  // namespace sunder::ask
