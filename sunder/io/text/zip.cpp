#include <sunder/io/text/bytes.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/zip_internal.h>

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <new>

namespace sunder::io {

namespace {

// Records begin with these; what follows are their lengths without names and other fields of any length.
constexpr std::uint32_t local_mark = 0x04034b50, entry_mark = 0x02014b50, end_mark = 0x06054b50;
constexpr std::uint32_t end64_mark = 0x06064b50, locator_mark = 0x07064b50;
constexpr std::size_t local_length = 30, entry_length = 46, end_length = 22, end64_length = 56, locator_length = 20;
constexpr std::size_t longest_comment = 0xffff;

constexpr std::uint16_t is_encrypted = 1, stored = 0, deflated = 8, zip64_field = 1;
constexpr std::uint32_t see_zip64 = 0xffffffff;

constexpr std::string_view copy_again = "export or copy the file again";

bool is_same_name(std::string_view a, std::string_view b) {
  return a.size() == b.size() && in_small_letters(a) == in_small_letters(b);
}

}  // namespace

template <class Number>
Number ZipArchive::number(std::uint64_t at) const {
  return load<Number>(bytes_.data() + at, ByteOrder::little_endian);
}

void ZipArchive::fail(std::string_view what) const { fail_file(place_, fmt::format("{}; {}", what, copy_again)); }

ZipArchive::ZipArchive(std::string_view bytes, std::string_view place)
    : bytes_(bytes), place_(place), left_(free_bytes + bytes_per_byte * bytes.size()) {
  read_directory();
}

void ZipArchive::read_directory() {
  // The end is the last record whose comment ends with the file.
  std::uint64_t end = bytes_.size();
  for (std::uint64_t length = 0; end == bytes_.size(); ++length) {
    if (length > longest_comment || length + end_length > bytes_.size()) {
      fail("is no whole ZIP archive: its directory, which stands at the end, is missing");
    }
    const std::uint64_t at = bytes_.size() - end_length - length;
    if (number<std::uint32_t>(at) == end_mark && number<std::uint16_t>(at + 20) == length) end = at;
  }
  std::uint64_t volume = number<std::uint16_t>(end + 4), volume_of_directory = number<std::uint16_t>(end + 6);
  std::uint64_t count_here = number<std::uint16_t>(end + 8), count = number<std::uint16_t>(end + 10);
  std::uint64_t size = number<std::uint32_t>(end + 12), begin = number<std::uint32_t>(end + 16);
  if (end >= locator_length && number<std::uint32_t>(end - locator_length) == locator_mark) {
    const std::uint64_t at = number<std::uint64_t>(end - locator_length + 8);
    if (end < end64_length || at > end - end64_length || number<std::uint32_t>(at) != end64_mark) {
      fail("its ZIP64 directory is not where the file says");
    }
    volume = number<std::uint32_t>(at + 16);
    volume_of_directory = number<std::uint32_t>(at + 20);
    count_here = number<std::uint64_t>(at + 24);
    count = number<std::uint64_t>(at + 32);
    size = number<std::uint64_t>(at + 40);
    begin = number<std::uint64_t>(at + 48);
  }
  if (volume != 0 || volume_of_directory != 0 || count_here != count) {
    fail_file(place_, "is one of several volumes of a ZIP archive, which is not read; store all in one file");
  }
  if (begin > end || size > end - begin) fail("its ZIP directory is not where the file says");
  for (std::uint64_t at = begin; entries_.size() < count;) {
    entries_.push_back(read_entry(at, begin + size));
    const std::uint64_t others = std::uint64_t{number<std::uint16_t>(at + 30)} + number<std::uint16_t>(at + 32);
    at += entry_length + entries_.back().name.size() + others;
  }
}

ZipArchive::Entry ZipArchive::read_entry(std::uint64_t at, std::uint64_t end) const {
  if (end - at < entry_length || number<std::uint32_t>(at) != entry_mark) fail("its ZIP directory is damaged");
  const std::uint64_t name = number<std::uint16_t>(at + 28), extra = number<std::uint16_t>(at + 30);
  if (name + extra + number<std::uint16_t>(at + 32) > end - at - entry_length) fail("its ZIP directory is damaged");
  Entry entry{bytes_.substr(at + entry_length, name), number<std::uint16_t>(at + 8),  number<std::uint16_t>(at + 10),
              number<std::uint32_t>(at + 16),         number<std::uint32_t>(at + 20), number<std::uint32_t>(at + 24),
              number<std::uint32_t>(at + 42)};
  // A ZIP64 field has those of the three that do not fit, in this order.
  std::uint64_t field = at + entry_length + name;
  const std::uint64_t last = field + extra;
  while (last - field >= 4 && number<std::uint16_t>(field + 2) <= last - field - 4) {
    const std::uint64_t next = field + 4 + number<std::uint16_t>(field + 2);
    if (number<std::uint16_t>(field) == zip64_field) {
      std::uint64_t value = field + 4;
      for (std::uint64_t* number64 : {&entry.size, &entry.packed, &entry.offset}) {
        if (*number64 != see_zip64) continue;
        if (next - value < 8) fail("its ZIP directory is damaged");
        *number64 = number<std::uint64_t>(value);
        value += 8;
      }
    }
    field = next;
  }
  return entry;
}

std::optional<std::string> ZipArchive::read(std::string_view name) {
  const auto has_name = [&](const Entry& entry) { return is_same_name(entry.name, name); };
  const auto found = std::find_if(entries_.begin(), entries_.end(), has_name);
  if (found == entries_.end()) return std::nullopt;
  if (std::find_if(found + 1, entries_.end(), has_name) != entries_.end()) {
    fail_file(place_, fmt::format("holds {} twice; {}", quote(name), copy_again));
  }
  const Entry& entry = *found;
  if ((entry.flags & is_encrypted) != 0) {
    fail_file(place_,
              fmt::format("{} in it is encrypted, which is not read; export it without a password", quote(name)));
  }
  if (entry.method != stored && entry.method != deflated) {
    fail_file(place_, fmt::format("{} in it is compressed by method {}, and only Deflate (8) is read; export it again",
                                  quote(name), entry.method));
  }
  if (entry.size > left_) {
    fail_file(place_, fmt::format("{} in it would give more than {} bytes a byte of the file, which is no text of a "
                                  "mesh; export it again",
                                  quote(name), bytes_per_byte));
  }
  left_ -= entry.size;
  const std::string_view packed = packed_bytes(entry);
  std::string text = entry.method == stored ? std::string(packed) : inflated(entry, packed);
  if (text.size() != entry.size) {
    fail_file(place_, fmt::format("{} in it is damaged: it has {} bytes of {}; {}", quote(name), text.size(),
                                  entry.size, copy_again));
  }
  uLong checksum = 0;
  for (std::size_t at = 0; at < text.size();) {  // lengths there are 32 bits
    const std::size_t length = std::min<std::size_t>(text.size() - at, std::numeric_limits<std::int32_t>::max());
    checksum = crc32(checksum, reinterpret_cast<const Bytef*>(text.data() + at), static_cast<uInt>(length));
    at += length;
  }
  if (checksum != entry.checksum) {
    fail_file(place_, fmt::format("{} in it is damaged: its checksum (CRC-32) is wrong; {}", quote(name), copy_again));
  }
  return text;
}

std::string_view ZipArchive::packed_bytes(const Entry& entry) const {
  const std::uint64_t size = bytes_.size();
  if (entry.offset > size || size - entry.offset < local_length || number<std::uint32_t>(entry.offset) != local_mark) {
    fail_file(place_, fmt::format("{} in it is not where the file says; {}", quote(entry.name), copy_again));
  }
  const std::uint64_t begin =
      entry.offset + local_length + number<std::uint16_t>(entry.offset + 26) + number<std::uint16_t>(entry.offset + 28);
  if (begin > size || entry.packed > size - begin) {
    fail_file(place_, fmt::format("ends inside of {}; {}", quote(entry.name), copy_again));
  }
  return bytes_.substr(begin, entry.packed);
}

std::string ZipArchive::inflated(const Entry& entry, std::string_view packed) const {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();  // negative: no header of zlib's
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ended_at_last(&stream, inflateEnd);
  std::string text;
  std::array<char, 1 << 14> piece;
  int result = Z_OK;
  // Text grows with what is there, whatever size is promised, and by one piece beyond it at most.
  for (std::size_t at = 0; result == Z_OK && text.size() <= entry.size;) {
    if (stream.avail_in == 0) {
      const std::size_t length = std::min(packed.size() - at, piece.size());
      stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data() + at));  // is only read
      stream.avail_in = static_cast<uInt>(length);
      at += length;
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    result = inflate(&stream, Z_NO_FLUSH);
    text.append(piece.data(), piece.size() - stream.avail_out);
  }
  if (result == Z_MEM_ERROR) throw std::bad_alloc();
  if (result != Z_STREAM_END && text.size() <= entry.size) {
    fail_file(place_, fmt::format("{} in it is damaged: it cannot be inflated; {}", quote(entry.name), copy_again));
  }
  return text;
}

}  // namespace sunder::io
