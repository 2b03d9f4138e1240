#include <sunder/io/csv.h>

#include <string>

namespace sunder::io {

bool split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    const std::size_t end = line.find(separator);
    std::string_view field = trimmed(line.substr(0, end));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
      field = trimmed(field.substr(1, field.size() - 2));
    }
    fields.push_back(field);
    if (field.find('"') != std::string_view::npos) return false;
    if (end == std::string_view::npos) return true;
    line.remove_prefix(end + 1);
  }
}

bool are_names(const std::vector<std::string_view>& fields, std::size_t count) {
  double value = 0;
  for (std::size_t i = 0; i < std::min(fields.size(), count); ++i) {
    if (parse_number(fields[i], value) == nullptr) return false;
  }
  std::string first(fields[0].substr(0, 8));
  for (char& c : first) c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  if (first.empty() || first == "NAN" || first == "INF" || first == "INFINITY") return false;
  return ('A' <= first[0] && first[0] <= 'Z') || first[0] == '_';
}

}  // namespace sunder::io
