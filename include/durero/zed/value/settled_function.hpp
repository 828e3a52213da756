#pragma once
/// A settled function is an infinite table that can be written down: from some integer on it is defined at every
/// integer, and it has one value at all of them but finitely many. `names : ℕ₁ → NAME`, of which a program has used the
/// first places, is one.

#include <vector>

#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// Returns the function that has the value `rest` at each integer from `least` on, and at the first part of each of
/// `pairs`, which may be any numbers, the second part instead. Two such functions are the same value (same()) exactly
/// where they have the same pairs. Preconditions: no two pairs agree in their first parts; nothing in `pairs` and
/// `rest` is open, unknown or undefined.
Value settled_function(int least, std::vector<Value> pairs, Value rest);

}  // namespace durero::zed
