// What the C++ programs beside this file share: questions are read, answers written, unit vectors and frames made. The
// protocol is described in include/durero/conform/ask/question.hpp.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ask {

using Vec = std::array<double, 3>;

inline Vec operator+(Vec a, Vec b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(Vec a, Vec b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(double s, Vec a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(Vec a, Vec b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec cross(Vec a, Vec b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Computed in binary64; whoever needs binary32 rounds it after. The largest component is made 1 first, so that no
// square is too large or too small.
inline Vec unit(Vec v) {
  const double largest = std::fmax(std::fabs(v[0]), std::fmax(std::fabs(v[1]), std::fabs(v[2])));
  const Vec scaled = {v[0] / largest, v[1] / largest, v[2] / largest};
  const double length = std::sqrt(dot(scaled, scaled));
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

// Two unit vectors that stand at right angles to the unit vector d and to each other: a × b = d.
inline std::array<Vec, 2> beside(Vec d) {
  const int least = std::fabs(d[0]) <= std::fabs(d[1]) && std::fabs(d[0]) <= std::fabs(d[2]) ? 0
                    : std::fabs(d[1]) <= std::fabs(d[2])                                     ? 1
                                                                                             : 2;
  Vec axis = {0, 0, 0};
  axis[least] = 1;
  const Vec a = unit(cross(axis, d));
  return {a, cross(d, a)};
}

struct Element {
  std::string tipo, name;
  std::vector<double> numbers;

  bool is(const char* word) const { return tipo == word; }
  // Of a box, a capsule, an ellipsoid, or a copy by a map: its sides and their lengths.
  bool is_body() const { return is("caja") || is("capsula") || is("elipsoide") || tipo.rfind("copia_", 0) == 0; }
  Vec side(int i) const { return vec(3 + 3 * i); }
  double half(int i) const { return std::hypot(side(i)[0], side(i)[1], side(i)[2]); }
  Vec vec(int first) const { return {numbers[first], numbers[first + 1], numbers[first + 2]}; }
  Vec centro() const { return vec(0); }
  Vec vector() const { return vec(3); }
  // Of a cylinder, cone or truncated cone: at its centro, and at the other end.
  double base_radius() const {
    if (is("cono")) return numbers[6] * numbers[7];
    return is("tronco") ? numbers[6] + numbers[7] * numbers[8] : numbers[6];
  }
  double top_radius() const { return is("cono") ? 0 : numbers[6]; }
  double altura() const { return numbers.back(); }
  Vec top() const { return centro() + altura() * vector(); }
};

struct Ray {
  Vec p, v;
  double begin = 0, end = std::numeric_limits<double>::infinity();  // what is asked about: begin ≤ t ≤ end
  bool is_shadow = false;                                           // whether anything is hit there
  bool is_about_all = false;                                        // all hits are asked for, or
  bool is_count = false;                                            // their number
  bool is_point = false;                                            // the nearest point to p is asked for
  bool is_cast = false;                                             // a ball is cast, of this
  double radius = 0;
};

struct Scene {
  std::string name;
  std::vector<Element> elements;
  std::vector<Ray> rays;
};

// The points of all triangles, each once, and of each triangle the numbers of its three points.
struct Mesh {
  std::vector<Vec> points;
  std::vector<std::array<unsigned, 3>> faces;
};
inline Mesh mesh_of(const Scene& scene) {
  Mesh mesh;
  std::map<Vec, unsigned> numbers;
  for (const Element& e : scene.elements) {
    std::array<unsigned, 3> face{};
    for (int i = 0; i < 3; ++i) {
      const auto [place, is_new] = numbers.try_emplace(e.vec(3 * i), unsigned(mesh.points.size()));
      if (is_new) mesh.points.push_back(e.vec(3 * i));
      face[i] = place->second;
    }
    mesh.faces.push_back(face);
  }
  return mesh;
}

// For systems that ask of segments: a power of two f so that no point is beyond p + f v, with
// the radius of a ball.
inline double segment(const Mesh& mesh, const Ray& ray) {
  double farthest = 0;
  for (const Vec& point : mesh.points) {
    const Vec away = point - ray.p;
    farthest = std::fmax(farthest, std::hypot(away[0], away[1], away[2]));
  }
  return std::exp2(std::ceil(std::log2(2 * (farthest + ray.radius) / std::hypot(ray.v[0], ray.v[1], ray.v[2]))));
}

inline double read_number(std::istream& in) {
  std::string word;
  in >> word;
  return std::strtod(word.c_str(), nullptr);  // which also reads what rounds to 0
}

// False at the end of the questions.
inline bool read(Scene& scene) {
  scene = {};
  std::string line, word;
  bool has_begins = false;
  const auto is_head = [&] {
    return word == "rays" || word == "shadows" || word == "ranges" || word == "crossings" || word == "counts" ||
           word == "points" || word == "casts";
  };
  if (!std::getline(std::cin, line)) return false;
  std::istringstream(line) >> word >> scene.name;
  while (std::getline(std::cin, line)) {
    std::istringstream in(line);
    in >> word;
    if (is_head()) {
      std::size_t count;
      in >> count;
      scene.rays.resize(count);
      for (Ray& ray : scene.rays) {
        ray.is_shadow = word == "shadows";
        ray.is_count = word == "counts";
        ray.is_about_all = ray.is_count || word == "crossings";
        ray.is_point = word == "points";
        ray.is_cast = word == "casts";
      }
      has_begins = word == "ranges";
      break;
    }
    Element element{word, "", {}};
    in >> element.name;
    while (in >> word) element.numbers.push_back(std::strtod(word.c_str(), nullptr));
    scene.elements.push_back(element);
  }
  for (Ray& ray : scene.rays) {
    std::getline(std::cin, line);
    std::istringstream in(line);
    for (double& x : ray.p) x = read_number(in);
    if (ray.is_point) continue;
    for (double& x : ray.v) x = read_number(in);
    if (has_begins) ray.begin = read_number(in);
    if (has_begins || ray.is_shadow) ray.end = read_number(in);
    if (ray.is_cast) ray.radius = read_number(in);
  }
  return true;
}

inline void miss() { std::puts("miss"); }
inline void hit(const std::string& element, double t) { std::printf("hit %s %.17g\n", element.c_str(), t); }
// A hit of which the point alone is known.
inline void hit_at(const std::string& element, Vec point) {
  std::printf("hit %s - %.17g %.17g %.17g\n", element.c_str(), point[0], point[1], point[2]);
}
// A hit with the place of contact.
inline void touch(const std::string& element, double t, Vec point) {
  std::printf("hit %s %.17g %.17g %.17g %.17g\n", element.c_str(), t, point[0], point[1], point[2]);
}
// A hit with its normal, and perhaps u and v of a triangle.
inline void hit(const std::string& element, double t, Vec normal, const double* uv = nullptr) {
  std::printf("hit %s %.17g normal %.17g %.17g %.17g", element.c_str(), t, normal[0], normal[1], normal[2]);
  if (uv) std::printf(" uv %.17g %.17g", uv[0], uv[1]);
  std::puts("");
}
// A hit of all.
struct Listed {
  double t;
  std::string element;
};
// The answer to a ray about all hits: those at t > 0, in order, or their number.
inline void all_hits(const Ray& ray, std::vector<Listed> all) {
  all.erase(std::remove_if(all.begin(), all.end(), [](const Listed& one) { return !(one.t > 0); }), all.end());
  if (ray.is_count) return void(std::printf("count %zu\n", all.size()));
  if (all.empty()) return miss();
  std::stable_sort(all.begin(), all.end(), [](const Listed& a, const Listed& b) { return a.t < b.t; });
  for (std::size_t i = 0; i < all.size(); ++i)
    std::printf("%shit %s %.17g", i == 0 ? "" : " ; ", all[i].element.c_str(), all[i].t);
  std::puts("");
}
// The answer to a shadow ray.
inline void shadow(bool is_hit) { std::puts(is_hit ? "hit" : "miss"); }
inline void refused(const char* why) { std::printf("refused %s\n", why); }

// Says what the system is, then answers each scene: begin(scene) makes it, and what that returns is asked ray by ray.
template <class Begin>
int answer(const std::string& system, Begin begin) {
  std::printf("system %s\n", system.c_str());
  std::fflush(stdout);
  for (Scene scene; read(scene);) {
    auto&& of_scene = begin(scene);
    for (const Ray& ray : scene.rays) {
      of_scene.ask(ray);
      std::fflush(stdout);
    }
  }
  return 0;
}

}  // namespace ask
