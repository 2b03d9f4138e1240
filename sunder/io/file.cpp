#include <sunder/io/file.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <memory>
#include <new>
#include <random>
#include <stdexcept>
#include <system_error>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

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

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// False (and errno) on failure.
bool write_and_close(std::unique_ptr<std::FILE, Close> file, std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  const int error = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (!written) errno = error;
  return written && closed;
}

// Removes its file unless told to keep it.
struct Temporary {
  fs::path path;
  bool keep = false;
  explicit Temporary(fs::path name) : path(std::move(name)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    if (!keep) fs::remove(path, ignored);
  }
};

}  // namespace

std::string read_file(const fs::path& path) {
  if (path.empty()) fail_path("(no name)", "the name of the file is empty; give one");
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (status.type() == fs::file_type::not_found) fail_path(path, "no such file; check the name and the folder");
  if (status.type() == fs::file_type::directory) fail_path(path, "is a folder; name a file");
  const bool regular = status.type() == fs::file_type::regular;

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    const int error = errno != 0 ? errno : problem.value();
    fail_path(path, fmt::format("cannot be opened ({}); check the permissions", reason(error)));
  }

  std::string bytes;
  try {
    const std::uintmax_t size = regular ? fs::file_size(path, problem) : 0;
    append_all(file, path, regular, problem ? 0 : static_cast<std::size_t>(size), bytes);
  } catch (const std::bad_alloc&) {
    fail_path(path, "does not fit into memory; split it");
  } catch (const std::length_error&) {
    fail_path(path, "does not fit into memory; split it");
  }
  if (bytes.empty()) fail_path(path, "the file is empty; export or copy it again");
  return bytes;
}

void write_file_atomically(const fs::path& path, std::string_view text) {
  if (path.empty()) fail_path("(no name)", "the name of the file is empty; give one");
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (status.type() == fs::file_type::directory) fail_path(path, "is a folder; name a file");
  const bool replaces = status.type() == fs::file_type::regular;

  if (fs::exists(status) && !replaces) {
    std::unique_ptr<std::FILE, Close> device(std::fopen(path.string().c_str(), "wb"));
    if (!device || !write_and_close(std::move(device), text)) {
      fail_path(path, fmt::format("cannot be written ({}); name a regular file", reason(errno)));
    }
    return;
  }

  const fs::path canonical = replaces ? fs::canonical(path, problem) : path;
  const fs::path target = problem && replaces ? path : canonical;

  // "x" makes a new file or fails, so that nothing of anybody else's is written over.
  std::random_device random;
  constexpr int attempts = 16;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    fs::path name = target.parent_path() / fmt::format(".{:08x}{:08x}.sunder", random(), random());
    std::unique_ptr<std::FILE, Close> file(std::fopen(name.string().c_str(), "wbx"));
    if (!file) {
      if (errno == EEXIST) continue;
      fail_path(path, fmt::format("no file can be made in its folder ({}); check that the folder exists and is yours "
                                  "to write to",
                                  reason(errno)));
    }
    Temporary temporary(std::move(name));
    if (!write_and_close(std::move(file), text)) {
      fail_path(path, fmt::format("cannot be written ({}); check the space on the disk", reason(errno)));
    }
    if (replaces) fs::permissions(temporary.path, status.permissions(), problem);
    fs::rename(temporary.path, target, problem);
    if (problem) fail_path(path, fmt::format("cannot be put in place ({}); check the name", problem.message()));
    temporary.keep = true;
    return;
  }
  fail_path(path, "no new name was found in its folder; try again");
}

}  // namespace sunder::io
