#include "durero/composed/side_tree.hpp"

#include <algorithm>
#include <utility>

namespace durero::composed {

SideTree::SideTree(Kind kind, std::size_t number, bool turned, std::vector<SideTree> parts)
    : kind_(kind), turned_(turned), number_(number), parts_(std::move(parts)) {}

SideTree SideTree::face(std::size_t number, bool turned) { return {Kind::face, number, turned, {}}; }

SideTree SideTree::all(std::vector<SideTree> parts) { return {Kind::all, 0, false, std::move(parts)}; }

SideTree SideTree::any(std::vector<SideTree> parts) { return {Kind::any, 0, false, std::move(parts)}; }

SideTree SideTree::complement() const {
  if (kind_ == Kind::face) return face(number_, !turned_);
  std::vector<SideTree> parts;
  parts.reserve(parts_.size());
  for (const SideTree& part : parts_) parts.push_back(part.complement());
  return kind_ == Kind::all ? any(std::move(parts)) : all(std::move(parts));
}

int SideTree::certain(std::span<const std::int8_t> sides) const {
  if (kind_ == Kind::face) return turned_ ? sides[number_] : -sides[number_];
  const int decides = kind_ == Kind::all ? -1 : 1;
  int common = -decides;
  for (const SideTree& part : parts_) {
    const int here = part.certain(sides);
    if (here == decides) return decides;
    if (here == 0) common = 0;
  }
  return common;
}

void SideTree::try_sides(std::span<std::int8_t> sides, std::span<const std::size_t> open, bool& is_in,
                         bool& is_out) const {
  const int here = certain(sides);
  is_in = is_in || here > 0;
  is_out = is_out || here < 0;
  if (here != 0) return;
  for (const std::int8_t side : {std::int8_t{-1}, std::int8_t{1}}) {
    if (is_in && is_out) break;
    sides[open[0]] = side;
    try_sides(sides, open.subspan(1), is_in, is_out);
  }
  sides[open[0]] = 0;
}

SolidPlace SideTree::place(std::span<const std::int8_t> sides) const {
  const int here = certain(sides);
  if (here != 0) return here > 0 ? SolidPlace::inside : SolidPlace::outside;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides[i] == 0) open.push_back(i);
  std::vector<std::int8_t> tried(sides.begin(), sides.end());
  bool is_in = false, is_out = false;
  try_sides(tried, open, is_in, is_out);
  return is_in && is_out ? SolidPlace::surface : is_in ? SolidPlace::inside : SolidPlace::outside;
}

}  // namespace durero::composed
