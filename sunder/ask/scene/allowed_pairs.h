// What is said of the pairs of bodies that `sunder scene` does not count, since they are allowed to meet, and why they are.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/robot/cell.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

using robot::AllowedPair;

// The reasons, and how many pairs have each: first those that say that a pair does not meet, or hardly ("Never"), or
// nothing about that; last that links are joined ("Adjacent"), which mostly meet.
struct AllowedFor {
  std::string reason;
  std::uint64_t pairs = 0;
};
std::vector<AllowedFor> reasons_of(std::span<const AllowedPair> list);
bool is_of_neighbours(const std::string& reason);

// "28 pairs of bodies (11 Never, 17 Adjacent)".
std::string allowed_text(std::span<const AllowedPair> list);

// [{"reason": "Never", "pairs": 11}, ..]
Json allowed_json(std::span<const AllowedPair> list);

// What a certificate does not speak of: what was left out of files, and these pairs.
std::vector<std::string> left_out_texts(const LeftOutList& left_out, std::span<const AllowedPair> list);

// "; allowed to meet, so not tested: 28 pairs ..", to stand behind what is said of others; or nothing.
std::string allowed_clause(std::span<const AllowedPair> list);

}  // namespace sunder::ask
