// How an operation edits the tables of a scene. Whatever asks for memory comes first and changes nothing that can be
// seen; the edit itself cannot fail; where a postcondition is broken the edit is undone, which cannot fail either.

#include <memory>
#include <optional>

#include "clauses.hpp"
#include "durero/model/cambio.hpp"
#include "durero/model/malla_clauses.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {
namespace {

using contract::cost;
using contract::evaluation_semantic;

template <class Op>
concept Addition = !std::is_void_v<ShapeAddedBy<Op>>;

[[gnu::cold, gnu::noinline]] std::string values(const model::Elemento& e) { return "e = " + e.name(); }

/// Checks a clause as a contract, under a semantic that was read once for all clauses of an operation.
auto checker(evaluation_semantic now, const model::Elemento& e) {
  return [now, &e](const clause& what, auto&& holds) {
    contract::check_under(now, what, holds, [&] { return values(e); });
  };
}

}  // namespace

class Editor {
 public:
  explicit Editor(Scene& scene) : scene_(scene) {}

  template <class Op>
  Respuesta apply(const Op& in) {
    const Key key = find(in.e);
    if constexpr (!Addition<Op>) require_single(key.place);
    if (const auto now = contract::semantic(cost::normal); now != evaluation_semantic::ignore) {
      const auto check = checker(now, in.e);
      preconditions(in, key.place, [&](const clause& what, const Refusal&, auto&& holds) { check(what, holds); });
    }
    return edit(in, key);
  }

  Respuesta apply(const model::Agregar_Elemento& in) {
    std::visit([&](const auto& addition) { apply(addition); }, specific(in));
    return Respuesta::elemento_agregado;
  }

  Respuesta apply(const model::Eliminar_Elemento& in) {
    const Key key = find(in.e);
    require_single(key.place);
    checker(contract::semantic(cost::normal), in.e)(model::Eliminar_Elemento_pre_1,
                                                    [&] { return key.place.has_value(); });
    edit_general(in, key);
    return Respuesta::elemento_eliminado;
  }

  template <ChangeOfAttribute Op>
  Respuesta change(const Op& in) {
    const Key key = find(in.e);
    require_single(key.place);
    if (const auto now = contract::semantic(cost::normal); now != evaluation_semantic::ignore) {
      const auto check = checker(now, in.e);
      preconditions(in, key.place, is_body(key.place),
                    [&](const clause& what, Respuesta, auto&& holds) { check(what, holds); });
    }
    return edit_attribute(in, key);
  }

  template <ChangeOfAttribute Op>
  model::Answer change_total(const Op& in) {
    const Key key = find(in.e);
    if (is_face(key.place)) return es_de_malla;
    std::optional<model::Answer> first;
    preconditions(in, key.place, is_body(key.place), [&](const clause& what, Respuesta refusal, auto&& holds) {
      if (!first && !holds()) first = model::Answer{refusal, &what};
    });
    return first ? *first : model::Answer{edit_attribute(in, key)};
  }

  /// The total operation of one type on the tables. Of an addition t? is hidden: Agregar_Esfera_Total_Tablas.def.1,
  /// Agregar_Cilindro_Total_Tablas.def.1, Agregar_Cono_Total_Tablas.def.1, Agregar_Tronco_Total_Tablas.def.1,
  /// Agregar_Plano_Total_Tablas.def.1, Agregar_Disco_Total_Tablas.def.1 and Agregar_Triangulo_Total_Tablas.def.1. Of a
  /// removal: Eliminar_Esfera_Total_Tablas.def.1, Eliminar_Cilindro_Total_Tablas.def.1,
  /// Eliminar_Cono_Total_Tablas.def.1, Eliminar_Tronco_Total_Tablas.def.1, Eliminar_Plano_Total_Tablas.def.1,
  /// Eliminar_Disco_Total_Tablas.def.1 and Eliminar_Triangulo_Total_Tablas.def.1.
  template <class Op>
  model::Answer apply_total(const Op& in) {
    if constexpr (Addition<Op>)
      if (in.t != ShapeAddedBy<Op>::tipo) return apply_total(hide_t(in));
    const Key key = find(in.e);
    if constexpr (!Addition<Op>)
      if (is_face(key.place)) return es_de_malla;
    if (const auto refusal = first_refusal(in, key.place)) return *refusal;
    return {edit(in, key)};
  }

  /// Agregar_Elemento_Total_Tablas.def.1: the addition of the type, and where it is done the general answer
  /// (Elemento_Agregado_Tablas.def.1).
  model::Answer apply_total(const model::Agregar_Elemento& in) {
    const model::Answer answer = std::visit([&](const auto& addition) { return apply_total(addition); }, specific(in));
    return answer.ok() ? model::Answer{Respuesta::elemento_agregado} : answer;
  }

