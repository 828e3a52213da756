#include "durero/conform/ask/program_reply.hpp"

#include <signal.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "support/catch.hpp"

using namespace durero::conform;

namespace {

ProgramReply reply(const std::string& script, const std::string& text = "", ReplyLimits limits = {}) {
  const std::atomic<bool> stop = false;
  return reply_of({"sh", "-c", script}, text, limits, stop);
}

}  // namespace

TEST_CASE("a program gets the text, sees its end, and replies") {
  CHECK(reply("cat", "one\ntwo\n").output == "one\ntwo\n");
  CHECK(reply("cat", "without an end of line").output == "without an end of line");
  CHECK(reply("cat; echo done", "").output == "done\n");
  const std::string long_text(300'000, 'x');
  CHECK(reply("wc -c", long_text + "\n").output == "300001\n");
  CHECK(reply("cat", long_text + "\n").output == long_text + "\n");
  const ProgramReply without_reading = reply("echo sat", long_text);
  CHECK(without_reading.output == "sat\n");
  CHECK(without_reading.failure.empty());
}

TEST_CASE("a program that does not reply has a failure, and no output") {
  CHECK(reply("cat >/dev/null").failure == "ends without an answer, exit status 0");
  CHECK(reply("echo; exit 2").failure == "ends without an answer, exit status 2");
  CHECK(reply("echo 'no file' >&2; exit 3").failure == "ends without an answer, exit status 3: no file");
  CHECK(reply("echo sat; kill -ABRT $$").failure == "ends by signal 6 (Aborted)");
  CHECK(reply("echo sat; exit 1").output == "sat\n");
  const ProgramReply flood = reply("yes", "", {.output = 1000});
  CHECK(flood.failure == "writes more than 1000 bytes");
  CHECK(flood.output.empty());
  CHECK(reply("printf %01001d 0", "", {.output = 1000}).failure == "writes more than 1000 bytes");
  CHECK(reply("printf %0999d 0", "", {.output = 1000}).output.size() == 999);
}

TEST_CASE("a program has so much time, from its start to its end") {
  const auto before = std::chrono::steady_clock::now();
  CHECK(reply("echo sat; exec sleep 60", "", {.time = std::chrono::milliseconds(300)}).failure ==
        "gives no answer within 0.3 s");
  CHECK(reply("while :; do echo sat; sleep 0.1; done", "", {.time = std::chrono::milliseconds(500)}).failure ==
        "gives no answer within 0.5 s");
  CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(30));
  const std::atomic<bool> stop = true;
  CHECK(reply_of({"sleep", "60"}, "", {}, stop).failure == "is interrupted");
}

TEST_CASE("a program that is not there is an error that names it") {
  const std::atomic<bool> stop = false;
  try {
    reply_of({"nobody-has-this"}, "", {}, stop);
    FAIL("it is there");
  } catch (const std::runtime_error& error) {
    CHECK(std::string(error.what()) == "nobody-has-this: No such file or directory; expected a program");
  }
}
