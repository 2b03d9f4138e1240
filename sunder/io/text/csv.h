// Records of CSV text (RFC 4180), and columns by their names. For readers.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/text/property.h>
#include <sunder/io/text/text.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::io {

// Calls of_line(line, number) with each line that is not blank, without blanks around it, and its number, from 1. A
// line ends with LF, CR LF or CR.
template <class OfLine>
void for_each_line(std::string_view text, const OfLine& of_line) {
  std::uint32_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty()) of_line(line, number);
    const bool two = end != std::string_view::npos && text.substr(end, 2) == "\r\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + (two ? 2 : 1));
  }
}

// Walks over the records of CSV text. A record ends with LF, CR LF or CR; blank ones are passed over. Fields are parted
// by commas, or by semicolons where the first record has one outside of quotes. A field in quotes may hold separators,
// line breaks, and quotes, each written twice. Blanks around a field, and around what its quotes hold, are left out.
// Keeps views of `text` and `place`, which must outlive it. Cost: linear.
class CsvReader {
 public:
  using Fields = std::vector<std::string_view>;

  // place: the file's name, for messages. progress, if any, is called now and then with the part done, 0 to 1.
  CsvReader(std::string_view text, std::string_view place, std::function<void(double)> progress = nullptr);

  // Goes to the next record, the first one to begin with; false where there is none.
  // Throws Error bad_file where a quote stands within a field without quotes, or quotes are not closed.
  bool next();

  const Fields& fields() const { return fields_; }  // of this record; valid until next()
  std::uint32_t line() const { return line_; }      // on which it begins, from 1
  bool is_first() const { return records_ == 1; }

  [[noreturn]] void fail(const std::string& what) const { fail_line(place_, line_, what); }

 private:
  void skip_blank_lines();
  void take_break();
  std::string_view quoted_field();
  std::string_view plain_field();

  std::string_view text_, place_;
  std::function<void(double)> progress_;
  std::size_t at_ = 0;
  char separator_ = 0;
  std::uint32_t line_ = 0, next_line_ = 1;
  std::uint64_t records_ = 0;
  Fields fields_;
  std::deque<std::string> unquoted_;  // what fields_ views where quotes were doubled
};

// Is this a record of names? None of the first `count` fields is a number, and the first begins as names do.
bool are_names(const CsvReader::Fields& fields, std::size_t count);

// The column of geometries as WKT, by its name in small letters: wkt, geometry, geom, the_geom; empty where the record
// has no such name, or also x1,y1,x2,y2.
std::string geometry_column(const CsvReader::Fields& names);

// What columns a file has to have, in the order in which they stand where no names say otherwise.
struct CsvColumns {
  std::vector<std::string_view> needed;   // "x1", "y1", "x2", "y2"
  std::vector<std::string_view> strange;  // names that would mean something else: "r"; z, z1, z2 are known
  std::string_view objects;               // for messages: "segments"
};

// Where the columns of a file stand, and what is told with each row: its name, its group, and other columns.
class CsvTable {
 public:
  // name, group, properties: the columns that the caller asks for, by their names; empty for none.
  CsvTable(const CsvColumns& columns, const std::string& name, const std::string& group,
           std::vector<std::string> properties = {})
      : columns_(columns), name_(name), group_(group), properties_(std::move(properties)) {}

  // To be told the first record. True where it holds names; then they say where the needed columns are, small and
  // large letters alike, and any others may stand between them. Else these come first, and a name may follow.
  // Throws Error bad_file where names do not say it, or a column is there twice; bad_call where no column has the
  // name, group or property asked for.
  // by_row: a group "feature", of which there is no column, is each row by itself.
  bool begin(const CsvReader& reader, std::string_view place, bool drop_z, bool by_row = false);

  // Throws Error bad_file where the record has too few or too many fields; a name at its end may be left out.
  void check_count(const CsvReader& reader) const;

  double number(const CsvReader& reader, std::size_t needed) const;  // needed: which of the columns
  std::string_view field(const CsvReader& reader, std::size_t needed) const { return reader.fields()[at_[needed]]; }
  std::string name(const CsvReader& reader) const;  // empty where there is none
  bool groups() const { return group_column_ != none; }
  std::string_view group(const CsvReader& reader) const;  // requires groups(); throws Error bad_file where it is empty
  PropertyValues properties(const CsvReader& reader) const;  // all as text

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t column_of(const CsvReader& reader, std::string_view name) const;
  std::size_t asked_column(const CsvReader& reader, std::string_view place, const std::string& name,
                           std::string_view what_for) const;
  void place_columns(const CsvReader& reader, bool drop_z);
  std::string needed_text() const;
  std::string known_text(const CsvReader::Fields& names) const;

  const CsvColumns& columns_;
  const std::string &name_, &group_;
  std::vector<std::string> properties_;
  std::vector<std::size_t> at_;  // of the needed columns
  std::size_t count_ = 0;        // of all columns, where the first record names them
  bool has_names_ = false;
  std::size_t name_column_ = none, group_column_ = none;
  std::vector<std::size_t> property_columns_;
};

}  // namespace sunder::io
