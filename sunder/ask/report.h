// What the verbs share: methods and rules by name, the JSON envelope, and output.
#pragma once

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
#include <memory>
#include <span>
#include <string>
#include <string_view>
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

// Writes to standard output at once. Throws Error bad_call where that fails (a full disk).
void print(std::string_view text);

// The same for people: what a terminal might obey (control bytes, but for line feeds) goes as \xNN. Names that may hold
// line feeds are made one line before: io::one_line.
void print_for_people(std::string_view text);

// One line on standard error: "sunder: ...". What cannot be written there is lost, and that is no error.
void print_error(std::string_view text);

// The same, and in reports that are made after it: "sunder: note: ...".
void note(std::string_view text);

// From now on nothing is printed but errors (--quiet).
void be_quiet();
bool is_quiet();

// From now on nothing is printed for people: standard output has another use.
void leave_standard_output();

// Has standard output another use, or has anything been printed, a part of a report perhaps?
bool is_output_in_use();

struct Spoken;  // what has been said in this call, and whether anything is to be

// While one is alive, nothing is printed; what has been said is then as it was before.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::unique_ptr<Spoken> before_;
};

// There is no such method: throws Error bad_call that lists the `known`.
[[noreturn]] void refuse_method(std::string_view method, std::string_view known);

// Methods by name, as --method has them.
template <class Method>
struct Named {
  std::string_view name;
  Method* method;
};

// "automatic, gjk, scan": for help texts and errors.
template <class Methods>
std::string method_names(const Methods& methods) {
  std::string names;
  for (const auto& m : methods) names.append(names.empty() ? "" : ", ").append(m.name);
  return names;
}

// Throws Error bad_call that lists all names, and what they are for.
template <class Methods>
auto* method_by(std::string_view name, const Methods& methods, std::string_view what_for = "") {
  for (const auto& m : methods) {
    if (m.name == name) return m.method;
  }
  refuse_method(name, method_names(methods).append(what_for));
}

inline constexpr std::array all_allowed{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch};

// The contacts that --allow names. Throws Error bad_call that lists those that may be allowed.
Allowed allowed_by(std::string_view name, std::span<const Allowed> those = all_allowed);

// A method for two bodies by its name. Throws Error bad_call that names all, and `more`.
using PairMethod = solid::PairAnswer (*)(const solid::ConvexPolyhedron&, const solid::Pose&,  //
                                         const solid::ConvexPolyhedron&, const solid::Pose&);
PairMethod pair_method(const std::string& name, std::string_view more = "");
std::string pair_method_names();

// The keys that every verb's report begins with. What does not apply is null; `notes` are those so far.
Json envelope(const Json& verb, const Json& answer, const Json& method = nullptr);

// The report of a call that came to no answer: "error" has its kind, place and text. No verb: null.
Json error_report(const Json& verb, std::string_view kind, std::string_view place, std::string_view text);
Json to_json(const Cost& cost);
Json to_json(const Point3& point);
Json to_json(const io::CoordinateSystems& systems);  // [{"name", "assumed", "files": [...]}]
Json to_json(const LeftOutList& list);               // [{"kind", "count", "of": [...]}], with all owners

// The text of a report: indented, with short lists and objects on one line; ends with a line feed.
std::string to_text(const Json& json);

// A certificate file: its origin, and the statements that `write` writes; whole, or not there.
void write_proof(const std::string& file, const Origin& origin, const std::function<void(ClaimsWriter&)>& write);

// "  title       value\n"; other lines of the value stand below it.
std::string titled(std::string_view title, std::string value);

// The same of a file that was written; empty where there is none. clause: what is said of it.
std::string file_line(std::string_view title, const std::string& file, std::string_view clause = "");

// Reports name the coordinate systems of the inputs: in a line of text, in "coordinate_systems" of JSON, and in notes.
// Each is empty where no input declares a system.
std::string systems_line(const io::CoordinateSystems& systems);
void add_systems(const io::CoordinateSystems& systems, Json& report);
void note_systems(const io::CoordinateSystems& systems);

// What an answer says and its proof does not, in words; empty where there is nothing.
std::string not_proved_line(std::span<const std::string> words);

// "about" numbers for people: four digits.
std::string about(double x);
std::string about(const Point3& p);  // "(x, y, z)"

// "about 0.25": a length, by its upper end; "at least 1.79769313486e+308" where that is beyond the range of doubles.
std::string about_length(const Interval& length);

}  // namespace sunder::ask
