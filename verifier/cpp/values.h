// What statements say and claims bring: values of some types, each under its name; and rules, which take them.
#pragma once

#include <verifier/cpp/reader.h>
#include <verifier/cpp/tables.h>

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace sunder_verifier {

using Indices = std::vector<std::size_t>;  // some may be no_index, where a shape says so
using IndexLists = std::vector<Indices>;
using IndexPair = std::pair<std::size_t, std::size_t>;
using IndexPairs = std::vector<IndexPair>;
using Points = std::vector<Numbers>;       // or other rows of numbers
using Groups = std::vector<std::int64_t>;  // empty: each is one of its own

// Numbers of named things: weights of points, multipliers of half-spaces.
struct WeightList {
  Indices named;
  Numbers values;
};

// A triangle of a face: its first corner, this one and the next; or no face.
struct FaceHome {
  std::size_t face = no_index, corner = 0;
};

struct SweepEvents {
  std::vector<std::int64_t> at;     // an end: 2 i or 2 i + 1; or -1
  std::vector<std::int64_t> below;  // a segment, or -1
  std::vector<std::size_t> begin;   // event k has the segments row[begin[k]] to row[begin[k + 1]]
  std::vector<std::size_t> row;
};

// Two entries of a table, and a kind of contact; of pairs without kind the kind is empty.
struct StatedContact {
  std::size_t i = 0, j = 0;
  std::string kind;

  friend auto operator<=>(const StatedContact&, const StatedContact&) = default;
};
using StatedContacts = std::vector<StatedContact>;

// What does not count.
struct AllowedContacts {
  bool shared_endpoint = false, touch = false;
};

struct EndOnLine {
  Numbers point;
  std::size_t side = 0;
};
using TwoEnds = std::array<std::optional<EndOnLine>, 2>;

// A point of a body: of a hull, with a radius or without, one of its core, which the weights make; of others any, which
// the body holds by them.
struct SurfaceEnd {
  WeightList weights;
  Numbers point, from;  // not of a hull; from: of an ellipsoid only
};

// From the first corner of a triangle, or the point of a cell, along a direction.
struct StatedRay {
  std::size_t of = 0;
  Numbers along;
};
using StatedRays = std::vector<StatedRay>;

// A point of A less one of B.
struct SurfaceCorner {
  SurfaceEnd of_a, of_b;
};
using SurfaceCorners = std::vector<SurfaceCorner>;

// The points x with normal x = level.
struct StatedPlane {
  Integers normal;
  Integer level;
};

// What a member stands for: nothing but itself, or a mesh that is placed as it is; and what both are images of.
struct MeshMember {
  bool is_mesh = false;
  std::size_t mesh = 0, mesh_base = 0, body_base = 0;
};
using MeshMembers = std::vector<MeshMember>;

enum class ValidRule : std::uint8_t { valid, simple, with_self_touch };

// ---- What statements before have proved.

// Verdicts about two bodies or meshes, by their indices in the order of the statement, and by the number n 2^e, n odd,
// that the question says, if it says one.
using ProvedVerdicts = std::map<std::tuple<std::size_t, std::size_t, Integer, std::int64_t>, std::set<std::string>>;

// Of a flat hull the outline is the one face, of a segment its two ends are.
struct ProvedHull {
  std::string verdict;
  IndexLists faces;
};

struct Proved {
  // Null: none of this question.
  const ProvedVerdicts* of(const std::string& question) const {
    const auto found = verdicts.find(question);
    return found != verdicts.end() ? &found->second : nullptr;
  }

  std::map<std::string, ProvedVerdicts> verdicts;  // by their questions
  std::map<std::size_t, ProvedHull> hulls;         // by the indices of bodies
};

// ---- Values by name.

// What a file has, and a statement names: values point to it.
template <class T>
constexpr bool is_of_file = false;
template <class T>
  requires std::is_same_v<T, HullBody> || std::is_same_v<T, MeshBody> || std::is_same_v<T, RowBody> ||
               std::is_same_v<T, PolygonTable> || std::is_same_v<T, Segments> || std::is_same_v<T, Circles> ||
               std::is_same_v<T, Boxes> || std::is_same_v<T, Constraints> || std::is_same_v<T, Proved>
constexpr bool is_of_file<T> = true;

using Value =
    std::variant<std::size_t, std::string, Number, Numbers, Points, Indices, IndexLists, std::vector<IndexLists>,
                 IndexPairs, Groups, WeightList, std::vector<FaceHome>, SweepEvents, StatedContacts, AllowedContacts,
                 TwoEnds, MeshMembers, SurfaceCorners, StatedRays, StatedPlane, ValidRule,
                 std::shared_ptr<const PartTable>, const HullBody*, const MeshBody*, const RowBody*,
                 const PolygonTable*, const Segments*, const Circles*, const Boxes*, const Constraints*, const Proved*>;

// What a value is, or points to. Requires that it is of that type.
template <class T>
const T& as(const Value&& value) = delete;
template <class T>
const T& as(const Value& value) {
  if constexpr (std::is_same_v<T, Value>) {
    return value;  // NOLINT(bugprone-return-const-ref-from-parameter): temporaries are refused
  } else if constexpr (std::is_same_v<T, PartTable>) {
    return *std::get<std::shared_ptr<const T>>(value);
  } else if constexpr (is_of_file<T>) {
    return *std::get<const T*>(value);
  } else {
    return std::get<T>(value);
  }
}

// Names, and what they mean; and those of the scope around it. It must not be moved while it is in use, and names must
// outlive it.
class Scope {
 public:
  explicit Scope(const Scope* around = nullptr) : around_(around) {}

  // Values that were found before are found elsewhere then.
  void set(std::string_view name, Value value) { values_.emplace_back(name, std::move(value)); }

  // nullptr: nothing has that name.
  const Value* find(std::string_view name) const {
    for (const auto& [known, value] : values_) {
      if (known == name) return &value;
    }
    return around_ != nullptr ? around_->find(name) : nullptr;
  }

  // Requires that something has that name.
  const Value& operator[](std::string_view name) const { return *find(name); }

 private:
  const Scope* around_;
  std::vector<std::pair<std::string_view, Value>> values_;
};

// A rule takes so many values, in the order of its parameters; it throws Refused where the claim does not hold.
struct Rule {
  void (*check)(const Value* const* values);
  std::size_t count;
};

template <class... Parameters>
constexpr std::size_t count_of(void (*)(Parameters...)) {
  return sizeof...(Parameters);
}

template <class... Parameters>
void call(void (*function)(Parameters...), const Value* const* values) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    function(as<std::remove_cvref_t<Parameters>>(*values[k])...);
  }(std::index_sequence_for<Parameters...>());
}

template <auto function>
constexpr Rule rule{[](const Value* const* values) { call(function, values); }, count_of(function)};

}  // namespace sunder_verifier
