#include <sunder/base/error.h>
#include <sunder/io/csv.h>
#include <sunder/io/file.h>
#include <sunder/io/kicad.h>
#include <sunder/io/lines.h>
#include <sunder/io/lines_builder.h>
#include <sunder/io/lines_geojson.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>

namespace sunder::io {

namespace {

char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

class Csv {
 public:
  explicit Csv(LineBuilder& builder) : builder_(builder), group_(builder.options().group) {}

  void parse(std::string_view text) {
    bool first = true;
    for_each_line(text, builder_.options().progress, [&](std::string_view line, std::uint32_t number) {
      if (first && line.find(';') != std::string_view::npos) separator_ = ';';
      builder_.at_line(number);
      const std::vector<std::string_view> fields = fields_of(line);
      const bool names = first && are_names(fields, 4);
      if (names) read_names(fields);
      if (first) choose_group(names ? fields : std::vector<std::string_view>());
      first = false;
      if (!names) add(fields, number);
    });
  }

 private:
  std::vector<std::string_view> fields_of(std::string_view line) const {
    std::vector<std::string_view> fields;
    if (split_fields(line, separator_, fields)) return fields;
    builder_.fail(
        fmt::format("{} has a quote within; write fields without separators and quotes", quote(fields.back())));
  }

  void check_count(std::size_t count) const {
    if (columns_ > 0 && count != columns_) {
      builder_.fail(fmt::format("has {} fields, but the line of names has {}; give the same number", count, columns_));
    }
    if (count < 4 || (count > 5 && columns_ == 0)) {
      builder_.fail(fmt::format("has {} fields; give x1,y1,x2,y2 and, if you like, an id", count));
    }
  }

  void read_names(const std::vector<std::string_view>& names) {
    if (!group_.empty()) columns_ = names.size();
    check_count(names.size());
    if (upper(names[0][0]) != 'X' && names.size() >= 5) {
      builder_.fail(fmt::format("the first column is named {}; the order is x1,y1,x2,y2,id", quote(names[0])));
    }
    const auto id = std::find(names.begin() + 4, names.end(), "id");
    if (id != names.end()) id_column_ = static_cast<std::size_t>(id - names.begin());
  }

  // names: of the columns; empty where there are none.
  void choose_group(const std::vector<std::string_view>& names) {
    if (group_.empty()) return;
    std::string known = "feature";
    for (std::size_t i = 4; i < names.size(); ++i) {
      if (i < 20) known += fmt::format(", {}", shorten(names[i]));
      if (names[i] != group_) continue;
      if (group_column_ > 0) builder_.fail(fmt::format("two columns are named {}; rename one", quote(group_)));
      group_column_ = i;
    }
    if (names.size() > 20) known += ", ...";
    if (names.empty()) known += ", and the columns after the fourth where a first line names them";
    if (group_column_ == 0 && group_ != "feature") fail_group(builder_.place(), group_, known);
    builder_.group_by(group_column_ > 0 ? GroupBy::field : GroupBy::feature);
  }

  void add(const std::vector<std::string_view>& fields, std::uint32_t number) {
    check_count(fields.size());
    builder_.begin_feature(id_column_ < fields.size() ? one_line(fields[id_column_]) : std::string(), number);
    if (group_column_ > 0) {
      const std::string_view value = fields[group_column_];
      if (value.empty()) builder_.fail(fmt::format("has no value in the column {}; give one", quote(group_)));
      builder_.group_value(std::string(value));
    }
    const Point2 from{builder_.number(fields[0]), builder_.number(fields[1])};
    const Point2 to{builder_.number(fields[2]), builder_.number(fields[3])};
    builder_.add(from, to);
  }

  LineBuilder& builder_;
  const std::string& group_;
  char separator_ = ',';
  std::size_t columns_ = 0;       // that each line must have; 0: four or five
  std::size_t id_column_ = 4;     // past the end: none
  std::size_t group_column_ = 0;  // 0: none
};

// A geometry in WKT.
class Wkt {
 public:
  Wkt(std::string_view text, LineBuilder& builder) : rest_(text), builder_(builder) {}

  // Did an SRID stand before it?
  bool geometry() {
    std::string type = word();
    const bool srid = type == "SRID";
    if (srid) {
      pass_srid();
      type = word();
    }
    std::string tag = word();
    if (tag.empty()) tag = cut_tag(type);
    if (tag == "EMPTY") builder_.fail("is empty; leave the line out");
    if (!tag.empty() && tag != "Z" && tag != "M" && tag != "ZM") {
      builder_.fail(fmt::format("{} after {} is not understood", quote(tag), type));
    }
    if (type == "LINESTRING") {
      builder_.add_line(points());
    } else if (type == "MULTILINESTRING") {
      list([&] { builder_.add_line(points()); });
    } else if (type == "POLYGON") {
      polygon(false);
    } else if (type == "MULTIPOLYGON") {
      list([&] { polygon(true); });
    } else if (type == "POINT" && builder_.options().points) {
      builder_.add_point(points());
    } else {
      builder_.fail(fmt::format("{} is not read here; give {}LINESTRING, MULTILINESTRING, POLYGON or MULTIPOLYGON",
                                quote(type), builder_.options().points ? "POINT, " : ""));
    }
    if (!(rest_ = trimmed(rest_)).empty()) builder_.fail(fmt::format("{} stands after the geometry", quote(rest_)));
    return srid;
  }

