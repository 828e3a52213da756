#include "durero/zed/types/types.hpp"

#include <algorithm>
#include <unordered_set>

namespace durero::zed {
namespace {

// These bound the work of one unification. Each type alone is bounded (max_size, max_depth), but variables chain types,
// so the recursion is bounded again: 4000 frames of at most 1 KiB are half of a default stack, and 10^5 steps are about
// a millisecond.
constexpr unsigned max_unify_depth = 4000;
constexpr std::uint32_t max_unify_steps = 100000;

}  // namespace

Type::Type(Node node) {
  std::uint64_t size = 1;
  for (const Type& part : node.parts) {
    size += part.size();
    node.depth = std::max(node.depth, part.depth() + 1);
    node.generic = node.generic || part.node().generic;
    node.open = node.open || part.node().open;
  }
  node.size = static_cast<std::uint32_t>(std::min<std::uint64_t>(size, max_size + 1));
  node.generic = node.generic || node.kind == Kind::formal;
  node.open = node.open || node.kind == Kind::variable;
  node_ = std::make_shared<const Node>(std::move(node));
}

Type Type::given(Name name) { return Type({.kind = Kind::given, .names = {std::move(name)}, .parts = {}, .same = {}}); }
Type Type::formal(Name name) {
  return Type({.kind = Kind::formal, .names = {std::move(name)}, .parts = {}, .same = {}});
}
Type Type::power(Type element) {
  return Type({.kind = Kind::power, .names = {}, .parts = {std::move(element)}, .same = {}});
}
Type Type::product(std::vector<Type> parts) {
  return Type({.kind = Kind::product, .names = {}, .parts = std::move(parts), .same = {}});
}
Type Type::schema(std::vector<std::pair<Name, Type>> fields) {
  std::sort(fields.begin(), fields.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Node node{.kind = Kind::schema, .names = {}, .parts = {}, .same = {}};
  node.names.reserve(fields.size());
  node.parts.reserve(fields.size());
  for (auto& [name, type] : fields) {
    node.names.push_back(std::move(name));
    node.parts.push_back(std::move(type));
  }
  return Type(std::move(node));
}
Type Type::variable() { return Type({.kind = Kind::variable, .names = {}, .parts = {}, .same = {}}); }
Type Type::unknown() { return Type({.kind = Kind::unknown, .names = {}, .parts = {}, .same = {}}); }

const Name& Type::name() const {
  static const Name none;
  const Node& mine = node();
  return mine.kind == Kind::given || mine.kind == Kind::formal ? mine.names[0] : none;
}

const std::vector<Name>& Type::fields() const {
  static const std::vector<Name> none;
  const Node& mine = node();
  return mine.kind == Kind::schema ? mine.names : none;
}

const Type::Node& Type::node() const {
  const Node* at = node_.get();
  while (at->same) at = at->same.get();
  return *at;
}

std::shared_ptr<const Type::Node> Type::resolved() const {
  std::shared_ptr<const Node> at = node_;
  while (at->same) at = at->same;
  return at;
}

const Type* Type::field(const Name& wanted) const {
  const std::vector<Name>& names = fields();
  const auto at = std::lower_bound(names.begin(), names.end(), wanted);
  if (at == names.end() || *at != wanted) return nullptr;
  return &parts()[static_cast<std::size_t>(at - names.begin())];
}

/// Says whether some node of the type passes the test; a node that stands in it twice is tested once. What is behind a
/// node that is not `looked_into` passes it nowhere.
template <class LookedInto, class Test>
bool Type::any_node(const Type& in, LookedInto&& looked_into, Test&& test) {
  if (!looked_into(in.node())) return false;
  std::unordered_set<const Node*> seen;
  std::vector<const Node*> left = {&in.node()};
  while (!left.empty()) {
    const Node* node = left.back();
    left.pop_back();
    if (!seen.insert(node).second) continue;
    if (test(*node)) return true;
    for (const Type& part : node->parts)
      if (looked_into(part.node())) left.push_back(&part.node());
  }
  return false;
}

bool Type::has_variables() const {
  return any_node(*this, is_open, [](const Node& node) { return node.kind == Kind::variable; });
}

bool Type::is_known() const {
  return !any_node(
      *this, [](const Node&) { return true; },
      [](const Node& node) {
        return node.kind == Kind::variable || node.kind == Kind::unknown || node.kind == Kind::formal;
      });
}

bool Type::occurs(const Node* variable, const Type& in) {
  return any_node(in, is_open, [variable](const Node& node) { return &node == variable; });
}

bool Type::unify_at(const Type& a, const Type& b, unsigned depth, std::uint32_t& steps) {
  const Node &left = a.node(), &right = b.node();
  if (&left == &right || left.kind == Kind::unknown || right.kind == Kind::unknown) return true;
  if (depth > max_unify_depth || ++steps > max_unify_steps) return false;
  if (left.kind == Kind::variable && right.kind == Kind::variable) {
    join(a, b);
    return true;
  }
  if (left.kind == Kind::variable) {
    if (occurs(&left, b)) return false;
    left.same = b.resolved();
    return true;
  }
  if (right.kind == Kind::variable) return unify_at(b, a, depth + 1, steps);
  if (left.kind != right.kind || left.names != right.names || left.parts.size() != right.parts.size()) return false;
  for (std::size_t i = 0; i < left.parts.size(); ++i)
    if (!unify_at(left.parts[i], right.parts[i], depth + 1, steps)) return false;
  return true;
}

/// Two variables become one: the one of lower rank is found to be the other.
void Type::join(const Type& a, const Type& b) {
  const auto left = a.resolved(), right = b.resolved();
  if (left->rank == right->rank) ++right->rank;
  if (left->rank <= right->rank) {
    left->same = right;
  } else {
    right->same = left;
  }
}

Type Type::settled() const {
  std::unordered_map<const Node*, Type> done;
  const Type type = settled_at(0, done);
  return type.size() > max_size ? unknown() : type;
}

Type Type::settled_at(std::uint32_t depth, std::unordered_map<const Node*, Type>& done) const {
  const Node& mine = node();
  if (mine.kind == Kind::variable || depth > max_depth) return unknown();
  if (!mine.open && depth + mine.depth <= max_depth) return Type(resolved());
  if (const auto entry = done.find(&mine); entry != done.end()) return entry->second;
  Node node{.kind = mine.kind, .names = mine.names, .parts = {}, .same = {}};
  node.parts.reserve(mine.parts.size());
  for (const Type& part : mine.parts) node.parts.push_back(part.settled_at(depth + 1, done));
  return done.emplace(&mine, Type(std::move(node))).first->second;
}

bool unify(const Type& a, const Type& b) {
  std::uint32_t steps = 0;
  return Type::unify_at(a, b, 0, steps);
}

Type Type::substitute(const std::vector<Name>& formals, const std::vector<Type>& actuals) const {
  const Node& mine = node();
  if (!mine.generic) return *this;
  if (mine.kind == Kind::formal) {
    const auto entry = std::find(formals.begin(), formals.end(), mine.names[0]);
    return entry == formals.end() ? *this : actuals[static_cast<std::size_t>(entry - formals.begin())];
  }
  Node node{.kind = mine.kind, .names = mine.names, .parts = {}, .same = {}};
  node.parts.reserve(mine.parts.size());
  for (const Type& part : mine.parts) node.parts.push_back(part.substitute(formals, actuals));
  return Type(std::move(node));
}

std::string Type::text(int parts) const {
  std::string out;
  append(out, false, parts);
  return out;
}

void Type::append(std::string& out, bool tight, int& budget) const {
  if (--budget < 0) {
    if (!out.ends_with("…")) out += "…";
    return;
  }
  const Node& mine = node();
  if (mine.kind == Kind::given || mine.kind == Kind::formal) {
    out += mine.names[0].text();
  } else if (mine.kind == Kind::power) {
    out += "ℙ ";
    mine.parts[0].append(out, true, budget);
  } else if (mine.kind == Kind::product) {
    if (tight) out += "(";
    for (std::size_t i = 0; i < mine.parts.size(); ++i) {
      if (i > 0) out += " × ";
      mine.parts[i].append(out, true, budget);
    }
    if (tight) out += ")";
  } else if (mine.kind == Kind::schema) {
    out += "[";
    for (std::size_t i = 0; i < mine.parts.size() && budget > 0; ++i) {
      out += (i > 0 ? "; " : "") + mine.names[i].text() + " : ";
      mine.parts[i].append(out, false, budget);
    }
    out += "]";
  } else {
    out += "?";
  }
}

}  // namespace durero::zed
