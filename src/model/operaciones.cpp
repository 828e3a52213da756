#include "durero/model/operaciones.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <type_traits>
#include <utility>

#include "durero/model/operaciones_clauses.hpp"

namespace durero::model {
namespace {

using contract::cost;

static_assert(std::is_nothrow_move_assignable_v<Escena>);

/// Whether an operation has the input of this attribute.
template <class Attribute, class Op>
concept InputOf = std::is_invocable_v<decltype(std::remove_reference_t<Attribute>::input), const Op&>;

/// The inputs of each addition are the attributes that Escena gives its type, and the general
/// addition has them all.
template <class... A>
consteval bool inputs_are_attributes(std::type_identity<std::variant<A...>>) {
  bool agree = true;
  for_each_attribute([&]<class Attribute>(const Attribute& attribute) {
    agree = agree && InputOf<Attribute, Agregar_Elemento> &&
            ((InputOf<Attribute, A> == attribute.types.contains(A::tipo)) && ...);
  });
  return agree;
}
static_assert(inputs_are_attributes(std::type_identity<Addition>()));

// The values that a violation is printed with.

double text(double x) { return x; }
template <class Triple>
std::string text(const Triple& p) {
  return fmt::format("({}, {}, {})", p.x(), p.y(), p.z());
}

std::string text(const Terna& v) { return fmt::format("({}, {}, {})", text(v.a), text(v.b), text(v.c)); }

template <class Op>
std::string values(const Op& in) {
  std::string all = fmt::format("e? = {}, t? = {}", in.e.name(), name(in.t));
  for_each_attribute([&]<class Attribute>(const Attribute& attribute) {
    if constexpr (InputOf<Attribute, Op>) all += fmt::format(", {}? = {}", attribute.word, text(attribute.input(in)));
  });
  return all;
}

std::string values(const Agregar_Elemento& in) {
  return std::visit([](const auto& addition) { return values(addition); }, specific(in));
}

template <class Op>
  requires(!requires(const Op& in) { in.t; })
std::string values(const Op& in) {
  return fmt::format("e? = {}", in.e.name());
}

// The after-state of an operation.

template <class Op>
Escena after_of(const Escena& before, const Op& in) {
  Escena s = before;
  s.elementos.insert(in.e);
  s.tipos.insert(in.t);
  s.de_que_tipo.emplace(in.e, in.t);
  for_each_attribute([&]<class Attribute>(const Attribute& attribute) {
    if constexpr (InputOf<Attribute, Op>) (s.*attribute.component).emplace(in.e, attribute.input(in));
  });
  return s;
}

Escena after_of(const Escena& before, const Agregar_Elemento& in) {
  return std::visit([&](const auto& addition) { return after_of(before, addition); }, specific(in));
}

/// Every removal forgets the name in every component; the types are those that are left.
template <class Op>
  requires(!requires(const Op& in) { in.t; })
Escena after_of(const Escena& before, const Op& in) {
  Escena s = before;
  s.elementos.erase(in.e);
  s.de_que_tipo.erase(in.e);
  for_each_attribute([&](const auto& attribute) { (s.*attribute.component).erase(in.e); });
  s.tipos.clear();
  for (const auto& [e, t] : s.de_que_tipo) s.tipos.insert(t);
  return s;
}

template <class Op>
void check_before(const Escena& before, const Op& in) {
  const auto about = [&] { return values(in); };
  if (contract::evaluated(cost::audit)) check(inv(before), cost::audit, about);
  if (contract::evaluated(cost::normal)) check(pre(before, in), cost::normal, about);
}

template <class Op>
void check_after(const Escena& before, const Op& in, const Escena& after, Respuesta r) {
  const auto about = [&] { return values(in); };
  if (contract::evaluated(cost::normal)) {
    check(post(before, in, after, r, cost::normal), cost::normal, about);
    check(inv_at(after, in.e), cost::normal, about);
  }
  if (contract::evaluated(cost::audit)) {
    check(post(before, in, after, r, cost::audit), cost::audit, about);
    check(inv(after), cost::audit, about);
  }
}

template <class Op>
Respuesta perform(Escena& escena, const Op& in) {
  check_before(escena, in);
  Escena after = after_of(escena, in);
  check_after(escena, in, after, in.answer);
  escena = std::move(after);  // from here on nothing can fail
  return in.answer;
}

/// A specific addition: its name says the type.
template <class Op>
concept SaysItsType = requires(Op in) { in.t = Op::tipo; };

/// \hide (t?): some t? will do, and that of the name does.
template <class Op>
Op hide_t(Op in) {
  if constexpr (SaysItsType<Op>) in.t = Op::tipo;
  return in;
}

/// The first error of the total operation, in the order of the text, and the precondition that it denies.
struct FirstError {
  Error error;
  const clause* violated;
};

template <class Op>
std::optional<FirstError> first_error(const Escena& escena, const Op& in) {
  std::optional<FirstError> first;
  preconditions(in, escena, [&](const clause& what, const Refusal& refusal, auto&& holds) {
    if (!first && refusal && !holds()) first = {*refusal, &what};
  });
  return first;
}

template <class Op>
Answer perform_total(Escena& escena, const Op& in) {
  const auto first = first_error(escena, in);
  if (!first) return {perform(escena, in)};
  return {model::apply(std::as_const(escena), first->error), first->violated};
}

}  // namespace

Addition specific(const Agregar_Elemento& in) {
  const auto given = [&](const auto& attribute) -> const auto& {
    const auto& input = attribute.input(in);
    if (input) return *input;
    throw std::invalid_argument(fmt::format("Agregar_Elemento: {}? is absent", attribute.word));
  };
  return with_type(in.t, [&]<class Type>(std::type_identity<Type>) -> Addition {
    // A schema declares the centre first, of which it requires nothing, and then each input of which it does.
    return std::apply(
        [&]<class... Entry>(const Entry&...) {
          if constexpr (InputOf<decltype(attribute_of<&Escena::mi_centro>()), typename Type::Addition>)
            return typename Type::Addition{in.e, given(attribute_of<&Escena::mi_centro>()),
                                           given(attribute_of<Entry::Denial::component>())...};
          else
            return typename Type::Addition{in.e, given(attribute_of<Entry::Denial::component>())...};
        },
        Type::Addition::requirements);
  });
}

Removal specific(const Escena& s, const Eliminar_Elemento& in) {
  contract::require(Eliminar_Elemento_pre_1, s.elementos.contains(in.e));
  return with_type(s.de_que_tipo.at(in.e),
                   [&]<class Type>(std::type_identity<Type>) -> Removal { return typename Type::Removal{in.e}; });
}

Respuesta apply(Escena& escena, const Operation& operation) {
  return std::visit([&](const auto& in) { return perform(escena, in); }, operation);
}

Answer apply_total(Escena& escena, const Operation& operation) {
  return std::visit([&](const auto& in) { return perform_total(escena, hide_t(in)); }, operation);
}

}  // namespace durero::model
