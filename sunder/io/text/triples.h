// Objects of three numbers out of CSV: circles "x,y,r" and half-planes "a,b,c".
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/text/property.h>
#include <sunder/planar/object/discs.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// T1. There is a row; its numbers are finite.
// T2. name and line have an entry for each row. So has group where one was asked for, a position in groups; and
//     properties where some were.
struct TripleFile {
  std::vector<std::array<double, 3>> rows;
  std::vector<std::string> name;    // what the file gives, else the row's number, counted from 1
  std::vector<std::uint32_t> line;  // of the file, from 1
  std::vector<std::uint32_t> group;
  std::vector<std::string> groups;  // the values of the column, in the order in which they come
  std::vector<PropertyValues> properties;
};

// What the three numbers are, for messages.
struct TripleKind {
  std::array<std::string_view, 3> columns;  // "x", "y", "r"
  std::array<std::string_view, 2> strange;  // columns that would make them something else
  std::string_view object;                  // "circle"
};
inline constexpr TripleKind circle_rows{{"x", "y", "r"}, {"z", "c"}, "circle"};
inline constexpr TripleKind half_plane_rows{{"a", "b", "c"}, {"d", "r"}, "half-plane"};

// What is asked of a reader: columns by their names.
struct TripleOptions {
  std::string group{};                             // to group by; empty: none
  std::string name{};                              // to name by; empty: the one told below
  std::vector<std::string> properties{};           // that are told of each row
  std::function<void(double)> progress = nullptr;  // called now and then with the part that is read, 0 to 1
  InputFiles* inputs = nullptr;                    // as of read_file
};

// Reads the file whole: three numbers a record and, if you like, a name as the fourth field. Where a first line names
// the columns, the three are found by their names, in any order, and any others may stand beside them; the name is the
// one named "name" or "id" (also Name, NAME, ...), else the first other. Names that do not hold the three are refused.
// Splitting as in csv.h. Numbers are rounded once to the nearest double.
// Throws Error bad_file: "FILE:LINE: what; remedy"; bad_call where there is no column that is asked for.
// Cost: linear, with a group O(N log N).
TripleFile read_triples(const std::filesystem::path& path, const TripleKind& kind, const TripleOptions& options = {});

// As read_triples, from memory. place: the file's name, for messages.
TripleFile parse_triples(std::string_view text, std::string_view place, const TripleKind& kind,
                         const TripleOptions& options = {});

// Circles, with their insides. Throws Error as read_triples, and bad_file for a negative radius.
struct CirclesFile {
  TripleFile file;
  planar::Discs circles;
};
CirclesFile read_circles(const std::filesystem::path& path, const TripleOptions& options = {});

}  // namespace sunder::io
