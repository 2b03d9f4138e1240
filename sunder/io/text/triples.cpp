#include <sunder/io/text/csv.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/triples.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <map>
#include <utility>

namespace sunder::io {

TripleFile parse_triples(std::string_view text, std::string_view place, const TripleKind& kind,
                         const TripleOptions& options) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  refuse_foreign(text, place);
  const std::string objects = fmt::format("{}s", kind.object);
  const CsvColumns columns{
      {kind.columns.begin(), kind.columns.end()}, {kind.strange.begin(), kind.strange.end()}, objects};
  CsvTable table(columns, options.name, options.group, options.properties);
  CsvReader reader(text, place, options.progress);
  TripleFile file;
  std::map<std::string, std::uint32_t, std::less<>> positions;  // of a group in file.groups
  while (reader.next()) {
    if (reader.is_first() && table.begin(reader, place, true)) continue;
    table.check_count(reader);
    const std::array row{table.number(reader, 0), table.number(reader, 1), table.number(reader, 2)};
    if (file.rows.size() == std::numeric_limits<std::uint32_t>::max()) {
      reader.fail("has too many rows before; split the file");
    }
    file.rows.push_back(row);
    file.line.push_back(reader.line());
    std::string own = table.name(reader);
    file.name.push_back(own.empty() ? std::to_string(file.rows.size()) : std::move(own));
    if (!options.properties.empty()) file.properties.push_back(table.properties(reader));
    if (!table.groups()) continue;
    const std::string_view value = table.group(reader);
    const auto [at, is_new] = positions.emplace(value, static_cast<std::uint32_t>(file.groups.size()));
    if (is_new) file.groups.push_back(one_line(value));
    file.group.push_back(at->second);
  }
  if (file.rows.empty())
    fail_file(place, fmt::format("has no {}; give lines {}", objects, fmt::join(kind.columns, ",")));
  return file;
}

TripleFile read_triples(const std::filesystem::path& path, const TripleKind& kind, const TripleOptions& options) {
  return parse_triples(read_file(path, options.inputs), path.string(), kind, options);
}

CirclesFile read_circles(const std::filesystem::path& path, const TripleOptions& options) {
  TripleFile file = read_triples(path, circle_rows, options);
  std::vector<Disc> circles;
  circles.reserve(file.rows.size());
  for (std::size_t k = 0; k < file.rows.size(); ++k) {
    const auto& [x, y, r] = file.rows[k];
    if (r < 0) fail_line(path.string(), file.line[k], "has a negative radius; give x,y,r with r of at least 0");
    circles.push_back({{x, y}, r});
  }
  return {std::move(file), planar::Discs(std::move(circles))};
}

}  // namespace sunder::io
