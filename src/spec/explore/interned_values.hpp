#pragma once
/// The values of an exploration, each kept once: two are equal where their numbers are. A set keeps the numbers of its
/// members sorted.

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "durero/zed/value/value.hpp"

namespace durero::spec {

/// The number of a value; 0 is that of an expression without a value.
using ValueId = std::uint32_t;

/// A list of values; a short one needs no heap.
using ValueList = boost::container::small_vector<ValueId, 16>;

/// The error of an operator that the kept values do not serve: the evaluator is to be asked then.
class NotInterned : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The form of a kept value.
enum class InternedForm : std::uint8_t { undefined, number, atom, tuple, binding, constructed, set, other };

/// Every value that an exploration met, as a number. Values stay as long as the table.
class InternedValues {
 public:
  InternedValues();

  /// @{ The number of the value of that form. A tuple, a binding or a set with an undefined part is undefined.
  ValueId number(std::int64_t value);
  ValueId tuple(std::span<const ValueId> parts) { return composed(InternedForm::tuple, 0, parts); }
  ValueId pair(ValueId first, ValueId second);
  ValueId binding(std::uint32_t signature, std::span<const ValueId> parts) {
    return composed(InternedForm::binding, signature, parts);
  }
  ValueId constructed(const zed::Atom& constructor, ValueId argument);
  ValueId set(std::span<ValueId> members);  ///< sorts them
  ValueId set(ValueList& members) { return set(std::span(members.data(), members.size())); }
  ValueId sorted_set(std::span<const ValueId> members) { return composed(InternedForm::set, 0, members); }
  ValueId sorted_set(const ValueList& members) { return sorted_set(std::span(members.data(), members.size())); }
  /// @}
  /// The number of a signature, whose names are sorted.
  std::uint32_t signature(const std::vector<zed::Name>& names);
  /// The number of a value of the evaluator. Throws NotInterned where a set in it is not listed.
  ValueId of(const zed::Value& value);
  /// The number of a value that may be known by membership alone: it is equal to itself only.
  ValueId whole(const zed::Value& value);
  /// The value of that number.
  zed::Value value(ValueId id) const;

  InternedForm form(ValueId id) const { return entries_[id].form; }
  /// The parts of a tuple, a binding or a constructed value, or the sorted members of a set. They stay where they are.
  std::span<const ValueId> parts(ValueId id) const { return {entries_[id].parts, entries_[id].count}; }
  /// The members of a set. Throws NotInterned where it is not listed.
  std::span<const ValueId> members(ValueId id) const;
  /// The whole number. Throws NotInterned for any other.
  std::int64_t whole_number(ValueId id) const;
  /// The names of a binding.
  const std::vector<zed::Name>& names(ValueId binding) const { return *signatures_[entries_[binding].tag]; }
  /// The atom of that number, or the constructor of a constructed value.
  const zed::Atom& atom(ValueId id) const { return atoms_[entries_[id].tag]; }
  /// Says whether the set has the member.
  bool has(ValueId set, ValueId member) const;
  /// Makes the constructed value, tuple, binding or set anew with other parts, which it may sort.
  ValueId remade(ValueId id, std::vector<ValueId>& parts);
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    InternedForm form = InternedForm::undefined;
    std::uint32_t count = 0, tag = 0;
    const ValueId* parts = nullptr;
    std::int64_t number = 0;
  };

  ValueId composed(InternedForm form, std::uint32_t tag, std::span<const ValueId> parts);
  ValueId kept(const Entry& entry, std::span<const ValueId> parts);
  static std::uint64_t hash(const Entry& entry, std::span<const ValueId> parts);
  bool is(const Entry& entry, const Entry& wanted, std::span<const ValueId> parts) const;
  const ValueId* copied(std::span<const ValueId> parts);
  std::uint32_t atom_tag(const zed::Atom& atom);
  ValueId of_set(const zed::Set& set);
  template <class Values>
  std::vector<ValueId> of_each(const Values& values);
  void grow();

  std::vector<Entry> entries_;
  struct Slot {
    ValueId id = 0;          // 0 is a free place
    std::uint32_t hash = 0;  // so that few others are looked at
  };
  std::vector<Slot> slots_;                         // the numbers by their hashes
  std::vector<std::unique_ptr<ValueId[]>> blocks_;  // the parts, in blocks that stay where they are
  std::size_t used_ = 0, left_ = 0;                 // so many numbers of the last block are taken, and free
  std::vector<zed::Atom> atoms_;
  std::unordered_map<std::string, std::uint32_t> atom_tags_;
  std::vector<zed::Signature> signatures_;
  std::vector<zed::Value> others_;
};

/// A mixed hash of numbers (the finalizer of SplitMix64 over each).
std::uint64_t hash_of(std::span<const ValueId> ids, std::uint64_t seed);

}  // namespace durero::spec
