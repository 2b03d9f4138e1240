// What sunder pair is asked about a bounded body and what need not be: a line, a ray, a plane, a half-plane; and how
// is told what a line, a ray or a segment has in common with a body, in the plane and in space.
#pragma once

#include <sunder/ask/pair/pair_question.h>

#include <sunder/certificate/cut.h>
#include <sunder/predicate/exact_point.h>

#include <string>

namespace sunder::ask {

// The body is A or B, and the first of the proof's file.
class MixedPair : public PairQuestion {
 protected:
  MixedPair(const PairCall& asked, PairObject body, PairObject other, bool body_is_a, const PairFiles& files,
            Space space = Space::solid);

  const char* letter() const { return is_b_first_ ? "B" : "A"; }  // of the body
  const char* other_letter() const { return is_b_first_ ? "A" : "B"; }

  // Of bodies of space, before other facts: that the body meets the other as the hull that it is.
  void tell_said_of(bool is_hull);

  // Signs alone decided: by filters, or not.
  static std::string signs_text(DecidedBy decided_by);
};

// An end of the part in common, which is at about that point; `whose` own end it may be: "its".
Told end_told(Told feature, Json point, const std::string& about_point, const ExactFraction& along_line, OwnEnd own,
              const char* whose);

// Adds where the part in common begins and ends; of a point that, once.
void add_ends(const Told& first, const Told& last, CutKind kind, Told& common);

}  // namespace sunder::ask
