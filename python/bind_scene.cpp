// Scenes of many placed bodies.
#include <sunder/certificate/pair_claims.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/pair/contact_evidence.h>

#include "common.h"

#include <algorithm>

namespace sunder::python {

namespace {

using scene::Body;
using scene::PartPair;
using scene::Question;

struct SceneAnswer : YesNo {
  std::vector<PartPair> pairs;
  scene::Counts counts;
};

void add_pair(PairClaims& claims, const scene::Part& a, std::uint32_t index_a, const scene::Part& b,
              std::uint32_t index_b, const PartPair& pair) {
  const PairCertificate& certificate = pair.answer.certificate();
  if (!pair.answer.meet() || pair.contact == Contact::none) return claims.add_pair(index_a, index_b, certificate);
  const solid::Interiors interiors = solid::interiors(a.shape, a.pose, b.shape, b.pose);
  if (interiors.meet) return claims.add_overlapping(index_a, index_b, interiors.point);
  claims.add_touching(index_a, index_b, claims.common_point(index_a, index_b, certificate), interiors.direction);
}

// That exactly those pairs of parts meet which do: each pair is stated, and then that these are all.
std::string certificate_of(const std::vector<Body>& bodies, Question question) {
  question.every_pair = true;
  const scene::Answer answer = scene::meeting_pairs(bodies, question);
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims claims(file);
  std::vector<std::uint32_t> tables, first;
  AllPairs all;
  all.touching_allowed = question.touching_allowed;
  const auto name = [](const Body& body, const scene::Part& part) {
    return body.parts.size() == 1 ? body.name : body.name + "/" + part.name;
  };
  for (const Body& body : bodies) {
    for (const scene::Part& part : body.parts)
      tables.push_back(claims.add_body(name(body, part), part.shape.vertices()));
  }
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    first.push_back(static_cast<std::uint32_t>(all.members.size()));
    for (const scene::Part& part : bodies[b].parts) {
      const std::uint32_t table = tables[all.members.size()];
      all.members.push_back(claims.add_placed(name(bodies[b], part), table, part.pose.affine()));
      all.groups.push_back(b);
    }
  }
  for (const PartPair& pair : answer.pairs) {
    const std::uint32_t i = first[pair.body_a] + pair.part_a, j = first[pair.body_b] + pair.part_b;
    add_pair(claims, bodies[pair.body_a].parts[pair.part_a], all.members[i], bodies[pair.body_b].parts[pair.part_b],
             all.members[j], pair);
    if (pair.counts) all.contacts.push_back({i, j});
  }
  for (const auto& [a, b] : question.allowed) {
    if (a == b) continue;
    const auto [low, high] = std::minmax(a, b);
    for (std::uint32_t i = 0; i < bodies[low].parts.size(); ++i) {
      for (std::uint32_t j = 0; j < bodies[high].parts.size(); ++j)
        all.besides.push_back({first[low] + i, first[high] + j});
    }
  }
  std::sort(all.besides.begin(), all.besides.end());
  all.besides.erase(std::unique(all.besides.begin(), all.besides.end()), all.besides.end());
  std::sort(all.contacts.begin(), all.contacts.end());
  claims.add_all_pairs(all);
  claims.end();
  return text;
}

SceneAnswer meeting_pairs(const std::vector<Body>& given,
                          const std::vector<std::pair<std::uint32_t, std::uint32_t>>& allowed, bool touching_allowed,
                          bool contacts, bool every_pair) {
  Question question;
  for (const auto& [a, b] : allowed) {
    if (a >= given.size() || b >= given.size()) {
      throw Error(ErrorCode::bad_value,
                  "names a body that is not there; give two numbers below " + std::to_string(given.size()),
                  "allowed[" + std::to_string(question.allowed.size()) + "]");
    }
    question.allowed.push_back({a, b});
  }
  question.touching_allowed = touching_allowed;
  question.contacts = contacts;
  question.every_pair = every_pair;
  const auto bodies = std::make_shared<const std::vector<Body>>(given);
  return unlocked([&] {
    scene::Answer found = scene::meeting_pairs(*bodies, question);
    SceneAnswer answer;
    answer.yes = found.some_meet();
    answer.certificate_text = [bodies, question] { return certificate_of(*bodies, question); };
    for (const PartPair& pair : found.pairs) {
      answer.cost.probes += pair.answer.cost.probes;
      answer.cost.iterations += pair.answer.cost.iterations;
      answer.cost.exact += pair.answer.cost.exact;
      answer.cost.proposals += pair.answer.cost.proposals;
    }
    answer.pairs = std::move(found.pairs);
    answer.counts = found.counts;
    return answer;
  });
}

}  // namespace

void bind_scene(nb::module_& scene) {
  nb::class_<scene::Part>(scene, "Part", "A convex polyhedron of a body, placed.")
      .def(nb::init<std::string, solid::ConvexPolyhedron, solid::Pose>(), nb::arg("name"), nb::arg("shape"),
           nb::arg("pose"))
      .def_ro("name", &scene::Part::name)
      .def_ro("shape", &scene::Part::shape)
      .def_ro("pose", &scene::Part::pose);
  nb::class_<Body>(scene, "Body", "A body of parts, which are not tested against each other.")
      .def(nb::init<std::string, std::vector<scene::Part>>(), nb::arg("name"), nb::arg("parts"))
      .def_ro("name", &Body::name)
      .def_ro("parts", &Body::parts);
  nb::class_<PartPair>(scene, "PartPair", "Two parts of different bodies that were asked about.")
      .def_ro("body_a", &PartPair::body_a)
      .def_ro("body_b", &PartPair::body_b)
      .def_ro("part_a", &PartPair::part_a)
      .def_ro("part_b", &PartPair::part_b)
      .def_prop_ro("meet", [](const PartPair& pair) { return pair.answer.meet(); })
      .def_ro("counts", &PartPair::counts, "They meet, and that is not allowed.")
      .def_ro("by_boxes", &PartPair::by_boxes, "Their boxes are apart, and nothing more was asked.")
      .def_prop_ro(
          "contact", [](const PartPair& pair) { return name_of(pair.contact); },
          "\"none\", \"touching\", \"overlapping\"; of pairs that meet only where contacts were asked for.");
  nb::class_<SceneAnswer, YesNo>(scene, "SceneAnswer", "Which parts of different bodies meet? True where some do.")
      .def_ro("pairs", &SceneAnswer::pairs, "By bodies, then parts; with every_pair all, else those whose boxes meet.")
      .def_prop_ro(
          "meeting", [](const SceneAnswer& a) { return a.counts.meeting; }, "How many pairs meet.")
      .def_prop_ro("tested", [](const SceneAnswer& a) { return a.counts.by_method; }, "How many pairs boxes left.");
  scene.def("meeting_pairs", &meeting_pairs, nb::arg("bodies"),
            nb::arg("allowed") = std::vector<std::pair<std::uint32_t, std::uint32_t>>(),
            nb::arg("touching_allowed") = false, nb::arg("contacts") = false, nb::arg("every_pair") = false,
            "Which of many placed bodies meet? allowed: pairs of bodies that are not tested.");
}

}  // namespace sunder::python
