// A scene: read, written, edited under contract and drawn.
#include <fmt/core.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <stdexcept>

#include "bindings.hpp"
#include "durero/composed/engine.hpp"
#include "durero/io/exported_files.hpp"
#include "durero/io/formats.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/operation_text.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pov/algebraic.hpp"
#include "durero/model/historia.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/copying.hpp"
#include "durero/scene/stage.hpp"
#include "errors.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

py::object as_python(double x) { return py::float_(x); }
py::object as_python(const glm::dvec3& v) { return py::make_tuple(v.x, v.y, v.z); }
py::object as_python(const scene::Corners& v) {
  return py::make_tuple(as_python(v[0]), as_python(v[1]), as_python(v[2]));
}

/// The operation as a script has it: its total name without the ending.
std::string operation_name(const model::Operation& operation) {
  constexpr std::string_view ending = "_Total";
  return std::visit(
      [&](const auto& in) {
        const std::string_view total = std::decay_t<decltype(in)>::total;
        return std::string(total.substr(0, total.size() - ending.size()));
      },
      operation);
}

/// The inputs of the operation, by their names without `?`.
py::dict inputs_of(const model::Operation& operation) {
  py::dict inputs;
  const auto set = [&](std::string_view name, const py::object& value) { inputs[py::str(std::string(name))] = value; };
  std::visit(
      [&]<class In>(const In& in) {
        set("e", py::str(in.e.name()));
        using Shape = scene::ShapeAddedBy<In>;
        if constexpr (!std::is_void_v<Shape>) {
          scene::for_each_input<Shape>(
              [&](const auto& attribute) { set(attribute.word, as_python(scene::stored(in.*attribute.input))); });
        } else if constexpr (std::is_same_v<In, model::Agregar_Elemento>) {
          set("t", py::str(std::string(model::name(in.t))));
          model::for_each_attribute([&](const auto& attribute) {
            if (const auto& value = attribute.input(in)) set(attribute.word, as_python(scene::stored(*value)));
          });
        }
      },
      operation);
  return inputs;
}

std::string operation_name(const scene::GroupEdit& edit) {
  return std::holds_alternative<scene::Grouping>(edit) ? "group" : "ungroup";
}

py::dict inputs_of(const scene::GroupEdit& edit) {
  py::dict inputs;
  std::visit([&](const auto& in) { inputs["g"] = in.g; }, edit);
  if (const auto* in = std::get_if<scene::Grouping>(&edit)) {
    inputs["elementos"] = std::vector(in->of.elementos.begin(), in->of.elementos.end());
    inputs["groups"] = std::vector(in->of.groups.begin(), in->of.groups.end());
  }
  return inputs;
}

/// What was asked: its operation, and that one's inputs.
using Asked = std::pair<std::string, py::dict>;

Asked asked(const scene::Edit& edit, const written::Edited&) {
  return {operation_name(edit.operation), inputs_of(edit.operation)};
}

Asked asked(const scene::GroupEdit& edit, const written::Edited&) { return {operation_name(edit), inputs_of(edit)}; }

Asked asked(const scene::Closing& in, const written::Edited&) {
  py::dict inputs;
  inputs["e"] = in.e;
  inputs["base"] = in.base;
  inputs["top"] = in.top;
  return {"close", inputs};
}

py::object as_python(const model::ExactVector& v) {
  const auto number = [](const number::Rational& entry) { return number::round_to_binary64(entry); };
  return py::make_tuple(number(v.x), number(v.y), number(v.z));
}

Asked asked(const scene::Copying& in, const written::Edited&) {
  py::dict inputs;
  inputs["e"] = in.e;
  inputs["de"] = in.de;
  inputs["centro"] = as_python(in.mapa.centro);
  inputs["x"] = as_python(in.mapa.x);
  inputs["y"] = as_python(in.mapa.y);
  inputs["z"] = as_python(in.mapa.z);
  return {"Agregar_Instancia", inputs};
}

