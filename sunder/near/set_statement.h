// Statements about which members of a set meet, in certificate files: what those proved by a cover and those proved by
// a sweep share (docs/claims.md, "Covers", "Sweeps").
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/near/set_question.h>

#include <cstdint>
#include <string_view>

namespace sunder {

// The table, by write_row(file, member), and the statement of the same name up to its verdict.
template <class Members>
void begin_set_statement(ClaimsWriter& file, std::string_view name, const Members& members, Allowed allowed,
                         Groups groups, std::string_view verdict) {
  file.begin_table(name);
  for (std::uint32_t i = 0; i < members.size(); ++i) write_row(file, members[i]);
  file.end_table();
  file.begin_statement(name);
  file.text("allowed", name_of(allowed));
  if (!groups.empty()) file.indices("groups", groups);
  file.text("verdict", verdict);
}

// Of `some`: the two, how they meet, a point of both by write_point(file, member, member), and the end.
template <class Members, class Found>
void end_some_statement(ClaimsWriter& file, const Members& members, const Found& found) {
  file.index("i", found.i);
  file.index("j", found.j);
  file.text("kind", name_of(found.kind));
  write_point(file, members[found.i], members[found.j]);
  file.begin_claims();
  file.claim("contact");
  file.end_statement();
}

// Of `these`: visit(take) calls take(contact) for each, by i, then j.
template <class Contact, class Visit>
void write_contacts(ClaimsWriter& file, const Visit& visit) {
  file.begin_list("contacts");
  visit([&](const Contact& contact) { file.add_contact(contact.i, contact.j, name_of(contact.kind)); });
  file.end_list();
}

}  // namespace sunder
