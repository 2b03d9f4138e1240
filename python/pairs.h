// Two placed convex objects, of the plane or of space: one pair with its answer.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>

#include "common.h"

namespace sunder::python {

struct PythonPairAnswer : YesNo {
  DecidedBy decided_by = DecidedBy::filter;
};

// The file that states and proves what the answer says of A and B. In the plane vertices have z = 0.
std::string pair_certificate(std::span<const Point3> a, const Affine3& pose_a, std::span<const Point3> b,
                             const Affine3& pose_b, const PairCertificate& certificate, PairClaims::Space space);

// Binds the questions about two objects under these names: `name` and its short name in the module.
template <class Object, class Pose, class Answering>
void bind_pair(nb::module_& module, nb::module_& chapter, const char* name, const Answering& answer_of) {
  using Shared = std::shared_ptr<Object>;
  const auto placed = [answer_of](const Shared& a, const Pose& pose_a, const Shared& b, const Pose& pose_b) {
    return answer_of(a, pose_a, b, pose_b);
  };
  chapter.def(name, placed, nb::arg("a"), nb::arg("pose_a"), nb::arg("b"), nb::arg("pose_b"),
              "Do two placed convex objects meet? Touching is meeting.");
  module.def("intersect", placed, nb::arg("a"), nb::arg("pose_a"), nb::arg("b"), nb::arg("pose_b"),
             "Do two convex objects meet, placed or as they are? Touching is meeting.");
  module.def(
      "intersect", [answer_of](const Shared& a, const Shared& b) { return answer_of(a, Pose(), b, Pose()); },
      nb::arg("a"), nb::arg("b"));
}

}  // namespace sunder::python
