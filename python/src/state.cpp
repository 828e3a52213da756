#include "state.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "durero/composed/engine.hpp"
#include "durero/engine/prepared.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/text/shown.hpp"

namespace durero::python {

Numbering::Numbering(const scene::Scene& scene)
    : size_(static_cast<std::int32_t>(scene.size())), singles_(scene::singles_by_name(scene)) {
  scene.for_each_single(
      [&](scene::ElementRef element, const auto&) { numbers_[static_cast<std::size_t>(element.tipo)].push_back(0); });
  for (std::size_t i = 0; i < singles_.size(); ++i) {
    const auto [tipo, index] = singles_[i];
    numbers_[static_cast<std::size_t>(tipo)][index] = static_cast<std::int32_t>(i);
  }
}

const Numbering& State::numbering() const {
  const std::scoped_lock lock(making_);
  if (!numbering_) numbering_ = std::make_unique<const Numbering>(scene());
  return *numbering_;
}

const engine::Engine& State::prepared(const engine::EngineRow& engine, const std::string& hierarchy) const {
  if (value_.text() != nullptr && hierarchy != engine::automatic)
    throw std::invalid_argument(
        fmt::format("hierarchy {}: the scene was read by {}, which answers; expected no hierarchy",
                    text::shown(hierarchy), value_.text()->file()));
  const std::scoped_lock lock(making_);
  auto& prepared = engines_[{engine.name, hierarchy}];
  if (!prepared)
    prepared = value_.text() == nullptr ? composed::prepared(engine, hierarchy, grouped()) : value_.engine();
  return *prepared;
}

written::Edited& State::edited() {
  numbering_.reset();
  engines_.clear();
  return value_;
}

written::Edited& Scene::edited() {
  if (state_.use_count() > 1) state_ = std::make_shared<State>(whole());
  return state_->edited();
}

void require_own_shapes(const State& state, std::string_view what) {
  if (state.value().text() != nullptr)
    throw std::invalid_argument(
        fmt::format("the scene was read by {}; expected one without surfaces: {} knows the program's own shapes alone",
                    state.value().text()->file(), what));
  if (state.scene().has_bodies())
    throw std::invalid_argument(fmt::format(
        "an element is made of others, as an instance is; expected none: {} knows the program's own shapes alone",
        what));
}

const engine::EngineRow& engine_named(const State& state, std::string_view name) {
  if (state.value().text() != nullptr && name != engine::default_engine)
    throw std::invalid_argument(fmt::format("engine {}: the scene was read by {}, which answers; expected no engine",
                                            text::shown(name), state.value().text()->file()));
  if (const engine::EngineRow* row = engine::find(name)) return *row;
  std::vector<std::string_view> known;
  for (const engine::EngineRow& row : engine::engines()) known.push_back(row.name);
  throw std::invalid_argument(
      fmt::format("no engine {}; expected one of {}", text::shown(name), fmt::join(known, ", ")));
}

}  // namespace durero::python
