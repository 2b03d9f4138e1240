#include <sunder/base/error.h>
#include <sunder/io/csv.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/io/triples.h>

#include <fmt/format.h>

#include <limits>
#include <map>
#include <utility>

namespace sunder::io {

namespace {

using Fields = std::vector<std::string_view>;

class Triples {
 public:
  Triples(std::string_view place, const TripleKind& kind, const std::string& group)
      : place_(place), kind_(kind), group_(group) {}

  void add_line(const Fields& fields, std::uint32_t line, bool first) {
    line_ = line;
    const bool names = first && are_names(fields, 3);
    if (first && !group_.empty()) choose_columns(names ? fields : Fields());
    check_count(fields.size());
    if (!names) add(fields);
  }

  TripleFile file;

 private:
  [[noreturn]] void fail(const std::string& what) const { fail_line(place_, line_, what); }

  // names: of the columns; empty where there are none.
  void choose_columns(const Fields& names) {
    std::string known;
    for (std::size_t k = 3; k < names.size(); ++k) {
      if (k < 20) known += fmt::format("{}{}", known.empty() ? "" : ", ", shorten(names[k]));
      if (names[k] == "name") name_column_ = k;
      if (names[k] != group_) continue;
      if (group_column_ > 0) fail(fmt::format("two columns are named {}; rename one", quote(group_)));
      group_column_ = k;
    }
    columns_ = names.size();
    if (group_column_ > 0) return;
    throw Error(ErrorCode::bad_call,
                fmt::format("there is no column {} to group by; {}", quote(group_),
                            known.empty() ? fmt::format("a first line has to name the columns after {}", kind_.columns)
                                          : "there are " + one_line(known)),
                one_line(place_));
  }

  void check_count(std::size_t count) const {
    if (columns_ > 0 && count != columns_) {
      fail(fmt::format("has {} fields, but the line of names has {}; give the same number", count, columns_));
    }
    if (count < 3 || (count > 4 && columns_ == 0)) {
      fail(fmt::format("has {} fields; give {} and, if you like, a name", count, kind_.columns));
    }
  }

  void add(const Fields& fields) {
    std::array<double, 3> row{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (const char* problem = parse_number(fields[k], row[k])) {
        fail(fmt::format("{} {}", quote(fields[k]), problem));
      }
    }
    if (file.rows.size() == std::numeric_limits<std::uint32_t>::max()) fail("has too many rows before; split the file");
    file.rows.push_back(row);
    file.line.push_back(line_);
    const bool named = name_column_ < fields.size() && !fields[name_column_].empty();
    file.name.push_back(named ? one_line(fields[name_column_]) : std::to_string(file.rows.size()));
    if (group_column_ == 0) return;
    const std::string_view value = fields[group_column_];
    if (value.empty()) fail(fmt::format("has no value in the column {}; give one", quote(group_)));
    const auto [at, is_new] = positions_.emplace(value, static_cast<std::uint32_t>(file.groups.size()));
    if (is_new) file.groups.push_back(one_line(value));
    file.group.push_back(at->second);
  }

  std::string_view place_;
  const TripleKind& kind_;
  const std::string& group_;
  std::uint32_t line_ = 0;
  std::size_t columns_ = 0;  // that each line must have; 0: three or four
  std::size_t name_column_ = 3, group_column_ = 0;
  std::map<std::string, std::uint32_t, std::less<>> positions_;  // of a group in file.groups
};

}  // namespace

TripleFile parse_triples(std::string_view text, std::string_view place, const TripleKind& kind,
                         const std::string& group, const std::function<void(double)>& progress) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  Triples triples(place, kind, group);
  Fields fields;
  char separator = ',';
  bool first = true;
  for_each_line(text, progress, [&](std::string_view line, std::uint32_t number) {
    if (first && line.find(';') != std::string_view::npos) separator = ';';
    if (!split_fields(line, separator, fields)) {
      fail_line(place, number,
                fmt::format("{} has a quote within; write fields without separators and quotes", quote(fields.back())));
    }
    triples.add_line(fields, number, first);
    first = false;
  });
  if (triples.file.rows.empty()) fail_file(place, fmt::format("has no {}s; give lines {}", kind.object, kind.columns));
  return std::move(triples.file);
}

TripleFile read_triples(const std::filesystem::path& path, const TripleKind& kind, const std::string& group,
                        const std::function<void(double)>& progress) {
  return parse_triples(read_file(path), path.string(), kind, group, progress);
}

}  // namespace sunder::io
