#pragma once
/// The Z text of a call, read.

#include <memory>
#include <string>

#include "asked.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::web {

/// A Z text with its types. The parents that it names are found in the program's own text; no file is asked.
struct HeldText {
  std::string name;         ///< as messages name it
  zed::Specification text;  ///< with the program's own sections, where it names one of them
  zed::Typing typing;       ///< of that
  bool own = false;         ///< it is the program's own text

  /// Throws io::InputError at the first error of reading or of types, and where the text holds no Z.
  void require_right() const;
};

/// The text of a call: its key `text`, called `name` where that is there, and `text` elsewhere; without it the
/// program's own.
std::shared_ptr<const HeldText> text_of(const AskedCall& asked);

/// The index of the labels of the program's own text.
const std::string& label_table();

}  // namespace durero::web
