#include <cli/outputs.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

namespace sunder::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> output_options{"--certificate", "--csv", "--geojson", "--svg", "--out"};
constexpr std::array<std::string_view, 2> words{"--title", "--method"};
constexpr std::string_view standard_output = "/dev/stdout";

template <class List>
bool is_in(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code problem;
  const fs::file_status status = fs::status(a, problem);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;
  if (fs::exists(status) && fs::exists(b, problem)) return fs::equivalent(a, b, problem) && !problem;
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, problem), problem);
  const fs::path whole_b = fs::weakly_canonical(fs::absolute(b, problem), problem);
  return !whole_a.empty() && whole_a == whole_b;
}

std::string described(const NamedFile& file) {
  const std::string name = io::quote(file.path.string());
  return file.option.empty() ? "the input " + name : file.option + " " + name;
}

}  // namespace

void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) {
      throw Error(ErrorCode::bad_call, "the name of the file is empty; give one", output->option);
    }
    const auto is_output = [&](const NamedFile& other) { return is_same_file(output->path, other.path); };
    auto same = std::find_if(inputs.begin(), inputs.end(), is_output);
    if (same == inputs.end()) {
      same = std::find_if(outputs.begin(), output, is_output);
      if (same == output) continue;
    }
    throw Error(
        ErrorCode::bad_call,
        fmt::format("{} is the same file as {}; name another one", io::quote(output->path.string()), described(*same)),
        output->option);
  }
}

void require_apart(const CLI::App& verb) {
  std::vector<NamedFile> inputs, outputs{{"standard output", standard_output}};
  for (const CLI::Option* option : verb.get_options()) {
    const std::string name = option->get_lnames().empty() ? "" : "--" + option->get_lnames().front();
    if (is_in(words, name)) continue;
    for (const std::string& value : option->results()) {
      if (is_in(output_options, name)) {
        outputs.push_back({name, value});
        continue;
      }
      for (const std::string& file : {value, value.substr(0, value.rfind('@'))}) {  // FILE@POSE
        if (!file.empty() && file != "-") inputs.push_back({name, file});
      }
    }
  }
  require_apart(inputs, outputs);
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
    if (option == nullptr || !is_in(option->results(), "-")) continue;
    if (!first.empty()) {
      throw Error(ErrorCode::bad_call, "standard output is taken by " + first + "; name a file", std::string(name));
    }
    first = name;
    takes = true;
  }
  return takes;
}

}  // namespace sunder::cli
