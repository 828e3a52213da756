// durero spec …: the Z text read, type-checked, evaluated, shown with all that carries it out, and asked about hits.
#include "spec.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/oracle/spec.hpp"
#include "durero/zed/review/review.hpp"

namespace durero::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string expression, name, scene, rays, hits;
};

std::string defects_text(const std::vector<zed::Defect>& defects) {
  std::string said;
  for (const zed::Defect& defect : defects) said += defect.text() + "\n";
  return said;
}

bool has_error(const std::vector<zed::Defect>& defects) {
  for (const zed::Defect& defect : defects) {
    if (defect.severity == zed::Defect::Severity::error) return true;
  }
  return false;
}

std::string sections_text(const zed::Specification& specification) {
  std::string said;
  for (const zed::Section& section : specification.sections) {
    said += fmt::format("{}: section {} ok, {} paragraphs\n", section.file, section.name, section.paragraphs.size());
  }
  return said;
}

// A file of which nothing was read was meant to hold something.
std::string empty_files(const std::vector<std::string>& files, const zed::Specification& read) {
  std::string said;
  for (const std::string& file : files) {
    const auto here = [&](const zed::Section& section) { return section.file == file; };
    if (std::none_of(read.sections.begin(), read.sections.end(), here))
      said += fmt::format("{}:1:1: no Z paragraph; expected \\begin{{zed}}, axdef, schema, gendef or zsection\n", file);
  }
  return said;
}

}  // namespace

namespace {

// Throws where a file cannot be read.
std::vector<std::pair<std::string, std::string>> sources(const std::vector<std::string>& files) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const std::string& file : files) texts.emplace_back(file, io::read_source(file).text());
  return texts;
}

}  // namespace

int spec_check(const std::vector<std::string>& files) {
  const zed::Specification read = files.empty() ? oracle::spec::text() : zed::read_sources(sources(files));
  const std::vector<zed::Defect> defects = zed::review(read);
  const std::string empty = has_error(defects) ? "" : empty_files(files, read);
  const bool wrong = has_error(defects) || !empty.empty();
  io::write_file("-", defects_text(defects) + empty + (wrong ? "" : sections_text(read)));
  return wrong ? 1 : 0;
}

void add_spec(CLI::App& app, int& status) {
  auto* spec = app.add_subcommand("spec", "Read, check, evaluate and show the Z text");
  spec->require_subcommand(1);
  add_spec_export(*spec, status);
  const auto options = std::make_shared<Options>();

  auto* check = spec->add_subcommand("check", "Read and type-check Z text; each defect at its line");
  check->add_option("FILES", options->files, "Z text in LaTeX mark-up; without it, the program's own text");
  check->callback([options, &status] { status = spec_check(options->files); });

  auto* eval = spec->add_subcommand("eval", "The value of an expression, or whether a predicate holds");
  eval->add_option("EXPR", options->expression, "Z, in Unicode or in LaTeX mark-up")->required();
  eval->add_option("--scene", options->scene, "Scene file: Escena's components and the elements are then names");
  eval->footer(
      "θ is a letter, so a space stands behind it: θ Escena.\n"
      "An element's name may stand between quotation marks, and does where it is no word: mi_radio(\"a-b\").\n"
      "Numbers may be decimal; / and √ are known: 0.25 + 1/3 * √2.\n"
      "What begins with - is taken for an option unless -- stands before it: spec eval -- '-(2)'.\n"
      "Status 0: a value, or true; 1: undefined, or false; 2: it cannot be read, or decided.");
  eval->callback([options, &status] { status = spec_eval(options->expression, options->scene); });

  auto* show = spec->add_subcommand("show", "A paragraph, and where each of its predicates is carried out");
  show->add_option("NAME", options->name, "A name that the text declares, or a label")->required();
  show->callback([options, &status] { status = spec_show(options->name); });

  auto* confirm = spec->add_subcommand("confirm", "Let the Z text decide whether hits are right");
  confirm->footer(
      "The text decides all of it: where on the ray its points lie on an element, and so that a miss is one; the\n"
      "elements of the point; which point is the reduction of them all; and where no point is nearest. The program\n"
      "adds the roots of the polynomials in t that the text compares with 0, and the rounding of the hit's numbers.\n"
      "Each ray has one line in HITS, in any order. A JSON line for each ray and one with the counts go to stdout.\n"
      "Status 0: every ray is answered, and rightly; 1: some ray is not; 2: a file cannot be read.");
  confirm->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  confirm->add_option("RAYS", options->rays, "Ray file")->required();
  confirm->add_option("HITS", options->hits, "Hit file (JSON lines)")->required();
  confirm->callback([options, &status] { status = spec_confirm(options->scene, options->rays, options->hits); });
}

}  // namespace durero::cli
