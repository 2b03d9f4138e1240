// sunder circles FILE: do any two circles, with their insides, meet? Which? How many?
#include <cli/circles_input.h>
#include <cli/progress.h>
#include <cli/set_verb.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/discs_all.h>
#include <sunder/planar/set/discs_any_json.h>

#include <CLI/App.hpp>

namespace sunder::cli {

namespace {

using planar::DiscContact;
using planar::Discs;
using planar::DiscsAnswer;
using planar::DiscsContact;

using AnyMethod = DiscsAnswer(const Discs&, const SetOptions&);
constexpr std::array<Named<AnyMethod>, 4> any_methods{{{"automatic", planar::discs_any},
                                                       {"grid", planar::discs_any_by_grid},
                                                       {"sweep", planar::discs_any_by_sweep},
                                                       {"scan", planar::discs_any_by_scan}}};
constexpr std::array<Named<planar::DiscsMethod>, 4> all_methods{{{"automatic", planar::discs_visit},
                                                                 {"grid", planar::discs_all_by_grid},
                                                                 {"sweep", planar::discs_all_by_sweep},
                                                                 {"scan", planar::discs_all_by_scan}}};

// Discs have no ends to share.
Allowed allowed_for_discs(const std::string& name) {
  if (name == "nothing") return Allowed::nothing;
  if (name == "touch") return Allowed::touch;
  throw Error(ErrorCode::bad_call,
              fmt::format("there is nothing named {} to allow; there are nothing, touch", io::quote(name)), "--allow");
}

std::string about(const Disc& c) {
  return fmt::format("centre ({:.10g}, {:.10g}), radius {:.10g}", c.center.x, c.center.y, c.radius);
}

class CirclesSet {
 public:
  using Call = SetCall;
  using Contact = DiscsContact;
  using Kind = DiscContact;
  using Result = SetResult<CirclesSet>;
  static constexpr std::string_view verb = "circles", noun = "circle", drawn_noun = noun;
  static constexpr std::array kinds{DiscContact::overlapping, DiscContact::inside, DiscContact::touching};

  static void check(const Call& call) {
    allowed_for_discs(call.allow);
    method_by(call.method, any_methods);
  }

  explicit CirclesSet(const Call& call)
      : call_(call),
        input_(read_circles(call.files[0], call.group, call.name, call.proves() ? &origin_.inputs : nullptr)),
        circles_(input_.circles) {
    options_.allowed = allowed_for_discs(call.allow);
    options_.groups = input_.file.group;
  }

  std::uint64_t drawn() const { return circles_.size(); }

  void ask(Result& result) const {
    const auto with_progress = [this](const auto& ask_it) {
      Progress progress("comparing");
      SetOptions options = options_;
      options.progress = progress.reporter();
      return ask_it(options);
    };
    if (!call_.counts()) {
      const DiscsAnswer answer = with_progress(
          [this](const SetOptions& options) { return method_by(call_.method, any_methods)(circles_, options); });
      result.cost = answer.cost;
      return result.found(answer.found);
    }
    result.count_and_list(circles_.size(), call_.lists(), [=, this](const Block& block, const auto& take) {
      return with_progress([&](const SetOptions& options) {
        return discs_visit_block(circles_, options, block, method_by(call_.method, all_methods),
                                 [&](const DiscsContact& contact) {
                                   take(contact);
                                   return true;
                                 });
      });
    });
  }

  std::vector<Proof> proofs(const Result& result) const {
    if (call_.lists()) require_provable(result.pairs());
    return {{call_.certificate, [this, &result](ClaimsWriter& claims) {
               const planar::DiscsQuestion question{circles_, options_.allowed, options_.groups};
               if (call_.lists()) {
                 write_list_statement(claims, question, [&](const std::function<void(const DiscsContact&)>& take) {
                   result.visit([&](const DiscsContact& contact) {
                     take(contact);
                     return true;
                   });
                 });
               } else if (call_.count) {
                 write_count_statement(claims, question, result.pairs());
               } else {
                 DiscsAnswer answer;
                 result.visit([&](const DiscsContact& contact) {
                   answer.found = contact;
                   return false;
                 });
                 write_statement(claims, question, answer);
               }
             }}};
  }
  const Origin& origin() const { return origin_; }

  std::string head() const {
    std::string text = fmt::format("{}: {}", io::one_line(call_.files[0]), count_of(circles_.size(), "circle"));
    if (!call_.group.empty()) text += ", " + count_of(input_.file.groups.size(), "group");
    return text + '\n';
  }
  std::string said_of() const { return ""; }
  std::vector<std::string> rules() const {
    if (call_.group.empty()) return {};
    return {fmt::format("those of one {} may meet", call_.group)};
  }
  std::string clause() const { return ""; }
  std::string text(const DiscsContact& contact) const {
    const Point2 p = place(contact);
    std::string text = fmt::format("{}, with about ({:.10g}, {:.10g}) in common\n", name_of(contact.kind), p.x, p.y);
    const io::TripleFile& file = input_.file;
    for (const std::uint32_t i : {contact.i, contact.j}) {
      const std::string group = call_.group.empty() ? "" : " of " + file.groups[file.group[i]];
      text += fmt::format("    circle {}{}, line {}: {}\n", file.name[i], group, file.line[i], about(circles_[i]));
    }
    return text;
  }
  std::string tail(const Result&) const { return ""; }

  void add_head(Json& json) const {
    json["objects"] = Json::array({{{"file", call_.files[0]}, {"circles", circles_.size()}}});
  }
  void add_tail(Json&) const {}

  static DiscContact kind_of(const DiscsContact& contact) { return contact.kind; }

  ContactRow row(const DiscsContact& c) const {
    const io::TripleFile& file = input_.file;
    ContactRow row{c.i, c.j, name_of(c.kind), place(c)};
    row.properties = {{"names", {file.name[c.i], file.name[c.j]}},
                      {"lines", {std::to_string(file.line[c.i]), std::to_string(file.line[c.j])}, false}};
    if (!call_.group.empty())
      row.properties.push_back({"groups", {file.groups[file.group[c.i]], file.groups[file.group[c.j]]}});
    return row;
  }

  std::string picture(const Result& result, const std::vector<DiscsContact>& contacts) const {
    std::vector<Point2> seen;
    for (const Disc& c : circles_.all()) {
      seen.push_back({c.center.x - c.radius, c.center.y - c.radius});
      seen.push_back({c.center.x + c.radius, c.center.y + c.radius});
    }
    return picture_of_members(
        call_, result, contacts, seen, circles_.size(), "",
        [this](PlanePicture& drawing, std::uint32_t i, Ink ink) { drawing.circle(circles_[i], ink); },
        [](PlanePicture&, const DiscsContact&) {});
  }

 private:
  Point2 place(const DiscsContact& c) const { return planar::common_point_rounded(circles_[c.i], circles_[c.j]); }

  const Call& call_;
  Origin origin_;
  DiscsInput input_;
  const Discs& circles_;
  SetOptions options_;
};

}  // namespace

void add_circles(CLI::App& program, int& code) {
  auto call = std::make_shared<SetCall>();
  CLI::App* verb = add_set_verb(
      program, *call,
      {"circles", "Do any two circles of a file, with their insides, meet? Which, or a proof that none do.",
       "circles: CSV (x,y,r, and a name if you like)", "circles", "nothing, or touch",
       "circles that are the same in this may meet: a column of the CSV",
       "the column that names circles; unless given, name, NAME, id", "automatic, grid, sweep, or scan"});
  verb->callback([call, &code] { code = run_set<CirclesSet>(*call); });
}

}  // namespace sunder::cli
