#pragma once
/// What each step computes of one ray and one element, against exact arithmetic, in parts of the bound that it states.

#include "bounds_table.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/search.hpp"
#include "support/shapes.hpp"
#include "trace/rounding-inl.hpp"
#include "trace/steps.hpp"
#include "trace/triage.hpp"

namespace durero::test {

namespace steps = trace::HWY_NAMESPACE;
using trace::Decision;
using trace::Ray;
using trace::RootEstimate;

inline Dyadic exact(double x) { return x; }
inline Dyadic exact(const steps::DoubleDouble& x) { return Dyadic(x.hi) + Dyadic(x.lo); }

inline constexpr double wrong = std::numeric_limits<double>::infinity();

template <class Shape>
class Measurement {
 public:
  Measurement(const Shape& shape, const Specimen& specimen)
      : shape_(shape),
        rayo_(specimen.rayo()),
        traced_(rayo_),
        on_(specimen.on),
        exact_(shape, rayo_, false),
        reach_(reach(surface::exact::coefficients(shape, rayo_, on_))) {}

  Ratios ratios() && {
    closed_form<double>("triage");
    closed_form<steps::DoubleDouble>("stable");
    const RootEstimate first = triage(shape_, traced_, on_), second = stable(shape_, traced_, on_);
    if (is_right_hit("triage", first)) improvement(first);
    if (is_right_hit("stable", second)) rounding("stable", second);
    if (!on_) in_lanes();
    ends();
    return std::move(ratios_);
  }

 private:
  void note(std::string_view step, std::string_view name, double ratio) { ratios_.push_back({{step, name}, ratio}); }

  /// The quantities of the closed form over T.
  template <class T>
  void closed_form(std::string_view step) {
    const auto f = steps::quadratic<T>(shape_, traced_);
    note(step, "A", ratio(exact(f.A) - exact_.A, f.A_error));
    note(step, "B", ratio(exact(f.B) - exact_.B, f.B_error));
    note(step, "C", ratio(exact(f.C) - exact_.C, f.C_error));
    note(step, "F", ratio(exact(f.F) - exact_.F, f.B_error));
    note(step, "H", ratio(exact(f.H) - exact_.H, f.B_error));
    if constexpr (steps::is_linear(Shape::tipo)) {
      if (!(steps::magnitude(f.B) > 2 * f.B_error)) return;
      parameter(step, f, steps::root_of_linear(f), {-exact_.C, shifted(exact_.B, 1)});
      if (f.edged) note(step, "margin", ratio(error_of_margin(f), f.margin_error));
      return;
    }
    const bool A_known = steps::magnitude(f.A) > 2 * f.A_error;
    if (on_) {
      if (A_known) {
        const auto root = steps::quotient(T(-(f.B + f.B)), 2 * f.B_error, f.A, f.A_error);
        parameter(step, f, root, {-exact_.B - exact_.B, exact_.A});
      }
    } else if (steps::leading(f.F) > f.B_error) {
      const auto S = steps::root_of_discriminant(f);
      note(step, "D", ratio(exact(f.F) * exact(f.H) - exact_.D, Dyadic(S.error) * exact(S.value)));
      note(step, "S", ratio(exact(S.value) - exact_.S, S.error));
      const auto sum = steps::stable_sum(f, S);
      const Dyadic q = -(exact_.B + (sum.positive ? exact_.S : -exact_.S));
      note(step, "q", ratio(exact(sum.q.value) - q, sum.q.error));
      if (!(steps::magnitude(sum.q.value) > 2 * sum.q.error)) return;
      if (A_known) parameter(step, f, steps::quotient(sum.q.value, sum.q.error, f.A, f.A_error), {q, exact_.A});
      parameter(step, f, steps::quotient(f.C, f.C_error, sum.q.value, sum.q.error), {exact_.C, q});
    }
  }

  /// Less what it errs by as it is cut to a leading part, which keeps its sign. Precondition: the sign of B is certain,
  /// as margin is measured by it.
  template <class T>
  Dyadic error_of_margin(const steps::BoundedQuadratic<T>& f) const {
    const Exact_Vector p(rayo_.p().xyz()), v(rayo_.v().xyz());
    const Dyadic cut = std::is_same_v<T, double> ? 0 : shifted(magnitude(Dyadic(f.margin)), -53);
    if constexpr (requires { margin(shape_, p, v); })
      return std::max(magnitude(Dyadic(f.margin) - margin(shape_, p, v)) - cut, Dyadic());
    else
      return {};
  }

  /// A root, and the advance at it.
  template <class T>
  void parameter(std::string_view step, const steps::BoundedQuadratic<T>& f, const steps::Root<T>& computed,
                 const Fraction& t) {
    note(step, "root", t.ratio(exact(computed.t), computed.error));
    if (!f.bounded) return;
    const auto s = steps::advance(f, computed);
    const Fraction avance = t.linear(exact_.s0, exact_.s1);
    note(step, "avance", avance.ratio(exact(s.value), s.error));
    const Fraction rest = t.linear(*exact_.altura - exact_.s0, -exact_.s1);
    note(step, "altura − avance", rest.ratio(exact(T(T(f.altura) - s.value)), s.error));
  }

