/// The parts of a refinement are found by the names and types of a text's schemas.
#include "durero/spec/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "durero/spec/animation.hpp"
#include "durero/text/nearest.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "durero/zed/syntax/parser.hpp"

namespace durero::spec {
namespace {

using zed::Name;
using zed::Type;

/// The types of the bindings of a text's schemas, by their names; generic ones are left out.
using SchemaTypes = std::map<std::string, Type>;

SchemaTypes schema_types(const zed::Specification& text, const zed::Typing& typing) {
  SchemaTypes types;
  for (const zed::Section& section : text.sections)
    for (const zed::Paragraph& paragraph : section.paragraphs)
      for (const Name& name : zed::names_of(paragraph)) {
        const zed::Global* global = typing.find(section.name, name);
        if (global && global->scheme.formals.empty() && global->scheme.type.is_schema_set())
          types.emplace(name.text(), global->scheme.type.parts()[0].settled());
      }
  return types;
}

std::string name_texts(const std::vector<Name>& names) {
  std::string said;
  for (const Name& name : names) said += (said.empty() ? "" : ", ") + name.text();
  return said.empty() ? "none" : said;
}

Name after_name(const Name& name) { return {name.word, name.strokes + "'"}; }

class RefinementFinder {
 public:
  RefinementFinder(const zed::Specification& text, const zed::Typing& typing, const RefinementCall& call)
      : call_(call), types_(schema_types(text, typing)) {
    found_.abstract = call.abstract;
    found_.concrete = call.concrete;
    found_.retrieve = call.retrieve;
    found_.backward = call.backward;
    for (const std::string& name : {call.abstract, call.concrete, call.retrieve}) type_of(name);
    check_states();
    add_initial(text);
    Operations abstract = operations_on(text, call.abstract), concrete = operations_on(text, call.concrete);
    std::erase_if(abstract, [&](const auto& each) { return concrete.erase(each.first) > 0; });  // they are on both
    add_pairs(abstract, concrete);
  }
  Refinement take() { return std::move(found_); }

 private:
  const Type& type_of(const std::string& schema) const {
    const auto at = types_.find(schema);
    if (at != types_.end()) return at->second;
    std::vector<std::string> names;
    for (const auto& [name, type] : types_) names.push_back(name);
    throw RefinementError(fmt::format("the text has no schema {}; expected {}", schema,
                                      text::nearest(schema, names).value_or("one of its schemas without formals")));
  }
  const std::vector<Name>& fields_of(const std::string& schema) const { return type_of(schema).fields(); }

  void check_states() const {
    const auto &a = fields_of(found_.abstract), &c = fields_of(found_.concrete), &r = fields_of(found_.retrieve);
    std::vector<Name> both, shared;
    std::set_union(a.begin(), a.end(), c.begin(), c.end(), std::back_inserter(both));
    std::set_intersection(a.begin(), a.end(), c.begin(), c.end(), std::back_inserter(shared));
    if (!shared.empty())
      throw RefinementError(fmt::format("{} and {} share {}; expected states without a common component",
                                        found_.abstract, found_.concrete, name_texts(shared)));
    if (both != r)
      throw RefinementError(fmt::format("{} has the components {}; expected those of {} and {}, and no others",
                                        found_.retrieve, name_texts(r), found_.abstract, found_.concrete));
  }

  using Operations = std::map<std::string, MachineOperation>;

  /// Δ and Ξ of a state that the text defines itself are no operations.
  static Operations operations_on(const zed::Specification& text, const std::string& state) {
    Setup setup;
    setup.state = state;
    const Machine machine(text, setup);
    Operations operations;
    for (const MachineOperation& each : machine.operations())
      if (!each.name.starts_with("Δ") && !each.name.starts_with("Ξ")) operations.emplace(each.name, each);
    return operations;
  }

  std::string initial_of(const zed::Specification& text, const std::string& state, bool concrete) const {
    Setup setup;
    setup.state = state;
    for (const auto& [a, c] : call_.pairs)
      if (begins(concrete ? c : a, state)) return concrete ? c : a;
    const std::string init = Machine(text, setup).init();
    if (init.empty())
      throw RefinementError(
          fmt::format("{} has no initial schema; expected Init{}, or --pair AINIT=CINIT", state, state));
    return init;
  }

  /// Whether the schema has the components of the state, or of the state after, and nothing else.
  bool begins(const std::string& schema, const std::string& state) const {
    const auto& of_state = fields_of(state);
    std::vector<Name> after;
    for (const Name& name : of_state) after.push_back(after_name(name));
    const auto& fields = fields_of(schema);
    return schema != state && (fields == of_state || fields == after);
  }

