#include "durero/model/tipo/triangulo.hpp"

#include "model/sampling.hpp"

namespace durero::model {

Surd potencia_triangulo(const ExactPoint& w, const Terna& v) {
  const ExactPoint a = v.a, b = v.b, c = v.c;
  return (w.x - a.x) * ((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y)) +
         (w.y - a.y) * ((b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z)) +
         (w.z - a.z) * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

Surd escalar(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, const ExactPoint& s) {
  return (q.x - p.x) * (s.x - r.x) + (q.y - p.y) * (s.y - r.y) + (q.z - p.z) * (s.z - r.z);
}

Surd lado(const ExactPoint& w, const Punto& a, const Punto& b, const Punto& c) {
  return escalar(a, b, a, b) * escalar(a, w, a, c) - escalar(a, b, a, c) * escalar(a, w, a, b);
}

Puntos prisma(const Terna& v) {
  return Puntos([=](const ExactPoint& w) {
    return 0 <= lado(w, v.a, v.b, v.c) && 0 <= lado(w, v.b, v.c, v.a) && 0 <= lado(w, v.c, v.a, v.b);
  });
}

Puntos puntos_triangulo(const Terna& v) {
  const auto member = [=, inside = prisma(v)](const ExactPoint& w) {
    return inside.contains(w) && potencia_triangulo(w, v) == 0;
  };
  // a + β(b − a) + γ(c − a) with β, γ ≥ 0 and β + γ ≤ 1.
  return Puntos(member, [=](Random& random) -> std::optional<ExactPoint> {
    const Rational beta = any_share(random), gamma = any_share(random) * (1 - beta);
    const auto share = [&](double a, double b, double c) {
      const Rational from = number::exact(a);
      return Surd(Rational(from + beta * (number::exact(b) - from) + gamma * (number::exact(c) - from)));
    };
    return ExactPoint{share(v.a.x(), v.b.x(), v.c.x()), share(v.a.y(), v.b.y(), v.c.y()),
                      share(v.a.z(), v.b.z(), v.c.z())};
  });
}

Potencia Triangulo::potencia(const Escena& s, const Elemento& e) {
  return [v = s.mi_vertices.at(e).terna()](const ExactPoint& w) { return potencia_triangulo(w, v); };
}

Puntos Triangulo::puntos(const Escena& s, const Elemento& e) { return puntos_triangulo(s.mi_vertices.at(e).terna()); }

}  // namespace durero::model
