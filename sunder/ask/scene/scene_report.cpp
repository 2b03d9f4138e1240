#include <sunder/ask/evidence.h>
#include <sunder/ask/scene/scene_report.h>

#include <sunder/scene/parts_as_meshes.h>

#include <sunder/certificate/rounded_evidence.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using scene::PartPair;

constexpr std::size_t text_width = 100;
constexpr std::size_t most_in_matrix = 24;  // bodies
constexpr std::size_t most_listed = 20;     // pairs that meet, of one placement

const scene::Part& part_a(const Placed& p, const PartPair& pair) { return p.bodies[pair.body_a].parts[pair.part_a]; }
const scene::Part& part_b(const Placed& p, const PartPair& pair) { return p.bodies[pair.body_b].parts[pair.part_b]; }

// Do the parts meet, and do hulls replace meshes in that?
bool meet_as_hulls(const SceneReport& report, const PartPair& pair) {
  return pair.meet() && !pair.meshes && is_hull(report, pair);
}

std::string_view said_of(const SceneReport& report, const PartPair& pair) {
  return pair.meshes ? "meshes" : meet_as_hulls(report, pair) ? "hulls" : "bodies";
}

// Of a pair that meets, rounded.
Point3 common_point(const Placed& placed, const PartPair& pair) {
  return rounded_common_point(pair, part_a(placed, pair), part_b(placed, pair));
}

// What a cell of the matrix says about two bodies, from the weakest to the strongest.
enum Cell : char {
  by_boxes = '.',
  by_method = 'o',
  touching = 't',
  undecided_cell = '?',
  meeting = 'X',
  allowed_cell = '-'
};

std::vector<std::vector<char>> cells_of(const SceneReport& report, const Placed& placed) {
  std::vector<std::vector<char>> cells;
  for (std::size_t b = 0; b < placed.bodies.size(); ++b) cells.emplace_back(b, by_boxes);
  for (auto [a, b] : report.question.allowed) {
    if (a != b) cells[std::max(a, b)][std::min(a, b)] = allowed_cell;
  }
  for (const PartPair& pair : placed.answer.pairs) {
    char& cell = cells[pair.body_b][pair.body_a];
    if (pair.counts)
      cell = meeting;
    else if (pair.undecided() && cell != meeting)
      cell = undecided_cell;
    else if (pair.meet() && cell != meeting && cell != undecided_cell)
      cell = touching;
    else if (!pair.by_boxes && cell == by_boxes)
      cell = by_method;
  }
  return cells;
}

std::string painted(const std::string& text, bool colour, const char* code) {
  return colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
}

std::string painted_cell(char cell, bool colour) {
  const std::string text(1, cell);
  if (cell == meeting || cell == undecided_cell) return painted(text, colour, "1;31");
  return cell == by_method ? text : painted(text, colour, "2");
}

// Triangular tables of who meets whom, side by side as far as they fit.
std::string matrix_text(const SceneReport& report) {
  const std::vector<scene::Body>& bodies = report.placements.front().bodies;
  std::size_t name_width = 0;
  for (const scene::Body& body : bodies) name_width = std::max(name_width, body.name.size());
  std::size_t cell_width = bodies.size() > 10 ? 3 : 2;
  std::size_t block = cell_width * bodies.size() + 4;
  for (const Placed& placed : report.placements) block = std::max(block, placed.title.size() + 4);
  const std::size_t margin = name_width + 7;
  const std::size_t at_once = std::max<std::size_t>(1, (text_width - std::min(margin, text_width)) / block);

  std::string text;
  for (std::size_t first = 0; first < report.placements.size(); first += at_once) {
    const std::size_t last = std::min(first + at_once, report.placements.size());
    std::vector<std::vector<std::vector<char>>> cells;
    std::string titles(margin, ' '), numbers(margin, ' ');
    for (std::size_t p = first; p < last; ++p) {
      const Placed& placed = report.placements[p];
      cells.push_back(cells_of(report, placed));
      titles += fmt::format("{:<{}}", placed.title, block);
      std::string row;
      for (std::size_t b = 0; b < bodies.size(); ++b) row += fmt::format("{:>{}}", b, cell_width);
      numbers += fmt::format("{:<{}}", row, block);
    }
    const auto without_blanks_at_end = [](std::string line) {
      line.erase(line.find_last_not_of(' ') + 1);
      return line + "\n";
    };
    if (report.placements.size() > 1) text += without_blanks_at_end(titles);
    text += without_blanks_at_end(numbers);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      std::string line = fmt::format("  {:>2} {:<{}}", b, bodies[b].name, margin - 5);
      for (std::size_t p = 0; p < cells.size(); ++p) {
        for (std::size_t a = 0; a < b; ++a) {
          line += std::string(cell_width - 1, ' ') + painted_cell(cells[p][b][a], report.colour);
        }
        line += std::string(block - cell_width * b, ' ');
      }
      text += without_blanks_at_end(line);
    }
  }
  std::string key = "  X meet   o apart, by a direction   . apart, by boxes";
  if (!report.none_undecided()) key += "   ? undecided";
  if (report.question.touching_allowed) key += "   t touching, allowed";
  if (!report.allowed_because.empty()) {
    std::string because;
    for (const std::string& word : report.allowed_because) because += (because.empty() ? "" : ", ") + word;
    key += "   - allowed: " + because;
  }
  return text + key + "\n";
}

