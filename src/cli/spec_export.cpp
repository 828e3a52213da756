// durero spec export --coq FILE…: the Z text in another language.
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/output_file.hpp"
#include "durero/zed/coq/coq.hpp"

namespace durero::cli {
namespace {

struct SpecExportOptions {
  std::vector<std::string> files;
  std::string to = "-";
};

void refuse(const std::vector<zed::Defect>& defects) {
  if (!defects.empty()) throw std::runtime_error(defects.front().text());
}

int export_coq(const SpecExportOptions& options) {
  io::OutputFile out(options.to);
  const zed::Specification specification = zed::read_files(options.files);
  refuse(specification.defects);
  const zed::Typing typing = zed::check(specification);
  refuse(typing.defects);
  out.write(zed::to_coq(specification, typing));
  out.commit();
  return 0;
}

}  // namespace

void add_spec_export(CLI::App& spec, int& status) {
  auto* command = spec.add_subcommand("export", "Write the Z text in another language");
  const auto options = std::make_shared<SpecExportOptions>();
  command->add_flag("--coq")->required()->description(
      "As Coq: proofs/Especificacion.v is that of the texts in spec/ that have one state, Escena");
  command->add_option("-o,--output", options->to, "File to write; without it, the standard output");
  command->add_option("FILE", options->files, "Z texts in LaTeX mark-up; their parents are found beside them")
      ->required();
  command->footer(exit_status("it is written", "the call is bad, or a text is wrong") +
                  examples({"spec export --coq spec/interseccion.tex -o Especificacion.v"}));
  command->callback([options, &status] { status = export_coq(*options); });
}

}  // namespace durero::cli
