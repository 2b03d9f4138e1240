// Certificates of which members of a set meet, proved by a cover (docs/claims.md, "Covers"): the table and a statement.
//
// Of a set, besides what set_methods.h asks for:
//   table_name(set)             of the table, and of the question: "circles"
//   boxes_of(set)               the members' boxes, which may be rounded
//   write_row(file, member)     in the table
//   write_point(file, a, b)     the member "point" of a statement: a point of both, exact
// Each function requires the true answer to the question, by whatever method: what proves it is made here. Cost:
// O(N log N) time, that of cover_order(), O(N) memory, and the length of the list.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/near/cover_order.h>
#include <sunder/near/set_methods.h>
#include <sunder/near/set_question.h>
#include <sunder/near/set_statement.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace sunder {

// What is asked of which members. Kept by reference.
template <class Set>
struct CoverQuestion {
  using Contact = ContactIn<Set>;

  const Set& members;
  Allowed allowed = Allowed::nothing;
  Groups groups{};
};

template <class Set>
void begin_cover_statement(ClaimsWriter& file, const CoverQuestion<Set>& question, std::string_view verdict) {
  begin_set_statement(file, table_name(question.members), question.members, question.allowed, question.groups, verdict);
}

template <class Set>
void end_cover_statement(ClaimsWriter& file, const CoverQuestion<Set>& question) {
  file.begin_claims();
  file.begin_claim("cover");
  file.indices("order", cover_order(boxes_of(question.members), question.groups));
  file.end_claim();
  file.end_statement();
}

// Two that meet, or that none do.
template <class Set>
void write_statement(ClaimsWriter& file, const CoverQuestion<Set>& question, const AnyAnswer<ContactIn<Set>>& answer) {
  if (!answer.meet()) {
    begin_cover_statement(file, question, "none");
    end_cover_statement(file, question);
    return;
  }
  begin_cover_statement(file, question, "some");
  end_some_statement(file, question.members, *answer.found);
}

// Exactly these meet. visit(take) calls take(contact) for each, by i, then j.
template <class Set, class Visit>
void write_list_statement(ClaimsWriter& file, const CoverQuestion<Set>& question, const Visit& visit) {
  begin_cover_statement(file, question, "these");
  write_contacts<ContactIn<Set>>(file, visit);
  end_cover_statement(file, question);
}

// So many meet.
template <class Set>
void write_count_statement(ClaimsWriter& file, const CoverQuestion<Set>& question, std::uint64_t number) {
  begin_cover_statement(file, question, "count");
  file.number("number", number);
  end_cover_statement(file, question);
}

template <class Set>
void write_statement(ClaimsWriter& file, const CoverQuestion<Set>& question, AllAnswer<ContactIn<Set>> answer) {
  std::sort(answer.found.begin(), answer.found.end());
  write_list_statement(file, question,
                       [&](const auto& take) { std::for_each(answer.found.begin(), answer.found.end(), take); });
}

template <class Set>
void write_statement(ClaimsWriter& file, const CoverQuestion<Set>& question, const CountAnswer<>& answer) {
  write_count_statement(file, question, answer.count);
}

// The whole file, of any of these answers.
template <class Set, class Answer>
std::string cover_certificate_text(const CoverQuestion<Set>& question, const Answer& answer) {
  return claims_text({}, [&](ClaimsWriter& file) { write_statement(file, question, answer); });
}

}  // namespace sunder
