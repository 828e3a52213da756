// Calls in JSON: each has one line for an answer, whatever it is, and the same when it is asked again.
#include <string>
#include <string_view>

#include "durero/web/call.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view request(reinterpret_cast<const char*>(data), size);
  const std::string answer = web::call(request);
  test::must(answer.starts_with('{') && answer.ends_with('}') && answer.find('\n') == std::string::npos);
  test::must(web::call(request) == answer);
  return 0;
}
