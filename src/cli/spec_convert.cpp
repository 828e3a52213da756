// durero spec convert FILE [--to iso|latex|unicode|spivey] [-o OUT]: a Z text in another mark-up.
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/zed/print/convert.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

struct SpecConvertOptions {
  std::string file, form;
  std::string to = "-";
};

zed::Form wanted(const SpecConvertOptions& options, const std::string& text) {
  if (options.form.empty()) return zed::form_of(text) == zed::Form::unicode ? zed::Form::latex : zed::Form::unicode;
  if (options.form == "spivey") return zed::Form::spivey;
  return options.form == "unicode" ? zed::Form::unicode : zed::Form::latex;
}

int convert(const SpecConvertOptions& options) {
  io::OutputFile out(options.to);
  const std::string text(io::read_source(options.file).text());
  const zed::Specification read = zed::read_sources({{options.file, text}});
  refuse_unread({options.file}, read);
  try {
    out.write(zed::converted(text, wanted(options, text), read));
  } catch (const zed::ZError& error) {
    throw io::InputError(options.file, {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  }
  out.commit();
  return 0;
}

}  // namespace

void add_spec_convert(CLI::App& spec, int& status) {
  auto* command = spec.add_subcommand("convert", "Write a Z text in Unicode instead of LaTeX, or the other way round");
  const auto options = std::make_shared<SpecConvertOptions>();
  command->add_option("FILE", options->file, "Z text in LaTeX or Unicode mark-up; its parents are found beside it")
      ->required();
  command
      ->add_option(
          "--to", options->form,
          "The mark-up to write, of which iso is LaTeX, too, and spivey that of fuzz; without it, Unicode for a "
          "FILE in LaTeX, and LaTeX for one in Unicode")
      ->check(CLI::IsMember({"iso", "latex", "unicode", "spivey"}));
  command->add_option("-o,--output", options->to, "File to write; without it, the standard output");
  command->footer(
      "Each paragraph keeps its tokens, labels and comments, and the prose between stays byte for byte. A text that\n"
      "is in the mark-up already is written as it is. The text must be readable; its types are not asked for. What "
      "Spivey's\nZ has no form for, as a section of one's own among the parents, is refused at its place.\n\n" +
      exit_status("it is written", "the call is bad, or the other mark-up cannot say the text") +
      examples({"spec convert demo/birthday_book.tex", "spec convert mine.utf8 --to latex -o mine.tex"}));
  command->callback([options, &status] { status = convert(*options); });
}

}  // namespace durero::cli
