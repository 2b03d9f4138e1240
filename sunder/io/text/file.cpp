#include <sunder/base/contract.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/sha256.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <new>
#include <random>
#include <stdexcept>
#include <system_error>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* standard_input = "/dev/stdin";
constexpr std::size_t largest_stream = std::size_t{1} << 28;
constexpr std::size_t stream_piece = std::size_t{1} << 20;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_path(const fs::path& path, const std::string& text) { fail_file(path.string(), text); }

void append_all(std::ifstream& file, const fs::path& path, bool regular, std::size_t expected, std::string& bytes) {
  // One byte more than expected, so that the end shows in the first read.
  std::size_t piece = regular ? expected + 1 : stream_piece;
  for (;;) {
    const std::size_t before = bytes.size();
    bytes.resize(before + piece);
    errno = 0;
    file.read(bytes.data() + before, static_cast<std::streamsize>(piece));
    bytes.resize(before + static_cast<std::size_t>(file.gcount()));
    if (file.bad()) {
      const std::string why = errno == 0 ? "" : " (" + reason(errno) + ")";
      fail_path(path, fmt::format("cannot be read{}; check the disk and the permissions", why));
    }
    if (file.eof()) return;
    if (!regular && bytes.size() > largest_stream) {
      fail_path(path, "gives more than 256 MiB; read from a regular file");
    }
    piece = stream_piece;
  }
}

void add_to(InputFiles& inputs, const fs::path& path, std::string_view bytes) {
  const InputFile file{path == standard_input ? "-" : path.string(), sha256(bytes)};
  if (std::find(inputs.begin(), inputs.end(), file) == inputs.end()) inputs.push_back(file);
}

// The names of files that are being written, where a handler of signals may read them.
struct Unfinished {
  std::atomic<bool> taken{false}, named{false};
  std::array<char, 4096> name{};
};
std::array<Unfinished, 16> unfinished;
constexpr std::size_t no_slot = unfinished.size();

thread_local const GivenFiles* given_files = nullptr;

}  // namespace

GivenFiles::GivenFiles(std::vector<File> files) : files_(std::move(files)) {
  SUNDER_REQUIRE(given_files == nullptr);
  given_files = this;
}

GivenFiles::~GivenFiles() { given_files = nullptr; }

const GivenFiles* GivenFiles::now() { return given_files; }

const std::string* GivenFiles::bytes_of(const fs::path& name) const {
  const std::string wanted = name == standard_input ? "-" : name.string();
  const auto found = std::find_if(files_.begin(), files_.end(), [&](const File& file) { return file.name == wanted; });
  return found == files_.end() ? nullptr : found->bytes;
}

fs::path GivenFiles::name_with_end(const fs::path& end) const {
  const std::vector<fs::path> wanted(end.begin(), end.end());
  fs::path result;
  for (const File& file : files_) {
    const fs::path name = file.name;
    const std::vector<fs::path> parts(name.begin(), name.end());
    if (parts.size() < wanted.size() || !std::equal(wanted.rbegin(), wanted.rend(), parts.rbegin())) continue;
    if (!result.empty()) return {};
    result = name;
  }
  return result;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  if (given_files == nullptr) return fs::is_regular_file(path, ignored);
  return given_files->bytes_of(path) != nullptr;
}

std::string read_file(const fs::path& path, InputFiles* inputs) {
  if (path.empty()) fail_path("(no name)", "the name of the file is empty; give one");
  if (given_files != nullptr) {
    const std::string* bytes = given_files->bytes_of(path);
    if (bytes == nullptr) fail_path(path, "is none of the files that are given; give all");
    if (inputs != nullptr) add_to(*inputs, path, *bytes);
    return *bytes;
  }
  const fs::path source = path == "-" ? standard_input : path;
  std::error_code problem;
  const fs::file_status status = fs::status(source, problem);
  if (status.type() == fs::file_type::not_found) fail_path(path, "no such file; check the name and the folder");
  if (status.type() == fs::file_type::directory) fail_path(path, "is a folder; name a file");
  const bool regular = status.type() == fs::file_type::regular;

  errno = 0;
  std::ifstream file(source, std::ios::binary);
  if (!file) {
    const int error = errno != 0 ? errno : problem.value();
    fail_path(path, fmt::format("cannot be opened ({}); check the permissions", reason(error)));
  }

  std::string bytes;
  try {
    const std::uintmax_t size = regular ? fs::file_size(source, problem) : 0;
    append_all(file, path, regular, problem ? 0 : static_cast<std::size_t>(size), bytes);
  } catch (const std::bad_alloc&) {
    fail_path(path, "does not fit into memory; split it");
  } catch (const std::length_error&) {
    fail_path(path, "does not fit into memory; split it");
  }
  if (bytes.empty()) fail_path(path, "the file is empty; export or copy it again");
  if (inputs != nullptr) add_to(*inputs, path, bytes);
  return bytes;
}

