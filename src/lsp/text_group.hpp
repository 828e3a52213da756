#pragma once
/// A text is read together with those that it stands in one specification with.

#include <functional>
#include <map>
#include <string>

namespace durero::lsp {

/// The texts of a folder, by their paths: the files of Z in it.
using FolderTexts = std::map<std::string, std::string>;
/// Reads the texts of the folder that a path stands in.
using FolderReader = std::function<FolderTexts(const std::string& path)>;

/// The FolderReader of the disk: the `.tex` and `.utf8` files that can be read.
FolderTexts folder_on_disk(const std::string& path);

/// Returns the texts to read one with: itself, and where it names its section, those among `beside` that are parents or
/// children of these, however far. Of two that declare one section the first counts, and the text itself before all. A
/// text without a header is read alone.
std::map<std::string, std::string> group_of(const std::string& path, const std::string& text,
                                            const FolderTexts& beside);

}  // namespace durero::lsp
