// Whole files, in and out.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// The bytes of the file; of "-", those of standard input. Pipes and devices are read to their end, up to 256 MiB.
// Throws Error bad_file, "FILE: what is wrong; remedy": the name is empty, there is no such file, it is a folder, it
// cannot be opened or read, it is empty, or it does not fit into memory.
// inputs: where given, the name and the SHA-256 of what was read are added, unless they stand there already; standard
// input, by either name, is named "-". Costs about as much as reading text.
std::string read_file(const std::filesystem::path& path, InputFiles* inputs = nullptr);

// For files that other files name: throws Error bad_file where it is a pipe or a device, so that no name in a file
// makes a call wait for the one or read the other. What does not exist is left to who reads it.
void require_regular(const std::filesystem::path& path);

// Is there a regular file of this name?
bool is_file(const std::filesystem::path& path);

// While one of these is alive, files have other names on this thread: read_file and is_file know the names given here,
// and no others. So an answer is made again from files that are elsewhere now, and nothing else is read.
// One at a time on a thread; other threads read what they read before.
class GivenFiles {
 public:
  struct File {
    std::string name;          // "-": standard input
    const std::string* bytes;  // which outlive it
  };

  explicit GivenFiles(std::vector<File> files);
  ~GivenFiles();
  GivenFiles(const GivenFiles&) = delete;
  GivenFiles& operator=(const GivenFiles&) = delete;

  // The one that is alive; null: none is, and names are those of files.
  static const GivenFiles* now();

  // Null: there is none of that name.
  const std::string* bytes_of(const std::filesystem::path& name) const;
  // The name that ends with these folders and this file: "robots/arm/link.stl" ends with "arm/link.stl". Empty where
  // none does, or several do.
  std::filesystem::path name_with_end(const std::filesystem::path& end) const;

 private:
  std::vector<File> files_;
};

// A file that is written piece by piece and takes its name at the end: all of it, or, when anything fails, nothing
// (what was there before stays, and no other file is left behind).
//   O1. It is written to a new file in the same folder, which takes the name in commit(). Where that is not called, the
//       new file is removed. Permissions of a file that is replaced are kept, and a symbolic link is followed.
//   O2. What is no regular file (/dev/stdout, a pipe) is written to directly; "-" is standard output, whatever that is.
//   O3. remove_unfinished_files() removes the new files of up to 16 that are being written.
// Not promised: that the text survives a power cut right after the return.
// Each throws Error bad_file: "FILE: what is wrong; remedy".
class OutputFile {
 public:
  // instead: where given, what takes the text, and no file is made.
  explicit OutputFile(const std::filesystem::path& path, std::function<void(std::string_view)> instead = nullptr);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  void commit();  // once, after the last write

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  // A place for the new file's name where remove_unfinished_files() finds it.
  class Slot {
   public:
    Slot();
    ~Slot();
    Slot(const Slot&) = delete;
    Slot& operator=(const Slot&) = delete;
    void set(const std::string& name);

   private:
    std::size_t number_;
  };

  void create();

  std::filesystem::path path_, target_, temporary_;  // as given; what takes the text; the new file, if there is one
  std::filesystem::perms permissions_ = std::filesystem::perms::unknown;  // to be kept
  Slot slot_;
  std::function<void(std::string_view)> instead_;
  std::unique_ptr<std::FILE, Close> file_;
};

// Puts the text under this name, as OutputFile does.
void write_file_atomically(const std::filesystem::path& path, std::string_view text,
                           std::function<void(std::string_view)> instead = nullptr);

// Removes the new files that are being written by this process, at this moment. For handlers of signals that end the
// process: it calls nothing but unlink().
void remove_unfinished_files() noexcept;

}  // namespace sunder::io
