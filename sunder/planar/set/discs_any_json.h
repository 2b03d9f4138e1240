// Certificates of answers about a set of circles with their insides (docs/claims.md, "circles").
//
// None throws, but for want of memory, or what the writer's sink or `visit` throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/set/discs_all.h>
#include <sunder/planar/set/discs_any.h>

#include <cstdint>
#include <functional>
#include <string>

namespace sunder::planar {

// What was asked. Kept by reference.
struct DiscsQuestion {
  const Discs& circles;
  Allowed allowed = Allowed::nothing;
  Groups groups{};
};

// Each writes the table and the statement, and requires the true answer to this question, by whatever method: what
// proves it is made here. Cost: O(N log N) time, that of cover_order(), O(N) memory, and the length of the list.
// Two that meet, or that none do:
void write_statement(ClaimsWriter& file, const DiscsQuestion& question, const DiscsAnswer& answer);
// Exactly these meet. `visit` calls its argument for each, by i, then j.
using EachDiscsContact = std::function<void(const std::function<void(const DiscsContact&)>&)>;
void write_list_statement(ClaimsWriter& file, const DiscsQuestion& question, const EachDiscsContact& visit);
// So many meet:
void write_count_statement(ClaimsWriter& file, const DiscsQuestion& question, std::uint64_t number);

// The whole file.
std::string certificate_text(const Discs& circles, Allowed allowed, const DiscsAnswer& answer, Groups groups = {});
std::string certificate_text(const Discs& circles, Allowed allowed, DiscsAllAnswer answer, Groups groups = {});
std::string certificate_text(const Discs& circles, Allowed allowed, const CountAnswer& answer, Groups groups = {});

}  // namespace sunder::planar
