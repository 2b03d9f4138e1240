// Sets of indices, as sorted lists.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace sunder_verifier {

using Set = std::vector<std::size_t>;

inline Set as_set(Set all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

inline bool has(const Set& set, std::size_t k) { return std::binary_search(set.begin(), set.end(), k); }

inline Set sum(const Set& a, const Set& b) {
  Set result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

inline Set common(const Set& a, const Set& b) {
  Set result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

inline Set without(const Set& a, const Set& b) {
  Set result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

template <class Condition>
Set only(const Set& set, const Condition& condition) {
  Set result;
  std::copy_if(set.begin(), set.end(), std::back_inserter(result), condition);
  return result;
}

inline Set toggled(const Set& set, std::size_t k) {
  Set result;
  std::set_symmetric_difference(set.begin(), set.end(), &k, &k + 1, std::back_inserter(result));
  return result;
}

}  // namespace sunder_verifier
