// batch SCENE RAYS.npy: for each line of the standard input answers all rays by one call of engine::first_hits, and
// prints the seconds that it took.
#include <chrono>
#include <iostream>
#include <string>

#include "durero/engine/engine.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/rays/rays_file.hpp"

using namespace durero;

int main(int, char** arguments) {
  const scene::Scene scene = io::read_scene(io::read_source(arguments[1]));
  const std::vector<scene::Query> rays = io::read_rays(io::read_source(arguments[2]), scene);
  const auto engine = engine::find(engine::default_engine)->prepare(scene);
  for (std::string line; std::getline(std::cin, line);) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<scene::Hit> hits = engine::first_hits(*engine, rays);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    std::cout << taken.count() << ' ' << hits.size() << std::endl;
  }
}
