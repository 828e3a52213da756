#include "interned_values.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace durero::spec {
namespace {

/// A block of parts has so many numbers, or as many as one value needs.
constexpr std::size_t block_size = 1 << 16;

std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9U;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebU;
  return x ^ x >> 31;
}

/// The whole number that a real is, where 64 bits hold it.
std::optional<std::int64_t> small_number(const zed::Real& real) {
  if (!real.is_integer()) return std::nullopt;
  constexpr int most_digits = 18;  // so many decimal digits are below 2⁶³ in any case
  const std::string text = real.text();
  if (text.size() > most_digits) return std::nullopt;
  return std::stoll(text);
}

zed::Real real_of(std::int64_t number) {
  const zed::Real size = zed::Real::natural(std::to_string(number < 0 ? -number : number));
  return number < 0 ? -size : size;
}

}  // namespace

std::uint64_t hash_of(std::span<const ValueId> ids, std::uint64_t seed) {
  std::uint64_t hash = seed;
  for (const ValueId id : ids) hash = mixed(hash + id + 0x9e3779b97f4a7c15U);
  return hash;
}

InternedValues::InternedValues() : entries_(1), slots_(1 << 12) {}

bool InternedValues::is(const Entry& entry, const Entry& wanted, std::span<const ValueId> parts) const {
  return entry.form == wanted.form && entry.tag == wanted.tag && entry.number == wanted.number &&
         entry.count == parts.size() && std::equal(parts.begin(), parts.end(), entry.parts);
}

const ValueId* InternedValues::copied(std::span<const ValueId> parts) {
  if (parts.empty()) return nullptr;
  if (parts.size() > left_) {
    left_ = std::max(block_size, parts.size());
    blocks_.push_back(std::make_unique<ValueId[]>(left_));
    std::copy(parts.begin(), parts.end(), blocks_.back().get());
    used_ = parts.size();
  } else {
    std::copy(parts.begin(), parts.end(), blocks_.back().get() + used_);
    used_ += parts.size();
  }
  left_ -= parts.size();
  return blocks_.back().get() + used_ - parts.size();
}

std::uint64_t InternedValues::hash(const Entry& entry, std::span<const ValueId> parts) {
  return hash_of(parts, mixed(static_cast<std::uint64_t>(entry.form) << 56U ^ std::uint64_t{entry.tag} << 20U ^
                              static_cast<std::uint64_t>(entry.number)));
}

ValueId InternedValues::kept(const Entry& wanted, std::span<const ValueId> parts) {
  const std::uint64_t whole = hash(wanted, parts);
  const auto upper = static_cast<std::uint32_t>(whole >> 32U);
  std::size_t at = whole & (slots_.size() - 1);
  for (; slots_[at].id != 0; at = (at + 1) & (slots_.size() - 1))
    if (slots_[at].hash == upper && is(entries_[slots_[at].id], wanted, parts)) return slots_[at].id;
  Entry entry = wanted;
  entry.count = static_cast<std::uint32_t>(parts.size());
  entry.parts = copied(parts);
  const auto id = static_cast<ValueId>(entries_.size());
  slots_[at] = {id, upper};
  entries_.push_back(entry);
  if (entries_.size() * 2 > slots_.size()) grow();
  return id;
}

void InternedValues::grow() {
  std::vector<Slot> longer(slots_.size() * 2);
  for (ValueId id = 1; id < entries_.size(); ++id) {
    if (entries_[id].form == InternedForm::other) continue;  // it is not looked for
    const std::uint64_t whole = hash(entries_[id], parts(id));
    std::size_t at = whole & (longer.size() - 1);
    while (longer[at].id != 0) at = (at + 1) & (longer.size() - 1);
    longer[at] = {id, static_cast<std::uint32_t>(whole >> 32U)};
  }
  slots_ = std::move(longer);
}

ValueId InternedValues::number(std::int64_t value) {
  Entry entry;
  entry.form = InternedForm::number;
  entry.number = value;
  return kept(entry, {});
}

ValueId InternedValues::composed(InternedForm form, std::uint32_t tag, std::span<const ValueId> parts) {
  if (std::find(parts.begin(), parts.end(), 0U) != parts.end()) return 0;
  Entry entry;
  entry.form = form;
  entry.tag = tag;
  return kept(entry, parts);
}

ValueId InternedValues::pair(ValueId first, ValueId second) {
  const std::array parts{first, second};
  return tuple(parts);
}

ValueId InternedValues::constructed(const zed::Atom& constructor, ValueId argument) {
  return composed(InternedForm::constructed, atom_tag(constructor), std::span(&argument, 1));
}

