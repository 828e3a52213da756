#include "pov_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/io/number_text.hpp"
#include "durero/scene/srgb.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

using Arguments = std::vector<PovNumbers>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t deepest_expression = 300;  // expressions within expressions

// Names of numbers.

struct NamedNumbers {
  std::string_view name;
  PovNumbers value;
};
/// 1 at one place of so many.
PovNumbers unit(std::size_t place, std::size_t count) {
  PovNumbers axis;
  axis.of[place] = 1, axis.count = count;
  return axis;
}

const NamedNumbers names[] = {{"pi", std::numbers::pi},
                              {"tau", 2 * std::numbers::pi},
                              {"x", {1, 0, 0}},
                              {"y", {0, 1, 0}},
                              {"z", {0, 0, 1}},
                              {"t", unit(3, 4)},
                              {"u", unit(0, 2)},
                              {"v", unit(1, 2)},
                              {"true", 1},
                              {"yes", 1},
                              {"on", 1},
                              {"false", 0},
                              {"no", 0},
                              {"off", 0},
                              // A picture alone is asked for, and no film.
                              {"clock", 0},
                              {"clock_on", 0},
                              {"clock_delta", 1},
                              {"initial_clock", 0},
                              {"final_clock", 1},
                              {"frame_number", 1},
                              {"initial_frame", 1},
                              {"final_frame", 1}};

// Functions.

struct NamedFunction {
  std::string_view name;
  std::size_t least, most;  // arguments
  PovNumbers (*value)(const Arguments& a);
};

/// v, turned about an axis by degrees, as POV-Ray turns: to the left.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& about, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const glm::dvec3 axis = glm::normalize(about);
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
}
PovNumbers of_vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
PovNumbers turned_by_axes(const Arguments& a) {
  glm::dvec3 v = a[0].triple();
  const glm::dvec3 by = a[1].triple();
  v = turned(v, {1, 0, 0}, by.x);
  v = turned(v, {0, 1, 0}, by.y);
  return of_vector(turned(v, {0, 0, 1}, by.z));
}
/// The whole part and the rest of division, towards 0.
double quotient(double a, double b) { return std::trunc(a / b); }

template <class Choose>
PovNumbers chosen(const Arguments& a, Choose choose) {
  double value = a[0].of[0];
  for (const PovNumbers& other : a) value = choose(value, other.of[0]);
  return value;
}

#define ONE(name, expression)                          \
  {                                                    \
    name, 1, 1, [](const Arguments& a) -> PovNumbers { \
      const double x = a[0].of[0];                     \
      return expression;                               \
    }                                                  \
  }
#define TWO(name, expression)                          \
  {                                                    \
    name, 2, 2, [](const Arguments& a) -> PovNumbers { \
      const double x = a[0].of[0], y = a[1].of[0];     \
      return expression;                               \
    }                                                  \
  }
constexpr std::size_t many = 100;

