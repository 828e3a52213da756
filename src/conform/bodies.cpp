#include "bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::conform {
namespace {

using model::Tipo;

struct Triple {
  double x, y;
};

/// The integer points of the circle of radius n.
std::vector<Triple> circle(int n) {
  std::vector<Triple> points;
  for (int x = -n; x <= n; ++x) {
    for (int y = -n; y <= n; ++y) {
      if (x * x + y * y == n * n) points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  return points;
}

/// The integer points of the sphere of radius n.
std::vector<glm::dvec3> sphere(int n) {
  std::vector<glm::dvec3> points;
  for (int x = -n; x <= n; ++x) {
    for (int y = -n; y <= n; ++y) {
      const int z = static_cast<int>(std::sqrt(std::max(0, n * n - x * x - y * y)));
      if (x * x + y * y + z * z != n * n) continue;
      points.emplace_back(x, y, z);
      points.emplace_back(x, y, -z);
    }
  }
  return points;
}

// Radii with many integer points: products of primes 4k + 1 for the circle, odd numbers for the sphere.
constexpr std::array circle_radii{5, 25, 65, 85, 130};
constexpr std::array sphere_radii{9, 15, 27, 35, 45, 63};

template <class Points, std::size_t n>
auto tables(const std::array<int, n>& radii, Points points_of) {
  std::array<decltype(points_of(1)), n> tables;
  for (std::size_t i = 0; i < n; ++i) tables[i] = points_of(radii[i]);
  return tables;
}

/// A point of the lattice at the distance `radius` from 0, one of circle_radii; times 2^j for radius·2^j.
Triple on_circle(Random& random, double radius) {
  static const auto points = tables(circle_radii, circle);
  for (std::size_t i = 0; i < circle_radii.size(); ++i) {
    const double ratio = radius / circle_radii[i];
    int exponent = 0;
    if (std::frexp(ratio, &exponent) != 0.5) continue;  // no power of two
    const Triple p = points[i][random.below(points[i].size())];
    return {p.x * ratio, p.y * ratio};
  }
  return {radius, 0};
}

glm::dvec3 on_sphere(Random& random, double radius) {
  static const auto points = tables(sphere_radii, sphere);
  for (std::size_t i = 0; i < sphere_radii.size(); ++i) {
    const double ratio = radius / sphere_radii[i];
    int exponent = 0;
    if (std::frexp(ratio, &exponent) != 0.5) continue;
    return ratio * points[i][random.below(points[i].size())];
  }
  return {radius, 0, 0};
}

glm::dvec3 across_axis(Random& random, const Body& body, double radius) {
  if (body.lattice) {
    const Triple p = on_circle(random, radius);
    return p.x * body.e1 + p.y * body.e2;
  }
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), length = std::sqrt(x * x + y * y);
    if (length > 0.1 && length <= 1) return radius * (x / length * body.e1 + y / length * body.e2);
  }
}

Touch sphere_touch(Random& random, const Body& body) {
  const glm::dvec3 radial = body.lattice ? on_sphere(random, body.size) : body.size * random.direction();
  for (;;) {
    const glm::dvec3 around = glm::cross(radial, random.lattice_vector(2));
    const glm::dvec3 along = glm::cross(radial, random.lattice_vector(2));
    if (around != glm::dvec3(0) && along != glm::dvec3(0)) return {body.centro + radial, radial, around, along};
  }
}

/// A base with d = ±x, ±y or ±z.
void set_lattice_base(Random& random, Body& body) {
  const int first = random.integer(0, 2);
  body.e1 = body.e2 = body.d = glm::dvec3(0);
  body.e1[(first + 1) % 3] = random.sign();
  body.e2[(first + 2) % 3] = random.sign();
  body.d[first] = random.sign();
}

/// A base with any d of which Unitario takes; one in four has a coordinate 0.
void set_tilted_base(Random& random, Body& body) {
  do {
    body.d = random.direction();
    if (random.chance(1, 4)) body.d[random.integer(0, 2)] = 0;
    body.d /= std::sqrt(glm::dot(body.d, body.d));
  } while (!model::Unitario::contains(model::Vector(body.d)));
  glm::dvec3 e(0);
  e[random.integer(0, 2)] = 1;
  body.e1 = glm::cross(body.d, e + 0.25 * random.direction());
  body.e1 /= std::sqrt(glm::dot(body.e1, body.e1));
  body.e2 = glm::cross(body.d, body.e1);
}

}  // namespace

