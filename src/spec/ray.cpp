#include "durero/spec/ray.hpp"

#include <algorithm>

#include "durero/zed/value/roots.hpp"

namespace durero::spec {
namespace {

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

/// Where the truth of the membership in alcance may change.
std::vector<Surd> ends(const Judge& judge, const Value& escena, const model::Rayo& rayo,
                       const std::set<model::Elemento>& en, const model::Elemento& e) {
  const zed::Evaluator& evaluator = judge.evaluator();
  const auto apply = [&](const char* name, std::vector<Value> arguments) {
    return evaluator.apply(evaluator.value(zed::Name{name, ""}), Value::tuple(std::move(arguments)));
  };
  const Value seen = en.contains(e) ? apply("puntos_desde", {escena, value(e), value(rayo.p())})
                                    : apply("puntos_de_elemento", {escena, value(e)});
  const auto ends = zed::roots(evaluator.comparisons(seen, [&](zed::Unknown t) { return along(rayo, t); }));
  std::vector<Surd> positive;
  for (const Real& end : ends.value())  // the numbers of a scene are rational
    if (sign(end) > 0) positive.push_back(end.surd());
  return positive;
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
  const auto between = [](const Surd& low, const Surd& high) { return zed::between(Real(low), Real(high)).surd(); };
  const auto holds = [&](const Surd& t) {
    return judge.in_alcance(model::along(rayo.p(), rayo.v(), t), escena, rayo, en, e);
  };
  for (std::size_t i = 0; i < extent.at.size(); ++i) {
    extent.between.push_back(holds(between(i == 0 ? Surd() : extent.at[i - 1], extent.at[i])));
    extent.on.push_back(holds(extent.at[i]));
  }
  extent.between.push_back(holds(extent.at.empty() ? Surd(1) : zed::above(Real(extent.at.back())).surd()));
  return extent;
}

}  // namespace durero::spec
