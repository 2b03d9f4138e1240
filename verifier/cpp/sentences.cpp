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

struct Sentence {
  const char *question, *verdict;  // the verdict is empty: all of them
  const char* text;                // with members of the statement
};

constexpr auto sentences = std::to_array<Sentence>({
    {"pair", "apart", "{a} and {b} are apart"},
    {"pair", "meet", "{a} and {b} meet at {point}"},
    {"pair", "touching", "{a} and {b} touch at {point}"},
    {"pair", "overlapping", "{a} and {b} overlap at {point}"},
    {"distance", "closest", "{a} and {b} are closest at {from_a} and {to_b}"},
    {"clearance", "kept", "{a} and {b} are {least} apart, or more"},
    {"clearance", "broken", "{a} and {b} are nearer than {least}, at {from_a} and {to_b}"},
    {"depth", "at_most", "{a} moved by {most}, in a direction, does not overlap {b}"},
    {"depth", "at_least", "{a} moved by {least}, in any direction, meets {b}"},
    {"clearances", "kept", "all pairs of bodies are {least} apart, or more"},
    {"clearances", "broken", "exactly these pairs of bodies are nearer than {least}: {nearer}"},
    {"motion", "apart", "{a} and {b} are apart all along their ways"},
    {"motion", "meet", "{a} and {b} meet on their ways, at time {time}, at {point}"},
    {"motion", "first", "{a} and {b} first meet on their ways at time {time}, at {point}"},
    {"half_spaces", "empty", "the common part of the half-spaces of {a} is empty"},
    {"half_spaces", "bounded", "the common part of the half-spaces of {a} is bounded, of dimension {dimension}"},
    {"half_spaces", "unbounded", "the common part of the half-spaces of {a} is unbounded, of dimension {dimension}"},
    {"half_spaces_vertices", "vertices",
     "the common part of the half-spaces of {a} is bounded, and has exactly {vertices}"},
    {"half_spaces_program", "one", "{point} is the best point of the half-spaces of {a} along {objective}"},
    {"half_spaces_program", "many", "{point} is one of many best points of the half-spaces of {a} along {objective}"},
    {"half_spaces_program", "all", "{point} is as good as all others of the half-spaces of {a} along {objective}"},
    {"half_spaces_program", "unbounded", "there is no best point of the half-spaces of {a} along {objective}"},
    {"half_spaces_program", "infeasible", "no point is in all half-spaces of {a}"},
    {"polytopes", "apart", "{a} and {b} are apart"},
    {"polytopes", "meet", "{a} and {b} meet at {point}"},
    {"polytopes", "apart_by_hyperplanes", "{a} and {b} are apart, by half-spaces that hold them"},
    {"hull", "solid", "the hull of {a} is solid, with the faces {faces}"},
    {"hull", "flat", "the hull of {a} is a polygon with the corners {outline}"},
    {"hull", "segment", "the hull of {a} is the segment between its points {i} and {j}"},
    {"hull", "point", "the hull of {a} is a point"},
    {"polytope_hull", "facets", "the hull of {a} has exactly {facets}"},
    {"polytope_hull", "segment", "the hull of {a} is the segment between its points {i} and {j}"},
    {"polytope_hull", "point", "the hull of {a} is a point"},
    {"section", "nothing", "the plane {plane} does not meet {a}"},
    {"section", "touching", "the plane {plane} touches {a} at the points {corners}"},
    {"section", "outlined", "the section of {a} by the plane {plane} has the corners {corners}"},
    {"segments", "some", "segments {i} and {j} meet at {point}: {kind}"},
    {"segments", "none", "no two segments meet"},
    {"circles", "some", "circles {i} and {j} meet at {point}: {kind}"},
    {"circles", "none", "no two circles meet"},
    {"boxes", "some", "boxes {i} and {j} meet at {point}: {kind}"},
    {"boxes", "none", "no two boxes meet"},
    {"polygons", "some", "polygons {i} and {j} meet at {point}"},
    {"polygons", "none", "no two polygons meet"},
    {"half_planes", "", "the common part of the half-planes is {region}"},
    {"kernel", "", "the kernel of ring {ring} is {region}"},
    {"convex_polygons_common_part", "", "the common part of the convex polygons is {region}"},
    {"circles_common_part", "empty", "the common part of the circles is empty"},
    {"circles_common_part", "plane", "the common part of the circles is the plane"},
    {"circles_common_part", "point", "the common part of the circles is the point {point}"},
    {"circles_common_part", "region",
     "the common part of the circles is a region around {point}, bounded by arcs of {arcs}"},
    {"valid", "valid", "polygons {parts}: {rule}"},
    {"valid", "too_few_points", "ring {ring} has too few points"},
    {"valid", "edges_meet", "edges {i} and {j} meet at {point}: {kind}"},
    {"valid", "comes_twice", "ring {ring} comes twice to {point}"},
    {"valid", "misplaced", "ring {ring} is misplaced at {point}"},
    {"valid", "crosses", "ring {ring} crosses itself at {point}"},
    {"valid", "falls_apart", "one falls apart"},
    {"valid", "circle", "rings {rings} close a circle"},
    {"valid", "repeated", "edge {edge} has no length"},
    {"valid", "rings_touch", "rings {ring} and {other} touch at {point}"},
    {"linear_program", "one", "{point} is the best point along {objective}"},
    {"linear_program", "many", "{point} is one of many best points along {objective}"},
    {"linear_program", "all", "{point} is as good as all others along {objective}"},
    {"linear_program", "unbounded", "there is no best point along {objective}"},
    {"linear_program", "infeasible", "no point is in all half-planes"},
});

