#pragma once
/// The names that paragraphs declare, and the labels that stand in them.

#include <string>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// Returns the names that a paragraph declares for its section.
std::vector<Name> names_of(const Paragraph& paragraph);

/// Returns the labels of its predicates, or of the definition that it is, in order.
std::vector<std::string> labels_of(const Paragraph& paragraph);

/// Says whether the paragraph declares the name or bears it as a label.
bool is_named(const Paragraph& paragraph, const std::string& name);

/// Says whether the paragraph is a schema's box that declares a component of this name.
bool has_component(const Paragraph& paragraph, const std::string& name);

}  // namespace durero::zed
