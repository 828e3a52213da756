#pragma once
/// Sets of sets and of tuples have small members, which a search for a witness tries, and members of a bounded size, of
/// which it goes through all.

#include <optional>
#include <vector>

#include "zed/value/context.hpp"

namespace durero::zed {

/// The most members of a bounded size that are listed.
inline constexpr std::size_t most_bounded_members = 1 << 16;

/// Returns subsets of these values, each of which stands once, smaller ones first, and no more than `most`. Nothing of
/// a value that is undefined or open is made.
std::vector<Value> subsets_of(std::vector<Value> values, std::size_t most, bool nonempty);
/// Returns all subsets of sorted values that have at most so many members. Nothing where they are too many.
std::optional<std::vector<Value>> all_subsets(const std::vector<Value>& sorted, std::size_t size);

/// Returns sequences of these values, shorter ones first, and no more than `most`.
std::vector<Value> sequences_of(const std::vector<Value>& values, std::size_t most, bool nonempty, bool distinct);
/// Returns all sequences of these values with at most so many items. Nothing where they are too many.
std::optional<std::vector<Value>> all_sequences(const std::vector<Value>& values, std::size_t length, bool distinct);

/// Returns tuples of some members of these sets.
std::vector<Value> some_tuples(const std::vector<Value>& factors, const SmallScope& scope, Context& context);

/// Returns the sequence of these items.
Value sequence_of(const std::vector<Value>& items);

}  // namespace durero::zed
