#include "element_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

using model::Respuesta;
using model::Tipo;

enum Field : std::size_t { id, tipo, centro, radio, vector, altura, proporcion, material };
constexpr std::array<std::string_view, 8> field_names = {"id",     "tipo",   "centro",     "radio",
                                                         "vector", "altura", "proporcion", "material"};
constexpr std::size_t always_required = 3;  // id, tipo, centro

constexpr std::array<std::string_view, 3> tipo_names = {"esfera", "cilindro", "cono"};  // in the order of Tipo

// The attributes of each type, and no others (Escena.inv.3 to Escena.inv.6).
std::span<const Field> attributes(Tipo t) {
  static constexpr Field esfera[] = {radio};
  static constexpr Field cilindro[] = {radio, vector, altura};
  static constexpr Field cono[] = {proporcion, vector, altura};
  static constexpr std::span<const Field> all[] = {esfera, cilindro, cono};
  return all[static_cast<std::size_t>(t)];
}

// What the object of an element holds, and where.
struct Fields {
  std::size_t at = 0;                       // the object
  std::array<std::size_t, 8> key_offset{};  // 0 where the key is not there: no key stands at the start of a text
  std::array<std::size_t, 8> offset{};      // the values
  std::string_view id{}, material{};
  Tipo tipo{};
  glm::dvec3 centro{}, vector{};
  double radio = 0, altura = 0, proporcion = 0;
};

Tipo read_tipo(json::Reader& in) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("tipo");
  const auto found = std::ranges::find(tipo_names, name);
  if (found == tipo_names.end()) {
    in.fail(at, fmt::format("tipo is {}", text::shown(name)), "expected \"esfera\", \"cilindro\" or \"cono\"");
  }
  return static_cast<Tipo>(found - tipo_names.begin());
}

void read_field(json::Reader& in, Field field, Fields& f) {
  f.key_offset[field] = in.key_offset();
  f.offset[field] = in.offset();
  const std::string_view what = field_names[field];
  switch (field) {
    case id:
      f.id = in.string(what);
      if (!model::Elemento::is_name(f.id)) {
        in.fail(f.offset[id], fmt::format("id is {}", text::shown(f.id)), "expected 1 to 128 of A-Z a-z 0-9 _ . : -");
      }
      break;
    case tipo:
      f.tipo = read_tipo(in);
      break;
    case centro:
      f.centro = in.vec3(what);
      break;
    case radio:
      f.radio = in.number(what);
      break;
    case vector:
      f.vector = in.vec3(what);
      break;
    case altura:
      f.altura = in.number(what);
      break;
    case proporcion:
      f.proporcion = in.number(what);
      break;
    case material:
      f.material = in.string(what);
      break;
  }
}

// Each attribute is there if and only if the type has it.
void check_attributes(const json::Reader& in, const Fields& f) {
  const auto own = attributes(f.tipo);
  const std::string_view tipo_name = tipo_names[static_cast<std::size_t>(f.tipo)];
  for (const Field field : {radio, vector, altura, proporcion}) {
    const bool there = f.key_offset[field] != 0;
    const bool wanted = std::ranges::find(own, field) != own.end();
    if (there && !wanted) {
      in.fail(f.key_offset[field],
              fmt::format("unknown key \"{}\" in an element of tipo {}", field_names[field], tipo_name),
              "expected the attributes of its tipo only");
    }
    if (!there && wanted) {
      in.fail(f.at, fmt::format("key \"{}\" is missing in an element of tipo {}", field_names[field], tipo_name),
              "expected it");
    }
  }
}

model::Operation addition(const Fields& f) {
  model::Elemento e{std::string(f.id)};
  const model::Punto c{f.centro};
  switch (f.tipo) {
    case Tipo::soy_esfera:
      return model::Agregar_Esfera{std::move(e), c, f.radio};
    case Tipo::soy_cilindro:
      return model::Agregar_Cilindro{std::move(e), c, f.radio, model::Vector{f.vector}, f.altura};
    case Tipo::soy_cono:
      break;
  }
  return model::Agregar_Cono{std::move(e), c, f.proporcion, model::Vector{f.vector}, f.altura};
}

// The operation says which clause does not hold; the file's error stands at the value that breaks it.
[[noreturn]] void refuse(const json::Reader& in, const Fields& f, const model::Answer& answer) {
  const auto at_value = [&](Field field, double value) {
    in.fail(f.offset[field], fmt::format("{} is {}", field_names[field], value),
            fmt::format("expected {} ({})", model::Rmas_inv_1.predicate, model::Rmas_inv_1.label));
  };
  switch (answer.r) {
    case Respuesta::radio_no_positivo:
      at_value(radio, f.radio);
      break;
    case Respuesta::altura_no_positiva:
      at_value(altura, f.altura);
      break;
    case Respuesta::proporcion_no_positiva:
      at_value(proporcion, f.proporcion);
      break;
    case Respuesta::vector_no_unitario:
      in.fail(
          f.offset[vector], fmt::format("vector is ({}, {}, {})", f.vector.x, f.vector.y, f.vector.z),
          fmt::format("expected a unit vector, {} ({})", model::Unitario_inv_1.predicate, model::Unitario_inv_1.label));
    default:
      break;
  }
  in.fail(f.offset[id], fmt::format("id is {}: {}", text::shown(f.id), model::name(answer.r)),
          fmt::format("expected {} ({})", answer.violated->predicate, answer.violated->label));
}

}  // namespace

void read_element(json::Reader& in, scene::Scene& scene, std::vector<MaterialUse>& uses) {
  Fields f;
  f.at = in.offset();
  in.object("an element", field_names, always_required,
            [&](std::size_t field) { read_field(in, static_cast<Field>(field), f); });
  check_attributes(in, f);
  const model::Answer answer = scene.apply_total(addition(f));
  if (!answer.ok()) refuse(in, f, answer);
  if (f.key_offset[material] != 0) uses.push_back({f.id, {f.material, f.offset[material]}});
}

}  // namespace durero::io
