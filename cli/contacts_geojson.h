// Where segments meet, as GeoJSON to lay over a map.
#pragma once

#include <sunder/io/lines.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/set/segments_all.h>

#include <span>
#include <string>

namespace sunder::cli {

// The common part of two members of Segments that overlap. Exact: its ends are ends of theirs.
planar::Segment common_part(const planar::Segment& s, const planar::Segment& t);

// A FeatureCollection with a feature for each contact, in their order, one on each line: lines can be compared (diff).
//   geometry    Point, planar::common_point_rounded; of an overlap LineString, its common part. Numbers are
//               the shortest that read back as the same double, and those of the file: a board's y still points down.
//   properties  number (from 1), kind, i, j, and as lists of two: features (names), lines (null where the format does
//               not tell), and if the file has them groups and layers.
// Bytes of names that are no UTF-8 become U+FFFD. Requires that `segments` are those of the file, in its order;
// contacts are by these numbers. Cost: linear, and the common point of each contact in exact arithmetic.
std::string contacts_geojson(const io::LineFile& file, const planar::Segments& segments,
                             std::span<const planar::SegmentsContact> contacts);

}  // namespace sunder::cli
