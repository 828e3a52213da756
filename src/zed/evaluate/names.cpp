/// Compiles names: those in scope, what paragraphs declare, and the toolkit's.

#include "zed/evaluate/compiler.hpp"
#include "zed/operators.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {

const Local* Compiler::find(const Name& name, const Scope& scope) const {
  for (const Scope* here = &scope; here; here = here->outer) {
    const auto entry = here->names.find(name);
    if (entry != here->names.end()) return &entry->second;
  }
  return nullptr;
}

Code Compiler::name(const Node& node, const Scope& scope) {
  if (const Local* local = find(node.name, scope)) {
    if (!local->slot) {
      reads_.insert(reads_.end(), local->reads.begin(), local->reads.end());
      return local->code;
    }
    reads_.push_back(*local->slot);
    return Code::of_slot(*local->slot);
  }
  Meaning* global = definitions_.find(node.name);
  if (!global) {
    if (components(reference(node.name), definitions_)) return schema_set(reference(node.name, {}, node.place), scope);
    return toolkit(node, scope);
  }
  if (!node.children.empty()) {
    if (std::holds_alternative<Schema>(global->paragraph->form))
      return schema_set(reference(node.name, node.children, node.place), scope);
    if (const auto* box = std::get_if<Axiomatic>(&global->paragraph->form); box && !box->formals.empty())
      return instance_with(node, *global, scope);
    const auto* definition = std::get_if<Definition>(&global->paragraph->form);
    if (!definition || definition->formals.empty()) cannot(node, node.name.text() + " is not evaluated with actuals");
    const Scope inner = formals(definition->formals, node.children, scope);
    return expression(definition->value, inner);
  }
  return [this, global](Frame& frame) { return global->value ? *global->value : this->global(*global, frame.context); };
}

/// A generic box with actuals that name nothing local is evaluated once.
Code Compiler::instance_with(const Node& node, const Meaning& global, const Scope& scope) {
  const std::size_t before = reads_.size();
  for (const Term& actual : node.children) expression(actual, scope);
  if (reads_.size() != before)
    cannot(node, node.name.text() + " is not evaluated with actuals that depend on variables");
  return Code::once([this, &global, actuals = node.children](
                        Frame& frame) { return generic_instance(global, actuals, frame.context); },
                    constants_.emplace_back());
}

Scope Compiler::formals(const std::vector<Name>& formals, const std::vector<Term>& actuals, const Scope& scope) {
  Scope inner{.unit = scope.unit};
  for (std::size_t i = 0; i < formals.size(); ++i) {
    Local local;
    if (i < actuals.size()) {
      const std::size_t before = reads_.size();
      local.code = expression(actuals[i], scope);
      local.reads.assign(reads_.begin() + static_cast<std::ptrdiff_t>(before), reads_.end());
    } else {  // actuals that are left out are inferred; their set is the whole type
      local.code = [whole = everything(formals[i].text())](Frame&) { return whole; };
    }
    inner.names.emplace(formals[i], std::move(local));
  }
  return inner;
}

Code Compiler::toolkit(const Node& node, const Scope& scope) {
  const OperatorRow* row = operator_row(node.name.text());
  if (!row) cannot(node, "the evaluator knows no " + node.name.text());
  const Evaluation& by = row->evaluation;
  const auto constant = [](Value value) { return [value = std::move(value)](Frame&) { return value; }; };
  if (row->binding.role == Role::generic) return set_expression(node, *row, scope);
  if (by.constant) return constant(by.constant());
  if (by.is_function()) return constant(toolkit_function(*row));
  if (by.property || by.relation) return constant(toolkit_relation(*row));
  cannot(node, "the evaluator knows no " + node.name.text());
}

/// Compiles a generic operator with its actuals: `𝔽 S`, `A ⇸ B`.
Code Compiler::set_expression(const Node& node, const OperatorRow& row, const Scope& scope) {
  if (row.arrow && node.children.size() == 2)
    return [from = expression(node.children[0], scope), to = expression(node.children[1], scope), &row](Frame& frame) {
      const Value left = from(frame);
      return function_set(left, to(frame), *row.arrow, row.symbol());
    };
  if (!row.evaluation.unary || node.children.size() != 1) cannot(node, "the evaluator knows no " + node.name.text());
  return [set = expression(node.children[0], scope), make = row.evaluation.unary](Frame& frame) {
    return make(set(frame), frame.context);
  };
}

}  // namespace durero::zed
