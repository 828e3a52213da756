#include "durero/zed/types/typecheck.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "zed/syntax/characters.hpp"
#include "zed/syntax/symbols.hpp"
#include "zed/types/checker.hpp"

namespace durero::zed {
namespace {

/// Checks the paragraphs of one section.
class SectionChecker {
 public:
  SectionChecker(const Section& section, Typing& into)
      : section_(section),
        into_(into),
        globals_(into.scopes[section.name]),
        terms_(section.file, globals_, into.toolkit[section.name], into) {}

  void run() {
    try {
      paragraphs();
    } catch (const ZError& error) {  // a limit is reached
      into_.defects.push_back(error.in(section_.file));
    }
  }

 private:
  void paragraphs() {
    for (const Name& name : section_.lost) declare(name, {{}, Type::unknown()}, Global::Form::lost, section_.place);
    for (std::size_t i = 0; i < section_.paragraphs.size(); ++i) {
      const Paragraph& here = section_.paragraphs[i];
      if (std::holds_alternative<FreeType>(here.form)) {
        i = free_types(i);
      } else {
        std::visit([this, &here](const auto& form) { paragraph(form, here.place); }, here.form);
      }
      terms_.solve();
      terms_.finish_paragraph();
    }
  }

  void declare(const Name& name, Scheme scheme, Global::Form form, Place place) {
    if (name.empty()) return;
    terms_.solve();
    const auto entry = globals_.find(name);
    const bool known = entry != globals_.end() && entry->second->form != Global::Form::lost;
    if (known || toolkit_scheme(name, into_.toolkit[section_.name])) {
      const std::string where =
          known ? fmt::format("{}:{}", entry->second->file, entry->second->place.line) : "the toolkit";
      terms_.error(place, fmt::format("{} is declared already, in {}", name.text(), where), "expected a new name");
      return;
    }
    scheme.type = scheme.type.settled();
    globals_[name] =
        std::make_shared<const Global>(Global{name, std::move(scheme), form, section_.name, section_.file, place});
  }

  void paragraph(const GivenTypes& given, Place place) {
    for (std::size_t i = 0; i < given.names.size(); ++i)
      declare(given.names[i], {{}, Type::power(Type::given(given.names[i]))}, Global::Form::given,
              i < given.places.size() ? given.places[i] : place);
  }

  void paragraph(const FreeType&, Place) {}  // free_types() checks these

  /// Checks the free types from paragraph `first` on that are joined by &, and returns the last of them.
  std::size_t free_types(std::size_t first) {
    std::size_t last = first;
    const auto type_at = [this](std::size_t i) { return std::get_if<FreeType>(&section_.paragraphs[i].form); };
    while (last + 1 < section_.paragraphs.size() && type_at(last + 1) && type_at(last + 1)->joined) ++last;
    for (std::size_t i = first; i <= last; ++i)
      declare(type_at(i)->name, {{}, Type::power(Type::given(type_at(i)->name))}, Global::Form::free_type,
              section_.paragraphs[i].place);
    for (std::size_t i = first; i <= last; ++i)
      for (const Branch& branch : type_at(i)->branches) constructor(*type_at(i), branch);
    return last;
  }

  void constructor(const FreeType& of, const Branch& branch) {
    Type type = Type::given(of.name);
    if (branch.argument) {
      Type set = Type::unknown();
      terms_.in_passes([&] { set = terms_.expression(branch.argument); });
      if (!set.is(Type::Kind::power) && !set.is(Type::Kind::unknown))
        terms_.error(branch.argument->place,
                     fmt::format("an expression of type {} stands as the argument of a constructor", set.text()),
                     "expected a set");
      const Type argument = set.is(Type::Kind::power) ? set.parts()[0] : Type::unknown();
      type = Type::power(Type::product({argument, type}));
    }
    declare(branch.name, {{}, std::move(type)}, Global::Form::branch, branch.place);
  }

  void formals(const std::vector<Name>& names, Place place) {
    Fields fields;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
          names.begin() + static_cast<std::ptrdiff_t>(i))
        terms_.error(place, names[i].text() + " is a generic formal twice", "expected distinct formals");
    for (const Name& name : names) fields.emplace_back(name, Type::power(Type::formal(name)));
    terms_.push(std::move(fields));
  }

  void paragraph(const Definition& definition, Place place) {
    formals(definition.formals, place);
    Type type = Type::unknown();
    terms_.in_passes([&] { type = terms_.expression(definition.value); });
    terms_.pop();
    declare(definition.name, {definition.formals, std::move(type)}, Global::Form::definition, place);
  }

  /// Checks the declarations and predicates of a box with its formals in scope, and returns what it declares.
  Fields signature_of_box(const std::vector<Name>& generic_formals, const SchemaText& text, Place place) {
    formals(generic_formals, place);
    Fields fields;
    terms_.in_passes([&] {
      terms_.push(terms_.signature(text));
      terms_.predicates(text);
      fields = terms_.pop().fields;
    });
    terms_.pop();
    return fields;
  }

  void paragraph(const Axiomatic& box, Place place) {
    for (const auto& [name, type] : signature_of_box(box.formals, box.text, place))
      declare(name, {box.formals, type}, Global::Form::axiom, place_of(name, box.text));
  }

