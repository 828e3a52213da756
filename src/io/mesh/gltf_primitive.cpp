#include "gltf_primitive.hpp"

#include <fmt/format.h>

#include "durero/io/json/whole_number.hpp"

namespace durero::io {
namespace {

void read_attributes(const GltfJson& file, json::Reader& in, GltfPrimitive& primitive) {
  in.members("attributes", [&](const json::Key& key) {
    const GltfReference accessor = file.reference(in, key.name, GltfArray::accessors);
    if (key.name == "POSITION")
      primitive.positions = accessor;
    else if (key.name == "NORMAL")
      primitive.normals = accessor;
    else if (key.name == "TEXCOORD_0")
      primitive.uv = accessor;
    else
      ++primitive.other_attributes;
  });
}

GltfMode read_mode(json::Reader& in) {
  using enum GltfMode;
  constexpr std::array modes{none, none, none, none, triangles, strip, fan};
  return modes[static_cast<std::size_t>(json::whole_number(in, "mode", 0, 6, "0 to 6"))];
}

GltfPrimitive read_primitive(const GltfJson& file, json::Reader& in) {
  GltfPrimitive primitive{.at = in.offset()};
  read_known(in, "an item of primitives", [&](std::string_view key) {
    if (key == "attributes") {
      read_attributes(file, in, primitive);
    } else if (key == "indices") {
      primitive.indices = file.reference(in, key, GltfArray::accessors);
    } else if (key == "mode") {
      primitive.mode = read_mode(in);
    } else if (key == "targets") {
      in.array(key, [&] { in.skip(), ++primitive.targets; });
    } else {
      primitive.has_material = primitive.has_material || key == "material";
      if (const auto draco = key == "extensions" ? in.member("KHR_draco_mesh_compression") : std::nullopt)
        primitive.compressed_at = draco->offset();
      return false;
    }
    return true;
  });
  return primitive;
}

}  // namespace

GltfMesh read_gltf_mesh(const GltfJson& file, std::size_t number) {
  json::Reader in = file.item(GltfArray::meshes, number);
  GltfMesh mesh;
  read_known(in, "an item of meshes", [&](std::string_view key) {
    if (key == "primitives")
      in.array(key, [&] { mesh.primitives.push_back(read_primitive(file, in)); });
    else if (key == "name")
      mesh.name = in.string(key);
    else
      return false;
    return true;
  });
  return mesh;
}

}  // namespace durero::io
