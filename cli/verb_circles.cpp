// sunder circles FILE: do any two circles, with their insides, meet? Which? How many?
#include <cli/circles_input.h>
#include <cli/common.h>
#include <cli/list_stream.h>
#include <cli/plane_picture.h>
#include <cli/progress.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/discs_all.h>
#include <sunder/planar/set/discs_any_json.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace sunder::cli {

namespace {

using planar::DiscContact;
using planar::Discs;
using planar::DiscsAnswer;
using planar::DiscsContact;

struct Call {
  std::string file;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string group, name, certificate, svg, title;
  std::uint64_t svg_limit = most_drawn;  // circles and contacts
  bool json = false;

  bool lists() const { return all || !svg.empty(); }
};

using Contacts = ContactsInOrder<DiscsContact>;

struct Result {
  DiscsAnswer any;                       // with --any
  std::unique_ptr<Contacts> contacts;    // with --any at most one; with --count null
  std::array<std::uint64_t, 4> count{};  // by kind
  Cost cost;

  void add(DiscContact kind) { ++count.at(static_cast<std::size_t>(kind)); }
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

using AnyMethod = DiscsAnswer(const Discs&, const SetOptions&);
AnyMethod* any_method(const std::string& name) {
  if (name == "automatic") return planar::discs_any;
  if (name == "grid") return planar::discs_any_by_grid;
  if (name == "sweep") return planar::discs_any_by_sweep;
  if (name == "scan") return planar::discs_any_by_scan;
  refuse_method(name, "automatic, grid, sweep, scan");
}
planar::DiscsMethod* contact_method(const std::string& name) {
  if (name == "automatic") return planar::discs_visit;
  if (name == "grid") return planar::discs_all_by_grid;
  if (name == "sweep") return planar::discs_all_by_sweep;
  if (name == "scan") return planar::discs_all_by_scan;
  refuse_method(name, "automatic, grid, sweep, scan");
}

// What can be told before the file is read.
void check(const Call& call) {
  if (call.lists() || call.count) {
    contact_method(call.method);
  } else {
    any_method(call.method);
  }
}

SetOptions options_of(const Call& call, const io::TripleFile& file) {
  SetOptions options;
  options.allowed = allowed_for_discs(call.allow);
  options.groups = file.group;
  return options;
}

// With --count, and where a list is wanted. Keeps the circles by reference.
void count_and_list(const Call& call, const SetOptions& options, const Discs& circles, Result& result) {
  const auto ask = [&, options](const Block& block, const Contacts::Take& take) {
    const bool is_first = result.contacts == nullptr;
    Progress progress("comparing");
    SetOptions shown = options;
    shown.progress = progress.reporter();
    const Cost cost =
        discs_visit_block(circles, shown, block, contact_method(call.method), [&](const DiscsContact& contact) {
          if (is_first) result.add(contact.kind);
          if (take) take(contact);
          return true;
        });
    if (is_first) result.cost = cost;
  };
  if (call.lists()) {
    result.contacts = std::make_unique<Contacts>(circles.size(), most_held(circles.size()), ask);
  } else {
    ask({0, circles.size()}, nullptr);
  }
}

void find_any(const Call& call, SetOptions options, const Discs& circles, Result& result) {
  Progress progress("comparing");
  options.progress = progress.reporter();
  const DiscsAnswer& answer = result.any = any_method(call.method)(circles, options);
  result.cost = answer.cost;
  std::vector<DiscsContact> found;
  if (answer.meet()) {
    found.push_back(*answer.found);
    result.add(answer.found->kind);
  }
  result.contacts = std::make_unique<Contacts>(std::move(found));
}

void write_certificate(const Call& call, const SetOptions& options, const Discs& circles, const Result& result,
                       const Origin& origin) {
  if (call.lists()) require_provable(result.pairs());
  io::OutputFile file(call.certificate);
  ClaimsWriter claims([&](std::string_view text) { file.write(text); });
  claims.add_origin(origin);
  const planar::DiscsQuestion question{circles, options.allowed, options.groups};
  if (call.lists()) {
    write_list_statement(claims, question, [&](const std::function<void(const DiscsContact&)>& take) {
      result.contacts->visit([&](const DiscsContact& contact) {
        take(contact);
        return true;
      });
    });
  } else if (call.count) {
    write_count_statement(claims, question, result.pairs());
  } else {
    write_statement(claims, question, result.any);
  }
  claims.end();
  file.commit();
}

std::string about(const Disc& c) {
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

// listed: the first of the contacts.
std::string human_text(const Call& call, const io::TripleFile& file, const Discs& circles, const Result& result,
                       const std::vector<DiscsContact>& listed) {
  std::string text = fmt::format("{}: {}\n", io::one_line(call.file), count_of(circles.size(), "circle"));
  if (!call.group.empty()) {
    text += fmt::format("{}; those of one {} may meet\n", count_of(file.groups.size(), "group"), call.group);
  }
  const bool some = result.pairs() > 0;
  text += fmt::format("{} meet{}", some ? "some" : "none", call.allow == "touch" ? " (touch allowed)" : "");
  if (some && (call.lists() || call.count)) {
    text += fmt::format(": {}: {}", count_of(result.pairs(), "pair"), counts_text(result));
  }
  text += '\n';
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const DiscsContact& contact = listed[k];
    const Point2 p = planar::common_point_rounded(circles[contact.i], circles[contact.j]);
    text += fmt::format("{} {}, with about ({:.10g}, {:.10g}) in common\n",
                        call.lists() ? fmt::format("  {}.", k + 1) : " ", name_of(contact.kind), p.x, p.y);
    for (const std::uint32_t i : {contact.i, contact.j}) {
      const std::string group = call.group.empty() ? "" : " of " + file.groups[file.group[i]];
      text += fmt::format("    circle {}{}, line {}: {}\n", file.name[i], group, file.line[i], about(circles[i]));
    }
  }
  if (call.lists() && result.pairs() > listed.size()) {
    text += fmt::format("  and {} more; --json or --svg have all\n", result.pairs() - listed.size());
  }
  text += fmt::format("  cost        {}\n", count_of(result.cost.probes, "comparison"));
  if (!call.certificate.empty()) text += fmt::format("  proof       {}\n", io::one_line(call.certificate));
  if (!call.svg.empty()) text += fmt::format("  picture     {}\n", io::one_line(call.svg));
  return text;
}

// All but the contacts.
Json report(const Call& call, const Discs& circles, const Result& result) {
  Json json = envelope("circles", result.pairs() > 0 ? "some" : "none", call.method);
  json["cost"] = to_json(result.cost);
  json["objects"] = Json::array({{{"file", call.file}, {"circles", circles.size()}}});
  json["allowed"] = call.allow;
  if (!call.group.empty()) json["group"] = call.group;
  if (call.lists() || call.count) {
    json["count"] = result.pairs();
    for (const DiscContact kind : kinds) json["counts"][std::string(name_of(kind))] = result.of(kind);
  }
  return json;
}

std::string contact_json(const Call& call, const io::TripleFile& file, const Discs& circles, const DiscsContact& c) {
  const Point2 p = planar::common_point_rounded(circles[c.i], circles[c.j]);
  std::string text =
      fmt::format(R"({{"i": {}, "j": {}, "kind": "{}", "point": {}, "names": {}, "lines": [{}, {}])", c.i, c.j,
                  name_of(c.kind), pair_json(number_json(p.x), number_json(p.y)),
                  pair_json(quoted_json(file.name[c.i]), quoted_json(file.name[c.j])), file.line[c.i], file.line[c.j]);
  if (!call.group.empty()) {
    text += R"(, "groups": )" + pair_json(quoted_json(file.groups[file.group[c.i]]),  //
                                          quoted_json(file.groups[file.group[c.j]]));
  }
  return text + "}";
}

Ink ink_of(DiscContact kind) {
  return kind == DiscContact::overlapping ? Ink::accent : kind == DiscContact::inside ? Ink::second : Ink::third;
}

// A circle has the colour of the strongest contact that it is in.
std::string picture(const Call& call, const Discs& circles, const Result& result,
                    const std::vector<DiscsContact>& drawn) {
  std::vector<Point2> seen;
  for (const Disc& c : circles.all()) {
    seen.push_back({c.center.x - c.radius, c.center.y - c.radius});
    seen.push_back({c.center.x + c.radius, c.center.y + c.radius});
  }
  PlanePicture drawing(seen);
  std::vector<DiscContact> strongest(circles.size(), DiscContact::none);
  for (auto kind = kinds.rbegin(); kind != kinds.rend(); ++kind) {
    for (const DiscsContact& c : drawn) {
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

// Goes through the contacts once, and writes all that was asked for.
void write(const Call& call, const io::TripleFile& file, const Discs& circles, const Result& result) {
  std::optional<ListReport> json;
  if (call.json) json.emplace(report(call, circles, result), "contacts");
  std::vector<DiscsContact> listed, drawn;
  const auto take = [&](const DiscsContact& contact) {
    if (json) json->add(contact_json(call, file, circles, contact));
    if (!call.svg.empty()) drawn.push_back(contact);
    if (listed.size() < most_listed) listed.push_back(contact);
    return json || !call.svg.empty() || listed.size() < most_listed;
  };
  if (result.contacts) result.contacts->visit(take);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, circles, result, drawn));
  if (json) {
    json->close();
  } else {
    print_for_people(human_text(call, file, circles, result, listed));
  }
}

int run(const Call& call) {
  check(call);
  allowed_for_discs(call.allow);
  Origin origin;
  const DiscsInput input =
      read_circles(call.file, call.group, call.name, call.certificate.empty() ? nullptr : &origin.inputs);
  const SetOptions options = options_of(call, input.file);
  const auto require_drawable = [&](std::uint64_t contacts) {
    if (!call.svg.empty()) cli::require_drawable(input.circles.size(), "circle", contacts, call.svg_limit);
  };
  require_drawable(0);
  Result result;
  if (call.lists() || call.count) {
    count_and_list(call, options, input.circles, result);
  } else {
    find_any(call, options, input.circles, result);
  }
  require_drawable(result.pairs());
  if (!call.certificate.empty()) write_certificate(call, options, input.circles, result, origin);
  write(call, input.file, input.circles, result);
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
  verb->add_option("--name", call->name, "the column that names circles; unless given, name, NAME, id")
      ->type_name("FIELD");
  verb->add_option("--method", call->method, "automatic, grid, sweep, or scan")->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the circles and the pairs that meet here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  add_svg_limit(*verb, call->svg_limit);
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
