#pragma once
/// What a message may quote: whatever a file, a file's name or an argument holds, a message stays one line that a
/// terminal prints and does not obey.

#include <string>
#include <string_view>

namespace durero::text {

/// The text with each byte written as `\x1b` that belongs to no UTF-8 character, to a control character (C0, DEL, C1)
/// or to one that breaks a line or turns the direction of writing. Everything else stays as it is, backslashes too, so
/// escaping twice changes nothing more.
std::string escaped(std::string_view text);

/// A piece of input as a message shows it: in quotes, escaped, cut after 40 characters with `…` for the rest.
std::string shown(std::string_view text);

}  // namespace durero::text
