// For tests and fuzzers: ZIP archives, made without the reader's code and without zlib.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

struct ZipMade {
  std::string name, text;
  bool is_deflated = false;  // as blocks that are stored
  std::uint16_t flags = 0, method = is_deflated ? 8 : 0;
};

// Bit by bit.
inline std::uint32_t checksum_made(std::string_view text) {
  std::uint32_t rest = 0xffffffff;
  for (const char c : text) {
    rest ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest % 2 == 1 ? 0xedb88320 : 0);
  }
  return ~rest;
}

inline std::string little_endian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xff);
  return text;
}

// Blocks of at most 65,535 bytes, the last one marked; each with its length, and the complement of it.
inline std::string deflate_made(std::string_view text) {
  std::string packed;
  do {
    const std::string_view block = text.substr(0, 0xffff);
    text.remove_prefix(block.size());
    packed += text.empty() ? '\1' : '\0';
    packed += little_endian(block.size(), 2) + little_endian(~std::uint64_t{block.size()}, 2) + std::string(block);
  } while (!text.empty());
  return packed;
}

// is_64: as streams are written, with sizes behind the files, and in fields of 64 bits at the end.
inline std::string zip_made(const std::vector<ZipMade>& files, bool is_64 = false) {
  std::string all, directory;
  const std::string none = little_endian(is_64 ? 0xffffffff : 0, 4);
  for (const ZipMade& file : files) {
    const std::string packed = file.is_deflated ? deflate_made(file.text) : file.text;
    const std::string kind =
        little_endian(file.flags | (is_64 ? 8 : 0), 2) + little_endian(file.method, 2) + std::string(4, '\0');
    const std::string sizes = little_endian(packed.size(), 4) + little_endian(file.text.size(), 4);
    const std::string checksum = little_endian(checksum_made(file.text), 4), name = little_endian(file.name.size(), 2);
    const std::string wide = is_64 ? little_endian(1, 2) + little_endian(24, 2) + little_endian(file.text.size(), 8) +
                                         little_endian(packed.size(), 8) + little_endian(all.size(), 8)
                                   : "";
    directory += "PK\1\2" + std::string(4, '\0') + kind + checksum + (is_64 ? none + none : sizes) + name +
                 little_endian(wide.size(), 2) + std::string(10, '\0') + (is_64 ? none : little_endian(all.size(), 4)) +
                 file.name + wide;
    all += "PK\3\4" + std::string(2, '\0') + kind + (is_64 ? std::string(12, '\0') : checksum + sizes) + name +
           std::string(2, '\0') + file.name + packed;
    if (is_64) all += "PK\7\x08" + checksum + little_endian(packed.size(), 8) + little_endian(file.text.size(), 8);
  }
  const std::size_t begin = all.size(), end = begin + directory.size();
  all += directory;
  if (is_64) {
    all += "PK\6\6" + little_endian(44, 8) + std::string(12, '\0') + little_endian(files.size(), 8) +
           little_endian(files.size(), 8) + little_endian(directory.size(), 8) + little_endian(begin, 8);
    all += "PK\6\7" + std::string(4, '\0') + little_endian(end, 8) + little_endian(1, 4);
  }
  const std::string count = little_endian(is_64 ? 0xffff : files.size(), 2);
  return all + "PK\5\6" + std::string(4, '\0') + count + count +
         (is_64 ? none + none : little_endian(directory.size(), 4) + little_endian(begin, 4)) + std::string(2, '\0');
}

// A package of 3MF around a model.
inline std::string package_made(std::string_view model, const std::vector<ZipMade>& others = {}, bool is_64 = false) {
  std::vector<ZipMade> files{
      {"_rels/.rels",
       "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
       "Target=\"/3D/3dmodel.model\" Id=\"r\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
       "</Relationships>"},
      {"3D/3dmodel.model", std::string(model), true}};
  files.insert(files.end(), others.begin(), others.end());
  return zip_made(files, is_64);
}

}  // namespace sunder::io
