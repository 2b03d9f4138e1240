#include <sunder/io/robot/packages.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/xml_internal.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <system_error>

namespace sunder::io {

namespace {

namespace fs = std::filesystem;

constexpr XmlKind package_file{"package", "package.xml", "a package.xml", "file"};

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// The name in the folder's package.xml; nothing where there is none, or none that can be read.
std::optional<std::string> package_name(const fs::path& folder) {
  const fs::path file = folder / "package.xml";
  if (!is_file(file)) return std::nullopt;
  try {
    const std::string bytes = read_file(file);
    const std::string place = file.string();
    const XmlFile xml(bytes, place, package_file);
    const XMLElement* name = xml.root().FirstChildElement("name");
    if (name == nullptr || name->GetText() == nullptr) return std::nullopt;
    return std::string(trimmed(name->GetText()));
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool is_package(const fs::path& folder, const std::string& name) {
  return is_folder(folder) && (folder.filename() == name || package_name(folder) == name);
}

// The folder and those above it, the nearest first.
std::vector<fs::path> folders_above(const fs::path& folder) {
  std::error_code ignored;
  fs::path at = (fs::current_path(ignored) / folder).lexically_normal();
  if (!at.has_filename()) at = at.parent_path();  // "a/b/" is "a/b"
  std::vector<fs::path> above;
  for (; at.has_relative_path(); at = at.parent_path()) above.push_back(at);
  return above;
}

std::vector<fs::path> folders_of_package(const std::string& name, std::span<const fs::path> above,
                                         const Packages& packages) {
  std::vector<fs::path> folders;
  for (const fs::path& folder : above) {
    if (is_package(folder, name)) folders.push_back(folder);
  }
  for (const fs::path& folder : above) {
    if (is_folder(folder / name)) folders.push_back(folder / name);
  }
  for (const fs::path& folder : packages.search) {
    if (is_package(folder, name)) folders.push_back(folder);
    std::vector<fs::path> within;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
      if (is_package(entry.path(), name)) within.push_back(entry.path());
    }
    std::sort(within.begin(), within.end());
    folders.insert(folders.end(), within.begin(), within.end());
  }
  return folders;
}

fs::path joined(std::span<const fs::path> parts) {
  fs::path path;
  for (const fs::path& part : parts) path /= part;
  return path;
}

[[noreturn]] void fail_tried(const std::string& written, std::span<const fs::path> tried, const std::string& remedy) {
  constexpr std::size_t most = 4;
  std::string list;
  for (std::size_t i = 0; i < std::min(tried.size(), most); ++i) {
    list += (i == 0 ? "" : ", ") + one_line(tried[i].string());
  }
  if (tried.size() > most) list += fmt::format(" and {} more", tried.size() - most);
  fail_file(written, fmt::format("no such mesh; tried: {}; {}", list.empty() ? "nothing" : list, remedy));
}

// inside: what stands behind package:// or model://.
fs::path resolve_in_package(const std::string& written, std::string_view inside, bool is_model,
                            const fs::path& robot_folder, const Packages& packages) {
  std::vector<fs::path> parts;
  for (const fs::path& part : fs::path(inside).relative_path()) parts.push_back(part);
  if (parts.size() < 2) fail_tried(written, {}, "write package://NAME/FILE");
  const std::string name = parts[0].string();
  const std::string remedy = fmt::format("name the package's folder: --package {}=FOLDER", shorten(name));
  const fs::path rest = joined(std::span(parts).subspan(1));

  std::vector<fs::path> candidates;
  const auto named = std::find_if(packages.named.begin(), packages.named.end(),
                                  [&](const auto& package) { return package.first == name; });
  if (named != packages.named.end()) {
    candidates.push_back(named->second / rest);
    if (!is_file(candidates[0])) fail_tried(written, candidates, fmt::format("correct --package {}", shorten(name)));
    return candidates[0];
  }

  const std::vector<fs::path> above = folders_above(robot_folder);
  if (const GivenFiles* given = GivenFiles::now()) {  // the folders of their names need not be there
    candidates = {given->name_with_end(name / rest), given->name_with_end(rest)};
    std::erase(candidates, fs::path());
  } else {
    for (const fs::path& folder : folders_of_package(name, above, packages)) candidates.push_back(folder / rest);
  }
  const auto own =
      std::find_if(above.begin(), above.end(), [](const fs::path& folder) { return is_file(folder / "package.xml"); });
  if (own == above.end() || is_model) {
    for (std::size_t skip = 1; skip < parts.size(); ++skip) {
      candidates.push_back(robot_folder / joined(std::span(parts).subspan(skip)));
    }
  }
  for (const fs::path& candidate : candidates) {
    if (is_file(candidate)) return candidate;
  }
  if (candidates.empty()) {
    fail_file(written,
              fmt::format("there is no package {}; the robot's file is of {}, by {}; {}", quote(name),
                          quote(package_name(*own).value_or("?")), one_line((*own / "package.xml").string()), remedy));
  }
  fail_tried(written, candidates, remedy);
}

}  // namespace

Packages parse_packages(std::span<const std::string> named, const std::string& search) {
  Packages packages;
  for (const std::string& word : named) {
    const auto fail = [&](const std::string& text) { throw Error(ErrorCode::bad_call, text, "--package"); };
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0) fail(quote(word) + " is not of the form NAME=FOLDER");
    const std::string name = word.substr(0, equals);
    const fs::path folder = word.substr(equals + 1);
    if (GivenFiles::now() == nullptr && !is_folder(folder))
      fail(quote(folder.string()) + " is no folder; name the one of package " + quote(name));
    for (const auto& [known, ignored] : packages.named) {
      if (known == name) fail("the package " + quote(name) + " comes twice; name one folder");
    }
    packages.named.emplace_back(name, folder);
  }
  for (std::size_t at = 0; at < search.size();) {
    const std::size_t end = std::min(search.find(':', at), search.size());
    if (end > at) packages.search.emplace_back(search.substr(at, end - at));
    at = end + 1;
  }
  return packages;
}

fs::path resolve_mesh(const std::string& written, const fs::path& robot_folder, const Packages& packages) {
  const std::string_view name = written;
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (!name.starts_with(scheme)) continue;
    return resolve_in_package(written, name.substr(scheme.size()), scheme == "model://", robot_folder, packages);
  }
  fs::path path;
  if (name.starts_with("file://")) {
    path = name.substr(7);
  } else if (name.find("://") != std::string_view::npos) {
    fail_file(written, "meshes are not fetched from the net; store the file and name it");
  } else {
    path = robot_folder / written;  // an absolute name stays as it is
  }
  if (!is_file(path)) fail_tried(written, std::span(&path, 1), "correct the name, or put the file there");
  return path;
}

}  // namespace sunder::io
