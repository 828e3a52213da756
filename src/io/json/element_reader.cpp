#include "element_reader.hpp"

#include <fmt/format.h>

#include <optional>
#include <variant>
#include <vector>

#include "body_reader.hpp"
#include "durero/model/escena.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/spanish.hpp"
#include "field.hpp"
#include "io/attribute_words.hpp"
#include "vertex_fields.hpp"

namespace durero::io {
namespace {

using model::Tipo;

// The keys of an element: id, tipo, the attributes of all shapes, material, the looks of the vertices, and motion.
constexpr std::size_t id = 0, tipo = 1, first_attribute = 2, material = first_attribute + attribute_words.size(),
                      uv = material + 1, tangents = uv + 1, normals = tangents + 1, motion = normals + 1;
constexpr auto keys = [] {
  std::array<std::string_view, motion + 1> all{};
  all[id] = "id";
  all[tipo] = "tipo";
  std::ranges::copy(attribute_words, all.begin() + first_attribute);
  all[material] = "material";
  std::ranges::copy(vertex_keys, all.begin() + uv);
  all[motion] = "motion";
  return all;
}();
constexpr std::size_t required = 2;  // id and tipo; which attributes there must be, the tipo says

// The value of an attribute, and where its key and the value itself stand.
struct Read {
  std::size_t key_offset, offset;
  std::variant<double, glm::dvec3, scene::Corners> value;
};

struct Fields {
  std::size_t at = 0;  // where the object stands
  Placed<std::string_view> id{};
  Tipo tipo{};
  std::array<std::optional<Read>, attribute_words.size()> attributes{};
  std::optional<Placed<std::string_view>> material{};
  std::optional<Placed<std::array<glm::dvec2, 3>>> uv{};  // at its key, as the next ones
  std::optional<Placed<std::array<scene::VertexTangents, 3>>> tangents{};
  std::optional<Placed<scene::VertexNormals>> normals{};
  glm::dvec3 motion{};

  const std::optional<Read>& attribute(std::string_view word) const {
    return attributes[static_cast<std::size_t>(std::ranges::find(attribute_words, word) - attribute_words.begin())];
  }
};

Tipo read_tipo(json::Reader& in, const WrittenElements& written) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("tipo");
  std::optional<Tipo> known;
  std::vector<std::string_view> words;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    words.push_back(Shape::word);
    if (name == Shape::word) known = Shape::tipo;
  });
  for (const WrittenType& type : written.types) words.push_back(type.word);
  if (written.bodies)
    for (const BodyTipo& body : body_tipos()) words.push_back(body.word);
  if (!known) {
    in.fail(at, fmt::format("tipo (type) is {}", text::shown(name)),
            "expected " + text::expected_of(name, {words.begin(), words.end()}));
  }
  return *known;
}

Read read_attribute(json::Reader& in, std::string_view word) {
  Read read{in.key_offset(), in.offset(), {}};
  with_attribute(word, [&]<class Attribute>(const Attribute&) {
    typename Attribute::Stored value{};
    read_json(in, word, value);
    read.value = value;
  });
  return read;
}

void read_field(json::Reader& in, std::size_t key, const WrittenElements& written, Fields& f) {
  const std::size_t at = in.offset();
  if (key == id) {
    f.id = {read_id(in), at};
  } else if (key == tipo) {
    f.tipo = read_tipo(in, written);
  } else if (key == material) {
    f.material = {in.string("material"), at};
  } else if (key == uv) {
    f.uv = {read_uv(in), in.key_offset()};
  } else if (key == tangents) {
    f.tangents = {read_vertex_tangents(in), in.key_offset()};
  } else if (key == normals) {
    f.normals = {read_vertex_normals(in), in.key_offset()};
  } else if (key == motion) {
    f.motion = in.vec3("motion");
  } else {
    f.attributes[key - first_attribute] = read_attribute(in, keys[key]);
  }
}

// The invariant that says which elements have the attribute of that word.
const contract::clause* domain_of(std::string_view word) {
  const contract::clause* domain = nullptr;
  model::for_each_attribute([&](const auto& attribute) {
    if (attribute.word == word) domain = attribute.domain;
  });
  return domain;
}

// An element of a tipo, as messages name it.
std::string element_of(std::string_view tipo) { return "an element of tipo " + text::with_english(tipo); }

// Each attribute is there if and only if the shape has it (Escena.inv.2 to Escena.inv.6, Escena.inv.9).
template <class Shape>
void check_attributes(const json::Reader& in, const Fields& f) {
  for (std::size_t i = 0; i < attribute_words.size(); ++i) {
    const auto& attribute = f.attributes[i];
    if (attribute && !has_attribute<Shape>(attribute_words[i])) {
      in.fail(attribute->key_offset,
              fmt::format("unknown key \"{}\"{} in {}", attribute_words[i], text::english_beside(attribute_words[i]),
                          element_of(Shape::word)),
              "expected the attributes of its tipo only", domain_of(attribute_words[i]));
    }
    if (!attribute && has_attribute<Shape>(attribute_words[i])) {
      in.fail(f.at,
              fmt::format("key \"{}\"{} is missing in {}", attribute_words[i], text::english_beside(attribute_words[i]),
                          element_of(Shape::word)),
              "expected it", domain_of(attribute_words[i]));
    }
  }
}

// The looks of vertices are a triangle's alone, and tangents are those of its uv.
template <class Shape>
void check_vertex_looks(const json::Reader& in, const Fields& f) {
  const auto refuse = [&](const auto& wrong, std::size_t key) {
    if (wrong)
      in.fail(wrong->offset, fmt::format("unknown key \"{}\" in {}", keys[key], element_of(Shape::word)),
              "expected the attributes of its tipo only");
  };
  if constexpr (!std::is_same_v<Shape, scene::Triangle>) {
    refuse(f.uv, uv);
    refuse(f.tangents, tangents);
    refuse(f.normals, normals);
  }
  if (f.tangents && !f.uv) in.fail(f.tangents->offset, "tangents without uv", "expected uv too");
}

