/// The schemas that the trial of a refinement asks.
#include "obligations.hpp"
#include "simulation.hpp"

namespace durero::spec {
namespace {

zed::Paragraph defined(const std::string& name, const zed::Term& schema) {
  return {{}, zed::Definition{{name, ""}, {}, schema, {}}};
}

}  // namespace

std::string done_and_related(std::size_t i) { return " done and related " + std::to_string(i); }
std::string related_and_done(std::size_t i) { return " related and done " + std::to_string(i); }

zed::Section simulation_section(const zed::Specification& text, const Refinement& refinement) {
  zed::Section section;
  section.file = "REFINE";
  section.name = " refinement";
  for (const zed::Section& each : text.sections) section.parents.push_back(each.name);
  const zed::Term r = schema_named(refinement.retrieve), after = dashed(r);
  section.paragraphs = {defined(retrieve_after, after), defined(first_of_abstract, first_abstract(refinement)),
                        defined(first_of_concrete, first_concrete(refinement)),
                        defined(first_related, both_hold(first_abstract(refinement), after))};
  for (std::size_t i = 0; i < refinement.operations.size(); ++i) {
    const zed::Term operation = schema_named(refinement.operations[i].abstract);
    section.paragraphs.push_back(defined(done_and_related(i), both_hold(after, operation)));
    section.paragraphs.push_back(defined(related_and_done(i), both_hold(r, operation)));
  }
  return section;
}

}  // namespace durero::spec
