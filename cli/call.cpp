#include <cli/call.h>
#include <cli/words.h>

#include <sunder/ask/outputs.h>
#include <sunder/ask/scene/scene_input.h>
#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>

namespace sunder::cli {

namespace {

constexpr std::array<std::string_view, 8> output_options{
    "--certificate", "--csv", "--geojson", "--svg", "--gltf", "--out", "--json-lines", "--meeting-certificate"};

template <class List>
bool is_in(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// ---- Words.

// An option as a call gives it.
struct Given {
  std::string word;                                                          // "--svg", without what follows "="
  const CLI::Option* option = nullptr;                                       // null: there is none of that name
  enum class Value : std::uint8_t { none, here, next } value = Value::none;  // where it stands
  bool is_empty = false;                                                     // the value is there, and has no character
};

std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? "" : "--" + option.get_lnames().front();
}

Given given(const CLI::App& verb, const std::string& word, bool is_last) {
  const bool is_long = word.starts_with("--");
  const std::size_t size = is_long ? std::min(word.find('='), word.size()) : 2;
  Given result{word.substr(0, size), verb.get_option_no_throw(word.substr(0, size))};
  if (result.option == nullptr && !is_long) result.word = word;
  if (size < word.size()) {
    result.value = Given::Value::here;
    result.is_empty = is_long && size + 1 == word.size();
  } else if (result.option != nullptr && takes_value(*result.option) && !is_last) {
    result.value = Given::Value::next;
  }
  return result;
}

std::vector<Given> given_options(const CLI::App& verb, std::span<const std::string> words) {
  std::vector<Given> options;
  for (std::size_t k = 0; k < words.size() && words[k] != "--"; ++k) {
    if (!words[k].starts_with('-') || words[k] == "-") continue;
    options.push_back(given(verb, words[k], k + 1 == words.size()));
    if (options.back().value != Given::Value::next) continue;
    ++k;
    options.back().is_empty = words[k].empty();
  }
  return options;
}

std::string unknown(const CLI::App& verb, const std::string& word) {
  std::string text = "there is no option " + io::quote(word);
  std::string others;  // verbs that have it
  for (const CLI::App* other : verbs_of(*verb.get_parent())) {
    if (other->get_option_no_throw(word) != nullptr) others += (others.empty() ? "" : ", ") + other->get_name();
  }
  if (!others.empty()) {
    return fmt::format("{} has no option {}; these verbs have it: {}", verb.get_name(), io::quote(word), others);
  }
  const std::string meant = did_you_mean(word, names_of_options(verb));
  if (!meant.empty() || word.starts_with("--")) return text + meant;
  return text + "; a file of that name is " + io::quote("./" + word);
}

std::string problem_of(const CLI::App& verb, const Given& given) {
  if (given.option == nullptr) return unknown(verb, given.word);
  const bool takes = takes_value(*given.option), has = given.value != Given::Value::none;
  if (takes && !has) return fmt::format("{} has no value; give {}", given.word, given.option->get_type_name());
  if (!takes && has) return given.word + " takes no value; leave it out";
  // Mostly a variable of a shell that is not set: it must not be as if the option were not there. Names of outputs are
  // looked at where files are.
  const std::string name = name_of(*given.option);
  const bool may_be_empty = given.value == Given::Value::next && (name == "--title" || is_in(output_options, name));
  if (given.is_empty && !may_be_empty) {
    return fmt::format("the value of {} is empty; give {}", given.word, given.option->get_type_name());
  }
  return "";
}

// ---- Files.

namespace fs = std::filesystem;
using ask::NamedFile;

constexpr std::string_view standard_stream = "-";

bool is_there(const std::string& file) {
  std::error_code problem;
  return fs::exists(file, problem);
}

// Words of --allow are kinds, names, and files.
bool reads_files(const CLI::Option& option) {
  return option.get_lnames().empty() || option.get_type_name() == "FILE" || option.get_type_name() == "WHAT";
}

bool is_allowed_kind(const std::string& word) {
  return word == "adjacent" || word == "touch" || (word.find(',') != std::string::npos && !is_there(word));
}

void require_one_reader(const std::vector<NamedFile>& inputs) {
  const auto reads = [](const NamedFile& file) { return file.path == standard_stream || file.path == "/dev/stdin"; };
  if (std::count_if(inputs.begin(), inputs.end(), reads) < 2) return;
  throw Error(ErrorCode::bad_call, "standard input is named twice, and can be read once; name a file", "-");
}

}  // namespace

std::vector<const CLI::App*> verbs_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string option_problem(const CLI::App& verb, std::span<const std::string> words) {
  const std::vector<Given> options = given_options(verb, words);
  const auto is_help = [&](const Given& given) { return given.option == verb.get_help_ptr(); };
  if (std::any_of(options.begin(), options.end(), is_help)) return "";
  for (auto given = options.begin(); given != options.end(); ++given) {
    if (std::string problem = problem_of(verb, *given); !problem.empty()) return problem;
    const auto is_same = [&](const Given& other) { return other.option == given->option; };
    const bool may_repeat = given->option->get_items_expected_max() != 1;
    if (!may_repeat && std::any_of(options.begin(), given, is_same)) {
      return given->word + " is given twice; leave one out";
    }
  }
  return "";
}

bool asks_for_json(const CLI::App& verb, std::span<const std::string> words) {
  const std::vector<Given> options = given_options(verb, words);
  return std::any_of(options.begin(), options.end(), [](const Given& given) { return given.word == "--json"; });
}

void require_apart(const CLI::App& verb, ask::Talk& talk) {
  std::vector<NamedFile> inputs, outputs;
  for (const CLI::Option* option : verb.get_options()) {
    const std::string name = name_of(*option);
    for (const std::string& value : option->results()) {
      if (is_in(output_options, name)) {
        outputs.push_back({name, value});
      } else if (reads_files(*option) && !(option->get_type_name() == "WHAT" && is_allowed_kind(value))) {
        const bool may_have_a_name = name.empty() || name == "--srdf";
        const std::string file = may_have_a_name && !is_there(value) ? ask::file_word(value).file : value;
        if (!file.empty()) inputs.push_back({name, file});
      }
    }
  }
  require_one_reader(inputs);
  ask::require_apart(talk, inputs, std::move(outputs));
}

bool takes_standard_output(const CLI::App& verb, const ask::Talk& talk) {
  const CLI::Option* json = verb.get_option_no_throw("--json");
  std::string first = json != nullptr && json->count() > 0 ? "--json" : "";
  if (!first.empty() && verb.get_option("--quiet")->count() > 0) {
    throw Error(ErrorCode::bad_call, "a report is not quiet; leave one of the two out", "--json and --quiet");
  }
  if (talk.instead(standard_stream)) return false;
  bool takes = false;
  for (const std::string_view name : output_options) {
    const CLI::Option* option = verb.get_option_no_throw(std::string(name));
    if (option == nullptr || !is_in(option->results(), standard_stream)) continue;
    if (!first.empty()) {
      throw Error(ErrorCode::bad_call, "standard output is taken by " + first + "; name a file", std::string(name));
    }
    first = name;
    takes = true;
  }
  return takes;
}

bool prints_over_input(std::span<const std::string> words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool is_output = k > 0 && (words[k - 1] == "-o" || is_in(output_options, words[k - 1]));
    if (is_output) continue;
    for (const std::string& file : {words[k], ask::file_word(words[k]).file}) {
      if (!file.empty() && ask::overwrites(standard_stream, file)) return true;
    }
  }
  return false;
}

}  // namespace sunder::cli
