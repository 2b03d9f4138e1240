// The answer to a question: the evidence, and how it came about.
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

// The evidence is a variant of plain data, which names no object, and the verdict is that of what it holds: of two
// objects a Verdict (then meet() and undecided() are there), of a linear program an Optimum (optimum.h).
template <class EvidenceOf>
struct [[nodiscard]] Answer {
  using Evidence = EvidenceOf;

  Evidence evidence{};
  DecidedBy decided_by = DecidedBy::filter;  // of undecided ones: what was tried last
  Cost cost{};

  auto verdict() const { return verdict_of(evidence); }
  bool meet() const { return verdict() == Verdict::meet; }
  bool undecided() const { return verdict() == Verdict::undecided; }
};

using PairAnswer = Answer<PairCertificate>;

// The answer to how two objects, or their boundaries, lie to each other.
struct [[nodiscard]] RelationAnswer {
  Relation relation = Relation::none;
  Cost cost;
};

// Of boundaries. `a_inside`, `b_inside`: is one strictly on the inner side of all edges or facets of the other?
inline Relation relation_of_boundaries(bool meet, bool a_inside, bool b_inside) {
  return !meet ? Relation::none : a_inside ? Relation::a_inside_b : b_inside ? Relation::b_inside_a : Relation::meeting;
}

// The same answer with the names of the two objects exchanged.
PairAnswer exchanged(const PairAnswer& answer);

// Sets how the answer came about, from how many signs exact arithmetic decided.
template <class AnyAnswer>
void conclude(AnyAnswer& answer, std::uint32_t exact_signs, bool finished = false) {
  answer.cost.exact = exact_signs;
  answer.decided_by = finished ? DecidedBy::finishing : exact_signs == 0 ? DecidedBy::filter : DecidedBy::evidence;
}

}  // namespace sunder
