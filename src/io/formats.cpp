#include "durero/io/formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <system_error>

#include "durero/io/file_name.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/mesh/gathered.hpp"
#include "durero/io/mesh/gltf.hpp"
#include "durero/io/mesh/obj.hpp"
#include "durero/io/mesh/ply.hpp"
#include "durero/io/mesh/stl.hpp"
#include "durero/io/mitsuba/mitsuba.hpp"
#include "durero/io/nff/nff.hpp"
#include "durero/io/pbrt/pbrt.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/io/radiance/radiance.hpp"
#include "durero/text/shown.hpp"
#include "scene_folder.hpp"

namespace durero::io {
namespace {

Imported import_json(const Source& source) {
  scene::GroupedScene read = read_grouped_scene(source, Bodies::read);
  return {std::move(read.scene), {}, std::move(read.groups)};
}
Exported write_json(const scene::Scene& scene, const scene::Groups& groups) { return {scene_text(scene, groups), {}}; }

constexpr Format all[] = {
    {.ending = ".glb", .read = read_gltf, .write = gltf_bytes, .is_mesh = true, .write_bytes = gltf_bytes},
    {.ending = ".gltf", .read = read_gltf, .write = gltf_text, .is_mesh = true},
    {.ending = ".json", .read = import_json, .write = write_json},
    {.ending = ".nff", .read = read_nff, .write = nff_text, .has_lines = true},
    {.ending = ".obj", .read = read_obj, .write = obj_text, .has_lines = true, .is_mesh = true},
    {.ending = ".pbrt", .read = read_pbrt, .write = pbrt_text, .is_mesh = true},
    {.ending = ".ply", .read = read_ply, .write = ply_text, .is_mesh = true, .write_bytes = ply_bytes},
    {.ending = ".pov", .read = read_pov, .write = pov_text},
    {.ending = ".rad", .read = read_radiance, .write = radiance_text},
    {.ending = ".stl", .read = read_stl, .write = stl_text, .is_mesh = true, .write_bytes = stl_bytes},
    {.ending = ".xml", .read = read_mitsuba, .is_mesh = true, .write_with_files = mitsuba_text}};

bool is_read(const Format& format) { return format.read != nullptr; }
bool is_written(const Format& format) { return format.write != nullptr || format.write_with_files != nullptr; }
bool has_bytes(const Format& format) { return format.write_bytes != nullptr; }

std::string endings(bool (*is_meant)(const Format&)) {
  std::vector<std::string_view> endings;
  for (const Format& format : all)
    if (is_meant(format)) endings.push_back(format.ending);
  return fmt::format("{}", fmt::join(endings, " or "));
}

const Format& format_of(const std::string& path, bool (*is_meant)(const Format&),
                        const char* none = "a format that is not known by this name") {
  for (const Format& format : all)
    if (is_meant(format) && ends_in(path, format.ending)) return format;
  throw FileError(path, none, fmt::format("expected one that ends in {}", endings(is_meant)));
}

}  // namespace

std::span<const Format> formats() { return all; }

const Format& format_to_read(const std::string& path) { return format_of(path, is_read); }
const Format& format_to_write(const std::string& path) { return format_of(path, is_written); }
const Format& format_to_write_bytes(const std::string& path) {
  return format_of(path, has_bytes, "no format with a binary form by this name");
}

Exported exported_scene(const std::string& path, const scene::Scene& scene, const scene::Groups& groups,
                        bool as_bytes) {
  if (as_bytes) return format_to_write_bytes(path).write_bytes(scene, groups);
  const Format& format = format_to_write(path);
  if (format.write_with_files == nullptr) return format.write(scene, groups);
  return format.write_with_files(scene, groups, std::filesystem::path(path).stem().string());
}

Imported read_any_format(const std::string& path, const Reading& how) {
  const std::string& root = how.root;
  const Format& format = format_to_read(path);
  std::error_code error;
  if (!root.empty() && !std::filesystem::is_directory(root, error)) throw FileError(root, "no folder", "expected one");
  Source source = format.has_lines ? read_lines(path) : read_source(path);
  source.set_root(root);
  source.set_keeps_surfaces(how.keeps_surfaces);
  if (!SceneFolder(source).holds_scene())
    throw FileError(path, "lies elsewhere", fmt::format("expected a file in {} or beneath it", text::shown(root)));
  return format.read(source);
}

Imported import_file(const std::string& path, const Reading& how, std::optional<bool> in_meshes) {
  const bool are_gathered = in_meshes.value_or(format_to_read(path).is_mesh);
  Imported read = read_any_format(path, how);
  return are_gathered ? gathered(std::move(read), path) : std::move(read);
}

std::string endings_to_read() { return endings(is_read); }
std::string endings_to_write() { return endings(is_written); }

}  // namespace durero::io
