#include "description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace durero::cli {
namespace {

using Kind = OptionValue::Kind;

/// A value that is neither a number nor one of a few words, by the name of its option or argument, which means the same
/// everywhere.
struct ArgumentRow {
  std::string_view name;
  Kind kind;
  std::string_view shown;
};
constexpr std::array rows = {
    ArgumentRow{"SCENE", Kind::file, "SCENE"},         ArgumentRow{"RAYS", Kind::file, "RAYS"},
    ArgumentRow{"HITS", Kind::file, "HITS"},           ArgumentRow{"FILE", Kind::file, "FILE"},
    ArgumentRow{"FILES", Kind::file, "FILES"},         ArgumentRow{"PATH", Kind::file, "PATH"},
    ArgumentRow{"REPORT", Kind::file, "REPORT"},       ArgumentRow{"CAMPAIGN", Kind::file, "CAMPAIGN"},
    ArgumentRow{"--scene", Kind::file, "SCENE"},       ArgumentRow{"--script", Kind::file, "FILE"},
    ArgumentRow{"--output", Kind::file, "FILE"},       ArgumentRow{"--reproducer", Kind::file, "FILE"},
    ArgumentRow{"--write", Kind::file, "FILE"},        ArgumentRow{"--profile", Kind::file, "PROFILE"},
    ArgumentRow{"SYSTEM", Kind::file, "SYSTEM"},       ArgumentRow{"DIR", Kind::folder, "DIR"},
    ArgumentRow{"--systems", Kind::folder, "DIR"},     ArgumentRow{"--report", Kind::folder, "DIR"},
    ArgumentRow{"FROM", Kind::file, "FROM"},           ArgumentRow{"TO", Kind::file, "TO"},
    ArgumentRow{"--root", Kind::folder, "FOLDER"},     ArgumentRow{"--directory", Kind::folder, "DIR"},
    ArgumentRow{"EXPR", Kind::text, "EXPR"},           ArgumentRow{"NAME", Kind::text, "NAME"},
    ArgumentRow{"COMMAND", Kind::text, "COMMAND"},     ArgumentRow{"CASE", Kind::text, "CASE"},
    ArgumentRow{"--case", Kind::text, "CASE"},         ArgumentRow{"--op", Kind::text, "OPERATION"},
    ArgumentRow{"--size", Kind::text, "WxH"},          ArgumentRow{"--crop", Kind::text, "X,Y,W,H"},
    ArgumentRow{"--state", Kind::text, "SCHEMA"},      ArgumentRow{"--init", Kind::text, "SCHEMA"},
    ArgumentRow{"--given", Kind::text, "SET=MEMBERS"}, ArgumentRow{"--let", Kind::text, "NAME=VALUE"},
    ArgumentRow{"--scope", Kind::text, "NAME=SCOPE"},  ArgumentRow{"--replay", Kind::file, "TRACE"},
    ArgumentRow{"--with", Kind::file, "FILE"},         ArgumentRow{"--from", Kind::text, "X,Y,Z"},
    ArgumentRow{"--towards", Kind::text, "X,Y,Z"},     ArgumentRow{"--picture", Kind::file, "PICTURE"},
    ArgumentRow{"--mirror", Kind::text, "NAME"},       ArgumentRow{"--of", Kind::text, "NAME"},
    ArgumentRow{"--tree", Kind::file, "DRAWING"},      ArgumentRow{"POINTS", Kind::file, "POINTS"},
    ArgumentRow{"--point", Kind::text, "X,Y,Z"},       ArgumentRow{"--rays", Kind::file, "RAYS"},
    ArgumentRow{"--ranges", Kind::file, "RANGES"},     ArgumentRow{"BASE", Kind::file, "BASE"},
    ArgumentRow{"OURS", Kind::file, "OURS"},           ArgumentRow{"THEIRS", Kind::file, "THEIRS"},
    ArgumentRow{"--json-patch", Kind::file, "PATCH"},  ArgumentRow{"STORE", Kind::file, "STORE"},
    ArgumentRow{"--author", Kind::text, "NAME"},       ArgumentRow{"--time", Kind::text, "TIME"},
    ArgumentRow{"--comment", Kind::text, "COMMENT"},   ArgumentRow{"--salvage", Kind::file, "STORE"},
    ArgumentRow{"--for-each", Kind::text, "SET"},      ArgumentRow{"--why-not", Kind::text, "OPERATION"},
    ArgumentRow{"--host", Kind::text, "ADDRESS"},      ArgumentRow{"--token", Kind::file, "FILE"},
    ArgumentRow{"--origin", Kind::text, "ORIGIN"},     ArgumentRow{"--by", Kind::text, "SCHEMA"},
    ArgumentRow{"--pair", Kind::text, "AOP=COP"},      ArgumentRow{"--coq", Kind::file, "FILE"},
    ArgumentRow{"--isabelle", Kind::file, "FILE"},     ArgumentRow{"--numbers", Kind::text, "LOW..HIGH"},
    ArgumentRow{"--always", Kind::text, "PREDICATE"},  ArgumentRow{"--eventually", Kind::text, "PREDICATE"},
    ArgumentRow{"--leads-to", Kind::text, "P Q"},      ArgumentRow{"--dot", Kind::file, "FILE"},
    ArgumentRow{"--svg", Kind::file, "FILE"},          ArgumentRow{"--trace", Kind::file, "TRACE"},
    ArgumentRow{"--solver", Kind::text, "PROGRAM"},
};

/// CLI11's description of an option: its type, and behind a colon the descriptions of its checks.
struct Typed {
  std::string type, checks;
};

Typed typed(const CLI::Option& option) {
  const std::string whole = option.get_type_name();
  const std::size_t colon = whole.find(':');
  if (colon == whole.npos) return {whole, ""};
  return {whole.substr(0, colon), whole.substr(colon + 1)};
}

std::vector<std::string> listed(std::string_view words) {
  std::vector<std::string> list;
  std::istringstream in{std::string(words)};
  for (std::string word; std::getline(in, word, ',');) list.push_back(word);
  return list;
}

/// `--engine` is shown with ENGINE.
std::string capital(std::string name) {
  name.erase(0, name.find_first_not_of('-'));
  std::ranges::transform(name, name.begin(), [](char c) { return 'a' <= c && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return name;
}

}  // namespace

OptionValue value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  const std::string name = option.get_name();
  const auto [type, checks] = typed(option);
  const bool is_place = option.get_positional();
  if (checks.starts_with('{'))
    return {Kind::word, capital(name), listed(std::string_view(checks).substr(1, checks.find('}') - 1)), ""};
  if (type == "UINT" || type == "INT" || type == "FLOAT")
    return {Kind::number, is_place ? name : type == "FLOAT" ? "NUMBER" : "N", {}, checks};
  const auto* const row = std::ranges::find(rows, name, &ArgumentRow::name);
  if (row == rows.end()) return {Kind::text, type, {}, ""};
  return {row->kind, std::string(row->shown), {}, ""};
}

std::string path_of(const CLI::App& command) {
  if (command.get_parent() == nullptr) return "";
  const std::string above = path_of(*command.get_parent());
  return above.empty() ? command.get_name() : above + " " + command.get_name();
}

std::vector<const CLI::App*> subcommands(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::App*> with_subcommands(const CLI::App& command) {
  std::vector<const CLI::App*> all{&command};
  for (const CLI::App* below : subcommands(command)) {
    const auto more = with_subcommands(*below);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::vector<const CLI::Option*> arguments(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::vector<const CLI::Option*> options(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return !option->get_positional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& letter : option.get_snames()) names.push_back("-" + letter);
  for (const std::string& word : option.get_lnames()) names.push_back("--" + word);
  return names;
}

std::string usage(const CLI::App& command) {
  const std::string path = path_of(command);
  std::string text = "durero" + (path.empty() ? "" : " " + path);
  std::string rest;
  for (const CLI::Option* option : options(command)) {
    const OptionValue value = value_of(*option);
    if (option->get_required()) rest += " " + option->get_name() + (value.kind == Kind::none ? "" : " " + value.name);
  }
  for (const CLI::Option* argument : arguments(command)) {
    const std::string several = argument->get_items_expected_max() > 1 ? "..." : "";
    rest +=
        argument->get_required() ? " " + argument->get_name() + several : " [" + argument->get_name() + several + "]";
  }
  if (!subcommands(command).empty()) rest += " COMMAND";
  return text + " [OPTION]..." + rest;
}

std::vector<FooterSection> sections(const CLI::App& command) {
  std::vector<FooterSection> sections;
  std::istringstream lines(command.get_footer());
  for (std::string line; std::getline(lines, line);) {
    const bool is_title = !line.empty() && line.front() != ' ' && line.back() == ':';
    const bool goes_on = !sections.empty() && (line.starts_with("  ") || sections.back().title.empty());
    if (is_title)
      sections.push_back({line.substr(0, line.size() - 1), {}});
    else if (goes_on || line.empty()) {
      if (!line.empty()) sections.back().lines.push_back(line);
    } else
      sections.push_back({"", {line}});
  }
  return sections;
}

std::string exit_status(const std::string& zero, const std::string& one, const std::string& two) {
  return fmt::format("Exit status:\n  0  {}\n{}  2  {}\n\n", zero, one.empty() ? "" : fmt::format("  1  {}\n", one),
                     two);
}

std::string exit_status(const std::string& zero, const std::string& two) { return exit_status(zero, "", two); }

std::string examples(const std::vector<std::string>& calls) {
  std::string text = "Examples:";
  for (const std::string& call : calls) text += "\n  durero " + call;
  return text;
}

}  // namespace durero::cli
