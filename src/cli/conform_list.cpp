// durero conform list [--json]: the families, with what they are for.
#include <fmt/format.h>

#include "conform.hpp"
#include "description.hpp"
#include "durero/conform/families/families.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/standard_output.hpp"

namespace durero::cli {
namespace {

using conform::Family;
using conform::NumberFormat;
using conform::Range;
using io::json::Writer;

std::string range_text(const Range& range) { return fmt::format("{} … {}", range.least, range.greatest); }

std::string text_of(const Family& family) {
  const Range& range = family.parameter;
  const Range in_binary32 = parameter(family, NumberFormat::binary32);
  std::string text = fmt::format("{:20} {}\n{:20} {}\n{:20} {}: {}", family.name, family.kind, "", family.reason, "",
                                 range.name, range_text(range));
  if (in_binary32.least != range.least || in_binary32.greatest != range.greatest)
    text += fmt::format(" ({} in binary32)", range_text(in_binary32));
  return text + '\n';
}

void write_range(Writer& out, const Range& range) {
  const double least = range.least, greatest = range.greatest;
  out.member("least", least).member("greatest", greatest);
}

std::string families_json() {
  std::string text;
  Writer out(text);
  out.begin_array();
  for (const Family& family : conform::families()) {
    out.new_line().begin_object().member("family", family.name).member("kind", family.kind);
    out.member("reason", family.reason).key("parameter").begin_object().member("name", family.parameter.name);
    write_range(out, family.parameter);
    out.key("binary32").begin_object();
    write_range(out, parameter(family, NumberFormat::binary32));
    out.end_object().end_object().end_object();
  }
  out.new_line().end_array();
  return text + '\n';
}

int run(bool as_json) {
  std::string text;
  for (const Family& family : conform::families()) text += text_of(family);
  io::print(as_json ? families_json() : text);
  return 0;
}

}  // namespace

void add_conform_list(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("list", "The families of cases: what their rays are, why, and what is drawn");
  const auto as_json = std::make_shared<bool>(false);
  command->add_flag("--json", *as_json, "As JSON");
  command->footer(exit_status("they are listed", "the call is bad") +
                  examples({"conform list", "conform list --json"}));
  command->callback([as_json, &status] { status = run(*as_json); });
}

}  // namespace durero::cli
