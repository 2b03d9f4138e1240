#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/xml_internal.h>

#include <fmt/format.h>

#include <algorithm>

namespace sunder::io {

namespace {

// "XML_ERROR_MISMATCHED_ELEMENT" for people.
std::string problem_of(const tinyxml2::XMLDocument& document) {
  std::string_view kind = tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID());
  for (const std::string_view prefix : {"XML_", "ERROR_"}) {
    if (kind.starts_with(prefix)) kind.remove_prefix(prefix.size());
  }
  std::string words(kind);
  for (char& c : words) c = c == '_' ? ' ' : static_cast<char>(c - 'A' + 'a');
  return words;
}

}  // namespace

std::vector<std::string_view> xml_words(std::string_view text) {
  constexpr std::string_view blank = " \t\n\r";
  std::vector<std::string_view> found;
  for (std::size_t at = text.find_first_not_of(blank); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blank, at), text.size());
    found.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(blank, end);
  }
  return found;
}

XmlFile::XmlFile(std::string_view bytes, std::string_view place, const XmlKind& kind) : place_(place) {
  if (bytes.find('\0') != std::string_view::npos) {
    fail_file(place_, fmt::format("holds zero bytes; {} is XML text", kind.a));
  }
  if (document_.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
    const int line = std::max(document_.ErrorLineNum(), 1);
    fail_line(place_, static_cast<std::size_t>(line),
              fmt::format("is not well-formed XML ({}); export the {} again", problem_of(document_), kind.thing));
  }
  const XMLElement* root = document_.RootElement();
  if (root == nullptr) fail_file(place_, fmt::format("has no element; {} is XML with <{}>", kind.a, kind.root));
  if (!is(*root, kind.root)) {
    if (const ForeignBody known = foreign_body(bytes); !known.what.empty()) fail(*root, foreign_text(known, place_));
    fail(*root, fmt::format("is {}, expected <{}>; this is no {}", tag(*root), kind.root, kind.name));
  }
}

std::string XmlFile::tag(const XMLElement& element) { return "<" + shorten(element.Name()) + ">"; }

void XmlFile::fail(const XMLElement& element, const std::string& text) const {
  fail_line(place_, static_cast<std::size_t>(std::max(element.GetLineNum(), 1)), text);
}

const char* XmlFile::attribute(const XMLElement& element, const char* name) const {
  const char* value = element.Attribute(name);
  if (value == nullptr) fail(element, fmt::format("{} has no {}=\"...\"; add it", tag(element), name));
  return value;
}

std::string XmlFile::name_of(const XMLElement& element) const {
  std::string name = one_line(attribute(element, "name"));
  if (name.empty()) fail(element, fmt::format("the name of {} is empty; give it one", tag(element)));
  return name;
}

double XmlFile::number(const XMLElement& element, const char* name, std::string_view word) const {
  double value = 0;
  if (const char* problem = parse_number(word, value)) {
    fail(element, fmt::format("{} of {}: {} {}", name, tag(element), quote(word), problem));
  }
  return value;
}

double XmlFile::number_or(const XMLElement& element, const char* name, double otherwise) const {
  const char* text = element.Attribute(name);
  if (text == nullptr) return otherwise;
  const std::vector<std::string_view> found = xml_words(text);
  if (found.size() != 1) {
    fail(element, fmt::format("{} of {} is {}, expected a number", name, tag(element), quote(text)));
  }
  return number(element, name, found[0]);
}

std::array<double, 3> XmlFile::triple_or(const XMLElement& element, const char* name,
                                         std::array<double, 3> otherwise) const {
  const char* text = element.Attribute(name);
  if (text == nullptr) return otherwise;
  const std::vector<std::string_view> found = xml_words(text);
  if (found.size() != 3) {
    fail(element, fmt::format("{} of {} is {}, expected 3 numbers", name, tag(element), quote(text)));
  }
  return {number(element, name, found[0]), number(element, name, found[1]), number(element, name, found[2])};
}

}  // namespace sunder::io