  /// The answer of a whole step, a hit or a miss, must be the exact one. Whether it is a hit, and right.
  bool is_right_hit(std::string_view step, const RootEstimate& finding) {
    if (finding.verdict == Decision::undecided) return false;
    const bool hit = finding.verdict == Decision::hit;
    const bool right = hit ? !reach_.empty() && !reach_.no_minimum() : reach_.empty();
    note(step, "t", !right ? wrong : !hit ? 0 : of_t(finding));
    if (!hit || !right) return false;
    if (step != "stable") slope(step, finding.slope);
    return true;
  }

  /// A·t + B at the first root, which is S or −S; B less for a ray that starts on the element.
  void slope(std::string_view step, const trace::Slope& computed) {
    const bool falls = number::sign(number::linear(exact_.B, exact_.A, reach_.first())) < 0;
    const Dyadic at_root = steps::is_linear(tipo) ? exact_.B : on_ ? -exact_.B : falls ? -exact_.S : exact_.S;
    note(step, "slope", ratio(Dyadic(computed.at_root) - at_root, computed.at_root_error));
    note(step, "A of the slope", ratio(Dyadic(computed.A) - exact_.A, computed.A_error));
  }

  double of_t(const RootEstimate& finding) const {
    return fraction(reach_.first()).ratio(Dyadic(finding.hi) + Dyadic(finding.lo), finding.error);
  }

  void in_lanes() {
    trace::Packet packet;
    for (std::size_t lane = 0; lane < trace::Packet::size; ++lane) packet.set(lane, traced_, shape_);
    trace::Findings findings;
    triage(packet, tipo, findings);
    const RootEstimate finding = findings[trace::Packet::size - 1];
    if (!is_right_hit("lanes", finding)) return;
    trace::RoundedPacket rounded;
    improve_and_round(packet, tipo, findings, rounded);
    constexpr std::size_t last = trace::Packet::size - 1;
    if ((rounded.certain >> last & 1) == 0) return;
    rounded_right("lanes", rounded.t[last], {rounded.x[last], rounded.y[last], rounded.z[last]});
  }

  /// The search's two ends of the first point's parameter, as parts of the way from the finding to each.
  void ends() {
    scene::Scene scene;
    const scene::ElementRef e = add(scene, shape_);
    const scene::Origin en = on_ ? scene::Origin(e) : scene::Origin();
    trace::Counts counts;
    const trace::Meeting met = trace::Search(scene, rayo_, en, counts).meeting(e, trace::no_limit);
    if (met.kind != trace::Meeting::Kind::point || met.step == trace::Step::exact) return;
    const Dyadic hi(met.finding.hi);
    const Fraction on_the_way = fraction(reach_.first()).linear(-hi, 1);
    const Dyadic end = number::sign(on_the_way.n) == number::sign(on_the_way.w) ? met.high : met.low;
    note("search", met.step == trace::Step::triage ? "ends, triage" : "ends, stable",
         ratio(on_the_way.n, magnitude((end - hi) * on_the_way.w)));
  }

  void improvement(const RootEstimate& first) {
    const auto f = steps::quadratic_at(first.hi, shape_, traced_, on_);
    Exact from = exact_;
    if (on_) from.C = Dyadic();
    note("improved", "potencia", ratio(exact(f.value) - from.quadratic(first.hi), f.error));
    const RootEstimate better = improved(shape_, traced_, on_, first);
    if (better.verdict != Decision::hit) return;
    note("improved", "t", of_t(better));
    rounding("improved", better);
  }

  /// The coordinates of the point, and what is said to be certain of them.
  void rounding(std::string_view step, const RootEstimate& finding) {
    const Fraction t = fraction(reach_.first());
    for (int axis = 0; axis < 3; ++axis) {
      const auto at =
          steps::coordinate<double>(traced_.p[axis], traced_.v[axis], {finding.hi, finding.lo}, finding.error);
      note(step, "point", t.linear(traced_.p[axis], traced_.v[axis]).ratio(exact(at.value), at.error));
    }
    const trace::RoundedPoint once = rounded(shape_, traced_, finding);
    if (once.certain) rounded_right(step, once.t, once.punto);
  }

  void rounded_right(std::string_view step, double t, const glm::dvec3& punto) {
    const scene::Hit hit = surface::exact::rounded_hit(rayo_, reach_.first(), {});
    note(step, "rounded", t == hit.t && punto == hit.punto ? 0 : wrong);
  }

  static constexpr model::Tipo tipo = Shape::tipo;
  const Shape& shape_;
  model::Rayo rayo_;
  Ray traced_;
  bool on_;
  Exact exact_;  ///< of the ray as if it did not start on the element
  surface::exact::Reach reach_;
  Ratios ratios_;
};

inline Ratios measured(const Specimen& specimen) {
  return std::visit([&](const auto& shape) { return Measurement(shape, specimen).ratios(); }, specimen.element);
}

}  // namespace durero::test
