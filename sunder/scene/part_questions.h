// What a scene asks of its parts.
#pragma once

#include <sunder/scene/scene.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>
#include <sunder/solid/round/world_box.h>

namespace sunder::scene {

// What the last answer about two parts leaves to the next one.
using PairWarmStart = solid::WarmStart;

// The second is larger, and costs no walk.
solid::WorldBox box_of(const Part& part);
Box3 rough_box_of(const Part& part);

// Do they meet? Two polyhedra by the question's method; the second from the last answer on, where that is the front
// door.
solid::RoundAnswer answer_of(const Part& a, const Part& b, const Question& question);
solid::RoundAnswer answer_of(const Part& a, const Part& b, const Question& question, PairWarmStart& last);

// Asks about parts as they are, where their shapes are not apart, and one of them is the hull of a mesh. The answer is
// kept in pair.meshes, which stays empty for poses beyond can_be_placed().
void look_closer(PartPair& pair, const Part& a, const Part& b);

// Counts the answer of `pair`, which the method gave, and says whether it counts, and whether they touch or overlap,
// where that is asked for.
void count_answer(PartPair& pair, const Part& a, const Part& b, const Question& question, Counts& counts);

// The order of lists: by body_a, body_b, part_a, part_b.
bool is_listed_before(const PartPair& p, const PartPair& q);

}  // namespace sunder::scene