Asked asked(const scene::CopyRemoval& in, const written::Edited&) {
  py::dict inputs;
  inputs["e"] = in.e;
  return {"Eliminar_Instancia", inputs};
}

Asked asked(const scene::Joining& in, const written::Edited&) {
  py::dict inputs;
  inputs["e"] = in.e;
  inputs["de"] = in.de;
  const scene::Body joined{scene::Compound{in.operation, {}}};
  return {io::addition_name(scene::word_of(joined)), inputs};
}

Asked asked(const scene::MeshEdit& edit, const written::Edited&) {
  py::dict inputs;
  const auto name = [&](const model::Elemento& m) { inputs["m"] = m.name(); };
  return std::visit(
      [&]<class In>(const In& in) -> Asked {
        if constexpr (std::is_same_v<In, scene::VertexMove>) {
          name(in.m);
          inputs["n"] = in.n;
          inputs["punto"] = as_python(in.punto.xyz());
          return {"Mover_Vertice", inputs};
        } else if constexpr (std::is_same_v<In, scene::MeshRemoval>) {
          name(in.m);
          return {"Eliminar_Malla", inputs};
        } else {
          name(in.mesh.m);
          return {std::is_same_v<In, scene::MeshAddition> ? "Agregar_Malla" : "Reemplazar_Malla", inputs};
        }
      },
      edit);
}

Asked asked(const model::AttributeChange& change, const written::Edited&) {
  return std::visit(
      [&]<class Change>(const Change& in) {
        const auto& attribute = model::attribute_of<Change::component>();
        py::dict inputs;
        inputs["e"] = in.e.name();
        inputs[py::str(std::string(attribute.word))] = as_python(scene::stored(attribute.input(in)));
        return Asked{model::schema_name(change), inputs};
      },
      change);
}

Asked asked(const model::LookChange& change, const written::Edited&) {
  return std::visit(
      [](const auto& in) {
        py::dict inputs;
        inputs["e"] = in.e.name();
        if constexpr (requires { in.material; }) inputs["material"] = in.material;
        if constexpr (requires { in.g; }) inputs["g"] = in.g;
        return Asked{std::string(in.schema), inputs};
      },
      change);
}

Asked asked(const scene::SolidRemoval& in, const written::Edited&) {
  py::dict inputs;
  inputs["e"] = in.e;
  return {"Eliminar_Solido", inputs};
}

py::dict attributes_of(const io::WrittenElement& element, const io::WrittenType& type) {
  py::dict attributes;
  for (std::size_t i = 0; i < type.attributes.size(); ++i)
    std::visit([&](const auto& value) { attributes[py::str(type.attributes[i].word)] = as_python(value); },
               element.values[i]);
  return attributes;
}

Asked asked(const io::WrittenEdit& edit, const written::Edited& scene) {
  if (const auto* const out = std::get_if<io::WrittenRemoval>(&edit)) {
    py::dict inputs;
    inputs["e"] = out->e;
    return {io::removal_name(scene.types()[out->type].word), inputs};
  }
  const io::WrittenElement& element = std::get<io::WrittenAddition>(edit).element;
  const io::WrittenType& type = scene.types()[element.type];
  py::dict inputs = attributes_of(element, type);
  inputs["e"] = element.id;
  return {io::addition_name(type.word), inputs};
}

/// r!, and the group that is left.
using Done = std::pair<std::string, std::string>;

/// What an edit answered, or Refused.
Done done(const Scene& scene, const io::ScriptStep& step, const io::EditAnswer& answer) {
  if (answer.ok()) return {answer.r, answer.left_group};
  const auto [operation, inputs] = std::visit([&](const auto& edit) { return asked(edit, scene.whole()); }, step.edit);
  raise("Refused", answer.violated, answer.predicate, answer.r, operation, inputs, step.line);
}

