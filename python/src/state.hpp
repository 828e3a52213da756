#pragma once
/// A scene as Python holds it: what reads it shares it, and an edit waits for nobody.

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/io/json/edit_history.hpp"
#include "durero/written/edited.hpp"

namespace durero::python {

/// The elements of a scene, numbered from 0: those by themselves in the order of their names, then the faces of meshes,
/// mesh by mesh in the order of their names. An array knows an element by its number.
class Numbering {
 public:
  explicit Numbering(const scene::Scene& scene);

  std::int32_t size() const noexcept { return size_; }
  /// Precondition: 0 ≤ number < size().
  scene::ElementRef element(std::int32_t number) const noexcept {
    const auto place = static_cast<std::size_t>(number);
    if (place < singles_.size()) return singles_[place];
    return {scene::Triangle::tipo, static_cast<std::uint32_t>(place - singles_.size() + triangles())};
  }
  std::int32_t number(scene::ElementRef element) const noexcept {
    const std::vector<std::int32_t>& of_type = numbers_[static_cast<std::size_t>(element.tipo)];
    if (element.index < of_type.size()) return of_type[element.index];
    return static_cast<std::int32_t>(element.index - triangles() + singles_.size());
  }

 private:
  /// The triangles that are in no mesh.
  std::size_t triangles() const noexcept { return numbers_[static_cast<std::size_t>(scene::Triangle::tipo)].size(); }

  std::int32_t size_;
  std::vector<scene::ElementRef> singles_;                             // the elements in no mesh, by number
  std::array<std::vector<std::int32_t>, scene::shape_count> numbers_;  // of these
};

/// A scene, and what answers need beside it, which is made when it is first asked for. Any thread may ask.
class State {
 public:
  explicit State(written::Edited value) : value_(std::move(value)) {}

  const written::Edited& value() const noexcept { return value_; }
  const scene::GroupedScene& grouped() const noexcept { return value_.of(); }
  const scene::Scene& scene() const noexcept { return grouped().scene; }
  const Numbering& numbering() const;
  /// With its hierarchy made as engine::prepared says, which throws where it cannot be. A Z text that the scene was
  /// read by answers in its place, and knows the elements that rays start on; it has no hierarchy to make.
  const engine::Engine& prepared(const engine::EngineRow& engine, const std::string& hierarchy) const;

  /// For an edit, which nobody may read beside: what was made of the scene is forgotten.
  written::Edited& edited();

 private:
  written::Edited value_;
  mutable std::mutex making_;
  mutable std::unique_ptr<const Numbering> numbering_;
  mutable std::map<std::pair<std::string_view, std::string>, std::unique_ptr<const engine::Engine>>
      engines_;  // by name and hierarchy
};

/// The scene of Python's object. An answer holds the state that it is asked of; an edit changes a state that nobody
/// else holds, and otherwise a copy of it. So an edit by one thread beside a trace by another is safe, and the trace
/// answers for the scene as it was when it began. Whoever calls holds Python's lock, which orders the two.
class Scene {
 public:
  explicit Scene(scene::GroupedScene grouped) : Scene(written::Edited(std::move(grouped))) {}
  explicit Scene(written::Edited value) : state_(std::make_shared<State>(std::move(value))) {}

  std::shared_ptr<const State> state() const noexcept { return state_; }
  const scene::Scene& value() const noexcept { return state_->scene(); }
  const scene::GroupedScene& grouped() const noexcept { return state_->grouped(); }
  const written::Edited& whole() const noexcept { return state_->value(); }

  /// The scene and its groups, to be edited in place.
  written::Edited& edited();
  /// The steps that led to it, with those that were undone.
  io::EditHistory& history() noexcept { return history_; }
  const io::EditHistory& history() const noexcept { return history_; }

 private:
  static constexpr std::size_t most_steps = 10'000;

  std::shared_ptr<State> state_;
  io::EditHistory history_{most_steps};
};

/// Throws std::invalid_argument, which lists the engines, where none has the name; and where a Z text answers in their
/// place, and the name is not that of whoever names none.
const engine::EngineRow& engine_named(const State& state, std::string_view name);

/// Throws std::invalid_argument where the scene was read by a Z text: `what` knows the program's own shapes alone.
void require_own_shapes(const State& state, std::string_view what);

}  // namespace durero::python
