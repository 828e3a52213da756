// durero conform show --case FAMILY/NUMBER --ray N: a ray of a suite and its exact answer.
#include <memory>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "description.hpp"
#include "durero/conform/report/explanation.hpp"
#include "durero/io/standard_output.hpp"

namespace durero::cli {

void add_conform_show(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("show", "A ray of a suite and its exact answer, to forty digits");
  const auto call = std::make_shared<CaseCall>();
  add_case(*command, *call);
  add_elements(*command, call->suite);
  add_question(*command, call->suite.question);
  command->footer(exit_status("it is shown", "the call is bad, or the suite has no such ray") +
                  examples({"conform show --case tiny/0007 --ray 3"}));
  command->callback([call, &status] {
    io::print(conform::explanation(case_of(*call, suite_of(call->suite)), call->ray));
    status = 0;
  });
}

}  // namespace durero::cli
