#include "durero/conform/report/reproducer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <ranges>
#include <sstream>
#include <stdexcept>

#include "conform/ask/child.hpp"
#include "conform/report/reproducer_words.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

namespace fs = std::filesystem;

/// The value with the text before it repeated on each of its lines.
std::string on_each_line(const std::string& before, const std::string& value) {
  std::string text;
  std::istringstream lines(value);
  for (std::string line; std::getline(lines, line);) text += (text.empty() ? "" : "\n" + before) + line;
  return text;
}

/// The line with its names replaced by what they stand for.
std::string filled(std::string_view line, const Words& words) {
  std::string text;
  for (std::size_t at = 0; (at = line.find("@(")) != line.npos;) {
    const std::size_t end = line.find(')', at);
    const std::string name(line.substr(at + 2, end == line.npos ? end : end - at - 2));
    const auto word = words.find(name);
    if (end == line.npos || word == words.end())
      throw std::runtime_error(fmt::format("nothing is called {}; expected one of {}", text::shown(name),
                                           fmt::join(std::views::keys(words), ", ")));
    text += line.substr(0, at);
    text += on_each_line(text, word->second);
    line.remove_prefix(end + 1);
  }
  return text + std::string(line);
}

/// A line of a template: its text, and the types of the elements for which it is repeated; without types it stands
/// once.
struct TemplateLine {
  std::string text;
  std::vector<std::string> tipos{};

  explicit TemplateLine(const std::string& line) : text(line) {
    const std::size_t at = line.find_first_not_of(' ');
    if (at == line.npos || line[at] != '@' || line.compare(at, 2, "@(") == 0) return;
    const std::size_t end = std::min(line.find(' ', at), line.size());
    std::istringstream words(line.substr(at + 1, end - at - 1));
    for (std::string word; std::getline(words, word, ',');) tipos.push_back(word);
    text = line.substr(0, at) + (end < line.size() ? line.substr(end + 1) : "");
  }

  bool stands_for(std::string_view tipo) const {
    return std::ranges::any_of(tipos, [&](const std::string& word) { return word == tipo || word == "each"; });
  }
};

/// A template that is filled in line after line.
class TemplateFiller {
 public:
  TemplateFiller(Words words, std::vector<ElementWords> elements)
      : words_(std::move(words)), elements_(std::move(elements)) {
    for (ElementWords& element : elements_) element.words.insert(words_.begin(), words_.end());
  }

  void add(const TemplateLine& line) {
    if (!line.tipos.empty()) return block_.push_back(line);
    end_block();
    text_ += filled(line.text, words_) + "\n";
  }

  std::string result() && {
    end_block();
    return std::move(text_);
  }

 private:
  void end_block() {
    if (block_.empty()) return;
    for (const ElementWords& element : elements_) {
      for (const TemplateLine& line : block_) {
        if (line.stands_for(element.tipo)) text_ += filled(line.text, element.words) + "\n";
      }
    }
    block_.clear();
  }

  Words words_;
  std::vector<ElementWords> elements_;
  std::vector<TemplateLine> block_;
  std::string text_;
};

/// A temporary folder that is removed with this object.
class Folder {
 public:
  Folder() {
    std::string name = fs::temp_directory_path() / "durero-reproducer-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder; expected room for one");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

struct EndedProgram {
  bool well = false;
  std::string text{};   // of its standard output
  std::string words{};  // the end of the process, and of its standard error
};

EndedProgram run(const Command& command, const std::string& folder, const std::atomic<bool>& stop) {
  constexpr Seconds time_of_a_line{300};
  Child child(command, {.folder = folder}, stop);
  child.close_input();
  EndedProgram ended;
  for (std::string line; child.next_line(time_of_a_line, line) == Child::Event::line;) ended.text += line + "\n";
  const std::string how = child.end();
  ended.well = how == "exit status 0";
  ended.words = fmt::format("{}: {}", how, text::escaped(child.last_words()));
  return ended;
}

constexpr std::string_view got = "got: ";

}  // namespace

std::string reproducer_text(const System& system, const Finding& finding, const std::string& about,
                            const std::string& file) {
  Words words = ray_words(finding.of);
  words["file"] = file;
  words["about"] = about;
  words["expected"] = expected_answer(finding, system.profile);
  words.insert(system.reproducer.words.begin(), system.reproducer.words.end());
  TemplateFiller filling(std::move(words), element_words(finding.of));
  std::istringstream lines(std::string(io::read_source(system.reproducer.program).text()));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      filling.add(TemplateLine(line));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", system.reproducer.program, number, error.what()));
    }
  }
  return std::move(filling).result();
}

Reproduction reproduced(const System& system, const Finding& finding, const std::string& program,
                        const std::string& file, const std::atomic<bool>& stop) {
  const Folder folder;
  const std::string path = folder.path() + "/" + file;
  io::write_file(path, program);
  EndedProgram ended{.well = true};
  for (const Command& command : system.reproducer.run) {
    if (ended.well)
      ended = run(filled_in(command, {{"program", path}, {"built", folder.path() + "/built"}}), folder.path(), stop);
  }
  Reproduction reproduction{.words = ended.words};
  Claim claim{.outcome = Claim::Outcome::crashed};
  const std::size_t answer = ended.text.find(got);  // a system's own words may stand before it on the line
  if (answer != ended.text.npos) {
    reproduction.output = ended.text.substr(answer);
    const std::string line = reproduction.output.substr(0, reproduction.output.find('\n'));
    claim = read_answer(line.substr(got.size()), finding.of, system.profile.caps);
  }
  reproduction.verdict = judge(finding.of, 0, claim, system.profile).verdict;
  return reproduction;
}

}  // namespace durero::conform
