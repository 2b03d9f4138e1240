// Sunder's answers about pairs: taken as a caller takes them, and added up.
#pragma once

#include <bench/contest/contest.h>

#include <sunder/certificate/pair_answer.h>

namespace bench {

// The compiler has to suppose that all of the answer, its certificate too, is read here.
template <class Answer>
void consume(const Answer& answer) {
  asm volatile("" : : "g"(&answer) : "memory");
}

// ask(k) gives the answer of input k; its certificate is included, the answer is not kept.
template <class Ask>
Run run_pairs(Ask ask) {
  return each([ask = std::move(ask)](std::size_t k) {
    const sunder::PairAnswer answer = ask(k);
    consume(answer);
    return answer.meet();
  });
}

template <class Answer>
Tally tally_of(const Answer& answer, bool wrong) {
  const auto by = [&](sunder::DecidedBy how) -> std::uint64_t { return answer.decided_by == how ? 1 : 0; };
  return {1,
          by(sunder::DecidedBy::filter),
          by(sunder::DecidedBy::evidence),
          by(sunder::DecidedBy::finishing),
          answer.cost.probes,
          answer.cost.iterations,
          answer.cost.exact,
          wrong ? 1U : 0U};
}

}  // namespace bench
