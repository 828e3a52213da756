#include "durero/trace/counts.hpp"

namespace durero::trace {

Counts& Counts::operator+=(const Counts& other) {
  for (std::size_t step = 0; step < element.size(); ++step) {
    element[step] += other.element[step];
    order[step] += other.order[step];
    rounding[step] += other.rounding[step];
  }
  return *this;
}

}  // namespace durero::trace
