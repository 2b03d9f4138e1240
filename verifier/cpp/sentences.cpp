#include <verifier/cpp/sentences.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>

namespace sunder_verifier {
namespace {

constexpr std::size_t most_entries = 10;  // of a list
constexpr std::size_t most_digits = 40;   // of a number

constexpr std::array<std::array<const char*, 2>, 10> ones{{
    {"bodies", "body"},
    {"polytopes", "polytope"},
    {"meshes", "mesh"},
    {"segments", "segment"},
    {"circles", "circle"},
    {"boxes", "box"},
    {"polygons", "polygon"},
    {"half_planes", "half-plane"},
    {"rings", "ring"},
    {"convex_polygons", "convex polygon"},
}};

constexpr std::array<std::array<const char*, 2>, 9> region_words{{
    {"empty", "empty"},
    {"point", "a point"},
    {"segment", "a segment"},
    {"ray", "a ray"},
    {"line", "a line"},
    {"strip", "a strip"},
    {"half-plane", "a half-plane"},
    {"unbounded", "a region without bounds"},
    {"bounded", "a bounded region"},
}};

// The bytes of so many characters.
std::size_t bytes_of(const std::string& text, std::size_t most) {
  std::size_t k = 0;
  for (std::size_t seen = 0; k < text.size(); ++k) {
    if ((text[k] & 0xC0) != 0x80 && seen++ == most) break;
  }
  return k;
}

// What an ASCII escape of a code point looks like: "\u00e4", of those beyond 16 bits two of them.
void add_escaped(std::uint32_t code, std::string& text) {
  constexpr std::string_view digits = "0123456789abcdef";
  if (code > 0xffff) {
    add_escaped(0xd7c0 + (code >> 10), text);
    code = 0xdc00 + (code & 0x3ff);
  }
  text += "\\u";
  for (int shift = 12; shift >= 0; shift -= 4) text += digits[(code >> shift) & 15];
}

std::string plain(const Json& value) {
  return value.is_string() ? std::string(value.text()) : std::to_string(value.integer());
}

template <class Text>
std::string joined(const Json& list, std::size_t most, const char* between, Text text_of) {
  std::string text;
  for (const Json& entry : list) {
    if (most-- == 0) break;
    text += (text.empty() ? "" : between) + text_of(entry);
  }
  return text;
}

std::string shown_entry(const Json& entry) {
  return entry.is_array() ? joined(entry, entry.size(), " ", plain) : plain(entry);
}

bool is_short(const Json& point) {
  for (const Json& number : point) {
    if (number.size() > most_digits) return false;
  }
  return true;
}

// How many pairs of so many members a statement is about.
std::size_t pairs_asked(const Json& item, std::size_t size) {
  std::vector<std::int64_t> groups;
  if (item.contains("groups")) {
    for (const Json& group : item["groups"]) groups.push_back(group.integer());
  }
  std::map<std::int64_t, std::size_t> in_group;
  std::size_t pairs = size * (size - 1) / 2;
  for (const std::int64_t group : groups) pairs -= in_group[group]++;
  if (!item.contains("except")) return pairs;
  for (const Json& pair : item["except"]) {
    const auto group = [&](std::size_t k) { return groups[static_cast<std::size_t>(pair[k].integer())]; };
    if (groups.empty() || group(0) != group(1)) --pairs;
  }
  return pairs;
}

template <std::size_t size>
std::string found(const std::array<std::array<const char*, 2>, size>& table, const std::string& key) {
  const auto known = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row[0] == key; });
  return known == table.end() ? "" : (*known)[1];
}

std::string region_text(const Json& item, const std::string& verdict) {
  const std::string kind = found(region_words, verdict);
  return item.contains("sides") && !item["sides"].empty() ? kind + ", of sides " + shown(item["sides"]) : kind;
}

// Of facets, which are lists of simplices.
std::string facets_text(const Json& facets) {
  std::size_t simplices = 0;
  for (const Json& facet : facets) simplices += facet.size();
  return std::to_string(facets.size()) + " facets, made of " + std::to_string(simplices) + " simplices of " +
         std::to_string(facets[0][0].size()) + " corners";
}

// Of members, how many of them are meshes.
std::string meshes_text(const Json& item) {
  if (!item.contains("as_meshes")) return "";
  std::size_t count = 0;
  for (const Json& entry : item["as_meshes"]) count += entry.is_null() ? 0u : 1u;
  if (count == 0) return "";
  return ", of which " + std::to_string(count) + (count == 1 ? " is a mesh," : " are meshes,");
}

// Which members stand for which.
std::string meshes_of_members_text(const Json& item) {
  if (!item.contains("as_meshes")) return "";
  std::string text;
  std::size_t member = 0, count = 0;
  for (const Json& entry : item["as_meshes"]) {
    const std::size_t k = member++;
    if (entry.is_null() || ++count > most_entries) continue;
    text += ", member " + std::to_string(k) + " is mesh " + std::to_string(entry.integer());
  }
  if (count > most_entries) text += " and " + std::to_string(count - most_entries) + " more";
  return text;
}

