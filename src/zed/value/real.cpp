#include "durero/zed/value/real.hpp"

#include <bit>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace durero::zed {
namespace {

__extension__ typedef __int128 Wide;
__extension__ typedef unsigned __int128 Unsigned;

constexpr int max_bits = 126;  // a significand has as many; one more is for the carry of a sum, one for the sign

int bit_width(Wide value) {
  const Unsigned magnitude = value < 0 ? -static_cast<Unsigned>(value) : static_cast<Unsigned>(value);
  const auto high = static_cast<std::uint64_t>(magnitude >> 64);
  return static_cast<int>(high != 0 ? 64 + std::bit_width(high)
                                    : std::bit_width(static_cast<std::uint64_t>(magnitude)));
}

int trailing_zeros(Wide value) {
  const auto low = static_cast<std::uint64_t>(value);
  return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(value >> 64));
}

[[noreturn]] void no_form(const char* what) {
  throw std::domain_error(std::string(what) + " is neither x+y*√Δ over the rationals nor the root of one");
}

}  // namespace

struct SmallArithmetic {
  using Small = Real::Small;

  static Wide wide(const Small& value) {
    return static_cast<Wide>((static_cast<Unsigned>(static_cast<std::uint64_t>(value.high)) << 64) | value.low);
  }

  // Exponents stay in a range in which no sum of a few of them overflows.
  static std::optional<Small> small(Wide significand, std::int64_t exponent) {
    if (significand == 0) return Small{};
    const int zeros = trailing_zeros(significand);
    significand >>= zeros;
    exponent += zeros;
    if (bit_width(significand) > max_bits || exponent < -(1 << 24) || exponent > (1 << 24)) return std::nullopt;
    return Small{static_cast<std::int64_t>(significand >> 64), static_cast<std::uint64_t>(significand),
                 static_cast<std::int32_t>(exponent)};
  }

  static std::optional<Small> sum(const Small& a, const Small& b, int sign_of_b) {
    const Wide x = wide(a), y = sign_of_b * wide(b);
    if (x == 0) return small(y, b.exponent);
    if (y == 0) return a;
    if (a.exponent >= b.exponent) return aligned_sum(x, a.exponent - b.exponent, y, b.exponent);
    return aligned_sum(y, b.exponent - a.exponent, x, a.exponent);
  }

  // Returns x·2^shift + y, both times 2^exponent.
  static std::optional<Small> aligned_sum(Wide x, std::int32_t shift, Wide y, std::int32_t exponent) {
    if (bit_width(x) + shift > max_bits) return std::nullopt;
    return small(x * (Wide{1} << shift) + y, exponent);
  }

  static std::optional<Small> product(const Small& a, const Small& b) {
    const Wide x = wide(a), y = wide(b);
    if (bit_width(x) + bit_width(y) > max_bits) return std::nullopt;
    return small(x * y, std::int64_t{a.exponent} + b.exponent);
  }

  static int sign(const Small& a) { return a.high < 0 ? -1 : (a.high | static_cast<std::int64_t>(a.low != 0)) != 0; }

  static std::strong_ordering compare(const Small& a, const Small& b) {
    if (sign(a) != sign(b)) return sign(a) <=> sign(b);
    Wide x = wide(a), y = wide(b);
    const int of_x = bit_width(x) + a.exponent, of_y = bit_width(y) + b.exponent;
    if (of_x != of_y) return sign(a) > 0 ? of_x <=> of_y : of_y <=> of_x;
    // The leading bits are the same: the one with the greater exponent has the fewer bits, so it has room to be
    // aligned.
    if (a.exponent > b.exponent) x *= Wide{1} << (a.exponent - b.exponent);
    if (b.exponent > a.exponent) y *= Wide{1} << (b.exponent - a.exponent);
    return x <=> y;
  }

  static number::Rational rational(const Small& a) {
    const Wide significand = wide(a);
    number::Integer n = number::Integer(static_cast<std::int64_t>(significand >> 64));
    n <<= 64;
    n += number::Integer(a.low);
    if (a.exponent >= 0) return number::Rational(n << static_cast<unsigned>(a.exponent));
    return number::Rational(n, number::Integer(1) << static_cast<unsigned>(-a.exponent));
  }

