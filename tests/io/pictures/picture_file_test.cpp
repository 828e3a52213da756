#include "durero/io/pictures/picture_file.hpp"

#include <cstdio>
// It needs the one above.
#include <jpeglib.h>
#include <png.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;
using io::picture_of;
using scene::TransferFunction;

namespace {

/// By libpng, of 8 or of 16 bits.
std::string png(std::uint32_t width, std::uint32_t height, png_uint_32 format, const void* samples) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  png_alloc_size_t size = 0;
  REQUIRE(png_image_write_to_memory(&image, nullptr, &size, 0, samples, 0, nullptr));
  std::string bytes(size, '\0');
  REQUIRE(png_image_write_to_memory(&image, bytes.data(), &size, 0, samples, 0, nullptr));
  bytes.resize(size);
  return bytes;
}

/// A grey one of one value, by libjpeg.
std::string jpeg(std::uint32_t width, std::uint32_t height, std::uint8_t value) {
  jpeg_compress_struct out{};
  jpeg_error_mgr errors{};
  out.err = jpeg_std_error(&errors);
  jpeg_create_compress(&out);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&out, &bytes, &size);
  out.image_width = width;
  out.image_height = height;
  out.input_components = 1;
  out.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&out);
  jpeg_start_compress(&out, TRUE);
  std::vector<std::uint8_t> row(width, value);
  JSAMPROW rows = row.data();
  while (out.next_scanline < height) jpeg_write_scanlines(&out, &rows, 1);
  jpeg_finish_compress(&out);
  std::string text(reinterpret_cast<char*>(bytes), size);
  jpeg_destroy_compress(&out);
  std::free(bytes);
  return text;
}

const std::uint8_t six[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 128, 51, 10};

/// What reading the pictures of a scene says, without the folder; empty where nothing is wrong.
std::string said(const test::Folder& folder, const std::string& parts) {
  const std::string name = folder.file("s.json");
  const io::Source source(name, "{\"format\":\"durero-scene\",\"version\":1,\"elementos\":[],\n" + parts + "}");
  scene::Scene scene = io::read_scene(source);
  try {
    io::read_pictures(source, scene.stage());
  } catch (const io::InputError& error) {
    return std::string(error.what()).substr(folder.file("").size());
  }
  return "";
}

}  // namespace

TEST_CASE("a PNG of 8 bits: rows from the top, by the curve or as it stands") {
  const std::string bytes = png(3, 2, PNG_FORMAT_RGB, six);
  const scene::TexelImage plain = picture_of(bytes, TransferFunction::linear);
  CHECK((plain.width == 3 && plain.height == 2));
  CHECK(plain.at(0, 0) == glm::dvec3(1, 0, 0));
  CHECK(plain.at(2, 0) == glm::dvec3(0, 0, 1));
  CHECK(plain.at(0, 1) == glm::dvec3(0));
  CHECK(plain.at(2, 1) == glm::dvec3(128, 51, 10) / 255.0);
  const scene::TexelImage light = picture_of(bytes, TransferFunction::srgb);
  CHECK(light.at(1, 1) == glm::dvec3(1));
  CHECK(light.at(2, 1) == glm::dvec3(io::linear_light(128), io::linear_light(51), io::linear_light(10)));
}

TEST_CASE("the curve is that of sRGB") {
  CHECK(io::linear_light(0) == 0);
  CHECK(io::linear_light(255) == 1);
  CHECK(io::linear_light(10) == Approx(10 / 255.0 / 12.92).epsilon(1e-15));
  CHECK(io::linear_light(11) == Approx(std::pow((11 / 255.0 + 0.055) / 1.055, 2.4)).epsilon(1e-15));
  CHECK(io::linear_light(188) == Approx(0.5029).epsilon(1e-3));
}

TEST_CASE("a PNG of 16 bits is linear, whatever the curve") {
  const std::uint16_t samples[] = {0, 1000, 65535, 32768, 7, 0};
  const std::string bytes = png(2, 1, PNG_FORMAT_LINEAR_RGB, samples);
  for (const TransferFunction curve : {TransferFunction::srgb, TransferFunction::linear}) {
    const scene::TexelImage picture = picture_of(bytes, curve);
    CHECK(picture.at(0, 0) == glm::dvec3(0, 1000, 65535) / 65535.0);
    CHECK(picture.at(1, 0) == glm::dvec3(32768, 7, 0) / 65535.0);
  }
}

TEST_CASE("a JPEG of odd size, grey") {
  const scene::TexelImage picture = picture_of(jpeg(5, 3, 100), TransferFunction::linear);
  CHECK((picture.width == 5 && picture.height == 3));
  REQUIRE(picture.texels.size() == 15);
  for (const glm::dvec3& texel : picture.texels) CHECK(texel == glm::dvec3(100 / 255.0));
}

