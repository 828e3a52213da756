#include "durero/written/edited.hpp"

#include <fmt/format.h>

#include "durero/io/json/groups_file.hpp"
#include "durero/scene/addition.hpp"

namespace durero::written {
namespace {

scene::Edit removal_of(const std::string& name) { return {model::Eliminar_Elemento{model::Elemento{name}}, {}}; }

std::string answer_word(model::Respuesta r) { return std::string(model::name(r)); }

/// @{ The element that an edit concerns; null where it concerns none.
const std::string* element_of(const scene::Edit& edit) { return &scene::name_of(edit.operation).name(); }
const std::string* element_of(const io::WrittenEdit& edit) {
  const auto* const in = std::get_if<io::WrittenAddition>(&edit);
  return in == nullptr ? &std::get<io::WrittenRemoval>(edit).e : &in->element.id;
}
const std::string* element_of(const scene::GroupEdit&) { return nullptr; }
const std::string* element_of(const scene::Closing&) { return nullptr; }
/// @}

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

template <class MakeSurface>
io::EditAnswer Edited::add_if_given(const scene::Edit& edit, MakeSurface make) {
  const model::Answer answer = of_.apply_total(edit);
  if (!answer.ok()) return io::edit_answer(answer);
  const auto undo = [&] { of_.apply_total(removal_of(scene::name_of(edit.operation).name())); };
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
  if (!text_) return io::edit_answer(of_.apply_total(edit));
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

io::EditAnswer Edited::apply_total(const io::ScriptStep& step) {
  return std::visit(
      [&](const auto& edit) {
        const std::string* const name = element_of(edit);
        if (name == nullptr) return apply_total(edit);
        std::string was_in(of_.groups.of_element(*name));
        io::EditAnswer answer = apply_total(edit);
        if (answer.ok()) answer.left_group = left_group(*name, std::move(was_in));
        return answer;
      },
      step.edit);
}

std::pair<model::Answer, io::EditAnswer> Edited::apply_own(const scene::Edit& edit) {
  const std::string& name = *element_of(edit);
  std::string was_in(of_.groups.of_element(name));
  const model::Answer answer = of_.apply_total(edit);
  std::pair told(answer, io::edit_answer(answer));
  if (answer.ok()) told.second.left_group = left_group(name, std::move(was_in));
  return told;
}

std::string Edited::left_group(const std::string& name, std::string was_in) {
  if (!of_.scene.find(name)) {
    if (!was_in.empty()) left_.insert_or_assign(name, was_in);
    return was_in;
  }
  const auto left = left_.extract(name);
  return left.empty() || !of_.groups.table().contains(left.mapped()) ? "" : left.mapped();
}

io::EditAnswer Edited::apply_total(const scene::Closing& in) {
  const scene::Lids lids = scene::lids(of_.scene, in);
  if (lids.violated != nullptr) return io::edit_answer(scene::Outcome{"not_closed", lids.violated});
  std::size_t added = 0;
  const auto undo = [&] {
    while (added > 0) of_.apply_total(removal_of(scene::name_of(lids.additions[--added].operation).name()));
  };
  try {
    for (const scene::Edit& lid : lids.additions) {
      io::EditAnswer answer = apply_total(lid);
      if (!answer.ok()) {
        undo();
        return answer;
      }
      ++added;
    }
  } catch (...) {
    undo();
    throw;
  }
  return {lids.exact ? "closed" : "closed_but_for_rounding"};
}

io::EditAnswer Edited::apply_total(const io::WrittenEdit& edit) {
  if (const auto* const in = std::get_if<io::WrittenAddition>(&edit)) return add(*in);
  return remove(std::get<io::WrittenRemoval>(edit));
}

io::EditAnswer Edited::add(const io::WrittenAddition& in) {
  const auto make = [&] {
    surface_of(*text_, in.element);
    elements_.emplace(in.element.id, in.element);
  };
  io::EditAnswer answer =
      add_if_given({scene::addition(model::Elemento{in.element.id}, io::stand_in), in.material}, make);
  if (answer.ok()) answer.r = answer_word(model::Respuesta::elemento_agregado);
  return answer;
}

io::EditAnswer Edited::remove(const io::WrittenRemoval& in) {
  const io::WrittenElement* const element = written(in.e);
  const std::string& word = types()[in.type].word;
  if (of_.scene.find(in.e) && (element == nullptr || element->type != in.type))
    return {answer_word(model::Respuesta::tipo_incorrecto), fmt::format("{}.pre.1", io::removal_name(word)),
            fmt::format("de_que_tipo(e?) = soy_{}", word)};
  return apply_total(removal_of(in.e));
}

std::unique_ptr<const engine::Engine> Edited::engine() const { return prepared(of_.scene, elements_, *text_); }

std::string Edited::scene_text() const { return io::scene_text(of_.scene, of_.groups, {types(), &elements_}); }

}  // namespace durero::written
