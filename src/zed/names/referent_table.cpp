#include "zed/names/referent_table.hpp"

#include <algorithm>

namespace durero::zed {

std::size_t ReferentTable::add(Referent referent) {
  referents_.push_back(std::move(referent));
  parents_.push_back(parents_.size());
  return parents_.size() - 1;
}

std::size_t ReferentTable::root(std::size_t of) {
  while (parents_[of] != of) of = parents_[of] = parents_[parents_[of]];
  return of;
}

void ReferentTable::unite(std::size_t a, std::size_t b) {
  a = root(a);
  b = root(b);
  if (a == b) return;
  if (b < a) std::swap(a, b);  // the first stays, so that the answer is the same at every call
  parents_[b] = a;
  referents_[a].form = std::max(referents_[a].form, referents_[b].form);
}

void ReferentTable::share(std::map<Name, std::size_t>& shared, const ComponentReferents& components,
                          ReferentTable& in) {
  for (const auto& [name, referent] : components)
    if (const auto [at, added] = shared.try_emplace(name, referent); !added) in.unite(at->second, referent);
}

void ReferentTable::remember(const ComponentReferents& components) {
  std::vector<Name> names;
  names.reserve(components.size());
  for (const auto& [name, referent] : components) names.push_back(name);
  std::ranges::sort(names);
  SharedSignature& signature = signatures_[std::move(names)];
  if (signature.shared) {
    share(*signature.shared, components, *this);
  } else {
    signature.waiting.push_back(components);
  }
}

ComponentReferents ReferentTable::of_bindings(const Type& schema) {
  SharedSignature& signature = signatures_[schema.fields()];
  if (!signature.shared) {
    signature.shared.emplace();
    for (const ComponentReferents& components : signature.waiting) share(*signature.shared, components, *this);
    signature.waiting.clear();
  }
  for (const Name& name : schema.fields())
    if (!signature.shared->contains(name)) signature.shared->emplace(name, add({Referent::Form::component, name}));
  return {signature.shared->begin(), signature.shared->end()};
}

}  // namespace durero::zed
