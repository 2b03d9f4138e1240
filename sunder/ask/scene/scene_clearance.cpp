#include <sunder/ask/scene/scene_clearance.h>
#include <sunder/ask/scene/scene_report.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

using scene::PartDistance;

constexpr std::size_t most_listed_closer = 20;  // pairs of one placement

double distance_of(std::string_view text, const char* option, bool may_be_zero) {
  const std::vector<double> numbers = parse_numbers(text, option);
  const bool is_one = numbers.size() == 1 && (numbers[0] > 0 || (may_be_zero && numbers[0] == 0));
  if (is_one) return numbers[0] + 0.0;
  throw Error(ErrorCode::bad_call,
              fmt::format("{} is not one number {}", io::quote(text), may_be_zero ? "of zero or more" : "above zero"),
              option);
}

constexpr const char* margin_option = "--margin";

// "a,b=c"
scene::Margin margin_of(const std::string& text, const robot::Cell& cell) {
  const std::size_t equals = text.rfind('=');
  const std::size_t comma = std::min(equals, text.find(','));
  if (equals == std::string::npos || comma == equals) {
    throw Error(ErrorCode::bad_call,
                io::quote(text) + " is not NAME,NAME=NUMBER: two bodies, and how far apart they have to be",
                margin_option);
  }
  const std::string_view all(text);
  const auto body = [&](std::string_view name) {
    return cell.body_named(std::string(io::trimmed(name)), margin_option);
  };
  const std::uint32_t a = body(all.substr(0, comma)), b = body(all.substr(comma + 1, equals - comma - 1));
  if (a == b) {
    throw Error(ErrorCode::bad_call, io::quote(text) + " names one body twice; parts of one body are not asked about",
                margin_option);
  }
  return {std::min(a, b), std::max(a, b), distance_of(io::trimmed(all.substr(equals + 1)), margin_option, true)};
}

// Is something said of a hull in the place of a mesh?
bool are_hulls(const SceneReport& report, const Placed& placed, const PartDistance& pair) {
  return is_hull(report, pair) && !is_of_meshes(pair, placed.bodies);
}

// "about 0.25 apart, from (0, 0, 1) to (0, 0, 1.25)", or "they meet"
std::string distance_text(const PartDistance& pair) {
  if (pair.meet()) return "they meet";
  const auto points = *rounded_nearest(pair.evidence);
  return fmt::format("{} apart, from {} to {}", about_length(pair.distance), about(points[0]), about(points[1]));
}

std::string closer_text(const SceneReport& report, const Placed& placed, const std::string& prefix) {
  const scene::ClearanceAnswer& answer = *placed.near.clearance;
  std::string text;
  for (std::size_t k = 0; k < answer.closer.size() && k < most_listed_closer; ++k) {
    const scene::CloserParts& pair = answer.closer[k];
    text += fmt::format("{}{} are closer than {}{}: {}\n", prefix, names_of(placed, pair), pair.least,
                        are_hulls(report, placed, pair) ? ", as hulls" : "", distance_text(pair));
  }
  if (answer.closer.size() > most_listed_closer) {
    text += fmt::format("{}and {} more\n", prefix, count_of(answer.closer.size() - most_listed_closer, "pair"));
  }
  for (std::size_t k = 0; k < answer.undecided.size() && k < most_listed_closer; ++k) {
    const scene::CloserParts& pair = answer.undecided[k];
    text += fmt::format("{}undecided: it is not known whether {} are closer than {}: {}\n", prefix,
                        names_of(placed, pair), pair.least, distance_text(pair));
  }
  if (answer.undecided.size() > most_listed_closer) {
    text += fmt::format("{}and {} more undecided\n", prefix,
                        count_of(answer.undecided.size() - most_listed_closer, "pair"));
  }
  const std::size_t count = answer.closer.size(), undecided = answer.undecided.size();
  const std::string known = count == 0 ? undecided == 0 ? "none" : "none that is known" : std::to_string(count);
  return text + fmt::format("{}closer than asked for: {} of {} (allowed {}, by boxes {}, by distance {}{}){}\n", prefix,
                            known, count_of(answer.pairs, "pair"), answer.allowed, answer.by_boxes, answer.by_method,
                            undecided == 0 ? "" : fmt::format(", undecided {}", undecided),
                            report.cell.left_out().clause());
}