  // Returns the small form where the number is a dyadic of so few bits.
  static std::optional<Small> of(const number::Surd& value) {
    if (!value.y.is_zero()) return std::nullopt;
    number::Integer n = numerator(value.x);
    const number::Integer d = denominator(value.x);
    if (n.is_zero()) return Small{};
    const auto below = static_cast<std::int64_t>(lsb(d));
    if (msb(d) != static_cast<std::size_t>(below)) return std::nullopt;
    const bool negative = n.sign() < 0;
    if (negative) n = -n;
    const auto zeros = static_cast<std::int64_t>(lsb(n));
    if (static_cast<std::int64_t>(msb(n)) - zeros >= max_bits) return std::nullopt;
    n >>= static_cast<unsigned>(zeros);
    const Wide high = static_cast<std::uint64_t>(number::Integer(n >> 64));
    const Wide low = static_cast<std::uint64_t>(number::Integer(n & number::Integer(~std::uint64_t{0})));
    const Wide significand = high * (Wide{1} << 64) + low;
    return small(negative ? -significand : significand, zeros - below);
  }
};

using S = SmallArithmetic;

Real::Real(int value) : form_(*S::small(value, 0)) {}

Real::Real(double value) : form_(Small{}) {
  if (!std::isfinite(value)) throw std::domain_error("an infinity or a NaN denotes no number");
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  form_ = *S::small(static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53);
}

Real::Real(number::Surd value) : form_(Small{}) {
  if (const auto small = S::of(value)) {
    form_ = *small;
  } else {
    form_ = std::make_shared<const number::Surd>(std::move(value));
  }
}

Real Real::natural(const std::string& digits) { return Real(number::Surd(number::Rational(number::Integer(digits)))); }

bool Real::is_integer() const {
  if (const auto* small = std::get_if<Small>(&form_)) return small->exponent >= 0;
  const auto* big = std::get_if<Big>(&form_);
  return big && (*big)->y.is_zero() && denominator((*big)->x) == 1;
}

std::size_t Real::words() const {
  const auto words_of_integer = [](const number::Integer& part) -> std::size_t {
    return part.is_zero() ? 0 : msb(part.sign() < 0 ? number::Integer(-part) : part) / 64 + 1;
  };
  const auto words_of = [&](const number::Rational& part) {
    return words_of_integer(numerator(part)) + words_of_integer(denominator(part));
  };
  const auto* big = std::get_if<Big>(&form_);
  return big ? words_of((*big)->x) + words_of((*big)->y) : 0;
}

const number::Surd& Real::surd(number::Surd& room) const {
  if (const auto* big = std::get_if<Big>(&form_)) return **big;
  if (const auto* small = std::get_if<Small>(&form_)) return room = number::Surd(S::rational(*small));
  no_form("this number");
}

number::Surd Real::surd() const {
  number::Surd room;
  return surd(room);
}

Real operator+(const Real& a, const Real& b) {
  const auto *x = std::get_if<Real::Small>(&a.form_), *y = std::get_if<Real::Small>(&b.form_);
  if (x && y) {
    if (const auto sum = S::sum(*x, *y, 1)) return Real(*sum);
  }
  if (x && S::sign(*x) == 0) return b;
  if (y && S::sign(*y) == 0) return a;
  if (!a.is_surd() || !b.is_surd()) no_form("a sum");
  number::Surd room_a, room_b;
  return Real(a.surd(room_a) + b.surd(room_b));
}

Real operator-(const Real& a, const Real& b) {
  const auto *x = std::get_if<Real::Small>(&a.form_), *y = std::get_if<Real::Small>(&b.form_);
  if (x && y) {
    if (const auto difference = S::sum(*x, *y, -1)) return Real(*difference);
  }
  if (y && S::sign(*y) == 0) return a;
  if (!a.is_surd() || !b.is_surd()) {
    if (a == b) return Real();
    no_form("a difference");
  }
  number::Surd room_a, room_b;
  return Real(a.surd(room_a) - b.surd(room_b));
}