  /// Eliminar_Elemento_Total_Tablas.def.1: the removal from whatever table the row is in, and the general answer
  /// (Elemento_Eliminado_Tablas.def.1).
  model::Answer apply_total(const model::Eliminar_Elemento& in) {
    const Key key = find(in.e);
    if (is_face(key.place)) return es_de_malla;
    if (!key.place) return {Respuesta::elemento_no_existe, &model::Eliminar_Elemento_pre_1};
    edit_general(in, key);
    return {Respuesta::elemento_eliminado};
  }

 private:
  struct Key {
    NameIndex::hash_type hash;
    Place place;
  };

  Key find(const model::Elemento& e) const {
    const NameIndex::hash_type hash = NameIndex::hash(e.name());
    return {hash, scene_.find(e.name(), hash)};
  }

  /// \hide (t?): the name of a specific addition says the type.
  template <class Op>
  static Op hide_t(Op in) {
    in.t = ShapeAddedBy<Op>::tipo;
    return in;
  }

  template <class Op>
  static std::optional<model::Answer> first_refusal(const Op& in, const Place& place) {
    std::optional<model::Answer> first;
    preconditions(in, place, [&](const clause& what, const Refusal& refusal, auto&& holds) {
      if (!first && refusal && !holds()) first = model::Answer{*refusal, &what};
    });
    return first;
  }

  void edit_general(const model::Eliminar_Elemento& in, const Key& key) {
    require_row(key.place);
    with_shape(key.place->tipo,
               [&]<class Shape>(std::type_identity<Shape>) { edit(typename Shape::Removal{in.e}, key); });
  }

  /// What a scene stands for, where its edit is audited.
  using State = std::shared_ptr<const model::Escena>;
  using OldState = std::optional<State>;

  OldState old_state() const {
    if (scene_.audits_are_put_off_) return std::nullopt;
    return contract::old_value([&] { return scene_.audited_ ? scene_.audited_ : state(); });
  }

  State state() const { return std::make_shared<const model::Escena>(retrieve(scene_)); }

  /// The edit, between the old value and the whole Z predicates where audit clauses are evaluated. What the audit of
  /// the edit before saw is the old value of this one.
  template <class Op>
  Respuesta edit(const Op& in, const Key& key) {
    const OldState before = old_state();
    if constexpr (Addition<Op>)
      return add(in, key.hash, before);
    else
      return remove(in, key, before);
  }

  /// Agregar_Fila: e? has no place (Agregar_Fila.pre.1); the index learns the one behind the last row
  /// (Agregar_Fila.post.1), and there is a row more (Agregar_Fila.post.2). What each type puts in its columns is its
  /// Shape: Agregar_Esfera_Tablas.def.1, Agregar_Cilindro_Tablas.def.1, Agregar_Cono_Tablas.def.1,
  /// Agregar_Tronco_Tablas.def.1, Agregar_Plano_Tablas.def.1, Agregar_Disco_Tablas.def.1 and
  /// Agregar_Triangulo_Tablas.def.1.
  template <class Op>
  Respuesta add(const Op& in, NameIndex::hash_type hash, const OldState& before) {
    using Shape = ShapeAddedBy<Op>;
    Table<Shape>& table = scene_.table<Shape>();
    const Sizes sizes_before = sizes();
    const Respuesta r = in.answer;
    TableRow<Shape> row{shape_of<Shape>(in), {in.e, hash}};
    table.reserve_one_more();
    scene_.index_.reserve_one_more();

    const ElementRef place{Shape::tipo, table.size()};
    table.push_back(std::move(row));
    scene_.index_.insert(hash, place);
    try {
      if (const auto now = contract::semantic(cost::normal); now != evaluation_semantic::ignore)
        postconditions(
            in, Added<Shape>{sizes_before, sizes(), place, scene_.find(in.e.name(), hash), table.shapes.back(), r},
            checker(now, in.e));
      audit(before, in, in.e, r);
    } catch (...) {
      scene_.index_.erase(hash, place);
      table.pop_back();
      throw;
    }
    return r;
  }

  /// Removes the row that the name has, whatever its type is: only where preconditions are not enforced can it differ.
  template <class Op>
  Respuesta remove(const Op& in, const Key& key, const OldState& before) {
    require_row(key.place);
    return with_shape(key.place->tipo, [&]<class Shape>(std::type_identity<Shape>) {
      return remove_from(scene_.table<Shape>(), in, key, before);
    });
  }

