#include <cli/call_files.h>

#include <sunder/ask/outputs.h>
#include <sunder/base/error.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::cli {

namespace {

namespace fs = std::filesystem;
using ask::NamedFile;

constexpr std::array<std::string_view, 5> output_options{"--certificate", "--csv", "--geojson", "--svg", "--out"};
constexpr std::string_view stream = "-";

template <class List>
bool is_in(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// "cube.obj" of "cube.obj@1,0,0".
std::string without_pose(const std::string& word) { return word.substr(0, word.rfind('@')); }

std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? "" : "--" + option.get_lnames().front();
}

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
  const auto reads = [](const NamedFile& file) { return file.path == stream || file.path == "/dev/stdin"; };
  if (std::count_if(inputs.begin(), inputs.end(), reads) < 2) return;
  throw Error(ErrorCode::bad_call, "standard input is named twice, and can be read once; name a file", "-");
}

}  // namespace

void require_apart(const CLI::App& verb) {
  std::vector<NamedFile> inputs, outputs;
  for (const CLI::Option* option : verb.get_options()) {
    const std::string name = name_of(*option);
    for (const std::string& value : option->results()) {
      if (is_in(output_options, name)) {
        outputs.push_back({name, value});
      } else if (reads_files(*option) && !(option->get_type_name() == "WHAT" && is_allowed_kind(value))) {
        const std::string file = name.empty() && !is_there(value) ? without_pose(value) : value;
        if (!file.empty()) inputs.push_back({name, file});
      }
    }
  }
  require_one_reader(inputs);
  ask::require_apart(inputs, std::move(outputs));
}

bool takes_standard_output(const CLI::App& verb) {
  const CLI::Option* json = verb.get_option_no_throw("--json");
  std::string first = json != nullptr && json->count() > 0 ? "--json" : "";
  if (!first.empty() && verb.get_option("--quiet")->count() > 0) {
    throw Error(ErrorCode::bad_call, "a report is not quiet; leave one of the two out", "--json and --quiet");
  }
  bool takes = false;
  for (const std::string_view name : output_options) {
    const CLI::Option* option = verb.get_option_no_throw(std::string(name));
    if (option == nullptr || !is_in(option->results(), stream)) continue;
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
    for (const std::string& file : {words[k], without_pose(words[k])}) {
      if (!file.empty() && ask::overwrites(stream, file)) return true;
    }
  }
  return false;
}

}  // namespace sunder::cli
