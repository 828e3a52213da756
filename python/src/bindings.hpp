#pragma once
/// The parts of the module durero._durero: each adds its functions. What they are for a user is said in python/durero.

#include <pybind11/pybind11.h>

namespace durero::python {

namespace py = pybind11;

void add_errors(py::module_& module);
void add_scene(py::module_& module);
void add_store(py::module_& module);
void add_trace(py::module_& module);
void add_distance(py::module_& module);
void add_mesh_check(py::module_& module);
void add_exact(py::module_& module);
void add_spec(py::module_& module);
void add_conform(py::module_& module);
void add_meshes(py::module_& module);
void add_names(py::module_& module);

}  // namespace durero::python
