// What sunder pair is asked about two bounded objects, of the plane or of space: do they meet, and how; how far apart
// are they, how deep in each other, are they as far apart as they should be? BoundedPair chooses the questions, and the
// order and the words of the answers. A class for each kind of objects finds the answers.
#pragma once

#include <sunder/ask/pair/pair_question.h>

#include <array>
#include <optional>
#include <string>

namespace sunder::ask {

// A distance or a depth, which the interval encloses.
struct Measure {
  Interval length;
  std::optional<std::array<Told, 2>> between{};  // features of A and of B, where they are known
  std::string square{};                          // of a depth: a fraction, where that is known
  WorldDirection direction{Point3{}};            // of a depth: from A to B; A is moved back along it
};

// The clearance that is asked about; 0: none. Throws Error bad_call for what is no number above zero.
double least_clearance(const PairCall& call);

// The facts "distance" and "clearance". is_of_hulls: of the hulls of meshes.
Fact told_distance(const Measure& found, bool is_of_hulls);
Fact told_clearance(Verdict found, double least, const Interval& distance, bool is_of_hulls);

class BoundedPair : public PairQuestion {
 public:
  void ask();

 protected:
  // is_hull: one of them is the hull of the mesh that it stands for.
  BoundedPair(const PairCall& asked, PairObject a, PairObject b, bool is_hull, const PairFiles& files, Space space);
  ~BoundedPair() = default;

  // Each is called where its answer is asked for, in this order, and states that answer.
  virtual void decide() = 0;                       // tells the evidence; where --classify is given, contact_
  virtual Measure distance() = 0;                  // states it only where --distance is given
  virtual Measure depth() = 0;                     // they meet
  virtual Verdict clearance_of(double least) = 0;  // apart: kept; meet: broken. Has the distance

 private:
  Fact told_depth(const Measure& found);

  bool is_hull_;
  double least_;  // the clearance that is asked about; 0: none
};

}  // namespace sunder::ask