/// Every operation of the text, or none of them.
std::vector<Done> apply(Scene& scene, const std::string& text, const std::string& name) {
  const auto script = io::read_script(io::Source(name, text), scene.value().stage(), scene.whole().types());
  const auto all = scene.history().apply_all(scene.edited(), script);
  std::vector<Done> answers;
  for (std::size_t i = 0; i < all.size(); ++i) answers.push_back(done(scene, script[i], all[i]));
  return answers;
}

/// The lines of a step's edits.
std::vector<std::string> lines_of(const Scene& scene, const io::HistoryStep& step) {
  std::vector<std::string> lines;
  for (const io::ScriptStep& edit : step.edits)
    lines.push_back(io::operation_text(edit, scene.value().stage(), scene.whole().types()));
  return lines;
}

/// The steps that are done, in order.
std::vector<std::vector<std::string>> history(const Scene& scene) {
  std::vector<std::vector<std::string>> steps;
  for (const io::HistoryStep& step : scene.history().done()) steps.push_back(lines_of(scene, step));
  return steps;
}

void require_transaction(const Scene& scene, bool is_open) {
  if (scene.history().is_open() == is_open) return;
  throw std::runtime_error(is_open ? "no transaction is open" : "a transaction is open; expected its end before");
}

std::string undo(Scene& scene) {
  require_transaction(scene, false);
  if (!scene.history().undo(scene.edited()))
    raise_refused(model::Deshacer_pre_1, model::Respuesta::nada_que_deshacer, "Deshacer");
  return std::string(model::name(model::Respuesta::deshecho));
}

std::string redo(Scene& scene) {
  require_transaction(scene, false);
  if (!scene.history().redo(scene.edited()))
    raise_refused(model::Rehacer_pre_1, model::Respuesta::nada_que_rehacer, "Rehacer");
  return std::string(model::name(model::Respuesta::rehecho));
}

/// Of the program's own shapes, or by a Z text.
Scene read(const py::bytes& text, const std::string& name, const std::optional<std::string>& surfaces) {
  const io::Source source(name, text);
  const py::gil_scoped_release released;
  if (!surfaces) return Scene(io::read_grouped_scene(source, io::Bodies::read));
  return Scene(written::Edited(source, std::make_shared<const written::Text>(*surfaces)));
}

std::string text(const Scene& scene) { return scene.whole().scene_text(); }

/// The file of the Z text that it was read by.
std::optional<std::string> surfaces(const Scene& scene) {
  if (scene.whole().text() == nullptr) return std::nullopt;
  return scene.whole().text()->file();
}

/// By name what is directly in each.
std::map<std::string, std::pair<std::vector<std::string>, std::vector<std::string>>> groups(const Scene& scene) {
  std::map<std::string, std::pair<std::vector<std::string>, std::vector<std::string>>> all;
  for (const auto& [name, group] : scene.grouped().groups.table())
    all[name] = {{group.elementos.begin(), group.elementos.end()}, {group.groups.begin(), group.groups.end()}};
  return all;
}

std::vector<std::string> names(const Scene& scene) {
  const auto state = scene.state();
  std::vector<std::string> names;
  for (std::int32_t i = 0; i < state->numbering().size(); ++i)
    names.push_back(state->scene().name(state->numbering().element(i)).name());
  return names;
}

template <class Shape>
std::pair<std::string, py::dict> word_and_attributes(const Shape& shape) {
  py::dict attributes;
  scene::for_each_attribute<Shape>([&](const auto& attribute) {
    attributes[py::str(std::string(attribute.word))] = as_python(shape.*attribute.field);
  });
  return {std::string(Shape::word), attributes};
}

/// An entry of a map: a number, or a Fraction where it is no binary64.
py::object entry_of(const number::Rational& entry) {
  const double rounded = number::round_to_binary64(entry);
  if (std::isfinite(rounded) && number::exact(rounded) == entry) return py::float_(rounded);
  return py::module_::import("fractions").attr("Fraction")(entry.str());
}

