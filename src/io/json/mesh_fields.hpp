#pragma once
/// The meshes of a scene file: `"mallas":[{"id":NAME,"puntos":[[x,y,z],…],"caras":[[i,j,k],…],…},…]`.

#include <optional>
#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/scene/scene.hpp"
#include "element_reader.hpp"

namespace durero::io {

/// A mesh as it stands in a file, without its material.
struct FileMesh {
  scene::Mesh mesh;
  std::optional<Placed<std::string_view>> material{};
};

/// Reads a mesh. Whether it can be added is for add_mesh() to say.
FileMesh read_mesh(json::Reader& in);

/// Adds a mesh by its operation. `at` stands on it: where it is refused, the error is at the face, or at the name.
void add_mesh(const json::Reader& at, scene::Scene& scene, scene::Mesh mesh);

/// Writes it, a point and a face on each line.
void write_mesh(json::Writer& out, const scene::Mesh& mesh, const scene::Stage& stage);

/// A face: `[i,j,k]`, three whole numbers from 0.
model::Cara read_face(json::Reader& in, std::string_view what);

}  // namespace durero::io
