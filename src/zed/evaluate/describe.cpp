#include "zed/evaluate/describe.hpp"

#include "durero/zed/print/print.hpp"

namespace durero::zed {

std::string describe(const Node& node) {
  const bool one_schema = node.kind == Kind::comprehension && node.children.empty() && node.text->predicates.empty() &&
                          node.text->declarations.size() == 1 &&
                          node.text->declarations[0].form == Declaration::Form::included;
  if (one_schema) return to_unicode(node.text->declarations[0].term);
  return to_unicode(Term(std::make_shared<const Node>(node)));
}

}  // namespace durero::zed
