#pragma once
/// Arrays of two in JSON.

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "durero/io/json/json.hpp"

namespace durero::io {

/// An array of two, each by read_one(). `expected` is what is said of one that has more or fewer.
template <class Item, class ReadOne>
std::array<Item, 2> read_two(json::Reader& in, std::string_view what, const char* expected, ReadOne&& read_one) {
  const std::size_t at = in.offset();
  std::array<Item, 2> items{};
  std::size_t count = 0;
  in.array(what, [&] {
    if (count == items.size()) in.fail(in.offset(), fmt::format("{} has a third item", what), expected);
    items[count++] = read_one();
  });
  if (count != items.size()) in.fail(at, fmt::format("{} has {} items", what, count), expected);
  return items;
}

}  // namespace durero::io
