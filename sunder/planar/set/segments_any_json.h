// Certificates of answers about a set of segments (docs/claims.md, "segments").
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/set/segments_any.h>

#include <string>

namespace sunder::planar {

// The table and the statement. Requires an answer about these segments under this rule and with these groups; one of
// `none` with its transcript. The certificate must be true: the common point is computed here.
void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAnswer& answer,
                     Groups groups = {});

// The whole file.
std::string certificate_text(const Segments& segments, Allowed allowed, const SegmentsAnswer& answer,
                             Groups groups = {});

}  // namespace sunder::planar
