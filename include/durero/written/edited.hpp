#pragma once
/// An edited scene holds its groups too. Where a Z text defines the elements, each addition is checked against the text
/// as well: attributes outside the domain of puntos_TIPO are refused with the predicate that does not hold.

#include <memory>
#include <span>
#include <string>
#include <utility>

#include "durero/io/json/edited_scene.hpp"
#include "durero/scene/copying.hpp"
#include "durero/written/engine.hpp"

namespace durero::written {

/// An edited scene, with a text or without. A copy shares the text.
class Edited final : public io::EditedScene {
 public:
  /// A scene of the program's own shapes, without a text.
  explicit Edited(scene::GroupedScene scene = {}) : EditedScene(std::move(scene)) {}
  /// Reads a scene by the text. Throws io::InputError at the first thing that is wrong, in the scene or in the text.
  Edited(const io::Source& source, std::shared_ptr<const Text> text);

  /// The text; null without one.
  const Text* text() const noexcept { return text_.get(); }
  std::span<const io::WrittenType> types() const override;
  /// The element of that name, where it is of a type of the text; otherwise null.
  const io::WrittenElement* written(std::string_view name) const;

  using EditedScene::apply_total;
  /// @{ The same, which throw io::InputError where the text is wrong; the scene is then as it was.
  io::EditAnswer apply_total(const scene::Edit& edit) override;
  io::EditAnswer apply_total(const io::WrittenEdit& edit) override;
  io::EditAnswer apply_total(const scene::Copying& edit) override;
  io::EditAnswer apply_total(const scene::Joining& edit) override;
  io::EditAnswer apply_total(scene::MeshEdit edit) override;
  io::EditAnswer apply_total(const model::AttributeChange& change) override;
  /// @}

  std::optional<io::WrittenElement> written_record(const std::string& name) const override;

  /// The engine that answers rays by the text. It does not refer to this scene. Precondition: there is a text.
  std::unique_ptr<const engine::Engine> engine() const;

  std::unique_ptr<io::EditedScene> copy() const override { return std::make_unique<Edited>(*this); }
  std::string scene_text() const override;

 private:
  void set_written(const std::string& name, std::optional<io::WrittenElement> element) override;
  bool stands_in(const std::string& name) const override { return elements_.contains(name); }
  io::EditAnswer add(const io::WrittenAddition& in);
  io::EditAnswer remove(const io::WrittenRemoval& in);
  /// Carries out an addition, and then makes the surface. The addition is undone where the text does not give it one.
  template <class MakeSurface>
  io::EditAnswer add_if_given(const scene::Edit& edit, MakeSurface make);

  std::shared_ptr<const Text> text_{};
  io::WrittenByName elements_{};
};

}  // namespace durero::written
