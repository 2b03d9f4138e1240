#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_question.h>

#include <sunder/certificate/rounded_evidence.h>
#include <sunder/solid/round/round_claims.h>

#include <fmt/format.h>

#include <algorithm>

namespace sunder::ask {

namespace {

// One sentence in one or two lines.
std::string evidence_text(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b, bool is_planar) {
  const auto told = [&](const Point3& p) { return is_planar ? about(Point2{p.x, p.y}) : about(p); };
  if (const auto* common = std::get_if<CommonVertices>(&c)) {
    return fmt::format(
        "a common point at about {}, made of {} of A and {} of B", told(rounded_common_point(*common, a, b)),
        common->count_a == 1 ? "1 vertex" : fmt::format("{} vertices", common->count_a), common->count_b);
  }
  const Separation& apart = std::get<Separation>(c);
  const RoundedGap gap = rounded_gap(apart, a, b);
  return fmt::format(
      "an empty {} about {} wide across the direction of about {},\nfrom vertex {} of A to vertex {} of B",
      is_planar ? "strip" : "slab", about(gap.width), told(gap.direction), apart.extreme_a, apart.extreme_b);
}

}  // namespace

std::string decided_text(DecidedBy decided_by) {
  switch (decided_by) {
    case DecidedBy::filter: return "the search's evidence, checked by floating-point filters alone";
    case DecidedBy::evidence: return "the search's evidence, checked with the help of exact arithmetic";
    case DecidedBy::finishing: return "exact finishing, because the search's evidence did not hold";
    case DecidedBy::scan: return "exact arithmetic, by looking at everything";
  }
  return "";
}

std::string about(const Point2& p) { return fmt::format("({}, {})", about(p.x), about(p.y)); }

Report PairQuestion::report() const {
  Report report{.answer = word_, .code = is_yes_ ? exit_code::yes : exit_code::no, .decided_by = name_of(decided_by_)};
  report.function = function_;
  report.cost = cost_;
  report.cost_text = fmt::format("{}, {}, {} of exact arithmetic", count_of(cost_.probes, "probe"),
                                 count_of(cost_.iterations, "iteration"), count_of(cost_.exact, "use"));
  report.objects = Json::array({a_.json, b_.json});
  report.not_proved = not_proved_;
  const bool is_unknown =
      std::any_of(facts_.begin(), facts_.end(), [](const Fact& fact) { return fact.key == "contact_unknown"; });
  const std::string contact = !call.classify || !meet_ ? ""
                              : is_unknown             ? " (touching or overlapping)"
                                                       : fmt::format(" ({})", name_of(contact_));
  report.tell(fmt::format("{} and {}: {}{}{}\n", a_.file, b_.file, verdict_, contact, files_.left_out.clause()));
  report.tell(titled("A", a_.text) + titled("B", b_.text));
  report.add(facts_of(files_.left_out));
  const std::vector<Fact> systems = facts_of(files_.systems);
  for (const Fact& fact : systems) report.add(fact.key, fact.json);
  if (call.classify && !is_unknown) report.add("contact", name_of(contact_));
  for (const auto& [key, json, text] : facts_) {
    report.add(key, json, text.empty() ? "" : titled(key == "contact_unknown" ? "contact" : key, text));
  }
  for (const Fact& fact : systems) report.tell(fact.text);
  report.tell(titled("decided by", decided_text_));
  return report;
}

Fact PairQuestion::evidence(const PairCertificate& certificate) const {
  const PlacedVertices a = a_.in_space(), b = b_.in_space();
  Json json = evidence_json(certificate, a, b);
  const bool is_planar = space_ == Space::planar;
  for (const char* key : {"point", "direction_about"}) {
    if (is_planar && json.contains(key)) json[key].erase(2);  // z
  }
  return {"evidence", std::move(json), evidence_text(certificate, a, b, is_planar)};
}

void PairQuestion::require_decided() const {
  if (!is_undecided_) return;
  throw Error(ErrorCode::bad_value, "the pair is undecided, and there is no proof; leave out --certificate",
              "--certificate");
}

std::string PairQuestion::certificate() const {
  require_decided();
  return claims_text(origin(), [&](ClaimsWriter& file) {
    PairClaims pairs(file, space_);
    const auto add = [&](const PairObject& object) {
      file.say(object.said);
      return pairs.add_placed(object.name,
                              object.round != nullptr ? solid::add_shape(pairs, object.name, *object.round)
                                                      : pairs.add_body(object.name, object.vertices, object.ways),
                              object.pose);
    };
    const std::uint32_t first = add(is_b_first_ ? b_ : a_), second = add(is_b_first_ ? a_ : b_);
    for (const Statement& statement : statements_) statement(pairs, first, second);
  });
}

}  // namespace sunder::ask
