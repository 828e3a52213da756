// The module's functions for a page: a room for a request, the call, and the length of its answer.
#include <cstddef>
#include <string>

#include "durero/web/call.hpp"

namespace {

std::string request;
std::string answer;

}  // namespace

extern "C" {

/// The room for a request of so many bytes; the next one may move it.
[[clang::export_name("room")]] char* durero_room(std::size_t size) {
  request.resize(size);
  return request.data();
}

/// Answers the request; where the answer stands until the next call.
[[clang::export_name("call")]] const char* durero_call() {
  answer = durero::web::call(request);
  return answer.data();
}

/// The bytes of the answer.
[[clang::export_name("length")]] std::size_t durero_length() { return answer.size(); }

}  // extern "C"
