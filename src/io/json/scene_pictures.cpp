// The pictures that a scene names.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>

#include "durero/io/json/json.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/file.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

using scene::PictureFile;
using scene::TexelImage;
using scene::Texture;

class PictureReader {
 public:
  explicit PictureReader(const Source& source)
      : source_(source), folder_(std::filesystem::path(source.name()).parent_path()) {}

  void read(Texture& texture) {
    if (texture.pattern != scene::Pattern::image) return;
    const auto at = [&](const json::Reader& scene) {
      return scene.member("textures").value().member(texture.name).value().member("image").value().offset();
    };
    TexelImage picture = read(texture.image.file, texture.curve, "image", at);
    const bool is_mipmap = texture.filter == scene::Filter::mipmap;
    if (is_mipmap && !has_mipmap(picture))
      fail(texture.image.file, "image", at, fmt::format("it has {} by {} texels", picture.width, picture.height),
           "2ⁿ by 2ⁿ for a mipmap");
    texture.image.levels = std::make_shared<const std::vector<TexelImage>>(
        is_mipmap ? mipmap(std::move(picture)) : std::vector<TexelImage>{std::move(picture)});
  }

  void read(scene::Environment& environment) {
    const std::string_view kind = scene::surroundings_words[static_cast<std::size_t>(environment.kind)];
    for (std::size_t i = 0; i < environment.pictures.size(); ++i) {
      PictureFile& file = environment.pictures[i];
      const auto at = [&](const json::Reader& scene) {
        const json::Reader in = scene.member("environment").value().member(kind).value();
        return environment.kind == scene::Surroundings::box ? item(in, i) : in.offset();
      };
      file.levels = std::make_shared<const std::vector<TexelImage>>(
          std::vector<TexelImage>{read(file.file, scene::TransferFunction::srgb, kind, at)});
    }
  }

 private:
  using Place = std::function<std::size_t(const json::Reader&)>;

  static std::size_t item(json::Reader in, std::size_t number) {
    std::size_t offset = 0, i = 0;
    in.array("box", [&] {
      if (i++ == number) offset = in.offset();
      in.skip();
    });
    return offset;
  }

  TexelImage read(const std::string& file, scene::TransferFunction curve, std::string_view what, const Place& at) {
    try {
      return picture_of(text::read_file((folder_ / file).string()), curve);
    } catch (const std::system_error& error) {
      fail(file, what, at, error.code().message());
    } catch (const PictureError& error) {
      fail(file, what, at, error.what());
    }
  }

  [[noreturn]] void fail(const std::string& file, std::string_view what, const Place& at, const std::string& wrong,
                         std::string_view expected = "a PNG or JPEG file") const {
    const json::Document document(source_);
    source_.fail(at(json::Reader(document)), fmt::format("{} is {}: {}", what, text::shown(file), wrong),
                 fmt::format("expected {}", expected));
  }

  const Source& source_;
  std::filesystem::path folder_;
};

/// The folder that a file is in, without symbolic links, so that its parent is that of its name.
std::filesystem::path folder_of(const std::string& file) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(file).parent_path());
}

/// Whether a folder is above another, or is it.
bool leads_to(const std::filesystem::path& above, const std::filesystem::path& folder) {
  return std::mismatch(above.begin(), above.end(), folder.begin(), folder.end()).first == above.end();
}

}  // namespace

void rename_pictures(scene::Stage& stage, const std::string& from, const std::string& to) {
  const std::filesystem::path old_folder = folder_of(from), folder = folder_of(to);
  if (old_folder == folder) return;
  const auto rename = [&](PictureFile& picture) {
    const std::filesystem::path name = picture.file;
    if (name.empty() || name.is_absolute()) return;
    std::filesystem::path above = old_folder;
    auto part = name.begin();
    for (; part != name.end() && *part == ".."; ++part) above = above.parent_path();
    for (; part != name.end() && leads_to(above / *part, folder); ++part) above /= *part;
    std::filesystem::path renamed = above.lexically_relative(folder);
    if (renamed == ".") renamed.clear();
    for (; part != name.end(); ++part) renamed /= *part;
    picture.file = renamed.string();
  };
  for (Texture& texture : stage.textures)
    if (texture.pattern == scene::Pattern::image) rename(texture.image);
  if (!stage.environment) return;
  for (PictureFile& picture : stage.environment->pictures) rename(picture);
}

void read_pictures(const Source& source, scene::Stage& stage) {
  PictureReader reader(source);
  for (Texture& texture : stage.textures) reader.read(texture);
  if (stage.environment) reader.read(*stage.environment);
}

}  // namespace durero::io