model::Operation Body::operation(const model::Elemento& e) const {
  switch (tipo) {
    case Tipo::soy_esfera:
      return model::Agregar_Esfera{e, model::Punto(centro), size};
    case Tipo::soy_cilindro:
      return model::Agregar_Cilindro{e, model::Punto(centro), size, model::Vector(d), altura};
    default:
      return model::Agregar_Cono{e, model::Punto(centro), size, model::Vector(d), altura};
  }
}

Tipo any_type(Random& random) { return static_cast<Tipo>(random.integer(0, 2)); }
Tipo any_axial_type(Random& random) { return random.chance(1, 2) ? Tipo::soy_cilindro : Tipo::soy_cono; }

Body lattice_body(Random& random, Tipo tipo) {
  Body body{.tipo = tipo};
  set_lattice_base(random, body);
  for (int i = 0; i < 3; ++i) body.centro[i] = random.integer(-300, 300);
  if (tipo == Tipo::soy_esfera) {
    body.size = sphere_radii[random.below(sphere_radii.size())];
    return body;
  }
  const double radius = circle_radii[random.below(circle_radii.size())];
  if (tipo == Tipo::soy_cilindro) {
    body.size = radius;
    body.altura = 8 * random.integer(1, 40);
  } else {
    body.size = std::ldexp(1, random.integer(-2, 2));  // the base has the radius size·altura
    body.altura = radius / body.size;
  }
  return body;
}

Body tilted_body(Random& random, Tipo tipo) {
  Body body{.tipo = tipo, .lattice = false};
  set_tilted_base(random, body);
  body.centro = random.in_cube(300);
  body.size = tipo == Tipo::soy_cono ? random.uniform(0.2, 4) : random.uniform(5, 100);
  if (tipo != Tipo::soy_cono)
    body.altura = random.uniform(10, 300);
  else if (random.chance(1, 2))
    body.altura = std::ldexp(1, random.integer(2, 6));  // size·altura is then exact
  else
    body.altura = random.uniform(5, 100) / body.size;
  return body;
}

Body any_body(Random& random, Tipo tipo) {
  return random.chance(2, 3) ? lattice_body(random, tipo) : tilted_body(random, tipo);
}

Body scaled(Body body, int k) {
  const auto scale = [&](glm::dvec3& v) { v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)}; };
  scale(body.centro);
  if (body.tipo != Tipo::soy_cono) body.size = std::ldexp(body.size, k);
  body.altura = std::ldexp(body.altura, k);
  body.marks.clear();
  return body;
}

Shot scaled(Shot shot, int k) {
  for (int i = 0; i < 3; ++i) {
    shot.p[i] = std::ldexp(shot.p[i], k);
    shot.v[i] = std::ldexp(shot.v[i], k);
  }
  return shot;
}

Touch touch_at(Random& random, const Body& body, double part) {
  const glm::dvec3 base = across_axis(random, body, body.radius());
  const glm::dvec3 around = glm::cross(body.d, base);
  if (body.tipo == Tipo::soy_cilindro) return {body.centro + base + part * body.altura * body.d, base, around, body.d};
  const glm::dvec3 along = body.altura * body.d - base;
  return {body.centro + base + part * along, (1 - part) * base, around, along};
}

