// Any bytes, read as CSV, WKT, GeoJSON and KiCad boards, with and without groups, then asked for contacts.
// Seeds: cases/segments, cases/boards, cases/broken-lines.
#include <fuzz/require.h>

#include <sunder/base/error.h>
#include <sunder/io/plane/lines.h>
#include <sunder/planar/segments/segments_any.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

using sunder::fuzz::require;
namespace {

// L4: each segment has its entry, or there are no names; names come in the order of their first segments.
void check_names(const std::vector<std::uint32_t>& of_segment, const std::vector<std::string>& names,
                 std::size_t segments) {
  require(of_segment.size() == (names.empty() ? 0 : segments));
  std::size_t seen = 0;
  for (const std::uint32_t i : of_segment) {
    require(i <= seen && i < names.size());
    if (i == seen) ++seen;
  }
  require(seen == names.size());
  for (const std::string& name : names) require(name.find('\n') == std::string::npos);
}

void check(std::string_view text, std::string_view place, const sunder::io::LineOptions& options) {
  sunder::io::LineFile file;
  try {
    file = sunder::io::parse_lines(text, place, options);
  } catch (const sunder::Error& error) {
    const std::string_view message = error.what();
    const bool of_field = error.code() == sunder::ErrorCode::bad_call &&
                          !(options.group.empty() && options.name.empty() && options.properties.empty());
    require(error.code() == sunder::ErrorCode::bad_file || of_field);
    require(message.starts_with(place) && message.find('\n') == std::string_view::npos);
    return;
  }
  require(file.source.size() == file.segments.size() && !(file.segments.empty() && file.broken.empty()));
  require(options.keep_broken || file.broken.empty());
  require(options.leave_out || file.left_out.empty());
  for (std::size_t i = 0; i < file.source.size(); ++i) {
    require(file.source[i].feature < file.features.size());
    require(i == 0 || file.source[i - 1].feature <= file.source[i].feature);
  }
  const bool board = file.format == "KiCad board";
  require(file.groups.empty() == (options.group.empty() && !board) && file.layers.empty() == !board);
  require(file.properties.size() == (options.properties.empty() ? 0 : file.features.size()));
  for (const sunder::io::PropertyValues& values : file.properties) {
    require(values.size() == options.properties.size());
    for (const sunder::io::PropertyValue& value : values) require(value.text.find('\n') == std::string::npos);
  }
  if (file.broken.empty()) check_names(file.group, file.groups, file.segments.size());
  for (const sunder::io::BrokenRing& ring : file.broken) {
    require(ring.feature < file.features.size() && ring.ring <= file.rings.size());
    require(file.groups.empty() || ring.group < file.groups.size());
  }
  check_names(file.layer, file.layers, file.segments.size());
  for (const std::string& remark : file.remarks) require(remark.find('\n') == std::string::npos);
  for (const sunder::io::LineRing& ring : file.rings) {
    require(ring.count >= 3 && ring.first + ring.count <= file.segments.size());
    require(file.segments[ring.first].a == file.segments[ring.first + ring.count - 1].b);
  }
  if (file.segments.empty()) return;
  const sunder::planar::Segments segments(file.segments);  // throws where a coordinate is not finite
  if (segments.size() > 60) return;
  for (const auto allowed : {sunder::Allowed::nothing, sunder::Allowed::shared_endpoint, sunder::Allowed::touch}) {
    sunder::planar::SweepEvents events;
    const auto sweep = sunder::planar::segments_any_with_transcript(segments, {allowed}, events);
    require(sweep.meet() == sunder::planar::segments_any_by_scan(segments, {allowed}).meet());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> groups{"", "feature", "ring", "net", "layer"};
  sunder::io::LineOptions options;
  options.drop_z = size % 2 == 0;
  options.group = groups[size / 2 % groups.size()];
  options.leave_out = size / 10 % 2 == 0;
  options.keep_broken = size / 20 % 2 == 0;
  options.lines = size / 40 % 4 != 0;
  if (size / 160 % 4 == 0) options.name = "id";
  if (size / 3 % 4 == 1) options.properties = {"name", "id"};
  for (const std::string_view place : {"a.csv", "a.wkt", "a.geojson", "a.kicad_pcb", "a"}) check(text, place, options);
  return 0;
}
