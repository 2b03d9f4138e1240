#include <sunder/ask/pair/pair_mixed.h>

#include <fmt/format.h>

#include <utility>

namespace sunder::ask {

MixedPair::MixedPair(const PairCall& asked, PairObject body, PairObject other, bool body_is_a, const PairFiles& files,
                     Space space)
    : PairQuestion(asked, std::move(body_is_a ? body : other), std::move(body_is_a ? other : body), files, space) {
  is_b_first_ = !body_is_a;
}

void MixedPair::tell_said_of(bool is_hull) {
  if (meet_ && is_hull) verdict_ = "meet as hulls";
  facts_.push_back({"said_of", meet_ && is_hull ? "hulls" : "bodies", ""});
}

std::string MixedPair::signs_text(DecidedBy decided_by) {
  return decided_by == DecidedBy::filter ? "signs, by floating-point filters alone"
                                         : "signs, with the help of exact arithmetic";
}

Told end_told(Told feature, Json point, const std::string& about_point, const ExactFraction& along_line, OwnEnd own,
              const char* whose) {
  const std::string t = along_line.text();
  Json json{{"point", std::move(point)}, {"along_line", t}};
  json.update(feature.json);
  if (own == OwnEnd::a) json["beginning"] = true;
  if (own == OwnEnd::b) json["end"] = true;
  const std::string place = fmt::format("about {}, {}", about_point, feature.text);
  if (own != OwnEnd::none) {
    return {std::move(json), fmt::format("{} {} at {}", whose, own == OwnEnd::a ? "beginning" : "end", place)};
  }
  // As a fraction where that is short.
  return {std::move(json),
          fmt::format("{}, t = {}", place, t.size() <= 20 ? t : "about " + about(along_line.nearest()))};
}

void add_ends(const Told& first, const Told& last, CutKind kind, Told& common) {
  common.json["first"] = first.json;
  common.json["last"] = last.json;
  common.text += kind == CutKind::point ? first.text : fmt::format("from {}\nto {}", first.text, last.text);
}

}  // namespace sunder::ask
