// Objects of three numbers out of CSV: circles "x,y,r" and half-planes "a,b,c".
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// T1. There is a row; its numbers are finite.
// T2. name and line have an entry for each row. So has group where one was asked for, a position in groups.
struct TripleFile {
  std::vector<std::array<double, 3>> rows;
  std::vector<std::string> name;    // what the file gives, else the row's number, counted from 1
  std::vector<std::uint32_t> line;  // of the file, from 1
  std::vector<std::uint32_t> group;
  std::vector<std::string> groups;  // the values of the column, in the order in which they come
};

// What the three numbers are, for messages.
struct TripleKind {
  std::string_view columns;  // "x,y,r"
  std::string_view object;   // "circle"
};
inline constexpr TripleKind circle_rows{"x,y,r", "circle"};
inline constexpr TripleKind half_plane_rows{"a,b,c", "half-plane"};

// Reads the file whole: three numbers a line and, if you like, a name as the fourth field; a first line of names is
// skipped, empty lines are. Where the first line has a semicolon, semicolons part the fields. A field may stand in
// quotes, but hold none. Numbers are rounded once to the nearest double.
// Where the column of a group is named, the first line has to name it, and any columns may follow the first three; the
// name is the one named "name", else the fourth.
// Throws Error bad_file: "FILE:LINE: what; remedy"; bad_call where no column after the third has the group's name.
// Cost: linear, with a group O(N log N).
TripleFile read_triples(const std::filesystem::path& path, const TripleKind& kind, const std::string& group = {},
                        const std::function<void(double)>& progress = nullptr);

// As read_triples, from memory. place: the file's name, for messages.
TripleFile parse_triples(std::string_view text, std::string_view place, const TripleKind& kind,
                         const std::string& group = {}, const std::function<void(double)>& progress = nullptr);

}  // namespace sunder::io
