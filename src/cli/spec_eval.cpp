// durero spec eval EXPR [--scene SCENE]: the value of an expression, or whether a predicate holds.
#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "durero/io/output_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/oracle/spec.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/syntax/symbols.hpp"
#include "durero/zed/types/toolkit.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

constexpr const char* section_name = "call";
constexpr const char* file_name = "EXPR";

// A section that sees the whole text. With a scene it declares Escena, its elements by name, and no more.
zed::Section calling_section(const zed::Specification& specification) {
  zed::Section made;
  made.file = file_name;
  made.name = section_name;
  for (const zed::Section& one : specification.sections) made.parents.push_back(one.name);
  return made;
}

// A name that the text does not use, and that a Z name can be.
bool free_word(const zed::Typing& typing, const std::string& word) {
  static const std::regex pattern("[A-Za-z][A-Za-z0-9_]*");
  const zed::Name name{word, ""};
  return std::regex_match(word, pattern) && !zed::is_reserved(word) && !typing.find(section_name, name) &&
         !zed::toolkit().contains(name);
}

struct Call {
  zed::Specification specification = oracle::spec::text();
  zed::Typing typing{};
  zed::Given given{};

  explicit Call(const std::string& scene) {
    specification.sections.push_back(calling_section(specification));
    typing = zed::check(specification);
    if (scene.empty()) return;
    const model::Escena escena = scene::retrieve(io::read_scene(io::read_source(scene)));
    given = oracle::spec::components(escena);
    declare(escena);
    typing = zed::check(specification);
  }

 private:
  void declare(const model::Escena& escena) {
    using Form = zed::Declaration::Form;
    zed::Axiomatic box;
    box.text.declarations.push_back({Form::included, {}, {}, zed::reference({"Escena", ""}), {}});
    zed::Declaration names{Form::typed, {}, {}, zed::reference({"Elemento", ""}), {}};
    const auto component = [&](const std::string& word) {
      return std::any_of(given.begin(), given.end(), [&](const auto& one) { return one.first.word == word; });
    };
    zed::Given elements;
    for (const model::Elemento& e : escena.elementos) {
      if (!free_word(typing, e.name()) || component(e.name())) continue;
      names.names.push_back({e.name(), ""});
      names.places.push_back({});
      elements.emplace_back(zed::Name{e.name(), ""}, oracle::spec::value(e));
    }
    if (!names.names.empty()) box.text.declarations.push_back(std::move(names));
    given.insert(given.end(), elements.begin(), elements.end());
    specification.sections.back().paragraphs.push_back({{}, std::move(box)});
  }
};

bool is_latex(const std::string& text) { return std::regex_search(text, std::regex(R"(\\[A-Za-z_{}#&%])")); }

// In LaTeX a subscript or a name's underscore is \_; a term in Unicode has none.
zed::Term parsed(const std::string& text, const zed::Specification& specification) {
  try {
    if (!is_latex(text)) return zed::parse_unicode(text);
    zed::Markup markup;
    for (const auto& one : specification.markup) markup.insert(one.second.begin(), one.second.end());
    return zed::parse_latex(text, markup);
  } catch (const zed::ZError& error) {
    throw io::InputError(file_name, {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  }
}

// The term stands for a predicate where no type is known for it.
bool is_predicate(const zed::Typing& typing, const zed::Term& term) { return !typing.type_of(term); }

// [ S ]: of a connective of schemas, whose components are not in scope, the schema.
zed::Term schema_of(const zed::Term& term) {
  zed::SchemaText text;
  text.declarations.push_back({zed::Declaration::Form::included, {}, {}, term, term->place});
  return zed::quantified(zed::Kind::schema_text, std::move(text), {}, term->place);
}

[[noreturn]] void undecided(const std::string& why) {
  throw io::InputError(file_name, {1, 1}, "this is not decided: " + why,
                       "expected finite sets, or equations, for what is quantified");
}

constexpr const char* open_variable =
    "a variable ranges over a set that is not finite, and no equation gives its value";

int print(const std::string& text, bool yes) {
  io::write_file("-", text + "\n");
  return yes ? 0 : 1;
}

int evaluated(const zed::Evaluator& evaluator, const zed::Typing& typing, const zed::Term& term) {
  if (!is_predicate(typing, term)) {
    const zed::Value value = evaluator.value(term);
    if (value.is_open()) undecided(open_variable);
    return print(value.text(), !value.is_undefined());
  }
  const zed::Truth truth = evaluator.holds(term);
  if (truth == zed::Truth::open) undecided(open_variable);
  return print(truth == zed::Truth::yes ? "true" : "false", truth == zed::Truth::yes);
}

}  // namespace

int spec_eval(const std::string& expression, const std::string& scene) {
  const Call call(scene);
  zed::Term term = parsed(expression, call.specification);
  zed::Typing typing = zed::check_term(call.typing, section_name, term, {}, file_name);
  if (!typing.ok()) {
    const zed::Term schema = schema_of(term);
    zed::Typing as_schema = zed::check_term(call.typing, section_name, schema, {}, file_name);
    if (as_schema.ok()) {
      term = schema;
      typing = std::move(as_schema);
    }
  }
  if (!typing.ok()) {
    const zed::Defect& first = typing.defects.front();
    throw io::InputError(file_name, {first.place.line, first.place.column}, first.what, first.expected);
  }
  try {
    const zed::Evaluator evaluator(call.specification.sections, call.given);
    return evaluated(evaluator, typing, term);
  } catch (const zed::EvaluationError& error) {
    undecided(error.what());
  }
}

}  // namespace durero::cli
