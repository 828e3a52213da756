#include "errors.hpp"

#include <fmt/format.h>

#include <exception>

#include "bindings.hpp"
#include "durero/io/source.hpp"

namespace durero::python {
namespace {

/// The name of the file stands before its place.
std::string file_of(const io::InputError& error) {
  const std::string message = error.what();
  return message.substr(0, message.find(fmt::format(":{}:{}: ", error.place().line, error.place().column)));
}

void set_error(const char* name, const py::tuple& arguments) {
  const py::object type = py::module_::import("durero.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(*arguments).ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const io::InputError& error) {
    set_error("InputError", py::make_tuple(error.what(), file_of(error), error.place().line, error.place().column));
  } catch (const io::FileError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  }
}

}  // namespace

void raise_input_error(const std::string& file, std::size_t line, std::size_t column, const std::string& what) {
  raise("InputError", fmt::format("{}:{}:{}: {}", file, line, column, what), file, line, column);
}

void raise_refused(const contract::clause& precondition, model::Respuesta r, const char* operation) {
  raise("Refused", std::string(precondition.label), std::string(precondition.predicate), std::string(model::name(r)),
        operation, py::dict(), 1);
}

void add_errors(py::module_&) { py::register_exception_translator(translate); }

}  // namespace durero::python
