// Does the checker accept what is said of a pair?
#pragma once

#include <sunder/certificate/check.h>
#include <sunder/scene/scene.h>

#include <gtest/gtest.h>

#include <span>

namespace sunder::scene {

inline void expect_certified(std::span<const Body> bodies, const PartPair& pair) {
  const Part &p = bodies[pair.body_a].parts[pair.part_a], &q = bodies[pair.body_b].parts[pair.part_b];
  PairCertificate certificate;
  if (const auto* apart = std::get_if<Separation>(&pair.answer.evidence)) {
    certificate = *apart;
  } else {
    certificate = std::get<CommonVertices>(pair.answer.evidence);
  }
  ASSERT_EQ(check_absolutely(certificate, {p.shape.points(), p.pose.affine(), false},
                             {q.shape.points(), q.pose.affine(), false}),
            CheckResult::accepted);
}

}  // namespace sunder::scene
