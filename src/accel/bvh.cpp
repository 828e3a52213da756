#include "durero/accel/bvh.hpp"

#include <cmath>
#include <optional>

#include "accel/top_down.hpp"
#include "durero/accel/insertion.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using scene::ElementRef;

/// Nothing where the element is not ordinary, or no box contains it: a plane.
std::optional<surface::Box> finite_box(const scene::Scene& scene, ElementRef e) {
  return scene.visit(e, [](const auto& shape) -> std::optional<surface::Box> {
    if (!trace::ordinary(shape)) return {};
    const surface::Box box = surface::box(shape);
    if (!std::isfinite(box.low.x) || !std::isfinite(box.high.x)) return {};
    return box;
  });
}

}  // namespace

Bvh::Bvh(const scene::Scene& scene, Build build, unsigned most_children)
    : scene_(&scene), most_children_(most_children) {
  std::vector<Number> leaves;
  scene.for_each([&](ElementRef e, const auto&) {
    const auto box = finite_box(scene, e);
    if (!box) return put_apart(e);
    const Number leaf = tree_.leaf(e, *box);
    places_[static_cast<std::size_t>(e.tipo)].push_back({false, leaf});
    leaves.push_back(leaf);
  });
  grow(build, std::move(leaves));
}

void Bvh::grow(Build build, std::vector<Number> leaves) {
  if (leaves.empty()) return;
  if (build == Build::top_down) return tree_.set_root(accel::top_down(tree_, leaves, most_children_));
  for (const Number leaf : leaves) {
    Insertion<double> insertion(tree_, tree_[leaf].box, most_children_);
    put(tree_, build == Build::incremental ? insertion.downwards() : insertion.of_all(), leaf);
  }
}

void Bvh::put_apart(ElementRef e) {
  places_[static_cast<std::size_t>(e.tipo)].push_back({true, static_cast<std::uint32_t>(apart_.size())});
  apart_.push_back(e);
}

void Bvh::added(ElementRef e) {
  const auto box = finite_box(*scene_, e);
  if (!box) return put_apart(e);
  const Number leaf = tree_.leaf(e, *box);
  places_[static_cast<std::size_t>(e.tipo)].push_back({false, leaf});
  put(tree_, Insertion<double>(tree_, *box, most_children_).downwards(), leaf);
}

void Bvh::removed(ElementRef e) {
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
  size.bytes = tree_.bytes() + apart_.capacity() * sizeof(ElementRef);
  for (const auto& column : places_) size.bytes += column.capacity() * sizeof(Place);
  if (tree_.empty()) return size;
  size.elements = size.cells = size.references = tree_[tree_.root()].leaves;
  size.nodes = tree_.inner_nodes();
  size.depth = tree_.depth();
  return size;
}

}  // namespace durero::accel
