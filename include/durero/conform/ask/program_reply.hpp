#pragma once
/// A program that takes one text and writes one reply, such as a solver, is run within limits.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

#include "durero/conform/ask/system_file.hpp"

namespace durero::conform {

/// The limits on a program that replies.
struct ReplyLimits {
  std::chrono::duration<double> time{10};  ///< from its start to its end
  std::uint64_t memory = 0;                ///< bytes of data; 0: those of this program
  std::size_t output = 1 << 20;            ///< bytes that it may write
};

/// The reply of a program.
struct ProgramReply {
  std::string output;     ///< its standard output
  std::string failure{};  ///< `gives no answer within 10 s`, `ends by signal 6 (Aborted)`; empty where it replied
};

/// Runs the program with the text at its standard input, and waits for its end. It has no reply where it writes
/// nothing, writes too much, is ended by a signal, does not end in time, or `stop` is set. All processes that it starts
/// end with it. Throws std::runtime_error where there is no such program.
ProgramReply reply_of(const Command& program, const std::string& text, const ReplyLimits& limits,
                      const std::atomic<bool>& stop);

}  // namespace durero::conform
