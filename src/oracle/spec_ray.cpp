#include "durero/oracle/spec_ray.hpp"

#include <algorithm>

namespace durero::oracle::spec {
namespace {

using number::Rational;
using number::Surd;
using zed::Real;
using zed::Value;

Value along(const model::Rayo& rayo, zed::Unknown t) {
  static const zed::Signature names = zed::signature({{"x", ""}, {"y", ""}, {"z", ""}});
  const model::Punto& p = rayo.p();
  const model::Vector& v = rayo.v();
  return Value::binding(names, {Value::line(Real(p.x()), Real(v.x()), t), Value::line(Real(p.y()), Real(v.y()), t),
                                Value::line(Real(p.z()), Real(v.z()), t)});
}

/// The positive real roots of c + b·t + a·t², of which one is not 0. The numbers of the text are rational here.
void append_roots(const zed::Polynomial& polynomial, std::vector<Surd>& to) {
  const auto rational = [](const Real& value) { return value.surd().x; };
  const Rational c = rational(polynomial.constant), b = rational(polynomial.slope), a = rational(polynomial.square);
  const auto take = [&](Surd root) {
    if (number::sign(root) > 0) to.push_back(std::move(root));
  };
  if (a == 0) {
    if (b != 0) take(Rational(-c / b));
    return;
  }
  const Rational discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return;
  for (const int side : {-1, 1}) take(Surd(Rational(-b / (2 * a)), Rational(side / (2 * a)), discriminant));
}

/// A rational strictly between two numbers, 0 ≤ low < high.
Surd between(const Surd& low, const Surd& high) {
  Rational from = 0, to = 1;
  while (Surd(to) < high) to *= 2;
  for (;;) {
    const Rational middle = (from + to) / 2;
    if (Surd(middle) <= low) {
      from = middle;
    } else if (Surd(middle) >= high) {
      to = middle;
    } else {
      return middle;
    }
  }
}

Surd above(const Surd& low) {
  Rational found = 1;
  while (Surd(found) <= low) found *= 2;
  return found;
}

/// Where the truth of the membership in alcance may change.
std::vector<Surd> ends(const Judge& judge, const Value& escena, const model::Rayo& rayo,
                       const std::set<model::Elemento>& en, const model::Elemento& e) {
  const zed::Evaluator& evaluator = judge.evaluator();
  const auto apply = [&](const char* name, std::vector<Value> arguments) {
    return evaluator.apply(evaluator.value(zed::Name{name, ""}), Value::tuple(std::move(arguments)));
  };
  const Value seen = en.contains(e) ? apply("puntos_desde", {escena, value(e), value(rayo.p())})
                                    : apply("puntos_de_elemento", {escena, value(e)});
  std::vector<Surd> found;
  for (const auto& comparison : evaluator.comparisons(seen, [&](zed::Unknown t) { return along(rayo, t); })) {
    append_roots(comparison, found);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

bool Extent::empty() const {
  return std::find(on.begin(), on.end(), true) == on.end() &&
         std::find(between.begin(), between.end(), true) == between.end();
}

const Surd* Extent::first() const {
  for (std::size_t i = 0; i < at.size() && !between[i]; ++i) {
    if (on[i]) return &at[i];
  }
  return nullptr;
}

bool Extent::any_below(const Surd& limit) const {
  for (std::size_t i = 0; i < between.size(); ++i) {
    const bool starts_below = i == 0 ? number::sign(limit) > 0 : at[i - 1] < limit;
    if (starts_below && (between[i] || (i > 0 && on[i - 1]))) return true;
  }
  return false;
}

Extent alcance(const Judge& judge, const Value& escena, const model::Rayo& rayo, const std::set<model::Elemento>& en,
               const model::Elemento& e) {
  Extent extent{ends(judge, escena, rayo, en, e), {}, {}};
  const auto holds = [&](const Surd& t) {
    return judge.in_alcance(model::along(rayo.p(), rayo.v(), t), escena, rayo, en, e);
  };
  for (std::size_t i = 0; i < extent.at.size(); ++i) {
    extent.between.push_back(holds(between(i == 0 ? Surd() : extent.at[i - 1], extent.at[i])));
    extent.on.push_back(holds(extent.at[i]));
  }
  extent.between.push_back(holds(extent.at.empty() ? Surd(1) : above(extent.at.back())));
  return extent;
}

}  // namespace durero::oracle::spec
