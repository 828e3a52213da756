#pragma once
/// The grammar of Spivey's Z (The Z Notation, chapter 6), as far as ISO's is larger.

#include <set>
#include <string>
#include <string_view>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/operators.hpp"

namespace durero::zed {

/// The names of schemas, which Spivey's Z decorates and defines by \defs.
using SchemaNames = std::set<std::string, std::less<>>;

/// Adds the name of a paragraph that is a schema, or is defined to be one by those known so far.
void add_schema_name(const Paragraph& paragraph, SchemaNames& known);

/// Says whether a definition is one of a schema, so that \defs stands in the place of ==.
bool defines_schema(const Definition& definition, const SchemaNames& known);

/// Throws ZError, with its place, at what a paragraph says and Spivey's grammar has no form for.
void require_spivey(const Paragraph& paragraph, const SchemaNames& known);

/// Returns the directive of an operator template, `%%inop \boxplus 3`. `word` is its word in LaTeX. Throws ZError where
/// Spivey's Z has none.
std::string spivey_directive_of(const OperatorTemplate& op, std::string_view word, Place place);

}  // namespace durero::zed
