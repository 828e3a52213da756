#pragma once
/// What is reported, and what is marked, line by line.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "durero/zed/syntax/defect.hpp"
#include "support/tree.hpp"

namespace durero::zed::test {

using Lines = std::map<std::string, std::map<unsigned, std::vector<std::string>>>;  // file, line, what stands there

/// The `.tex` files of a folder of the source tree, in order.
inline std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(durero::test::source_dir() + "/" + folder))
    if (entry.path().extension() == ".tex") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

inline std::string contents(const std::string& file) {
  std::ostringstream all;
  all << std::ifstream(file).rdbuf();
  return all.str();
}

/// The marks, such as E06, that stand as words in the comments that end the lines of a file; of each line in order.
inline void marks(const std::string& file, const std::function<bool(const std::string&)>& wanted, Lines& to) {
  std::istringstream in(contents(file));
  std::string line;
  for (unsigned at = 1; std::getline(in, line); ++at) {
    const std::size_t comment = line.find('%');
    if (comment == line.npos || comment == 0) continue;
    std::string words = line.substr(comment);
    for (char& c : words)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = ' ';
    std::istringstream split(words);
    for (std::string word; split >> word;)
      if (wanted(word)) to[file][at].push_back(word);
  }
}

inline void report(const std::vector<Defect>& defects, Lines& to) {
  for (const Defect& defect : defects) to[defect.file][defect.place.line].push_back(defect.text());
}

inline bool has(const Lines& lines, const std::string& file, unsigned line) {
  const auto entry = lines.find(file);
  return entry != lines.end() && entry->second.contains(line);
}

}  // namespace durero::zed::test
