// What sunder pair is asked about a bounded body and an object that may be unbounded: a line, a ray, a plane or a
// half-plane. Also the words for the common part of a body and a line, a ray or a segment, in the plane and in space.
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

  // Tells whether the answer is about the body, or about the hull that stands for its mesh. For bodies of space; call
  // it before other facts are added.
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
