// durero spec export --coq FILE…: the Z text in another language.
#include "commands.hpp"
#include "durero/io/output_file.hpp"
#include "durero/zed/coq/coq.hpp"

namespace durero::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string to = "-";
};

void refuse(const std::vector<zed::Defect>& defects) {
  if (!defects.empty()) throw std::runtime_error(defects.front().text());
}

int export_coq(const Options& options) {
  const zed::Specification specification = zed::read_files(options.files);
  refuse(specification.defects);
  const zed::Typing typing = zed::check(specification);
  refuse(typing.defects);
  io::write_file(options.to, zed::to_coq(specification, typing));
  return 0;
}

}  // namespace

void add_spec_export(CLI::App& spec, int& status) {
  auto* command = spec.add_subcommand("export", "Write the Z text in another language");
  const auto options = std::make_shared<Options>();
  command->add_flag("--coq")->required()->description("As Coq: proofs/Especificacion.v is that of spec/*.tex");
  command->add_option("-o,--output", options->to, "File to write; without it, the standard output");
  command->add_option("FILE", options->files, "Z texts in LaTeX mark-up; their parents are found beside them")
      ->required();
  command->callback([options, &status] { status = export_coq(*options); });
}

}  // namespace durero::cli
