#pragma once
/// The closed set of types. What the text says of each is a header of its own in model/tipo/.

#include <cstddef>
#include <type_traits>

#include "durero/model/tipo/cilindro.hpp"
#include "durero/model/tipo/cono.hpp"
#include "durero/model/tipo/disco.hpp"
#include "durero/model/tipo/esfera.hpp"
#include "durero/model/tipo/plano.hpp"
#include "durero/model/tipo/triangulo.hpp"
#include "durero/model/tipo/tronco.hpp"

namespace durero::model {

/// Every type, in the order of Tipo.
using Types = std::tuple<Esfera, Cilindro, Cono, Tronco, Plano, Disco, Triangulo>;

/// visit(std::type_identity<Type>) for every type, in order.
template <class Visit>
constexpr void for_each_type(Visit&& visit) {
  [&]<class... Type>(std::type_identity<std::tuple<Type...>>) {
    (visit(std::type_identity<Type>()), ...);
  }(std::type_identity<Types>());
}

// The list is whole and in order.
static_assert([] {
  std::size_t place = 0;
  bool in_order = true;
  for_each_type([&]<class Type>(std::type_identity<Type>) {
    in_order = in_order && static_cast<std::size_t>(Type::tipo) == place++ && Type::Addition::tipo == Type::tipo &&
               Type::Removal::tipo == Type::tipo && Type::Removal::Denial::tipo == Type::tipo;
  });
  return in_order && place == tipo_count;
}());

/// visit(std::type_identity<Type>) for the type of an element; the results have one type.
template <class Visit>
decltype(auto) with_type(Tipo tipo, Visit&& visit) {
  using Result = std::invoke_result_t<Visit&, std::type_identity<std::tuple_element_t<0, Types>>>;
  return [&]<class... Type>(std::type_identity<std::tuple<Type...>>) -> Result {
    constexpr std::array<Result (*)(Visit&), sizeof...(Type)> visits{
        [](Visit& of) -> Result { return of(std::type_identity<Type>()); }...};
    return visits[static_cast<std::size_t>(tipo)](visit);
  }(std::type_identity<Types>());
}

}  // namespace durero::model
