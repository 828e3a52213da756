/// A race, if asked for: what the build under ThreadSanitizer must see, and what it must not take for one.
///   race shared | apart
#include <tbb/parallel_for.h>

#include <cstdio>
#include <cstring>
#include <vector>

int main(int argc, char** argv) {
  const bool shared = argc > 1 && std::strcmp(argv[1], "shared") == 0;
  std::vector<long> sums(1000);
  tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t i) { sums[shared ? 0 : i] += 1; });
  long sum = 0;
  for (const long part : sums) sum += part;
  std::printf("%ld\n", sum);
  return 0;
}
