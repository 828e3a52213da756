#pragma once
/// NumPy's .npy format: a table of binary64 read, and the head of a file written.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/input.hpp"
#include "durero/io/source.hpp"

namespace durero::io {

/// True where a text starts as a .npy file does.
bool is_npy(std::string_view text) noexcept;

/// The columns of a table of shape (n, columns); of shape (n,) they are 1. Throws InputError.
std::size_t npy_columns(const Source& source);

/// Asks for as much of an input as tells whether it starts as a .npy file does.
bool is_npy(Input& input);

/// Reads a table of float64 with that many columns, row after row; either byte order, C or Fortran order. Memory does
/// not grow with the table but where it comes in Fortran order through a pipe. All members throw InputError and
/// FileError.
class NpyReader {
 public:
  /// Reads what stands before the data. The input must outlive it.
  NpyReader(Input& input, std::size_t columns);

  /// Puts the next rows in place of the values: those that are there, for which it waits where none is. False at the
  /// end of the table, behind which nothing may stand.
  bool next(std::vector<double>& values);

 private:
  std::size_t width() const { return 8 * columns_; }
  [[noreturn]] void refuse_data(std::uint64_t bytes) const;
  bool at_end();
  void in_order(std::vector<double>& values);
  void gathered(std::vector<double>& values);

  Input& input_;
  std::size_t columns_, rows_ = 0;
  std::size_t done_ = 0;  // rows
  bool is_big_endian_ = false, is_fortran_ = false;
};

/// Reads such a table whole, as n rows.
std::vector<double> read_npy(const Source& source, std::size_t columns);

/// What stands before the data of an array of the given dtype and shape, as Python text: `<f8` is `'<f8'`, `(3,)`.
std::string npy_head(std::string_view descr, std::string_view shape);

/// Appends a binary64 in little-endian order.
void append_binary64(std::string& out, double value);

}  // namespace durero::io
