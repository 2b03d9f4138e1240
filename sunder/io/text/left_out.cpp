#include <sunder/io/text/left_out.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace sunder::io {

namespace {

constexpr std::size_t most_owners = 3;

// "1 unused vertex", "2 unused vertices", "2 meshes", "2 cylinders".
std::string counted(std::uint64_t count, std::string noun) {
  if (count == 1) return "1 " + noun;
  if (noun.ends_with("vertex")) {
    noun.replace(noun.size() - 2, 2, "ices");
  } else {
    noun += noun.ends_with("sh") || noun.ends_with("x") ? "es" : "s";
  }
  return fmt::format("{} {}", count, noun);
}

}  // namespace

void LeftOutList::gather(const LeftOut& item, const std::string& owner, std::vector<Kind>& kinds) {
  auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == item.kind; });
  if (kind == kinds.end()) kind = kinds.insert(kinds.end(), {item.kind, 0, {}});
  kind->count += item.count;
  if (!owner.empty() && (kind->of.empty() || kind->of.back() != owner)) kind->of.push_back(owner);
}

void LeftOutList::add(const std::string& file, std::span<const LeftOut> left_out, const std::string& remedy) {
  const std::string name = one_line(std::filesystem::path(file).filename().string());
  std::vector<Kind> here;
  for (const LeftOut& item : left_out) {
    gather(item, item.of, here);  // the message begins with the file
    gather(item, item.of.empty() ? name : item.of, kinds_);
  }
  if (here.empty() || consent_) return;
  fail_file(file, fmt::format("not read: {}; {}, or ask without them: --leave-out", text_of(here), remedy));
}

std::string LeftOutList::text_of(std::span<const Kind> kinds) {
  std::string text;
  for (const Kind& kind : kinds) {
    text += (text.empty() ? "" : "; ") + counted(kind.count, kind.name) + (kind.of.empty() ? "" : " of ");
    const std::size_t shown = kind.of.size() > most_owners + 1 ? most_owners : kind.of.size();
    for (std::size_t i = 0; i < shown; ++i) text += (i > 0 ? ", " : "") + kind.of[i];
    if (shown < kind.of.size()) text += fmt::format(" and {} more", kind.of.size() - shown);
  }
  return text;
}

std::string LeftOutList::text() const { return text_of(kinds_); }

std::string LeftOutList::clause() const { return empty() ? "" : "; left out: " + text(); }

std::vector<std::string> LeftOutList::texts() const {
  std::vector<std::string> texts;
  for (const Kind& kind : kinds_) texts.push_back(text_of(std::span(&kind, 1)));
  return texts;
}

std::vector<std::string> LeftOutList::texts_of(const std::string& file) const {
  const std::string owner = one_line(std::filesystem::path(file).filename().string());
  std::vector<std::string> texts;
  for (const Kind& kind : kinds_) {
    if (std::find(kind.of.begin(), kind.of.end(), owner) == kind.of.end()) continue;
    texts.push_back(kind.of.size() == 1 ? counted(kind.count, kind.name) : "some of " + counted(kind.count, kind.name));
  }
  return texts;
}

}  // namespace sunder::io
