#include "durero/render/output/image.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <new>
#include <stdexcept>
#include <utility>

#include "durero/scene/srgb.hpp"

namespace durero::render {
namespace {

/// The state of libpng's writer. Its errors leave by longjmp, so that objects with a destructor live here and not in
/// between.
struct Writing {
  explicit Writing(std::span<const Note> notes) {
    for (const Note& note : notes) texts.push_back(text_of(note));
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, refuse, [](png_structp, png_const_charp) {});
    if (png) info = png_create_info_struct(png);
    if (!info) {
      png_destroy_write_struct(&png, &info);
      throw std::bad_alloc();
    }
    png_set_write_fn(png, this, append, [](png_structp) {});
  }
  ~Writing() { png_destroy_write_struct(&png, &info); }
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;

  static png_text text_of(const Note& note) {
    const bool ascii = std::all_of(note.text.begin(), note.text.end(), [](char c) { return (c & 0x80) == 0; });
    png_text text{};
    text.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(note.keyword.c_str());  // libpng copies both and changes neither
    text.text = const_cast<char*>(note.text.c_str());
    (ascii ? text.text_length : text.itxt_length) = note.text.size();
    return text;
  }
  static void append(png_structp png, png_bytep data, png_size_t size) {
    bool full = false;
    try {
      static_cast<Writing*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), size);
    } catch (const std::bad_alloc&) {
      full = true;
    }
    if (full) png_error(png, "memory is full");
  }
  [[noreturn]] static void refuse(png_structp png, png_const_charp message) {
    static_cast<Writing*>(png_get_error_ptr(png))->complaint = message;
    png_longjmp(png, 1);
  }

  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<png_text> texts{};
  std::string bytes{};
  std::string complaint{};
};

/// Whether libpng has written it all.
bool written(Writing& to, const Image& image) {
  if (setjmp(png_jmpbuf(to.png))) return false;
  png_set_IHDR(to.png, to.info, image.resolution.width, image.resolution.height, 8, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // PNG's filters take two thirds of the time of the writer, and make most rendered pictures no smaller.
  png_set_filter(to.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_sRGB_gAMA_and_cHRM(to.png, to.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_text(to.png, to.info, to.texts.data(), static_cast<int>(to.texts.size()));
  png_write_info(to.png, to.info);
  for (std::uint32_t y = 0; y < image.resolution.height; ++y)
    png_write_row(to.png, &image.rgb[std::size_t(y) * image.resolution.width * 3]);
  png_write_end(to.png, nullptr);
  return true;
}

}  // namespace

void Image::set(std::uint32_t x, std::uint32_t y, const glm::dvec3& color) {
  std::uint8_t* pixel = &rgb[(std::size_t(y) * resolution.width + x) * 3];
  for (int i = 0; i < 3; ++i) pixel[i] = scene::srgb_byte(color[i]);
}

std::string encode_png(const Image& image, std::span<const Note> notes) {
  Writing to(notes);
  if (!written(to, image)) throw std::runtime_error(to.complaint);
  return std::move(to.bytes);
}

}  // namespace durero::render
