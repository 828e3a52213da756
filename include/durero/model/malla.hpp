#pragma once
/// spec/malla.tex: a mesh is points, each of which stands once, and faces; its faces are triangles of the scene. What
/// is said here is said of a copy, in O(n), as in model/operaciones.hpp.

#include <map>
#include <optional>
#include <set>
#include <variant>
#include <vector>

#include "durero/model/cara.hpp"
#include "durero/model/escena.hpp"
#include "durero/model/operation.hpp"
#include "durero/model/puntos.hpp"

namespace durero::model {

using contract::clause;

inline constexpr clause Red_inv_1{"Red.inv.1", "dom puntos = 0 ‥ # puntos - 1"};
inline constexpr clause Red_inv_2{"Red.inv.2", "dom caras = 0 ‥ # caras - 1"};
inline constexpr clause Completa_inv_1{"Completa.inv.1", "∀ c : ran red.caras • { c.i, c.j, c.k } ⊆ dom red.puntos"};
inline constexpr clause Malla_inv_1{"Malla.inv.1", "∀ c : ran red.caras • terna(red, c) ∈ Vertices"};
inline constexpr clause Mallas_inv_1{"Mallas.inv.1", "mallas ⊆ dom familia"};
inline constexpr clause Mallas_inv_2{"Mallas.inv.2", "∀ m : dom mallas • familia(m, mallas(m)) ⊆ mi_vertices"};
inline constexpr clause Init_Mallas_post_1{"Init_Mallas.post.1", "mallas' = ∅"};

/// Points and faces, each numbered from zero without a gap (Red). Throws contract_violation Red.inv.1 or Red.inv.2
/// otherwise. What the faces name need be no points of it.
class Red {
 public:
  /// @{ The component of that name in the text, as a function.
  using Points = std::map<Ordinal, Punto>;
  using Faces = std::map<Ordinal, Cara>;
  /// @}
  /// Precondition: all_hold(inv(puntos, caras)); throws otherwise.
  Red(Points puntos, Faces caras);
  /// Of points and faces that are numbered in the order in which they stand.
  static Red of(const std::vector<Punto>& puntos, const std::vector<Cara>& caras);
  /// Red.inv.1 and Red.inv.2.
  static Judgements inv(const Points& puntos, const Faces& caras);
  /// @{ The component of that name.
  const Points& puntos() const noexcept { return puntos_; }
  const Faces& caras() const noexcept { return caras_; }
  /// @}
  bool operator==(const Red&) const = default;

 private:
  Points puntos_;
  Faces caras_;
};

/// The points of a face (terna.def.1); nothing where one of its numbers is no point's.
std::optional<Terna> terna(const Red& red, const Cara& c);

/// red ∈ Completa: each face names points that there are.
bool is_complete(const Red& red);

/// Points and faces that are a mesh (Malla): complete, and no face has its points on one line. Throws
/// contract_violation Completa.inv.1 or Malla.inv.1 otherwise.
class Malla {
 public:
  /// Precondition: contains(red); throws otherwise.
  explicit Malla(Red red);
  /// The points and faces, as they were given.
  const Red& red() const noexcept { return red_; }
  /// red ∈ Malla, exactly.
  static bool contains(const Red& red);
  bool operator==(const Malla&) const = default;

 private:
  Red red_;
};

/// The name of the face n of the mesh m: `m:n`, in decimal (nombre_cara.def.1). No two faces have one, since the number
/// is what stands behind the last colon. Nothing where that is too long for a name.
std::optional<Elemento> nombre_cara(const Elemento& m, Ordinal n);

/// The triangles of a mesh by their names.
using Family = std::map<Elemento, Vertices>;

/// familia(m, red) (familia.def.1); nothing outside its domain: where red is no mesh, or a face has no name.
std::optional<Family> familia(const Elemento& m, const Red& red);

/// The points and faces with the point n at p (movida.def.1); nothing where there is no such point.
std::optional<Red> movida(const Red& red, Ordinal n, const Punto& p);

/// A scene with meshes (Mallas). A plain value: its invariants are evaluated by what is declared below.
struct Mallas {
  Escena escena;                     ///< the components of Escena
  std::map<Elemento, Malla> mallas;  ///< the component of that name

