// Certificates of which members of a set meet, proved by a cover (docs/claims.md, "Covers"): the table and a statement.
//
// A question says what is asked of which members, and keeps them by reference:
//   Question::Contact, Question::table   a ContactOfTwo; the name of the table, and of the question
//   allowed, groups                      what does not count
//   write_rows(file), boxes()            the members, and their boxes, which may be rounded
//   write_point(file, i, j)              the member "point": a point of both, exact
// Each function requires the true answer to the question, by whatever method: what proves it is made here. Cost:
// O(N log N) time, that of cover_order(), O(N) memory, and the length of the list.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/near/cover_order.h>
#include <sunder/near/set_question.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace sunder {

template <class Question>
void begin_cover_statement(ClaimsWriter& file, const Question& question, std::string_view verdict) {
  file.begin_table(Question::table);
  question.write_rows(file);
  file.end_table();
  file.begin_statement(Question::table);
  file.text("allowed", std::string(name_of(question.allowed)));
  if (!question.groups.empty()) file.indices("groups", question.groups);
  file.text("verdict", std::string(verdict));
}

template <class Question>
void end_cover_statement(ClaimsWriter& file, const Question& question) {
  file.begin_claims();
  file.begin_claim("cover");
  file.indices("order", cover_order(question.boxes(), question.groups));
  file.end_claim();
  file.end_statement();
}

// Two that meet, or that none do.
template <class Question>
void write_statement(ClaimsWriter& file, const Question& question,
                     const AnyAnswer<typename Question::Contact>& answer) {
  if (!answer.meet()) {
    begin_cover_statement(file, question, "none");
    end_cover_statement(file, question);
    return;
  }
  begin_cover_statement(file, question, "some");
  const auto [i, j, kind] = *answer.found;
  file.index("i", i);
  file.index("j", j);
  file.text("kind", std::string(name_of(kind)));
  question.write_point(file, i, j);
  file.begin_claims();
  file.begin_claim("contact");
  file.end_claim();
  file.end_statement();
}

// Exactly these meet. visit(take) calls take(contact) for each, by i, then j.
template <class Question, class Visit>
void write_list_statement(ClaimsWriter& file, const Question& question, const Visit& visit) {
  begin_cover_statement(file, question, "these");
  file.begin_list("contacts");
  visit([&](const typename Question::Contact& contact) {
    file.add_contact(contact.i, contact.j, name_of(contact.kind));
  });
  file.end_list();
  end_cover_statement(file, question);
}

// So many meet.
template <class Question>
void write_count_statement(ClaimsWriter& file, const Question& question, std::uint64_t number) {
  begin_cover_statement(file, question, "count");
  file.number("number", number);
  end_cover_statement(file, question);
}

template <class Question>
void write_statement(ClaimsWriter& file, const Question& question, AllAnswer<typename Question::Contact> answer) {
  std::sort(answer.contacts.begin(), answer.contacts.end());
  write_list_statement(file, question,
                       [&](const auto& take) { std::for_each(answer.contacts.begin(), answer.contacts.end(), take); });
}

template <class Question>
void write_statement(ClaimsWriter& file, const Question& question, const CountAnswer& answer) {
  write_count_statement(file, question, answer.count);
}

// The whole file, of any of these answers.
template <class Question, class Answer>
std::string cover_certificate_text(const Question& question, const Answer& answer) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  write_statement(file, question, answer);
  file.end();
  return text;
}

}  // namespace sunder
