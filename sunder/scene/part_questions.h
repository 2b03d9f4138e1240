// What a scene asks of its parts: all that depends on what a part's shape is.
#pragma once

#include <sunder/scene/scene.h>
#include <sunder/scene/world_box.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>

namespace sunder::scene {

// What the last answer about two parts leaves to the next one.
using PairWarmStart = solid::WarmStart;

// The second is larger, and costs no walk.
WorldBox box_of(const Part& part);
Box3 rough_box_of(const Part& part);

// Has none of them a radius?
bool are_polyhedra(const Part& a, const Part& b);

// Of polyhedra: do they meet? By the question's method; the second from the last answer on, where that is the front
// door.
PairAnswer pair_answer(const Part& a, const Part& b, const Question& question);
PairAnswer pair_answer(const Part& a, const Part& b, const Question& question, PairWarmStart& last);

// Of others.
void take_round_answer(PartPair& pair, const Part& a, const Part& b);

// That their boxes are apart, as the certificate says: for bodies with a radius, too, its direction is one (W1).
void take_boxes(PartPair& pair, const Part& a, const Part& b, const PairCertificate& certificate);

// Counts the answer of `pair`, which the method gave, and says whether it counts, and of what kind the contact is,
// where that is asked for.
void count_answer(PartPair& pair, const Part& a, const Part& b, const Question& question, Counts& counts);

// The order of lists: by body_a, body_b, part_a, part_b.
bool is_listed_before(const PartPair& p, const PartPair& q);

}  // namespace sunder::scene
