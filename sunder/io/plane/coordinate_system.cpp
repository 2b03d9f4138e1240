#include <sunder/io/plane/coordinate_system.h>

#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <utility>

namespace sunder::io {

namespace {

constexpr std::string_view wgs84 = "EPSG:4326", crs84_urn = "urn:ogc:def:crs:OGC:1.3:CRS84";

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

bool is_word(std::string_view word) {
  const auto is_part = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  };
  return !word.empty() && std::all_of(word.begin(), word.end(), is_part);
}

CoordinateSystem by_code(std::string_view authority, std::string_view code) {
  const std::string of = upper(authority), number = upper(code);
  const bool is_crs84 = (of == "OGC" && (number == "CRS84" || number == "CRS84H")) || (of == "CRS" && number == "84");
  if (is_crs84) return {std::string(wgs84), "CRS84", std::string(crs84_urn)};
  const std::string id = of + ":" + number;
  return {id, id, id == wgs84 ? std::string(crs84_urn) : fmt::format("urn:ogc:def:crs:{}::{}", of, number)};
}

// "EPSG", "28992" out of the many ways to write them.
std::optional<std::pair<std::string_view, std::string_view>> code_of(std::string_view text) {
  const std::string small = in_small_letters(text);
  const auto between = [&](std::string_view before,
                           char gap) -> std::optional<std::pair<std::string_view, std::string_view>> {
    if (!small.starts_with(before)) return std::nullopt;
    const std::string_view rest = text.substr(before.size());
    const std::size_t first = rest.find(gap), last = rest.rfind(gap);
    if (first == std::string_view::npos) return std::nullopt;
    return std::pair(rest.substr(0, first), rest.substr(last + 1));
  };
  constexpr std::array<std::pair<std::string_view, char>, 5> forms{{{"urn:ogc:def:crs:", ':'},
                                                                    {"urn:x-ogc:def:crs:", ':'},
                                                                    {"http://www.opengis.net/def/crs/", '/'},
                                                                    {"https://www.opengis.net/def/crs/", '/'},
                                                                    {"", ':'}}};
  for (const auto& [before, gap] : forms) {
    const auto found = between(before, gap);
    const bool is_plain = before.empty() && std::count(text.begin(), text.end(), ':') != 1;
    if (found && !is_plain && is_word(found->first) && is_word(found->second)) return found;
  }
  constexpr std::string_view gml = "http://www.opengis.net/gml/srs/epsg.xml#";
  if (small.starts_with(gml) && is_word(text.substr(gml.size()))) return std::pair("EPSG", text.substr(gml.size()));
  if (small == "crs84") return std::pair("OGC", text);
  return std::nullopt;
}

// The word that ends there, in small letters.
std::string word_before(std::string_view text, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && end - begin < 12 && is_word(text.substr(begin - 1, 1))) --begin;
  return in_small_letters(text.substr(begin, end - begin));
}

// The words between quotes or commas, from `at` to the bracket that closes.
std::vector<std::string_view> words_of(std::string_view text, std::size_t at) {
  std::vector<std::string_view> words;
  while (at < text.size() && words.size() < 2) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n,\"", at);
    if (begin == std::string_view::npos || text[begin] == ']' || text[begin] == ')') break;
    const std::size_t end = std::min(text.find_first_of(",\"])", begin), text.size());
    words.push_back(trimmed(text.substr(begin, end - begin)));
    at = end < text.size() && text[end] == '"' ? end + 1 : end;
  }
  return words;
}

}  // namespace

CoordinateSystem system_by_name(std::string_view name) {
  std::string_view text = trimmed(name);
  if (text.starts_with('[') && text.ends_with(']')) text = trimmed(text.substr(1, text.size() - 2));
  if (const auto code = code_of(text)) return by_code(code->first, code->second);
  return {std::string(text), shorten(text), std::string(text)};
}

CoordinateSystem system_by_srid(std::int64_t srid) {
  return srid > 0 ? by_code("EPSG", std::to_string(srid)) : CoordinateSystem();
}

