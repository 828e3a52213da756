#include "durero/scene/remainder.hpp"

#include <algorithm>

#include "durero/scene/edit.hpp"

namespace durero::scene {

Remainder::Remainder(const GroupedScene& whole, const std::function<bool(ElementRef)>& leaves_out) : left_{whole} {
  Scene& left = left_.scene;
  std::vector<model::Elemento> others;
  left.for_each([&](ElementRef e, const auto&) {
    if (leaves_out(e)) others.push_back(left.name(e));
  });
  for (const model::Elemento& name : others) left.apply_total(Edit{model::Eliminar_Elemento{name}});
  place_left_.resize(whole.scene.shapes<Sphere>().size(), none);
  const auto spheres = static_cast<std::uint32_t>(left.shapes<Sphere>().size());
  for (std::uint32_t i = 0; i < spheres; ++i) {
    const ElementRef there = whole.scene.find(left.name({Sphere::tipo, i}).name()).value();
    place_in_whole_.push_back(there.index);
    place_left_[there.index] = i;
  }
}

Query Remainder::query(const Query& of) const {
  Query own{of.rayo};
  for (const ElementRef e : of.en) {
    if (e.tipo != Sphere::tipo)
      own.en.push_back(e);
    else if (place_left_[e.index] != none)
      own.en.push_back({e.tipo, place_left_[e.index]});
  }
  std::ranges::sort(own.en);
  return own;
}

std::vector<Query> Remainder::queries(std::span<const Query> of) const {
  std::vector<Query> own;
  own.reserve(of.size());
  for (const Query& each : of) own.push_back(query(each));
  return own;
}

ElementSet Remainder::elements(const ElementSet& left) const {
  ElementSet there = left;
  for (ElementRef& e : there) e = element(e);
  std::ranges::sort(there);
  return there;
}

}  // namespace durero::scene
