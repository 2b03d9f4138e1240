#include <cli/common.h>
#include <cli/outputs.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace sunder::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> output_options{"--certificate", "--csv", "--geojson", "--svg", "--out"};
constexpr const char *standard_input = "/dev/stdin", *standard_output = "/dev/stdout", *nowhere = "/dev/null";
constexpr std::string_view stream = "-";

template <class List>
bool is_in(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// What a path leads to, if there is something.
std::optional<struct stat> found(const fs::path& path) {
  struct stat info = {};
  if (stat(path.c_str(), &info) != 0) return std::nullopt;
  return info;
}

bool is_same(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

bool is_same_file(const fs::path& a, const fs::path& b) {
  const auto found_a = found(a), found_b = found(b), found_nowhere = found(nowhere);
  if (found_a && found_b) return is_same(*found_a, *found_b) && !(found_nowhere && is_same(*found_a, *found_nowhere));
  if (found_a || found_b) return false;
  std::error_code problem;
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, problem), problem);
  const fs::path whole_b = fs::weakly_canonical(fs::absolute(b, problem), problem);
  return !whole_a.empty() && whole_a == whole_b;
}

fs::path input_of(const fs::path& path) { return path == stream ? fs::path(standard_input) : path; }
fs::path output_of(const fs::path& path) { return path == stream ? fs::path(standard_output) : path; }

// Who types at a terminal and reads there gives one device two names.
bool is_input(const fs::path& output, const fs::path& input) {
  const auto info = found(output);
  const bool is_terminal = info && (S_ISCHR(info->st_mode) || S_ISSOCK(info->st_mode));
  return !is_terminal && is_same_file(output, input);
}

std::string described(const NamedFile& file) {
  const std::string name = file.path == stream ? "-" : io::quote(file.path.string());
  return file.option.empty() ? "the input " + name : file.option + " " + name;
}

// "cube.obj" of "cube.obj@1,0,0".
std::string without_pose(const std::string& word) { return word.substr(0, word.rfind('@')); }

std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? "" : "--" + option.get_lnames().front();
}

// Words of --allow are kinds, names, and files.
bool reads_files(const CLI::Option& option) {
  return option.get_lnames().empty() || option.get_type_name() == "FILE" || option.get_type_name() == "WHAT";
}

bool is_allowed_kind(const std::string& word) {
  return word == "adjacent" || word == "touch" || (word.find(',') != std::string::npos && !found(word));
}

void require_one_reader(const std::vector<NamedFile>& inputs) {
  const auto reads = [](const NamedFile& file) { return file.path == stream || file.path == standard_input; };
  if (std::count_if(inputs.begin(), inputs.end(), reads) < 2) return;
  throw Error(ErrorCode::bad_call, "standard input is named twice, and can be read once; name a file", "-");
}

}  // namespace

void require_apart(const std::vector<NamedFile>& inputs, std::vector<NamedFile> outputs) {
  const NamedFile report{"standard output", stream};
  const auto is_stream = [](const NamedFile& file) { return file.path == stream; };
  const bool is_taken = std::any_of(outputs.begin(), outputs.end(), is_stream);
  if (!is_taken && !is_quiet()) outputs.insert(outputs.begin(), report);
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) {
      throw Error(ErrorCode::bad_call, "the name of the file is empty; give one", output->option);
    }
    const fs::path path = output_of(output->path);
    const auto is_read = [&](const NamedFile& input) { return is_input(path, input_of(input.path)); };
    auto same = std::find_if(inputs.begin(), inputs.end(), is_read);
    if (same == inputs.end()) {
      same = std::find_if(outputs.begin(), output,
                          [&](const NamedFile& other) { return is_same_file(path, output_of(other.path)); });
      if (same == output) continue;
    } else if (is_same_file(path, standard_output)) {
      leave_standard_output();
    }
    throw Error(ErrorCode::bad_call,
                fmt::format("{} is the same file as {}; name another one",
                            output->path == stream ? "it" : io::quote(output->path.string()), described(*same)),
                output->option);
  }
}

void require_apart(const CLI::App& verb) {
  std::vector<NamedFile> inputs, outputs;
  for (const CLI::Option* option : verb.get_options()) {
    const std::string name = name_of(*option);
    for (const std::string& value : option->results()) {
      if (is_in(output_options, name)) {
        outputs.push_back({name, value});
      } else if (reads_files(*option) && !(option->get_type_name() == "WHAT" && is_allowed_kind(value))) {
        const std::string file = name.empty() && !found(value) ? without_pose(value) : value;
        if (!file.empty()) inputs.push_back({name, file});
      }
    }
  }
  require_one_reader(inputs);
  require_apart(inputs, std::move(outputs));
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
      if (!file.empty() && is_input(standard_output, input_of(file))) return true;
    }
  }
  return false;
}

}  // namespace sunder::cli
