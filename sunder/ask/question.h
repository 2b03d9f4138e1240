// A question with one answer, as a verb: what is the same for all such. One call writes the proof and the picture, and
// returns the report.
//
// What is a question's own is a class, here Question, which has read its inputs:
//   call                        what was asked: a QuestionCall, or what derives from it
//   verb, drawn_noun, drawn()   "region"; things that a picture shows, and how many
//   ask()                       answers; throws Error
//   certificate(), picture()    texts of the files, where they are asked for
//   report()                    all but what is said here for all questions
#pragma once

#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/certificate/origin.h>

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
Report answer(Question&& question, Talk& talk) {
  const QuestionCall& call = question.call;
  if (!call.svg.empty()) require_drawable(question.drawn(), Question::drawn_noun, 0, call.svg_limit);
  question.ask();
  if (call.proves()) talk.write_file(call.certificate, question.certificate());
  if (!call.svg.empty()) talk.write_file(call.svg, question.picture());
  Report report = question.report();
  report.verb = Question::verb;
  report.method = call.method;
  report.notes = talk.notes();
  report.is_proved = call.proves();
  report.proof = call.certificate;
  report.picture = call.svg;
  return report;
}

}  // namespace sunder::ask
