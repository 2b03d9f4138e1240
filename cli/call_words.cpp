#include <cli/call_words.h>
#include <cli/words.h>

#include <sunder/io/text.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <cstdint>

namespace sunder::cli {

namespace {

// An option as a call gives it.
struct Given {
  std::string word;                                                          // "--svg", without what follows "="
  const CLI::Option* option = nullptr;                                       // null: there is none of that name
  enum class Value : std::uint8_t { none, here, next } value = Value::none;  // where it stands
};

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

Given given(const CLI::App& verb, const std::string& word, bool is_last) {
  const bool is_long = word.starts_with("--");
  const std::size_t size = is_long ? std::min(word.find('='), word.size()) : 2;
  Given result{word.substr(0, size), verb.get_option_no_throw(word.substr(0, size))};
  if (result.option == nullptr && !is_long) result.word = word;
  if (size < word.size()) {
    result.value = Given::Value::here;
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
    if (options.back().value == Given::Value::next) ++k;
  }
  return options;
}

std::string unknown(const CLI::App& verb, const std::string& word) {
  std::string text = "there is no option " + io::quote(word);
  const std::string meant = did_you_mean(word, names_of_options(verb));
  if (!meant.empty() || word.starts_with("--")) return text + meant;
  return text + "; a file of that name is " + io::quote("./" + word);
}

std::string problem_of(const CLI::App& verb, const Given& given) {
  if (given.option == nullptr) return unknown(verb, given.word);
  const bool takes = takes_value(*given.option), has = given.value != Given::Value::none;
  if (takes && !has) return fmt::format("{} has no value; give {}", given.word, given.option->get_type_name());
  if (!takes && has) return given.word + " takes no value; leave it out";
  return "";
}

}  // namespace

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

}  // namespace sunder::cli