/// `de`, a dictionary with the tipo of the original, and `mapa`, three rows of four entries.
py::dict attributes_of(const scene::Instance& instance) {
  auto [word, original] = std::visit([](const auto& shape) { return word_and_attributes(shape); }, instance.shape);
  original["tipo"] = word;
  py::dict attributes;
  attributes["de"] = original;
  const model::Mapa& m = instance.mapa;
  const auto row = [&](auto coordinate) {
    return py::make_tuple(entry_of(coordinate(m.x)), entry_of(coordinate(m.y)), entry_of(coordinate(m.z)),
                          entry_of(coordinate(m.centro)));
  };
  attributes["mapa"] = py::make_tuple(row([](const auto& v) { return v.x; }), row([](const auto& v) { return v.y; }),
                                      row([](const auto& v) { return v.z; }));
  return attributes;
}

py::dict attributes_of(const scene::Compound& solid);

/// A part with its tipo; of a shape that no map has moved its own attributes.
py::dict part_of(const scene::Body& body) {
  const auto* const instance = std::get_if<scene::Instance>(&body.form);
  if (instance != nullptr && model::identidad(instance->mapa)) {
    auto [word, attributes] = std::visit([](const auto& shape) { return word_and_attributes(shape); }, instance->shape);
    attributes["tipo"] = word;
    return attributes;
  }
  py::dict attributes = std::visit([](const auto& form) { return attributes_of(form); }, body.form);
  attributes["tipo"] = std::string(scene::word_of(body));
  return attributes;
}

/// `de`, a dictionary for each part.
py::dict attributes_of(const scene::Compound& solid) {
  py::list parts;
  for (const scene::Body& part : solid.parts) parts.append(part_of(part));
  py::dict attributes;
  attributes["de"] = parts;
  return attributes;
}

std::pair<std::string, py::dict> word_and_attributes(const written::Edited& scene, const std::string& name,
                                                     scene::ElementRef element) {
  if (const io::WrittenElement* const own = scene.written(name)) {
    const io::WrittenType& type = scene.types()[own->type];
    return {type.word, attributes_of(*own, type)};
  }
  if (const scene::Body* const body = scene.of().scene.body(element))
    return {std::string(scene::word_of(*body)),
            std::visit([](const auto& form) { return attributes_of(form); }, body->form)};
  return scene.of().scene.visit(element, [](const auto& shape) { return word_and_attributes(shape); });
}

/// Its word, its attributes and its material.
py::object element(const Scene& scene, const std::string& name) {
  const auto found = scene.value().find(name);
  if (!found) throw py::key_error(name);
  const auto [word, attributes] = word_and_attributes(scene.whole(), name, *found);
  const auto material = scene.value().material(*found);
  const py::object look = material ? py::object(py::str(scene.value().stage().materials[*material].name)) : py::none();
  return py::make_tuple(word, attributes, look);
}

using Size = std::optional<std::pair<std::uint32_t, std::uint32_t>>;

py::array render(const Scene& scene, const Size& size, const std::string& engine_name, const std::string& hierarchy) {
  const auto state = scene.state();
  const engine::EngineRow& row = engine_named(*state, engine_name);
  if (!row.honours_origins)
    throw std::invalid_argument("engine " + engine_name +
                                ": shadow rays start on elements, of which it knows nothing; expected another");
  const auto image = [&] {
    const py::gil_scoped_release released;
    if (!size)
      return std::make_unique<render::Image>(
          render::toned(render::render(state->scene(), state->prepared(row, hierarchy)), render::Tone::clamp));
    scene::GroupedScene sized = state->grouped();
    sized.scene.stage().resolution = scene::Resolution{size->first, size->second};
    const bool by_text = state->value().text() != nullptr;  // what answers by it refers to no scene
    const auto of_pixels = by_text ? nullptr : composed::prepared(row, hierarchy, sized);
    return std::make_unique<render::Image>(render::toned(
        render::render(sized.scene, by_text ? state->prepared(row, hierarchy) : *of_pixels), render::Tone::clamp));
  }();
  const py::ssize_t height = image->resolution.height, width = image->resolution.width;
  auto* const pixels = new std::vector<std::uint8_t>(std::move(image->rgb));
  const py::capsule owner(pixels, [](void* held) { delete static_cast<std::vector<std::uint8_t>*>(held); });
  return py::array_t<std::uint8_t>({height, width, py::ssize_t{3}}, pixels->data(), owner);
}