std::string counts_text(const SceneReport& report) {
  std::size_t width = 9;
  for (const Placed& placed : report.placements) width = std::max(width, placed.title.size());
  std::string text = fmt::format("{:<{}}  {:>14} {:>8} {:>9} {:>10} {:>8} {:>10}\n", "placement", width,
                                 "pairs of parts", "allowed", "by boxes", "by method", "meeting", "time");
  for (const Placed& placed : report.placements) {
    const scene::Counts& c = placed.answer.counts;
    text += fmt::format("{:<{}}  {:>14} {:>8} {:>9} {:>10} {:>8} {:>7.2f} ms\n", placed.title, width, c.pairs,
                        c.allowed, c.by_boxes, c.by_method, c.meeting, 1e3 * placed.seconds);
  }
  return text;
}

// Each pair that is undecided: none of them is left unsaid.
std::string undecided_text(const Placed& placed, const std::string& prefix) {
  std::string text;
  std::uint64_t listed = 0;
  for (const PartPair& pair : placed.answer.pairs) {
    if (!pair.undecided() || ++listed > most_listed) continue;
    text += prefix + "undecided: " + names_of(placed, pair) +
            " are so near to touching that it is not known whether they meet\n";
  }
  if (listed > most_listed) {
    text += fmt::format("{}and {} more undecided\n", prefix, count_of(listed - most_listed, "pair"));
  }
  return text;
}

std::string meeting_text(const SceneReport& report, const Placed& placed) {
  const std::string prefix = report.placements.size() > 1 ? placed.title + ": " : "";
  const LeftOutList& left_out = report.cell.left_out();
  std::string text;
  std::uint64_t listed = 0;
  for (const PartPair& pair : placed.answer.pairs) {
    if (!pair.meet()) continue;
    if (++listed > most_listed) continue;
    const std::string contact =
        report.question.contacts ? fmt::format(", {}{}", contact_name(pair), pair.counts ? "" : " (allowed)") : "";
    text += prefix + names_of(placed, pair) + " " +
            painted(meet_as_hulls(report, pair) ? "meet as hulls" : "meet", report.colour && pair.counts, "1;31") +
            contact + ", at about " + about(common_point(placed, pair)) + "\n";
  }
  if (listed > most_listed) text += fmt::format("{}and {} more\n", prefix, count_of(listed - most_listed, "pair"));
  text += undecided_text(placed, prefix);
  if (const std::uint64_t pairs = placed.answer.counts.surfaces_alone; pairs > 0) {
    text += prefix + surfaces_alone_text(pairs, report.surfaces_consented) + "\n";
  }
  const char* const of_those = report.allowed.empty() ? "" : ", among the pairs tested";
  if (listed == 0 && placed.answer.counts.undecided > 0) {
    text += prefix + "no others meet" + of_those + left_out.clause() + "\n";
  } else if (listed == 0) {
    const char* const none = placed.bodies.empty() ? "nothing can meet: no link has a collision shape"
                             : left_out.empty()    ? "none meet"
                                                   : "none of the bodies read meet";
    text += prefix + none + (placed.bodies.empty() ? "" : of_those) + left_out.clause() + "\n";
  } else if (!left_out.empty()) {
    text += fmt::format("{}the answer covers only the bodies that were read{}\n", prefix, left_out.clause());
  }
  return text;
}

