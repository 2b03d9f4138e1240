// A question about the members of a set, as a verb: do any two meet, which do, how many? What is the same for all sets:
// the call, its options, and the one pass over the contacts that feeds text, reports, maps, tables and pictures.
//
// What is a set's own is a class, here Set:
//   Set::Call, Set::Contact              SetCall or what derives from it; what a contact is
//   Set::verb, Set::noun, Set::kinds     "circles", "circle", all kinds but none, the strongest first
//   static check(call)                   what can be told before a file is read; throws Error
//   Set(call, talk)                      reads; throws Error
//   systems()                            io::CoordinateSystems of what was read
//   drawn(), drawn_noun                  how many things a picture shows
//   ask(result)                          answers
//   prove(result)                        writes the certificates, where one is asked for; returns their names
//   facts(result)                        what is told besides the contacts
//   kind_of(contact), row(contact)       to all lists
//   text(contact)                        for people, after its number
//   picture(result, contacts, said)      an SVG, in which this is said
#pragma once

#include <sunder/ask/list_stream.h>
#include <sunder/ask/report.h>
#include <sunder/ask/set/contact_row.h>
#include <sunder/ask/verb.h>

#include <sunder/certificate/claims.h>
#include <sunder/near/contacts_in_order.h>
#include <sunder/near/set_question.h>
#include <sunder/picture/plane.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::ask {

using picture::Ink;
using picture::PlanePicture;

struct SetCall : QuestionCall {
  std::vector<std::string> files;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string allow = "nothing";
  std::string group, name, csv, geojson;
  std::vector<std::string> properties;
  bool leave_out = false, drop_z = false, mixed_crs = false;

  // A picture, a map and a table show all.
  bool lists() const { return all || !csv.empty() || !geojson.empty() || !svg.empty(); }
  bool counts() const { return lists() || count; }
};

// Help of the options, where it differs.
struct SetHelp {
  std::string verb, about, file, noun;  // noun: "circles"
  std::string allow, group, name, method;
  int most_files = 1;
};
std::vector<Option> set_options(SetCall& call, const SetHelp& help);
void add_file_options(Verb& verb, SetCall& call);  // of files of features: --leave-out, --drop-z, --mixed-crs

// What is told of a set and of the answer, besides the contacts: for people, and in JSON.
struct SetFacts {
  std::string head, tail;               // lines before the verdict, and after the contacts
  std::string said_of, clause;          // within the verdict: " of the centre lines"; what it is not about
  std::vector<std::string> rules;       // within the verdict: what may meet
  std::vector<std::string> not_proved;  // the words of the answer that the proof does not prove
  Json first = Json::object(), last = Json::object();  // in a report, around what is allowed
};

// Proofs of lists are as long as the lists. Of more contacts, pairs or defects than that none is written.
inline constexpr std::uint64_t most_proved = 10'000'000;

// Throws Error bad_call for more: it names the option.
void require_provable(std::uint64_t contacts);

// Throws Error bad_call where a proof is asked of the method scan.
void require_other_than_scan(const SetCall& call);

template <class Set>
struct SetResult {
  using Contact = typename Set::Contact;
  using Visitor = std::function<bool(const Contact&)>;
  using Contacts = ContactsInOrder<Contact>;

  std::function<void(const Visitor&)> visit = [](const Visitor&) {};  // by i, then j; with --any at most one
  std::array<std::uint64_t, Set::kinds.size()> count{};               // of contacts, by kind
  std::vector<std::string> proofs;                                    // files written
  Cost cost;
  std::string_view function{};  // of the library, that answered

  // The position in Set::kinds.
  static std::size_t kind_of(const Contact& contact) {
    const auto kind = std::find(Set::kinds.begin(), Set::kinds.end(), Set::kind_of(contact));
    return static_cast<std::size_t>(kind - Set::kinds.begin());
  }

  void add(const Contact& contact) { ++count.at(kind_of(contact)); }
  std::uint64_t pairs() const { return std::accumulate(count.begin(), count.end(), std::uint64_t{0}); }
  bool some() const { return pairs() > 0; }

  void hold(std::vector<Contact> contacts) { hold(std::make_shared<Contacts>(std::move(contacts))); }
  void hold(std::shared_ptr<Contacts> contacts) {
    visit = [contacts](const Visitor& visitor) { contacts->visit(visitor); };
  }

  template <class Take>
  void for_each(const Take& take) const {
    visit([&](const Contact& contact) {
      take(contact);
      return true;
    });
  }

  // With --any.
  void found(const std::optional<Contact>& contact) {
    if (!contact) return;
    add(*contact);
    visit = [one = *contact](const Visitor& visitor) { visitor(one); };
  }

