#include <sunder/ask/outputs.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <sys/stat.h>

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace sunder::ask {

namespace {

namespace fs = std::filesystem;

constexpr const char *standard_input = "/dev/stdin", *standard_output = "/dev/stdout", *nowhere = "/dev/null";
constexpr const char* stream = "-";

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

std::string described(const NamedFile& file) {
  const std::string name = file.path == stream ? "-" : io::quote(file.path.string());
  return file.option.empty() ? "the input " + name : file.option + " " + name;
}

}  // namespace

bool overwrites(const fs::path& output, const fs::path& input) {
  const fs::path written = output_of(output);
  const auto info = found(written);
  // Who types at a terminal and reads there gives one device two names.
  const bool is_terminal = info && (S_ISCHR(info->st_mode) || S_ISSOCK(info->st_mode));
  return !is_terminal && is_same_file(written, input_of(input));
}

void require_apart(Talk& talk, const std::vector<NamedFile>& inputs, std::vector<NamedFile> outputs) {
  const NamedFile report{"standard output", stream};
  const auto is_stream = [](const NamedFile& file) { return file.path == stream; };
  const bool is_taken = std::any_of(outputs.begin(), outputs.end(), is_stream);
  if (!is_taken && !talk.is_quiet()) outputs.insert(outputs.begin(), report);
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) {
      throw Error(ErrorCode::bad_call, "the name of the file is empty; give one", output->option);
    }
    const fs::path path = output_of(output->path);
    const auto is_read = [&](const NamedFile& input) { return overwrites(output->path, input.path); };
    auto same = std::find_if(inputs.begin(), inputs.end(), is_read);
    if (same == inputs.end()) {
      same = std::find_if(outputs.begin(), output,
                          [&](const NamedFile& other) { return is_same_file(path, output_of(other.path)); });
      if (same == output) continue;
    } else if (is_same_file(path, standard_output)) {
      talk.leave_output();
    }
    throw Error(ErrorCode::bad_call,
                fmt::format("{} is the same file as {}; name another one",
                            output->path == stream ? "it" : io::quote(output->path.string()), described(*same)),
                output->option);
  }
}

}  // namespace sunder::ask
