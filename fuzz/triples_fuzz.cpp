// Any bytes, read as circles (some by a group) and as half-planes, then asked: do any two meet, what is the common
// part? Seeds: cases/circles, cases/half-planes.
#include <fuzz/require.h>

#include <sunder/base/error.h>
#include <sunder/io/text/triples.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/region/half_plane_intersection.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

using sunder::fuzz::require;
namespace {

using namespace std::string_view_literals;
using sunder::Disc;
using sunder::planar::Constraints;
using sunder::planar::Discs;
using sunder::planar::Region;

constexpr std::size_t most_rows = 40;  // for the oracles

void ask_circles(const sunder::io::TripleFile& file) {
  std::vector<Disc> circles;
  for (const auto& [x, y, r] : file.rows) circles.push_back({{x, y}, std::fabs(r)});
  const Discs set(circles);
  for (const auto allowed : {sunder::Allowed::nothing, sunder::Allowed::touch}) {
    const sunder::SetOptions options{allowed, file.group, nullptr};
    const bool meet = sunder::planar::discs_any_by_scan(set, options).meet();
    require(sunder::planar::discs_any(set, options).meet() == meet);
    require(sunder::planar::discs_any_by_grid(set, options).meet() == meet);
    require(sunder::planar::discs_any_by_sweep(set, options).meet() == meet);
  }
}

void ask_half_planes(const sunder::io::TripleFile& file) {
  std::vector<sunder::Constraint> rows;
  for (const auto& [a, b, c] : file.rows) {
    if (a != 0 || b != 0) rows.push_back({a, b, c});
  }
  if (rows.empty()) return;
  const Constraints constraints(rows);
  const Region oracle = half_plane_intersection_by_scan(constraints);
  for (const Region& region :
       {half_plane_intersection(constraints, {true}), half_plane_intersection_by_division(constraints, {true})}) {
    require(region.kind == oracle.kind);
    require(region.empty() || region.sides == oracle.sides);
    require(check(constraints, region));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const bool of_circles = size % 2 == 0, by_group = size % 3 == 0, tells = size % 5 == 0;
  const std::string group = by_group ? "name" : "";
  std::vector<std::string> properties;
  if (tells) properties = {"id"};
  sunder::io::TripleFile file;
  try {
    const auto& kind = of_circles ? sunder::io::circle_rows : sunder::io::half_plane_rows;
    file = sunder::io::parse_triples(text, "a.csv"sv, kind, {.group = group, .properties = properties});
  } catch (const sunder::Error& error) {
    const std::string_view message = error.what();
    const bool asks = by_group || tells;
    require(error.code() == sunder::ErrorCode::bad_file || (asks && error.code() == sunder::ErrorCode::bad_call));
    require(message.starts_with("a.csv"sv) && message.find('\n') == std::string_view::npos);
    return 0;
  }
  require(!file.rows.empty() && file.name.size() == file.rows.size() && file.line.size() == file.rows.size());
  require(file.group.size() == (by_group ? file.rows.size() : 0));
  require(file.properties.size() == (tells ? file.rows.size() : 0));
  for (const std::uint32_t g : file.group) require(g < file.groups.size());
  for (const auto& row : file.rows) {
    for (const double x : row) require(std::isfinite(x));
  }
  if (file.rows.size() > most_rows) return 0;
  if (of_circles) {
    ask_circles(file);
  } else {
    ask_half_planes(file);
  }
  return 0;
}
