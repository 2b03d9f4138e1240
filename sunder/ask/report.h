// What the verbs share: methods and rules by name, poses as text, the JSON envelope, and output.
#pragma once

#include <sunder/ask/exit_code.h>

#include <sunder/io/text.h>
#include <sunder/planar/set/contact_rule.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

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

// There is no such method: throws Error bad_call that lists the `known`.
[[noreturn]] void refuse_method(std::string_view method, std::string_view known);

// The contacts that --allow names: nothing, shared-endpoint, touch. Throws Error bad_call that lists them.
Allowed allowed_by(std::string_view name);

// A method for pair questions by its name: automatic, gjk, scan. Throws Error bad_call that names all.
using PairMethod = solid::PairAnswer (*)(const solid::ConvexPolyhedron&, const solid::Pose&,  //
                                         const solid::ConvexPolyhedron&, const solid::Pose&);
PairMethod pair_method(const std::string& name);

// Numbers between commas or blanks. Throws Error that names the one that is none; `place` says where the text is from.
std::vector<double> parse_numbers(std::string_view text, const std::string& place);

// What parse_pose reads, for help texts.
extern const char* const pose_forms;

// A pose as text: "tx,ty,tz", "qw,qx,qy,qz,tx,ty,tz", or the 12 or 16 numbers of a matrix row by row.
// Throws Error bad_pose or bad_call, with `place`.
solid::Pose parse_pose(std::string_view text, const std::string& place);

// JSON. Objects keep the order in which they are made.
using Json = nlohmann::ordered_json;

// The keys that every verb's report begins with. What does not apply is null; `notes` are those so far.
Json envelope(const Json& verb, const Json& answer, const Json& method = nullptr);

// The report of a call that came to no answer: "error" has its kind, place and text. No verb: null.
Json error_report(const Json& verb, std::string_view kind, std::string_view place, std::string_view text);
Json to_json(const Cost& cost);
Json to_json(const Point3& point);

// The text of a report: indented, with short lists and objects on one line; ends with a line feed.
std::string to_text(const Json& json);

// On one line, with blanks: an entry of a list that is written as it comes.
std::string to_line(const Json& json);

// "about" numbers for people: four digits.
std::string about(double x);
std::string about(const Point3& p);  // "(x, y, z)"

// "(x, y)", ten digits.
std::string place_text(const Point2& p);

using io::count_of;

}  // namespace sunder::ask
