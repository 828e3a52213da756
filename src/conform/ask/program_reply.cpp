#include "durero/conform/ask/program_reply.hpp"

#include <fmt/format.h>

#include "conform/ask/child.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

using ReplyClock = std::chrono::steady_clock;

std::string first_words(const std::string& text) {
  constexpr std::size_t most = 100;
  return text::escaped(text.substr(0, std::min(text.find('\n'), most)));
}

ProgramReply too_long(const ReplyLimits& limits) {
  return {"", fmt::format("writes more than {} bytes", limits.output)};
}

/// The reply of a child that ended by itself.
ProgramReply reply_at_end(Child& child, std::string output, const ReplyLimits& limits) {
  output += child.rest();
  if (output.size() > limits.output) return too_long(limits);
  const std::string how = child.end();
  if (how.starts_with("signal")) return {"", "ends by " + how};
  if (output.find_first_not_of(" \r\n\t") != output.npos) return {std::move(output)};
  const std::string said = first_words(child.last_words());
  return {"", "ends without an answer" + (how.empty() ? "" : ", " + how) + (said.empty() ? "" : ": " + said)};
}

}  // namespace

ProgramReply reply_of(const Command& program, const std::string& text, const ReplyLimits& limits,
                      const std::atomic<bool>& stop) {
  const auto until = ReplyClock::now() + std::chrono::duration_cast<ReplyClock::duration>(limits.time);
  Child child(program, {.memory = limits.memory, .line = limits.output + 1}, stop);
  child.tell(text);
  child.close_input_when_told();
  std::string output, line;
  for (;;) {
    switch (child.next_line(until - ReplyClock::now(), line)) {
      case Child::Event::line:
        output += line + "\n";
        if (output.size() > limits.output) return too_long(limits);
        break;
      case Child::Event::ended:
        return reply_at_end(child, std::move(output), limits);
      case Child::Event::late:
        return {"", fmt::format("gives no answer within {} s", limits.time.count())};
      case Child::Event::stopped:
        return {"", "is interrupted"};
    }
  }
}

}  // namespace durero::conform
