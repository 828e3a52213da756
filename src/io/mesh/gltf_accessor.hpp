#pragma once
/// The accessors of a glTF file: arrays of numbers and vectors in its buffers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gltf_buffers.hpp"

namespace durero::io {

/// The type of a component, by its number in a file.
struct GltfComponent {
  int number;
  std::string_view name;
  std::size_t size;  ///< bytes
  bool is_signed;
  std::uint32_t unit;  ///< stands for 1 where it is normalized; 0 where it cannot be
};

/// An accessor, whose elements are read when they are asked for: those that stand in its view, each at its stride, and
/// in their place those of a sparse accessor; without a view all are 0.
class GltfAccessor {
 public:
  /// Numbers up to four, of which an element has the first ones.
  using Element = std::array<double, 4>;

  /// Throws InputError, also where the bytes do not reach. The buffers must outlive it.
  GltfAccessor(const Source& source, const GltfJson& file, GltfBuffers& buffers, const GltfReference& reference);

  std::size_t count() const { return count_; }
  /// A component is its number in an element over this: 1, but where it is normalized.
  double divisor() const { return is_normalized_ ? component_->unit : 1; }
  /// Throws InputError where it is not of that type: VEC3 of float, and of bytes and shorts, normalized or not.
  void require_vectors(std::string_view type) const;
  /// Throws InputError where its elements are not whole numbers without sign.
  void require_indices() const;

  /// The numbers of an element, exactly. Precondition: there is such an element.
  Element element(std::size_t number) const;
  /// The same; throws InputError where one of them is not finite.
  Element finite_element(std::size_t number) const;
  /// The greatest number that an index of its component may be, which stands for no vertex.
  std::uint64_t no_index() const { return (std::uint64_t{1} << 8U * component_->size) - 1; }
  /// Whether it has a view, or is sparse: whether any of its numbers stands in the file.
  bool has_bytes() const { return !view_.bytes.empty() || !sparse_.empty(); }

  /// Throws InputError at the accessor, which the message names.
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const;

 private:
  struct Slice {
    std::optional<GltfReference> view;
    std::uint64_t offset = 0;
  };
  struct Sparse {
    std::size_t at = 0, count = 0;
    Slice indices{}, values{};
    const GltfComponent* index = nullptr;
  };

  void read(json::Reader& in, const GltfJson& file, Slice& elements, std::optional<Sparse>& sparse);
  static Sparse read_sparse(json::Reader& in, const GltfJson& file);
  void find(const Slice& elements, GltfBuffers& buffers);
  void find(const Sparse& sparse, GltfBuffers& buffers);
  std::string_view part(const Slice& slice, std::size_t size, GltfBuffers& buffers) const;
  std::size_t size() const { return components_ * component_->size; }
  double number_at(std::string_view bytes) const;

  const Source& source_;
  std::size_t number_, at_;
  std::string_view type_;
  std::size_t components_ = 0;
  const GltfComponent* component_ = nullptr;
  bool is_normalized_ = false;
  std::uint64_t count_ = 0;
  GltfView view_;
  std::vector<std::uint64_t> sparse_;  ///< ascending: the numbers of the elements that stand elsewhere
  std::string_view sparse_bytes_;
};

}  // namespace durero::io
