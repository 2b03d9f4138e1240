// The certificate file of an answer about a set of segments (docs/certificates.md, "Sets").
#pragma once

#include <sunder/planar/set/segments_any.h>

#include <string>

namespace sunder::planar {

// Requires an answer about these segments under this rule and with these groups; one of `none` with its transcript. The
// certificate must be true: the common point is computed here.
std::string certificate_text(const Segments& segments, Allowed allowed, const SegmentsAnswer& answer,
                             Groups groups = {});

}  // namespace sunder::planar
