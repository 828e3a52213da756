// English for the Spanish names, by the one table of the program.
#include "bindings.hpp"
#include "durero/text/spanish.hpp"

namespace durero::python {
namespace {

/// Each name with its English and its meaning, in the order of the text.
py::tuple spanish_names() {
  py::list rows;
  for (const auto& [name, english, meaning] : text::spanish_names())
    rows.append(py::make_tuple(std::string(name), std::string(english), std::string(meaning)));
  return py::tuple(rows);
}

}  // namespace

void add_names(py::module_& module) { module.def("spanish_names", spanish_names); }

}  // namespace durero::python
