#include "durero/written/edited.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "durero/io/json/groups_file.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"

namespace durero::written {
namespace {

std::string answer_word(model::Respuesta r) { return std::string(model::name(r)); }

/// The answer of a change to an element of a type of the text, which has no attribute of the program's own.
model::Answer no_attribute(const model::AttributeChange& change) {
  return std::visit(
      [](const auto& in) {
        return model::Answer{model::Respuesta::tipo_incorrecto,
                             in.of_type ? &model::of_type_clause(*in.of_type) : in.has_attribute};
      },
      change);
}

}  // namespace

Edited::Edited(const io::Source& source, std::shared_ptr<const Text> text) : text_(std::move(text)) {
  Written read = written::read(source, *text_);
  of_.groups = io::read_groups(source, read.scene);
  of_.scene = std::move(read.scene);
  elements_ = std::move(read.elements);
}

std::span<const io::WrittenType> Edited::types() const {
  if (!text_) return {};
  return text_->types();
}

const io::WrittenElement* Edited::written(std::string_view name) const {
  const auto found = elements_.find(name);
  return found == elements_.end() ? nullptr : &found->second;
}

std::optional<io::WrittenElement> Edited::written_record(const std::string& name) const {
  const io::WrittenElement* const element = written(name);
  return element == nullptr ? std::nullopt : std::optional(*element);
}

void Edited::set_written(const std::string& name, std::optional<io::WrittenElement> element) {
  if (element)
    elements_.insert_or_assign(name, *std::move(element));
  else
    elements_.erase(name);
}

template <class MakeSurface>
io::EditAnswer Edited::add_if_given(const scene::Edit& edit, MakeSurface make) {
  const model::Answer answer = of_.apply_total(edit);
  if (!answer.ok()) return io::edit_answer(answer);
  const auto undo = [&] { of_.apply_total(io::removal_of(scene::name_of(edit.operation).name())); };
  try {
    make();
    return io::edit_answer(answer);
  } catch (const NotInDomain& refused) {
    undo();
    return {"not_in_domain", fmt::format("puntos_{}.dom", refused.type), refused.expected};
  } catch (...) {
    undo();
    throw;
  }
}

io::EditAnswer Edited::apply_total(const scene::Edit& edit) {
  if (!text_) return EditedScene::apply_total(edit);
  const std::string& name = scene::name_of(edit.operation).name();
  const bool stands_in = elements_.contains(name);
  if (stands_in && std::holds_alternative<model::Eliminar_Esfera>(edit.operation))  // it is no sphere
    return io::edit_answer(model::Answer{model::Respuesta::tipo_incorrecto, &model::Eliminar_Esfera_pre_1});
  if (of_.scene.find(name)) {
    const model::Answer answer = of_.apply_total(edit);
    if (answer.ok() && stands_in) elements_.erase(name);
    return io::edit_answer(answer);
  }
  return add_if_given(edit, [&] { surface_of(*text_, of_.scene, of_.scene.find(name).value()); });
}

io::EditAnswer Edited::apply_total(const io::WrittenEdit& edit) {
  if (const auto* const in = std::get_if<io::WrittenAddition>(&edit)) return add(*in);
  return remove(std::get<io::WrittenRemoval>(edit));
}

io::EditAnswer Edited::apply_total(const scene::Copying& edit) {
  if (text_) throw std::domain_error(edit.e + " is an instance beside a Z text; expected types of the text alone");
  return EditedScene::apply_total(edit);
}

io::EditAnswer Edited::apply_total(scene::MeshEdit edit) {
  if (text_) throw std::domain_error("a mesh is edited beside a Z text; expected types of the text alone");
  return EditedScene::apply_total(std::move(edit));
}

/// Changes an attribute, and then makes the surface: where the text gives none, the change is undone.
io::EditAnswer Edited::apply_total(const model::AttributeChange& change) {
  const std::string& name = model::name_of(change).name();
  if (stands_in(name)) return io::edit_answer(no_attribute(change));
  if (!text_) return EditedScene::apply_total(change);
  const scene::Scene before = of_.scene;
  const model::Answer answer = of_.change_total(change);
  if (!answer.ok()) return io::edit_answer(answer);
  try {
    surface_of(*text_, of_.scene, of_.scene.find(name).value());
    return io::edit_answer(answer);
  } catch (const NotInDomain& refused) {
    of_.scene = before;
    return {"not_in_domain", fmt::format("puntos_{}.dom", refused.type), refused.expected};
  } catch (...) {
    of_.scene = before;
    throw;
  }
}

io::EditAnswer Edited::apply_total(const scene::Joining& edit) {
  if (text_) throw std::domain_error(edit.e + " is a solid beside a Z text; expected types of the text alone");
  return EditedScene::apply_total(edit);
}

io::EditAnswer Edited::add(const io::WrittenAddition& in) {
  const auto make = [&] {
    surface_of(*text_, in.element);
    elements_.emplace(in.element.id, in.element);
  };
  io::EditAnswer answer =
      add_if_given({scene::addition(model::Elemento{in.element.id}, scene::stand_in), in.material}, make);
  if (answer.ok()) answer.r = answer_word(model::Respuesta::elemento_agregado);
  return answer;
}

io::EditAnswer Edited::remove(const io::WrittenRemoval& in) {
  const io::WrittenElement* const element = written(in.e);
  const std::string& word = types()[in.type].word;
  if (of_.scene.find(in.e) && (element == nullptr || element->type != in.type))
    return {answer_word(model::Respuesta::tipo_incorrecto), fmt::format("{}.pre.1", io::removal_name(word)),
            fmt::format("de_que_tipo(e?) = soy_{}", word)};
  return apply_total(io::removal_of(in.e));
}

std::unique_ptr<const engine::Engine> Edited::engine() const { return prepared(of_.scene, elements_, *text_); }

std::string Edited::scene_text() const { return io::scene_text(of_.scene, of_.groups, {types(), &elements_}); }

}  // namespace durero::written