constexpr std::array<std::array<const char*, 2>, 10> regions{{
    {"empty", "empty"},
    {"plane", "the plane"},
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

std::string titled(const NamedBody& body) {
  return (body.title.empty() ? "" : body.title + " ") + body.quoted;
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

// A word, a number, a point of numbers as they stand in the file, or a list of entries.
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

using Words = std::map<std::string, std::string>;  // for the members

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

std::string count_text(const Json& item, const std::string& question) {
  const bool is_list = item.contains("contacts");
  const std::size_t count = is_list ? item["contacts"].size() : static_cast<std::size_t>(item["number"].integer());
  const std::string text = "exactly " + std::to_string(count) + (count == 1 ? " pair of " : " pairs of ") + question +
                           (count == 1 ? " meets" : " meet");
  return is_list && count > 0 ? text + ": " + shown(item["contacts"]) : text;
}

std::string region_text(const Json& item, const std::string& verdict) {
  const auto known =
      std::find_if(regions.begin(), regions.end(), [&](const auto& region) { return region[0] == verdict; });
  const std::string kind = known == regions.end() ? "" : (*known)[1];
  return item.contains("sides") && !item["sides"].empty() ? kind + ", of sides " + shown(item["sides"]) : kind;
}

// Of facets, which are lists of simplices.
std::string facets_text(const Json& facets) {
  std::size_t simplices = 0;
  for (const Json& facet : facets) simplices += facet.size();
  return std::to_string(facets.size()) + " facets, made of " + std::to_string(simplices) + " simplices of " +
         std::to_string(facets[0][0].size()) + " corners";
}

std::string vertices_text(const Json& vertices) {
  return std::to_string(vertices.size()) + (vertices.size() == 1 ? " vertex" : " vertices");
}

std::string rules_text(const Json& item) {
  std::string text;
  if (item.contains("allowed") && item["allowed"].text() != "nothing")
    text = std::string(item["allowed"].text()) + " allowed";
  if (item.contains("groups")) {
    std::set<std::int64_t> different;
    for (const Json& group : item["groups"]) different.insert(group.integer());
    text += text.empty() ? "" : ", ";
    text += "members of one of " + std::to_string(different.size()) + " groups may meet";
  }
  for (const auto& [key, title] : {std::pair("members", "members: "), std::pair("except", "not asked about: ")}) {
    if (item.contains(key) && !item[key].empty()) text += (text.empty() ? "" : ", ") + (title + shown(item[key]));
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

std::string sentence_of(const Json& item, const NamedBody& a, const NamedBody& b) {
  const std::string question(item["question"].text()), verdict(item["verdict"].text());
  if (verdict == "these" || verdict == "count") return count_text(item, question) + rules_text(item);
  Words words{{"region", region_text(item, verdict)}};
  for (const auto& [name, value] : item.members()) {
    if (name == "claims" || name == "points") continue;
    words[std::string(name)] = name == "facets"     ? facets_text(*value)
                               : name == "vertices" ? vertices_text(*value)
                                                    : shown(*value);
  }
  if (!a.quoted.empty()) words["a"] = titled(a);
  if (!b.quoted.empty()) words["b"] = titled(b);
  const auto known = std::find_if(sentences.begin(), sentences.end(), [&](const Sentence& sentence) {
    return sentence.question == question && (sentence.verdict == verdict || *sentence.verdict == '\0');
  });
  const std::string text = known == sentences.end() ? verdict : filled(known->text, words);
  if (question != "valid" || verdict == "valid") return text + rules_text(item);
  return "polygons " + words["parts"] + ": not " + words["rule"] + ", as " + text;
}

}  // namespace sunder_verifier
