// durero spec refine ABSTRACT CONCRETE --by RETRIEVE FILE…: the obligations of a data refinement, written and tried.
#include "spec_refine.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/spec/refinement_trial.hpp"
#include "durero/zed/hol/hol.hpp"
#include "progress.hpp"
#include "spec.hpp"
#include "spec_machine.hpp"
#include "spec_run_typed.hpp"

namespace durero::cli {
namespace {

struct RefineCall {
  spec::RefinementCall call;
  spec::RefinementBounds bounds;
  std::vector<std::string> files, pairs, given;
  std::string write, coq, isabelle;
  bool some = false, quiet = false;
};

std::pair<std::string, std::string> pair_of(const std::string& typed) {
  const std::size_t at = typed.find('=');
  if (at == typed.npos || at == 0 || at + 1 == typed.size())
    throw io::InputError("--pair", {1, 1}, "no pair " + typed, "expected AOP=COP");
  return {typed.substr(0, at), typed.substr(at + 1)};
}

[[noreturn]] void refuse_refinement(const RefineCall& call, const std::string& said) {
  const std::size_t end = said.find("; expected");
  throw io::InputError(call.files.front(), {1, 1}, said.substr(0, end),
                       end == said.npos ? "expected a refinement" : said.substr(end + 2));
}

void write_obligations(const RefineCall& call, const zed::Specification& text, const spec::Refinement& refinement,
                       bool functional) {
  if (call.write.empty()) return;
  io::OutputFile out(call.write);
  out.write(spec::obligations_text(text, refinement, spec::obligations(refinement, functional),
                                   call.write.ends_with(".tex")));
  out.commit();
}

/// The obligations with the text's definitions, for a proof assistant.
void export_obligations(const std::string& file, zed::ProofAssistant prover, const zed::Specification& text,
                        const std::vector<spec::Obligation>& all) {
  if (file.empty()) return;
  std::vector<zed::NamedClaim> claims;
  for (const spec::Obligation& each : all) {
    std::string name = "obligation_" + each.label;
    std::replace(name.begin(), name.end(), '.', '_');
    claims.push_back({std::move(name), each.claim});
  }
  io::OutputFile out(file);
  out.write(zed::to_hol(text, zed::check(text), claims, prover, std::filesystem::path(file).stem().string()));
  out.commit();
}

int answer(const RefineCall& call, const zed::Specification& text, const spec::Refinement& refinement) {
  std::optional<Progress> progress(std::in_place, call.quiet, "spec refine");
  const spec::RefinementTrial trial = spec::try_refinement(text, refinement, call.bounds);
  progress.reset();
  note_taken(trial.taken);
  write_obligations(call, text, refinement, trial.functional);
  const std::vector<spec::Obligation> stated = spec::obligations(refinement, trial.functional);
  export_obligations(call.coq, zed::ProofAssistant::coq, text, stated);
  export_obligations(call.isabelle, zed::ProofAssistant::isabelle, text, stated);
  io::print(spec::refinement_answer(text, refinement, call.bounds, trial));
  return trial.holds() && (call.some || refinement.alone.empty()) ? 0 : 1;
}

int spec_refine(RefineCall& call) {
  for (const std::string& typed : call.pairs) call.call.pairs.push_back(pair_of(typed));
  spec::Setup setup;
  for (const std::string& typed : call.given) add_typed_members(typed, setup);
  call.bounds.given = setup.given;
  const zed::Specification text = specification_of(call.files);
  try {
    return with_constants([&] { return answer(call, text, spec::refinement_of(text, zed::check(text), call.call)); });
  } catch (const spec::RefinementError& error) {
    refuse_refinement(call, error.what());
  } catch (const spec::GivenSetError& error) {
    refuse_as_said("--given", error.what());
  } catch (const std::invalid_argument& error) {
    refuse_refinement(call, error.what());
  }
}

}  // namespace

void add_spec_refine(CLI::App& spec, int& status) {
  auto* command = spec.add_subcommand("refine", "Try whether one state of a Z text refines another");
  const auto options = std::make_shared<RefineCall>();
  command->add_option("ABSTRACT", options->call.abstract, "The schema of the abstract state")->required();
  command->add_option("CONCRETE", options->call.concrete, "The schema of the state that refines it")->required();
  command->add_option("--by", options->call.retrieve, "The schema that relates the two states")->required();
  command->add_option("FILES", options->files, "Z text in LaTeX or Unicode mark-up")->required();
  command->add_option("--pair", options->pairs, "Partners: AOP=COP, operations or initial schemas")
      ->allow_extra_args(false);
  command->add_flag("--some", options->some, "Operations without a partner are no fault");
  command->add_flag("--backward", options->call.backward, "A backward simulation, and not a forward one");
  command
      ->add_option("--scope", options->bounds.scope,
                   "Scopes from 1 to N are tried: given sets of so many members, numbers from -N to N")
      ->check(whole_number(1, 9))
      ->capture_default_str();
  command
      ->add_option("--states", options->bounds.states,
                   "How many pairs of states are reached, and how many states listed, in each scope")
      ->check(whole_number(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--given", options->given, "A given set's members: NAME=3, or NAME=ann,bob");
  command
      ->add_option("--let", options->bounds.constants,
                   "The value of a constant that the text leaves open: NAME=VALUE, in Z")
      ->allow_extra_args(false);
  command->add_option("--steps", options->bounds.steps, "How many steps of evaluation one question may take")
      ->check(whole_number(1, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_option("--write", options->write, "Write the obligations, too: LaTeX in a file NAME.tex, else Unicode");
  command->add_option("--coq", options->coq, "Write the definitions and the obligations in Coq, too");
  command->add_option("--isabelle", options->isabelle, "Write them as a theory of Isabelle/HOL, too");
  add_quiet(*command, options->quiet);
  command->footer(
      "The obligations say that nobody who uses the operations can tell the concrete state from the abstract one:\n"
      "initialisation, and for each operation applicability and correctness. They are tried on pairs of states that\n"
      "both reach together, and on all states in small scopes; what is false is shown by two traces. To try is not to\n"
      "prove. The partner of Op is Op1 where S1 refines S, or else the only operation whose name begins or ends "
      "so.\n\n" +
      exit_status("each obligation holds in every case that was tried",
                  "one is false, not tried or not decided, or an operation has no partner",
                  "the call is bad, or a text is wrong") +
      examples({"spec refine BirthdayBook BirthdayBook1 --by Abs demo/birthday_book_arrays.tex"}));
  command->callback([options, &status] { status = spec_refine(*options); });
}

}  // namespace durero::cli
