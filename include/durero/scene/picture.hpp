#pragma once
/// A picture that a surface wears or that stands around a scene: texels, and the ever smaller versions of it.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace durero::scene {

/// Texels of linear colours or of plain numbers, as whoever made it says.
struct TexelImage {
  std::uint32_t width = 0;           ///< of a row, in texels
  std::uint32_t height = 0;          ///< how many rows
  std::vector<glm::dvec3> texels{};  ///< rows from the top
  bool operator==(const TexelImage&) const = default;

  /// Texel (j, k), (0, 0) upper left. Precondition: it is in the picture.
  const glm::dvec3& at(std::uint32_t j, std::uint32_t k) const { return texels[std::size_t{k} * width + j]; }
};

/// Whether it has 2ⁿ × 2ⁿ texels, of which alone the realism seed (1.1) makes a mipmap.
bool has_mipmap(const TexelImage& picture) noexcept;

/// The mipmap of a picture M₀ of 2ⁿ × 2ⁿ texels (realism seed, 1.1): M₀, M₁, …, Mₙ, where
/// M_{i+1}[j, k] = ¼(Mᵢ[2j, 2k] + Mᵢ[2j+1, 2k] + Mᵢ[2j, 2k+1] + Mᵢ[2j+1, 2k+1]). So each has the mean of M₀, and Mₙ is
/// it. Throws std::invalid_argument where has_mipmap() is false.
std::vector<TexelImage> mipmap(TexelImage picture);

/// A file with a picture, and the picture once it has been read.
struct PictureFile {
  std::string file{};  ///< as written, from the folder of the scene's file
  std::shared_ptr<const std::vector<TexelImage>> levels =
      {};  ///< the picture, or its whole mipmap; null until it is read

  /// Of the same file: what was read of it is no part of what a scene says.
  bool operator==(const PictureFile& other) const { return file == other.file; }
};

}  // namespace durero::scene
