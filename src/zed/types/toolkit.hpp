#pragma once
/// The names of the standard toolkit (ISO/IEC 13568, annex B) have types.

#include <unordered_map>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/toolkit_sections.hpp"
#include "durero/zed/types/types.hpp"

namespace durero::zed {

/// 𝔸 is the given type of all numbers.
const Type& arithmos();

/// A name of the toolkit is declared in a section of it.
struct ToolkitEntry {
  ToolkitSection section;
  Scheme scheme;
};

/// All names of the toolkit. A section sees those that the sections of the toolkit among its ancestors declare.
const std::unordered_map<Name, ToolkitEntry>& toolkit();

/// Returns the type of a name that one of these sections of the toolkit declares, or null.
const Scheme* toolkit_scheme(const Name& name, ToolkitSections seen);

/// An expression that is typed by hand sees these, and no section does: / and √, with which its value is printed.
const std::unordered_map<Name, Scheme>& calculator();

}  // namespace durero::zed
