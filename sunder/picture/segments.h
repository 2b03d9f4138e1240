// A picture of segments and of where they meet, as SVG.
#pragma once

#include <sunder/io/plane/lines.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/segments/segments_all.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sunder::picture {

// What is wrong with polygons, whose edges are segments of the file.
struct PicturedDefect {
  std::uint32_t i = 0, j = 0;  // the edges that show it; where one does, twice
  planar::Segment place;       // as of planar::PolygonDefect
  std::string_view kind;       // "hole-outside"
  std::string text;            // a sentence
};

struct SegmentsPicture {
  const io::LineFile& file;
  const planar::Segments& segments;                   // those of the file, in its order
  std::span<const planar::SegmentsContact> contacts;  // numbered from 1, in this order
  std::string said{};                                 // the answer in words, as the text has it: "none meet"
  std::string title{};                                // empty: a question
  bool y_down = false;                                // as boards have it
  std::span<const PicturedDefect> defects{};          // in the place of contacts
};

// All segments drawn thin, those that meet bold over them, and a ring with a number at each contact (rings.h), in the
// colour of its kind; 1600 pixels wide, without scripts. Pointing at a ring shows who meets there. Of defects likewise.
//   S1. For every finite input the text is well-formed XML, in UTF-8, of finite numbers; the same input gives the same
//       text.
//   S2. Thin lines: one path for each layer; without layers, for each group, where there are at most 8; else one path.
//       Segments that follow each other in the file and share an end are one line. Coordinates are tenths of a pixel.
//       Where that is over 6 MB: the density of segments instead (density.h).
//   S3. Bold, in the kind's colour: the segments of the first 5000 contacts; of an overlap, the common part as a band.
//   S4. x and y are to one scale unless one extent is more than 20 times the other; the picture says so.
// What it does not do: decide. Positions are rounded. Size: about 5 bytes for a short segment of a line, 20 for one by
// itself; a few hundred bytes for a ring.
std::string segments_svg(const SegmentsPicture& picture);

}  // namespace sunder::picture
