// Polygons out of files, in the words and reports of the verbs.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/io/plane/polygons.h>

#include <string>
#include <vector>

namespace sunder::ask {

using io::PolygonsInput;
using io::PolygonSource;
using io::PolygonsRequest;
using io::text_of;

// Help of the options that make a request.
inline constexpr const char* skip_invalid_help = "answer for the valid features, and list the others";
inline constexpr const char* mend_help =
    "close open rings, and remove spikes and rings without area; the output lists the changes";
inline constexpr const char* name_help = "the property that holds the names of features (default: name, NAME or id)";

// As io::read_polygons, telling of the progress.
PolygonsInput read_with_progress(const Talk& talk, PolygonsRequest request);

// "2 repeated vertices left out, 1 spike cut off, 1 ring closed".
std::string text_of(const planar::MendedRings& mended);

// "skipped", "mended", "left_out", "remarks", as far as there are any: to people at most 20 of a kind.
std::vector<Fact> facts_of(const PolygonsInput& input);

// The origin of a proof whose table of this name has an entry for each polygon, and besides so many `entries` of each
// file, where these are given.
Origin origin_of(const PolygonsInput& input, const char* table, bool drop_z, std::vector<std::uint64_t> entries = {});

}  // namespace sunder::ask
