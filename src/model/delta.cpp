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

bool Delta::same_names() const {
  if (whole_) return after_.elementos == before_.elementos;
  return after_.elementos.size() == before_.elementos.size() &&
         after_.elementos.contains(e_) == before_.elementos.contains(e_);
}

}  // namespace durero::model