// Why pairs of bodies, the lower first, are allowed to meet.
using Reasons = std::map<std::array<std::uint32_t, 2>, std::string>;
Reasons reasons_by_bodies(const SceneReport& report) {
  Reasons reasons;
  for (const auto& [bodies, reason] : report.allowed) {
    reasons[{std::min(bodies[0], bodies[1]), std::max(bodies[0], bodies[1])}] = reason;
  }
  return reasons;
}

// Lists the allowed pairs that meet, or may meet, by reason, in the order of reasons_of().
std::string allowed_meeting_text(const SceneReport& report, const Placed& placed, const std::string& prefix) {
  const Reasons reasons = reasons_by_bodies(report);
  std::vector<const PartPair*> found;
  for (const PartPair& pair : placed.of_allowed->pairs) {
    if (pair.meet() || pair.undecided()) found.push_back(&pair);
  }
  if (found.empty()) return prefix + "none of these meet\n";
  std::string text;
  for (const AllowedFor& of : reasons_of(report.allowed)) {
    std::uint64_t count = 0;
    std::string neighbours;
    for (const PartPair* pair : found) {
      if (reasons.at({pair->body_a, pair->body_b}) != of.reason || ++count > most_listed) continue;
      const char* const verdict = pair->undecided()              ? ", undecided whether they meet"
                                  : meet_as_hulls(report, *pair) ? " meet as hulls"
                                                                 : " meet";
      const std::string names = names_of(placed, *pair);
      if (is_of_neighbours(of.reason)) {
        neighbours += (neighbours.empty() ? "" : "; ") + names + verdict;
      } else {
        text += fmt::format("{}allowed ({}), and {}{}{}\n", prefix, of.reason, names, verdict,
                            pair->undecided() ? "" : ", at about " + about(common_point(placed, *pair)));
      }
    }
    if (!neighbours.empty()) text += fmt::format("{}allowed ({}): {}\n", prefix, of.reason, neighbours);
    if (count > most_listed) text += fmt::format("{}and {} more of {}\n", prefix, count - most_listed, of.reason);
  }
  return text;
}

std::string allowed_pairs_text(const SceneReport& report) {
  return (report.checks_allowed ? "allowed to meet, so not counted: " : "allowed to meet, so not tested: ") +
         allowed_text(report.allowed);
}

std::string allowed_report_text(const SceneReport& report) {
  if (report.allowed.empty()) return "";
  std::string text = allowed_pairs_text(report);
  if (!report.checks_allowed) return text + "; --check-allowed asks about them\n";
  text += "\n";
  for (const Placed& placed : report.placements) {
    text += allowed_meeting_text(report, placed, report.placements.size() > 1 ? placed.title + ": " : "  ");
  }
  return text;
}

void add_contact(const PartPair& pair, Json& json) {
  if (has_unknown_contact(pair)) {
    json["contact_unknown"] = true;
  } else if (!pair.undecided()) {
    json["contact"] = name_of(pair.relation);
  }
}

// A part as it was read.
Json object_json(const io::BodyPart& part) {
  if (part.mesh != nullptr) {
    Json json = to_json(part.body);
    json["shape"] = "mesh";
    json["surface"] = surface_told(*part.mesh).json;
    return json;
  }
  if (!part.round) return to_json(part.body);
  const solid::RoundWords words = words_of(*part.round);
  Json json{{"file", part.body.file}, {"name", part.body.name}, {"format", part.body.format}, {"shape", words.shape}};
  add_numbers(words, json);
  return json;
}

Json pair_json(const SceneReport& report, std::size_t p, const PartPair& pair) {
  const Placed& placed = report.placements[p];
  Json json = begun_json(report, p, pair);
  json["answer"] = name_of(pair.verdict());
  if (report.question.contacts) add_contact(pair, json);
  json["said_of"] = said_of(report, pair);
  json["counted"] = pair.counts;
  json["decided_by"] = pair.by_boxes ? "boxes" : std::string(name_of(pair.decided_by()));
  json["cost"] = to_json(pair.cost());
  json["evidence"] = pair_evidence_json(pair, part_a(placed, pair), part_b(placed, pair));
  return json;
}