  // With --count, and where a list is wanted: it stays in memory, or is asked for again, block by block. Then what
  // ask_block has by reference must stay. ask_block(block, take): Cost.
  template <class AskBlock>
  void count_and_list(std::uint32_t size, bool lists, const AskBlock& ask_block) {
    const auto first = [this, ask_block](const Block& block, const typename Contacts::Take& take) {
      cost = ask_block(block, [&](const Contact& c) {
        add(c);
        if (take) take(c);
      });
    };
    if (!lists) return first({0, size}, nullptr);
    auto is_first = std::make_shared<bool>(true);
    hold(
        std::make_shared<Contacts>(size, most_held(size), [=](const Block& block, const typename Contacts::Take& take) {
          if (std::exchange(*is_first, false)) return first(block, take);
          ask_block(block, take);
        }));
  }
};

// " (touch allowed; those of one net may meet)", or nothing.
inline std::string rules_text(const SetCall& call, const SetFacts& facts) {
  std::vector<std::string> rules = facts.rules;
  if (call.allow != "nothing") rules.insert(rules.begin(), call.allow + " allowed");
  return rules.empty() ? "" : fmt::format(" ({})", fmt::join(rules, "; "));
}

// The verdict in a picture: "2 pairs of the tracks' centre lines meet (touch allowed)"
inline std::string picture_text(const SetCall& call, const SetFacts& facts, std::uint64_t pairs) {
  const std::string subject = pairs == 0 ? "none" : count_of(pairs, "pair");
  return fmt::format("{}{} {}{}{}", subject, facts.said_of, pairs == 1 ? "meets" : "meet", rules_text(call, facts),
                     facts.clause);
}

// "some meet (touch allowed): 2 pairs: 2 touching"
template <class Set>
std::string verdict_text(const SetCall& call, const SetFacts& facts, const SetResult<Set>& result) {
  std::string text =
      fmt::format("{}{} meet{}", result.some() ? "some" : "none", facts.said_of, rules_text(call, facts));
  if (result.some() && call.counts()) {
    std::string counts;
    for (std::size_t k = 0; k < result.count.size(); ++k) {
      if (result.count.at(k) == 0) continue;
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", result.count.at(k), name_of(Set::kinds.at(k)));
    }
    text += fmt::format(": {}: {}", count_of(result.pairs(), "pair"), counts);
  }
  return text + facts.clause + '\n';
}

// listed: the first of the contacts.
template <class Set>
std::string human_text(const SetCall& call, const Set& set, const SetFacts& facts, const SetResult<Set>& result,
                       const std::vector<typename Set::Contact>& listed) {
  std::string text = facts.head + verdict_text(call, facts, result);
  for (std::size_t k = 0; k < listed.size(); ++k) {
    text += fmt::format("{} {}", call.lists() ? fmt::format("  {}.", k + 1) : " ", set.text(listed[k]));
  }
  if (call.lists() && result.pairs() > listed.size()) {
    text += fmt::format("  and {} more; --json, --csv, --geojson or --svg have all\n", result.pairs() - listed.size());
  }
  text += facts.tail;
  for (const Fact& fact : facts_of(set.systems())) text += fact.text;
  text += titled("cost", count_of(result.cost.probes, "comparison"));
  for (const std::string& proof : result.proofs) text += file_line("proof", proof);
  if (call.proves()) text += not_proved_line(facts.not_proved);
  return text + file_line("contacts", call.geojson) + file_line("table", call.csv) + file_line("picture", call.svg);
}

// All but the contacts.
template <class Set>
Json report(const Talk& talk, const SetCall& call, const Set& set, const SetFacts& facts,
            const SetResult<Set>& result) {
  Json json = envelope(talk, Set::verb, result.some() ? "some" : "none", call.method);
  json["function"] = result.function;
  json["cost"] = to_json(result.cost);
  json.update(facts.first);
  json["allowed"] = call.allow;
  if (!call.group.empty()) json["group"] = call.group;
  json.update(facts.last);
  for (const Fact& fact : facts_of(set.systems())) json[fact.key] = fact.json;
  if (call.proves()) json["not_proved"] = facts.not_proved;
  if (!call.counts()) return json;
  json["count"] = result.pairs();
  for (std::size_t k = 0; k < result.count.size(); ++k) {
    json["counts"][std::string(name_of(Set::kinds.at(k)))] = result.count.at(k);
  }
  return json;
}

// In a picture a member has the colour of the strongest contact that it is in. Of each member a position in Set::kinds,
// or their number: it is in none.
template <class Set>
std::vector<std::size_t> strongest_kinds(const std::vector<typename Set::Contact>& contacts, std::size_t size) {
  std::vector<std::size_t> strongest(size, Set::kinds.size());
  for (const typename Set::Contact& c : contacts) {
    for (const std::uint32_t i : {c.i, c.j}) strongest[i] = std::min(strongest[i], SetResult<Set>::kind_of(c));
  }
  return strongest;
}

