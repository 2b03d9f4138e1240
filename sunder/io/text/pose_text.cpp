#include <sunder/io/text/pose_text.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sunder::io {

std::vector<double> parse_numbers(std::string_view text, const std::string& place) {
  constexpr std::string_view gaps = " \t";
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view field = text.substr(0, comma);
    const std::size_t before = numbers.size();
    while (true) {
      field.remove_prefix(std::min(field.find_first_not_of(gaps), field.size()));
      if (field.empty() && numbers.size() > before) break;
      const std::string_view word = field.substr(0, std::min(field.find_first_of(gaps), field.size()));
      double value = 0;
      if (const char* problem = parse_number(word, value)) {
        throw Error(ErrorCode::bad_call, quote(word) + " " + problem, place);
      }
      numbers.push_back(value);
      field.remove_prefix(word.size());
    }
    if (comma == text.size()) return numbers;
    text.remove_prefix(comma + 1);
  }
}

solid::Pose parse_pose(std::string_view text, const std::string& place) {
  const std::vector<double> n = parse_numbers(text, place);
  try {
    switch (n.size()) {
      case 3: return solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {n[0], n[1], n[2]});
      case 7: return solid::Pose::from_quaternion(n[0], n[1], n[2], n[3], {n[4], n[5], n[6]});
      case 12:
        return solid::Pose::from_matrix({n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10]}, {n[3], n[7], n[11]});
      case 16: {
        std::array<double, 16> rows;
        std::copy(n.begin(), n.end(), rows.begin());
        return solid::Pose::from_matrix4(rows);
      }
      default: break;
    }
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), place);
  }
  throw Error(ErrorCode::bad_call, fmt::format("a pose of {}; give {}", count_of(n.size(), "number"), pose_forms),
              place);
}

}  // namespace sunder::io