const NamedFunction functions[] = {
    ONE("abs", std::abs(x)),
    ONE("acos", std::acos(x)),
    ONE("acosh", std::acosh(x)),
    ONE("asin", std::asin(x)),
    ONE("asinh", std::asinh(x)),
    ONE("atan", std::atan(x)),
    ONE("atanh", std::atanh(x)),
    ONE("ceil", std::ceil(x)),
    ONE("cos", std::cos(x)),
    ONE("cosh", std::cosh(x)),
    ONE("degrees", x * 180 / std::numbers::pi),
    ONE("exp", std::exp(x)),
    ONE("floor", std::floor(x)),
    ONE("int", std::trunc(x)),
    ONE("ln", std::log(x)),
    ONE("log", std::log10(x)),
    ONE("radians", x * std::numbers::pi / 180),
    ONE("sin", std::sin(x)),
    ONE("sinh", std::sinh(x)),
    ONE("sqr", x * x),
    ONE("sqrt", std::sqrt(x)),
    ONE("tan", std::tan(x)),
    ONE("tanh", std::tanh(x)),
    TWO("atan2", std::atan2(x, y)),
    TWO("div", y == 0 ? nan : quotient(x, y)),
    TWO("mod", y == 0 ? nan : std::fmod(x, y)),
    TWO("pow", std::pow(x, y)),
    {"max", 1, many, [](const Arguments& a) { return chosen(a, [](double x, double y) { return std::max(x, y); }); }},
    {"min", 1, many, [](const Arguments& a) { return chosen(a, [](double x, double y) { return std::min(x, y); }); }},
    {"select", 3, 4,
     [](const Arguments& a) {
       const double x = a[0].of[0];
       if (a.size() == 3) return x < 0 ? a[1] : a[2];
       return x < 0 ? a[1] : x == 0 ? a[2] : a[3];
     }},
    {"vaxis_rotate", 3, 3,
     [](const Arguments& a) { return of_vector(turned(a[0].triple(), a[1].triple(), a[2].of[0])); }},
    {"vcross", 2, 2, [](const Arguments& a) { return of_vector(glm::cross(a[0].triple(), a[1].triple())); }},
    {"vdot", 2, 2, [](const Arguments& a) -> PovNumbers { return glm::dot(a[0].triple(), a[1].triple()); }},
    {"vlength", 1, 1, [](const Arguments& a) -> PovNumbers { return glm::length(a[0].triple()); }},
    {"vnormalize", 1, 1,
     [](const Arguments& a) {
       const glm::dvec3 v = a[0].triple();
       return v == glm::dvec3(0) ? of_vector(v) : of_vector(glm::normalize(v));
     }},
    {"vrotate", 2, 2, turned_by_axes}};
#undef ONE
#undef TWO

template <class Table>
auto found_in(const Table& table, std::string_view name) {
  const auto* const entry = std::ranges::find_if(table, [&](const auto& e) { return e.name == name; });
  return entry == std::end(table) ? nullptr : entry;
}

// Components and colours.

struct Component {
  std::string_view name;
  std::size_t place;
};
constexpr Component components[] = {{"x", 0}, {"u", 0},    {"red", 0}, {"y", 1},      {"v", 1},       {"green", 1},
                                    {"z", 2}, {"blue", 2}, {"t", 3},   {"filter", 3}, {"transmit", 4}};

struct ColorWord {
  std::string_view name;
  std::size_t count;  // of the numbers behind it
};
constexpr ColorWord color_prefixes[] = {{"color", 5}, {"colour", 5}, {"rgb", 3},   {"srgb", 3},  {"rgbf", 4},
                                        {"srgbf", 4}, {"rgbt", 4},   {"srgbt", 4}, {"rgbft", 5}, {"srgbft", 5}};

class Expression {
 public:
  explicit Expression(PovTerms& in) : in_(in) {}

  PovNumbers condition() {
    const Depth depth(*this);
    const PovNumbers chosen = either();
    if (!in_.take("?")) return chosen;
    const PovNumbers first = condition();
    in_.expect(":", "behind the first of two values");
    const PovNumbers second = condition();
    return chosen.of[0] != 0 ? first : second;
  }

  PovNumbers sum() {
    const Depth depth(*this);
    PovNumbers value = product();
    while (in_.at("+") || in_.at("-")) {
      const bool is_plus = in_.at("+");
      in_.pass();
      value = joined(value, product(), is_plus ? plus : minus);
    }
    return value;
  }

  PovNumbers factor() {
    const Depth depth(*this);
    if (in_.take("-")) return joined(0.0, factor(), minus);
    if (in_.take("+")) return factor();
    if (in_.take("!")) return factor().of[0] == 0 ? 1.0 : 0.0;
    PovNumbers value = primary();
    while (in_.take(".")) value = component(value);
    return value;
  }

 private:
  /// Expressions within each other, which are calls within calls.
  struct Depth {
    explicit Depth(Expression& e) : of(e) {
      if (++of.depth_ > deepest_expression) of.in_.fail_here("expected expressions within each other, 300 at most");
    }
    ~Depth() { --of.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Expression& of;
  };

