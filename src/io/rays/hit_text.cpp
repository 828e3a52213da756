// The lines of hits, apart from their files: who prints none has no need of these.
#include <algorithm>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "io/rays/hit_line.hpp"

namespace durero::io {

std::vector<std::string> names_of_hit(const scene::Hit& hit, const scene::Scene& scene) {
  std::vector<std::string> all;
  for (const scene::ElementRef element : hit.elementos) all.push_back(scene.name(element).name());
  std::ranges::sort(all);
  return all;
}

void write_hit(json::Writer& out, const scene::Hit& hit, const scene::Scene& scene) {
  out.member("outcome", model::name(hit.resultado)).key("elementos").begin_array();
  for (const std::string& name : names_of_hit(hit, scene)) out.value(name);
  out.end_array();
  if (hit.resultado == model::Resultado::hit) out.member("t", hit.t).member("point", hit.punto);
}

void append_text(std::string& text, std::size_t ray, const scene::Hit& hit, const scene::Scene& scene) {
  json::Writer out(text);
  write_hit(out.begin_object().member("ray", ray), hit, scene);
  out.end_object();
}

std::string hit_text(std::size_t ray, const scene::Hit& hit, const scene::Scene& scene) {
  std::string text;
  append_text(text, ray, hit, scene);
  return text;
}

}  // namespace durero::io
