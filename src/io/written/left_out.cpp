#include "left_out.hpp"

#include <fmt/format.h>

#include "durero/scene/body.hpp"
#include "io/losses.hpp"

namespace durero::io {
namespace {

/// The English names of the types, in the order of Tipo.
constexpr std::array<std::string_view, scene::shape_count> type_names{"sphere", "cylinder", "cone",    "truncated cone",
                                                                      "plane",  "disc",     "triangle"};

}  // namespace

void LeftOutElements::add(const scene::Body& body) {
  ++(std::holds_alternative<scene::Instance>(body.form) ? instances_ : solids_);
}

void LeftOutElements::name_losses(std::vector<std::string>& lost, std::string_view format) const {
  const auto name = [&](std::size_t count, std::string_view one) {
    add_loss(lost, count, one, fmt::format("{}s", one), fmt::format("left out: not written to {}", format));
  };
  for (std::size_t place = 0; place < type_names.size(); ++place) name(shapes_[place], type_names[place]);
  name(instances_, "instance");
  name(solids_, "solid");
}

}  // namespace durero::io
