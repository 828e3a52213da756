#include "durero/model/delta.hpp"

namespace durero::model {

bool Delta::added() const {
  if (!after_.elementos.contains(e_)) return false;
  return whole_ ? same_elsewhere(&Escena::elementos) : grown(&Escena::elementos);
}

bool Delta::removed() const {
  if (after_.elementos.contains(e_)) return false;
  return whole_ ? same_elsewhere(&Escena::elementos) : shrunk(&Escena::elementos);
}

}  // namespace durero::model
