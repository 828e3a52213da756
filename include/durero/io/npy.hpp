#pragma once
/// NumPy's .npy format: a table of binary64 read, and the head of a file written.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io {

/// True where a text starts as a .npy file does.
bool is_npy(std::string_view text) noexcept;

/// The columns of a table of shape (n, columns); of shape (n,) they are 1. Throws InputError.
std::size_t npy_columns(const Source& source);

/// Reads a table of float64 with that many columns, as n rows; either byte order, C or Fortran order. Throws
/// InputError.
std::vector<double> read_npy(const Source& source, std::size_t columns);

/// What stands before the data of an array of the given dtype and shape, as Python text: `<f8` is `'<f8'`, `(3,)`.
std::string npy_head(std::string_view descr, std::string_view shape);

/// Appends a binary64 in little-endian order.
void append_binary64(std::string& out, double value);

}  // namespace durero::io
