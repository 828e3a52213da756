#include "durero/accel/bvh.hpp"

#include <algorithm>
#include <stdexcept>

#include "accel/finite_box.hpp"
#include "accel/top_down.hpp"
#include "durero/accel/insertion.hpp"

namespace durero::accel {
namespace {

/// The elements of a group and of all within it.
void collect(const Group& group, std::vector<scene::ElementRef>& elements) {
  elements.insert(elements.end(), group.elements.begin(), group.elements.end());
  for (const Group& within : group.groups) collect(within, elements);
}

}  // namespace

Bvh::Bvh(const scene::Scene& scene, Build build, unsigned most_children)
    : scene_(&scene), most_children_(most_children) {
  grow(build, take_elements());
}

Bvh::Bvh(const scene::Scene& scene, const Group& by_hand) : scene_(&scene), most_children_(usual_children) {
  std::vector<scene::ElementRef> grouped, all;
  collect(by_hand, grouped);
  std::ranges::sort(grouped);
  scene.for_each([&](scene::ElementRef e, const auto&) { all.push_back(e); });
  if (grouped != all) throw std::invalid_argument("not every element is in exactly one group");
  take_elements();
  tree_.set_root(join(by_hand));
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

Hierarchy::Number Bvh::join(const Group& group) {
  std::vector<Number> children;
  for (const scene::ElementRef e : group.elements)
    if (!place(e).apart) children.push_back(place(e).number);
  for (const Group& within : group.groups)
    if (const Number node = join(within); node != Hierarchy::none) children.push_back(node);
  if (children.empty()) return Hierarchy::none;
  return children.size() == 1 ? children.front() : tree_.join(children);
}

void Bvh::grow(Build build, std::vector<Number> leaves) {
  if (leaves.empty()) return;
  if (build == Build::top_down) return tree_.set_root(accel::top_down(tree_, leaves, most_children_));
  for (const Number leaf : leaves) {
    Insertion<double> insertion(tree_, tree_[leaf].box, most_children_);
    put(tree_, build == Build::incremental ? insertion.downwards() : insertion.of_all(), leaf);
  }
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
