// Where segments meet, as GeoJSON to lay over a map.
#pragma once

#include <cli/list_stream.h>

#include <sunder/io/lines.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/set/segments_all.h>

namespace sunder::cli {

// The common part of two members of Segments that overlap. Exact: its ends are ends of theirs.
planar::Segment common_part(const planar::Segment& s, const planar::Segment& t);

// A FeatureCollection with a feature for each contact, in their order, one on each line: lines can be compared (diff).
//   geometry    Point, planar::common_point_rounded; of an overlap LineString, its common part. Numbers are
//               the shortest that read back as the same double, and those of the file: a board's y still points down.
//   properties  number (from 1), kind, i, j, and as lists of two: features (names), lines (null where the format does
//               not tell), and if the file has them groups and layers.
// Bytes of names that are no UTF-8 become U+FFFD. Contacts are by the numbers of the file's segments. Cost: linear, and
// the common point of each contact in exact arithmetic.
class ContactsGeojson {
 public:
  // The text goes to `sink` as it comes. Keeps the file by reference.
  ContactsGeojson(const io::LineFile& file, ListStream::Sink sink);

  void add(const planar::SegmentsContact& contact);
  void close() { list_.close("\n]}\n"); }

 private:
  const io::LineFile& file_;
  ListStream list_;
};

}  // namespace sunder::cli