CoordinateSystem system_by_prj(std::string_view whole) {
  constexpr std::string_view gaps = " \t\r\n\f\v";
  std::string_view text = whole.substr(0, whole.find_last_not_of(gaps) + 1);
  text.remove_prefix(std::min(text.find_first_not_of(gaps), text.size()));
  if (code_of(text)) return system_by_name(text);
  std::vector<std::string_view> code;
  std::size_t depth = 0;
  std::string_view name = text;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      const std::size_t end = std::min(text.find('"', at + 1), text.size());
      if (name == text) name = text.substr(at + 1, end - at - 1);
      at = end;
    } else if (c == ']' || c == ')') {
      if (depth > 0) --depth;
    } else if (c == '[' || c == '(') {
      const std::string before = word_before(text, at);
      if (depth == 1 && (before == "authority" || before == "id")) code = words_of(text, at + 1);
      ++depth;
    }
  }
  if (code.size() == 2 && is_word(code[0]) && is_word(code[1])) return by_code(code[0], code[1]);
  if (text.empty()) return {};
  return {std::string(text), fmt::format("{}, a .prj without a code", quote(name)), {}};
}

CoordinateSystem system_beside(const std::filesystem::path& file, InputFiles* inputs) {
  constexpr std::uintmax_t most = 1 << 16;
  if (file == "-") return {};
  std::filesystem::path beside = file;
  beside.replace_extension(".prj");
  std::error_code problem;
  if (beside == file || !is_file(beside)) return {};
  // A file that is given, and not on disk, is there only because it was read before.
  const std::uintmax_t size = GivenFiles::now() == nullptr ? std::filesystem::file_size(beside, problem) : 1;
  if (!problem && size == 0) return {};
  if (!problem && size > most) {
    fail_file(beside.string(), fmt::format("is no coordinate system of {}: it is too long; give another one, or none",
                                           one_line(file.filename().string())));
  }
  return system_by_prj(read_file(beside, inputs));
}

CoordinateSystem assumed_crs84() { return {std::string(wgs84), "CRS84, as GeoJSON that names no other", {}, true}; }

std::string text_of(std::span<const SystemOfFile> systems) {
  const auto is_declared = [](const SystemOfFile& s) { return s.system.declared(); };
  if (std::none_of(systems.begin(), systems.end(), is_declared)) return "";
  if (systems.size() == 1) return systems[0].system.name;
  std::string text;
  for (const auto& [system, first] : systems) {
    text += fmt::format("{}{} from {}", text.empty() ? "" : ", ", system.declared() ? system.name : "none", first);
  }
  return text;
}

void CoordinateSystems::add(const std::string& file, std::span<const SystemOfFile> systems) {
  const bool is_mixed = systems.size() > 1;
  const std::string shown = one_line(file);
  for (const auto& [system, first] : systems) {
    if (!system.declared()) {
      undeclared_.push_back(is_mixed ? fmt::format("{} of {}", first, shown) : shown);
      continue;
    }
    const auto found =
        std::find_if(declared_.begin(), declared_.end(), [&](const Declared& d) { return d.system.id == system.id; });
    if (found != declared_.end()) {
      if (found->files.back() != shown) found->files.push_back(shown);
      if (found->system.is_assumed) found->system = system;
      continue;
    }
    if (!declared_.empty() && !may_differ_) {
      const Declared& other = declared_.front();
      const bool is_same = other.files.front() == shown;
      fail_file(file,
                fmt::format("{}the coordinate system is {}, and that of {} is {}; transform one (ogr2ogr -t_srs), "
                            "or compare the numbers as they are: --mixed-crs",
                            is_same ? first + ": " : "", system.name, is_same ? other.first : other.files.front(),
                            other.system.name));
    }
    declared_.push_back({system, {shown}, first});
  }
}

std::string CoordinateSystems::text() const {
  if (declared_.size() == 1) return declared_.front().system.name;
  std::string text;
  for (const auto& [system, files, first] : declared_) {
    text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", system.name, files.front());
    if (files.size() > 1) text += fmt::format(" and {} more", files.size() - 1);
  }
  return text;
}

std::vector<std::string> CoordinateSystems::remarks() const {
  std::vector<std::string> remarks;
  if (declared_.empty()) return remarks;
  if (!undeclared_.empty()) {
    remarks.push_back(fmt::format("{} {} no coordinate system: the numbers count as in {}",
                                  undeclared_.size() == 1
                                      ? undeclared_[0]
                                      : fmt::format("{} and {} more", undeclared_[0], undeclared_.size() - 1),
                                  undeclared_.size() == 1 ? "declares" : "declare",
                                  declared_.size() == 1 ? declared_.front().system.name : "the others"));
  }
  if (declared_.size() > 1) {
    remarks.push_back(fmt::format("coordinate systems differ, and the numbers are compared as they are: {}", text()));
  }
  return remarks;
}

}  // namespace sunder::io
