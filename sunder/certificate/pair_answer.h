// The answer to a question about two convex objects: the certificate, and how it came about.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/certificate/pair.h>

#include <cstdint>
#include <string_view>

namespace sunder {

// How an answer came about.
enum class DecidedBy : std::uint8_t {
  filter,     // the search's evidence in doubles, accepted by filters alone
  evidence,   // the search's evidence, made or accepted with the help of exact arithmetic
  finishing,  // an exact method, because the search's evidence did not hold
  scan,       // an exact method that looks at everything
};

std::string_view name_of(DecidedBy);  // "finishing"

// Where two objects that meet have their common points.
enum class Contact : std::uint8_t {
  none,         // apart
  touching,     // they meet, but their relative interiors do not: some plane parts them weakly
  overlapping,  // their relative interiors meet
};

std::string_view name_of(Contact);  // "touching"

struct [[nodiscard]] PairAnswer {
  PairCertificate evidence;
  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;

  bool meet() const { return evidence.verdict == Verdict::meet; }
  const PairCertificate& certificate() const { return evidence; }
};

// The same answer with the names of the two objects exchanged.
PairAnswer exchanged(const PairAnswer& answer);

// Sets how the answer came about, from how many signs exact arithmetic decided.
template <class Answer>
void conclude(Answer& answer, std::uint32_t exact_signs, bool finished = false) {
  answer.cost.exact = exact_signs;
  answer.decided_by = finished ? DecidedBy::finishing : exact_signs == 0 ? DecidedBy::filter : DecidedBy::evidence;
}

}  // namespace sunder
