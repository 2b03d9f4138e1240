// The quick in-library check of certificates. (For a check that shares no code with the library, see verifier/.)
// Also called: proof checking; checking the witness of a certifying algorithm.
#pragma once

#include <sunder/certificate/direction.h>
#include <sunder/certificate/pair.h>

#include <cstdint>
#include <string_view>

namespace sunder {

// What holds, or what failed first.
enum class CheckResult : std::uint8_t {
  accepted,
  bad_index,           // a vertex that does not exist, too many or too few of them, or a direction that is none
  not_extreme_in_a,    // a vertex of A is further along the direction than the one named
  not_extreme_in_b,    // a vertex of B is less far
  not_strictly_apart,  // the two extreme vertices are not strictly ordered
  no_common_point,     // the vertices have no common point with unique positive weights
};

std::string_view name_of(CheckResult);  // "not extreme in a"

// The absolute check: exact, against every vertex of both tables; no hull is assumed. Linear for `apart`, constant for
// `meet`. Whatever the certificate holds, this neither throws nor reads out of range.
CheckResult check_absolutely(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b);

}  // namespace sunder
