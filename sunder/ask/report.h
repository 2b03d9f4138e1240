// What the verbs share: methods and rules by name, the JSON envelope, and words.
#pragma once

#include <sunder/ask/talk.h>

#include <sunder/base/cost.h>
#include <sunder/base/json.h>
#include <sunder/certificate/claims.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/plane/coordinate_system.h>
#include <sunder/io/text/left_out.h>
#include <sunder/io/text/pose_text.h>
#include <sunder/io/text/text.h>
#include <sunder/number/interval.h>
#include <sunder/planar/segments/contact_rule.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::ask {

using io::count_of;
using io::LeftOutList;
using io::parse_numbers;
using io::parse_pose;
using io::place_text;
using io::pose_forms;

// What a question comes to, as a number.
namespace exit_code {
constexpr int no = 0;        // apart, none meet, accepted; also `hull` and `info`
constexpr int yes = 1;       // meet, some meet, refused
constexpr int bad = 2;       // bad input or call; one line on standard error
constexpr int internal = 3;  // a fault of the program itself
}  // namespace exit_code

// There is no such method: throws Error bad_call that lists the `known`.
[[noreturn]] void refuse_method(std::string_view method, std::string_view known);

// Methods by name, as --method has them, each with the library's function that it calls, as reports name it. May be
// called as the method.
template <class Method>
struct Named {
  std::string_view name;
  Method* method = nullptr;
  std::string_view function{};  // "planar::segments_any_by_sweep"
  operator Method*() const { return method; }
};

// So that the name of a function is that of the function which is called.
#define SUNDER_METHOD(name, function) {name, function, #function}

// "automatic, gjk, scan": for help texts and errors.
template <class Methods>
std::string method_names(const Methods& methods) {
  std::string names;
  for (const auto& m : methods) names.append(names.empty() ? "" : ", ").append(m.name);
  return names;
}

// Throws Error bad_call that lists all names, and what they are for.
template <class Methods>
auto method_by(std::string_view name, const Methods& methods, std::string_view what_for = "") {
  for (const auto& m : methods) {
    if (m.name == name) return m;
  }
  refuse_method(name, method_names(methods).append(what_for));
}

inline constexpr std::array all_allowed{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch};

// The contacts that --allow names. Throws Error bad_call that lists those that may be allowed.
Allowed allowed_by(std::string_view name, std::span<const Allowed> those = all_allowed);

// A method for two bodies by its name. Throws Error bad_call that names all, and `more`.
using PairMethod = Named<solid::PairAnswer(const solid::ConvexPolyhedron&, const solid::Pose&,  //
                                           const solid::ConvexPolyhedron&, const solid::Pose&)>;
PairMethod pair_method(const std::string& name, std::string_view more = "");
std::string pair_method_names();

// One statement about an answer: lines of text for people, and a JSON value under a key. Either may be empty.
struct Fact {
  std::string key;
  Json json;
  std::string text;
};

// The answer to a call, as a value. text_of and json_of say it to people and to programs.
struct Report {
  Json verb = nullptr, answer = nullptr;
  int code = exit_code::no;
  Json method = nullptr, function = nullptr, decided_by = nullptr;
  std::optional<Cost> cost{};
  std::string cost_text{};  // to people; empty: nothing is said of it
  Json objects = Json::array();
  std::vector<std::string> notes{};
  std::vector<Fact> facts{};  // in their order
  bool is_proved = false;
  std::vector<std::string> not_proved{};  // what of all this a proof does not say, in words
  std::string proof{}, picture{};         // files that were written, told to people
  bool has_colours = false;               // the text for people has those of terminals, and no other control bytes
  bool is_told = false;                   // it went to the talk as it was found, and nothing of it is left to be said

  void tell(std::string text) { facts.push_back({"", nullptr, std::move(text)}); }
  void add(std::string key, Json json, std::string text = "") {
    facts.push_back({std::move(key), std::move(json), std::move(text)});
  }
  void add(const std::vector<Fact>& more) { facts.insert(facts.end(), more.begin(), more.end()); }
};
std::string text_of(const Report& report);
Json json_of(const Report& report);

// The report of an answer that has been printed already: it holds the exit code alone.
Report told(int code);

// The keys that every verb's report begins with. What does not apply is null; `notes` are those so far.
Json envelope(const Talk& talk, const Json& verb, const Json& answer, const Json& method = nullptr);

// The report of a call that came to no answer: "error" has its kind, place and text. No verb: null.
Json error_report(const Talk& talk, const Json& verb, std::string_view kind, std::string_view place,
                  std::string_view text);
Json to_json(const Cost& cost);
Json to_json(const Point3& point);
Json to_json(const io::CoordinateSystems& systems);  // [{"name", "assumed", "files": [...]}]
Json to_json(const LeftOutList& list);               // [{"kind", "count", "of": [...]}], with all owners

// The text of a report: indented, with short lists and objects on one line; ends with a line feed.
std::string to_text(const Json& json);

// A certificate file: its origin, and the statements that `write` writes; whole, or not there.
void write_proof(const Talk& talk, const std::string& file, const Origin& origin,
                 const std::function<void(ClaimsWriter&)>& write);

// "  title       value\n"; other lines of the value stand below it.
std::string titled(std::string_view title, std::string value);

// The same of a file that was written; empty where there is none. clause: what is said of it.
std::string file_line(std::string_view title, const std::string& file, std::string_view clause = "");

// Reports name the coordinate systems of the inputs, as one fact; none where no input declares a system.
std::vector<Fact> facts_of(const io::CoordinateSystems& systems);

// What was left out, for reports alone: the clauses of verdicts have it for people.
std::vector<Fact> facts_of(const LeftOutList& left_out);

// What an answer says and its proof does not, in words; empty where there is nothing.
std::string not_proved_line(std::span<const std::string> words);

// "about" numbers for people: four digits.
std::string about(double x);
std::string about(const Point3& p);  // "(x, y, z)"

// "about 0.25": a length, by its upper end; "at least 1.79769313486e+308" where that is beyond the range of doubles.
std::string about_length(const Interval& length);

}  // namespace sunder::ask
