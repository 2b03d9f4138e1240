// The evidence of an answer in JSON, with rounded numbers. The exact ones are in certificate files.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/certificate/direction.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/round/round_round.h>

#include <string_view>

namespace sunder::ask {

// apart: {"direction_about", "gap_about", "extreme_a", "extreme_b"}; meet: {"point_about", "vertices_a", "vertices_b"}.
Json evidence_json(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b);

// The same for two polyhedra. For other bodies, apart: {"direction_about", "gap_about"}; meet: {"point"}; undecided:
// {"direction_about"}.
Json evidence_json(const solid::RoundEvidence& evidence, const solid::PlacedRound& a, const solid::PlacedRound& b);

// "ball", "capsule", "rounded hull", "cylinder", "cone", "ellipsoid".
std::string_view shape_name(const solid::RoundBody& body);

}  // namespace sunder::ask
