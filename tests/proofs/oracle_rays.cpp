/// Scenes and rays of every family with what answers them, as proofs/oracle/main.ml reads them.
///   oracle_rays RAYS SEED exact | trace [fault]
/// exact: surface::exact. trace: the certified tracer, each ray twice: in a batch by lanes, and alone.
/// fault: one claim in fifty is wrong, in each way in turn; all other lines are those without it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "durero/scene/addition.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/analytic.hpp"
#include "support/scenes.hpp"

using namespace durero;

namespace {

/// Where the numbers of a scene and its rays come from.
struct Family {
  const char* name;
  double (*number)(test::Random&);  ///< a coordinate
  double (*length)(test::Random&);  ///< a radius, height or slope
  bool unit_axes;                   ///< axes along x, y, z only: tangents, rims, generators and ties are frequent
};

double halves(test::Random& random) { return static_cast<double>(random.below(9)) / 2 - 2; }
double half_lengths(test::Random& random) { return static_cast<double>(random.below(4) + 1) / 2; }
double ordinary(test::Random& random) { return random.uniform(-3, 3); }
double ordinary_length(test::Random& random) { return random.uniform(0.1, 2); }

/// Every exponent from −1074 to 1023, as the rest of the bits are random.
double any_positive(test::Random& random) {
  const int exponent = static_cast<int>(random.below(2098)) - 1074;
  const double x = std::ldexp(random.uniform(1, 2), exponent);
  return std::isfinite(x) && x > 0 ? x : std::numeric_limits<double>::denorm_min();
}
double any(test::Random& random) { return random.below(2) == 0 ? any_positive(random) : -any_positive(random); }

/// Near numbers of very different sizes: what cancels.
double mixed(test::Random& random) {
  const double near = halves(random);
  const int places = static_cast<int>(random.below(60));
  return near + std::ldexp(ordinary(random), -places);
}
double mixed_length(test::Random& random) {
  const double near = half_lengths(random);
  return near + std::ldexp(1, -static_cast<int>(random.below(52)));
}

constexpr Family families[] = {
    {"ordinary", ordinary, ordinary_length, false}, {"coincident", halves, half_lengths, true},
    {"near coincident", mixed, mixed_length, true}, {"tilted", halves, half_lengths, false},
    {"whole range", any, any_positive, false},
};

glm::dvec3 vec(const Family& family, test::Random& random) {
  const double x = family.number(random), y = family.number(random), z = family.number(random);
  return {x, y, z};
}

model::Vector axis(const Family& family, test::Random& random) {
  if (!family.unit_axes) return random.axis();
  glm::dvec3 d(0);
  d[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
  return model::Vector(d);
}

/// A random element; one in five is the same as one that is there, under another name: ties.
model::Operation addition(const Family& family, test::Random& random, const scene::Scene& scene) {
  const model::Elemento e("e" + std::to_string(scene.size()));
  if (random.below(5) == 0 && !scene.shapes<scene::Sphere>().empty()) {
    return model::Agregar_Esfera{e, model::Punto(scene.shapes<scene::Sphere>()[0].centro),
                                 scene.shapes<scene::Sphere>()[0].radio};
  }
  if (random.below(5) == 0 && !scene.shapes<scene::Cone>().empty()) {
    const scene::Cone& c = scene.shapes<scene::Cone>()[0];
    return model::Agregar_Cono{e, model::Punto(c.centro), c.proporcion, model::Vector(c.vector), c.altura};
  }
  const model::Punto centro(vec(family, random));
  const double size = family.length(random), altura = family.length(random);
  switch (random.below(7)) {
    case 5:
      return model::Agregar_Disco{e, centro, size, axis(family, random)};
    case 6: {
      // One in two shares an edge with a triangle that is there.
      const auto triangles = scene.shapes<scene::Triangle>();
      const bool shares = !triangles.empty() && random.below(2) == 0;
      const model::Punto a = shares ? model::Punto(triangles[0].vertices[1]) : centro;
      const model::Punto b(shares ? triangles[0].vertices[2] : vec(family, random)), c(vec(family, random));
      const model::Terna vertices{a, b, c};
      if (model::Vertices::contains(vertices)) return model::Agregar_Triangulo{e, vertices};
      return model::Agregar_Triangulo{e, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    }
    case 0:
      return model::Agregar_Esfera{e, centro, size};
    case 1:
      return model::Agregar_Cilindro{e, centro, size, axis(family, random), altura};
    case 2:
      return model::Agregar_Plano{e, centro, axis(family, random)};
    case 3:
      return model::Agregar_Cono{e, centro, size, axis(family, random), altura};
    default: {
      const double proporcion = family.length(random);
      return model::Agregar_Tronco{e, centro, size, proporcion, axis(family, random), altura};
    }
  }
}

void print(double x) { std::printf(" %a", x); }
void print(const glm::dvec3& v) { std::printf(" %a %a %a", v.x, v.y, v.z); }
void print(const scene::Corners& corners) {
  for (const glm::dvec3& corner : corners) print(corner);
}

/// An element is its word, its name and its attributes in their order.
void print(const scene::Scene& scene) {
  std::printf("scene\n");
  scene.for_each([&]<class Shape>(scene::ElementRef e, const Shape& shape) {
    std::printf("%.*s %s", static_cast<int>(Shape::word.size()), Shape::word.data(), scene.name(e).name().c_str());
    scene::for_each_attribute<Shape>([&](const auto& attribute) { print(shape.*attribute.field); });
    std::printf("\n");
  });
}

std::string names(const scene::Scene& scene, const scene::ElementSet& elements) {
  std::string text;
  for (const scene::ElementRef e : elements) text += (text.empty() ? "" : ",") + scene.name(e).name();
  return text;
}

void print(const scene::Scene& scene, const model::Rayo& rayo, const scene::ElementSet& en, const scene::Hit& hit) {
  std::printf("ray");
  print(rayo.p().xyz());
  print(rayo.v().xyz());
  for (const scene::ElementRef e : en) std::printf(" @%s", scene.name(e).name().c_str());
  switch (hit.resultado) {
    case model::Resultado::miss:
      std::printf(" = miss\n");
      break;
    case model::Resultado::no_minimum:
      std::printf(" = no_minimum %s\n", names(scene, hit.elementos).c_str());
      break;
    case model::Resultado::hit:
      std::printf(" = hit %s %a", names(scene, hit.elementos).c_str(), hit.t);
      print(hit.punto);
      std::printf("\n");
  }
}

/// From a point of an axis's neighbourhood: the unit axis after the one that d is nearest to.
glm::dvec3 across(const glm::dvec3& d) {
  const int longest = std::abs(d.x) > 0.6 ? 0 : std::abs(d.y) > 0.6 ? 1 : 2;
  glm::dvec3 e(0);
  e[(longest + 1) % 3] = 1;
  return e;
}

struct Line {
  glm::dvec3 from, v;
};

/// Towards the centre, from p.
Line aimed(const scene::Sphere& e, const glm::dvec3& p, double) { return {p, e.centro - p}; }

// Along a generator, or in the plane, where the element's numbers allow it exactly; from before, inside or after it.

Line aimed(const scene::Cylinder& e, const glm::dvec3&, double start) {
  return {e.centro + e.radio * across(e.vector) + start * e.vector, e.vector};
}
Line aimed(const scene::Cone& e, const glm::dvec3&, double start) {
  const glm::dvec3 v = e.vector - e.proporcion * across(e.vector);
  return {e.centro + e.proporcion * e.altura * across(e.vector) + start * v, v};
}
Line aimed(const scene::TruncatedCone& e, const glm::dvec3&, double start) {
  const glm::dvec3 v = e.vector - e.proporcion * across(e.vector);
  return {e.centro + (e.radio + e.proporcion * e.altura) * across(e.vector) + start * v, v};
}
Line aimed(const scene::Plane& e, const glm::dvec3&, double start) {
  return {e.centro + start * across(e.vector), across(e.vector)};
}
/// Beside the centre by start/4: a chord, or past the disc.
Line aimed(const scene::Disc& e, const glm::dvec3&, double start) {
  const glm::dvec3 v = across(e.vector), aside = glm::cross(e.vector, v);
  return {e.centro + start * v + start / 4 * aside, v};
}
/// Where start is more than 1 at a vertex from p, where it is less than −1 at the middle of an edge; in the plane else,
/// along an edge where it is 0.
Line aimed(const scene::Triangle& e, const glm::dvec3& p, double start) {
  const auto& [a, b, c] = e.vertices;
  if (start > 1) return {p, b - p};
  if (start < -1) return {p, 0.5 * (b + c) - p};
  return {a - (b - a) + start * (c - a), b - a};
}

model::Rayo aimed(const scene::Scene& scene, scene::ElementRef e, const glm::dvec3& p, double start) {
  auto [from, v] = scene.visit(e, [&](const auto& shape) { return aimed(shape, p, start); });
  if (!std::isfinite(v.x + v.y + v.z) || v == glm::dvec3(0)) v = {0, 0, 1};
  if (!std::isfinite(from.x + from.y + from.z)) from = p;
  return {model::Punto(from), model::Vector(v)};
}

/// A ray of the family; one in three is aimed at an element, and one in four starts on some element.
scene::Query ray_of(const Family& family, test::Random& random, const scene::Scene& scene) {
  const auto some = [&] { return *scene.find("e" + std::to_string(random.below(scene.size()))); };
  const glm::dvec3 p = vec(family, random);
  glm::dvec3 v = vec(family, random);
  if (v == glm::dvec3(0)) v = {0, 0, 1};
  const bool at_element = random.below(3) == 0;
  const auto at_some = [&] {
    const double start = family.number(random);
    return aimed(scene, some(), p, start);
  };
  scene::Query query{at_element ? at_some() : model::Rayo{model::Punto(p), model::Vector(v)}};
  if (random.below(4) == 0) query.en.push_back(some());
  return query;
}

/// The ways of being wrong. A claim that cannot be wrong in one way is so in the next that it can.
enum class Fault { parameter, x, y, z, zero, element_more, element_less, another_outcome };
constexpr int faults = 8;

/// A neighbour of x, which is rounded correctly and so has no right neighbour.
void nudge(double& x) { x = std::nextafter(x, x == 0 ? 1 : 0); }

/// Whether there was a coordinate that is 0, whose sign is now another.
bool turn_zero(glm::dvec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] == 0) return point[axis] = -point[axis], true;
  }
  return false;
}