void set_vertex_looks(scene::Scene& scene, const Fields& f) {
  if (!f.uv && !f.normals) return;
  const scene::ElementRef element = scene.find(f.id.value).value();
  if (f.uv) {
    scene::Wrap wrap{f.uv->value};
    if (f.tangents) wrap.tangents = f.tangents->value;
    scene.set_wrap(element, wrap);
  }
  if (f.normals) scene.set_vertex_normals(element, f.normals->value);
}

template <class Shape>
Shape shape_of(const Fields& f) {
  Shape shape{};
  scene::for_each_attribute<Shape>([&]<class Attribute>(const Attribute& attribute) {
    shape.*attribute.field = std::get<typename Attribute::Stored>(f.attribute(attribute.word)->value);
  });
  return shape;
}

// Fails at the value of an attribute that is not in the set that the text gives it: Rmas, Unitario, Vertices.
struct Check {
  const json::Reader& in;
  std::size_t at;
  std::string_view word;

  void operator()(std::type_identity<model::Rmas>, double x) const {
    if (!model::Rmas::contains(x)) fail(fmt::format("{}", x), "", model::Rmas_inv_1);
  }
  void operator()(std::type_identity<model::Vector>, const glm::dvec3& v) const {
    if (!model::Unitario::contains(model::Vector{v}))
      fail(fmt::format("({}, {}, {})", v.x, v.y, v.z), "a unit vector, ", model::Unitario_inv_1);
  }
  void operator()(std::type_identity<model::Punto>, const glm::dvec3&) const {}  // every triple is a Punto
  void operator()(std::type_identity<model::Vertices>, const scene::Corners& v) const {
    if (!model::Vertices::contains(scene::input_of<model::Terna>(v)))
      in.fail(at, fmt::format("{} is three points on one line", text::with_english(word)),
              fmt::format("expected the corners of a triangle ({})", model::Vertices_inv_1.label),
              &model::Vertices_inv_1);
  }

 private:
  void fail(const std::string& value, std::string_view kind, const contract::clause& clause) const {
    in.fail(at, fmt::format("{} is {}", text::with_english(word), value),
            fmt::format("expected {}{} ({})", kind, clause.predicate, clause.label), &clause);
  }
};

// The operation says which clause does not hold; the file's error stands at the value that breaks it.
template <class Shape>
[[noreturn]] void refuse(const json::Reader& in, const Fields& f, const model::Answer& answer) {
  if (answer.r != model::Respuesta::elemento_ya_existe) {
    scene::for_each_attribute<Shape>([&]<class Attribute>(const Attribute& attribute) {
      const Read& read = *f.attribute(attribute.word);
      Check{in, read.offset, attribute.word}(std::type_identity<typename Attribute::Value>(),
                                             std::get<typename Attribute::Stored>(read.value));
    });
  }
  in.fail(f.id.offset, fmt::format("id is {}: {}", text::shown(f.id.value), text::with_english(model::name(answer.r))),
          fmt::format("expected {} ({})", answer.violated->predicate, answer.violated->label), answer.violated);
}

}  // namespace

std::string_view read_id(json::Reader& in) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("id");
  if (!model::Elemento::is_name(name)) {
    in.fail(at, fmt::format("id is {}", text::shown(name)), "expected 1 to 128 of A-Z a-z 0-9 _ . : -");
  }
  return name;
}

WrittenShape read_shape(json::Reader& in, ShapeKeys has) {
  std::vector<std::size_t> allowed{tipo};
  if (has.id) allowed.push_back(id);
  const std::size_t required_here = allowed.size();
  for (std::size_t i = 0; i < attribute_words.size(); ++i) allowed.push_back(first_attribute + i);
  if (has.material) allowed.push_back(material);
  std::vector<std::string_view> words;
  for (const std::size_t key : allowed) words.push_back(keys[key]);
  Fields f;
  f.at = in.offset();
  in.object("a shape", words, required_here,
            [&](std::size_t key) { read_field(in, allowed[key], {.bodies = true}, f); });
  return scene::with_shape(f.tipo, [&]<class Shape>(std::type_identity<Shape>) {
    check_attributes<Shape>(in, f);
    const Shape shape = shape_of<Shape>(f);
    const model::Answer answer = scene::Scene().add(model::Elemento("shape"), shape);
    if (!answer.ok()) refuse<Shape>(in, f, answer);
    return WrittenShape{f.id, f.material, shape};
  });
}

void read_element(json::Reader& in, scene::Scene& scene, std::vector<MaterialUse>& uses,
                  const WrittenElements& written) {
  if (const auto type = written_type(in, written.types)) return read_written_element(in, *type, scene, uses, written);
  Fields f;
  f.at = in.offset();
  in.object("an element", keys, required, [&](std::size_t key) { read_field(in, key, written, f); });
  scene::with_shape(f.tipo, [&]<class Shape>(std::type_identity<Shape>) {
    check_attributes<Shape>(in, f);
    check_vertex_looks<Shape>(in, f);
    const model::Answer answer = scene.add(model::Elemento{std::string(f.id.value)}, shape_of<Shape>(f));
    if (!answer.ok()) refuse<Shape>(in, f, answer);
  });
  set_vertex_looks(scene, f);
  if (f.motion != glm::dvec3(0)) scene.set_motion(scene.find(f.id.value).value(), f.motion);
  if (f.material) uses.push_back({f.id.value, *f.material});
}

}  // namespace durero::io
