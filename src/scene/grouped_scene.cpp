#include "durero/scene/grouped_scene.hpp"

#include <utility>

#include "durero/scene/edit.hpp"

namespace durero::scene {

model::Answer GroupedScene::apply_total(const Edit& edit) {
  const model::Answer answer = scene.apply_total(edit);
  if (answer.ok()) groups.follow(edit.operation);
  return answer;
}

model::Answer GroupedScene::apply_total(MeshEdit edit) {
  const model::Answer answer = scene.apply_total(std::move(edit));
  if (answer.ok()) groups.follow_meshes(scene);
  return answer;
}

}  // namespace durero::scene
