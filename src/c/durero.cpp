#include "durero/c/durero.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "c/handles.hpp"
#include "durero/composed/engine.hpp"
#include "durero/engine/prepared.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/model/historia.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/stage.hpp"

using namespace durero;
using c::from_root;
using c::guarded;
using c::last_error;

namespace {

scene::Query query(const durero_ray& ray, std::size_t number) {
  const glm::dvec3 p{ray.p[0], ray.p[1], ray.p[2]}, v{ray.v[0], ray.v[1], ray.v[2]};
  const auto is_finite = [](const glm::dvec3& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
  };
  if (!is_finite(p) || !is_finite(v) || v == glm::dvec3(0))
    throw std::invalid_argument("ray " + std::to_string(number) +
                                ": no ray; expected finite numbers and v other than 0");
  return {{model::Punto(p), model::Vector(v)}, {}};
}

durero_engine* ready(const durero_scene& scene, std::string_view name, std::string_view hierarchy) {
  const engine::EngineRow* row = engine::find(name);
  if (row == nullptr) throw std::invalid_argument("no engine " + std::string(name));
  return new durero_engine{&scene.value.of().scene, composed::prepared(*row, hierarchy, scene.value.of())};
}

/// The text of a scene file of that name: pictures are named from its folder.
std::string text_for(const durero_scene& scene, const char* path) {
  if (scene.file.empty()) return scene.value.scene_text();
  written::Edited moved = scene.value;
  io::rename_pictures(moved.stage(), scene.file, path);
  return moved.scene_text();
}

/// The answer of an edit, as the scene and the thread keep it.
durero_answer answered(durero_scene& scene, io::EditAnswer answer) {
  scene.left_group = std::move(answer.left_group);
  if (answer.ok()) return DURERO_DONE;
  last_error.assign(answer.violated).append(": ").append(answer.predicate);
  return DURERO_REFUSED;
}

/// The answer of an edit of meshes.
io::EditAnswer applied(durero_scene& scene, scene::MeshEdit edit) {
  return scene.history.apply_total(scene.value, {1, std::move(edit)});
}

/// The answer where a step of the history was done, or where none was and the clause says so.
durero_answer moved(durero_scene& scene, bool is_done, const contract::clause& precondition) {
  scene.left_group.clear();
  if (is_done) return DURERO_DONE;
  return answered(scene, {"", std::string(precondition.label), std::string(precondition.predicate), ""});
}

void require_transaction(const durero_scene& scene, bool is_open) {
  if (scene.history.is_open() == is_open) return;
  throw std::logic_error(is_open ? "no transaction is open; expected durero_begin() before"
                                 : "a transaction is open; expected durero_commit() or durero_roll_back() before");
}

scene::Mesh mesh_of(std::string_view m, const durero_mesh& from) {
  if (!model::Elemento::is_name(m))
    throw std::invalid_argument(std::string(m) + ": no name; expected 1 to 128 of A-Z a-z 0-9 _ . : -");
  scene::Mesh mesh{model::Elemento(std::string(m))};
  mesh.puntos.reserve(from.vertex_count);
  for (std::size_t i = 0; i < from.vertex_count; ++i) {
    const double* const at = from.vertices + 3 * i;
    if (!std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2]))
      throw std::invalid_argument("vertex " + std::to_string(i) + ": no point; expected finite numbers");
    mesh.puntos.push_back({at[0], at[1], at[2]});
  }
  mesh.caras.reserve(from.face_count);
  for (std::size_t i = 0; i < from.face_count; ++i) {
    const std::uint32_t* const corners = from.faces + 3 * i;
    mesh.caras.push_back({corners[0], corners[1], corners[2]});
  }
  return mesh;
}

durero_hit published(const scene::Hit& hit) {
  return {c::outcome(hit.resultado),
          static_cast<std::uint32_t>(hit.elementos.size()),
          hit.t,
          {hit.punto.x, hit.punto.y, hit.punto.z}};
}

}  // namespace

const char* durero_error(void) { return last_error.c_str(); }

const char* durero_version(void) { return DURERO_VERSION; }

durero_scene* durero_scene_new(void) {
  return guarded<durero_scene*>(nullptr, [] { return new durero_scene{written::Edited()}; });
}

durero_scene* durero_scene_read(const char* path) {
  return guarded<durero_scene*>(nullptr, [&] {
    return new durero_scene{written::Edited(io::read_grouped_scene(io::read_source(path), io::Bodies::read)),
                            from_root(path)};
  });
}

durero_scene* durero_scene_read_with(const char* path, const char* text) {
  return guarded<durero_scene*>(nullptr, [&] {
    return new durero_scene{written::Edited(io::read_source(path), std::make_shared<const written::Text>(text)),
                            from_root(path)};
  });
}

