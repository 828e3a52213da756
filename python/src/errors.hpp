#pragma once
/// The exceptions of durero.errors, raised with what they hold.

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>

#include "durero/contract/contract.hpp"
#include "durero/model/tipos.hpp"

namespace durero::python {

/// Raises durero.errors.NAME(arguments...).
template <class... Arguments>
[[noreturn]] void raise(const char* name, const Arguments&... arguments) {
  const pybind11::object type = pybind11::module_::import("durero.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(arguments...).ptr());
  throw pybind11::error_already_set();
}

/// Raises durero.InputError, at a place of a text that is called so in messages.
[[noreturn]] void raise_input_error(const std::string& file, std::size_t line, std::size_t column,
                                    const std::string& what);

/// Raises durero.Refused, of an operation without inputs.
[[noreturn]] void raise_refused(const contract::clause& precondition, model::Respuesta r, const char* operation);

}  // namespace durero::python
