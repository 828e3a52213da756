#pragma once
/// Whether the sanitizers watch: their builds are some ten times slower.

#include <cstddef>

namespace durero::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

/// How many random cases a test tries: a tenth under the sanitizers, which look for other faults than wrong answers,
/// but one at least.
constexpr std::size_t fewer_when_sanitized(std::size_t cases) { return sanitized ? (cases + 9) / 10 : cases; }

}  // namespace durero::test
