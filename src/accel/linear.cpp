#include "durero/accel/linear.hpp"

namespace durero::accel {

static_assert(Structure<LinearList>);

Size LinearList::size() const {
  const std::size_t apart = extraordinary().size(), elements = scene().size() - apart;
  const std::size_t ball = 4 * sizeof(double);  // a column each
  return {.elements = elements,
          .apart = apart,
          .bytes = elements * (ball + sizeof(scene::ElementRef)) + apart * sizeof(scene::ElementRef)};
}

}  // namespace durero::accel
