#include "lsp/workspace.hpp"

#include <utility>
#include <variant>

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

namespace {

/// About an eighth of a second for a conjecture, as 10^8 steps take about a minute.
constexpr std::uint64_t most_steps_of_trial = 200000;

/// Leaves one conjecture in a specification: that of a file which has so many before it. False where there is none.
bool leave_conjecture(zed::Specification& in, const std::string& file, std::size_t before) {
  std::size_t passed = 0;
  bool left = false;
  for (zed::Section& section : in.sections)
    std::erase_if(section.paragraphs, [&](const zed::Paragraph& paragraph) {
      if (!std::holds_alternative<zed::Conjecture>(paragraph.form)) return false;
      const bool meant = section.file == file && passed++ == before;
      left = left || meant;
      return !meant;
    });
  return left;
}

}  // namespace

bool GroupAnalysis::try_next(const std::string& file) {
  zed::Specification one = checked_.read;
  if (!checked_.ok() || !leave_conjecture(one, file, tried_[file]++)) return false;
  zed::TrialBounds bounds;
  bounds.steps = most_steps_of_trial;
  for (zed::Trial& trial : zed::try_conjectures(one, checked_.typing, {}, bounds))
    if (!trial.counterexample.empty()) refuted_.push_back(std::move(trial));
  return true;
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
  std::erase(earlier_, nullptr);  // those that were taken up again
  for (auto& known : analyses_) earlier_.push_back(std::move(known));
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
  std::map<std::string, std::string> group = group_of(path, own, beside);
  for (auto& known : earlier_)
    if (known && known->checked().texts == group) return *analyses_.emplace_back(std::move(known));
  return *analyses_.emplace_back(std::make_unique<GroupAnalysis>(std::move(group)));
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
