// In the place of src/io/pictures/picture_file.cpp: a page has no files, and so no pictures.
#include "durero/io/pictures/picture_file.hpp"

namespace durero::io {

scene::TexelImage picture_of(std::string_view, scene::TransferFunction) {
  throw PictureError("a picture, which is not read here");
}

}  // namespace durero::io
