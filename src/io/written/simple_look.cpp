#include "simple_look.hpp"

#include <algorithm>

#include "io/simple_looks.hpp"

namespace durero::io {
namespace {

/// A colour of which a share goes on: where that is all, it stays bit for bit.
glm::dvec3 share_of_color(const glm::dvec3& color, double share) { return share == 1 ? color : color * share; }

scene::Material read_look(const SimpleLook& look) {
  switch (look.kind) {
    case SimpleKind::diffuse:
      return {.color = look.color};
    case SimpleKind::mirror:
      return mirror_of(look.color);
    case SimpleKind::glass:
      return glass_of(look.color, look.index);
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

}  // namespace

SimpleLook simple_look(const scene::Material& m) {
  if (m.k_t > 0 && m.k_t >= std::max(m.k_d, m.k_ps)) return {SimpleKind::glass, share_of_color(m.M_T, m.k_t), m.index};
  if (m.k_ps > m.k_d) return {SimpleKind::mirror, share_of_color(m.M_PS, m.k_ps)};
  return {SimpleKind::diffuse, share_of_color(m.color, m.k_d)};
}

// Numbers of shares that are 0 change nothing.
bool is_look(const SimpleLook& look, const scene::Material& material) {
  scene::Material read = read_look(look);
  read.name = material.name;
  read.emission = material.emission;
  if (material.k_s == 0) read.e = material.e;
  if (material.k_t == 0) read.index = material.index, read.M_T = material.M_T;
  if (material.k_ps == 0) read.M_PS = material.M_PS;
  if (material.k_d == 0 && material.k_a == 0) read.color = material.color;
  return read == material;
}

}  // namespace durero::io
