// A set of members that are rows of a file, for set_verb.h. What is its own is a class, here Of:
//   Of::Members, Of::verb, Of::noun     the set, for cover_statement.h too; "circles", "circle"
//   Of::all_methods, Of::any_methods    by name; where there are none, set_answers.h
//   Of::about_verb, Of::file_help       in a sentence each
//   read(call, talk, inputs)                 MembersFile<Members>; throws Error
//   about(member), place(a, b)          a member in words; a point of both, rounded
//   draw(picture, member, ink)
// Members are full, and meet as discs do: of their contacts all count, or all but touching ones.
#pragma once

#include <sunder/ask/said_of.h>
#include <sunder/ask/set/set_verb.h>

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/text/property.h>
#include <sunder/io/text/text.h>
#include <sunder/near/cover_statement.h>
#include <sunder/near/set_answers.h>
#include <sunder/near/set_methods.h>
#include <sunder/planar/pair/disc_disc.h>

namespace sunder::ask {

template <class Members>
struct MembersFile {
  Members members;
  std::vector<std::string> names{};
  std::vector<std::uint32_t> lines{};
  std::vector<std::uint32_t> group{};  // empty, or of each member a position in groups
  std::vector<std::string> groups{};
  std::vector<io::PropertyValues> properties{};  // empty, or of each member
};

template <class Of>
class MembersSet {
 public:
  using Call = SetCall;
  using Members = typename Of::Members;
  using Contact = ContactIn<Members>;
  using Kind = planar::DiscContact;
  using Result = SetResult<MembersSet>;
  static constexpr std::string_view verb = Of::verb, noun = Of::noun, drawn_noun = Of::noun;
  static constexpr std::array kinds{Kind::overlapping, Kind::inside, Kind::touching};
  static constexpr std::array may_be_allowed{Allowed::nothing, Allowed::touch};

  static void check(const Call& call) {
    allowed_by(call.allow, may_be_allowed);
    method_by(call.method, methods());
  }

  MembersSet(const Call& call, Talk& talk)
      : call_(call),
        talk_(talk),
        file_(Of::read(call, talk, call.proves() ? &origin_.inputs : nullptr)),
        members_(file_.members) {
    system_ = {io::system_beside(call.files[0], call.proves() ? &origin_.inputs : nullptr), {}};
    systems_.add(call.files[0], std::span(&system_, 1));
    options_.allowed = allowed_by(call.allow, may_be_allowed);
    options_.groups = file_.group;
  }

  const io::CoordinateSystems& systems() const { return systems_; }
  std::uint64_t drawn() const { return members_.size(); }

  void ask(Result& result) const {
    result.function = method_by(call_.method, methods()).function;
    const auto with_progress = [this](const auto& ask_it) {
      SetOptions options = options_;
      options.progress = talk_.progress("comparing");
      return ask_it(options);
    };
    if (!call_.counts()) {
      if constexpr (requires { Of::any_methods; }) result.function = method_by(call_.method, Of::any_methods).function;
      const AnyAnswer<Contact> answer = with_progress([this](const SetOptions& options) { return any(options); });
      result.cost = answer.cost;
      return result.found(answer.found);
    }
    result.count_and_list(size(), call_.lists(), [=, this](const Block& block, const auto& take) {
      return with_progress([&](const SetOptions& options) {
        return visit_of_block(
            members_, [](const Members& all) { return boxes_of(all); }, options, block,
            method_by(call_.method, methods()),
            [&](const Contact& contact) {
              take(contact);
              return true;
            });
      });
    });
  }

  std::vector<std::string> prove(const Result& result) const {
    if (call_.lists()) require_provable(result.pairs());
    Origin origin = origin_;
    const auto source = verb == "circles" ? Said::Source::circles : Said::Source::boxes;
    const Said said = said_in(std::span(&system_, 1), said_of_file(source, origin.inputs, call_.files[0]));
    origin.said = said_of_rows(verb.data(), members_.size(), said);
    write_proof(talk_, call_.certificate, origin, [&](ClaimsWriter& claims) { write_statements(claims, result); });
    return {call_.certificate};
  }

