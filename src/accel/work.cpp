#include "durero/accel/work.hpp"

namespace durero::accel {

Work& Work::operator+=(const Work& other) {
  rays += other.rays;
  volumes += other.volumes;
  nodes += other.nodes;
  cells += other.cells;
  by_miss += other.by_miss;
  by_distance += other.by_distance;
  candidates += other.candidates;
  repeated += other.repeated;
  untested += other.untested;
  return *this;
}

}  // namespace durero::accel
