#include "durero/accel/bvh.hpp"

#include <string>
#include <string_view>
#include <unordered_map>

#include "accel/finite_box.hpp"
#include "accel/insertion.hpp"
#include "accel/top_down.hpp"

namespace durero::accel {
Bvh::Bvh(const scene::Scene& scene, Build build, unsigned most_children)
    : scene_(&scene), most_children_(most_children) {
  grow(build, take_elements());
  arrange();
}

Bvh::Bvh(const scene::Scene& scene, const scene::Groups& by_hand) : scene_(&scene), most_children_(usual_children) {
  const std::vector<Number> leaves = take_elements();
  if (!leaves.empty()) tree_.set_root(join_groups(by_hand, leaves));
  arrange();
}

std::vector<Hierarchy::Number> Bvh::take_elements() {
  std::vector<Number> leaves;
  scene_->for_each([&](scene::ElementRef e, const auto&) {
    const auto box = finite_box(*scene_, e);
    if (!box) return put_apart(e);
    const Number leaf = tree_.leaf(e, *box);
    places_[static_cast<std::size_t>(e.tipo)].push_back({false, leaf});
    leaves.push_back(leaf);
  });
  return leaves;
}

Hierarchy::Number Bvh::join_groups(const scene::Groups& groups, std::span<const Number> leaves) {
  std::unordered_map<std::string_view, std::vector<Number>> within;  // elements outside all groups under the empty name
  for (const Number leaf : leaves) {
    const std::string name = scene_->name(tree_[leaf].element).name();
    within[groups.of_element(name)].push_back(leaf);
  }
  const auto joined = [&](const std::vector<Number>& children) {
    return children.size() == 1 ? children.front() : tree_.join(children);
  };
  for (const std::string_view group : groups.bottom_up())
    if (const auto found = within.find(group); found != within.end()) {
      const Number node = joined(found->second);
      within[groups.of_group(group)].push_back(node);
    }
  return joined(within.at({}));
}

void Bvh::grow(Build build, std::vector<Number> leaves) {
  if (leaves.empty()) return;
  if (build == Build::top_down) return tree_.set_root(accel::top_down(tree_, leaves, most_children_));
  for (const Number leaf : leaves) {
    Insertion<double> insertion(tree_, tree_[leaf].box, most_children_);
    put(tree_, build == Build::incremental ? insertion.downwards() : insertion.of_all(), leaf);
  }
}

void Bvh::arrange() {
  tree_.arrange();
  for (Number node = 0; node < tree_.numbers(); ++node)
    if (tree_[node].is_leaf()) place(tree_[node].element).number = node;
}

void Bvh::put_apart(scene::ElementRef e) {
  places_[static_cast<std::size_t>(e.tipo)].push_back({true, static_cast<std::uint32_t>(apart_.size())});
  apart_.push_back(e);
}

void Bvh::added(scene::ElementRef e) {
  const auto box = finite_box(*scene_, e);
  if (!box) return put_apart(e);
  const Number leaf = tree_.leaf(e, *box);
  places_[static_cast<std::size_t>(e.tipo)].push_back({false, leaf});
  put(tree_, Insertion<double>(tree_, *box, most_children_).downwards(), leaf);
}

void Bvh::removed(scene::ElementRef e) {
  const Place gone = place(e);
  if (gone.apart) {
    apart_[gone.number] = apart_.back();
    place(apart_.back()).number = gone.number;
    apart_.pop_back();
  } else {
    tree_.take_out(gone.number);
  }
  auto& column = places_[static_cast<std::size_t>(e.tipo)];
  const Place last = column.back();
  column.pop_back();
  if (e.index == column.size()) return;
  column[e.index] = last;
  if (last.apart)
    apart_[last.number] = e;
  else
    tree_.rename(last.number, e);
}

Size Bvh::size() const {
  Size size;
  size.apart = apart_.size();
  size.bytes = tree_.bytes() + apart_.capacity() * sizeof(scene::ElementRef);
  for (const auto& column : places_) size.bytes += column.capacity() * sizeof(Place);
  if (tree_.empty()) return size;
  size.elements = size.cells = size.references = tree_[tree_.root()].leaves;
  size.nodes = tree_.inner_nodes();
  size.depth = tree_.depth();
  return size;
}

}  // namespace durero::accel
