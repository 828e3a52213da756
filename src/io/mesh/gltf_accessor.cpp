#include "gltf_accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "durero/io/json/whole_number.hpp"
#include "durero/text/shown.hpp"
#include "io/byte_order.hpp"

namespace durero::io {
namespace {

constexpr std::array gltf_components{
    GltfComponent{5120, "byte", 1, true, 127},        GltfComponent{5121, "unsigned byte", 1, false, 255},
    GltfComponent{5122, "short", 2, true, 32767},     GltfComponent{5123, "unsigned short", 2, false, 65535},
    GltfComponent{5125, "unsigned int", 4, false, 0}, GltfComponent{5126, "float", 4, true, 0},
};

constexpr std::size_t most_zeros = std::size_t{1} << 20U;  // elements of an accessor that has no bytes

const GltfComponent* component_of(json::Reader& in, std::string_view key) {
  const std::size_t at = in.offset();
  const double number = in.number(key);
  const auto* const found =
      std::ranges::find_if(gltf_components, [&](const GltfComponent& c) { return c.number == number; });
  if (found == gltf_components.end())
    in.fail(at, fmt::format("{} is {}", key, number), "expected one of 5120, 5121, 5122, 5123, 5125, 5126");
  return found;
}

/// How many components a type has; 0 where it is a matrix.
std::size_t components_of(json::Reader& in, std::string_view& type) {
  constexpr std::array<std::string_view, 7> types{"MAT2", "SCALAR", "VEC2", "VEC3", "VEC4", "MAT3", "MAT4"};
  const std::size_t at = in.offset();
  type = in.string("type");
  const auto found = static_cast<std::size_t>(std::ranges::find(types, type) - types.begin());
  if (found == types.size())
    in.fail(at, fmt::format("type is {}", text::shown(type)),
            "expected one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
  return found < 5 ? found : 0;
}

}  // namespace

GltfAccessor::GltfAccessor(const Source& source, const GltfJson& file, GltfBuffers& buffers,
                           const GltfReference& reference)
    : source_(source), number_(reference.number) {
  json::Reader in = file.item(GltfArray::accessors, number_);
  at_ = in.offset();
  Slice elements;
  std::optional<Sparse> sparse;
  read(in, file, elements, sparse);
  if (component_ == nullptr || type_.empty() || count_ == 0)
    fail("lacks a key", "expected componentType, type and count");
  if (is_normalized_ && component_->unit == 0)
    fail(fmt::format("has a {} that is normalized", component_->name), "expected bytes or shorts");
  if (components_ == 0) return;  // a matrix, which no mesh has
  if (elements.view)
    find(elements, buffers);
  else if (count_ > most_zeros)
    fail(fmt::format("has {} elements and no bufferView", count_), fmt::format("expected {} at most", most_zeros));
  if (sparse) find(*sparse, buffers);
}

void GltfAccessor::read(json::Reader& in, const GltfJson& file, Slice& elements, std::optional<Sparse>& sparse) {
  read_known(in, "an item of accessors", [&](std::string_view key) {
    if (key == "bufferView")
      elements.view = file.reference(in, key, GltfArray::buffer_views);
    else if (key == "byteOffset")
      elements.offset = json::whole_number(in, key);
    else if (key == "componentType")
      component_ = component_of(in, key);
    else if (key == "normalized")
      is_normalized_ = in.boolean(key);
    else if (key == "count")
      count_ =
          static_cast<std::uint64_t>(json::whole_number(in, key, 1, json::most_whole, "a whole number from 1 to 2^53"));
    else if (key == "type")
      components_ = components_of(in, type_);
    else if (key == "sparse")
      sparse = read_sparse(in, file);
    else
      return false;
    return true;
  });
}

GltfAccessor::Sparse GltfAccessor::read_sparse(json::Reader& in, const GltfJson& file) {
  Sparse sparse{.at = in.offset()};
  const auto read_slice = [&](std::string_view what, Slice& slice, const GltfComponent** component) {
    read_known(in, what, [&](std::string_view key) {
      if (key == "bufferView")
        slice.view = file.reference(in, key, GltfArray::buffer_views);
      else if (key == "byteOffset")
        slice.offset = json::whole_number(in, key);
      else if (key == "componentType" && component != nullptr)
        *component = component_of(in, key);
      else
        return false;
      return true;
    });
  };
  read_known(in, "sparse", [&](std::string_view key) {
    if (key == "count")
      sparse.count = json::whole_number(in, key);
    else if (key == "indices")
      read_slice(key, sparse.indices, &sparse.index);
    else if (key == "values")
      read_slice(key, sparse.values, nullptr);
    else
      return false;
    return true;
  });
  const bool has_index = sparse.index != nullptr && sparse.index->number % 2 == 1;
  if (!has_index || !sparse.indices.view || !sparse.values.view)
    in.fail(sparse.at, "a sparse accessor without indices or values",
            "expected a bufferView of each, and indices of componentType 5121, 5123 or 5125");
  return sparse;
}

std::string_view GltfAccessor::part(const Slice& slice, std::size_t size, GltfBuffers& buffers) const {
  const GltfView found = buffers.view(*slice.view);
  if (slice.offset > found.bytes.size() || size > found.bytes.size() - slice.offset)
    fail(fmt::format("needs {} bytes from {} on of bufferView {}, which has {}", size, slice.offset, slice.view->number,
                     found.bytes.size()),
         "expected it within its view");
  return found.bytes.substr(slice.offset);
}

void GltfAccessor::find(const Slice& elements, GltfBuffers& buffers) {
  const std::uint64_t stride = buffers.view(*elements.view).stride;
  if (stride != 0 && stride < size())
    fail(fmt::format("has elements of {} bytes and a stride of {}", size(), stride), "expected a longer stride");
  view_.stride = stride == 0 ? size() : stride;
  view_.bytes = part(elements, view_.stride * (count_ - 1) + size(), buffers);
}

void GltfAccessor::find(const Sparse& sparse, GltfBuffers& buffers) {
  const std::size_t width = sparse.index->size;
  const std::string_view indices = part(sparse.indices, sparse.count * width, buffers);
  sparse_bytes_ = part(sparse.values, sparse.count * size(), buffers);
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const std::uint64_t index = little_endian(indices.substr(i * width, width));
    if (index >= count_ || (i > 0 && index <= sparse_.back()))
      source_.fail(sparse.at, fmt::format("index {} of a sparse accessor is {}", i, index),
                   fmt::format("expected numbers below {} that ascend", count_));
    sparse_.push_back(index);
  }
}

void GltfAccessor::require_vectors(std::string_view type) const {
  if (type_ != type || component_->number == 5125)
    fail(fmt::format("is {} of {}", type_, component_->name),
         fmt::format("expected {} of float, bytes or shorts", type));
}

void GltfAccessor::require_indices() const {
  if (type_ != "SCALAR" || component_->is_signed || is_normalized_)
    fail(fmt::format("is {}{} of {}", is_normalized_ ? "normalized " : "", type_, component_->name),
         "expected SCALAR of unsigned byte, short or int");
}

GltfAccessor::Element GltfAccessor::element(std::size_t number) const {
  Element element{};
  const auto own = std::ranges::lower_bound(sparse_, number);
  std::string_view bytes;
  if (own != sparse_.end() && *own == number)
    bytes = sparse_bytes_.substr(static_cast<std::size_t>(own - sparse_.begin()) * size());
  else if (!view_.bytes.empty())
    bytes = view_.bytes.substr(number * view_.stride);
  else
    return element;
  for (std::size_t i = 0; i < components_; ++i)
    element[i] = number_at(bytes.substr(i * component_->size, component_->size));
  return element;
}

double GltfAccessor::number_at(std::string_view bytes) const {
  const std::uint64_t bits = little_endian(bytes);
  if (component_->number == 5126) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  const auto number = static_cast<double>(bits);
  const auto modulus = static_cast<double>(no_index() + 1);
  const double own = component_->is_signed && number >= modulus / 2 ? number - modulus : number;
  return is_normalized_ ? std::max(own, -divisor()) : own;  // of both least numbers, −1 is the value
}

GltfAccessor::Element GltfAccessor::finite_element(std::size_t number) const {
  const Element found = element(number);
  for (const double x : found)
    if (!std::isfinite(x))
      fail(fmt::format("has a number that is not finite in element {}, counted from 0", number),
           "expected finite numbers");
  return found;
}

void GltfAccessor::fail(const std::string& wrong, const std::string& expected) const {
  source_.fail(at_, fmt::format("accessor {} {}", number_, wrong), expected);
}

}  // namespace durero::io
