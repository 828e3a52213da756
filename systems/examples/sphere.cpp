// A system that knows spheres: it reads the rays of `durero conform run` and writes its hits.
#include <cmath>
#include <iostream>
#include <map>
#include <valarray>

int main() {
  std::map<std::string, std::valarray<double>> spheres;  // centre and radius
  std::cout.precision(17);
  std::cout << "system example-c++ 1" << std::endl;
  for (std::string word, name; std::cin >> word >> name;) {
    if (word == "scene") spheres.clear();
    if (word == "esfera")
      for (double& number : spheres[name] = std::valarray<double>(4)) std::cin >> number;
    for (int rays = word == "rays" ? std::stoi(name) : 0; rays > 0; --rays) {
      std::valarray<double> p(3), v(3);
      for (auto* numbers : {&p, &v})
        for (double& number : *numbers) std::cin >> number;
      std::pair<double, std::string> nearest = {INFINITY, ""};
      for (const auto& [element, s] : spheres) {
        const std::valarray<double> q = p - s[std::slice(0, 3, 1)];
        const double A = (v * v).sum(), B = (q * v).sum(), D = B * B - A * ((q * q).sum() - s[3] * s[3]);
        for (const double t : {(-B - std::sqrt(D)) / A, (-B + std::sqrt(D)) / A})  // nan where there is no root
          if (t > 0 && t < nearest.first) nearest = {t, element};
      }
      if (nearest.second.empty())
        std::cout << "miss" << std::endl;
      else
        std::cout << "hit " << nearest.second << ' ' << nearest.first << std::endl;
    }
  }
}
