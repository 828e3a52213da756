#include "durero/scene/mesh.hpp"

#include <algorithm>
#include <charconv>

namespace durero::scene {

std::optional<std::uint32_t> face_number(std::string_view m, std::string_view name) noexcept {
  if (name.size() < m.size() + 2 || !name.starts_with(m) || name[m.size()] != ':') return std::nullopt;
  const std::string_view digits = name.substr(m.size() + 1);
  if (digits.size() > 1 && digits.front() == '0') return std::nullopt;
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

std::optional<std::size_t> Meshes::find(std::string_view m) const noexcept {
  const auto name = [](const std::shared_ptr<Mesh>& mesh) -> std::string_view { return mesh->m.name(); };
  const auto at = std::ranges::lower_bound(meshes_, m, {}, name);
  if (at == meshes_.end() || name(*at) != m) return std::nullopt;
  return static_cast<std::size_t>(at - meshes_.begin());
}

Meshes::Face Meshes::face(std::uint32_t number) const noexcept {
  const auto after = std::ranges::upper_bound(first_, number);
  const auto place = static_cast<std::size_t>(after - first_.begin()) - 1;
  return {*meshes_[place], number - first_[place]};
}

std::optional<std::uint32_t> Meshes::find_face(std::string_view name) const noexcept {
  if (meshes_.empty()) return std::nullopt;
  const std::size_t colon = name.rfind(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string_view m = name.substr(0, colon);
  const auto place = find(m);
  if (!place) return std::nullopt;
  const auto number = face_number(m, name);
  if (!number || *number >= meshes_[*place]->caras.size()) return std::nullopt;
  return first_[*place] + *number;
}

void Meshes::put(Mesh mesh) {
  auto made = std::make_shared<Mesh>(std::move(mesh));
  if (const auto place = find(made->m.name())) {
    meshes_[*place] = std::move(made);
  } else {
    first_.reserve(meshes_.size() + 2);
    const auto at = std::ranges::lower_bound(meshes_, made->m, {}, [](const auto& one) { return one->m; });
    meshes_.insert(at, std::move(made));
  }
  number_faces();
}

void Meshes::remove(std::size_t place) {
  meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(place));
  number_faces();
}

Mesh& Meshes::edited(std::size_t place) {
  std::shared_ptr<Mesh>& mesh = meshes_[place];
  if (mesh.use_count() > 1) mesh = std::make_shared<Mesh>(*mesh);
  return *mesh;
}

void Meshes::number_faces() {
  first_.assign(1, 0);
  for (const auto& mesh : meshes_) first_.push_back(first_.back() + static_cast<std::uint32_t>(mesh->caras.size()));
}

}  // namespace durero::scene
