#pragma once
/// The shapes of a pbrt scene, where they are simple.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/placed/mesh_files.hpp"
#include "io/placed/placed_scene.hpp"
#include "pbrt_words.hpp"

namespace durero::io {

/// Reads shapes, and counts those that no scene has.
class PbrtShapes {
 public:
  explicit PbrtShapes(const PbrtWords& words) : words_(words) {}

  /// The shape of a type; nothing where a scene has none such. `at` is the statement.
  std::optional<SimpleSurface> read(const PbrtPlace& at, const std::string& type, const PbrtParameters& parameters);
  void name_losses(std::vector<std::string>& lost) const;

 private:
  std::optional<SimpleSurface> sphere(const PbrtParameters& parameters);
  std::optional<SimpleSurface> cylinder(const PbrtParameters& parameters);
  std::optional<SimpleSurface> cone(const PbrtParameters& parameters);
  std::optional<SimpleSurface> disk(const PbrtParameters& parameters);
  std::optional<SimpleSurface> triangles(const PbrtPlace& at, const PbrtParameters& parameters);
  std::optional<SimpleSurface> patches(const PbrtPlace& at, const PbrtParameters& parameters);
  std::optional<SimpleSurface> file(const PbrtPlace& at, const PbrtParameters& parameters);
  std::nullopt_t leave_out(const std::string& what);

  const PbrtWords& words_;
  MeshFiles files_;
  std::map<std::string, std::size_t> left_out_;
};

}  // namespace durero::io