 private:
  std::string word() {
    rest_ = trimmed(rest_);
    std::string word;
    while (!rest_.empty() && 'A' <= upper(rest_[0]) && upper(rest_[0]) <= 'Z') {
      word += upper(rest_[0]);
      rest_.remove_prefix(1);
    }
    return word;
  }

  // Behind the "SRID" of "SRID=4326;".
  void pass_srid() {
    const bool equals = take('=');
    const std::size_t end = std::min(rest_.find(';'), rest_.size());
    std::int64_t number = 0;
    if (!equals || end == rest_.size() || !parse_integer(trimmed(rest_.substr(0, end)), number)) {
      builder_.fail("SRID is not followed by =, a number and a semicolon; write them, or leave SRID out");
    }
    rest_.remove_prefix(end + 1);
  }

  // The tag that is written to the type without a blank, as in POLYGONZ, cut off it.
  std::string cut_tag(std::string& type) const {
    for (const std::string_view tag : {"ZM", "Z", "M"}) {
      for (const std::string_view known : {"POINT", "LINESTRING", "MULTILINESTRING", "POLYGON", "MULTIPOLYGON"}) {
        if (type.size() != known.size() + tag.size() || !type.starts_with(known) || !type.ends_with(tag)) continue;
        if (known == "POINT" && !builder_.options().points) continue;  // refused under its own name
        type = known;
        return std::string(tag);
      }
    }
    return {};
  }

  bool take(char c) {
    rest_ = trimmed(rest_);
    if (rest_.empty() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (take(c)) return;
    builder_.fail(rest_.empty() ? fmt::format("ends where '{}' is expected; is it cut off?", c)
                                : fmt::format("{} stands where '{}' is expected", quote(rest_), c));
  }

  template <class Item>
  void list(const Item& item) {
    expect('(');
    do item();
    while (take(','));
    expect(')');
  }

  void polygon(bool several) {
    builder_.begin_polygon(several);
    list([&] {
      builder_.begin_ring();
      builder_.add_ring(points());
    });
  }

  std::vector<Point2> points() {
    std::vector<Point2> points;
    list([&] {
      rest_ = trimmed(rest_);
      const std::size_t end = std::min(rest_.find_first_of(",()"), rest_.size());
      std::string_view numbers = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(end);
      std::vector<double> x;
      while (!numbers.empty()) {
        const std::size_t blank = std::min(numbers.find_first_of(blanks), numbers.size());
        x.push_back(builder_.number(numbers.substr(0, blank)));
        numbers = trimmed(numbers.substr(blank));
      }
      if (x.size() < 2 || x.size() > 4) builder_.fail("a point has two numbers, parted by a blank");
      builder_.check_dimension(x.size());
      points.push_back({x[0], x[1]});
    });
    return points;
  }

  std::string_view rest_;
  LineBuilder& builder_;
};

void parse_wkt(std::string_view text, LineBuilder& builder) {
  builder.group_by_feature_or_ring();
  std::uint32_t srids = 0;
  for_each_line(text, builder.options().progress, [&](std::string_view line, std::uint32_t number) {
    builder.begin_feature({}, number);
    if (Wkt(line, builder).geometry()) ++srids;
  });
  if (srids > 0) {
    builder.file.remarks.push_back(
        fmt::format("lines with an SRID: {}; it is passed over: coordinates count as those of a plane", srids));
  }
}

}  // namespace

LineFile parse_lines(std::string_view text, std::string_view place, const LineOptions& options) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) fail_file(place, "has nothing in it; give a file with lines");
  const std::string ending = ending_of(place);
  if (ending == ".kicad_pcb" || text.substr(begin).starts_with("(kicad_")) return parse_kicad(text, place, options);
  LineBuilder builder(place, options);
  const char first = text[begin];
  const bool is_json = first == '{' || first == '[', is_word = 'A' <= upper(first) && upper(first) <= 'Z';
  if (ending == ".geojson" || ending == ".json" || (is_json && ending != ".csv" && ending != ".wkt")) {
    builder.file.format = "GeoJSON";
    parse_geojson(text, builder);
  } else if (ending == ".wkt" || (is_word && ending != ".csv")) {
    builder.file.format = "WKT";
    parse_wkt(text, builder);
  } else {
    builder.file.format = "CSV";
    Csv(builder).parse(text);
  }
  if (builder.file.segments.empty()) fail_file(place, "has no segments; give a file with lines");
  return std::move(builder.file);
}

LineFile read_lines(const std::filesystem::path& path, const LineOptions& options) {
  return parse_lines(read_file(path), path.string(), options);
}

void fail_group(std::string_view file, std::string_view group, std::string_view known) {
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no field {} to group by; there are {}", quote(group), one_line(known)),
              one_line(file));
}

}  // namespace sunder::io