// Null where allowed pairs were not asked about.
Json allowed_meeting_json(const SceneReport& report) {
  if (!report.checks_allowed) return nullptr;
  const Reasons reasons = reasons_by_bodies(report);
  Json list = Json::array();
  for (std::size_t p = 0; p < report.placements.size(); ++p) {
    const Placed& placed = report.placements[p];
    for (const PartPair& pair : placed.of_allowed->pairs) {
      if (!pair.meet() && !pair.undecided()) continue;
      Json json = begun_json(report, p, pair);
      json["reason"] = reasons.at({pair.body_a, pair.body_b});
      json["answer"] = name_of(pair.verdict());
      json["said_of"] = said_of(report, pair);
      if (pair.meet()) json["point_about"] = to_json(common_point(placed, pair));
      list.push_back(std::move(json));
    }
  }
  return list;
}

// What is counted, in the order of reports.
constexpr std::array<std::pair<const char*, std::uint64_t scene::Counts::*>, 9> counted{
    {{"parts", &scene::Counts::parts},
     {"pairs", &scene::Counts::pairs},
     {"allowed", &scene::Counts::allowed},
     {"by_boxes", &scene::Counts::by_boxes},
     {"by_method", &scene::Counts::by_method},
     {"undecided", &scene::Counts::undecided},
     {"meeting", &scene::Counts::meeting},
     {"touching_only", &scene::Counts::touching_only},
     {"surfaces_alone", &scene::Counts::surfaces_alone}}};

Json to_json(const scene::Counts& counts) {
  Json json;
  for (const auto& [key, count] : counted) json[key] = counts.*count;
  return json;
}

// The strongest means that any pair needed: "boxes", then as DecidedBy.
std::string decided_by(const SceneReport& report) {
  std::string strongest = "boxes";
  int rank = 0;
  for (const Placed& placed : report.placements) {
    for (const PartPair& pair : placed.answer.pairs) {
      const int r = pair.by_boxes ? 0 : 1 + static_cast<int>(pair.decided_by());
      if (r <= rank) continue;
      rank = r;
      strongest = name_of(pair.decided_by());
    }
  }
  return strongest;
}

}  // namespace

std::string_view SceneReport::verdict() const {
  const auto any = [&](const auto& is) { return std::any_of(placements.begin(), placements.end(), is); };
  if (any([](const Placed& p) { return p.answer.some_meet(); })) return "some";
  return none_undecided() ? "none" : "undecided";
}

bool SceneReport::none_undecided() const {
  return std::all_of(placements.begin(), placements.end(),
                     [](const Placed& p) { return p.answer.counts.undecided == 0; });
}

std::uint64_t SceneReport::surfaces_alone() const {
  std::uint64_t sum = 0;
  for (const Placed& placed : placements) sum += placed.answer.counts.surfaces_alone;
  return sum;
}

bool SceneReport::is_kept() const {
  return std::all_of(placements.begin(), placements.end(), [](const Placed& p) { return p.near.is_kept(); });
}

std::string_view contact_name(const PartPair& pair) {
  if (pair.undecided()) return "undecided";
  if (has_unknown_contact(pair)) return "touching or overlapping";
  switch (pair.relation) {
    case Relation::a_inside_b: return "the first inside the second";
    case Relation::b_inside_a: return "the second inside the first";
    case Relation::a_part_of_b: return "the first a part of the second";
    case Relation::b_part_of_a: return "the second a part of the first";
    default: return name_of(pair.relation);
  }
}

bool has_unknown_contact(const PartPair& pair) { return pair.meet() && pair.relation == Relation::none; }

std::string surfaces_alone_text(std::uint64_t pairs, bool is_consented) {
  return fmt::format(
      "{} apart as surfaces: a mesh of each is open, and what an open piece seems to enclose is not "
      "asked about{}",
      pairs == 1 ? "1 pair is" : fmt::format("{} pairs are", pairs),
      is_consented ? "" : "; --surface consents to that");
}

Json pair_evidence_json(const PartPair& pair, const scene::Part& a, const scene::Part& b) {
  if (pair.meshes) {
    if (const auto* of_two = std::get_if<solid::MeshAnswer>(&pair.meshes->answer)) {
      return evidence_json(of_two->evidence, *mesh_of(a), a.pose, *mesh_of(b), b.pose);
    }
    const auto& answer = std::get<solid::MeshRoundAnswer>(pair.meshes->answer);
    const auto parts = scene::PartsAsMeshes::of(a, b);
    const auto [mesh, pose, round] = parts->beside();
    return evidence_json(answer.evidence, mesh, pose, round, parts->mesh_a() != nullptr);
  }
  return evidence_json(pair.answer.evidence, solid::PlacedRound(a.shape, a.pose), solid::PlacedRound(b.shape, b.pose));
}

