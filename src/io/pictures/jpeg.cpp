#include "jpeg.hpp"

#include <csetjmp>
#include <cstdio>
// It needs the two above.
#include <jpeglib.h>

namespace durero::io {
namespace {

/// libjpeg leaves by a jump where it gives up. No value with a destructor is made between setjmp and the calls that may
/// jump: what they fill stands outside.
struct Errors {
  jpeg_error_mgr base;
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void give_up(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<Errors*>(jpeg->err);
  errors->base.format_message(jpeg, errors->message);
  std::longjmp(errors->back, 1);
}

/// Of a warning: the file is damaged, and libjpeg would make up what is not there.
void warn(j_common_ptr jpeg, int level) {
  if (level < 0) give_up(jpeg);
}

}  // namespace

std::string decode_jpeg(std::string_view bytes, std::size_t most, Jpeg& to) {
  jpeg_decompress_struct jpeg{};
  Errors errors{};
  jpeg.err = jpeg_std_error(&errors.base);
  errors.base.error_exit = give_up;
  errors.base.emit_message = warn;
  if (setjmp(errors.back) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return errors.message;
  }
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  to.width = jpeg.image_width;
  to.height = jpeg.image_height;
  if (std::size_t{to.width} * to.height <= most) {
    jpeg.out_color_space = JCS_RGB;
    jpeg.dct_method = JDCT_ISLOW;  // whole numbers: the same bytes on every machine
    jpeg_start_decompress(&jpeg);
    to.rgb.resize(std::size_t{to.width} * to.height * 3);
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPROW row = to.rgb.data() + std::size_t{jpeg.output_scanline} * to.width * 3;
      jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
  }
  jpeg_destroy_decompress(&jpeg);
  return {};
}

}  // namespace durero::io