void require_regular(const fs::path& path) {
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) return;
  fail_path(path, "is a pipe or a device, and a file that another one names is a regular file; copy it to one");
}

OutputFile::Slot::Slot() : number_(no_slot) {
  for (std::size_t k = 0; k < unfinished.size() && number_ == no_slot; ++k) {
    if (!unfinished[k].taken.exchange(true)) number_ = k;
  }
}

OutputFile::Slot::~Slot() {
  if (number_ == no_slot) return;
  unfinished[number_].named = false;
  unfinished[number_].taken = false;
}

void OutputFile::Slot::set(const std::string& name) {
  if (number_ == no_slot || name.size() >= unfinished[number_].name.size()) return;
  unfinished[number_].named = false;
  name.copy(unfinished[number_].name.data(), name.size());
  unfinished[number_].name.at(name.size()) = '\0';
  unfinished[number_].named = true;
}

OutputFile::OutputFile(const fs::path& path, std::function<void(std::string_view)> instead)
    : path_(path), instead_(std::move(instead)) {
  if (path.empty()) fail_path("(no name)", "the name of the file is empty; give one");
  if (instead_) return;
  if (path == "-") {
    errno = 0;
    if (const int copy = dup(STDOUT_FILENO); copy >= 0) file_.reset(fdopen(copy, "wb"));
    if (!file_) fail_path(path, fmt::format("standard output cannot be written ({})", reason(errno)));
    return;
  }
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (status.type() == fs::file_type::directory) fail_path(path, "is a folder; name a file");
  const bool replaces = status.type() == fs::file_type::regular;
  if (fs::exists(status) && !replaces) {
    file_.reset(std::fopen(path.string().c_str(), "wb"));
    if (!file_) fail_path(path, fmt::format("cannot be written ({}); name a regular file", reason(errno)));
    return;
  }
  if (replaces) {
    permissions_ = status.permissions();
    target_ = fs::canonical(path, problem);
  }
  if (target_.empty()) target_ = path;
  create();
}

void OutputFile::create() {
  // "x" makes a new file or fails, so that nothing of anybody else's is written over.
  std::random_device random;
  constexpr int attempts = 16;
  for (int attempt = 0; attempt < attempts && !file_; ++attempt) {
    temporary_ = target_.parent_path() / fmt::format(".{:08x}{:08x}.sunder", random(), random());
    slot_.set(temporary_.string());
    file_.reset(std::fopen(temporary_.string().c_str(), "wbx"));
    if (file_ || errno == EEXIST) continue;
    const int error = errno;
    temporary_.clear();
    fail_path(path_, fmt::format("no file can be made in its folder ({}); check that the folder exists and is yours "
                                 "to write to",
                                 reason(error)));
  }
  if (!file_) fail_path(path_, "no new name was found in its folder; try again");
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void OutputFile::write(std::string_view text) {
  if (instead_) return instead_(text);
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size()) return;
  fail_path(path_, fmt::format("cannot be written ({}); check where it goes and the space there", reason(errno)));
}

void OutputFile::commit() {
  if (instead_) return;
  errno = 0;
  if (std::fclose(file_.release()) != 0) {
    fail_path(path_, fmt::format("cannot be written ({}); check where it goes and the space there", reason(errno)));
  }
  if (temporary_.empty()) return;
  std::error_code problem;
  if (permissions_ != fs::perms::unknown) fs::permissions(temporary_, permissions_, problem);
  fs::rename(temporary_, target_, problem);
  if (problem) fail_path(path_, fmt::format("cannot be put in place ({}); check the name", problem.message()));
  temporary_.clear();
}

void write_file_atomically(const fs::path& path, std::string_view text, std::function<void(std::string_view)> instead) {
  OutputFile file(path, std::move(instead));
  file.write(text);
  file.commit();
}

void remove_unfinished_files() noexcept {
  for (const Unfinished& file : unfinished) {
    if (file.named) unlink(file.name.data());
  }
}

}  // namespace sunder::io