/// Whether there was an element to add.
bool add_element(scene::Hit& hit, const scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const scene::ElementRef e = *scene.find("e" + std::to_string(i));
    if (std::find(hit.elementos.begin(), hit.elementos.end(), e) == hit.elementos.end()) {
      hit.elementos.push_back(e);
      return true;
    }
  }
  return false;
}

/// A miss becomes a hit, a hit that no_minimum is said of, and what has no minimum a miss.
void exchange_outcome(scene::Hit& hit, const scene::Scene& scene) {
  switch (hit.resultado) {
    case model::Resultado::miss:
      hit = {model::Resultado::hit, 1, glm::dvec3(1), {*scene.find("e0")}};
      return;
    case model::Resultado::hit:
      hit.resultado = hit.t < 1 ? model::Resultado::miss : model::Resultado::no_minimum;
      return;
    case model::Resultado::no_minimum:
      hit.resultado = model::Resultado::miss;
      return;
  }
}

/// Whether the claim could be made wrong in this way.
bool spoil(scene::Hit& hit, const scene::Scene& scene, Fault fault) {
  const bool point = hit.resultado == model::Resultado::hit;
  switch (fault) {
    case Fault::parameter:
      return point && (nudge(hit.t), true);
    case Fault::x:
      return point && (nudge(hit.punto.x), true);
    case Fault::y:
      return point && (nudge(hit.punto.y), true);
    case Fault::z:
      return point && (nudge(hit.punto.z), true);
    case Fault::zero:
      return point && turn_zero(hit.punto);
    case Fault::element_more:
      return !hit.elementos.empty() && add_element(hit, scene);
    case Fault::element_less:
      return hit.elementos.size() > 1 && (hit.elementos.pop_back(), true);
    case Fault::another_outcome:
      exchange_outcome(hit, scene);
      return true;
  }
  return false;
}

