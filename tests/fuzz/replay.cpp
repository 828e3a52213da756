/// Runs a fuzzer's entry point on the files named, or on every file of the folders named: what libFuzzer does once its
/// search is over. So the everyday build replays the seeds, and the inputs that once broke a reader, without Clang.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

bool replay(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) return false;
  std::printf("%s\n", file.c_str());
  std::fflush(stdout);  // the last line names the input, should it end the program
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  // Every prefix that ends at a line: a text cut short is the most common damage.
  for (std::size_t end = bytes.find('\n'); end < bytes.size(); end = bytes.find('\n', end + 1))
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), end);
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  int replayed = 0;
  for (int i = 1; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i])) {
      if (!replay(arguments[i])) return 1;
      ++replayed;
      continue;
    }
    for (const auto& one : std::filesystem::recursive_directory_iterator(arguments[i])) {
      if (!one.is_regular_file()) continue;
      if (!replay(one.path())) return 1;
      ++replayed;
    }
  }
  std::printf("%d inputs\n", replayed);
  return replayed > 0 ? 0 : 1;  // no input: the seeds are not where they were
}
