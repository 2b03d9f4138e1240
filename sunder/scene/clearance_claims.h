// What clearance.h says of a scene, in certificate files (docs/claims.md, "clearance", "clearances", "distance").
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/pair_reasons.h>
#include <sunder/scene/scene_meshes.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace sunder::scene {

// Of each part of each body, its number in the file.
using PartNumbers = std::vector<std::vector<std::uint32_t>>;

// Notes what is said of the statement that follows, about all pairs of the scene or about those of two bodies.
// `others`: why pairs are not asked about, but for those that are allowed.
using NotePairs = std::function<void(bool is_of_scene, const PairReasons& others)>;

// States of two parts, as meshes: whether they are `least` apart, or more; without a number, how far they are. Tells what
// the statement about all pairs has from that.
using StateOfMeshes = std::function<void(ToldAsMeshes& told, const TwoParts& pair, std::optional<double> least)>;

// The pairs of which the functions below state something as meshes: those whose hulls are too close, and of these and two
// convex ones those of which one stands for a mesh in another pair.
std::vector<TwoParts> pairs_as_meshes(std::span<const Body> bodies, const ClearanceQuestion& question);
std::vector<TwoParts> pairs_as_meshes(std::span<const Body> bodies,
                                      const std::vector<std::array<std::uint32_t, 2>>& allowed,
                                      const PartDistance& nearest);

// States whether two parts, of these numbers in the file, are `least` apart, or more. False, and nothing is stated,
// where that is undecided. Cost: that of their clearance.
bool add_claims(PairClaims& claims, std::uint32_t of_a, const Part& a, std::uint32_t of_b, const Part& b, double least);

// States of each pair that has a margin, and is not undecided, whether it keeps it; then, for each margin, that this is
// of all of them. One statement is of all pairs but the allowed, the undecided, those that are stated as meshes, and those
// with a margin of their own; of these, each has its own. Cost: of each pair whose boxes do not tell, that of its distance, in exact numbers.
void add_claims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                const ClearanceQuestion& question, const ClearanceAnswer& answer, const StateOfMeshes& of_meshes,
                const NotePairs& note);

// States that all pairs but the allowed are as far apart as the lower bound of the nearest one's distance, or more
// (curved ones of which that cannot be told, and pairs that are stated as meshes, are among its exceptions); and of the nearest how far
// apart it is, exactly, or, where one has a radius, that it is nearer than the next double above the upper bound. Of
// parts that meet nothing: that they do is stated elsewhere. Cost: as above, of all pairs.
void add_claims(PairClaims& claims, std::span<const Body> bodies, const PartNumbers& numbers,
                const std::vector<std::array<std::uint32_t, 2>>& allowed, const PartDistance& nearest,
                const StateOfMeshes& of_meshes, const NotePairs& note);

}  // namespace sunder::scene