// A picture of full members: seen, what must be on it; said, the verdict; name(i); draw(drawing, i, ink);
// mark(contact): where it has a ring over all, or nothing.
template <class Set, class Name, class Draw, class Mark>
std::string picture_of_members(const SetCall& call, const SetResult<Set>& result,
                               const std::vector<typename Set::Contact>& contacts, std::span<const Point2> seen,
                               std::uint32_t size, const std::string& said, const Name& name, const Draw& draw,
                               const Mark& mark) {
  constexpr std::array inks{Ink::accent, Ink::second, Ink::third, Ink::calm};
  std::array<picture::RingKind, Set::kinds.size()> ring_kinds;
  for (std::size_t k = 0; k < Set::kinds.size(); ++k) ring_kinds.at(k) = {inks.at(k), name_of(Set::kinds.at(k))};
  PlanePicture drawing(seen);
  const std::vector<std::size_t> strongest = strongest_kinds<Set>(contacts, size);
  for (std::size_t kind = Set::kinds.size() + 1; kind-- > 0;) {
    for (std::uint32_t i = 0; i < size; ++i) {
      if (strongest[i] != kind) continue;
      drawing.named(name(i), [&] { draw(drawing, i, kind < Set::kinds.size() ? inks.at(kind) : Ink::calm); });
    }
  }
  std::vector<picture::RingContact> places;
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    const std::optional<Point2> at = mark(contacts[k]);
    if (at) places.push_back({drawing.at(*at), k, result.kind_of(contacts[k])});
  }
  drawing.rings(places, ring_kinds, [&](std::uint32_t k) {
    const typename Set::Contact& c = contacts[k];
    return fmt::format("contact {}: {}: {} and {}", k + 1, name_of(Set::kind_of(c)), name(c.i), name(c.j));
  });
  for (std::size_t k = 0; k < Set::kinds.size(); ++k) {
    drawing.legend(inks.at(k), fmt::format("{} {}", name_of(Set::kinds.at(k)), result.count.at(k)));
  }
  drawing.legend(Ink::calm,
                 call.allow == "nothing" && call.group.empty() ? "meets no other" : "no contact that counts");
  return drawing.text(call.title_or(fmt::format("Which of these {} meet?", Set::verb)),
                      fmt::format("{}; {}", count_of(size, Set::noun), said));
}

// Goes through the contacts once, and writes all that was asked for.
template <class Set>
void write_set(Talk& talk, const SetCall& call, const Set& set, const SetResult<Set>& result) {
  constexpr std::size_t most_listed = 20;
  talk.note_all(set.systems().remarks());
  const SetFacts facts = set.facts(result);
  std::optional<ContactTable> table;
  if (!call.csv.empty()) table.emplace(talk, call.csv);
  std::optional<GeojsonFile> geojson;
  if (!call.geojson.empty()) geojson.emplace(talk, call.geojson, set.systems());
  std::optional<ListReport> json;
  if (call.json) json.emplace(talk, report(talk, call, set, facts, result), "contacts");
  std::vector<typename Set::Contact> listed, drawn;
  result.visit([&](const typename Set::Contact& contact) {
    if (table || geojson || json) {
      const ContactRow row = set.row(contact);
      if (json) json->add(report_text(row));
      if (geojson) geojson->add(geojson_text(row, geojson->count() + 1));
      if (table) table->add(row);
    }
    if (!call.svg.empty()) drawn.push_back(contact);
    if (listed.size() < most_listed) listed.push_back(contact);
    return table || geojson || json || !call.svg.empty() || listed.size() < most_listed;
  });
  if (table) table->close();
  if (geojson) geojson->close();
  if (!call.svg.empty())
    talk.write_file(call.svg, set.picture(result, drawn, picture_text(call, facts, result.pairs())));
  json ? json->close() : talk.print_for_people(human_text(call, set, facts, result, listed));
}

// The verb: answers, proves, writes.
template <class Set>
Report run_set(const typename Set::Call& call, Talk& talk) {
  Set::check(call);
  require_different(call.properties);
  Set set(call, talk);
  const auto require_drawable = [&](std::uint64_t contacts) {
    if (!call.svg.empty()) ask::require_drawable(set.drawn(), Set::drawn_noun, contacts, call.svg_limit);
  };
  require_drawable(0);
  SetResult<Set> result;
  set.ask(result);
  require_drawable(result.pairs());
  if (call.proves()) result.proofs = set.prove(result);
  write_set(talk, call, set, result);
  return told(result.some() ? exit_code::yes : exit_code::no);
}

template <class Set>
Verb set_verb(std::shared_ptr<typename Set::Call> call, const SetHelp& help) {
  return {help.verb, help.about, codes_of_sets, set_options(*call, help),
          [call](Talk& talk) { return run_set<Set>(*call, talk); }};
}

}  // namespace sunder::ask
