#include "statement.h"

#include <utility>

namespace sunder_verifier {

Statement make_statement(const std::string& about, const std::string& rule, const std::string& verdict,
                         std::function<void()> check) {
  Statement statement;
  statement.result.name_a = about;
  statement.result.name_b = rule;
  statement.result.verdict = verdict;
  statement.check = std::move(check);
  return statement;
}

void require(bool condition, const char* check, const std::string& reason) {
  if (!condition) throw Refused{check, reason};
}

namespace {

const json& list_of(const json& item, const char* key, std::size_t count, const std::string& where) {
  const json& list = list_member(item, key, where);
  if (count != no_index && list.size() != count) {
    refuse_form(where + "." + key + " is not a list of " + std::to_string(count));
  }
  return list;
}

}  // namespace

std::vector<std::size_t> index_list(const json& item, const char* key, std::size_t size, std::size_t count,
                                    const std::string& where) {
  std::vector<std::size_t> result;
  const std::string entry_where = where + "." + key + " entry";
  for (const json& entry : list_of(item, key, count, where)) result.push_back(read_index(entry, size, entry_where));
  return result;
}

std::vector<std::size_t> index_or_none_list(const json& item, const char* key, std::size_t size, std::size_t count,
                                            const std::string& where) {
  std::vector<std::size_t> result;
  const std::string entry_where = where + "." + key + " entry that is not -1";
  for (const json& entry : list_of(item, key, count, where)) {
    result.push_back(is_minus_one(entry) ? no_index : read_index(entry, size, entry_where));
  }
  return result;
}

std::string read_rule(const json& item, const std::string& where) {
  std::string rule = string_member(item, "allowed", where);
  if (rule != "nothing" && rule != "shared-endpoint" && rule != "touch") {
    refuse_form(where + ".allowed is none of nothing, shared-endpoint, touch");
  }
  return rule;
}

std::vector<std::int64_t> read_groups(const json& item, std::size_t size, const std::string& where) {
  constexpr std::int64_t most = 999'999'999'999'999;  // all JSON readers agree about whole numbers up to this
  std::vector<std::int64_t> result;
  for (const json& entry : list_of(item, "groups", size, where)) {
    const bool is_small = entry.is_number_unsigned() ? entry.get<std::uint64_t>() <= most
                                                     : entry.is_number_integer() && entry.get<std::int64_t>() >= -most;
    if (!is_small) refuse_form(where + ".groups has an entry that is not a whole number of at most 15 digits");
    result.push_back(entry.get<std::int64_t>());
  }
  return result;
}

bool is_minus_one(const json& value) {
  return value.is_number_integer() && !value.is_number_unsigned() && value.get<std::int64_t>() == -1;
}

void require_each_end_once(const std::vector<std::size_t>& events, std::size_t size, const std::string& of) {
  std::vector<bool> seen(2 * size);
  bool are_once = events.size() == seen.size();
  for (std::size_t k = 0; k < events.size() && are_once; ++k) {
    are_once = !seen[events[k]];
    seen[events[k]] = true;
  }
  require(are_once, "T1", "the events are not each end of each " + of + " once");
}

}  // namespace sunder_verifier
