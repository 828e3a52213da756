#include "durero/accel/box_tree.hpp"

#include <vector>

#include "accel/top_down.hpp"

namespace durero::accel {

BoxTree::BoxTree(std::span<const surface::Box> boxes) {
  if (boxes.empty()) return;
  constexpr unsigned most_children = 8;
  std::vector<Hierarchy::Number> leaves;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) leaves.push_back(tree_.leaf({{}, i}, boxes[i]));
  tree_.set_root(top_down(tree_, leaves, most_children));
  tree_.arrange();
}

}  // namespace durero::accel
