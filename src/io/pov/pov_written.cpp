#include "pov_written.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "durero/io/pov/algebraic.hpp"

namespace durero::io {

using number::Rational;

namespace {

/// The attributes that hold the 35 coefficients of degree four, in POV-Ray's order.
const std::vector<WrittenAttribute>& holders_of_coefficients() {
  constexpr WrittenKind number = WrittenKind::number, triple = WrittenKind::triple;
  static const std::vector<WrittenAttribute> all{{"xxxx", number}, {"xxx", triple}, {"xx_1", triple}, {"xx_2", triple},
                                                 {"x_1", triple},  {"x_2", triple}, {"x_3", triple},  {"x_4", number},
                                                 {"c_1", triple},  {"c_2", triple}, {"c_3", triple},  {"c_4", triple},
                                                 {"c_5", triple}};
  return all;
}

/// A type with a place of its own in space. A Z text has the components of a schema in the order of their names.
WrittenType placed_type(std::string word, std::vector<WrittenAttribute> own) {
  for (const char* const place : {"centro", "x", "y", "z"}) own.push_back({place, WrittenKind::triple});
  std::ranges::sort(own, {}, &WrittenAttribute::word);
  return {std::move(word), std::move(own)};
}

/// The letters of the quadrics that clip in the space of a surface, and in that of a clip.
constexpr char own_letters[] = {'p', 'q'}, clip_letters[] = {'a', 'b', 'c'};

std::vector<WrittenAttribute> numbers_named(std::initializer_list<const char*> words) {
  std::vector<WrittenAttribute> all;
  for (const char* const word : words) all.push_back({word, WrittenKind::number});
  return all;
}

std::vector<WrittenAttribute> attributes_of_blob() {
  std::vector<WrittenAttribute> all{{"umbral", WrittenKind::number}};
  for (char i = '1'; i <= '6'; ++i)
    for (const char letter : {'c', 'v', 'r', 'f'})
      all.push_back(
          {std::string{letter, '_', i}, letter == 'c' || letter == 'v' ? WrittenKind::triple : WrittenKind::number});
  return all;
}

std::vector<WrittenAttribute> attributes_of_clipped() {
  std::vector<WrittenAttribute> all = holders_of_coefficients();
  for (const char letter : {'p', 'q', 'a', 'b', 'c'}) {
    all.push_back({std::string{letter}, WrittenKind::three_points});
    all.push_back({std::string{letter, '_', '0'}, WrittenKind::number});
  }
  all.push_back({"corte", WrittenKind::triple});
  all.push_back({"ejes_corte", WrittenKind::three_points});
  all.push_back({"fuera", WrittenKind::number});
  return all;
}

}  // namespace

std::span<const WrittenType> algebraic_types() {
  static const std::vector<WrittenType> types{
      placed_type("toro_oblicuo", {{"mayor", WrittenKind::number}, {"menor", WrittenKind::number}}),
      placed_type("cuartica", holders_of_coefficients()),
      placed_type("recorte", attributes_of_clipped()),
      placed_type("tapa", attributes_of_clipped()),
      placed_type("torneado", numbers_named({"r_0", "r_1", "r_2", "r_3", "h_0", "h_1", "h_2", "h_3"})),
      placed_type("alzado",
                  numbers_named({"r_0", "r_1", "r_2", "r_3", "h_0", "h_1", "h_2", "h_3", "desde", "hasta", "conico"})),
      placed_type("superelipsoide", numbers_named({"a", "b", "p", "q", "impar_a", "impar_b"})),
      placed_type("gotas", attributes_of_blob())};
  return types;
}

double PovAttributes::rounded(const Rational& value) {
  const double near = number::round_to_binary64(value);
  if (!std::isfinite(near))
    is_finite_ = false;
  else if (number::exact(near) != value)
    is_rounded_ = true;
  return near;
}

glm::dvec3 PovAttributes::rounded(const PovPolynomial& polynomial, const std::array<PovPowers, 3>& terms) {
  glm::dvec3 made;
  for (int i = 0; i < 3; ++i) made[i] = rounded(polynomial.coefficient(terms.at(static_cast<std::size_t>(i))));
  return made;
}

void PovAttributes::set_quartic(const PovPolynomial& polynomial) {
  const std::vector<PovPowers> powers = pov_powers_up_to(4);
  auto next = powers.begin();
  for (const auto& [word, kind] : holders_of_coefficients()) {
    if (kind == WrittenKind::number)
      values_[word] = rounded(polynomial.coefficient(*next++));
    else
      values_[word] = rounded(polynomial, {next[0], next[1], next[2]}), next += 3;
  }
}

void PovAttributes::set_quadric(char letter, const PovPolynomial& polynomial) {
  values_[std::string{letter}] = scene::Corners{rounded(polynomial, {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}),
                                                rounded(polynomial, {{{1, 1, 0}, {1, 0, 1}, {0, 1, 1}}}),
                                                rounded(polynomial, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}})};
  values_[std::string{letter, '_', '0'}] = rounded(polynomial.coefficient({0, 0, 0}));
}