std::string rules_text(const Json& item) {
  std::string text;
  if (item.contains("allowed") && item["allowed"].text() != "nothing") {
    text = std::string(item["allowed"].text()) + " allowed";
    if (!meshes_text(item).empty()) text += ", of meshes insides alone are compared";
  }
  if (item.contains("groups")) {
    std::set<std::int64_t> different;
    for (const Json& group : item["groups"]) different.insert(group.integer());
    text += text.empty() ? "" : ", ";
    text += "members of one of " + std::to_string(different.size()) + " groups may meet";
  }
  const std::string between = text.empty() ? "" : ", ";
  if (item.contains("members")) text += between + "members: " + shown(item["members"]) + meshes_of_members_text(item);
  if (item.contains("except") && !item["except"].empty()) {
    text += ", " + counted(item["except"].size(), "pair") + " not asked about: " + shown(item["except"]);
  }
  return text.empty() ? "" : " (" + text + ")";
}

}  // namespace

std::string shortened(const std::string& text, std::size_t most) {
  const std::size_t size = bytes_of(text, most);
  return size < text.size() ? text.substr(0, size) + "..." : text;
}

std::string in_quotes(const std::string& text, std::size_t most) {
  const std::size_t size = bytes_of(text, most);
  constexpr std::string_view escaped = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt";
  std::string result = "\"";
  for (std::size_t k = 0; k < size;) {
    const auto first = static_cast<unsigned char>(text[k]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    std::uint32_t code = length == 1 ? first : first & (0x7fu >> length);
    for (std::size_t m = 1; m < length; ++m) code = (code << 6) | (static_cast<unsigned char>(text[k + m]) & 0x3fu);
    if (const std::size_t known = escaped.find(text[k]); known != std::string_view::npos) {
      (result += '\\') += letters[known];
    } else if (code >= ' ' && code < 0x7f) {
      result += text[k];
    } else {
      add_escaped(code, result);
    }
    k += length;
  }
  return result + (size < text.size() ? "\"..." : "\"");
}

std::string shown(const Json& value) {
  if (!value.is_array()) return plain(value).size() <= most_digits ? plain(value) : "a number that the file has";
  if (!value.empty() && value[0].is_string()) {
    if (!is_short(value)) return "a point that the file has";
    std::string numbers = "(";  // not "(" + ...: g++ 12 warns of that where the library's headers are compiled once
    return numbers.append(joined(value, value.size(), ", ", plain)).append(")");
  }
  const std::string more =
      value.size() > most_entries ? " and " + std::to_string(value.size() - most_entries) + " more" : "";
  return joined(value, most_entries, ", ", shown_entry) + more;
}

std::string filled(const std::string& text, const Words& words) {
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '{') {
      result += text[k];
      continue;
    }
    const std::size_t end = text.find('}', k);
    result += words.at(text.substr(k + 1, end - k - 1));
    k = end;
  }
  return result;
}

std::string counted(std::size_t n, std::string_view one) {
  constexpr std::array<std::array<std::string_view, 2>, 6> endings{
      {{"ex", "ices"}, {"x", "xes"}, {"sh", "shes"}, {"ay", "ays"}, {"y", "ies"}, {"", "s"}}};
  const auto ending = std::find_if(endings.begin(), endings.end(), [&](const auto& e) { return one.ends_with(e[0]); });
  std::string text = std::to_string(n) + " ";
  if (n == 1) return text.append(one);
  return text.append(one.substr(0, one.size() - (*ending)[0].size())).append((*ending)[1]);
}

std::string sentence_of(const Json& item, const std::string& text, const Thing& a, const Thing& b,
                        const std::string& table, std::size_t size) {
  const std::string verdict(item["verdict"].text());
  if (item.contains("members")) size = item["members"].size();
  Words words{{"a", a.title}, {"b", b.title}, {"region", region_text(item, verdict)}};
  words["all"] = counted(size, found(ones, table)) + meshes_text(item);
  for (const auto& [key, value] : item.members()) {
    const std::string name(key);
    if (name == "claims" || name == "said" || name == "points" || words.contains(name)) continue;
    words[name] = name == "facets"     ? facets_text(*value)
                  : name == "vertices" ? counted(value->size(), "vertex")
                                       : shown(*value);
    words["n_" + name] = std::to_string(value->size());
  }
  const char* const list = item.contains("nearer") ? "nearer" : item.contains("kinds") ? "kinds" : "contacts";
  const std::size_t count = item.contains("number") ? static_cast<std::size_t>(item["number"].integer())
                            : item.contains(list)   ? item[list].size()
                                                    : 0;
  words["pairs"] = counted(count, "pair") + " of the " + words["all"] + (count == 1 ? " is" : " are");
  words["meeting"] = counted(count, "pair") + " of the " + words["all"] + (count == 1 ? " meets" : " meet");
  if (item.contains(list) && count > 0) words["meeting"] += ": " + words[list];
  const bool is_of_pairs = (item.contains("allowed") || item.contains("members")) && verdict != "some";
  std::string result = is_of_pairs && pairs_asked(item, size) == 0 ? "no pair of " + words["all"] + " is asked about"
                                                                   : filled(text, words);
  result += rules_text(item);
  for (const Thing* thing : {&a, &b}) {
    if (!thing->said.empty()) result += "; " + thing->quoted + " is said to be made of " + thing->said;
  }
  return result;
}

}  // namespace sunder_verifier
