// durero help [COMMAND | NAME]: the help of a command, or what a name of the Z text means.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "call_error.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/spec/label_index.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/spanish.hpp"
#include "embedded.hpp"
#include "help.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

using text::SpanishName;

/// A name or its English without case, underscores, blanks and the mark of an input or output.
std::string plain(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (c != '_' && c != ' ' && c != '?' && c != '!')
      letters += 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return letters;
}

/// The names of the text that the word is, or is the English of: that one alone where the word bears its mark.
std::vector<SpanishName> names_of_word(const std::string& word) {
  std::vector<SpanishName> found;
  for (const SpanishName& row : text::spanish_names()) {
    if (row.name == word && (word.ends_with('?') || word.ends_with('!'))) return {row};
    if (plain(row.name) == plain(word) || plain(row.english) == plain(word)) found.push_back(row);
  }
  return found;
}

/// The names that have the word between their underscores; none of a letter.
std::vector<std::string_view> names_made_of(std::string_view word) {
  std::vector<std::string_view> names;
  if (plain(word).size() < 2) return names;
  for (const SpanishName& row : text::spanish_names()) {
    if (row.name.find('_') == row.name.npos) continue;
    for (std::size_t begin = 0; begin < row.name.size();) {
      const std::size_t end = std::min(row.name.find('_', begin), row.name.size());
      if (plain(row.name.substr(begin, end - begin)) == plain(word)) names.push_back(row.name);
      begin = end + 1;
    }
  }
  return names;
}

/// The name, its English, its meaning, and where it stands in the text and in the program.
std::string name_text(const zed::Specification& specification, const spec::LabelIndex& index,
                      const SpanishName& row_of) {
  const auto& [name, english, meaning] = row_of;
  std::string text = fmt::format("{}{}\n  {}\n", name, english == name ? "" : fmt::format(": {}", english), meaning);
  if (const auto place = spec::name_location(specification, std::string(name), index)) {
    text += fmt::format("  {:<8}  {}  {}\n", "text", place->text, place->paragraph);
    if (!place->program.empty()) text += fmt::format("  {:<8}  {}\n", "program", place->program);
  }
  std::string line = "  in names";
  for (const std::string_view made : names_made_of(name)) {
    if (line.size() + 1 + made.size() > help_width) text += std::exchange(line, std::string(10, ' ')) + "\n";
    line += fmt::format("{}{}", line.size() == 10 ? "  " : " ", made);
  }
  if (line.size() > 10) text += line + "\n";
  return text;
}

std::string names_text(const std::vector<SpanishName>& names) {
  const zed::Specification specification = specification_of({});
  const spec::LabelIndex index(embedded::labels().begin()->second);
  std::string text;
  for (const SpanishName& name : names) text += (text.empty() ? "" : "\n") + name_text(specification, index, name);
  return text + "\ndurero spec show NAME prints the paragraph of a name, and docs/spanish.md has them all.\n";
}

/// Throws where the word is a slip of a name of the text, or of the English of one, and no slip of a command.
void refuse_near_name(const CLI::App& app, const std::string& word) {
  std::vector<std::string> commands, names;
  for (const CLI::App* below : subcommands(app)) commands.push_back(below->get_name());
  for (const SpanishName& name : text::spanish_names())
    for (const std::string_view of : {name.name, name.english}) names.emplace_back(of);
  const auto meant = text::nearest(word, names);
  if (meant && !text::nearest(word, commands))
    throw std::runtime_error(fmt::format(
        "help: {}: no such command and no such name of the text; expected {} — did you mean it?", word, *meant));
}

/// The help of a command, or of a name of the text.
std::string help_of(const CLI::App& app, const std::vector<std::string>& words) {
  const auto commands = subcommands(app);
  const auto is_first = [&](const CLI::App* command) { return command->get_name() == words.front(); };
  if (!words.empty() && std::ranges::none_of(commands, is_first)) {
    const auto names = names_of_word(fmt::format("{}", fmt::join(words, " ")));
    if (!names.empty()) return names_text(names);
    refuse_near_name(app, words.front());
  }
  return Help().make_help(&command_of(app, words, "help"), "", CLI::AppFormatMode::Normal);
}

}  // namespace

void add_help(CLI::App& app, int& status) {
  auto* command =
      app.add_subcommand("help", "Print what --help prints of a command, or what a name of the Z text means");
  const auto words = std::make_shared<std::vector<std::string>>();
  command->add_option(
      "COMMAND", *words,
      "The command that is told of, or a name of the Z text, or its English; without it, durero and all "
      "its commands");
  command->footer(exit_status("it is printed", "the call is bad") +
                  examples({"help", "help render", "help conform run", "help radio"}));
  command->callback([&app, words, &status] {
    io::print(help_of(app, *words));
    status = 0;
  });
}

}  // namespace durero::cli