  void add_initial(const zed::Specification& text) {
    found_.abstract_init = initial_of(text, found_.abstract, false);
    found_.concrete_init = initial_of(text, found_.concrete, true);
    for (const auto& [schema, state] :
         {std::pair{found_.abstract_init, found_.abstract}, std::pair{found_.concrete_init, found_.concrete}})
      if (!begins(schema, state))
        throw RefinementError(
            fmt::format("{} has the components {}; expected an initial schema of those of {}, or of {} ′", schema,
                        name_texts(fields_of(schema)), state, state));
    found_.abstract_primed = fields_of(found_.abstract_init) != fields_of(found_.abstract);
    found_.concrete_primed = fields_of(found_.concrete_init) != fields_of(found_.concrete);
  }

  void add_pairs(const Operations& abstract, const Operations& concrete) {
    std::map<std::string, std::string> chosen;
    for (const auto& [a, c] : call_.pairs) {
      if (begins(a, found_.abstract)) continue;
      require_operation(a, abstract, found_.abstract);
      require_operation(c, concrete, found_.concrete);
      if (!chosen.emplace(a, c).second) throw RefinementError("two partners of " + a + "; expected one");
    }
    Operations free = concrete;  // without the partners that the call chooses
    for (const auto& [a, c] : chosen) free.erase(c);
    std::set<std::string> partners;
    for (const auto& [name, operation] : abstract) {
      const auto at = chosen.find(name);
      const std::string partner = at != chosen.end() ? at->second : partner_of(name, abstract, free);
      if (partner.empty()) {
        found_.alone.push_back(name);
        continue;
      }
      if (!partners.insert(partner).second)
        throw RefinementError(fmt::format("{} is the partner of two operations; expected --pair for one", partner));
      add_pair(operation, concrete.at(partner));
    }
    for (const auto& [name, operation] : concrete)
      if (!partners.contains(name)) found_.alone.push_back(name);
    if (found_.operations.empty())
      throw RefinementError(
          fmt::format("no operation of {} has a partner of {}; expected names such as Op and Op1, or "
                      "--pair AOP=COP",
                      found_.abstract, found_.concrete));
  }

  void require_operation(const std::string& name, const Operations& operations, const std::string& state) const {
    type_of(name);
    if (!operations.contains(name))
      throw RefinementError(fmt::format("{} is no operation on {}; expected the components of {} and of {} ′", name,
                                        state, state, state));
  }

  /// The name that the concrete state's name tells: what it has before and behind the abstract one's.
  std::string told_name(const std::string& operation) const {
    const std::size_t at = found_.concrete.find(found_.abstract);
    if (at == std::string::npos) return {};
    return found_.concrete.substr(0, at) + operation + found_.concrete.substr(at + found_.abstract.size());
  }

  static bool is_named_after(const std::string& name, const std::string& operation) {
    return name.starts_with(operation) || name.ends_with(operation);
  }

  /// Of several abstract operations that could have it as partner, the one of the longest name has.
  static std::string partner_by_name(const std::string& operation, const Operations& abstract,
                                     const Operations& concrete) {
    std::vector<std::string> all;
    for (const auto& [name, each] : concrete) {
      const bool of_longer = std::any_of(abstract.begin(), abstract.end(), [&, &c = name](const auto& other) {
        return other.first.size() > operation.size() && is_named_after(c, other.first);
      });
      if (is_named_after(name, operation) && !of_longer && !abstract.contains(name)) all.push_back(name);
    }
    return all.size() == 1 ? all.front() : "";
  }

  std::string partner_of(const std::string& name, const Operations& abstract, const Operations& concrete) const {
    const std::string told = told_name(name);
    return concrete.contains(told) ? told : partner_by_name(name, abstract, concrete);
  }

  void add_pair(const MachineOperation& a, const MachineOperation& c) {
    OperationPair pair{a.name, c.name, {}, a.outputs};
    const Type &of_a = type_of(a.name), &of_c = type_of(c.name);
    const auto compare = [&](const char* what, const std::vector<Name>& x, const std::vector<Name>& y) {
      if (x != y)
        throw RefinementError(
            fmt::format("{} of {}: {}; expected those of {}: {}", what, c.name, name_texts(y), a.name, name_texts(x)));
      for (const Name& name : x)
        if (of_a.field(name)->text(Type::max_size) != of_c.field(name)->text(Type::max_size))
          throw RefinementError(fmt::format("{} of {} has the type {}; expected {}, as in {}", name.text(), c.name,
                                            of_c.field(name)->text(), of_a.field(name)->text(), a.name));
    };
    compare("the inputs", a.inputs, c.inputs);
    compare("the outputs", a.outputs, c.outputs);
    for (const Name& name : a.inputs)
      pair.inputs.emplace_back(name, zed::parse_unicode(of_a.field(name)->text(Type::max_size)));
    found_.operations.push_back(std::move(pair));
  }

  const RefinementCall& call_;
  SchemaTypes types_;
  Refinement found_;
};

}  // namespace

Refinement refinement_of(const zed::Specification& text, const zed::Typing& typing, const RefinementCall& call) {
  return RefinementFinder(text, typing, call).take();
}

}  // namespace durero::spec
