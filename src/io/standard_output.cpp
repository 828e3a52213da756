#include "durero/io/standard_output.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>

#include "descriptor.hpp"
#include "durero/io/output_file.hpp"

namespace durero::io {

void require_standard_output() {
  // To write nothing fails where it is closed or only to be read; on Linux a device that is full says so too.
  if (::write(STDOUT_FILENO, "", 0) < 0) refuse_to_write(standard_output, "be written", errno);
}

void print(std::string_view text) { write_file("-", text); }

void complain(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
    if (count < 0 && errno != EINTR) return;
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  }
}

}  // namespace durero::io
