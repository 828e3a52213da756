#include "durero/io/spool.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "descriptor.hpp"
#include "durero/io/temporary.hpp"

namespace durero::io {

Spool::Spool(std::string target) : target_(std::move(target)) {
  try {
    file_ = Temporary(target_).file();  // which goes with its name, and the file stays until it is closed
  } catch (const std::system_error& error) {
    refuse_to_write(target_, "be written", error.code().value());
  }
}

Spool::~Spool() {
  if (file_ >= 0) ::close(file_);
}

void Spool::write(std::string_view bytes) { write_all(target_, file_, bytes); }

Input Spool::read() {
  if (::lseek(file_, 0, SEEK_SET) != 0) refuse_to_read(target_, errno);
  return {target_, std::exchange(file_, -1)};
}

}  // namespace durero::io