durero_answer durero_scene_write(const durero_scene* scene, const char* path) {
  return guarded(DURERO_FAILED, [&] {
    io::write_file(path, text_for(*scene, path));
    return DURERO_DONE;
  });
}

void durero_scene_free(durero_scene* scene) { delete scene; }

size_t durero_scene_size(const durero_scene* scene) { return scene->value.of().scene.size(); }

durero_answer durero_apply(durero_scene* scene, const char* operation) {
  return guarded(DURERO_FAILED, [&] {
    const auto script =
        io::read_script(io::Source("operation", operation), scene->value.of().scene.stage(), scene->value.types());
    if (script.size() != 1) throw std::invalid_argument("operation: no single operation; expected one");
    return answered(*scene, scene->history.apply_total(scene->value, script.front()));
  });
}

durero_answer durero_add_mesh(durero_scene* scene, const char* m, const durero_mesh* mesh) {
  return guarded(DURERO_FAILED,
                 [&] { return answered(*scene, applied(*scene, scene::MeshAddition{mesh_of(m, *mesh)})); });
}

durero_answer durero_replace_mesh(durero_scene* scene, const char* m, const durero_mesh* mesh) {
  return guarded(DURERO_FAILED,
                 [&] { return answered(*scene, applied(*scene, scene::MeshReplacement{mesh_of(m, *mesh)})); });
}

durero_answer durero_undo(durero_scene* scene) {
  return guarded(DURERO_FAILED, [&] {
    require_transaction(*scene, false);
    return moved(*scene, scene->history.undo(scene->value), model::Deshacer_pre_1);
  });
}

durero_answer durero_redo(durero_scene* scene) {
  return guarded(DURERO_FAILED, [&] {
    require_transaction(*scene, false);
    return moved(*scene, scene->history.redo(scene->value), model::Rehacer_pre_1);
  });
}

durero_answer durero_begin(durero_scene* scene) {
  return guarded(DURERO_FAILED, [&] {
    require_transaction(*scene, false);
    scene->history.begin();
    return DURERO_DONE;
  });
}

durero_answer durero_commit(durero_scene* scene) {
  return guarded(DURERO_FAILED, [&] {
    require_transaction(*scene, true);
    scene->history.commit();
    return DURERO_DONE;
  });
}

durero_answer durero_roll_back(durero_scene* scene) {
  return guarded(DURERO_FAILED, [&] {
    require_transaction(*scene, true);
    scene->history.roll_back(scene->value);
    return DURERO_DONE;
  });
}

const char* durero_left_group(const durero_scene* scene) { return scene->left_group.c_str(); }

durero_engine* durero_engine_new(const durero_scene* scene, const char* name) {
  return guarded<durero_engine*>(nullptr, [&] {
    const bool by_text = scene->value.text() != nullptr;
    if (by_text && name != nullptr)
      throw std::invalid_argument("the scene was read by a Z text, which answers; expected no engine's name");
    const scene::Scene& of = scene->value.of().scene;
    if (by_text) return new durero_engine{&of, scene->value.engine()};
    return ready(*scene, name == nullptr ? engine::default_engine : std::string_view(name), engine::automatic);
  });
}

durero_engine* durero_engine_new_by_hand(const durero_scene* scene, const char* name) {
  return guarded<durero_engine*>(nullptr, [&] {
    if (scene->value.text() != nullptr)
      throw std::invalid_argument("the scene was read by a Z text, which answers; expected one with groups");
    return ready(*scene, name, engine::by_hand);
  });
}

void durero_engine_free(durero_engine* engine) { delete engine; }

durero_answer durero_first_hits(const durero_engine* engine, const durero_ray* rays, size_t count, durero_hit* hits) {
  return guarded(DURERO_FAILED, [&] {
    std::vector<scene::Query> queries;
    queries.reserve(count);
    for (std::size_t i = 0; i < count; ++i) queries.push_back(query(rays[i], i));
    const std::vector<scene::Hit> found = engine::first_hits(*engine->value, queries);
    std::transform(found.begin(), found.end(), hits, published);
    return DURERO_DONE;
  });
}

int durero_elements(const durero_engine* engine, const durero_ray* ray, char* names, size_t size) {
  return guarded(-1, [&] {
    const scene::Hit hit = engine::first_hit(*engine->value, query(*ray, 0));
    for (const scene::ElementRef element : hit.elementos) {
      const std::string& name = engine->scene->name(element).name();
      if (name.size() + 1 > size) continue;
      std::memcpy(names, name.c_str(), name.size() + 1);
      names += name.size() + 1;
      size -= name.size() + 1;
    }
    return static_cast<int>(hit.elementos.size());
  });
}