  /// Quitar_Fila: e? has a place (Quitar_Fila.pre.1); the last row moves into it (mudanza.def.1), in the index
  /// (Quitar_Fila.post.1) and with every column at once, since they are one row here (Quitar_Fila.post.3,
  /// Quitar_Fila.post.4, Quitar_Fila.post.5, Quitar_Fila.post.6, Quitar_Fila.post.7, Quitar_Fila.post.8); there is a
  /// row less (Quitar_Fila.post.2). The type says the operation: Eliminar_Esfera_Tablas.def.1,
  /// Eliminar_Cilindro_Tablas.def.1, Eliminar_Cono_Tablas.def.1, Eliminar_Tronco_Tablas.def.1,
  /// Eliminar_Plano_Tablas.def.1, Eliminar_Disco_Tablas.def.1 and Eliminar_Triangulo_Tablas.def.1.
  template <class Shape, class Op>
  Respuesta remove_from(Table<Shape>& table, const Op& in, const Key& key, const OldState& before) {
    const Sizes sizes_before = sizes();
    const Respuesta r = in.answer;
    const ElementRef gap = *key.place, last{gap.tipo, table.size() - 1};
    const NameIndex::hash_type last_hash = table.labels[last.index].hash;

    scene_.index_.erase(key.hash, gap);
    if (gap != last) scene_.index_.move(last_hash, last, gap);
    TableRow<Shape> row = table.take(gap.index);
    try {
      if (const auto now = contract::semantic(cost::normal); now != evaluation_semantic::ignore) {
        const bool known = scene_.find(in.e.name(), key.hash).has_value();
        const bool moved_is_known = gap == last || scene_.index_.knows(table.labels[gap.index].hash, gap);
        postconditions(in, Removed{sizes_before, sizes(), known, moved_is_known, r}, checker(now, in.e));
      }
      audit(before, in, in.e, r);
    } catch (...) {
      table.put_back(gap.index, std::move(row));
      if (gap != last) scene_.index_.move(last_hash, gap, last);
      scene_.index_.insert(key.hash, gap);
      throw;
    }
    return r;
  }

  /// Puts the value into the column of the row, whatever its type is; nothing where that has no such column: only where
  /// preconditions are not enforced can it be so.
  template <ChangeOfAttribute Op>
  Respuesta edit_attribute(const Op& in, const Key& key) {
    contract::require(model::Cambiar_Elemento_pre_1, key.place.has_value());
    const OldState before = old_state();
    with_shape(key.place->tipo, [&]<class Shape>(std::type_identity<Shape>) {
      if constexpr (has_attribute<Shape, Op::component>()) {
        constexpr auto field = std::get<place_of_attribute<Shape, Op::component>()>(attributes_of<Shape>).field;
        edit_row(in, key, before, scene_.table<Shape>().shapes[key.place->index], field);
      }
    });
    return model::change_answer;
  }

  template <class Op, class Shape, class Field>
  void edit_row(const Op& in, const Key& key, const OldState& before, Shape& row, Field field) {
    const Sizes sizes_before = sizes();
    const Shape old = row;
    row.*field = stored(model::attribute_of<Op::component>().input(in));
    try {
      if (const auto now = contract::semantic(cost::normal); now != evaluation_semantic::ignore)
        postconditions(in,
                       Changed<Shape>{sizes_before, sizes(), *key.place, scene_.find(in.e.name(), key.hash), old, row},
                       model::change_answer, checker(now, in.e));
      audit(before, model::AttributeChange(in), in.e, model::change_answer);
    } catch (...) {
      row = old;
      throw;
    }
  }

  /// The whole Z predicates over the retrieved scenes. Keeps what it saw, for the audit of the next edit.
  template <class Op>
  void audit(const OldState& before, const Op& in, const model::Elemento& e, Respuesta r) const {
    if (!before) return scene_.audited_.reset();
    State after = state();
    const auto about = [&] { return values(e); };
    model::check(model::post(**before, in, *after, r, cost::audit), cost::audit, about);
    model::check(model::inv(*after), cost::audit, about);
    scene_.audited_ = std::move(after);
  }

  /// A name without a row: nothing to remove, whatever the semantic of preconditions is.
  static void require_row(const Place& place) { contract::require(model::Eliminar_Elemento_pre_1, place.has_value()); }

  /// @{ A face is removed with its mesh alone, whatever the semantic of preconditions is.
  static constexpr model::Answer es_de_malla{Respuesta::es_de_malla, &model::Fuera_De_Malla_pre_1};
  bool is_face(const Place& place) const { return place && scene_.is_face(*place); }
  bool is_body(const Place& place) const { return place && !is_face(place) && scene_.body(*place) != nullptr; }
  void require_single(const Place& place) const { contract::require(model::Fuera_De_Malla_pre_1, !is_face(place)); }
  /// @}

  Sizes sizes() const {
    return Sizes([&]<class Shape>(std::type_identity<Shape>) -> std::size_t { return scene_.table<Shape>().size(); });
  }

  Scene& scene_;
};

Respuesta Scene::apply(const model::Operation& operation) {
  return std::visit([&](const auto& in) { return Editor(*this).apply(in); }, operation);
}

model::Answer Scene::apply_total(const model::Operation& operation) {
  return std::visit([&](const auto& in) { return Editor(*this).apply_total(in); }, operation);
}

Respuesta Scene::change(const model::AttributeChange& change) {
  return std::visit([&](const auto& in) { return Editor(*this).change(in); }, change);
}

model::Answer Scene::change_total(const model::AttributeChange& change) {
  return std::visit([&](const auto& in) { return Editor(*this).change_total(in); }, change);
}

}  // namespace durero::scene
