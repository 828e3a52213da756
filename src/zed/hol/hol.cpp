#include "durero/zed/hol/hol.hpp"

#include <fmt/format.h>

#include "durero/zed/syntax/defect.hpp"
#include "zed/hol/writer.hpp"

namespace durero::zed::hol {
namespace {

bool is_schema(const Type& type) { return type.is_schema_set(); }

Components components_in(const Type& binding) {
  Components all;
  for (std::size_t i = 0; i < binding.fields().size(); ++i)
    all.emplace_back(binding.fields()[i], binding.parts()[i].settled());
  return all;
}

}  // namespace

HolWriter::HolWriter(const Specification& text, const Typing& typing, ProofAssistant prover)
    : text_(text), typing_(typing), dialect_{prover} {}

std::string HolWriter::run(const std::vector<NamedClaim>& claims, const std::string& theory) {
  for (const Section& section : text_.sections)
    for (const Paragraph& each : section.paragraphs) try {
        paragraph(section, each);
      } catch (const ZError& error) {
        throw ExportError(error.in(section.file).text());
      }
  out_ += "\n";
  for (const NamedClaim& claim : claims) try {
      out_ += dialect_.definition(claim.name, {}, dialect_.prover == ProofAssistant::coq ? "Prop" : "bool",
                                  predicate(claim.claim, {}));
    } catch (const ZError& error) {
      throw ExportError(error.in(claim.name).text());
    }
  return dialect_.head(theory) + out_ + dialect_.tail();
}

void HolWriter::paragraph(const Section& section, const Paragraph& paragraph) {
  if (const auto* form = std::get_if<GivenTypes>(&paragraph.form)) return given(*form);
  if (const auto* form = std::get_if<FreeType>(&paragraph.form)) return free_type(*form);
  if (const auto* form = std::get_if<Definition>(&paragraph.form)) return definition(section, *form);
  if (const auto* form = std::get_if<Schema>(&paragraph.form)) return schema(section, *form);
  if (const auto* form = std::get_if<Axiomatic>(&paragraph.form)) return axiomatic(section, *form);
}

const Type& HolWriter::type_of(const Section& section, const Name& name) const {
  const Global* global = typing_.find(section.name, name);
  if (!global || !global->scheme.formals.empty()) not_covered({}, "the generic name " + name.text());
  return global->scheme.type;
}

void HolWriter::given(const GivenTypes& form) {
  for (const Name& name : form.names) {
    globals_[name.text()] = word(name, {});
    given_.insert(name.text());
    words_.insert(word(name, {}));
    out_ += dialect_.given(word(name, {}));
  }
}

/// Whether the set has all values of its type: only of such sets is the type of a constructor that of Z.
bool HolWriter::is_whole(const Term& set) const {
  if (set->kind == Kind::reference) return given_.contains(set->name.text());
  if (set->kind != Kind::power && set->kind != Kind::product) return false;
  for (const Term& child : set->children)
    if (!is_whole(child)) return false;
  return true;
}

void HolWriter::free_type(const FreeType& form) {
  const std::string name = word(form.name, {});
  globals_[form.name.text()] = name;
  given_.insert(form.name.text());
  words_.insert(name);
  Binders branches;
  for (const Branch& branch : form.branches) {
    std::string argument;
    if (branch.argument) {
      if (!is_whole(branch.argument)) not_covered(branch.place, "a constructor for members of a smaller set");
      const auto of = typing_.type_of(branch.argument);
      if (!of) not_covered(branch.place, "this constructor");
      argument = type(of->settled().parts()[0], branch.place);
      constructors_.insert(branch.name.text());
    }
    globals_[branch.name.text()] = word(branch.name, branch.place);
    words_.insert(word(branch.name, branch.place));
    branches.emplace_back(word(branch.name, branch.place), argument);
  }
  out_ += dialect_.free_type(name, branches);
}

void HolWriter::define_schema(const Name& name, const Type& binding, const Term& body) {
  const std::string text = word(name, body->place);
  words_.insert(text);
  const Components components = components_in(binding);
  Written scope;
  Binders arguments;
  for (const auto& [component, of] : components) {
    const std::string v = variable(component, scope, body->place);
    scope[component] = v;
    arguments.emplace_back(v, type(of, body->place));
  }
  out_ += dialect_.definition(text, arguments, dialect_.prover == ProofAssistant::coq ? "Prop" : "bool",
                              predicate(body, scope));
  globals_[name.text()] = text;
  schemas_[name.text()] = components;
}

void HolWriter::schema(const Section& section, const Schema& form) {
  if (!form.formals.empty()) not_covered({}, "the generic schema " + form.name.text());
  define_schema(form.name, type_of(section, form.name).parts()[0].settled(),
                zed::quantified(Kind::schema_text, form.text, {}));
}

void HolWriter::definition(const Section& section, const Definition& form) {
  if (!form.formals.empty()) not_covered(form.value->place, "a generic definition");
  const Type& type = type_of(section, form.name);
  if (is_schema(type)) return define_schema(form.name, type.parts()[0].settled(), form.value);
  Applied applied;
  const std::string value = term(form.value, {}, applied), name = word(form.name, form.value->place);
  if (!applied.empty()) not_covered(form.value->place, "an application in a definition");
  out_ += dialect_.definition(name, {}, this->type(type.settled(), form.value->place), value);
  globals_[form.name.text()] = name;
  words_.insert(name);
}

void HolWriter::axiomatic(const Section& section, const Axiomatic& form) {
  if (!form.formals.empty()) not_covered({}, "a generic box");
  std::vector<std::string> facts;
  for (const Declaration& declaration : form.text.declarations) {
    if (declaration.form != Declaration::Form::typed) not_covered(declaration.place, "this declaration");
    for (const Name& name : declaration.names) {
      const std::string text = word(name, declaration.place);
      out_ += dialect_.constant(text, type(type_of(section, name).settled(), declaration.place));
      globals_[name.text()] = text;
      words_.insert(text);
      Applied applied;
      const std::string set = term(declaration.term, {}, applied);
      facts.push_back(with(applied, fmt::format("(z_in {} {})", text, set)));
    }
  }
  for (const Predicate& each : form.text.predicates) facts.push_back(predicate(each.term, {}));
  for (const std::string& fact : facts) out_ += dialect_.axiom("fact_" + std::to_string(++axioms_), fact);
}

}  // namespace durero::zed::hol

namespace durero::zed {

std::string to_hol(const Specification& text, const Typing& typing, const std::vector<NamedClaim>& claims,
                   ProofAssistant prover, const std::string& name) {
  return hol::HolWriter(text, typing, prover).run(claims, name);
}

}  // namespace durero::zed
