// durero man [COMMAND]... [--directory DIR]: the manual's pages, in roff.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "call_error.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/text/utf8.hpp"
#include "durero/text/whole_number.hpp"
#include "help.hpp"

namespace durero::cli {
namespace {

/// The text as roff prints it: a minus that can be copied, no escapes but these, no character that a printer lacks.
std::string roff(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out = "\\&";
  for (; !text.empty(); text.remove_prefix(text::first(text).size())) {
    const auto character = text::decode(text);
    if (text.front() == '-')
      out += "\\-";
    else if (text.front() == '\\')
      out += "\\(rs";
    else if (character && character->code > 0x7F)
      out += fmt::format("\\[u{:04X}]", static_cast<std::uint32_t>(character->code));
    else
      out += text.front();
  }
  return out;
}

/// durero-conform-run
std::string page_name(const CLI::App& command) {
  std::string name = path_of(command).empty() ? "durero" : "durero-" + path_of(command);
  std::ranges::replace(name, ' ', '-');
  return name;
}

/// The day of SOURCE_DATE_EPOCH, or none: the same sources give the same pages.
std::string day() {
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = epoch == nullptr ? std::nullopt : text::whole_number(epoch);
  if (!seconds) return "";
  const auto day = std::chrono::floor<std::chrono::days>(std::chrono::sys_seconds(std::chrono::seconds(*seconds)));
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", int(date.year()), unsigned(date.month()), unsigned(date.day()));
}

std::string heading(const std::string& title) {
  std::string capital = title;
  std::ranges::transform(capital, capital.begin(), [](char c) { return 'a' <= c && c <= 'z' ? char(c - 32) : c; });
  return ".SH " + roff(capital) + "\n";
}

std::string entry(const std::string& names, const std::string& said) {
  return fmt::format(".TP\n{}\n{}\n", names, roff(said));
}

std::string entry(const CLI::Option& option) {
  const OptionValue value = value_of(option);
  if (option.get_positional()) return entry("\\fI" + roff(option.get_name()) + "\\fR", said_of(option));
  std::vector<std::string> names;
  for (const std::string& name : names_of(option)) names.push_back("\\fB" + roff(name) + "\\fR");
  return entry(
      fmt::format("{}{}", fmt::join(names, ", "), value.name.empty() ? "" : " \\fI" + roff(value.name) + "\\fR"),
      said_of(option));
}

template <class OptionList>
std::string entries(const char* title, const OptionList& all) {
  std::string text;
  for (const CLI::Option* option : all) text += entry(*option);
  return text.empty() ? "" : heading(title) + text;
}

std::string commands_section(const CLI::App& command) {
  std::string text;
  for (const CLI::App* below : subcommands(command))
    text += entry("\\fB" + roff(below->get_name()) + "\\fR",
                  below->get_description() + ": see " + page_name(*below) + "(1)");
  return text.empty() ? "" : heading("Commands") + text;
}

/// The text of a section: exit statuses as a list of terms, calls as they are typed.
std::string section_text(const FooterSection& section) {
  std::string text = heading(section.title);
  const bool is_list = section.title == "Exit status";
  if (!is_list) text += ".nf\n";
  for (const std::string& line : section.lines)
    text += is_list ? entry(line.substr(2, 1), line.substr(5)) : roff(line.substr(2)) + "\n";
  return text + (is_list ? "" : ".fi\n");
}

std::string see_also(const CLI::App& command) {
  std::vector<std::string> pages;
  if (command.get_parent() != nullptr) pages.push_back("\\fB" + roff(page_name(*command.get_parent())) + "\\fR(1)");
  for (const CLI::App* below : subcommands(command)) pages.push_back("\\fB" + roff(page_name(*below)) + "\\fR(1)");
  return pages.empty() ? "" : fmt::format("{}{}\n", heading("See also"), fmt::join(pages, ",\n"));
}

std::string page(const CLI::App& command) {
  const std::string name = page_name(command);
  std::string title = name;
  std::ranges::transform(title, title.begin(), [](char c) { return 'a' <= c && c <= 'z' ? char(c - 32) : c; });
  std::string text = fmt::format(".TH {} 1 \"{}\" \"durero {}\" \"Durero\"\n", roff(title), day(), DURERO_VERSION);
  text += heading("Name") + fmt::format("{} \\- {}\n", roff(name), roff(command.get_description()));
  text += heading("Synopsis") + roff(usage(command)) + "\n";
  text += heading("Description") + roff(command.get_description()) + ".\n";
  for (const FooterSection& section : sections(command)) {
    if (!section.title.empty()) continue;
    text += ".PP\n";
    for (const std::string& line : section.lines) text += roff(line) + "\n";
  }
  text += commands_section(command) + entries("Arguments", arguments(command)) + entries("Options", options(command));
  for (const FooterSection& section : sections(command))
    if (!section.title.empty()) text += section_text(section);
  return text + see_also(command);
}

struct ManOptions {
  std::vector<std::string> words;
  std::string directory;
};

int run(const CLI::App& app, const ManOptions& options) {
  if (options.directory.empty()) {
    io::print(page(command_of(app, options.words, "man")));
    return 0;
  }
  std::filesystem::create_directories(options.directory);
  for (const CLI::App* command : with_subcommands(command_of(app, options.words, "man")))
    io::write_file(fmt::format("{}/{}.1", options.directory, page_name(*command)), page(*command));
  return 0;
}

}  // namespace

void add_man(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("man", "Print a page of the manual, or write all, in roff");
  const auto options = std::make_shared<ManOptions>();
  command->add_option("COMMAND", options->words, "The page of this command; without it, that of durero");
  command->add_option("--directory", options->directory, "Write this page, and those of all commands below, there");
  command->footer("A page bears the date that SOURCE_DATE_EPOCH says, and else none.\n\n" +
                  exit_status("it is printed or written", "the call is bad, or a page cannot be written") +
                  examples({"man", "man conform run", "man --directory man1"}));
  command->callback([&app, options, &status] { status = run(app, *options); });
}

}  // namespace durero::cli
