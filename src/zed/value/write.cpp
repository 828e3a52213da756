/// Writes values in Z notation.

#include <algorithm>

#include "durero/zed/value/value.hpp"

namespace durero::zed {
namespace {

bool all_pairs(const std::vector<Value>& values) {
  return std::all_of(values.begin(), values.end(), [](const Value& value) {
    const auto* tuple = value.tuple();
    return tuple && tuple->parts.size() == 2;
  });
}

/// Writes a value of a type, or of one that is not known where that is null. A set of pairs is written as a
/// function, and as a sequence where it was made as one.
struct ValueWriter {
  const Value::Spelling& spelling;
  const Type* type = nullptr;

  std::string operator()(const Undefined&) const { return "undefined"; }
  std::string operator()(const Open&) const { return "open"; }
  std::string operator()(const Unknown&) const { return "unknown"; }
  std::string operator()(const PolynomialPtr&) const { return "unknown"; }
  std::string operator()(const Real& real) const { return real.text(); }
  std::string operator()(const Atom& atom) const { return spelling(*atom); }
  std::string operator()(const TuplePtr& tuple) const { return "(" + listed(tuple->parts, Type::Kind::product) + ")"; }
  std::string operator()(const BindingPtr& binding) const {
    std::string components;
    for (std::size_t i = 0; i < binding->values.size(); ++i)
      components += (i > 0 ? ", " : "") + (*binding->names)[i].text() +
                    " == " + write(binding->values[i], part(type, Type::Kind::schema, i));
    return "⦉" + components + "⦊";
  }
  /// The constructor says the type of its argument to whoever reads it.
  std::string operator()(const ConstructedPtr& value) const {
    const std::string argument = write(value->argument, nullptr);
    const bool pair = value->argument.tuple() && argument.starts_with("(");
    return spelling(*value->constructor) + (pair ? argument : "(" + argument + ")");
  }
  std::string operator()(const SetPtr& set) const {
    const std::vector<Value>* members = set->members();
    if (!members) return set->spelled(Set::Wording::closed);
    if (set->is_sequence()) return "⟨" + items(*members) + "⟩";
    if (members->empty()) return empty();
    return "{" + (all_pairs(*members) ? maplets(*members) : listed(*members, Type::Kind::power)) + "}";
  }

  std::string write(const Value& value, const Type* of) const {
    return std::visit(ValueWriter{spelling, of}, value.form());
  }

  /// Returns part i of a type of this kind, which is in step with part i of a value of it; null where the type is not
  /// known.
  static const Type* part(const Type* whole, Type::Kind kind, std::size_t i) {
    return whole && whole->is(kind) ? &whole->parts()[i] : nullptr;
  }

  std::string empty() const {
    const Type* member = part(type, Type::Kind::power, 0);
    return member && member->is_known() ? "∅[" + member->text(Type::max_size) + "]" : "∅";
  }

  /// The parts of a tuple have a type each; the members of a set have one in common.
  template <class Parts>
  std::string listed(const Parts& values, Type::Kind kind) const {
    std::string list;
    for (std::size_t i = 0; i < values.size(); ++i)
      list += (i > 0 ? ", " : "") + write(values[i], part(type, kind, kind == Type::Kind::power ? 0 : i));
    return list;
  }

  std::string items(const std::vector<Value>& pairs) const {
    const Type* item = part(part(type, Type::Kind::power, 0), Type::Kind::product, 1);
    std::string list;
    for (const Value& pair : pairs) list += (list.empty() ? "" : ", ") + write(pair.tuple()->parts[1], item);
    return list;
  }

  std::string maplets(const std::vector<Value>& pairs) const {
    const Type* member = part(type, Type::Kind::power, 0);
    const Type *from = part(member, Type::Kind::product, 0), *to = part(member, Type::Kind::product, 1);
    std::string list;
    for (const Value& pair : pairs)
      list +=
          (list.empty() ? "" : ", ") + write(pair.tuple()->parts[0], from) + " ↦ " + write(pair.tuple()->parts[1], to);
    return list;
  }
};

}  // namespace

std::string Value::text() const {
  const Spelling own_text = [](const AtomName& atom) { return atom.text; };
  return std::visit(ValueWriter{own_text}, form_);
}

std::string Value::text(const Type& type, const Spelling& spelling) const {
  return std::visit(ValueWriter{spelling, &type}, form_);
}

}  // namespace durero::zed
