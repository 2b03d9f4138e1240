// The certificate file of an answer about a set of circles (docs/certificates-sets.md, "circles_any").
#pragma once

#include <sunder/planar/set/circles_any.h>

#include <string>

namespace sunder::planar {

// Requires an answer about these circles under this rule and with these groups; one of `none` with its transcript, so
// without groups. The certificate must be true: the common point is computed here.
std::string certificate_text(const Circles& circles, Allowed allowed, const CirclesAnswer& answer, Groups groups = {});

}  // namespace sunder::planar
