#include <cli/words.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace sunder::cli {

std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);  // of beginnings of a, with those of b
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      const bool is_swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string nearest_word(std::string_view word, std::span<const std::string> words) {
  const std::size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  std::size_t least = 3;
  const std::string* nearest = nullptr;
  for (const std::string& other : words) {
    const std::size_t edits = edits_between(word, other);
    if (edits >= least || 2 * edits >= letters) continue;
    least = edits;
    nearest = &other;
  }
  if (nearest != nullptr) return *nearest;
  const auto begins = [&](const std::string& other) { return letters > 1 && other.starts_with(word); };
  const auto found = std::find_if(words.begin(), words.end(), begins);
  return std::count_if(words.begin(), words.end(), begins) == 1 ? *found : "";
}

std::string did_you_mean(std::string_view word, std::span<const std::string> words) {
  const std::string nearest = nearest_word(word, words);
  return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

}  // namespace sunder::cli
