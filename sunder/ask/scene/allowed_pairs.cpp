#include <sunder/ask/scene/allowed_pairs.h>

#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace sunder::ask {

namespace {

int rank(const std::string& reason) {
  constexpr std::array<std::string_view, 3> first{"Never", "Default", "User"};
  const auto found = std::find(first.begin(), first.end(), reason);
  return is_of_neighbours(reason) ? 9 : static_cast<int>(found - first.begin());
}

}  // namespace

std::vector<AllowedFor> reasons_of(std::span<const AllowedPair> list) {
  std::vector<AllowedFor> reasons;
  for (const AllowedPair& pair : list) {
    auto known =
        std::find_if(reasons.begin(), reasons.end(), [&](const AllowedFor& r) { return r.reason == pair.reason; });
    if (known == reasons.end()) known = reasons.insert(known, {pair.reason, 0});
    ++known->pairs;
  }
  std::sort(reasons.begin(), reasons.end(), [](const AllowedFor& p, const AllowedFor& q) {
    return std::tuple(rank(p.reason), p.reason) < std::tuple(rank(q.reason), q.reason);
  });
  return reasons;
}

bool is_of_neighbours(const std::string& reason) { return io::in_small_letters(reason) == "adjacent"; }

std::string allowed_text(std::span<const AllowedPair> list) {
  std::string text;
  for (const auto& [reason, pairs] : reasons_of(list)) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", pairs, reason);
  }
  return fmt::format("{} of bodies ({})", io::count_of(list.size(), "pair"), text);
}

Json allowed_json(std::span<const AllowedPair> list) {
  Json json = Json::array();
  for (const auto& [reason, pairs] : reasons_of(list)) json.push_back({{"reason", reason}, {"pairs", pairs}});
  return json;
}

std::vector<std::string> left_out_texts(const LeftOutList& left_out, std::span<const AllowedPair> list) {
  std::vector<std::string> texts = left_out.texts();
  if (!list.empty()) texts.push_back(allowed_text(list) + ", which may meet");
  return texts;
}

std::string allowed_clause(std::span<const AllowedPair> list) {
  return list.empty() ? "" : "; allowed to meet, so not tested: " + allowed_text(list);
}

}  // namespace sunder::ask