std::vector<std::string> not_proved(const SceneReport& report) {
  for (const Placed& placed : report.placements) {
    if (!placed.joints.empty()) return {"the joint values"};
  }
  return {};
}

std::vector<std::string> picture_notes(const SceneReport& report, const Placed& placed) {
  std::string text = report.allowed.empty() ? "" : allowed_pairs_text(report) + "\n";
  if (report.checks_allowed) text += allowed_meeting_text(report, placed, "");
  if (report.question.touching_allowed) text += "what only touches is allowed, and does not count\n";
  if (!report.cell.left_out().empty()) text += "left out: " + report.cell.left_out().text() + "\n";
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

Report report_of(const SceneReport& scene) {
  Report report{.verb = "scene", .answer = std::string(scene.verdict()), .decided_by = decided_by(scene)};
  const bool is_open = scene.surfaces_alone() > 0 && !scene.surfaces_consented;
  report.code = scene.none_meet() && scene.is_kept() && !is_open ? exit_code::no : exit_code::yes;
  for (const io::BodyPart* part : scene.cell.parts()) report.objects.push_back(object_json(*part));
  const std::vector<scene::Body>& bodies = scene.placements.front().bodies;
  const std::size_t placements = scene.placements.size();
  report.tell(fmt::format("{} with {}{}\n", bodies.size() == 1 ? "1 body" : fmt::format("{} bodies", bodies.size()),
                          count_of(scene.placements.front().answer.counts.parts, "part"),
                          placements > 1 ? fmt::format(", {} placements", placements) : ""));
  for (const auto& [name, link] : attached_names(scene.cell)) report.tell(name + " moves with " + link + "\n");
  if (bodies.size() <= most_in_matrix && bodies.size() > 1) report.tell(matrix_text(scene));
  report.tell(counts_text(scene));

  report.add(facts_of(scene.cell.left_out()));
  if (!scene.cell.unit().empty()) report.add("unit", scene.cell.unit());
  if (Json attached = attached_json(scene.cell); !attached.empty()) report.add("attached", std::move(attached));
  Json of_bodies = Json::array(), allowed_pairs = Json::array();
  std::size_t object = 0;
  for (const scene::Body& body : bodies) {
    Json parts = Json::array();
    for (const scene::Part& part : body.parts) parts.push_back({{"name", part.name}, {"object", object++}});
    of_bodies.push_back({{"name", body.name}, {"parts", parts}});
  }
  report.add("bodies", std::move(of_bodies));
  report.add("allowed", scene.question.touching_allowed ? "touch" : "nothing");
  for (const auto& [a, b] : scene.question.allowed) allowed_pairs.push_back({bodies[a].name, bodies[b].name});
  report.add("allowed_pairs", std::move(allowed_pairs));
  report.add("allowed_reasons", allowed_json(scene.allowed));
  report.add("allowed_meeting", allowed_meeting_json(scene));

  Json of_placements = Json::array(), pairs = Json::array();
  Cost cost;
  scene::Counts counts;
  std::uint64_t meeting = 0;
  std::string text;
  for (std::size_t p = 0; p < placements; ++p) {
    const Placed& placed = scene.placements[p];
    Json joints = Json::object();
    for (const auto& [joint, value] : placed.joints) joints[joint] = value;
    of_placements.push_back({{"name", placed.title},
                             {"answer", placed.answer.verdict()},
                             {"joints", joints},
                             {"totals", to_json(placed.answer.counts)},
                             {"seconds", placed.seconds}});
    text += meeting_text(scene, placed);
    for (const auto& [key, count] : counted) counts.*count += placed.answer.counts.*count;
    for (const PartPair& pair : placed.answer.pairs) {
      pairs.push_back(pair_json(scene, p, pair));
      if (pair.counts) ++meeting;
      const Cost of_pair = pair.cost();
      cost.probes += of_pair.probes;
      cost.iterations += of_pair.iterations;
      cost.exact += of_pair.exact;
    }
  }
  report.add("placements", std::move(of_placements), std::move(text));
  report.add("pairs", std::move(pairs), allowed_report_text(scene));
  report.cost = cost;
  report.add("count", meeting);
  report.add("totals", to_json(counts));
  add_nearness(scene, report);
  report.has_colours = scene.colour;
  return report;
}

}  // namespace sunder::ask
