// The compiled part of the Python package durero.
#include "bindings.hpp"

PYBIND11_MODULE(_durero, module) {
  using namespace durero::python;
  module.attr("version") = DURERO_VERSION;
  add_errors(module);
  add_scene(module);
  add_store(module);
  add_trace(module);
  add_distance(module);
  add_mesh_check(module);
  add_exact(module);
  add_spec(module);
  add_conform(module);
  add_meshes(module);
  add_names(module);
}