ValueId InternedValues::set(std::span<ValueId> members) {
  std::sort(members.begin(), members.end());
  const auto end = std::unique(members.begin(), members.end());
  return sorted_set(std::span<const ValueId>(members.begin(), end));
}

std::uint32_t InternedValues::atom_tag(const zed::Atom& atom) {
  const std::string key = atom->type + "\n" + atom->text;
  const auto [at, is_new] = atom_tags_.emplace(key, static_cast<std::uint32_t>(atoms_.size()));
  if (is_new) atoms_.push_back(atom);
  return at->second;
}

std::uint32_t InternedValues::signature(const std::vector<zed::Name>& names) {
  for (std::uint32_t i = 0; i < signatures_.size(); ++i)
    if (*signatures_[i] == names) return i;
  signatures_.push_back(zed::signature(names));
  return static_cast<std::uint32_t>(signatures_.size() - 1);
}

template <class Values>
std::vector<ValueId> InternedValues::of_each(const Values& values) {
  std::vector<ValueId> ids;
  ids.reserve(values.size());
  for (const zed::Value& value : values) ids.push_back(of(value));
  return ids;
}

ValueId InternedValues::of_set(const zed::Set& value) {
  if (!value.members()) throw NotInterned(value.text() + " is not listed");
  std::vector<ValueId> ids = of_each(*value.members());
  return set(ids);
}

ValueId InternedValues::of(const zed::Value& value) {
  if (value.is_undefined()) return 0;
  if (const zed::Real* real = value.real()) {
    if (const auto small = small_number(*real)) return number(*small);
    for (ValueId id = 1; id < entries_.size(); ++id)
      if (entries_[id].form == InternedForm::other && zed::same(others_[entries_[id].tag], value)) return id;
    return whole(value);
  }
  if (const auto* atom = value.get<zed::Atom>()) {
    Entry entry;
    entry.form = InternedForm::atom;
    entry.tag = atom_tag(*atom);
    return kept(entry, {});
  }
  if (const auto* of_tuple = value.tuple()) return tuple(of_each(of_tuple->parts));
  if (const auto* of_binding = value.binding())
    return binding(signature(*of_binding->names), of_each(of_binding->values));
  if (const auto* made = value.get<zed::ConstructedPtr>())
    return constructed((*made)->constructor, of((*made)->argument));
  if (const zed::Set* of_values = value.set()) return of_set(*of_values);
  throw NotInterned("a value is not known");
}

ValueId InternedValues::whole(const zed::Value& value) {
  Entry entry;
  entry.form = InternedForm::other;
  entry.tag = static_cast<std::uint32_t>(others_.size());
  others_.push_back(value);
  entries_.push_back(entry);
  return static_cast<ValueId>(entries_.size() - 1);
}

zed::Value InternedValues::value(ValueId id) const {
  const Entry& entry = entries_[id];
  std::vector<zed::Value> of_parts;
  for (const ValueId part : parts(id)) of_parts.push_back(value(part));
  switch (entry.form) {
    case InternedForm::undefined:
      return {};
    case InternedForm::number:
      return real_of(entry.number);
    case InternedForm::atom:
      return atoms_[entry.tag];
    case InternedForm::tuple:
      return zed::Value::tuple(std::move(of_parts));
    case InternedForm::binding:
      return zed::Value::binding(signatures_[entry.tag], std::move(of_parts));
    case InternedForm::constructed:
      return std::make_shared<const zed::Constructed>(zed::Constructed{atoms_[entry.tag], of_parts[0]});
    case InternedForm::set:
      return zed::Value::set(std::move(of_parts));
    case InternedForm::other:
      return others_[entry.tag];
  }
  __builtin_unreachable();  // it has one of these forms
}

std::span<const ValueId> InternedValues::members(ValueId id) const {
  if (form(id) != InternedForm::set) throw NotInterned("a set is not listed");
  return parts(id);
}

std::int64_t InternedValues::whole_number(ValueId id) const {
  if (form(id) != InternedForm::number) throw NotInterned("a number is not small");
  return entries_[id].number;
}

bool InternedValues::has(ValueId set, ValueId member) const {
  const auto all = members(set);
  constexpr std::size_t few = 8;  // a search of so few from one end is as quick as one by halves
  if (all.size() <= few) return std::find(all.begin(), all.end(), member) != all.end();
  return std::binary_search(all.begin(), all.end(), member);
}

ValueId InternedValues::remade(ValueId id, std::vector<ValueId>& parts) {
  if (form(id) == InternedForm::set) return set(parts);
  return composed(form(id), entries_[id].tag, parts);
}

}  // namespace durero::spec