Touch touch(Random& random, const Body& body) {
  return body.tipo == Tipo::soy_esfera ? sphere_touch(random, body)
                                       : touch_at(random, body, random.integer(1, 7) / 8.0);
}

Touch rim_touch(Random& random, const Body& body) {
  if (body.tipo == Tipo::soy_esfera) return sphere_touch(random, body);
  return touch_at(random, body, body.tipo == Tipo::soy_cilindro ? random.integer(0, 1) : 0);
}

glm::dvec3 any_vector(Random& random, const Body& body) {
  return body.lattice ? random.lattice_vector(8) : 8.0 * random.direction();
}

glm::dvec3 tangent_vector(Random& random, const Body& body, const Touch& touch) {
  for (;;) {
    const double around = random.signed_power(0, 2), along = random.integer(-3, 3);
    const glm::dvec3 u = around * touch.around + along * touch.along;
    if (body.tipo != Tipo::soy_esfera || u != glm::dvec3(0)) return u;
  }
}

glm::dvec3 perpendicular_vector(Random& random, const Body& body) {
  if (body.lattice || body.tipo == Tipo::soy_esfera) {
    for (;;) {
      const double x = random.integer(-8, 8), y = random.integer(-8, 8);
      const glm::dvec3 w = x * body.e1 + y * body.e2;
      if (w != glm::dvec3(0)) return w;
    }
  }
  // (−d.y, d.x, 0) and its like: the two products of its product with d are opposite, whatever d.
  for (;;) {
    const int i = random.integer(0, 2), j = (i + 1) % 3;
    glm::dvec3 w(0);
    w[i] = -body.d[j];
    w[j] = body.d[i];
    if (w != glm::dvec3(0)) return random.sign() * w;
  }
}

glm::dvec3 inwards(const glm::dvec3& v, const Touch& touch) {
  return glm::dot(v, glm::cross(touch.around, touch.along)) *
                     glm::dot(touch.radial, glm::cross(touch.around, touch.along)) >
                 0
             ? -v
             : v;
}

Shot arriving(Random& random, const glm::dvec3& point, const glm::dvec3& w, double m) {
  return {point - m * w, std::ldexp(1, random.integer(-3, 3)) * w};
}

double steps(const glm::dvec3& w, double size, int e) {
  const double length = std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)});
  return std::ldexp(1, e + std::ilogb(size) - std::ilogb(length));
}

Shot nudged(Random& random, Shot shot) {
  double& x = (random.chance(2, 3) ? shot.p : shot.v)[random.integer(0, 2)];
  if (x == 0 && random.chance(1, 2)) return shot;
  x = std::nextafter(x, random.sign() * HUGE_VAL);
  return shot;
}

Shot coincident(Random& random, const Body& body, int e) {
  const Touch rim = rim_touch(random, body);
  const auto at = [&](const glm::dvec3& point, const glm::dvec3& w) {
    return arriving(random, point, w, steps(w, body.radius(), e));
  };
  switch (random.integer(0, 4)) {
    case 0: {
      const Touch anywhere = touch(random, body);
      return at(anywhere.point, tangent_vector(random, body, anywhere));
    }
    case 1:
      return at(rim.point, inwards(any_vector(random, body), rim));
    case 2:
      return at(rim.point, inwards(perpendicular_vector(random, body), rim));
    case 3:
      if (body.tipo != Tipo::soy_cono) return at(rim.point, -rim.radial);
      return at(body.apex(), any_vector(random, body));
    default:
      return at(touch(random, body).point, rim.along);
  }
}

Shot ordinary(Random& random, const Body& body, int e) {
  if (random.chance(1, 3)) return coincident(random, body, e);
  const Touch anywhere = touch(random, body);
  glm::dvec3 w = any_vector(random, body);
  if (random.chance(7, 8)) w = inwards(w, anywhere);
  return arriving(random, anywhere.point, w, steps(w, body.radius(), e));
}

}  // namespace durero::conform
