#pragma once
/// spec/tablas.tex: the tables of a scene as the text writes them, component for component. Scene keeps the same in
/// vectors and a hash table; this is what its rows and its index say, for the text to be asked of.

#include <cstdint>
#include <map>
#include <tuple>

#include "durero/model/escena.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// Tablas. A place, Lugar.def.1, is an ElementRef, and tabla.def.1 its `tipo`. Scene() is Init_Tablas
/// (Init_Tablas.post.1). Of every Scene the invariant holds, because a row is appended or taken as a whole and the
/// index follows in the same step: tables have no gap (Tablas.inv.1), names and index say the same (Tablas.inv.2), and
/// a table has the columns of its type (Tablas.inv.3, Tablas.inv.4, Tablas.inv.5, Tablas.inv.6, Tablas.inv.7,
/// Tablas.inv.8).
struct Tablas {
  /// @{ The component of that name in the text.
  std::map<model::Elemento, ElementRef> lugar;
  std::map<model::Tipo, std::uint32_t> cuantos;
  std::map<ElementRef, model::Elemento> nombres;
  std::map<ElementRef, model::Punto> centros;
  std::map<ElementRef, model::Rmas> radios;
  std::map<ElementRef, model::Vector> vectores;
  std::map<ElementRef, model::Rmas> alturas;
  std::map<ElementRef, model::Rmas> proporciones;
  std::map<ElementRef, model::Vertices> ternas;
  /// @}

  bool operator==(const Tablas&) const = default;
};

/// A column, and the attribute of a scene that Retrieve makes of it.
template <class Value>
struct Column {
  std::string_view word;                                       ///< its name in the text
  std::map<ElementRef, Value> Tablas::*values;                 ///< the column
  std::map<model::Elemento, Value> model::Escena::*component;  ///< the attribute
};

/// As the standard deduces them of an aggregate; Clang 16 does not.
template <class Value>
Column(std::string_view, std::map<ElementRef, Value> Tablas::*, std::map<model::Elemento, Value> model::Escena::*)
    -> Column<Value>;

/// In the order of Retrieve.inv.2 to Retrieve.inv.7: Centros.def.1, Radios.def.1, Vectores.def.1, Alturas.def.1,
/// Proporciones.def.1, Ternas.def.1.
inline constexpr std::tuple columns{Column{"centros", &Tablas::centros, &model::Escena::mi_centro},
                                    Column{"radios", &Tablas::radios, &model::Escena::mi_radio},
                                    Column{"vectores", &Tablas::vectores, &model::Escena::mi_vector},
                                    Column{"alturas", &Tablas::alturas, &model::Escena::mi_altura},
                                    Column{"proporciones", &Tablas::proporciones, &model::Escena::mi_proporcion},
                                    Column{"ternas", &Tablas::ternas, &model::Escena::mi_vertices}};

/// visit(column) for each of them.
template <class Visit>
constexpr void for_each_column(Visit&& visit) {
  std::apply([&](const auto&... column) { (visit(column), ...); }, columns);
}

/// The tables of the elements by themselves, without meshes, read from the rows; `lugar` is what the index answers for
/// the name of each. A name that the index knows and no row has would stand nowhere here: scene.size() counts it, and
/// the faces of meshes. O(n log n).
Tablas tablas(const Scene& scene);

}  // namespace durero::scene
