#include "durero/io/json/edit_history.hpp"

#include <ranges>

#include "durero/scene/edit.hpp"

namespace durero::io {
namespace {

/// @{ The names of the elements that an edit changes.
std::vector<std::string> changed_by(const scene::Edit& edit) { return {scene::name_of(edit.operation).name()}; }
std::vector<std::string> changed_by(const scene::Closing& edit) { return {edit.base, edit.top}; }
std::vector<std::string> changed_by(const WrittenEdit& edit) {
  if (const auto* const in = std::get_if<WrittenAddition>(&edit)) return {in->element.id};
  return {std::get<WrittenRemoval>(edit).e};
}
std::vector<std::string> changed_by(const scene::Copying& edit) { return {edit.e}; }
std::vector<std::string> changed_by(const scene::CopyRemoval& edit) { return {edit.e}; }
std::vector<std::string> changed_by(const scene::Joining& edit) { return {edit.e}; }
std::vector<std::string> changed_by(const scene::SolidRemoval& edit) { return {edit.e}; }
std::vector<std::string> changed_by(const model::AttributeChange& edit) { return {model::name_of(edit).name()}; }
std::vector<std::string> changed_by(const model::LookChange& edit) { return {model::name_of(edit).name()}; }
std::vector<std::string> changed_by(const scene::GroupEdit&) { return {}; }
std::vector<std::string> changed_by(const scene::MeshEdit&) { return {}; }
/// @}

model::Elemento mesh_of(const scene::MeshEdit& edit) {
  return std::visit(
      [](const auto& in) {
        if constexpr (requires { in.mesh; })
          return in.mesh.m;
        else
          return in.m;
      },
      edit);
}

EditRecord record_before(const EditedScene& scene, const ScriptStep& edit) {
  EditRecord record;
  for (const std::string& name : std::visit([](const auto& of) { return changed_by(of); }, edit.edit)) {
    record.elements.push_back(scene::record_of(scene.of(), name));
    record.written.emplace_back(name, scene.written_record(name));
  }
  if (const auto* const of = std::get_if<scene::MeshEdit>(&edit.edit))
    record.mesh = scene::mesh_record_of(scene.of(), mesh_of(*of));
  if (std::holds_alternative<scene::GroupEdit>(edit.edit)) record.groups = scene.of().groups;
  return record;
}

void undo_all(EditedScene& scene, const HistoryStep& step) {
  for (const EditRecord& record : step.records | std::views::reverse) scene.restore(record);
}

}  // namespace

EditAnswer EditHistory::apply_total(EditedScene& scene, const ScriptStep& edit) {
  return apply_by(scene, edit, [](EditedScene& of, const ScriptStep& step) { return of.apply_total(step); });
}

EditAnswer EditHistory::apply_by(EditedScene& scene, const ScriptStep& edit, const CarryOutEdit& carry_out) {
  EditRecord record = record_before(scene, edit);
  EditAnswer answer = carry_out(scene, edit);
  if (!answer.ok()) return answer;
  HistoryStep one;
  HistoryStep& step = open_ ? *open_ : one;
  step.edits.push_back(edit);
  step.records.push_back(std::move(record));
  if (open_) return answer;
  keep(std::move(one));
  return answer;
}

void EditHistory::begin() { open_.emplace(); }

void EditHistory::commit() {
  if (!open_->edits.empty()) keep(*std::move(open_));
  open_.reset();
}

void EditHistory::roll_back(EditedScene& scene) {
  roll_back_to(scene, 0);
  open_.reset();
}

void EditHistory::roll_back_to(EditedScene& scene, std::size_t edits) {
  while (open_->edits.size() > edits) {
    scene.restore(open_->records.back());
    open_->records.pop_back();
    open_->edits.pop_back();
  }
}

std::vector<EditAnswer> EditHistory::apply_all(EditedScene& scene, std::span<const ScriptStep> edits) {
  const bool is_part = is_open();
  if (!is_part) begin();
  const std::size_t before = open_->edits.size();
  const auto give_up = [&] {
    roll_back_to(scene, before);
    if (!is_part) open_.reset();
  };
  std::vector<EditAnswer> answers;
  try {
    for (const ScriptStep& edit : edits) {
      answers.push_back(apply_total(scene, edit));
      if (answers.back().ok()) continue;
      give_up();
      return answers;
    }
  } catch (...) {
    give_up();
    throw;
  }
  if (!is_part) commit();
  return answers;
}

void EditHistory::keep(HistoryStep step) {
  done_.push_back(std::move(step));
  if (done_.size() > most_) done_.pop_front();
  undone_.clear();
}

bool EditHistory::undo(EditedScene& scene) {
  if (done_.empty()) return false;
  undo_all(scene, done_.back());
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  return true;
}

// The edits were done on a scene like this one, so each is done again: Historia.inv.2.
bool EditHistory::redo(EditedScene& scene) {
  if (undone_.empty()) return false;
  for (const ScriptStep& edit : undone_.back().edits) scene.apply_total(edit);
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  return true;
}

void EditHistory::clear() {
  done_.clear();
  undone_.clear();
}

}  // namespace durero::io
