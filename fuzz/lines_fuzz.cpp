// Any bytes, read as CSV, WKT and GeoJSON, then asked for contacts.
// Seeds: cases/segments.
#include <sunder/base/error.h>
#include <sunder/io/lines.h>
#include <sunder/planar/set/segments_any.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check(std::string_view text, std::string_view place, bool drop_z) {
  sunder::io::LineFile file;
  try {
    file = sunder::io::parse_lines(text, place, drop_z);
  } catch (const sunder::Error& error) {
    const std::string_view message = error.what();
    require(error.code() == sunder::ErrorCode::bad_file);
    require(message.starts_with(place) && message.find('\n') == std::string_view::npos);
    return;
  }
  require(!file.segments.empty() && file.source.size() == file.segments.size());
  for (std::size_t i = 0; i < file.source.size(); ++i) {
    require(file.source[i].feature < file.features.size());
    require(i == 0 || file.source[i - 1].feature <= file.source[i].feature);
  }
  const sunder::planar::Segments segments(file.segments);  // throws where a coordinate is not finite
  if (segments.size() > 60) return;
  for (const auto allowed :
       {sunder::planar::Allowed::nothing, sunder::planar::Allowed::shared_endpoint, sunder::planar::Allowed::touch}) {
    const auto sweep = sunder::planar::segments_any(segments, {allowed, true});
    require(sweep.meet() == sunder::planar::segments_any_by_scan(segments, {allowed, false}).meet());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const std::string_view place : {"a.csv", "a.wkt", "a.geojson", "a"}) check(text, place, size % 2 == 0);
  return 0;
}
