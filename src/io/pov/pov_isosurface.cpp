#include "pov_isosurface.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "pov_pieces.hpp"

namespace durero::io {

using number::Rational;

namespace {

/// The greatest degree of an isosurface that a Z text holds, and of what is read on the way there.
constexpr int greatest_isosurface_degree = 4, greatest_read_degree = 24;
/// Parentheses within each other, at most: each is read by a call within a call.
constexpr int deepest_parentheses = 200;

/// A function of x, y and z, read as a polynomial. Nothing of what else stands there.
class FunctionReader {
 public:
  explicit FunctionReader(PovWords& in) : in_(in) {}

  std::optional<PovPolynomial> sum() {
    auto all = product();
    while (all && (in_.at("+") || in_.at("-"))) {
      const bool is_plus = in_.take("+");
      if (!is_plus) in_.pass();
      const auto next = product();
      if (!next) return std::nullopt;
      all = is_plus ? *all + *next : *all - *next;
    }
    return all;
  }

 private:
  std::optional<PovPolynomial> product() {
    auto all = factor();
    while (all && (in_.at("*") || in_.at("/"))) {
      const bool is_times = in_.take("*");
      if (!is_times) in_.pass();
      const auto next = factor();
      if (!next) return std::nullopt;
      if (is_times) {
        if (all->degree() + next->degree() > greatest_read_degree) return std::nullopt;
        all = *all * *next;
      } else {
        if (next->degree() > 0 || next->terms().empty()) return std::nullopt;
        all = *all * PovPolynomial(Rational(1 / next->coefficient({0, 0, 0})));
      }
    }
    return all;
  }

  std::optional<PovPolynomial> factor() {
    if (++depth_ > deepest_parentheses) return std::nullopt;
    auto read = read_factor();
    --depth_;
    return read;
  }

  std::optional<PovPolynomial> read_factor() {
    if (in_.take("+")) return factor();
    if (in_.here() != nullptr && in_.here()->is_number()) return PovPolynomial(*in_.take_number());
    if (in_.take("-")) {
      const auto opposite = factor();
      return opposite ? std::optional(PovPolynomial() - *opposite) : std::nullopt;
    }
    for (const auto& [word, axis] : {std::pair{"x", 0U}, std::pair{"y", 1U}, std::pair{"z", 2U}})
      if (in_.take(word)) return PovPolynomial::coordinate(axis);
    if (in_.take("pow")) return raised();
    if (!in_.take("(")) return std::nullopt;
    auto within = sum();
    return in_.take(")") ? within : std::nullopt;
  }

  /// From behind pow.
  std::optional<PovPolynomial> raised() {
    if (!in_.take("(")) return std::nullopt;
    const auto base = sum();
    if (!base || !in_.take(",")) return std::nullopt;
    const auto exponent = sum();
    if (!exponent || exponent->degree() > 0 || !in_.take(")")) return std::nullopt;
    const double times = number::round_to_binary64(exponent->coefficient({0, 0, 0}));
    if (!(times >= 0 && times == std::floor(times)) || times * base->degree() > greatest_read_degree ||
        times > greatest_read_degree)
      return std::nullopt;
    return power(*base, static_cast<int>(times));
  }

  PovWords& in_;
  int depth_ = 0;
};

/// From behind `function` to behind its }.
std::optional<PovPolynomial> read_function(PovWords& in) {
  in.expect("{", "behind function");
  PovWords whole = in;
  auto read = FunctionReader(in).sum();
  if (read && in.take("}")) return read;
  in.stand_where(whole);
  in.skip_block();
  return std::nullopt;
}

/// The parts of space that may hold an isosurface.
struct Container {
  std::optional<std::array<glm::dvec3, 2>> box{};
  scene::Sphere ball{};
};

/// From behind `contained_by`.
Container read_container(PovWords& in) {
  in.expect("{", "behind contained_by");
  Container container;
  const bool is_box = in.take("box");
  if (!is_box && !in.take("sphere")) in.fail_here("expected box or sphere in contained_by");
  in.expect("{", is_box ? "behind box" : "behind sphere");
  const glm::dvec3 first = in.triple("contained_by");
  in.comma();
  if (is_box)
    container.box = {first, in.triple("contained_by")};
  else
    container.ball = {first, in.number("contained_by")};
  in.expect("}", "behind the numbers of a container");
  in.expect("}", "behind a container");
  return container;
}

std::vector<PovPiece> pieces_within(const PovPolynomial& level, const Container& container, bool is_open) {
  PovPiece surface{level};
  surface.clip = container.box ? inside_of_box(*container.box) : inside_of_ball(container.ball);
  std::vector<PovPiece> all{surface};
  if (is_open) return all;
  for (PovClip& face : container.box ? faces_of_box(*container.box) : std::vector{inside_of_ball(container.ball)}) {
    PovPiece lid{level};
    lid.clip = std::move(face);
    lid.is_lid = true;
    all.push_back(std::move(lid));
  }
  return all;
}

}  // namespace

std::optional<std::vector<PovPiece>> read_pov_isosurface(PovWords& in) {
  std::optional<PovPolynomial> function;
  Container container{.box = {{glm::dvec3(-1), glm::dvec3(1)}}};  // POV-Ray's own
  double threshold = 0;
  bool is_open = false;
  while (true) {
    if (in.take("function"))
      function = read_function(in);
    else if (in.take("contained_by"))
      container = read_container(in);
    else if (in.take("threshold"))
      threshold = in.number("threshold");
    else if (in.take("open"))
      is_open = true;
    else if (in.take("accuracy") || in.take("max_gradient") || in.take("max_trace") || in.take("evaluate"))
      in.skip_value();  // of how POV-Ray searches
    else if (!in.take("all_intersections"))
      break;
  }
  if (!function || function->degree() > greatest_isosurface_degree || function->degree() == 0) return std::nullopt;
  return pieces_within(*function - threshold, container, is_open);
}

}  // namespace durero::io
