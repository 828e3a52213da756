#pragma once
/// The layers behind one function: a question in JSON, and the answer in JSON (docs/formats/call.md). The page of the
/// text asks so.

#include <string>
#include <string_view>

namespace durero::web {

/// Answers a call. A call that is wrong has an error for an answer, `{"error":"NAME:LINE:COLUMN: what is wrong; what is
/// expected",…}`; nothing is thrown. The same call has the same answer, whatever was asked before: scenes and texts
/// that were read are kept, by their text, for the thread that asks.
std::string call(std::string_view request) noexcept;

}  // namespace durero::web
