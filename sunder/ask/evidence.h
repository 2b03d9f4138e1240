// The evidence of an answer in words and in JSON, with rounded numbers. The exact ones are in certificate files.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/certificate/direction.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <cstdint>
#include <string>

namespace sunder::ask {

PlacedVertices placed_vertices(const solid::ConvexPolyhedron& shape, const solid::Pose& pose);

// Who decided, in words.
std::string decided_text(DecidedBy decided_by);

// One sentence in one or two lines. The names are those of A and B.
std::string evidence_text(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b,
                          const std::string& name_a, const std::string& name_b);

// apart: {"direction_about", "gap_about", "extreme_a", "extreme_b"}; meet: {"point_about", "vertices_a", "vertices_b"}.
Json evidence_json(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b);

// Two bodies of a certificate file, and what proves how they are to each other.
struct SolidPair {
  std::uint32_t index_a, index_b;  // among the file's bodies
  const solid::ConvexPolyhedron &a, &b;
  const solid::Pose &pose_a, &pose_b;
};

// States that they are apart, or meet; where contact is not none, that they touch, or overlap.
void add_solid_pair(PairClaims& pairs, const SolidPair& pair, const PairCertificate& certificate, Contact contact);

}  // namespace sunder::ask
