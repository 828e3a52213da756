#pragma once
/// Which event has made each element of a scene what it is.

#include <string>
#include <vector>

#include "durero/store/store.hpp"

namespace durero::store {

/// An element, or a mesh with all of its faces, and the event that set it last.
struct BlamedElement {
  std::string name;   ///< of the element or the mesh
  EventNumber event;  ///< the edit that added or changed it last; the import where none did since
};

/// Every element and mesh of the scene of an event, elements first, each ascending by name. Groups are no part of an
/// element. Throws io::FileError as Store::state() does.
std::vector<BlamedElement> blame(Store& store, EventNumber of);

}  // namespace durero::store
