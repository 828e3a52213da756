// The compiled part of the Python package durero.
#include <string>

#include "bindings.hpp"

namespace durero::python {
namespace {

/// The first pybind11 that reads the arrays of NumPy 2, whose descriptors have another layout.
constexpr int first_for_numpy_2 = 0x020C0000;

/// An older pybind11 would read wrong numbers from NumPy 2's arrays. The module is not imported then.
/// @throws ImportError
void require_readable_arrays() {
  if (PYBIND11_VERSION_HEX >= first_for_numpy_2) return;
  const std::string version = py::module_::import("numpy").attr("__version__").cast<std::string>();
  if (version.compare(0, 2, "1.") == 0) return;
  throw py::import_error("durero: this module was built with a pybind11 before 2.12 and cannot read arrays of NumPy " +
                         version + "; expected NumPy 1, or a module built with pybind11 2.12 (pip install .)");
}

}  // namespace
}  // namespace durero::python

PYBIND11_MODULE(_durero, module) {
  using namespace durero::python;
  require_readable_arrays();
  module.attr("version") = DURERO_VERSION;
  module.attr("reads_numpy_2") = PYBIND11_VERSION_HEX >= first_for_numpy_2;
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
