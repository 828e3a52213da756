// A scene: read, written, edited under contract and drawn.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings.hpp"
#include "durero/engine/prepared.hpp"
#include "durero/io/groups_file.hpp"
#include "durero/io/operations_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/render/render.hpp"
#include "durero/render/tone.hpp"
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
          scene::for_each_attribute<Shape>(
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

const model::Operation& asked(const scene::Edit& edit) { return edit.operation; }
const scene::GroupEdit& asked(const scene::GroupEdit& edit) { return edit; }

std::string_view word(model::Respuesta r) { return model::name(r); }
std::string_view word(std::string_view r) { return r; }

std::string done(scene::GroupedScene& scene, const io::Step& step) {
  return std::visit(
      [&](const auto& edit) {
        const auto answer = scene.apply_total(edit);
        if (answer.ok()) return std::string(word(answer.r));
        raise("Refused", std::string(answer.violated->label), std::string(answer.violated->predicate),
              std::string(word(answer.r)), operation_name(asked(edit)), inputs_of(asked(edit)), step.line);
      },
      step.edit);
}

/// Every operation of the text, or none of them.
std::vector<std::string> apply(Scene& scene, const std::string& text, const std::string& name) {
  const auto script = io::read_script(io::Source(name, text), scene.value().stage());
  if (script.size() == 1) return {done(scene.edited(), script.front())};
  std::vector<std::string> answers;
  scene::GroupedScene edited = scene.grouped();
  for (const io::Step& step : script) answers.push_back(done(edited, step));
  scene.assign(std::move(edited));
  return answers;
}

Scene read(const py::bytes& text, const std::string& name) {
  const io::Source source(name, text);
  const py::gil_scoped_release released;
  return Scene(io::read_grouped_scene(source));
}

std::string text(const Scene& scene) { return io::scene_text(scene.grouped().scene, scene.grouped().groups); }

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
  for (const scene::ElementRef element : state->numbering().elements())
    names.push_back(state->scene().name(element).name());
  return names;
}

/// Its word, its attributes and its material.
py::object element(const Scene& scene, const std::string& name) {
  const auto found = scene.value().find(name);
  if (!found) throw py::key_error(name);
  py::dict attributes;
  const std::string word = scene.value().visit(*found, [&]<class Shape>(const Shape& shape) {
    scene::for_each_attribute<Shape>([&](const auto& attribute) {
      attributes[py::str(std::string(attribute.word))] = as_python(shape.*attribute.field);
    });
    return std::string(Shape::word);
  });
  const auto material = scene.value().material(*found);
  const py::object look = material ? py::object(py::str(scene.value().stage().materials[*material].name)) : py::none();
  return py::make_tuple(word, attributes, look);
}

using Size = std::optional<std::pair<std::uint32_t, std::uint32_t>>;

py::array render(const Scene& scene, const Size& size, const std::string& engine_name, const std::string& hierarchy) {
  const engine::Row& row = engine_named(engine_name);
  if (!row.honours_origins)
    throw std::invalid_argument("engine " + engine_name +
                                ": shadow rays start on elements, of which it knows nothing; expected another");
  const auto state = scene.state();
  const auto image = [&] {
    const py::gil_scoped_release released;
    if (!size)
      return std::make_unique<render::Image>(
          render::toned(render::render(state->scene(), state->prepared(row, hierarchy)), render::Tone::clamp));
    scene::GroupedScene sized = state->grouped();
    sized.scene.stage().resolution = scene::Resolution{size->first, size->second};
    return std::make_unique<render::Image>(
        render::toned(render::render(sized.scene, *engine::prepared(row, hierarchy, sized)), render::Tone::clamp));
  }();
  const py::ssize_t height = image->resolution.height, width = image->resolution.width;
  auto* const pixels = new std::vector<std::uint8_t>(std::move(image->rgb));
  const py::capsule owner(pixels, [](void* held) { delete static_cast<std::vector<std::uint8_t>*>(held); });
  return py::array_t<std::uint8_t>({height, width, py::ssize_t{3}}, pixels->data(), owner);
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
      .def("groups", groups)
      .def("text", text)
      .def("save", [](const Scene& scene, const std::string& path) { io::write_file(path, text(scene)); })
      .def("render", render);
  module.def("read_scene", read);
}

}  // namespace durero::python
