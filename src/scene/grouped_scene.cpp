#include "durero/scene/grouped_scene.hpp"

#include "durero/scene/edit.hpp"

namespace durero::scene {

model::Answer GroupedScene::apply_total(const Edit& edit) {
  const model::Answer answer = scene.apply_total(edit);
  if (answer.ok()) groups.follow(edit.operation);
  return answer;
}

}  // namespace durero::scene
