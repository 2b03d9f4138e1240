// A question with one answer, as a verb: what is the same for all such. One call writes the proof, the picture and the
// report, for people or in JSON.
//
// What is a question's own is a class, here Question, which has read its inputs:
//   call                        what was asked: a QuestionCall, or what derives from it
//   verb, drawn_noun, drawn()   "region"; things that a picture shows, and how many
//   ask()                       answers; throws Error
//   certificate(), picture()    texts of the files, where they are asked for
//   answer(), yes()             the word in the report; is the exit code 1?
//   text()                      for people: all but the lines below
//   cost(), cost_text()         counted; in words
//   not_proved()                what of all this a proof does not say, in words
//   add_to(report)              to the report in JSON
#pragma once

#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/certificate/origin.h>
#include <sunder/io/text/file.h>

#include <cstddef>
#include <string>

namespace sunder::ask {

// For people, the first of a list: text_of(k), each a line; then how many more JSON has.
template <class TextOf>
std::string first_of(std::size_t size, std::size_t most, const TextOf& text_of) {
  std::string text;
  for (std::size_t k = 0; k < size && k < most; ++k) text += text_of(k);
  if (size > most) text += "  and " + std::to_string(size - most) + " more; --json has all\n";
  return text;
}

template <class Question>
Json report_of(const Question& question) {
  Json json = envelope(Question::verb, question.answer(), question.call.method);
  json["cost"] = to_json(question.cost());
  question.add_to(json);
  if (question.call.proves()) json["not_proved"] = question.not_proved();
  return json;
}

// Returns the exit code.
template <class Question>
int answer(Question& question) {
  const QuestionCall& call = question.call;
  if (!call.svg.empty()) require_drawable(question.drawn(), Question::drawn_noun, 0, call.svg_limit);
  question.ask();
  if (call.proves()) io::write_file_atomically(call.certificate, question.certificate());
  if (!call.svg.empty()) io::write_file_atomically(call.svg, question.picture());
  if (call.json) {
    print(to_text(report_of(question)));
  } else {
    print_for_people(question.text() + titled("cost", question.cost_text()) + file_line("proof", call.certificate) +
                     (call.proves() ? not_proved_line(question.not_proved()) : "") + file_line("picture", call.svg));
  }
  return question.yes() ? exit_code::yes : exit_code::no;
}

}  // namespace sunder::ask
