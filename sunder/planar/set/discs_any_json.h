// Certificates of answers about a set of circles with their insides (docs/claims.md, "circles").
#pragma once

#include <sunder/near/cover_statement.h>
#include <sunder/planar/set/discs_all.h>
#include <sunder/planar/set/discs_any.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::planar {

// What was asked, for the functions of cover_statement.h. Kept by reference.
struct DiscsQuestion {
  using Contact = DiscsContact;
  static constexpr std::string_view table = "circles";

  const Discs& circles;
  Allowed allowed = Allowed::nothing;
  Groups groups{};

  void write_rows(ClaimsWriter& file) const;
  std::vector<Box2> boxes() const;
  void write_point(ClaimsWriter& file, std::uint32_t i, std::uint32_t j) const;
};

// The whole file. Answer: a DiscsAnswer, a DiscsAllAnswer in any order, or a CountAnswer.
template <class Answer>
std::string certificate_text(const Discs& circles, Allowed allowed, const Answer& answer, Groups groups = {}) {
  return cover_certificate_text(DiscsQuestion{circles, allowed, groups}, answer);
}

}  // namespace sunder::planar
