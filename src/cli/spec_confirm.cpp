// durero spec confirm SCENE RAYS HITS: the Z text decides whether hits, of any program, are the answers to the rays.
#include <fmt/format.h>

#include <optional>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/spec/confirmation.hpp"
#include "progress.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

/// The line of one ray. Without an objection the hit is confirmed.
std::string line(std::size_t ray, const std::optional<std::string>& objection) {
  std::string line;
  io::json::Writer out(line);
  out.begin_object().member("ray", ray).member("confirmed", !objection);
  if (objection) out.member("predicate", *objection);
  out.end_object();
  return line + "\n";
}

}  // namespace

int spec_confirm(const std::string& scene_path, const std::string& rays_path, const std::string& hits_path,
                 bool quiet) {
  const scene::Scene scene = io::read_scene(io::read_source(scene_path));
  const std::vector<io::Ray> rays = io::read_rays(io::read_lines(rays_path), scene);
  const auto hits = io::read_hits_of_rays(io::read_lines(hits_path), scene, rays.size());
  const spec::Confirmation confirmation(scene);
  std::size_t confirmed = 0, missing = 0;
  std::string lines;
  std::optional<Progress> progress(std::in_place, quiet, "spec confirm", "rays", rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto objection = hits[i] ? confirmation.objection(rays[i], *hits[i])
                                   : std::optional<std::string>("the ray has no hit in the file");
    confirmed += objection ? 0 : 1;
    missing += hits[i] ? 0 : 1;
    lines += line(i, objection);
    progress->add();
  }
  lines += fmt::format("{{\"rays\":{},\"confirmed\":{},\"refused\":{},\"missing\":{}}}\n", rays.size(), confirmed,
                       rays.size() - confirmed - missing, missing);
  progress.reset();
  io::print(lines);
  return confirmed == rays.size() ? 0 : 1;
}

}  // namespace durero::cli
