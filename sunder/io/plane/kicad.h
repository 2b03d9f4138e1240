// Tracks out of KiCad boards (.kicad_pcb). Readers of any file of lines ask lines.h.
#pragma once

#include <sunder/io/plane/lines.h>

#include <string_view>

namespace sunder::io {

// Board formats that are read: 3 and 4 (KiCad 4 and before it), 20160815 to 20251231 (KiCad 5 to 9).
//
// Each track on a copper layer, (segment ...) or (arc ...), is a feature, named after its net: "net GND"; its line is
// the one on which its list begins. Coordinates are millimetres, y downwards, as in the file.
//   K1. A segment keeps its ends exactly.
//   K2. An arc becomes a polyline through its start, mid and end, which are kept exactly; its other corners are on the
//       circle up to rounding, and the same on any machine. A chord spans at most 5 degrees, and so stays within 0.1 %
//       of the radius. Where the three points are collinear to within one in a million, the arc becomes the two
//       segments between them.
//   K3. layer names the copper layer of each track. Copper is what the board's table does not call a user's layer, and
//       whatever is not in that table but ends in ".Cu".
//   K4. group: "net" (the default), "layer" or "feature". Nets are the same where their names are. Tracks without a net
//       count as one net, "(no net)", with a remark.
// Widths, vias, zones, pads and graphics are not looked at; remarks say so, and how many there are.
// Lists may be nested to any depth. Throws as read_lines. Cost: linear.
LineFile parse_kicad(std::string_view text, std::string_view place, const LineOptions& options = {});

}  // namespace sunder::io