/// What the command line asks for, and how many claims were made.
struct Session {
  bool tracer = false, with_faults = false;
  long claims = 0;

  /// Prints the claim, right or spoilt.
  void claim(const scene::Scene& scene, const scene::Query& query, scene::Hit hit) {
    if (with_faults && claims++ % 50 == 49) {
      for (long fault = claims / 50; !spoil(hit, scene, static_cast<Fault>(fault % faults));) ++fault;
    }
    print(scene, query.rayo, query.en, hit);
  }

  void claims_of(const scene::Scene& scene, const std::vector<scene::Query>& queries) {
    if (!tracer) {
      for (const scene::Query& query : queries) {
        claim(scene, query, surface::exact::first_hit(scene, query.rayo, query.en));
      }
      return;
    }
    const std::vector<scene::Hit> hits = trace::first_hits(trace::Tables(scene), queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const scene::Query& query = queries[i];
      claim(scene, query, hits[i]);
      claim(scene, query, trace::first_hit(scene, query.rayo, query.en));
    }
  }
};

}  // namespace

int main(int argc, char** argv) {
  const auto is = [&](int i, const char* word) { return argc > i && std::strcmp(argv[i], word) == 0; };
  if (!is(3, "exact") && !is(3, "trace")) {
    std::fprintf(stderr, "oracle_rays: expected RAYS SEED exact | trace [fault]\n");
    return 2;
  }
  const long rays = std::atol(argv[1]);
  Session session{is(3, "trace"), is(4, "fault")};
  const std::size_t most = session.tracer ? 20 : 6;  // elements of a scene; 24 rays fill the lanes of a batch
  test::Random random(static_cast<std::uint64_t>(std::atol(argv[2])));
  for (long done = 0; done < rays; done += 24) {
    const Family& family = families[random.below(std::size(families))];
    scene::Scene scene;
    for (std::size_t i = 0, n = 1 + random.below(most); i < n; ++i) {
      scene.apply(addition(family, random, scene));
    }
    std::vector<scene::Query> queries;
    for (int i = 0; i < 24; ++i) queries.push_back(ray_of(family, random, scene));
    print(scene);
    session.claims_of(scene, queries);
  }
  return 0;
}