  static Place place_of(const Name& name, const SchemaText& text) {
    for (const Declaration& declaration : text.declarations)
      for (std::size_t i = 0; i < declaration.names.size() && i < declaration.places.size(); ++i)
        if (declaration.names[i] == name) return declaration.places[i];
    return text.declarations.empty() ? Place() : text.declarations[0].place;
  }

  void paragraph(const Schema& box, Place place) {
    declare(box.name, {box.formals, Type::power(Type::schema(signature_of_box(box.formals, box.text, place)))},
            Global::Form::schema, place);
  }

  void paragraph(const Conjecture& conjecture, Place place) {
    formals(conjecture.formals, place);
    terms_.in_passes([&] { terms_.predicate(conjecture.claim.term); });
    terms_.pop();
  }

  const Section& section_;
  Typing& into_;
  Checker::Globals& globals_;
  Checker terms_;
};

Defect declared_twice(const Section& section, const Name& name, std::string_view one, std::string_view other) {
  return {section.file, section.place,
          fmt::format("the parents declare {} twice, in {} and {}", name.text(), one, other),
          "expected one declaration of it", Defect::Severity::error};
}

/// A section sees, when it begins, all that its parents see at their end.
void inherit(const Section& section, Typing& into) {
  auto& mine = into.scopes[section.name];
  ToolkitSections& toolkit_seen = into.toolkit[section.name];
  for (const std::string& parent : section.parents) {
    if (const auto given = ToolkitSections::of(parent)) toolkit_seen |= *given;
    const auto theirs = into.scopes.find(parent);
    if (theirs == into.scopes.end() || parent == section.name) continue;
    toolkit_seen |= into.toolkit[parent];
    for (const auto& [name, global] : theirs->second) {
      const auto [at, added] = mine.emplace(name, global);
      if (!added && at->second != global)
        into.defects.push_back(declared_twice(section, name, at->second->section, global->section));
    }
  }
}

/// Refuses a name that one parent declares, where another one gives a section of the toolkit that declares it too.
void refuse_names_of_toolkit(const Section& section, Typing& into) {
  const ToolkitSections seen = into.toolkit[section.name];
  const bool all_alike = std::ranges::all_of(section.parents, [&](const std::string& parent) {
    return !into.scopes.contains(parent) || into.toolkit[parent] == seen;
  });
  if (all_alike) return;  // each parent refused such names itself
  for (const auto& [name, global] : into.scopes[section.name])
    if (toolkit_scheme(name, seen))
      into.defects.push_back(declared_twice(section, name, global->section, name_of(toolkit().at(name).section)));
}

/// Checks a term as a predicate, where its form is that of one, or as an expression.
void check_by_form(Checker& checker, const Term& term) {
  const Node* form = term.get();
  while (form->kind == Kind::let) form = form->children[0].get();  // a let is what its body is
  switch (form->kind) {
    case Kind::truth:
    case Kind::falsity:
    case Kind::relation:
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
      checker.predicate(term);
      break;
    default:
      checker.expression(term);
  }
}

/// Checks a term that stands alone.
void check_at_end(Checker& checker, const Term& term) {
  checker.in_passes([&] { check_by_form(checker, term); });
  checker.finish_paragraph();
}

}  // namespace

std::optional<Type> Typing::type_of(const Term& term) const {
  const auto entry = types.find(term.get());
  if (entry == types.end()) return std::nullopt;
  return entry->second;
}

const Global* Typing::find(const std::string& section, const Name& name) const {
  const auto scope = scopes.find(section);
  if (scope == scopes.end()) return nullptr;
  const auto entry = scope->second.find(name);
  return entry == scope->second.end() ? nullptr : entry->second.get();
}

Typing check(const Specification& specification) {
  Typing typing;
  for (const Section& section : specification.sections) {
    const auto first = static_cast<std::ptrdiff_t>(typing.defects.size());
    inherit(section, typing);
    refuse_names_of_toolkit(section, typing);
    SectionChecker(section, typing).run();
    std::stable_sort(typing.defects.begin() + first, typing.defects.end(), [](const Defect& a, const Defect& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
  }
  return typing;
}

std::vector<std::pair<Name, Type>> calculator_names() {
  std::vector<std::pair<Name, Type>> names;
  for (const auto& [name, scheme] : calculator()) names.emplace_back(name, scheme.type);
  return names;
}

bool is_free_word(const std::string& word) {
  const auto continues = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  return !word.empty() && is_letter(word[0]) && std::all_of(word.begin(), word.end(), continues) && may_be_name(word) &&
         !toolkit().contains({word, {}});
}

Typing check_term(const Typing& known, const std::string& section, const Term& term,
                  const std::vector<std::pair<Name, Type>>& locals, const std::string& file) {
  Typing typing;
  const auto scope = known.scopes.find(section);
  const auto toolkit_seen = known.toolkit.find(section);
  Checker::Globals globals = scope == known.scopes.end() ? Checker::Globals() : scope->second;
  Checker checker(file, globals, toolkit_seen == known.toolkit.end() ? ToolkitSections::all() : toolkit_seen->second,
                  typing);
  checker.push(locals);
  checker.take_alone();
  try {
    check_at_end(checker, term);
  } catch (const ZError& error) {  // a limit is reached
    typing.defects.push_back(error.in(file));
  }
  return typing;
}

}  // namespace durero::zed