/// Checks that a text has the types that elements are of, before they are read by it.
void require_types(const written::Text& text, const io::WrittenByName& surfaces) {
  for (const auto& [name, element] : surfaces) {
    const io::WrittenType& type = io::algebraic_types()[element.type];
    if (std::ranges::find(text.types(), type) == text.types().end())
      throw std::invalid_argument(
          fmt::format("{} declares no {} as POV-Ray's surfaces need it; expected a text such as "
                      "demo/surfaces/algebraic.tex",
                      text.file(), type.word));
  }
}

/// The scene of a file in any format, and what it lost on the way; perhaps by a Z text.
std::pair<Scene, std::vector<std::string>> import_file(const std::string& path, const std::string& root,
                                                       std::optional<bool> in_meshes,
                                                       const std::optional<std::string>& surfaces) {
  const py::gil_scoped_release released;
  io::Imported read = io::import_file(path, {.root = root, .keeps_surfaces = surfaces.has_value()}, in_meshes);
  if (!surfaces)
    return {Scene(scene::GroupedScene{std::move(read.scene), std::move(read.groups)}), std::move(read.lost)};
  const auto text = std::make_shared<const written::Text>(*surfaces);
  require_types(*text, read.surfaces);
  const io::Source whole(path, io::scene_text(read.scene, read.groups, {io::algebraic_types(), &read.surfaces}));
  return {Scene(written::Edited(whole, text)), std::move(read.lost)};
}

/// Writes a scene in the format that the name tells. What it loses.
std::vector<std::string> export_file(const Scene& scene, const std::string& path, bool binary) {
  const auto state = scene.state();
  require_own_shapes(*state, "export_file");
  const py::gil_scoped_release released;
  io::ExportedFiles out(path, "");
  const io::Exported exported = io::exported_scene(path, state->scene(), state->grouped().groups, binary);
  out.write(exported);
  return exported.lost;
}

}  // namespace

void add_scene(py::module_& module) {
  py::class_<Scene>(module, "Scene")
      .def(py::init([] { return Scene(scene::GroupedScene()); }))
      .def("size", [](const Scene& scene) { return scene.value().size(); })
      .def("contains", [](const Scene& scene, const std::string& name) { return scene.value().find(name).has_value(); })
      .def("names", names)
      .def("element", element)
      .def("materials",
           [](const Scene& scene) {
             std::vector<std::string> names;
             for (const scene::Material& material : scene.value().stage().materials) names.push_back(material.name);
             return names;
           })
      .def("copy", [](const Scene& scene) { return scene; })
      .def("apply", apply)
      .def("undo", undo)
      .def("redo", redo)
      .def("history", history)
      .def("last_step",
           [](const Scene& scene, bool undone) {
             return lines_of(scene, undone ? scene.history().undone().back() : scene.history().done().back());
           })
      .def("in_transaction", [](const Scene& scene) { return scene.history().is_open(); })
      .def("begin",
           [](Scene& scene) {
             require_transaction(scene, false);
             scene.history().begin();
           })
      .def("commit",
           [](Scene& scene) {
             require_transaction(scene, true);
             scene.history().commit();
           })
      .def("roll_back",
           [](Scene& scene) {
             require_transaction(scene, true);
             scene.history().roll_back(scene.edited());
           })
      .def("groups", groups)
      .def("surfaces", surfaces)
      .def("text", text)
      .def("save", [](const Scene& scene, const std::string& path) { io::write_file(path, text(scene)); })
      .def("render", render);
  module.def("read_scene", read);
  module.def("import_file", import_file);
  module.def("export_file", export_file);
}

}  // namespace durero::python
