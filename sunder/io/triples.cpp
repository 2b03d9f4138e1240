#include <sunder/io/csv.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/io/triples.h>

#include <fmt/format.h>

#include <limits>

namespace sunder::io {

TripleFile parse_triples(std::string_view text, std::string_view place, const TripleKind& kind,
                         const std::function<void(double)>& progress) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  TripleFile file;
  std::vector<std::string_view> fields;
  char separator = ',';
  bool first = true;
  for_each_line(text, progress, [&](std::string_view line, std::uint32_t number) {
    if (first && line.find(';') != std::string_view::npos) separator = ';';
    if (!split_fields(line, separator, fields)) {
      fail_line(place, number,
                fmt::format("{} has a quote within; write fields without separators and quotes", quote(fields.back())));
    }
    const bool names = first && are_names(fields, 3);
    first = false;
    if (fields.size() < 3 || fields.size() > 4) {
      fail_line(place, number,
                fmt::format("has {} fields; give {} and, if you like, a name", fields.size(), kind.columns));
    }
    if (names) return;
    std::array<double, 3> row{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (const char* problem = parse_number(fields[k], row[k])) {
        fail_line(place, number, fmt::format("{} {}", quote(fields[k]), problem));
      }
    }
    if (file.rows.size() == std::numeric_limits<std::uint32_t>::max()) {
      fail_line(place, number, "has too many rows before; split the file");
    }
    file.rows.push_back(row);
    file.line.push_back(number);
    const bool named = fields.size() > 3 && !fields[3].empty();
    file.name.push_back(named ? one_line(fields[3]) : std::to_string(file.rows.size()));
  });
  if (file.rows.empty()) fail_file(place, fmt::format("has no {}s; give lines {}", kind.object, kind.columns));
  return file;
}

TripleFile read_triples(const std::filesystem::path& path, const TripleKind& kind,
                        const std::function<void(double)>& progress) {
  return parse_triples(read_file(path), path.string(), kind, progress);
}

}  // namespace sunder::io
