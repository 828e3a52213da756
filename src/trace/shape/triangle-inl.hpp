/// A triangle in closed form: its quadratic along a ray, whose A is 0; the side of each edge on which the line crosses
/// the plane; and its potencia in some hundred bits. With e1 = b − a, e2 = c − a and q = p − a,
///   A = 0    B = −det/2    C = e2·(q × e1)    det = e1·(v × e2)
/// where q·(v × e2), v·(q × e1) and the rest of det have the signs, times that of det, of the lados of ca, ab and bc
/// where the line crosses the plane (Möller and Trumbore, 1997). margin is the least of them.
///
/// Bounds, to first order in ε, with L1 ≥ |e1| and L2 ≥ |e2|. Each edge errs by ε of itself, and so does q. A component
/// of v × e2 errs by 3ε of the sum of the sizes of its products, of q × e1 by 4ε; the sizes of the products of a whole
/// triple product add up to less than the product of three extents. A triple product adds three roundings, which gives
///   det       (3 + 1 + 3)ε·V·L1·L2         C         (4 + 1 + 3)ε·|q|·L1·L2
///   q·(v × e2)  (3 + 1 + 3)ε·V·|q|·L2      v·(q × e1)  (4 + 3)ε·V·|q|·L1
///   the rest  the sum of the three, and 2ε of it: 9εV(L1·L2 + |q|(L1 + L2))
/// where V, |q|, L1 and L2 are extents, the sums of the components' sizes. Twice as much pays for the rest.
///
/// The potencia's bound, with W the extent of q: the differences of the vertices are exact as sums of two. A product of
/// such sums has a lower part of at most 3u of itself that errs by 13u². The lower part of the normal's component is
/// then at most 7u, and errs by 40u², of the sizes of its products; of the product with q, whose lower part is 3u·W and
/// errs by 8u²·W, it is 11u and errs by 113u². Their sum errs by less than 450u²·W·L1·L2, of the 2048u² that
/// power_error allows.

#if defined(DURERO_TRACE_SHAPE_TRIANGLE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPE_TRIANGLE_INL_HPP_
#undef DURERO_TRACE_SHAPE_TRIANGLE_INL_HPP_
#else
#define DURERO_TRACE_SHAPE_TRIANGLE_INL_HPP_
#endif

#include "trace/power-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class R>
HWY_INLINE R least(R a, R b) {
  return choose(a < b, a, b);
}

template <class T, class Triangle, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic_of(Of<model::Tipo::soy_triangulo>, const Triangle& triangle, const Ray& ray) {
  const auto& [a, b, c] = triangle.vertices;
  const Vec<T> e1 = difference<T>(b, a), e2 = difference<T>(c, a), q = difference<T>(ray.p, a), v = vec<T>(ray.v);
  const Vec<T> v_e2 = cross(v, e2), q_e1 = cross(q, e1);
  const T det = dot(e1, v_e2), ca = dot(q, v_e2), ab = dot(v, q_e1), bc = det - ca - ab;
  const Bound<T> L1 = extent(e1), L2 = extent(e2), Q = extent(q), V = ray.speed;
  const Bound<T> unit = Numbers<T>::roundoff;
  const Truth<T> turned = leading(det) < 0;
  const auto of = [&](const T& lado) HWY_ATTR { return choose(turned, -leading(lado), leading(lado)); };
  BoundedQuadratic<T> f;
  f.B = det * T(-0.5);
  f.C = dot(e2, q_e1);
  f.B_error = 8 * unit * V * L1 * L2;
  f.C_error = 16 * unit * Q * L1 * L2;
  f.edged = true;
  f.margin = least(least(of(ab), of(bc)), of(ca));
  f.margin_error = 18 * unit * V * (L1 * L2 + Q * (L1 + L2));
  return f;
}

template <class R, class Point>
HWY_INLINE std::array<Pair<R>, 3> edge(const Point& from, const Point& to) {
  return {two_sum<R>(to.x, -from.x), two_sum<R>(to.y, -from.y), two_sum<R>(to.z, -from.z)};
}
template <class R>
HWY_INLINE R extent(const std::array<Pair<R>, 3>& a) {
  using std::abs;
  return abs(a[0].hi) + abs(a[1].hi) + abs(a[2].hi);
}

template <class R, class Triangle>
HWY_INLINE Power<R> power_of(Of<model::Tipo::soy_triangulo>, const Triangle& triangle, const Place3<R>& q) {
  const auto& [a, b, c] = triangle.vertices;
  const std::array<Pair<R>, 3> e1 = edge<R>(a, b), e2 = edge<R>(a, c);
  const auto normal = [&](std::size_t i, std::size_t j)
                          HWY_ATTR { return difference(product(e1[i], e2[j]), product(e1[j], e2[i])); };
  const Pair<R> value = sum(sum(product(q.x, normal(1, 2)), product(q.y, normal(2, 0))), product(q.z, normal(0, 1)));
  return {value, power_error * q.W * extent(e1) * extent(e2)};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
