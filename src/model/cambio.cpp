#include "durero/model/cambio.hpp"

#include <fmt/format.h>

#include "durero/model/type_list.hpp"

namespace durero::model {
namespace {

using contract::cost;

/// The error that the type of an element has not the attribute.
Sin_Centro lack_of(const Cambiar_Centro& in) { return {in.e}; }
Sin_Radio lack_of(const Cambiar_Radio& in) { return {in.e}; }
Sin_Vector lack_of(const Cambiar_Vector& in) { return {in.e}; }
Sin_Altura lack_of(const Cambiar_Altura& in) { return {in.e}; }
Sin_Proporcion lack_of(const Cambiar_Proporcion& in) { return {in.e}; }
Sin_Vertices lack_of(const Cambiar_Vertices& in) { return {in.e}; }

Error other_type(Tipo t, const Elemento& e) {
  return with_type(t, [&]<class Type>(std::type_identity<Type>) -> Error { return typename Type::Removal::Denial{e}; });
}

/// visit(clause, error, holds) for each precondition, in the order of the total operation's errors.
template <class Change, class Visit>
void change_preconditions(const Change& in, const Escena& s, Visit&& visit) {
  visit(Cambiar_Elemento_pre_1, ChangeError(Elemento_No_Existe{in.e}), [&] { return s.elementos.contains(in.e); });
  if (in.of_type)
    visit(of_type_clause(*in.of_type), ChangeError(other_type(*in.of_type, in.e)),
          [&] { return is_of_type(s, in.e, *in.of_type); });
  visit(*Change::has_attribute, ChangeError(lack_of(in)), [&] { return (s.*Change::component).contains(in.e); });
  for_each_entry(Change::requirements, [&]<class Entry>(const Entry& required) {
    visit(*required.what, ChangeError(typename Entry::Denial{required.input(in)}), [&] { return required.holds(in); });
  });
}

template <class Change>
Escena changed(const Escena& before, const Change& in) {
  Escena s = before;
  auto& component = s.*Change::component;
  using Value = typename std::remove_reference_t<decltype(component)>::mapped_type;
  component.insert_or_assign(in.e, Value(attribute_of<Change::component>().input(in)));
  return s;
}

/// No_Es_…, and what is said beside it of an attribute.
template <class Lack>
  requires requires { Lack::lacks; }
Judgements said_of(const Escena& s, const Lack& in, Respuesta r) {
  return {{Lack::exists, s.elementos.contains(in.e)},
          {Lack::lacks, !(s.*Lack::component).contains(in.e)},
          {Lack::answers, r == Lack::answer}};
}
Judgements said_of(const Escena& s, const Error& error, Respuesta r) { return judgements(s, error, r); }

Respuesta answer_of(const Error& error) {
  return std::visit([](const auto& in) { return in.answer; }, error);
}
template <class Lack>
  requires requires { Lack::lacks; }
Respuesta answer_of(const Lack&) {
  return Lack::answer;
}

std::string about(const AttributeChange& change) {
  return fmt::format("{}: e? = {}", schema_name(change), name_of(change).name());
}

}  // namespace

const clause& of_type_clause(Tipo t) {
  return *with_type(t, []<class Type>(std::type_identity<Type>) { return Type::is_of_type; });
}

const Elemento& name_of(const AttributeChange& change) {
  return std::visit([](const auto& in) -> const Elemento& { return in.e; }, change);
}

std::string schema_name(const AttributeChange& change) {
  return std::visit(
      [](const auto& in) {
        if (!in.of_type) return std::string(in.schema);
        std::string type(name(*in.of_type).substr(std::string_view("soy_").size()));
        type[0] = static_cast<char>(type[0] - 'a' + 'A');
        return fmt::format("{}_{}", in.schema, type);
      },
      change);
}

std::string total_name(const AttributeChange& change) { return schema_name(change) + "_Total"; }

Judgements judgements(const Escena& escena, const ChangeError& error, Respuesta r) {
  return std::visit([&](const auto& in) { return said_of(escena, in, r); }, error);
}

Judgements pre(const Escena& before, const AttributeChange& change) {
  Judgements all;
  const auto judge = [&](const clause& what, const ChangeError&, auto&& holds) { all.push_back({&what, holds()}); };
  std::visit([&](const auto& in) { change_preconditions(in, before, judge); }, change);
  return all;
}

Judgements post(const Escena& before, const AttributeChange& change, const Escena& after, Respuesta r, cost price) {
  const Delta d(before, name_of(change), after, price);
  Judgements all{{&Cambiar_Elemento_post_1, d.same_names()},
                 {&Cambiar_Elemento_post_2, d.same(&Escena::de_que_tipo)},
                 {&Cambiar_Elemento_post_3, r == change_answer}};
  const auto judge = [&](const auto& in) {
    for_each_entry(in.effects, [&](const auto& effect) { all.push_back({effect.what, has_effect(effect, in, d)}); });
  };
  std::visit(judge, change);
  return all;
}

Respuesta apply(Escena& escena, const AttributeChange& change) {
  const auto values = [&] { return about(change); };
  if (contract::evaluated(cost::audit)) check(inv(escena), cost::audit, values);
  if (contract::evaluated(cost::normal)) check(pre(escena, change), cost::normal, values);
  Escena after = std::visit([&](const auto& in) { return changed(escena, in); }, change);
  for (const cost price : {cost::normal, cost::audit})
    if (contract::evaluated(price)) check(post(escena, change, after, change_answer, price), price, values);
  if (contract::evaluated(cost::normal)) check(inv_at(after, name_of(change)), cost::normal, values);
  if (contract::evaluated(cost::audit)) check(inv(after), cost::audit, values);
  escena = std::move(after);  // from here on nothing can fail
  return change_answer;
}

Answer apply_total(Escena& escena, const AttributeChange& change) {
  std::optional<Answer> refused;
  const auto look = [&](const clause& what, const ChangeError& error, auto&& holds) {
    if (refused || holds()) return;
    const Respuesta r = std::visit([](const auto& in) { return answer_of(in); }, error);
    if (contract::evaluated(cost::normal)) check(judgements(escena, error, r), cost::normal);
    refused = Answer{r, &what};
  };
  std::visit([&](const auto& in) { change_preconditions(in, escena, look); }, change);
  return refused ? *refused : Answer{apply(escena, change)};
}

Answer apply_either(Escena& escena, const ElementOperation& operation) {
  return std::visit([&](const auto& in) { return apply_total(escena, in); }, operation);
}

}  // namespace durero::model
