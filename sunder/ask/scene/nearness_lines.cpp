#include <sunder/ask/list_stream.h>
#include <sunder/ask/report.h>
#include <sunder/ask/scene/nearness_lines.h>
#include <sunder/ask/scene/placements.h>

#include <sunder/base/contract.h>

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

using scene::PartDistance;

std::string short_distance_text(const PartDistance& pair) {
  return pair.meet() ? "they meet" : about_length(pair.distance) + " apart";
}

// Puts it before what ends the line.
void insert(std::string_view ending, std::string_view piece, std::string& text) {
  SUNDER_REQUIRE(text.ends_with(ending));
  text.resize(text.size() - ending.size());
  (text += piece) += ending;
}

}  // namespace

bool NearnessLines::is_hull(const PartDistance& pair) const {
  return cell_.is_hull(pair.body_a, pair.part_a) || cell_.is_hull(pair.body_b, pair.part_b);
}

std::string NearnessLines::names_of(const PartDistance& pair) const {
  return part_name(bodies_[pair.body_a], pair.part_a) + " and " + part_name(bodies_[pair.body_b], pair.part_b);
}

// "; none are closer", "; hand and post are closer than 0.1: about 0.07 apart; nearest: hand and post: about 0.07
// apart"
void NearnessLines::add_text(const scene::Nearness& found, std::string& text) const {
  std::string piece;
  const auto hulls = [&](const PartDistance& pair) { return is_hull(pair) ? " as hulls" : ""; };
  if (found.clearance) {
    const auto& [closer, undecided] = std::pair(&found.clearance->closer, &found.clearance->undecided);
    if (closer->empty()) piece += undecided->empty() ? "; none are closer" : "; none are known to be closer";
    for (const PartDistance& pair : *closer) {
      fmt::format_to(std::back_inserter(piece), "; {} are closer than {}{}: {}", names_of(pair), pair.least,
                     hulls(pair), short_distance_text(pair));
    }
    for (const PartDistance& pair : *undecided) {
      fmt::format_to(std::back_inserter(piece), "; undecided whether {} are closer than {}{}: {}", names_of(pair),
                     pair.least, hulls(pair), short_distance_text(pair));
    }
  }
  if (question_.nearest) {
    piece += found.nearest ? fmt::format("; nearest: {}{}: {}", names_of(*found.nearest), hulls(*found.nearest),
                                         short_distance_text(*found.nearest))
                           : "; nearest: no pair is asked about";
  }
  insert("\n", piece, text);
}

std::string NearnessLines::json_of(const PartDistance& pair, bool has_margin) const {
  Json json{{"a", bodies_[pair.body_a].name},
            {"b", bodies_[pair.body_b].name},
            {"part_a", pair.part_a},
            {"part_b", pair.part_b},
            {"said_of", is_hull(pair) ? "hulls" : "bodies"},
            {"low", pair.distance.low},
            {"high", pair.distance.high}};
  if (has_margin) json["least"] = pair.least;
  if (const auto points = rounded_nearest_points(pair)) {
    json["points_about"] = Json::array({to_json(points->of_a), to_json(points->of_b)});
  }
  return json.on_one_line();
}

void NearnessLines::add_json(const scene::Nearness& found, std::string& text) const {
  std::string piece;
  const auto add_list = [&](const char* key, const std::vector<PartDistance>& list) {
    fmt::format_to(std::back_inserter(piece), ", \"{}\": [", key);
    const char* between = "";
    for (const PartDistance& pair : list) {
      (piece += between) += json_of(pair, true);
      between = ", ";
    }
    piece += ']';
  };
  if (found.clearance) {
    add_list("closer", found.clearance->closer);
    if (!found.clearance->undecided.empty()) add_list("closer_undecided", found.clearance->undecided);
  }
  if (found.nearest) piece += ", \"nearest\": " + json_of(*found.nearest, false);
  insert("}\n", piece, text);
}

void NearnessLines::add_json_header(std::string& text) const {
  if (!question_.clearance) return;
  Json margins = Json::array();
  for (const auto& [a, b, least] : question_.clearance->margins) {
    margins.push_back({{"a", bodies_[a].name}, {"b", bodies_[b].name}, {"least", least}});
  }
  insert("}\n", ", \"clearance\": " + Json{{"least", question_.clearance->least}, {"margins", margins}}.on_one_line(),
         text);
}

void NearnessLines::add_csv_header(std::string& text) const {
  if (question_.clearance) insert("\n", ",closer,closer_pairs", text);
  if (question_.nearest) insert("\n", ",nearest_low,nearest_high,nearest_pair", text);
}

void NearnessLines::add_csv(const scene::Nearness& found, std::string& text) const {
  std::string piece;
  if (found.clearance) {
    std::string list;
    const auto add = [&](const PartDistance& pair, const char* what) {
      fmt::format_to(std::back_inserter(list), "{}{} ({}{} of {}{})", list.empty() ? "" : "; ", names_of(pair), what,
                     pair.distance.high, pair.least, is_hull(pair) ? ", as hulls" : "");
    };
    for (const PartDistance& pair : found.clearance->closer) add(pair, "");
    for (const PartDistance& pair : found.clearance->undecided) add(pair, "undecided, ");
    fmt::format_to(std::back_inserter(piece), ",{},{}", found.clearance->closer.size(), quoted_csv(list));
  }
  if (question_.nearest && found.nearest) {
    fmt::format_to(std::back_inserter(piece), ",{},{},{}", found.nearest->distance.low, found.nearest->distance.high,
                   quoted_csv(names_of(*found.nearest) + (is_hull(*found.nearest) ? " (as hulls)" : "")));
  } else if (question_.nearest) {
    piece += ",,,";
  }
  insert("\n", piece, text);
}

std::size_t list_closer(const scene::Nearness& found, std::vector<scene::CloserPair>& list) {
  if (!found.clearance) return 0;
  const auto add = [&](const PartDistance& pair, bool is_undecided) {
    list.push_back({pair.body_a, pair.body_b, pair.part_a, pair.part_b, pair.least, is_undecided});
  };
  for (const PartDistance& pair : found.clearance->closer) add(pair, false);
  for (const PartDistance& pair : found.clearance->undecided) add(pair, true);
  return found.clearance->closer.size();
}

}  // namespace sunder::ask
