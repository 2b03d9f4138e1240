// ZIP archives in memory: the files in them by name. For readers of packages (3MF).
// Source: PKWARE's APPNOTE.TXT 6.3.10, sections 4.3 to 4.5; RFC 1951 (Deflate, by zlib).
#pragma once

#include <sunder/base/error.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// Read: files that are stored or deflated, also with their sizes behind them (streams), or with sizes of 64 bits
// (ZIP64). What the central directory at the end says of a file holds.
// Refused: files that are encrypted or compressed otherwise, archives of several volumes.
class ZipArchive {
 public:
  // All that is read of an archive of n bytes is at most free_bytes + bytes_per_byte * n bytes: Deflate can make a
  // thousand bytes of one, so that a small file would fill the memory. Text of a mesh gives about 10 bytes a byte.
  static constexpr std::size_t free_bytes = std::size_t{1} << 16, bytes_per_byte = 64;

  // place: the file's name, for messages; both must outlive this. Throws Error bad_file: the archive is cut off or
  // damaged. Cost: linear in the number of files in it.
  ZipArchive(std::string_view bytes, std::string_view place);

  // The bytes of this file; nothing where there is none. Capital letters count as small ones, as packages have it
  // (ECMA-376 part 2). Throws Error bad_file: the name stands twice, or the file cannot be read or is damaged, by its
  // size or checksum. Cost: linear in the number of files, and in the size of this one.
  std::optional<std::string> read(std::string_view name);

 private:
  struct Entry {
    std::string_view name;
    std::uint16_t flags = 0, method = 0;
    std::uint32_t checksum = 0;
    std::uint64_t packed = 0, size = 0, offset = 0;
  };

  template <class Number>
  Number number(std::uint64_t at) const;  // requires that it is there
  [[noreturn]] void fail(std::string_view what) const;

  void read_directory();
  Entry read_entry(std::uint64_t at, std::uint64_t end) const;
  std::string_view packed_bytes(const Entry& entry) const;
  std::string inflated(const Entry& entry, std::string_view packed) const;

  std::string_view bytes_, place_;
  std::vector<Entry> entries_;
  std::uint64_t left_;  // to be read yet
};

}  // namespace sunder::io
