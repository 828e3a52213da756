#pragma once
/// Stores in a folder of a test, and scripts that are run on them.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "durero/io/json/groups_file.hpp"
#include "durero/store/store.hpp"
#include "support/folder.hpp"

namespace durero::test {

inline const store::Provenance by_ann{"ann", "2026-01-31T12:00:00Z", "a reason"};

inline io::Source script(const std::string& text) { return {"script", text}; }

inline std::string text_of(const scene::GroupedScene& of) { return io::scene_text(of.scene, of.groups); }

/// The scene of a revision, as a scene file.
inline std::string text_at(store::Store& of, std::string_view revision = "HEAD") {
  return text_of(of.state(of.find(revision)));
}

/// One transaction.
inline store::EditResult edit(store::Store& of, const std::string& text, bool all_or_nothing = false) {
  return of.edit({script(text), 0, by_ann, all_or_nothing, store::carry_out});
}

/// A sphere's addition; its name tells its place.
inline std::string ball(int number, double radius = 1) {
  return fmt::format("Agregar_Esfera e?=s{0} centro?=({0},0,0) radio?={1}\n", number, radius);
}
inline std::string balls(int first, int behind) {
  std::string text;
  for (int i = first; i < behind; ++i) text += ball(i);
  return text;
}

/// The path of a new store: of a file, or, where DURERO_STORE_SERVER is the URI of a PostgreSQL server, of a schema
/// there.
inline std::string new_store(const Folder& folder) {
  const char* const server = std::getenv("DURERO_STORE_SERVER");
  if (server == nullptr) return folder.file("kept.store");
  static int count = 0;
  return fmt::format("{}&options=-csearch_path%3Dkept_{}_{}", server, ::getpid(), ++count);
}

/// A new store of the empty scene, or of a scene file's.
struct KeptStore {
  explicit KeptStore(const std::string& scene = "") : path(new_store(folder)) {
    scene::GroupedScene of;
    if (!scene.empty()) of = io::read_grouped_scene(io::Source("scene.json", scene), io::Bodies::read);
    store::Store::create(path, std::move(of), "scene.json", by_ann);
  }
  store::Store open(store::StoreAccess access = store::StoreAccess::write) const { return store::Store(path, access); }

  Folder folder;
  std::string path;
};

}  // namespace durero::test
