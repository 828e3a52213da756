// durero conform answer [--engine E]: this program as a system, which is asked as any other is.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "conform.hpp"
#include "description.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/io/standard_output.hpp"
#include "engines.hpp"

namespace durero::cli {
namespace {

conform::Claim claim_of(const scene::Hit& hit) {
  using Outcome = conform::Claim::Outcome;
  switch (hit.resultado) {
    case model::Resultado::hit:
      return {.outcome = Outcome::hit, .element = hit.elementos.front(), .t = hit.t, .punto = hit.punto};
    case model::Resultado::miss:
      return {.outcome = Outcome::miss};
    case model::Resultado::no_minimum:
      return {.why = "no point of the elements is the nearest"};
  }
  __builtin_unreachable();  // a Resultado is one of its enumerators
}

/// The answer to a shadow ray: whether the first hit is not behind its end. A stretch inside a surface begins before.
conform::Claim shadow_of(const scene::Hit& hit, double end) {
  using Outcome = conform::Claim::Outcome;
  const bool is_hit =
      hit.resultado == model::Resultado::no_minimum || (hit.resultado == model::Resultado::hit && hit.t <= end);
  return {.outcome = is_hit ? Outcome::hit : Outcome::miss};
}

/// The line that a system writes for the claim; a ray without an answer is refused.
std::string answer_line(const conform::Claim& claim, const scene::Scene& scene) {
  return claim.outcome == conform::Claim::Outcome::unanswered ? "refused " + claim.why
                                                              : conform::claim_text(claim, scene);
}

int answer(const std::string& engine_name) {
  io::print(fmt::format("system durero {} {}\n", DURERO_VERSION, engine_name));
  conform::QuestionReader questions(*stdin);
  while (const auto question = questions.next()) {
    const auto engine = engine::find(engine_name)->prepare(question->scene);
    std::string answers;
    const std::vector<scene::Hit> hits = engine::first_hits(*engine, question->rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const conform::Claim claim = question->ends.empty() ? claim_of(hits[i]) : shadow_of(hits[i], question->ends[i]);
      answers += answer_line(claim, question->scene) + "\n";
    }
    io::print(answers);
  }
  return 0;
}

}  // namespace

void add_conform_answer(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("answer", "Answer questions on the standard input, as a system does");
  const auto engine = std::make_shared<std::string>(engine::default_engine);
  add_engine(*command, *engine);
  command->footer(exit_status("the questions are at an end", "the call or a question is bad") +
                  examples({"conform answer --engine exact"}));
  command->callback([engine, &status] { status = answer(*engine); });
}

}  // namespace durero::cli
