// A system that knows spheres: it reads the rays of `durero conform run` and writes its hits.
#include <cmath>
#include <iostream>
#include <map>

int main() {
  std::map<std::string, double[4]> spheres;  // centre and radius
  std::cout << "system example-c++ 1" << std::endl;
  for (std::string word, name; std::cin >> word >> name; std::fflush(stdout)) {
    if (word == "scene") spheres.clear();
    for (int i = 0; i < 4 && word == "esfera"; ++i) std::cin >> spheres[name][i];
    for (int rays = word == "rays" ? std::stoi(name) : 0; rays > 0; --rays) {
      double x[6], nearest = INFINITY;
      for (double& number : x) std::cin >> number;
      std::string first;
      for (const auto& [element, s] : spheres) {
        double A = 0, B = 0, C = -s[3] * s[3];
        for (int i = 0; i < 3; ++i)
          A += x[3 + i] * x[3 + i], B += (x[i] - s[i]) * x[3 + i], C += (x[i] - s[i]) * (x[i] - s[i]);
        for (double root : {-std::sqrt(B * B - A * C), std::sqrt(B * B - A * C)})  // or NaN
          if (double t = (root - B) / A; t > 0 && t < nearest) nearest = t, first = element;
      }
      first.empty() ? std::puts("miss") : std::printf("hit %s %.17g\n", first.c_str(), nearest);
    }
  }
}
