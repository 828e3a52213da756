#pragma once
/// The texts that an editor has open, and what is known of each.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "durero/zed/names/cross_reference.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/trial/trial.hpp"
#include "lsp/edited_text.hpp"
#include "lsp/text_group.hpp"

namespace durero::lsp {

/// A text that an editor has open.
struct OpenFile {
  std::string uri;       ///< as the editor writes it
  std::int64_t version;  ///< as the editor counts
  EditedText text;
};

/// What was found of the texts of a group. Its parts are made when they are first asked for.
class GroupAnalysis {
 public:
  explicit GroupAnalysis(std::map<std::string, std::string> texts) : checked_(zed::checked(std::move(texts))) {}

  const zed::CheckedTexts& checked() const { return checked_; }
  /// The defects of the group, as `durero spec check` gives them.
  const std::vector<zed::Defect>& defects();
  const zed::CrossReference& names();
  /// Tries the next conjecture of a file, where the group has no error; says whether there was one.
  bool try_next(const std::string& file);
  /// The conjectures that were found false so far.
  const std::vector<zed::Trial>& refuted() const { return refuted_; }

 private:
  zed::CheckedTexts checked_;
  std::map<std::string, std::size_t> tried_;  // of each file, how many conjectures
  std::vector<zed::Trial> refuted_;
  std::optional<std::vector<zed::Defect>> defects_;
  std::optional<zed::CrossReference> names_;
};

class Workspace {
 public:
  explicit Workspace(FolderReader read) : read_(std::move(read)) {}

  void open(const std::string& path, OpenFile file);
  void close(const std::string& path);
  /// Files may have changed on the disk. What is known of a group whose texts are the same stays known.
  void reread();
  /// An open file was edited.
  void edited() {
    analyses_.clear();
    earlier_.clear();
  }

  /// Returns an open file, or null.
  OpenFile* find(const std::string& path);
  const std::map<std::string, OpenFile>& files() const { return files_; }
  /// Returns what is known of an open file's group. Precondition: the file is open.
  GroupAnalysis& analysis(const std::string& path);
  /// Returns the text of a file of a group with its positions, as it was analysed.
  EditedText text_of(const GroupAnalysis& in, const std::string& path, PositionUnit unit) const;
  /// Returns the address of a file: as the editor writes it, where it is open.
  std::string uri_of(const std::string& path) const;

 private:
  FolderReader read_;
  std::map<std::string, OpenFile> files_;                 // by path
  std::map<std::string, FolderTexts> folders_;            // as they were last read, by the path of the folder
  std::vector<std::unique_ptr<GroupAnalysis>> analyses_;  // of the texts as they are
  std::vector<std::unique_ptr<GroupAnalysis>> earlier_;   // of texts that may be others now
};

}  // namespace durero::lsp
