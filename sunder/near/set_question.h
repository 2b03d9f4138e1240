// Questions about sets: do any two members have a contact that counts, which have one, how many are there? What counts,
// and what such questions are answered with.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/base/interruption.h>
#include <sunder/certificate/pair_answer.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace sunder {

// What does not count as a contact. Each allows what the one before does.
enum class Allowed : std::uint8_t {
  nothing,
  shared_endpoint,  // one common point that is an end of both: roads at a junction, consecutive edges
  touch,            // contacts in which no insides meet; of segments, in one point that is an end of one of them
};

std::string_view name_of(Allowed);  // "shared-endpoint"

// Of full bodies, where they have kinds of their own: `shared_endpoint` allows nothing.
inline bool counts(Relation contact, Allowed allowed) {
  return contact == Relation::overlapping || (contact == Relation::touching && allowed != Allowed::touch);
}

// A group for each member, as numbers: the members of one (the same net, ring, road) may meet and cross one another.
// Empty: there are none. Kept by reference. Every method throws Error bad_call where they are fewer or more than the
// members.
using Groups = std::span<const std::uint32_t>;

void check_groups(Groups groups, std::size_t members);

inline bool may_meet(Groups groups, std::uint32_t i, std::uint32_t j) {
  return !groups.empty() && groups[i] == groups[j];
}

// Are all members of one group? Then no contact counts.
bool are_one_group(Groups groups);

struct SetOptions {
  Allowed allowed = Allowed::nothing;
  Groups groups{};                                 // members of one group may meet
  std::function<void(double)> progress = nullptr;  // called now and then, or never, with the part that is done, below 1
};

// To be called at step k of so many; tells of the progress once in `every` steps, a power of two.
template <std::size_t every = 65536>
void tell_progress(const SetOptions& options, std::size_t k, std::size_t done, std::size_t all) {
  if (k % every != 0) return;
  may_be_interrupted(4 * every);
  if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(all));
}

// Two members, and how they meet.
template <class Kind>
struct ContactOfTwo {
  std::uint32_t i = 0, j = 0;  // i < j
  Kind kind = Kind::none;      // of a contact that was found never none
  friend auto operator<=>(const ContactOfTwo&, const ContactOfTwo&) = default;
};

// i and j in any order.
template <class Kind>
ContactOfTwo<Kind> contact_of(std::uint32_t i, std::uint32_t j, Kind kind) {
  return {std::min(i, j), std::max(i, j), kind};
}

template <class Found>
struct [[nodiscard]] AnyAnswer {
  std::optional<Found> found;  // a contact that counts; empty: there is none
  Cost cost;                   // each question says what its probes are

  bool meet() const noexcept { return found.has_value(); }
};

template <class Found>
struct [[nodiscard]] AllAnswer {
  std::vector<Found> found;  // in the order that the question says
  Cost cost;
};

// Count: a number, or one of each kind.
template <class Count = std::uint64_t>
struct [[nodiscard]] CountAnswer {
  Count count{};
  Cost cost;
};

// A method visits contacts until the visitor returns false; what it finds, as answers. Visit: Cost(visitor).
template <class Found, class Visit>
AnyAnswer<Found> first_of(const Visit& visit) {
  AnyAnswer<Found> answer;
  answer.cost = visit([&answer](const Found& contact) {
    answer.found = contact;
    return false;
  });
  return answer;
}

template <class Found, class Visit>
AllAnswer<Found> all_of(const Visit& visit) {
  AllAnswer<Found> answer;
  answer.cost = visit([&answer](const Found& contact) {
    answer.found.push_back(contact);
    return true;
  });
  return answer;
}

template <class Found, class Visit>
CountAnswer<> count_of(const Visit& visit) {
  CountAnswer<> answer;
  answer.cost = visit([&answer](const Found&) {
    ++answer.count;
    return true;
  });
  return answer;
}

}  // namespace sunder