  bool operator==(const Mallas&) const = default;
};

/// The invariants of Escena, Mallas.inv.1 and Mallas.inv.2: the whole predicates. O(n).
Judgements inv(const Mallas& s);

/// @{ The names of the triangles of one mesh, none where there is no such mesh (suyos.def.1), and of all
/// (de_malla.def.1).
std::set<Elemento> suyos(const Mallas& s, const Elemento& m);
std::set<Elemento> de_malla(const Mallas& s);
/// @}

/// The elements that are of no mesh, as a scene (sueltas.def.1).
Escena sueltas(const Mallas& s);

/// The empty scene without meshes (Init_Mallas). Its postcondition is checked.
Mallas Init_Mallas();
/// The clauses of Init_Mallas over its after-state.
Judgements Init_Mallas_post(const Mallas& after);

// The operations on meshes, each a struct of its inputs, without the `?`, with the names of its schemas in the text and
// the r! of the operation when it is done.

/// Adds a mesh: its triangles, all or none (Agregar_Malla).
struct Agregar_Malla {
  Elemento m;
  Red red;

  static constexpr Respuesta answer = Respuesta::malla_agregada;
  static constexpr std::string_view schema = "Agregar_Malla";
  static constexpr std::string_view total = "Agregar_Malla_Total";  ///< Agregar_Malla_Total.def.1
};

/// Removes a mesh with its triangles (Eliminar_Malla).
struct Eliminar_Malla {
  Elemento m;

  static constexpr Respuesta answer = Respuesta::malla_eliminada;
  static constexpr std::string_view schema = "Eliminar_Malla";
  static constexpr std::string_view total = "Eliminar_Malla_Total";  ///< Eliminar_Malla_Total.def.1
};

/// Replaces a mesh by another of its name (Reemplazar_Malla).
struct Reemplazar_Malla {
  Elemento m;
  Red red;

  static constexpr Respuesta answer = Respuesta::malla_reemplazada;
  static constexpr std::string_view schema = "Reemplazar_Malla";
  static constexpr std::string_view total = "Reemplazar_Malla_Total";  ///< Reemplazar_Malla_Total.def.1
};

/// Moves a vertex of a mesh, that is the corner of every face that has it (Mover_Vertice).
struct Mover_Vertice {
  Elemento m;
  Ordinal n;
  Punto punto;

  static constexpr Respuesta answer = Respuesta::vertice_movido;
  static constexpr std::string_view schema = "Mover_Vertice";
  static constexpr std::string_view total = "Mover_Vertice_Total";  ///< Mover_Vertice_Total.def.1
};

/// Any operation on meshes.
using MeshOperation = std::variant<Agregar_Malla, Eliminar_Malla, Reemplazar_Malla, Mover_Vertice>;

/// The partial operation. Throws contract_violation where a clause does not hold; the state is then as it was.
Respuesta apply(Mallas& s, const MeshOperation& operation);

/// The total operation (…_Total): where a precondition does not hold it changes nothing and answers the error, the
/// first in the order of the text.
Answer apply_total(Mallas& s, const MeshOperation& operation);

/// The total operation of a single element in a scene with meshes (…_Mallas), which leaves each mesh as it is: a
/// triangle of a mesh is not removed alone. The operation has the name of the scene's own, with _Mallas for _Total:
/// Agregar_Esfera_Mallas.def.1, Agregar_Cilindro_Mallas.def.1, Agregar_Cono_Mallas.def.1, Agregar_Tronco_Mallas.def.1,
/// Agregar_Plano_Mallas.def.1, Agregar_Disco_Mallas.def.1, Agregar_Triangulo_Mallas.def.1,
/// Agregar_Elemento_Mallas.def.1, Eliminar_Esfera_Mallas.def.1, Eliminar_Cilindro_Mallas.def.1,
/// Eliminar_Cono_Mallas.def.1, Eliminar_Tronco_Mallas.def.1, Eliminar_Plano_Mallas.def.1, Eliminar_Disco_Mallas.def.1,
/// Eliminar_Triangulo_Mallas.def.1 and Eliminar_Elemento_Mallas.def.1.
Answer apply_total(Mallas& s, const Operation& operation);

// A mesh is watertight since the sign at an edge is computed once for the two triangles that share it.

/// The volume of the direction of a ray and of the ways from its origin to the ends of an edge (giro.def.1): positive
/// where its line passes the edge on the one side, negative on the other. giro(rayo, b, a) is −giro(rayo, a, b).
/// Precondition: the points lie in one field.
Surd giro(const Rayo& rayo, const ExactPoint& a, const ExactPoint& b);

/// The sum of giro over the edges of a triangle; zero where the ray is parallel to it (cruce.def.1).
Surd cruce(const Rayo& rayo, const Terna& v);

/// (v, w) ∈ Vecinos: two triangles that share an edge, each in its own order (Vecinos.def.1).
bool are_neighbours(const Terna& v, const Terna& w);

/// The points of the line of a ray, at every parameter (recta.def.1).
Puntos recta(const Rayo& rayo);

}  // namespace durero::model
