#include "gltf_buffer.hpp"

#include <algorithm>
#include <bit>

#include "io/byte_order.hpp"

namespace durero::io {
namespace {

constexpr std::uint64_t float_type = 5126, index_type = 5125;         // of components
constexpr std::uint64_t vertex_target = 34962, index_target = 34963;  // of views

}  // namespace

std::size_t GltfBuffer::add_vectors(std::span<const float> numbers, std::size_t per_vector, bool with_bounds) {
  Accessor made{bytes_.size(), 4 * numbers.size(), numbers.size() / per_vector, false, per_vector};
  for (const float number : numbers) append_little_endian(bytes_, std::bit_cast<std::uint32_t>(number), 4);
  for (std::size_t axis = 0; with_bounds && axis < per_vector; ++axis) {
    float least = numbers[axis], greatest = least;
    for (std::size_t i = axis; i < numbers.size(); i += per_vector)
      least = std::min(least, numbers[i]), greatest = std::max(greatest, numbers[i]);
    made.least.push_back(least);
    made.greatest.push_back(greatest);
  }
  accessors_.push_back(std::move(made));
  return accessors_.size() - 1;
}

std::size_t GltfBuffer::add_indices(std::span<const std::uint32_t> indices) {
  accessors_.push_back({bytes_.size(), 4 * indices.size(), indices.size(), true, 1});
  for (const std::uint32_t index : indices) append_little_endian(bytes_, index, 4);
  return accessors_.size() - 1;
}

void GltfBuffer::write(json::Writer& out) const {
  if (accessors_.empty()) return;
  const auto number = [](std::size_t n) { return static_cast<std::uint64_t>(n); };
  out.key("accessors").begin_array();
  for (std::size_t i = 0; i < accessors_.size(); ++i) {
    const Accessor& one = accessors_[i];
    out.new_line()
        .begin_object()
        .member("bufferView", number(i))
        .member("componentType", one.is_of_indices ? index_type : float_type);
    out.member("count", number(one.count));
    out.member("type", one.is_of_indices ? "SCALAR" : one.per_vector == 2 ? "VEC2" : "VEC3");
    for (const auto& [name, bounds] : {std::pair("min", &one.least), std::pair("max", &one.greatest)}) {
      if (bounds->empty()) continue;
      out.key(name).begin_array();
      for (const double bound : *bounds) out.value(bound);
      out.end_array();
    }
    out.end_object();
  }
  out.end_array().new_line().key("bufferViews").begin_array();
  for (const Accessor& one : accessors_)
    out.new_line()
        .begin_object()
        .member("buffer", number(0))
        .member("byteOffset", number(one.begin))
        .member("byteLength", number(one.bytes))
        .member("target", one.is_of_indices ? index_target : vertex_target)
        .end_object();
  out.end_array();
}

}  // namespace durero::io
