#include <fmt/format.h>

#include <algorithm>

#include "durero/zed/syntax/defect.hpp"
#include "zed/coq/writer.hpp"

namespace durero::zed::coq {
namespace {

bool is_plain(const Schema& form) {
  return std::all_of(form.text.declarations.begin(), form.text.declarations.end(), [](const Declaration& declaration) {
    return declaration.form == Declaration::Form::typed &&
           std::all_of(declaration.names.begin(), declaration.names.end(),
                       [](const Name& name) { return name.strokes.empty(); });
  });
}

/// x : T says nothing beyond the type of x where T is the name of a whole type.
bool says_nothing(const Term& set, const Translator& in) { return set->kind == Kind::reference && in.whole(set); }

}  // namespace

void CoqWriter::record(const std::string& head, const Fields& fields) {
  sentence("Record " + head + " {");
  for (std::size_t i = 0; i < fields.size(); ++i)
    sentence(fields[i].first + (i + 1 == fields.size() ? "" : ";"), fields[i].second, "  ");
  out_ += "}.\n";
}

void CoqWriter::schema(const Schema& form) {
  if (!form.formals.empty()) uncovered(form.text.declarations.at(0).place, "a generic schema");
  is_plain(form) ? data(form) : operation(form);
}

/// Adds a field for each declaration x : S that says more than the type of x, and one for each predicate.
void CoqWriter::conditions(const std::string& name, const SchemaText& text, const CoqScope& scope, Fields& to) {
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form != Declaration::Form::typed || says_nothing(declaration.term, in_)) continue;
    for (const Name& declared : declaration.names) {
      Expr member = in_.member(scope.names.at(declared), declaration.term, scope);
      to.emplace_back(fmt::format("{}_decl_{} : {}", name, declared.word, member.text), "");
    }
  }
  std::size_t unlabelled = 0;
  for (const Predicate& predicate : text.predicates) {
    const std::string field =
        predicate.label.empty() ? fmt::format("{}_pred_{}", name, ++unlabelled) : identifier(predicate.label);
    to.emplace_back(field + " : " + in_.predicate(predicate.term, scope).text, predicate.label);
  }
}

void CoqWriter::data(const Schema& form) {
  const std::string name = variable(form.name);
  const bool is_state = name == in_.state;
  CoqScope unused;
  CoqSymbol symbol;
  symbol.form = CoqSymbol::Form::carrier;
  symbol.type = Carrier::named(name);
  symbol.signature = in_.declare(form.text, unused);
  Fields parts;
  for (Slot& slot : symbol.signature) {
    slot.variable = (is_state ? "" : name + "_") + slot.name.word;
    parts.emplace_back(slot.variable + " : " + slot.type.text(), "");
  }
  record(fmt::format("{0} := mk_{0}", name), parts);
  in_.symbols[form.name] = symbol;
  CoqScope scope;
  in_.declare(Slot{form.name, "s", symbol.type, true, {}}, scope);
  Fields asked;
  conditions(name, form.text, scope, asked);
  if (!asked.empty()) {
    out_ += "\n";
    record(fmt::format("{0}_ok (s : {0}) : Prop :=", name), asked);
    in_.symbols[form.name].ok = name + "_ok";
  }
  if (is_state) state_relations(name, form);
}

void CoqWriter::state_relations(const std::string& name, const Schema& form) {
  Fields equal;
  for (const Declaration& declaration : form.text.declarations)
    for (const Name& part : declaration.names) {
      const bool sets = in_.carrier(declaration.term).form == Carrier::Form::set;
      equal.emplace_back(fmt::format("{0}_eq_{1} : {1} s' {2} {1} s", name, part.word, sets ? "≡" : "="), "");
    }
  out_ += "\n";
  record(fmt::format("{0}_eq (s s' : {0}) : Prop :=", name), equal);
  out_ += "\n";
  record(
      fmt::format("Delta_{0} (s s' : {0}) : Prop :=", name),
      {{fmt::format("Delta_{0}_before : {0}_ok s", name), ""}, {fmt::format("Delta_{0}_after : {0}_ok s'", name), ""}});
  out_ += "\n";
  record(fmt::format("Xi_{0} (s s' : {0}) : Prop :=", name), {{fmt::format("Xi_{0}_Delta : Delta_{0} s s'", name), ""},
                                                              {fmt::format("Xi_{0}_eq : {0}_eq s s'", name), ""}});
}

void CoqWriter::operation(const Schema& form) {
  const std::string name = variable(form.name);
  CoqScope scope;
  CoqSymbol symbol;
  symbol.form = CoqSymbol::Form::operation;
  symbol.text = name;
  symbol.signature = in_.declare(form.text, scope);
  Fields fields;
  for (const Declaration& declaration : form.text.declarations) {
    if (declaration.form != Declaration::Form::included) continue;
    const Name included = schema_name(declaration.term).value();
    const std::string field = included.word == "Δ" + in_.state   ? "Delta"
                              : included.word == "Ξ" + in_.state ? "Xi"
                                                                 : included.word;
    fields.emplace_back(fmt::format("{}_{} : {}", name, field, in_.call(included, scope, declaration.place).text), "");
  }
  conditions(name, form.text, scope, fields);
  record(fmt::format("{} {} : Prop :=", name, binders(symbol.signature, false)), fields);
  in_.symbols[form.name] = symbol;
}

}  // namespace durero::zed::coq
