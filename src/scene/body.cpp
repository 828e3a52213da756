#include "durero/scene/body.hpp"

namespace durero::scene {
namespace {

Instance copied(const model::Mapa& by, const Instance& instance) {
  return {instance.shape, model::compuesto(by, instance.mapa)};
}

std::string_view word_of(const Instance&) { return "instancia"; }

}  // namespace

Body copied(const model::Mapa& by, const Body& body) {
  return std::visit([&](const auto& form) { return Body{copied(by, form)}; }, body.form);
}

std::string_view word_of(const Body& body) {
  return std::visit([](const auto& form) { return word_of(form); }, body.form);
}

}  // namespace durero::scene