TEST_CASE("what is no picture, and what ends early, is refused") {
  CHECK_THROWS_WITH(picture_of("", TransferFunction::srgb), "it is no picture");
  CHECK_THROWS_WITH(picture_of("GIF89a", TransferFunction::srgb), "it is no picture");
  const std::string whole_png = png(3, 2, PNG_FORMAT_RGB, six), whole_jpeg = jpeg(64, 64, 9);
  for (const std::string& whole : {whole_png, whole_jpeg})
    for (const std::size_t tenths : {3U, 6U})
      CHECK_THROWS_AS(picture_of(whole.substr(0, whole.size() * tenths / 10), TransferFunction::srgb),
                      io::PictureError);
  // libpng asks for nothing behind the last texel.
  const std::uint16_t deep[] = {0, 1000, 65535, 32768, 7, 0};
  for (const std::string& whole : {whole_png, png(2, 1, PNG_FORMAT_LINEAR_RGB, deep)}) {
    CHECK_THROWS_WITH(picture_of(whole.substr(0, whole.size() - 12), TransferFunction::srgb),
                      "it ends before its end chunk, IEND");
    for (std::size_t missing = 1; missing < whole.size(); ++missing)
      CHECK_THROWS_AS(picture_of(whole.substr(0, whole.size() - missing), TransferFunction::srgb), io::PictureError);
    CHECK(picture_of(whole + "behind the end", TransferFunction::linear) ==
          picture_of(whole, TransferFunction::linear));
  }
  // Of the latter libjpeg would make up what is missing, and warn.
  CHECK_THROWS_AS(picture_of(whole_jpeg.substr(0, whole_jpeg.size() - 8), TransferFunction::srgb), io::PictureError);
}

TEST_CASE("a picture of too many texels is refused before it is decoded") {
  CHECK_THROWS_WITH(picture_of(jpeg(8192, 4097, 9), TransferFunction::srgb),
                    "it has 8192 by 4097 texels, more than 33554432");
}

TEST_CASE("pictures of a scene: from its folder, with their mipmaps, and errors with their place") {
  const test::Folder folder;
  const std::uint8_t four[4 * 4 * 3] = {9};
  io::write_file(folder.file("odd.png"), png(3, 2, PNG_FORMAT_RGB, six));
  io::write_file(folder.file("even.png"), png(4, 4, PNG_FORMAT_RGB, four));
  io::write_file(folder.file("text.png"), "no picture at all");

  const io::Source source(folder.file("s.json"),
                          R"({"format":"durero-scene","version":1,"elementos":[],"textures":{
"a":{"image":"odd.png"},"b":{"image":"even.png","filter":"mipmap","near":2},"c":{"checker":[[1,1,1],[0,0,0]]}},
"environment":{"box":["odd.png","odd.png","odd.png","odd.png","odd.png","even.png"]}})");
  scene::Scene scene = io::read_scene(source);
  io::read_pictures(source, scene.stage());
  const auto& textures = scene.stage().textures;
  CHECK(textures[0].image.levels->size() == 1);
  CHECK(textures[0].image.levels->front().at(0, 0) == glm::dvec3(1, 0, 0));
  CHECK(textures[1].image.levels->size() == 3);
  CHECK_FALSE(textures[2].image.levels);
  CHECK(scene.stage().environment->pictures[5].levels->front().width == 4);

  CHECK(said(folder, R"("textures":{"a":{"image":"odd.png","filter":"mipmap","near":1}})") ==
        "s.json:2:26: image is \"odd.png\": it has 3 by 2 texels; expected 2ⁿ by 2ⁿ for a mipmap");
  CHECK(said(folder, R"("textures":{"a":{"image":"none.png"}})") ==
        "s.json:2:26: image is \"none.png\": No such file or directory; expected a PNG or JPEG file");
  CHECK(said(folder, R"("textures":{"a":{"image":"text.png"}})") ==
        "s.json:2:26: image is \"text.png\": it is no picture; expected a PNG or JPEG file");
  CHECK(said(folder, R"("environment":{"box":["odd.png","odd.png","text.png","odd.png","odd.png","odd.png"]})") ==
        "s.json:2:43: box is \"text.png\": it is no picture; expected a PNG or JPEG file");
  CHECK(said(folder, R"("environment":{"spherical":"text.png"})") ==
        "s.json:2:28: spherical is \"text.png\": it is no picture; expected a PNG or JPEG file");
}

TEST_CASE("pictures keep their files when a scene goes into another folder") {
  const test::Folder folder;
  for (const char* name : {"a", "a/b", "c", "real", "real/deep"}) std::filesystem::create_directory(folder.file(name));
  std::filesystem::create_directory_symlink(folder.file("real/deep"), folder.file("link"));
  const auto renamed = [&](const std::string& picture, const std::string& from, const std::string& to) {
    scene::Stage stage;
    stage.textures = {{.name = "t", .pattern = scene::Pattern::image, .image = {picture}}, {.name = "u"}};
    stage.environment = scene::Environment{.kind = scene::Surroundings::spherical, .pictures = {{picture}}};
    io::rename_pictures(stage, folder.file(from), folder.file(to));
    CHECK(stage.environment->pictures[0].file == stage.textures[0].image.file);
    CHECK(stage.textures[1].image.file.empty());
    return stage.textures[0].image.file;
  };
  CHECK(renamed("p.png", "a/s.json", "a/t.json") == "p.png");
  CHECK(renamed("../p.png", "a/s.json", "c/../a/t.json") == "../p.png");
  CHECK(renamed("/p.png", "a/s.json", "c/t.json") == "/p.png");
  CHECK(renamed("p.png", "a/s.json", "c/t.json") == "../a/p.png");
  CHECK(renamed("in/p.png", "s.json", "a/b/t.json") == "../../in/p.png");
  CHECK(renamed("p.png", "a/b/s.json", "t.json") == "a/b/p.png");
  CHECK(renamed("../p.png", "a/b/s.json", "a/t.json") == "p.png");
  CHECK(renamed("../../c/p.png", "a/b/s.json", "c/t.json") == "p.png");
  // Where a folder has another name, what is above it is above the folder itself.
  CHECK(renamed("p.png", "c/s.json", "link/t.json") == "../../c/p.png");
  CHECK(renamed("../p.png", "link/s.json", "c/t.json") == "../real/p.png");
}
