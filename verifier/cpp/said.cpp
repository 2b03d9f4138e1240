#include <verifier/cpp/reader.h>
#include <verifier/cpp/said.h>
#include <verifier/cpp/sentences.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace sunder_verifier {
namespace {

constexpr std::size_t most_said_steps = 8;  // of one description
constexpr std::size_t most_texts = 3;       // texts, and values of joints, that are shown

struct Context {
  const InputNames& inputs;
  std::size_t pairs_left_out = 0;
};

void require_list(const Json& value, const std::string& where) {
  if (!value.is_array()) refuse_form(where + " is not a list");
}

void require_two(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 2) refuse_form(where + " is not a list of 2");
}

std::size_t positive(const Json& value, const std::string& where) {
  const std::size_t number = read_index(value, most_number + 1, where);
  if (number == 0) refuse_form(where + " is not an index in range");
  return number;
}

std::string with_words_around(std::string before, const std::string& words, const char* after = "") {
  return before.append(words).append(after);
}

// The words of each entry, of the first ones; and how many more there are.
template <class Words>
std::string some(const Json& value, const std::string& where, Words words_of) {
  std::string text;
  std::size_t k = 0;
  require_list(value, where);
  for (const Json& entry : value) {
    const std::string words = words_of(entry, where + "[" + std::to_string(k) + "]");
    if (k < most_texts) text.append(k == 0 ? "" : ", ").append(words);
    ++k;
  }
  return k > most_texts ? text + " and " + std::to_string(k - most_texts) + " more" : text;
}

// ---- The words of a member.

using Read = std::string (*)(const Json& value, const Context& context, const std::string& where);

std::string text(const Json& value, const Context&, const std::string& where) {
  return in_quotes(read_text(value, where));
}

std::string input(const Json& value, const Context& context, const std::string& where) {
  return in_quotes(context.inputs[read_index(value, context.inputs.size(), where)]);
}

std::string texts(const Json& value, const Context& context, const std::string& where) {
  return some(value, where, [&](const Json& entry, const std::string& place) { return text(entry, context, place); });
}

std::string part(const Json& value, const Context& context, const std::string& where) {
  return value.is_null() ? "" : with_words_around("part ", text(value, context, where), " of ");
}

std::string without(const Json& value, const Context& context, const std::string& where) {
  const std::string words = texts(value, context, where);
  return words.empty() ? "" : with_words_around(", without ", words);
}

std::string reals(const Json& value, const Context&, const std::string& where) {
  require_list(value, where);
  read_doubles(value, value.size(), where);
  std::string words;
  for (const Json& number : value) words.append(words.empty() ? "" : ", ").append(shown(number));
  return words;
}

std::string nine_reals(const Json& value, const Context& context, const std::string& where) {
  read_doubles(value, 9, where);
  return reals(value, context, where);
}

std::string from(const Json& value, const Context& context, const std::string& where) {
  return value.is_null() ? "" : with_words_around(" of ", input(value, context, where));
}

std::string row(const Json& value, const Context&, const std::string& where) {
  return value.is_null() ? ""
                         : with_words_around(" of row ", std::to_string(read_index(value, most_number + 1, where)));
}

std::string joints(const Json& value, const Context& context, const std::string& where) {
  require_list(value, where);
  if (value.empty()) refuse_form(where + " is empty");
  return some(value, where, [&](const Json& entry, const std::string& place) {
    require_two(entry, place);
    const std::string name = text(entry[0], context, place);
    read_double(entry[1], place);
    return with_words_around(name, " ").append(shown(entry[1]));
  });
}

std::string reasons(const Json& value, const Context& context, const std::string& where) {
  std::size_t sum = 0;
  std::string words = some(value, where, [&](const Json& entry, const std::string& place) {
    require_two(entry, place);
    const std::string name = text(entry[0], context, place);
    const std::size_t number = positive(entry[1], place);
    sum += number;
    return std::to_string(number).append(" ").append(name);
  });
  if (sum != context.pairs_left_out || sum == 0) refuse_form(where + " do not sum to the pairs not asked about");
  return words;
}

struct SaidMember {
  const char* name;
  Read words;
};

constexpr std::array words_of_members{
    SaidMember{"input", input},   SaidMember{"part", part},    SaidMember{"without", without},
    SaidMember{"changes", texts}, SaidMember{"by", reals},     SaidMember{"frame", nine_reals},
    SaidMember{"text", text},     SaidMember{"axis", text},    SaidMember{"unit", text},
    SaidMember{"system", text},   SaidMember{"from", from},    SaidMember{"row", row},
    SaidMember{"values", joints}, SaidMember{"pairs", reasons}};

