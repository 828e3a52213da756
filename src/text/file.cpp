#include "durero/text/file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <system_error>

namespace durero::text {
namespace {

[[noreturn]] void fail() { throw std::system_error(errno, std::generic_category()); }

}  // namespace

std::string read_rest(std::FILE& file, std::size_t most) {
  std::string bytes;
  std::array<char, 1U << 16U> block;
  errno = 0;
  while (const std::size_t count = std::fread(block.data(), 1, std::min(block.size(), most - bytes.size()), &file))
    bytes.append(block.data(), count);
  if (std::ferror(&file) != 0) fail();
  return bytes;
}

std::string read_file(const std::string& path, std::size_t most) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail();
  return read_rest(*file, most);
}

}  // namespace durero::text