std::string nearest_text(const SceneReport& report, const Placed& placed, const std::string& prefix) {
  const LeftOutList& left_out = report.cell.left_out();
  if (!placed.near.nearest) return prefix + "nearest: no pair is asked about" + left_out.clause() + "\n";
  const PartDistance& pair = *placed.near.nearest;
  return fmt::format("{}nearest: {}{}: {}{}\n", prefix, names_of(placed, pair),
                     are_hulls(report, placed, pair) ? ", as hulls" : "", distance_text(pair), left_out.clause());
}

Json pair_json(const SceneReport& report, std::size_t placement, const PartDistance& pair) {
  Json json = begun_json(report, placement, pair);
  const Placed& placed = report.placements[placement];
  json["said_of"] = is_of_meshes(pair, placed.bodies) ? "meshes" : are_hulls(report, placed, pair) ? "hulls" : "bodies";
  json["low"] = pair.distance.low;
  json["high"] = pair.distance.high;
  if (const auto points = rounded_nearest(pair.evidence)) {
    json["points_about"] = Json::array({to_json((*points)[0]), to_json((*points)[1])});
  }
  return json;
}

Json clearance_json(const SceneReport& report) {
  const scene::ClearanceQuestion& question = *report.clearance;
  const std::vector<scene::Body>& bodies = report.placements.front().bodies;
  Json json{{"least", question.least}, {"margins", Json::array()}, {"kept", report.is_kept()}};
  for (const auto& [a, b, least] : question.margins) {
    json["margins"].push_back({{"a", bodies[a].name}, {"b", bodies[b].name}, {"least", least}});
  }
  for (const char* list : {"closer", "undecided"}) json[list] = Json::array();
  scene::ClearanceAnswer all;
  for (std::size_t p = 0; p < report.placements.size(); ++p) {
    const scene::ClearanceAnswer& answer = *report.placements[p].near.clearance;
    for (const auto& [key, list] : {std::pair("closer", &answer.closer), std::pair("undecided", &answer.undecided)}) {
      for (const scene::CloserParts& pair : *list) {
        json[key].push_back(pair_json(report, p, pair));
        json[key].back()["least"] = pair.least;
      }
    }
    all.pairs += answer.pairs;
    all.allowed += answer.allowed;
    all.by_boxes += answer.by_boxes;
    all.by_method += answer.by_method;
  }
  json["totals"] = {{"pairs", all.pairs},
                    {"allowed", all.allowed},
                    {"by_boxes", all.by_boxes},
                    {"by_method", all.by_method},
                    {"undecided", json["undecided"].size()},
                    {"closer", json["closer"].size()}};
  return json;
}

}  // namespace

std::optional<scene::ClearanceQuestion> clearance_question(Talk& talk, const ClearanceCall& call,
                                                           const robot::Cell& cell,
                                                           const std::vector<std::array<std::uint32_t, 2>>& allowed) {
  if (call.least.empty() && call.margins.empty()) return std::nullopt;
  scene::ClearanceQuestion question;
  question.allowed = allowed;
  if (!call.least.empty()) question.least = distance_of(call.least, "--clearance", false);
  std::set<std::pair<std::uint32_t, std::uint32_t>> may_meet, seen;
  for (const auto& [a, b] : allowed) may_meet.insert(std::minmax(a, b));
  for (const std::string& text : call.margins) {
    const scene::Margin margin = margin_of(text, cell);
    const std::pair pair(margin.body_a, margin.body_b);
    if (!seen.insert(pair).second) {
      throw Error(ErrorCode::bad_call, io::quote(text) + " is of a pair that has a margin already; give one",
                  margin_option);
    }
    if (may_meet.contains(pair)) {
      talk.note(fmt::format("{} {}: these may meet, so they are not asked about", margin_option, io::one_line(text)));
    }
    question.margins.push_back(margin);
  }
  return question;
}

void add_nearness(const SceneReport& scene, Report& report) {
  std::string text;
  Json nearest = Json::array();
  for (std::size_t p = 0; p < scene.placements.size(); ++p) {
    const Placed& placed = scene.placements[p];
    const std::string prefix = scene.placements.size() > 1 ? placed.title + ": " : "";
    if (placed.near.clearance) text += closer_text(scene, placed, prefix);
    if (scene.asks_for_nearest) text += nearest_text(scene, placed, prefix);
    if (placed.near.nearest) nearest.push_back(pair_json(scene, p, *placed.near.nearest));
  }
  if (scene.clearance) report.add("clearance", clearance_json(scene));
  if (scene.asks_for_nearest) report.add("nearest", std::move(nearest));
  report.tell(std::move(text));
}

}  // namespace sunder::ask