  using Operation = double (*)(double, double);
  static double plus(double a, double b) { return a + b; }
  static double minus(double a, double b) { return a - b; }
  static double times(double a, double b) { return a * b; }
  static double over(double a, double b) { return a / b; }

  PovNumbers finite(const PovNumbers& value, const PovToken* at) {
    if (std::ranges::all_of(value.of, [](double x) { return std::isfinite(x); })) return value;
    if (at == nullptr) in_.fail_here("expected a finite value before it");
    at->fail("an expression without a finite value", "expected one");
  }

  PovNumbers joined(const PovNumbers& a, const PovNumbers& b, Operation operation) {
    const std::size_t count = std::max(a.count, b.count);
    const PovNumbers left = a.widened(count), right = b.widened(count);
    PovNumbers value;
    value.count = count;
    for (std::size_t i = 0; i < count; ++i) value.of[i] = operation(left.of[i], right.of[i]);
    return finite(value, in_.here());
  }

  PovNumbers either() {
    PovNumbers value = both();
    while (in_.take("|")) {
      const PovNumbers other = both();
      value = value.of[0] != 0 || other.of[0] != 0 ? 1.0 : 0.0;
    }
    return value;
  }
  PovNumbers both() {
    PovNumbers value = comparison();
    while (in_.take("&")) {
      const PovNumbers other = comparison();
      value = value.of[0] != 0 && other.of[0] != 0 ? 1.0 : 0.0;
    }
    return value;
  }
  PovNumbers comparison() {
    PovNumbers value = sum();
    while (true) {
      const double a = value.of[0];
      if (in_.take("<"))
        value = a < sum().of[0] ? 1.0 : 0.0;
      else if (in_.take("<="))
        value = a <= sum().of[0] ? 1.0 : 0.0;
      else if (in_.take(">"))
        value = a > sum().of[0] ? 1.0 : 0.0;
      else if (in_.take(">="))
        value = a >= sum().of[0] ? 1.0 : 0.0;
      else if (in_.take("="))
        value = a == sum().of[0] ? 1.0 : 0.0;
      else if (in_.take("!="))
        value = a != sum().of[0] ? 1.0 : 0.0;
      else
        return value;
    }
  }

  PovNumbers product() {
    PovNumbers value = factor();
    while (in_.at("*") || in_.at("/")) {
      const bool is_times = in_.at("*");
      in_.pass();
      value = joined(value, factor(), is_times ? times : over);
    }
    return value;
  }

  PovNumbers primary() {
    const PovToken* const token = in_.here();
    if (token == nullptr) in_.fail_here("expected a number");
    if (token->is_number()) return number(*token);
    if (in_.take("(")) {
      const PovNumbers value = condition();
      in_.expect(")", "behind an expression");
      return value;
    }
    if (in_.take("<")) return literal();
    if (!token->is_name()) in_.fail_here("expected a finite number");
    if (const auto value = in_.named()) return *value;
    if (const NamedNumbers* const known = found_in(names, token->text)) {
      in_.pass();
      return known->value;
    }
    if (const NamedFunction* const known = found_in(functions, token->text)) return call(*known);
    if (const ColorWord* const word = found_in(color_prefixes, token->text)) return color(*word);
    in_.fail_here("expected a finite number");
  }

  PovNumbers number(const PovToken& token) {
    const auto value = read_finite(token.text);
    if (!value) in_.fail_here("expected a finite number");
    in_.pass();
    return *value;
  }

  /// < a, b, … > from behind the <.
  PovNumbers literal() {
    PovNumbers value;
    value.count = 0;
    do {
      if (value.count == value.of.size()) in_.fail_here("expected > behind five numbers");
      value.of[value.count++] = sum().of[0];
      in_.take(",");
    } while (!in_.at(">"));
    in_.pass();
    if (value.count == 1) in_.fail_here("expected two numbers or more between < and >");
    return value;
  }

