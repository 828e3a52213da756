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
#include "durero/scene/grouped_scene.hpp"

namespace durero::python {

/// The elements of a scene, numbered from 0 in the order of their names: what an array knows them by.
class Numbering {
 public:
  explicit Numbering(const scene::Scene& scene);

  std::int32_t size() const noexcept { return static_cast<std::int32_t>(elements_.size()); }
  const std::vector<scene::ElementRef>& elements() const noexcept { return elements_; }
  std::int32_t number(scene::ElementRef element) const noexcept {
    return numbers_[static_cast<std::size_t>(element.tipo)][element.index];
  }

 private:
  std::vector<scene::ElementRef> elements_;
  std::array<std::vector<std::int32_t>, scene::shape_count> numbers_;
};

/// A scene, and what answers need beside it, which is made when it is first asked for. Any thread may ask.
class State {
 public:
  explicit State(scene::GroupedScene grouped) : grouped_(std::move(grouped)) {}

  const scene::GroupedScene& grouped() const noexcept { return grouped_; }
  const scene::Scene& scene() const noexcept { return grouped_.scene; }
  const Numbering& numbering() const;
  /// With its hierarchy made as engine::prepared says, which throws where it cannot be.
  const engine::Engine& prepared(const engine::Row& engine, const std::string& hierarchy) const;

  /// For an edit, which nobody may read beside: what was made of the scene is forgotten.
  scene::GroupedScene& edited();

 private:
  scene::GroupedScene grouped_;
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
  explicit Scene(scene::GroupedScene grouped) : state_(std::make_shared<State>(std::move(grouped))) {}

  std::shared_ptr<const State> state() const noexcept { return state_; }
  const scene::Scene& value() const noexcept { return state_->scene(); }
  const scene::GroupedScene& grouped() const noexcept { return state_->grouped(); }

  /// The scene and its groups, to be edited in place.
  scene::GroupedScene& edited();
  /// Puts others in their place.
  void assign(scene::GroupedScene grouped) { state_ = std::make_shared<State>(std::move(grouped)); }

 private:
  std::shared_ptr<State> state_;
};

/// Throws std::invalid_argument, which lists the engines, where none has the name.
const engine::Row& engine_named(std::string_view name);

}  // namespace durero::python
