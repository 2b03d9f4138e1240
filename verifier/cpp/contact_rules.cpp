// Which entries of a table have a contact that counts: docs/claims.md, "contact", "cover", "none_counts" and those
// after it.
#include <verifier/cpp/contacts.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <utility>

namespace sunder_verifier {
namespace {

std::string pair_text(std::size_t i, std::size_t j) { return std::to_string(i) + " and " + std::to_string(j); }

// Those that count are those listed, by i, then j. Refuses by that rule.
void require_listed(const char* rule, const Contacts& contacts, const StatedContacts& listed) {
  std::vector<bool> found(listed.size());
  contacts.visit([&](std::size_t i, std::size_t j, const char* kind) {
    const auto at =
        std::lower_bound(listed.begin(), listed.end(), std::pair(i, j),
                         [](const StatedContact& c, const auto& pair) { return std::pair(c.i, c.j) < pair; });
    const bool is_listed = at != listed.end() && at->i == i && at->j == j && at->kind == kind;
    require(is_listed, rule, pair_text(i, j) + " have a contact that counts, and is not listed");
    found[static_cast<std::size_t>(at - listed.begin())] = true;
  });
  for (std::size_t k = 0; k < listed.size(); ++k) {
    require(found[k], rule, pair_text(listed[k].i, listed[k].j) + " have no contact that counts");
  }
}

void require_number(const char* rule, const Contacts& contacts, std::size_t number) {
  const std::uint64_t count = contacts.number();
  require(count == number, rule, std::to_string(count) + " contacts count");
}

template <class Member>
void check_contact_of(const MemberTable<Member>& members, std::size_t i, std::size_t j, const std::string& kind,
                      const Numbers& point, const Groups& groups, const AllowedContacts& allowed) {
  take_steps(16, length(point), members.bits);
  const SweepPoint place = place_in_units(point, members.exponent);
  require(i != j && (groups.empty() || groups[i] != groups[j]), "contact", pair_text(i, j) + " are of one group");
  require(counts(kind, allowed), "contact", kind + " does not count");
  for (const std::size_t k : {i, j}) {
    require(holds(members[k], place), "contact", "the point is not in " + std::to_string(k));
  }
  const std::string found = kind_of(members[i], members[j]);
  require(found == kind, "contact", "the contact is " + found);
}

Contacts swept(const SweepEvents& events, const Value& table, const Groups& groups, const AllowedContacts& allowed) {
  const auto* const segments = std::get_if<const Segments*>(&table);
  return segments != nullptr ? contacts_of(events, **segments, groups, allowed)
                             : contacts_of(events, as<PolygonTable>(table), groups, allowed);
}

void check_contact(const Value& table, std::size_t i, std::size_t j, const std::string& kind, const Numbers& point,
                   const Groups& groups, const AllowedContacts& allowed) {
  const auto check = [&](const auto& members) { check_contact_of(members, i, j, kind, point, groups, allowed); };
  if (const auto* const circles = std::get_if<const Circles*>(&table)) return check(**circles);
  if (const auto* const boxes = std::get_if<const Boxes*>(&table)) return check(**boxes);
  if (const auto* const segments = std::get_if<const Segments*>(&table)) return check(**segments);
  check(as<PartTable>(table).polygons.edges);
}

void check_none_counts(const SweepEvents& events, const Value& table, const Groups& groups,
                       const AllowedContacts& allowed) {
  require_listed("none_counts", swept(events, table, groups, allowed), {});
}

void check_these_count(const SweepEvents& events, const Value& table, const Groups& groups,
                       const AllowedContacts& allowed, const StatedContacts& contacts) {
  require_listed("these_count", swept(events, table, groups, allowed), contacts);
}

void check_number_counts(const SweepEvents& events, const Value& table, const Groups& groups,
                         const AllowedContacts& allowed, std::size_t number) {
  require_number("number_counts", swept(events, table, groups, allowed), number);
}

void check_cover(const Indices& order, const Value& table, const Groups& groups, const AllowedContacts& allowed,
                 const Value& listed) {
  const auto* const circles = std::get_if<const Circles*>(&table);
  const Contacts contacts = circles != nullptr ? contacts_of(order, **circles, groups, allowed)
                                               : contacts_of(order, as<Boxes>(table), groups, allowed);
  const auto* const number = std::get_if<std::size_t>(&listed);
  if (number != nullptr) return require_number("cover", contacts, *number);
  require_listed("cover", contacts, as<StatedContacts>(listed));
}

}  // namespace

Contacts counted_one_by_one(std::function<void(const VisitContact& visit)> visit) {
  return {visit, [visit] {
            std::uint64_t count = 0;
            visit([&](std::size_t, std::size_t, const char*) { ++count; });
            return count;
          }};
}

bool counts(const std::string& kind, const AllowedContacts& allowed) {
  const bool is_end = kind == "shared-endpoint" || kind == "touching";
  return !(is_end && allowed.shared_endpoint) && !(kind == "touch" && allowed.touch);
}

bool is_kind_of(const Value& table, const std::string& kind) {
  const bool are_full = std::holds_alternative<const Circles*>(table) || std::holds_alternative<const Boxes*>(table);
  return are_full ? kind == "touching" || kind == "overlapping" || kind == "inside"
                  : kind == "shared-endpoint" || kind == "touch" || kind == "crossing" || kind == "overlap";
}

const ClaimRows claims_of_contacts{
    {"contact", "", rule<check_contact>},
    {"none_counts", "events: sweep of subject", rule<check_none_counts>},
    {"these_count", "events: sweep of subject", rule<check_these_count>},
    {"number_counts", "events: sweep of subject", rule<check_number_counts>},
    {"cover", "order: order of subject", rule<check_cover>},
};

}  // namespace sunder_verifier
