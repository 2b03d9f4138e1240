#include <sunder/base/error.h>
#include <sunder/io/text/csv.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace sunder::io {

namespace {

bool is_break(char c) { return c == '\n' || c == '\r'; }

bool is_any_of(const std::vector<std::string_view>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// A semicolon where the first record has one outside of quotes, else a comma.
char separator_of(std::string_view text) {
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ';') return ';';
    if (is_break(c)) break;
  }
  return ',';
}

}  // namespace

CsvReader::CsvReader(std::string_view text, std::string_view place, std::function<void(double)> progress)
    : text_(text), place_(place), progress_(std::move(progress)) {}

void CsvReader::take_break() {
  at_ += text_.substr(at_, 2) == "\r\n" ? std::size_t{2} : std::size_t{1};
  ++next_line_;
}

void CsvReader::skip_blank_lines() {
  while (at_ < text_.size()) {
    if (is_break(text_[at_])) {
      take_break();
    } else if (blanks.find(text_[at_]) != std::string_view::npos) {
      ++at_;
    } else {
      return;
    }
  }
}

// At the quote that opens it; behind it nothing but blanks may stand.
std::string_view CsvReader::quoted_field() {
  const std::uint32_t begun = next_line_;
  const std::size_t begin = ++at_;
  std::string* copy = nullptr;  // where quotes are doubled
  std::size_t copied = begin;
  for (;;) {
    if (at_ == text_.size()) {
      line_ = begun;
      fail("a quote is opened and not closed; close it, or leave it out");
    }
    if (is_break(text_[at_])) {
      take_break();
    } else if (text_[at_] != '"') {
      ++at_;
    } else if (text_.substr(at_, 2) != "\"\"") {
      break;
    } else {
      if (copy == nullptr) copy = &unquoted_.emplace_back();
      copy->append(text_, copied, at_ + 1 - copied);
      at_ += 2;
      copied = at_;
    }
  }
  if (copy != nullptr) copy->append(text_, copied, at_ - copied);
  const std::string_view field = copy != nullptr ? std::string_view(*copy) : text_.substr(begin, at_ - begin);
  ++at_;
  return trimmed(field);
}

std::string_view CsvReader::plain_field() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != separator_ && !is_break(text_[at_])) ++at_;
  return trimmed(text_.substr(begin, at_ - begin));
}

bool CsvReader::next() {
  if (progress_ && records_ % 65536 == 0) progress_(static_cast<double>(at_) / static_cast<double>(text_.size() + 1));
  skip_blank_lines();
  if (at_ == text_.size()) return false;
  if (records_ == 0) separator_ = separator_of(text_.substr(at_));
  ++records_;
  line_ = next_line_;
  fields_.clear();
  unquoted_.clear();
  for (;;) {
    while (at_ < text_.size() && text_[at_] != separator_ && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    const std::size_t begin = at_;
    const bool quoted = at_ < text_.size() && text_[at_] == '"';
    fields_.push_back(quoted ? quoted_field() : plain_field());
    const std::string_view rest = plain_field();  // behind quotes; empty behind others
    if (!rest.empty() || (!quoted && fields_.back().find('"') != std::string_view::npos)) {
      fail(fmt::format("{} has a quote within; put the field in quotes, and each quote in it twice",
                       quote(text_.substr(begin, at_ - begin))));
    }
    if (at_ == text_.size() || text_[at_] != separator_) return true;
    ++at_;
  }
}

bool are_names(const CsvReader::Fields& fields, std::size_t count) {
  double value = 0;
  for (std::size_t i = 0; i < std::min(fields.size(), count); ++i) {
    if (parse_number(fields[i], value) == nullptr) return false;
  }
  const std::string first = in_small_letters(fields[0].substr(0, 8));
  if (first.empty() || first == "nan" || first == "inf" || first == "infinity") return false;
  return ('a' <= first[0] && first[0] <= 'z') || first[0] == '_';
}

std::string geometry_column(const CsvReader::Fields& names) {
  if (!are_names(names, 1)) return {};
  std::vector<std::string> small;
  for (const std::string_view name : names) small.push_back(in_small_letters(name));
  const auto has = [&](const char* name) { return std::find(small.begin(), small.end(), name) != small.end(); };
  if (has("x1") && has("y1") && has("x2") && has("y2")) return {};
  for (const char* known : {"wkt", "geometry", "geom", "the_geom"}) {
    if (has(known)) return known;
  }
  return {};
}

std::string CsvTable::needed_text() const { return fmt::format("{}", fmt::join(columns_.needed, ",")); }

std::string CsvTable::known_text(const CsvReader::Fields& names) const {
  constexpr std::size_t most = 20;
  std::vector<std::string> known;
  for (const std::string_view name : names) {
    if (!is_any_of(columns_.needed, in_small_letters(name))) known.push_back(shorten(name));
  }
  const bool more = known.size() > most;
  if (more) known.resize(most);
  return fmt::format("{}{}", fmt::join(known, ", "), more ? ", ..." : "");
}

std::size_t CsvTable::column_of(const CsvReader& reader, std::string_view name) const {
  std::size_t found = none;
  for (std::size_t i = 0; i < reader.fields().size(); ++i) {
    if (reader.fields()[i] != name) continue;
    if (found != none) reader.fail(fmt::format("two columns are named {}; rename one", quote(name)));
    found = i;
  }
  return found;
}

// Where the first record has names: each needed one once, none that is strange.
void CsvTable::place_columns(const CsvReader& reader, bool drop_z) {
  std::vector<std::string> kept;  // in small letters
  for (const std::string_view name : reader.fields()) kept.push_back(in_small_letters(name));
  at_.clear();
  for (const std::string_view needed : columns_.needed) {
    if (std::count(kept.begin(), kept.end(), needed) > 1) {
      reader.fail(fmt::format("two columns are named {}; rename one", quote(needed)));
    }
    const auto found = std::find(kept.begin(), kept.end(), needed);
    if (found != kept.end()) at_.push_back(static_cast<std::size_t>(found - kept.begin()));
  }
  const bool strange =
      std::any_of(kept.begin(), kept.end(), [&](const auto& name) { return is_any_of(columns_.strange, name); });
  if (strange || at_.size() < columns_.needed.size()) {
    const std::size_t shown = std::min<std::size_t>(kept.size(), 8);
    std::vector<std::string> first;
    for (std::size_t i = 0; i < shown; ++i) first.push_back(shorten(reader.fields()[i]));
    reader.fail(
        fmt::format("the columns are named {}{}, but {} have {}; name them so, or give the file to the verb for "
                    "what it holds",
                    fmt::join(first, ","), shown < kept.size() ? ",..." : "", columns_.objects, needed_text()));
  }
  const std::vector<std::string_view> third{"z", "z1", "z2"};
  const auto z = std::find_if(kept.begin(), kept.end(), [&](const auto& name) { return is_any_of(third, name); });
  if (z != kept.end() && !drop_z) {
    reader.fail(fmt::format("has a third coordinate, {}; to ignore it, give --drop-z", quote(*z)));
  }
}

// Throws Error bad_call where there is no such column.
std::size_t CsvTable::asked_column(const CsvReader& reader, std::string_view place, const std::string& name,
                                   std::string_view what_for) const {
  const std::size_t found = has_names_ ? column_of(reader, name) : none;
  if (found != none) return found;
  const std::string known = has_names_ ? known_text(reader.fields()) : "";
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no column {} to {}; {}", quote(name), what_for,
                          known.empty() ? fmt::format("a first line has to name the columns after {}", needed_text())
                                        : "there are " + known),
              one_line(place));
}

