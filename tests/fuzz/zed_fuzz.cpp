/// libFuzzer's entry to the reader of Z: `zed_fuzz -dict=tests/fuzz/zed.dict tests/zed/corpus/right
/// tests/zed/corpus/wrong spec` (with -DDURERO_FUZZ=ON and Clang). A crash, a hang, memory without bound or a broken
/// round trip is a finding.

#include <cstdint>

#include "zed/survive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  durero::zed::test::survive(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
