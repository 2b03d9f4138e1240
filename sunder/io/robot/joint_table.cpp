#include <sunder/base/threads.h>
#include <sunder/io/robot/joint_table.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/text/csv.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/npy.h>
#include <sunder/io/text/text.h>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <utility>

namespace sunder::io {

namespace {

// Rows as they mostly are: numbers, separators and line feeds, with blanks before numbers at most.
struct PlainRows {
  std::vector<double> values;
  std::vector<std::uint32_t> lines;  // counted from the first of these
  std::uint32_t line_feeds = 0;
  bool are_all = false;  // is there nothing else, wrong or only unusual?
};

PlainRows plain_rows(std::string_view text, char separator, std::size_t columns) {
  PlainRows rows;
  rows.line_feeds = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
  // Each value has a digit and what ends it, but for the last: so of blank lines no memory is asked for.
  rows.values.reserve(std::min((rows.line_feeds + std::size_t{1}) * columns, text.size() / 2 + 1));
  rows.lines.reserve(rows.line_feeds + 1);
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::uint32_t line = 0; at != end; ++line) {
    if (*at == '\n') {
      ++at;
      continue;
    }
    for (std::size_t k = 0; k < columns; ++k) {
      while (at != end && (*at == ' ' || *at == '\t')) ++at;
      double value = 0;
      const auto result = fast_float::from_chars(at, end, value);
      if (result.ec == std::errc::invalid_argument || !std::isfinite(value)) return rows;
      rows.values.push_back(value);
      at = result.ptr;
      if (k + 1 == columns) break;
      if (at == end || *at++ != separator) return rows;
    }
    rows.lines.push_back(line);
    if (at != end && *at == '\r') ++at;
    if (at != end && *at++ != '\n') return rows;
  }
  rows.are_all = true;
  return rows;
}

// Several pieces of whole lines, of about the same length.
std::vector<std::string_view> pieces_of(std::string_view text, std::size_t count) {
  std::vector<std::string_view> pieces;
  for (; count > 1; --count) {
    const std::size_t end = text.find('\n', text.size() / count);
    if (end == std::string_view::npos) break;
    pieces.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  pieces.push_back(text);
  return pieces;
}

// Reads all rows on so many threads, the first of them in this line. False where they are not all plain; then nothing
// is added.
bool add_plain_rows(std::string_view text, char separator, std::uint32_t line, std::size_t threads, JointTable& table) {
  constexpr std::size_t worth_a_thread = 1 << 16;  // bytes
  const std::vector<std::string_view> pieces =
      pieces_of(text, std::min(threads, std::max<std::size_t>(text.size() / worth_a_thread, 1)));
  std::vector<PlainRows> read(pieces.size());
  std::vector<std::exception_ptr> thrown(pieces.size());
  std::atomic<std::size_t> next = 0;
  on_threads(pieces.size(), [&] {
    for (std::size_t k = next++; k < pieces.size(); k = next++) {
      try {
        read[k] = plain_rows(pieces[k], separator, table.columns);
      } catch (...) {
        thrown[k] = std::current_exception();
      }
    }
  });
  for (const std::exception_ptr& what : thrown) {
    if (what) std::rethrow_exception(what);
  }
  for (const PlainRows& rows : read) {
    if (!rows.are_all) return false;
  }
  for (PlainRows& rows : read) {
    if (table.values.empty()) {
      table.values = std::move(rows.values);
    } else {
      table.values.insert(table.values.end(), rows.values.begin(), rows.values.end());
    }
    for (const std::uint32_t of : rows.lines) table.lines.push_back(line + of);
    line += rows.line_feeds;
  }
  return true;
}

JointTable of_csv(std::string_view text, std::string_view place, std::size_t threads) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark
  JointTable table;
  table.file = place;
  CsvReader reader(text, place);
  while (reader.next()) {
    const CsvReader::Fields& fields = reader.fields();
    if (reader.is_first()) {
      for (const std::string_view name : fields) {
        double number = 0;
        if (name.empty()) reader.fail("a column has no name; name the joints in the first line");
        if (parse_number(name, number) == nullptr) {
          reader.fail(quote(name) + " is a number; name the joints in the first line");
        }
        if (std::find(table.joints.begin(), table.joints.end(), name) != table.joints.end()) {
          reader.fail("joint " + quote(name) + " comes twice; keep one of the columns");
        }
        table.joints.emplace_back(name);
      }
      table.columns = fields.size();
      const std::size_t first = text.find_first_of("\r\n");
      const std::string_view names = text.substr(0, first);
      if (reader.line() == 1 && first != std::string_view::npos && names.find('"') == std::string_view::npos) {
        const std::size_t rows = first + (text.substr(first).starts_with("\r\n") ? 2 : 1);
        const char separator = names.find(';') == std::string_view::npos ? ',' : ';';
        if (add_plain_rows(text.substr(rows), separator, 2, threads, table)) return table;
      }
      continue;
    }
    if (fields.size() != table.columns) {
      reader.fail(fmt::format("{}, but {}; give each joint a value", count_of(fields.size(), "field"),
                              count_of(table.columns, "column")));
    }
    for (std::size_t k = 0; k < fields.size(); ++k) {
      double value = 0;
      if (const char* problem = parse_number(fields[k], value)) {
        reader.fail("joint " + quote(table.joints[k]) + ": " + quote(fields[k]) + " " + problem);
      }
      table.values.push_back(value);
    }
    table.lines.push_back(reader.line());
  }
  return table;
}

// "t", "time", "Time [s]", "time_from_start", "stamp.sec"
bool is_time(const std::string& name) {
  const std::string word = in_small_letters(name.substr(0, name.find_first_of("_ [(.-/")));
  constexpr std::array<std::string_view, 7> words{"t", "time", "timestamp", "stamp", "sec", "secs", "seconds"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

// "elbow" of "elbow_deg", "elbow [deg]", "elbow (degrees)"; empty of what does not end like that.
std::string joint_in_degrees(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const std::size_t last = name.find_last_not_of("])");
  if (last == std::string::npos) return "";
  std::size_t first = last + 1;
  while (first > 0 && is_letter(name[first - 1])) --first;
  const std::string unit = in_small_letters(name.substr(first, last + 1 - first));
  if (unit != "deg" && unit != "degree" && unit != "degrees") return "";
  const std::size_t end = name.substr(0, first).find_last_not_of("_ [(.-/");
  return first == 0 || end == std::string::npos || end + 1 == first ? "" : name.substr(0, end + 1);
}

JointTable of_npy(std::string_view bytes, std::string_view place) {
  NpyArray array = parse_npy(bytes, place);
  JointTable table;
  table.file = place;
  table.columns = array.columns;
  table.values = std::move(array.values);
  return table;
}

}  // namespace

std::string JointTable::place(std::size_t row) const {
  return lines.empty() ? fmt::format("{}: row {}", file, row) : fmt::format("{}:{}", file, lines[row]);
}

void fit_joint_table(const Robot& robot, JointTable& table, std::vector<std::string>& remarks) {
  const std::vector<std::string> known = movable_joints(robot);
  const auto is_known = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  std::vector<std::size_t> kept, in_degrees;  // columns
  for (std::size_t k = 0; k < table.joints.size(); ++k) {
    std::string& name = table.joints[k];
    if (!is_known(name) && is_time(name)) {
      remarks.push_back(fmt::format("{}: column {} has times, and is left out", table.file, quote(name)));
      continue;
    }
    kept.push_back(k);
    if (is_known(name)) continue;
    const std::string joint = joint_in_degrees(name);
    if (!is_known(joint)) continue;
    const Joint& found =
        *std::find_if(robot.joints.begin(), robot.joints.end(), [&](const Joint& of) { return of.name == joint; });
    if (found.type == JointType::prismatic) {
      throw Error(ErrorCode::bad_call, "slides, so it takes metres, not degrees", "joint " + quote(joint));
    }
    remarks.push_back(
        fmt::format("{}: column {} is in degrees; its values are rounded to radians", table.file, quote(name)));
    name = joint;
    in_degrees.push_back(k);
  }
  for (auto name = table.joints.begin(); name != table.joints.end(); ++name) {
    if (std::find(table.joints.begin(), name, *name) != name)
      fail_file(table.file, "joint " + quote(*name) + " has two columns; keep one of them");
  }
  if (kept.empty() && !table.joints.empty()) fail_file(table.file, "there is no column of a joint; give one");
  constexpr double radian = 3.14159265358979323846 / 180;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const std::size_t k : in_degrees) table.values[row * table.columns + k] *= radian;
  }
  if (kept.size() == table.columns) return;
  const std::size_t rows = table.rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < kept.size(); ++k) {
      table.values[row * kept.size() + k] = table.values[row * table.columns + kept[k]];
    }
  }
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (kept[k] != k) table.joints[k] = std::move(table.joints[kept[k]]);
  }
  table.joints.resize(kept.size());
  table.columns = kept.size();
  table.values.resize(rows * kept.size());
}

JointTable parse_joint_table(std::string_view bytes, std::string_view place, std::size_t threads) {
  JointTable table = is_npy(bytes) ? of_npy(bytes, place) : of_csv(bytes, place, threads);
  if (table.rows() == 0) fail_file(place, "there is no placement; give a line of values, after that of the names");
  return table;
}

JointTable read_joint_table(const std::string& file, InputFiles* inputs, std::size_t threads) {
  return parse_joint_table(read_file(file, inputs), one_line(file), threads);
}

}  // namespace sunder::io
