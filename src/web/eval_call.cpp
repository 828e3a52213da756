// Expressions and predicates, in the words of `durero spec eval`.
#include <fmt/format.h>

#include <array>

#include "calls.hpp"
#include "durero/model/escena.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/calculator.hpp"
#include "durero/spec/constants.hpp"
#include "durero/spec/refusal.hpp"
#include "durero/text/shown.hpp"
#include "held.hpp"
#include "held_scene.hpp"
#include "held_text.hpp"
#include "json_text.hpp"

namespace durero::web {
namespace {

constexpr std::array<std::string_view, 8> eval_keys{"expression", "scene", "text",    "name",
                                                    "let",        "steps", "explain", "bindings"};
constexpr const char* expression_name = "expression";
constexpr std::uint64_t default_steps = 100'000'000;  // as of `durero spec eval`
constexpr std::uint64_t most_steps = std::uint64_t{1} << 53U;

spec::Calculator calculator_of(const AskedCall& asked) {
  if (asked.has("text") || asked.has("name")) {
    const auto text = text_of(asked);
    text->require_right();
    return spec::Calculator(text->text);
  }
  if (asked.has("scene")) return spec::Calculator(scene::retrieve(scene_of(asked)->scene()));
  return {};
}

/// The calculator of a call. It is kept, because most calls ask it about the same scene or text again.
std::shared_ptr<const spec::Calculator> calculator(const AskedCall& asked) {
  thread_local Held<spec::Calculator> held(4);
  std::string key;
  for (const char* part : {"name", "text", "scene"}) {
    if (asked.has(part)) key.append(asked.part(part).text());
    key.append(1, '\0');
  }
  for (const std::string& let : asked.texts("let")) key.append(let).append(1, '\0');
  return held.of(key, [&] {
    auto made = std::make_shared<spec::Calculator>(calculator_of(asked));
    try {
      made->let(asked.texts("let"));
    } catch (const spec::ConstantError& error) {
      throw io::InputError("let", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
    }
    return made;
  });
}

std::string tree_text(const spec::ExplainedTerm& term) {
  return ObjectText()
      .member("term", term.term)
      .member("value", term.value)
      .member("witness", term.is_witness)
      .raw("parts", array_of(term.parts, tree_text))
      .text();
}

/// The local names of a call, by their values in Z.
spec::LocalNames bindings_of(const AskedCall& asked, const spec::Calculator& of, zed::Steps& steps) {
  spec::LocalNames locals;
  if (!asked.has("bindings")) return locals;
  io::json::Reader in = asked.at("bindings");
  in.members("bindings", [&](const io::json::Key& key) {
    const std::size_t at = in.offset();
    try {
      of.add_local(locals, std::string(key.name), std::string(in.string("a value")), steps);
    } catch (const zed::ZError& error) {
      in.fail(at, fmt::format("{}: {}", text::escaped(key.name), error.what_is_wrong), error.expected);
    }
  });
  return locals;
}

std::string evaluated(const AskedCall& asked, const std::string& expression, zed::Steps& steps) {
  const auto text = calculator(asked);
  const spec::LocalNames locals = bindings_of(asked, *text, steps);
  ObjectText answer;
  if (asked.flag("explain", false)) {
    const spec::ExplainedTerm whole = text->explained(expression, steps, locals);
    answer.raw("tree", tree_text(whole)).raw("lines", array_of_lines(spec::explanation_text(whole), true));
  }
  const spec::Calculator::Result result = text->evaluate(expression, steps, locals);
  return answer.member("value", result.text)
      .member("yes", result.yes)
      .member("steps", std::uint64_t{steps.taken()})
      .raw("taken", array_of_texts(spec::taken_lines(result.taken)))
      .text();
}

}  // namespace

std::string answer_eval(const AskedCall& asked) {
  asked.require(eval_keys, 1);
  if (asked.has("text") && asked.has("scene"))
    asked.source().fail(asked.at("scene").offset(), "a scene is a state of the program's own text",
                        "expected no text beside it");
  const std::string expression = asked.text("expression", "");
  zed::Steps steps(asked.whole("steps", 1, most_steps, default_steps));
  try {
    return evaluated(asked, expression, steps);
  } catch (const zed::ZError& error) {
    throw io::InputError(expression_name, {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  } catch (const zed::EvaluationError& error) {
    const auto [wrong, expected] = spec::refusal_of(error);
    throw io::InputError(expression_name, {1, 1}, wrong, expected);
  } catch (const zed::StepsSpent&) {
    throw io::InputError(expression_name, {1, 1},
                         fmt::format("steps {0} did not do: stopped after {0} steps", steps.most()),
                         "expected a smaller expression, or a greater steps");
  }
}

}  // namespace durero::web
