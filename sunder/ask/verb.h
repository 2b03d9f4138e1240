// The verbs as data: what each asks, its files and options, and what answers. Whoever lets people call them (the
// program, a language, a page) makes calls, help and completion from these tables.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sunder::ask {

class Talk;     // talk.h
struct Report;  // report.h

// A list takes a value each time that its option is given; one that stands without an option takes all words.
using OptionValue = std::variant<bool*, std::string*, std::uint64_t*, std::vector<std::string>*>;

struct Option {
  std::string name;   // "--svg", "-o,--out"; what stands without an option: "FILE"
  OptionValue value;  // where it goes; what is there before holds unless the option is given
  std::string help;
  std::string type = "TEXT";  // of the value, for people: NAME; FILE, if it is the name of one
  bool required = false;
  std::string needs = "";                  // the option that must be given, too
  std::vector<std::string> excludes = {};  // those that must not
  int most = 0;                            // words of a list without an option; 0: any number
  std::vector<std::string> of = {};        // the kinds of input that it is for, in words; empty: all
};

// Does the call set this option to a value that differs from its default? unless_given: the same option with its default.
bool is_given(const Option& option, const Option& unless_given);

// Throws Error bad_call for the first option that is given and is for none of these kinds, of which the input is one.
void require_fit(const std::vector<Option>& options, const std::vector<Option>& unless_given,
                 const std::vector<std::string>& kinds);

// The option, for these kinds of input alone.
inline Option only_of(std::vector<std::string> kinds, Option option) {
  option.of = std::move(kinds);
  return option;
}

struct Verb {
  std::string name, about, codes;    // codes: what the exit codes 0 and 1 say
  std::vector<Option> options;       // those without an option in front, in their order, first
  std::function<Report(Talk&)> run;  // answers the call that stands in the values. Throws Error
};

// Pictures: how many things are drawn, unless --svg-limit says another number.
inline constexpr std::uint64_t most_drawn = 1'000'000;

// Throws Error bad_call where so many things ("circle") and contacts are more than `most`: it names the option.
void require_drawable(std::uint64_t things, std::string_view noun, std::uint64_t contacts, std::uint64_t most);

// Questions about meshes: how much memory they may take, in MiB, unless --memory says another number.
inline constexpr std::uint64_t most_memory = 4096;

// What most calls have.
struct QuestionCall {
  std::string method = "automatic";
  std::string certificate, svg, title;
  std::uint64_t svg_limit = most_drawn;
  std::uint64_t memory = most_memory;
  bool json = false;

  bool proves() const { return !certificate.empty(); }
  std::string title_or(std::string_view other) const { return title.empty() ? std::string(other) : title; }
};

inline constexpr const char *codes_of_sets = "0 none meet; 1 some meet", *codes_of_reports = "0";

// The most things that --svg may draw; after the option --svg.
Option svg_limit_option(std::uint64_t& limit);

// Options that most verbs have.
inline constexpr const char* leave_out_help =
    "leave out what this verb cannot use (shapes, lines, loose vertices), and list it";
inline constexpr const char* mixed_crs_help =
    "compare coordinates as they are, even if the files declare different coordinate systems";
Option json_option(bool& json);
Option title_option(std::string& title);  // of the picture of --svg
Option certificate_option(std::string& file, std::string help = "write the proof to FILE");

Verb pair_verb();
Verb scene_verb();
Verb segments_verb();
Verb simple_verb();
Verb circles_verb();
Verb boxes_verb();
Verb polygons_verb();
Verb region_verb();
Verb kernel_verb();
Verb hull_verb();
Verb section_verb();
Verb polar_verb();
Verb info_verb();
Verb verify_verb();

// All, in this order. Each call makes verbs with values of their own.
std::vector<Verb> verbs();

}  // namespace sunder::ask