bool CsvTable::begin(const CsvReader& reader, std::string_view place, bool drop_z, bool by_row) {
  const CsvReader::Fields& fields = reader.fields();
  const std::size_t needed = columns_.needed.size();
  has_names_ = are_names(fields, needed);
  for (std::size_t k = 0; k < needed; ++k) at_.push_back(k);
  if (has_names_) {
    place_columns(reader, drop_z);
    count_ = fields.size();
    for (const std::string_view known : {"name", "Name", "NAME", "id", "ID", "Id"}) {
      if (name_column_ == none) name_column_ = column_of(reader, known);
    }
    for (std::size_t k = 0; k < fields.size() && name_column_ == none; ++k) {
      if (std::find(at_.begin(), at_.end(), k) == at_.end()) name_column_ = k;
    }
  } else {
    name_column_ = needed;
  }
  if (!name_.empty()) name_column_ = asked_column(reader, place, name_, "name by");
  const bool is_by_row = by_row && group_ == "feature" && !(has_names_ && column_of(reader, group_) != none);
  if (!group_.empty() && !is_by_row) group_column_ = asked_column(reader, place, group_, "group by");
  for (const std::string& property : properties_) {
    property_columns_.push_back(asked_column(reader, place, property, "tell of"));
  }
  return has_names_;
}

void CsvTable::check_count(const CsvReader& reader) const {
  const std::size_t count = reader.fields().size(), needed = columns_.needed.size();
  const bool name_left_out = count + 1 == count_ && name_column_ == count && group_column_ != count &&
                             std::find(at_.begin(), at_.end(), count) == at_.end();
  if (count_ > 0 && count != count_ && !name_left_out) {
    reader.fail(fmt::format("has {} fields, but the line of names has {}; give the same number", count, count_));
  }
  if (count_ == 0 && (count < needed || count > needed + 1)) {
    reader.fail(
        fmt::format("has {} fields; give {} and, if you like, a name; for more, name the columns in a first "
                    "line",
                    count, needed_text()));
  }
}

double CsvTable::number(const CsvReader& reader, std::size_t needed) const {
  const std::string_view word = field(reader, needed);
  double value = 0;
  if (const char* problem = parse_number(word, value)) reader.fail(fmt::format("{} {}", quote(word), problem));
  return value;
}

std::string CsvTable::name(const CsvReader& reader) const {
  return name_column_ < reader.fields().size() ? one_line(reader.fields()[name_column_]) : std::string();
}

std::string_view CsvTable::group(const CsvReader& reader) const {
  const std::string_view value = reader.fields()[group_column_];
  if (value.empty()) reader.fail(fmt::format("has no value in the column {}; give one", quote(group_)));
  return value;
}

PropertyValues CsvTable::properties(const CsvReader& reader) const {
  PropertyValues values;
  for (const std::size_t column : property_columns_) {
    PropertyValue& value = values.emplace_back();
    if (column < reader.fields().size() && !reader.fields()[column].empty()) {
      value = {one_line(reader.fields()[column]), true};
    }
  }
  return values;
}

}  // namespace sunder::io
