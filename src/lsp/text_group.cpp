#include "lsp/text_group.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "durero/text/file.hpp"
#include "durero/zed/names/section_headers.hpp"
#include "durero/zed/syntax/reader.hpp"

namespace durero::lsp {
namespace {

/// The sections of a text, and those that it needs.
struct SectionNames {
  std::set<std::string> own, parents;
};

SectionNames sections_of(std::string_view text) {
  SectionNames names;
  for (auto& [section, parents] : zed::section_headers(text)) {
    names.own.insert(section);
    for (std::string& parent : parents)
      if (!zed::is_toolkit(parent)) names.parents.insert(std::move(parent));
  }
  return names;
}

bool meet(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::ranges::any_of(a, [&](const std::string& name) { return b.contains(name); });
}

}  // namespace

FolderTexts folder_on_disk(const std::string& path) {
  FolderTexts texts;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) return texts;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    const std::filesystem::path& file = entry.path();
    if ((file.extension() != ".tex" && file.extension() != ".utf8") || !entry.is_regular_file(unreadable)) continue;
    try {
      texts.emplace(file.lexically_normal().string(), text::read_file(file.string(), zed::max_bytes + 1));
    } catch (const std::system_error&) {  // whoever names it as a parent is told that it is missing
    }
  }
  return texts;
}

std::map<std::string, std::string> group_of(const std::string& path, const std::string& text,
                                            const FolderTexts& beside) {
  std::map<std::string, std::string> group = {{path, text}};
  SectionNames known = sections_of(text);
  if (known.own.empty()) return group;
  std::vector<std::pair<const FolderTexts::value_type*, SectionNames>> others;
  for (const auto& each : beside)
    if (each.first != path) others.emplace_back(&each, sections_of(each.second));
  for (bool grows = true; grows;) {
    grows = false;
    for (auto& [other, names] : others) {
      if (other == nullptr || meet(names.own, known.own)) continue;
      if (!meet(names.own, known.parents) && !meet(names.parents, known.own)) continue;
      group.insert(*other);
      known.own.insert(names.own.begin(), names.own.end());
      known.parents.insert(names.parents.begin(), names.parents.end());
      other = nullptr;
      grows = true;
    }
  }
  return group;
}

}  // namespace durero::lsp