  SetFacts facts(const Result& result) const {
    SetFacts facts;
    if (result.some() && !call_.lists() && call_.count) facts.not_proved = {"how many of each kind"};
    facts.head = fmt::format("{}: {}", io::one_line(call_.files[0]), count_of(size(), noun));
    if (!file_.groups.empty()) {
      facts.head += ", " + count_of(file_.groups.size(), "group");
      facts.rules = {fmt::format("those of one {} may meet", call_.group)};
    }
    facts.head += '\n';
    facts.first["objects"] = Json::array({{{"file", call_.files[0]}, {std::string(verb), size()}}});
    return facts;
  }

  std::string text(const Contact& c) const {
    std::string text = fmt::format("{}, with about {} in common\n", name_of(c.kind),
                                   place_text(Of::place(members_[c.i], members_[c.j])));
    for (const std::uint32_t i : {c.i, c.j}) {
      const std::string group = file_.groups.empty() ? "" : " of " + file_.groups[file_.group[i]];
      text += fmt::format("    {} {}{}, line {}{}: {}\n", noun, file_.names[i], group, file_.lines[i],
                          words_of(call_.properties, file_.properties, i), Of::about(members_[i]));
    }
    return text;
  }
  static Kind kind_of(const Contact& contact) { return contact.kind; }

  ContactRow row(const Contact& c) const {
    ContactRow row{c.i, c.j, name_of(c.kind), Of::place(members_[c.i], members_[c.j])};
    row.properties = {{"names", {file_.names[c.i], file_.names[c.j]}},
                      {"lines", {std::to_string(file_.lines[c.i]), std::to_string(file_.lines[c.j])}, false}};
    if (!file_.groups.empty()) {
      row.properties.push_back({"groups", {file_.groups[file_.group[c.i]], file_.groups[file_.group[c.j]]}});
    }
    row.fields = fields_of(call_.properties, file_.properties, c.i, file_.properties, c.j);
    return row;
  }

  std::string picture(const Result& result, const std::vector<Contact>& contacts, const std::string& said) const {
    std::vector<Point2> seen;
    for (const Box2& box : boxes_of(members_)) seen.insert(seen.end(), {box.low, box.high});
    return picture_of_members(
        call_, result, contacts, seen, size(), said, [this](std::uint32_t i) { return file_.names[i]; },
        [this](PlanePicture& drawing, std::uint32_t i, Ink ink) { Of::draw(drawing, members_[i], ink); },
        [](const Contact&) { return std::optional<Point2>(); });
  }

  static auto methods() {
    if constexpr (requires { Of::all_methods; }) {
      return Of::all_methods;
    } else {
      using Method = Cost(const Members&, const SetOptions&, const ContactVisitor<Members>&);
      return std::array<Named<Method>, 2>{{{"automatic", contacts_visit<Members>, "contacts_visit"},
                                           {"scan", contacts_visit_by_scan<Members>, "contacts_visit_by_scan"}}};
    }
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(members_.size()); }

  AnyAnswer<Contact> any(const SetOptions& options) const {
    if constexpr (requires { Of::any_methods; }) {
      return method_by(call_.method, Of::any_methods)(members_, options);
    } else {
      return first_of<Contact>([&](const ContactVisitor<Members>& visit) {
        return method_by(call_.method, methods())(members_, options, visit);
      });
    }
  }

  void write_statements(ClaimsWriter& claims, const Result& result) const {
    const CoverQuestion<Members> question{members_, options_.allowed, options_.groups};
    if (call_.lists()) {
      write_list_statement(claims, question,
                           [&](const std::function<void(const Contact&)>& take) { result.for_each(take); });
    } else if (call_.count) {
      write_count_statement(claims, question, result.pairs());
    } else {
      AnyAnswer<Contact> answer;
      result.for_each([&](const Contact& contact) { answer.found = contact; });
      write_statement(claims, question, answer);
    }
  }

  const Call& call_;
  Talk& talk_;
  Origin origin_;
  MembersFile<Members> file_;
  const Members& members_;
  io::SystemOfFile system_;
  io::CoordinateSystems systems_;
  SetOptions options_;
};

template <class Of>
Verb members_verb() {
  const std::string methods = method_names(MembersSet<Of>::methods());
  const std::string members(Of::verb);
  return set_verb<MembersSet<Of>>(
      std::make_shared<SetCall>(),
      {members, Of::about_verb, Of::file_help, members, "nothing, or touch",
       members + " that are the same in this may meet: a column of the CSV",
       fmt::format("the column that names {}; unless given, name, NAME, id", members), methods});
}

}  // namespace sunder::ask
