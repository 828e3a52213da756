#pragma once
/// Pictures in files: PNG, by libpng, and JPEG, by libjpeg.

#include <stdexcept>
#include <string>
#include <string_view>

#include "durero/io/source.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

/// What is wrong with a picture; what() is the half of a message before its semicolon.
class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The most texels of a picture: as many as 8192 by 4096.
inline constexpr std::size_t most_texels = std::size_t{1} << 25U;

/// The linear light of a byte on the curve of sRGB: scene::linear_of_srgb of byte/255.
double linear_light(std::uint8_t srgb) noexcept;

/// The picture in the bytes of a PNG or JPEG file, by its first bytes. Of 8 bits its values are read by the curve:
/// `linear` takes them as they stand, of 255. Of 16 bits they are what libpng takes for linear light, whatever the
/// curve. What is transparent lies before black. Throws PictureError where the bytes are neither, where texels are
/// missing, and where they are more than most_texels.
scene::TexelImage picture_of(std::string_view bytes, scene::TransferFunction curve);

/// Reads every picture that the textures and the environment of a scene name, from the folder that the scene's file is
/// in, and makes the mipmaps. Throws InputError at the first name whose file cannot be read or holds no such picture.
/// Precondition: the stage is what read_scene() read from the source.
void read_pictures(const Source& source, scene::Stage& stage);

/// Names the pictures of a stage that was read from file `from` as file `to` has to name them, from its own folder.
/// Where both are in one folder, and where a name starts at the root, it stays as it is. Whether there is such a
/// picture is not asked. Throws std::filesystem::filesystem_error where a folder cannot be looked up.
void rename_pictures(scene::Stage& stage, const std::string& from, const std::string& to);

}  // namespace durero::io
