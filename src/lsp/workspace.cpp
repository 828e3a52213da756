#include "lsp/workspace.hpp"

#include <utility>

#include "durero/zed/review/review.hpp"
#include "lsp/file_uri.hpp"

namespace durero::lsp {

const std::vector<zed::Defect>& GroupAnalysis::defects() {
  if (!defects_) {
    defects_ = zed::review(checked_.read, checked_.typing);
    std::vector<std::string> files;
    for (const auto& [file, text] : checked_.texts) files.push_back(file);
    for (zed::Defect& empty : zed::without_paragraphs(files, checked_.read)) defects_->push_back(std::move(empty));
  }
  return *defects_;
}

const zed::CrossReference& GroupAnalysis::names() {
  if (!names_) names_ = zed::cross_reference(checked_);
  return *names_;
}

void Workspace::open(const std::string& path, OpenFile file) {
  files_.insert_or_assign(path, std::move(file));
  reread();
}

void Workspace::close(const std::string& path) {
  files_.erase(path);
  reread();
}

void Workspace::reread() {
  folders_.clear();
  analyses_.clear();
}

OpenFile* Workspace::find(const std::string& path) {
  const auto at = files_.find(path);
  return at == files_.end() ? nullptr : &at->second;
}

GroupAnalysis& Workspace::analysis(const std::string& path) {
  const std::string& own = files_.at(path).text.text();
  for (const auto& known : analyses_)
    if (known->checked().texts.contains(path)) return *known;
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  const auto [at, added] = folders_.try_emplace(folder);
  if (added) at->second = read_(path);
  FolderTexts beside = at->second;
  for (const auto& [other, file] : files_)
    if (other.substr(0, other.rfind('/') + 1) == folder) beside[other] = file.text.text();
  return *analyses_.emplace_back(std::make_unique<GroupAnalysis>(group_of(path, own, beside)));
}

EditedText Workspace::text_of(const GroupAnalysis& in, const std::string& path, PositionUnit unit) const {
  if (const auto at = files_.find(path); at != files_.end()) return at->second.text;
  const auto read = in.checked().texts.find(path);
  return EditedText(read == in.checked().texts.end() ? std::string() : read->second, unit);
}

std::string Workspace::uri_of(const std::string& path) const {
  const auto at = files_.find(path);
  return at == files_.end() ? uri_of_path(path) : at->second.uri;
}

}  // namespace durero::lsp
