#include <sunder/ask/pair/pair_question.h>

#include <fmt/format.h>

namespace sunder::ask {

std::string PairQuestion::cost_text() const {
  return fmt::format("{}, {}, {} of exact arithmetic", count_of(cost_.probes, "probe"),
                     count_of(cost_.iterations, "iteration"), count_of(cost_.exact, "use"));
}

std::string PairQuestion::head(const std::string& a, const std::string& b, std::string_view verdict) const {
  const std::string contact = call.classify && meet_ ? fmt::format(" ({})", name_of(contact_)) : "";
  return fmt::format("{} and {}: {}{}{}\n", a, b, verdict, contact, left_out_.clause());
}

void PairQuestion::add_head(Json& json, const Json& a, const Json& b) const {
  json["decided_by"] = name_of(decided_by_);
  json["objects"] = Json::array({a, b});
  if (!left_out_.empty()) json["left_out"] = to_json(left_out_);
  if (call.classify) json["contact"] = name_of(contact_);
}

std::string PairQuestion::certificate_of(PairClaims::Space space, const std::function<void(PairClaims&)>& write) const {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin_);
  PairClaims pairs(file, space);
  write(pairs);
  pairs.end();
  return text;
}

}  // namespace sunder::ask