// ---- The words of a kind, of the members that they name. Those of steps begin with a comma, and have `of`.

struct TableWords {
  const char *name, *words;
};

constexpr std::array descriptions{
    TableWords{"vertices", "all vertices of {part}{input}{without}"},
    TableWords{"triangles", "all triangles of {part}{input}{without}"},
    TableWords{"points", "all points of {part}{input}{without}"},
    TableWords{"half_spaces", "all half-spaces of {part}{input}{without}"},
    TableWords{"lines", "all lines of {part}{input}{without}"},
    TableWords{"centre_lines", "the centre lines of all tracks of {part}{input}{without}"},
    TableWords{"polygons", "all polygons of {part}{input}{without}"},
    TableWords{"circles", "all circles of {part}{input}{without}"},
    TableWords{"boxes", "all boxes of {part}{input}{without}"},
    TableWords{"half_planes", "all half-planes of {part}{input}{without}"},
    TableWords{"shape", "the shape of {part}{input}{without}"},
    TableWords{"given", "what is given as {text}"},
    TableWords{"hull", ", which is replaced by its convex hull"},
    TableWords{"scaled", ", times {by}"},
    TableWords{"unit", ", in {unit}"},
    TableWords{"projected", ", projected onto the frame {frame}"},
    TableWords{"dropped", ", with {axis} dropped"},
    TableWords{"radius", ", with a radius that is given beside it"},
    TableWords{"mended", ", mended: {changes}"},
    TableWords{"system", ", in the coordinate system {system}"},
};

constexpr std::array notes{
    TableWords{"joint_values", "; the joint values{row}{from} are said to be {values}"},
    TableWords{"allowed", "; the pairs not asked about are said to be allowed: {pairs}"},
};

template <std::size_t count>
std::string words_of(const std::array<TableWords, count>& kinds, const Json& value, const Context& context,
                     const std::string& where) {
  if (!value.is_object()) refuse_form(where + " is not an object");
  const Json* const name = value.find("is");
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const TableWords& known) {
    return name != nullptr && name->is_string() && name->text() == known.name;
  });
  if (kind == kinds.end()) refuse_form(where + ".is is none that is known");
  const std::string words = kind->words;
  Words of_members;
  std::vector<std::string> keys{"is"};
  if (words.starts_with(',')) keys.emplace_back("of");
  for (const SaidMember& member : words_of_members) {
    if (words.find(with_words_around("{", member.name, "}")) != std::string::npos) keys.emplace_back(member.name);
  }
  require_members(value, keys, {}, where);
  for (const SaidMember& member : words_of_members) {
    if (std::find(keys.begin(), keys.end(), member.name) == keys.end()) continue;
    of_members[member.name] = member.words(value[member.name], context, where + "." + member.name);
  }
  return filled(words, of_members);
}

}  // namespace

std::string read_description(const Json& value, const InputNames& inputs, const std::string& where) {
  std::string words, place = where;
  std::size_t steps = 0;
  for (const Json* at = &value; at != nullptr; at = at->find("of")) {
    if (++steps > most_said_steps)
      refuse_form(place + " has more than " + std::to_string(most_said_steps - 1) + " steps");
    words = words_of(descriptions, *at, {inputs}, place).append(words);
    place += ".of";
  }
  return words;
}

std::string read_notes(const Json& value, const InputNames& inputs, std::size_t pairs_left_out,
                       const std::string& where) {
  std::string words;
  require_list(value, where);
  for (const Json& entry : value) words += words_of(notes, entry, {inputs, pairs_left_out}, where);
  return words;
}

std::string read_said_of_rows(const Json& value, const InputNames& inputs, std::size_t size, const std::string& where) {
  std::size_t sum = 0;
  const std::string words = some(value, where, [&](const Json& entry, const std::string& place) {
    const ReadNow now(entry);
    require_two(*now, place);
    const std::size_t number = positive((*now)[0], place);
    sum += number;
    const std::string of = read_description((*now)[1], inputs, place);
    return value.size() > 1 ? with_words_around(std::to_string(number), ": ").append(of) : of;
  });
  if (sum != size || sum == 0) refuse_form(where + " does not sum to the entries");
  return with_words_around("; these are said to be made of ", words);
}

}  // namespace sunder_verifier