Real operator*(const Real& a, const Real& b) {
  const auto *x = std::get_if<Real::Small>(&a.form_), *y = std::get_if<Real::Small>(&b.form_);
  if (x && y) {
    if (const auto product = S::product(*x, *y)) return Real(*product);
  }
  if ((x && S::sign(*x) == 0) || (y && S::sign(*y) == 0)) return Real();
  if (a.is_surd() && b.is_surd()) {
    number::Surd room_a, room_b;
    return Real(a.surd(room_a) * b.surd(room_b));
  }
  const auto *r = std::get_if<Real::Rooted>(&a.form_), *q = std::get_if<Real::Rooted>(&b.form_);
  if (r && q) {  // √u · √w = √(u·w), and √u · √u = u
    if ((*r)->radicand == (*q)->radicand) return Real((*r)->radicand);
    return square_root(Real((*r)->radicand * (*q)->radicand));
  }
  no_form("a product");
}

Real operator/(const Real& a, const Real& b) {
  if (sign(b) == 0) throw std::domain_error("division by 0");
  if (!a.is_surd() || !b.is_surd()) no_form("a quotient");
  number::Surd room_a, room_b;
  return Real(a.surd(room_a) / b.surd(room_b));
}

std::strong_ordering operator<=>(const Real& a, const Real& b) {
  const auto *x = std::get_if<Real::Small>(&a.form_), *y = std::get_if<Real::Small>(&b.form_);
  if (x && y) return S::compare(*x, *y);
  const auto *r = std::get_if<Real::Rooted>(&a.form_), *q = std::get_if<Real::Rooted>(&b.form_);
  if (r && q) return number::compare((*r)->radicand, (*q)->radicand);
  if (r) return sign(b) < 0 ? std::strong_ordering::greater : number::compare((*r)->radicand, (b * b).surd());
  if (q) return sign(a) < 0 ? std::strong_ordering::less : number::compare((a * a).surd(), (*q)->radicand);
  number::Surd room_a, room_b;
  return number::compare(a.surd(room_a), b.surd(room_b));
}

int sign(const Real& value) {
  if (const auto* small = std::get_if<Real::Small>(&value.form_)) return S::sign(*small);
  if (const auto* big = std::get_if<Real::Big>(&value.form_)) return number::sign(**big);
  return 1;
}

Real square_root(const Real& value) {
  if (sign(value) < 0) throw std::domain_error("a negative number has no root");
  if (!value.is_surd()) no_form("a root of a root");
  const number::Surd radicand = value.surd();
  if (radicand.y.is_zero()) return Real(number::Surd(0, 1, radicand.x));
  Real root;
  root.form_ = std::make_shared<const Real::Root>(Real::Root{radicand});
  return root;
}

Real integer_quotient(const Real& a, const Real& b) {
  if (!a.is_integer() || !b.is_integer()) throw std::domain_error("div of numbers that are not integers");
  if (sign(b) == 0) throw std::domain_error("division by 0");
  const number::Integer n = numerator(a.surd().x), d = numerator(b.surd().x);
  number::Integer quotient, remainder;
  divide_qr(n, d, quotient, remainder);
  if (!remainder.is_zero() && (remainder.sign() < 0) != (d.sign() < 0)) --quotient;  // rounded down, not cut
  return Real(number::Surd(number::Rational(quotient)));
}

namespace {

std::string text(const number::Surd& value) {
  if (value.y.is_zero()) return value.x.str();
  const std::string radicand = value.delta.str();
  const std::string root = radicand.find('/') == radicand.npos ? "√" + radicand : "√(" + radicand + ")";
  const number::Rational size = value.y.sign() < 0 ? number::Rational(-value.y) : value.y;
  const std::string term = size == 1 ? root : size.str() + "*" + root;
  if (value.x.is_zero()) return (value.y.sign() < 0 ? "-" : "") + term;
  return value.x.str() + (value.y.sign() < 0 ? "-" : "+") + term;
}

}  // namespace

std::string Real::text() const {
  if (const auto* root = std::get_if<Rooted>(&form_)) return "√(" + zed::text((*root)->radicand) + ")";
  return zed::text(surd());
}

}  // namespace durero::zed
