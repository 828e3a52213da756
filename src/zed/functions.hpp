#pragma once
/// The functions and relations of the toolkit.

#include <string>
#include <vector>

#include "context.hpp"

namespace durero::zed {

/// A function of one argument, or of a pair.
struct ToolkitFunction {
  Value (*one)(const Value&, Context&) = nullptr;
  Value (*two)(const Value&, const Value&, Context&) = nullptr;
};
/// By its name: `_∪_`, `dom`, `#_`. Null where there is none.
const ToolkitFunction* toolkit_function(const std::string& name);
/// The function as a value.
Value toolkit_value(const std::string& name);

/// R∼⦇S⦈
Value inverse_image(const Value& relation, const Value& set, Context& context);

using ToolkitRelation = Truth (*)(const Value&, const Value&, Context&);
ToolkitRelation toolkit_relation(const std::string& name);

/// f(x).
Value apply_value(const Value& function, const Value& argument, Context& context);

}  // namespace durero::zed
