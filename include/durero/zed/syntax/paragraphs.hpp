#pragma once
/// What paragraphs declare and which labels stand in them.

#include <string>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// The names that a paragraph declares for its section.
std::vector<Name> names_of(const Paragraph& paragraph);

/// The labels of its predicates, or of the definition that it is, in order.
std::vector<std::string> labels_of(const Paragraph& paragraph);

/// True where the paragraph declares the name or bears it as a label.
bool is_named(const Paragraph& paragraph, const std::string& name);

/// True for a schema's box that declares a component of this name.
bool has_component(const Paragraph& paragraph, const std::string& name);

}  // namespace durero::zed
