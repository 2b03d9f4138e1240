// sunder circles FILE: do any two circles, with their insides, meet? Which? How many?
#include <cli/circles_input.h>
#include <cli/common.h>
#include <cli/plane_picture.h>
#include <cli/progress.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/circles_all.h>
#include <sunder/planar/set/circles_any_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

namespace sunder::cli {

namespace {

using planar::Allowed;
using planar::Circle;
using planar::Circles;
using planar::CirclesAnswer;
using planar::CirclesContact;
using planar::CirclesOptions;
using planar::DiscContact;

struct Call {
  std::string file;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string group, certificate, svg, title;
  bool json = false;

  bool lists() const { return all || !svg.empty(); }
};

struct Result {
  std::vector<CirclesContact> contacts;  // with --any at most one
  std::array<std::uint64_t, 4> count{};  // by kind
  Cost cost;

  void add(const CirclesContact& contact, bool keep) {
    ++count.at(static_cast<std::size_t>(contact.kind));
    if (keep) contacts.push_back(contact);
  }
  std::uint64_t pairs() const { return count[0] + count[1] + count[2] + count[3]; }
  std::uint64_t of(DiscContact kind) const { return count.at(static_cast<std::size_t>(kind)); }
};

constexpr std::array kinds{DiscContact::overlapping, DiscContact::inside, DiscContact::touching};

// Discs have no ends to share.
Allowed allowed_for_discs(const std::string& name) {
  if (name == "nothing") return Allowed::nothing;
  if (name == "touch") return Allowed::touch;
  throw Error(ErrorCode::bad_call,
              fmt::format("there is nothing named {} to allow; there are nothing, touch", io::quote(name)), "--allow");
}

using AnyMethod = CirclesAnswer(const Circles&, const CirclesOptions&);
AnyMethod* any_method(const std::string& name) {
  if (name == "automatic") return planar::circles_any;
  if (name == "grid") return planar::circles_any_by_grid;
  if (name == "sweep") return planar::circles_any_by_sweep;
  if (name == "scan") return planar::circles_any_by_scan;
  refuse_method(name, "automatic, grid, sweep, scan");
}
planar::CirclesContactMethod* contact_method(const std::string& name) {
  if (name == "automatic") return planar::visit_circle_contacts;
  if (name == "grid") return planar::visit_circle_contacts_by_grid;
  if (name == "sweep") return planar::visit_circle_contacts_by_sweep;
  if (name == "scan") return planar::visit_circle_contacts_by_scan;
  refuse_method(name, "automatic, grid, sweep, scan");
}

// What can be told before the file is read.
void check(const Call& call) {
  if (call.lists() || call.count) {
    contact_method(call.method);
  } else {
    any_method(call.method);
  }
  if (call.certificate.empty()) return;
  if (call.lists() || call.count) {
    throw Error(ErrorCode::bad_call, "lists, counts and pictures have no proof; ask whether any two meet",
                "--certificate");
  }
  if (!call.group.empty()) {
    throw Error(ErrorCode::bad_call, "that members of different groups do not meet has no proof yet; leave out one",
                "--group and --certificate");
  }
  if (call.method == "scan") {
    throw Error(ErrorCode::bad_call, "scan writes no certificates; give automatic or sweep", "--method");
  }
}

Result ask(const Call& call, const io::TripleFile& file, const Circles& circles) {
  Progress progress("comparing");
  CirclesOptions options;
  options.allowed = allowed_for_discs(call.allow);
  options.groups = file.group;
  options.transcript = !call.certificate.empty();
  options.progress = progress.reporter();
  Result result;
  if (call.lists() || call.count) {
    result.cost = contact_method(call.method)(circles, options, [&](const CirclesContact& contact) {
      result.add(contact, call.lists());
      return true;
    });
    std::sort(result.contacts.begin(), result.contacts.end());
    return result;
  }
  const CirclesAnswer answer = any_method(call.method)(circles, options);
  result.cost = answer.cost;
  if (answer.meet()) result.add({answer.i, answer.j, answer.kind}, true);
  if (!call.certificate.empty()) {
    io::write_file_atomically(call.certificate, planar::certificate_text(circles, options.allowed, answer));
  }
  return result;
}

std::string about(const Circle& c) {
  return fmt::format("centre ({:.10g}, {:.10g}), radius {:.10g}", c.center.x, c.center.y, c.radius);
}

// "12 overlapping, 3 inside"
std::string counts_text(const Result& result) {
  std::string text;
  for (const DiscContact kind : kinds) {
    if (result.of(kind) == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", result.of(kind), name_of(kind));
  }
  return text;
}

constexpr std::size_t most_listed = 20;

std::string human_text(const Call& call, const io::TripleFile& file, const Circles& circles, const Result& result) {
  std::string text = fmt::format("{}: {}\n", call.file, count_of(circles.size(), "circle"));
  if (!call.group.empty()) {
    text += fmt::format("{}; those of one {} may meet\n", count_of(file.groups.size(), "group"), call.group);
  }
  const bool some = result.pairs() > 0;
  text += fmt::format("{} meet{}", some ? "some" : "none", call.allow == "touch" ? " (touch allowed)" : "");
  if (some && (call.lists() || call.count)) {
    text += fmt::format(": {}: {}", count_of(result.pairs(), "pair"), counts_text(result));
  }
  text += '\n';
  for (std::size_t k = 0; k < std::min(result.contacts.size(), most_listed); ++k) {
    const CirclesContact& contact = result.contacts[k];
    const Point2 p = planar::common_point_rounded(circles[contact.i], circles[contact.j]);
    text += fmt::format("{} {}, with about ({:.10g}, {:.10g}) in common\n",
                        call.lists() ? fmt::format("  {}.", k + 1) : " ", name_of(contact.kind), p.x, p.y);
    for (const std::uint32_t i : {contact.i, contact.j}) {
      const std::string group = call.group.empty() ? "" : " of " + file.groups[file.group[i]];
      text += fmt::format("    circle {}{}, line {}: {}\n", file.name[i], group, file.line[i], about(circles[i]));
    }
  }
  if (result.contacts.size() > most_listed) {
    text += fmt::format("  and {} more; --json or --svg have all\n", result.contacts.size() - most_listed);
  }
  text += fmt::format("  cost        {}\n", count_of(result.cost.probes, "comparison"));
  if (!call.certificate.empty()) text += fmt::format("  proof       {}\n", call.certificate);
  if (!call.svg.empty()) text += fmt::format("  picture     {}\n", call.svg);
  return text;
}

Json report(const Call& call, const io::TripleFile& file, const Circles& circles, const Result& result) {
  Json json = envelope("circles", result.pairs() > 0 ? "some" : "none", call.method);
  json["cost"] = to_json(result.cost);
  json["objects"] = Json::array({{{"file", call.file}, {"circles", circles.size()}}});
  json["allowed"] = call.allow;
  if (!call.group.empty()) json["group"] = call.group;
  if (call.lists() || call.count) {
    json["count"] = result.pairs();
    for (const DiscContact kind : kinds) json["counts"][std::string(name_of(kind))] = result.of(kind);
  }
  json["contacts"] = Json::array();
  for (const CirclesContact& c : result.contacts) {
    const Point2 p = planar::common_point_rounded(circles[c.i], circles[c.j]);
    Json contact = {{"i", c.i},
                    {"j", c.j},
                    {"kind", name_of(c.kind)},
                    {"point", {p.x, p.y}},
                    {"names", {file.name[c.i], file.name[c.j]}},
                    {"lines", {file.line[c.i], file.line[c.j]}}};
    if (!call.group.empty()) contact["groups"] = {file.groups[file.group[c.i]], file.groups[file.group[c.j]]};
    json["contacts"].push_back(contact);
  }
  return json;
}

Ink ink_of(DiscContact kind) {
  return kind == DiscContact::overlapping ? Ink::accent : kind == DiscContact::inside ? Ink::second : Ink::third;
}

// A circle has the colour of the strongest contact that it is in.
std::string picture(const Call& call, const Circles& circles, const Result& result) {
  std::vector<Point2> seen;
  for (const Circle& c : circles.all()) {
    seen.push_back({c.center.x - c.radius, c.center.y - c.radius});
    seen.push_back({c.center.x + c.radius, c.center.y + c.radius});
  }
  PlanePicture drawing(seen);
  std::vector<DiscContact> strongest(circles.size(), DiscContact::none);
  for (auto kind = kinds.rbegin(); kind != kinds.rend(); ++kind) {
    for (const CirclesContact& c : result.contacts) {
      if (c.kind == *kind) strongest[c.i] = strongest[c.j] = *kind;
    }
  }
  for (std::uint32_t i = 0; i < circles.size(); ++i) {
    if (strongest[i] == DiscContact::none) drawing.circle(circles[i], Ink::calm);
  }
  for (auto kind = kinds.rbegin(); kind != kinds.rend(); ++kind) {
    for (std::uint32_t i = 0; i < circles.size(); ++i) {
      if (strongest[i] == *kind) drawing.circle(circles[i], ink_of(*kind));
    }
  }
  for (const DiscContact kind : kinds) {
    drawing.legend(ink_of(kind), fmt::format("{} {}", name_of(kind), result.of(kind)));
  }
  drawing.legend(Ink::calm, "meets no other");
  return drawing.text(call.title.empty() ? "Which of these circles meet?" : call.title,
                      fmt::format("{}; {}", count_of(circles.size(), "circle"),
                                  result.pairs() == 0 ? "none meet" : count_of(result.pairs(), "pair") + " meet"));
}

int run(const Call& call) {
  check(call);
  allowed_for_discs(call.allow);
  const auto [file, circles] = read_circles(call.file, call.group);
  const Result result = ask(call, file, circles);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, circles, result));
  print(call.json ? to_text(report(call, file, circles, result)) : human_text(call, file, circles, result));
  return result.pairs() == 0 ? exit_code::no : exit_code::yes;
}

}  // namespace

void add_circles(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb = program.add_subcommand(
      "circles", "Do any two circles of a file, with their insides, meet? Which, or a proof that none do.");
  verb->add_option("FILE", call->file, "circles: CSV (x,y,r, and a name if you like)")->required();
  auto* any = verb->add_flag("--any", call->any, "does any pair meet? (unless told otherwise)");
  auto* all = verb->add_flag("--all", call->all, "list all pairs that meet");
  auto* count = verb->add_flag("--count", call->count, "count the pairs that meet, by kind");
  any->excludes(all)->excludes(count);
  all->excludes(count);
  verb->add_option("--allow", call->allow, "what does not count: nothing, or touch")->type_name("KIND");
  verb->add_option("--group", call->group, "circles that are the same in this may meet: a column of the CSV")
      ->type_name("FIELD");
  verb->add_option("--method", call->method, "automatic, grid, sweep, or scan")->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the circles and the pairs that meet here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
