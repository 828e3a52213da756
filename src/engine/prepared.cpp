#include "durero/engine/prepared.hpp"

#include <stdexcept>
#include <string>

namespace durero::engine {

std::unique_ptr<const Engine> prepared(const EngineRow& row, std::string_view hierarchy,
                                       const scene::GroupedScene& input) {
  using namespace std::string_literals;
  if (hierarchy == automatic) return row.prepare(input.scene);
  if (hierarchy != by_hand)
    throw std::invalid_argument("hierarchy: there is no such one; expected "s.append(automatic) +
                                " or "s.append(by_hand));
  if (row.prepare_by_hand != nullptr) return row.prepare_by_hand(input.scene, input.groups);
  std::string following;
  for (const EngineRow& other : engines())
    if (other.prepare_by_hand != nullptr) following.append(following.empty() ? "" : ", ").append(other.name);
  throw std::invalid_argument("hierarchy "s.append(hierarchy) + ": "s.append(row.name) +
                              " follows no groups; expected engine " + following);
}

}  // namespace durero::engine
