// Which entries of a table have a contact that counts: docs/claims.md, "contact", "cover", "none_counts" and those
// after it.
#include <verifier/cpp/contacts.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <set>
#include <string_view>
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

// Calls for each two polygons that have common points that count; overlapping are those inside of which some are.
void visit_kinds(const SweepEvents& events, const PolygonTable& polygons, const Groups& groups,
                 const AllowedContacts& allowed, const VisitContact& visit) {
  const AllowedContacts touch{true, true};
  std::set<std::pair<std::size_t, std::size_t>> overlapping;
  contacts_of(events, polygons, groups, touch).visit([&](std::size_t i, std::size_t j, const char*) {
    overlapping.insert({i, j});
  });
  contacts_of(events, polygons, groups, allowed).visit([&](std::size_t i, std::size_t j, const char*) {
    visit(i, j, overlapping.contains({i, j}) ? "overlapping" : "touching");
  });
}

void check_these_kinds(const SweepEvents& events, const PolygonTable& polygons, const Groups& groups,
                       const AllowedContacts& allowed, const StatedContacts& kinds) {
  require_listed("these_kinds", counted_one_by_one([&](const VisitContact& visit) {
                   visit_kinds(events, polygons, groups, allowed, visit);
                 }),
                 kinds);
}

void check_kinds_count(const SweepEvents& events, const PolygonTable& polygons, const Groups& groups,
                       const AllowedContacts& allowed, std::size_t overlapping, std::size_t touching) {
  std::size_t all = 0, inside = 0;
  visit_kinds(events, polygons, groups, allowed, [&](std::size_t, std::size_t, std::string_view kind) {
    ++all;
    if (kind == "overlapping") ++inside;
  });
  require(inside == overlapping && all == overlapping + touching, "kinds_count",
          std::to_string(inside) + " of " + std::to_string(all) + " contacts are inside of both");
}

void check_how_two_meet(const SweepEvents& events, const PartTable& pair, const std::string& verdict) {
  std::string found = "apart";
  visit_kinds(events, pair.polygons, {}, {}, [&](std::size_t, std::size_t, const char* kind) { found = kind; });
  require(found == verdict, "how_two_meet", "they are " + found);
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
  if (std::holds_alternative<const PolygonTable*>(table)) return kind == "touching" || kind == "overlapping";
  const bool are_full = std::holds_alternative<const Circles*>(table) || std::holds_alternative<const Boxes*>(table);
  return are_full ? kind == "touching" || kind == "overlapping" || kind == "inside"
                  : kind == "shared-endpoint" || kind == "touch" || kind == "crossing" || kind == "overlap";
}

const ClaimRows claims_of_contacts{
    {"contact", "", rule<check_contact>},
    {"none_counts", "events: sweep of subject", rule<check_none_counts>},
    {"these_count", "events: sweep of subject", rule<check_these_count>},
    {"number_counts", "events: sweep of subject", rule<check_number_counts>},
    {"these_kinds", "events: sweep of subject", rule<check_these_kinds>},
    {"kinds_count", "events: sweep of subject", rule<check_kinds_count>},
    {"how_two_meet", "events: sweep of subject", rule<check_how_two_meet>},
    {"cover", "order: order of subject", rule<check_cover>},
};

}  // namespace sunder_verifier