  PovNumbers call(const NamedFunction& function) {
    const PovToken at = *in_.here();
    in_.pass();
    in_.expect("(", fmt::format("behind {}", function.name));
    Arguments arguments;
    do arguments.push_back(sum());
    while (in_.take(","));
    in_.expect(")", fmt::format("behind what {} is asked of", function.name));
    if (arguments.size() < function.least || arguments.size() > function.most)
      at.fail(fmt::format("{} of {} values", function.name, arguments.size()),
              fmt::format("expected {}", function.least));
    return finite(function.value(arguments), &at);
  }

  /// A colour of five numbers.
  PovNumbers color(const ColorWord& word) {
    in_.pass();
    if (const PovToken* const next = in_.here(); next != nullptr && share_of(next->text) != nullptr)
      return with_shares(black());
    return with_shares(of_word(word));
  }

  PovNumbers of_word(const ColorWord& word) {
    PovNumbers given = factor();
    if (given.count == 5) return given;  // it is a colour already
    given = given.widened(word.count == 5 ? 3 : word.count);
    if (word.name.starts_with('s'))
      for (std::size_t i = 0; i < 3; ++i) given.of[i] = scene::linear_of_srgb(given.of[i]);
    if (word.name.ends_with("bt")) std::swap(given.of[3], given.of[4]);
    given.count = 5;
    return given;
  }

  static PovNumbers black() {
    PovNumbers color;
    color.count = 5;
    return color;
  }

  static const Component* share_of(std::string_view word) {
    return word.size() > 1 ? found_in(components, word) : nullptr;
  }

  /// A colour with the shares that stand behind it: `red 1 green 0.5`, `filter 0.3`.
  PovNumbers with_shares(PovNumbers color) {
    for (const PovToken* next = in_.here(); next != nullptr; next = in_.here()) {
      const Component* const share = share_of(next->text);
      if (share == nullptr) break;
      in_.pass();
      color.of[share->place] = factor().of[0];
    }
    return color;
  }

  PovNumbers component(const PovNumbers& value) {
    const PovToken* const token = in_.here();
    if (in_.take("gray")) return 0.297 * value.of[0] + 0.589 * value.of[1] + 0.114 * value.of[2];
    const Component* const which = token == nullptr ? nullptr : found_in(components, token->text);
    if (which == nullptr) in_.fail_here("expected a component, such as x or red");
    if (which->place >= value.count) in_.fail_here("expected a component that the value has");
    in_.pass();
    return value.of[which->place];
  }

  PovTerms& in_;
  std::size_t depth_ = 0;
};

}  // namespace

PovNumbers PovNumbers::widened(std::size_t to) const {
  PovNumbers wide = *this;
  wide.count = std::max(count, to);
  if (count == 1) std::fill_n(wide.of.begin(), wide.count, of[0]);
  return wide;
}

glm::dvec3 PovNumbers::triple() const {
  const PovNumbers three = widened(3);
  return {three.of[0], three.of[1], three.of[2]};
}

void PovTerms::fail_here(const std::string& expected) const {
  refuse(expected);
  contract::unreachable();
}

bool PovTerms::take(std::string_view text) {
  if (!at(text)) return false;
  pass();
  return true;
}
void PovTerms::expect(std::string_view text, std::string_view where) {
  if (!take(text)) fail_here(fmt::format("expected {} {}", text, where));
}

PovNumbers pov_sum(PovTerms& in) { return Expression(in).sum(); }
PovNumbers pov_condition(PovTerms& in) { return Expression(in).condition(); }

bool begins_pov_expression(const PovToken& token) {
  if (token.is_number()) return true;
  if (!token.is_name())
    return token.text == "<" || token.text == "(" || token.text == "-" || token.text == "+" || token.text == "!";
  return found_in(names, token.text) || found_in(functions, token.text) || found_in(color_prefixes, token.text);
}

}  // namespace durero::io
