#include <sunder/base/error.h>
#include <sunder/io/text/zip_internal.h>
#include <sunder/io/text/zip_make_test.h>

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace sunder::io {
namespace {

// What is read of the file, or the message.
std::string read_of(std::string_view archive, std::string_view name) {
  try {
    return ZipArchive(archive, "a.zip").read(name).value_or("(none)");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
}

std::string edited(std::string bytes, std::size_t at, std::string_view with) {
  return bytes.replace(at, with.size(), with);
}

const std::string long_text = [] {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += std::to_string(i);
  return text;  // more than a block of Deflate, and than a piece of the reader
}();

TEST(Zip, ReadsWhatIsStoredAndDeflated) {
  for (const bool is_64 : {false, true}) {
    const std::string archive =
        zip_made({{"a/Empty.txt", ""}, {"b", "stored"}, {"c", long_text, true}, {"d", "", true}}, is_64);
    EXPECT_EQ(read_of(archive, "a/empty.TXT"), "");
    EXPECT_EQ(read_of(archive, "b"), "stored");
    EXPECT_EQ(read_of(archive, "c"), long_text);
    EXPECT_EQ(read_of(archive, "d"), "");
    EXPECT_EQ(read_of(archive, "e"), "(none)");
    EXPECT_EQ(read_of("what stands before" + archive, "b").substr(0, 6), "a.zip:") << "offsets are those of the file";
  }
}

TEST(Zip, TheEndMayHaveAComment) {
  std::string archive = zip_made({{"b", "text"}});
  archive.replace(archive.size() - 2, 2, little_endian(27, 2) + "PK\5\6 no end, as lengths say");
  archive.resize(archive.size() - 1);
  EXPECT_NE(read_of(archive, "b").find("is no whole ZIP archive"), std::string::npos);
  EXPECT_EQ(read_of(archive + "y", "b"), "text");
}

TEST(Zip, RefusesWhatIsDamaged) {
  const std::string archive = zip_made({{"b", "stored"}, {"c", "deflated", true}});
  const auto error = [&](std::size_t at, std::string_view with, std::string_view name) {
    return read_of(edited(archive, at, with), name);
  };
  EXPECT_NE(error(archive.find("stored"), "Stored", "b").find("checksum (CRC-32) is wrong"), std::string::npos);
  EXPECT_NE(error(archive.find("deflated") - 2, "xx", "c").find("cannot be inflated"), std::string::npos);
  const std::size_t entry = archive.find("PK\1\2"), end = archive.find("PK\5\6");
  EXPECT_NE(error(entry, "QK", "b").find("directory is damaged"), std::string::npos);
  EXPECT_NE(error(end + 10, "\x03", "b").find("several volumes"), std::string::npos);
  EXPECT_NE(error(end + 8, std::string("\x03\0\x03\0", 4), "b").find("directory is damaged"), std::string::npos);
  EXPECT_NE(error(end + 16, "\xff\xff", "b").find("directory is not where"), std::string::npos);
  EXPECT_NE(error(entry + 42, "\x01", "b").find("'b' in it is not where the file says"), std::string::npos);
  EXPECT_NE(error(entry + 20, "\xff\xff\xff", "b").find("ends inside of 'b'"), std::string::npos);
  EXPECT_NE(error(entry + 24, "\x07", "b").find("has 6 bytes of 7"), std::string::npos);
  EXPECT_NE(error(entry + 24, "\xff\xff\xff", "b").find("more than 64 bytes a byte of the file"), std::string::npos);
  EXPECT_NE(error(entry + 24, "\x05", "b").find("has 6 bytes of 5"), std::string::npos);
}

TEST(Zip, RefusesWhatItDoesNotRead) {
  EXPECT_NE(read_of(zip_made({{"b", "x", false, 1}}), "b").find("'b' in it is encrypted"), std::string::npos);
  EXPECT_NE(read_of(zip_made({{"b", "x", false, 0, 12}}), "b").find("compressed by method 12"), std::string::npos);
  EXPECT_NE(read_of(zip_made({{"b", "x"}, {"B", "y"}}), "b").find("holds 'b' twice"), std::string::npos);
}

// What is promised is refused before anything is made of it; and what is made of all files counts together.
TEST(Zip, ReadsNoMoreThanIsInProportion) {
  const std::string text(ZipArchive::free_bytes, 'x');
  const std::string packed = zip_made({{"b", text, true}});
  ZipArchive archive(packed, "a.zip");
  for (std::size_t i = 0; i <= ZipArchive::bytes_per_byte; ++i) EXPECT_EQ(archive.read("b"), text);
  EXPECT_THROW((void)archive.read("b"), Error);
}

TEST(Zip, SurvivesTruncationAndAnyByte) {
  for (const bool is_64 : {false, true}) {
    const std::string archive = zip_made({{"b", "stored"}, {"c", "deflated", true}}, is_64);
    for (std::size_t size = 0; size < archive.size(); ++size) {
      EXPECT_NE(read_of(archive.substr(0, size), "c"), "deflated") << size;
    }
    for (std::size_t at = 0; at < archive.size(); ++at) {
      for (const char change : {'\1', '\x80', '\xff'}) {
        std::string changed = archive;
        changed[at] = static_cast<char>(changed[at] ^ change);
        const std::string found = read_of(changed, "c");
        EXPECT_TRUE(found == "deflated" || found == "(none)" || found.starts_with("a.zip: ")) << at << ": " << found;
      }
    }
  }
}

}  // namespace
}  // namespace sunder::io
