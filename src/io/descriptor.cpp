#include "descriptor.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "durero/io/source.hpp"
#include "durero/io/standard_output.hpp"

namespace durero::io {

void refuse_to_read(const std::string& name, int error) {
  throw FileError(name, fmt::format("cannot be read: {}", std::strerror(error)), "expected a readable file");
}

void refuse_to_write(const std::string& name, const char* doing, int error) {
  throw FileError(name, fmt::format("cannot {}: {}", doing, std::strerror(error)),
                  name == standard_output ? "expected a standard output that takes what is printed"
                                          : "expected a file that can be written, in a directory that can");
}

void write_all(const std::string& name, int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EAGAIN) {  // a pipe that is full, and that whoever shares it does not wait on
      pollfd for_room{file, POLLOUT, 0};
      ::poll(&for_room, 1, -1);
    } else if (count < 0 && errno != EINTR) {
      refuse_to_write(name, "be written", errno);
    }
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  }
}

}  // namespace durero::io
