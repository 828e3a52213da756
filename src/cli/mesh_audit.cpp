#include "mesh_audit.hpp"

#include <optional>
#include <stdexcept>

#include "durero/io/file_name.hpp"
#include "durero/io/formats.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/mesh/mesh_report.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "file_error.hpp"
#include "losses.hpp"
#include "mesh_picture.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

/// The scene or mesh of a file, by its name.
io::Imported imported(const std::string& path) {
  if (path == "-" || io::ends_in(path, ".json")) return {io::read_scene(io::read_source(path)), {}};
  return io::read_any_format(path);
}

}  // namespace

// The reader itself says what it leaves out, such as triangles without area.
int audit_mesh(const AuditCall& call) {
  std::optional<io::OutputFile> picture;
  if (!call.picture.empty()) {
    io::require_ending(call.picture, io::png_endings, "a picture");
    picture.emplace(call.picture);
  }
  std::optional<Progress> progress(std::in_place, call.quiet, "check");
  const io::Imported found = imported(call.scene);
  const io::SceneMesh mesh = io::mesh_of(found.scene);
  io::MeshCheck check = io::check_mesh(call.scene, mesh, point_in(call.point));
  if (picture) picture->write(naming_file<std::domain_error>(call.scene, [&] { return mesh_picture(mesh, check); }));
  progress.reset();
  if (picture) picture->commit();
  if (call.most > 0) list_at_most(call.most, check);
  io::print(call.format == "json"    ? mesh_check_json(check)
            : call.format == "sarif" ? mesh_check_sarif(check)
                                     : mesh_check_text(check));
  name_losses(call.scene, found.lost);
  return check.findings.empty() ? 0 : 1;
}

}  // namespace durero::cli