void PovAttributes::set_place(const PovTransform& by) {
  values_["centro"] = by.shift;
  values_["x"] = by.linear[0], values_["y"] = by.linear[1], values_["z"] = by.linear[2];
}

void PovAttributes::set_clip_place(const PovTransform& by) {
  values_["corte"] = by.shift;
  values_["ejes_corte"] = scene::Corners{by.linear[0], by.linear[1], by.linear[2]};
}

void PovAttributes::set_all(const ValuesByWord& values) {
  for (const auto& [word, value] : values) values_.insert_or_assign(word, value);
}

void PovAttributes::set_number(const std::string& word, const Rational& value) { values_[word] = rounded(value); }

namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_finite_value(const WrittenValue& value) {
  if (const auto* const triple = std::get_if<glm::dvec3>(&value)) return is_finite(*triple);
  const auto* const corners = std::get_if<scene::Corners>(&value);
  return corners == nullptr || std::ranges::all_of(*corners, is_finite);
}

}  // namespace

std::optional<std::vector<WrittenValue>> PovAttributes::of_type(std::size_t type) const {
  std::vector<WrittenValue> attributes;
  for (const WrittenAttribute& attribute : algebraic_types()[type].attributes)
    attributes.push_back(values_.at(attribute.word));
  if (!is_finite_ || !std::ranges::all_of(attributes, is_finite_value)) return std::nullopt;
  return attributes;
}

std::optional<std::vector<WrittenValue>> placed_element(const PovElement& element, const PovTransform& by) {
  PovAttributes attributes;
  attributes.set_all(element.own);
  attributes.set_place(by);
  return has_way_back(by) ? attributes.of_type(element.type) : std::nullopt;
}

std::optional<std::vector<WrittenValue>> clipped_piece(const PovPiece& piece, const PovClip* clip,
                                                       const PovTransform& by, bool& is_rounded) {
  const PovTransform place = piece.place.then(by);
  PovAttributes attributes;
  attributes.set_place(place);
  attributes.set_quartic(piece.equation);
  const auto within = [](const std::vector<PovPolynomial>& all, std::size_t i) {
    return i < all.size() ? all[i] : PovPolynomial();
  };
  for (std::size_t i = 0; i < std::size(own_letters); ++i)
    attributes.set_quadric(own_letters[i], within(piece.within, i));
  if (clip != nullptr && piece.clip) return std::nullopt;
  PovClip cut = clip != nullptr ? *clip : PovClip();
  if (piece.clip) {
    cut = *piece.clip;
    cut.place = cut.place.then(by);
  }
  for (std::size_t i = 0; i < std::size(clip_letters); ++i)
    attributes.set_quadric(clip_letters[i], within(cut.within, i));
  attributes.set_clip_place(cut.place);
  attributes.set_number("fuera", cut.is_outside ? 1 : 0);
  auto values = attributes.of_type(piece.is_lid ? lid_of_surface : clipped_surface);
  if (!values || !has_way_back(place) || !has_way_back(cut.place)) return std::nullopt;
  const bool is_moved = !by.is_identity() && (!piece.place.is_identity() || piece.clip);
  is_rounded = is_rounded || piece.is_rounded || cut.is_rounded || is_moved || attributes.is_rounded();
  return values;
}

}  // namespace durero::io
