// Stores for C: what is kept is what the layer reads, what is refused or fails changes nothing.
#include "durero/store/store.hpp"

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "durero/c/durero.h"
#include "durero/io/json/groups_file.hpp"
#include "durero/store/verification.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"
#include "support/tree.hpp"

using namespace durero;

namespace {

using CScene = std::unique_ptr<durero_scene, decltype(&durero_scene_free)>;
using CStore = std::unique_ptr<durero_store, decltype(&durero_store_close)>;

const durero_provenance by_ann{"ann", "2026-01-31T12:00:00Z", "a reason"};

CStore opened(const std::string& path) { return {durero_store_open(path.c_str()), durero_store_close}; }

CStore created(const std::string& path) {
  REQUIRE(durero_store_create(path.c_str(), nullptr, &by_ann) == DURERO_DONE);
  CStore store = opened(path);
  REQUIRE(store);
  return store;
}

std::size_t size_at(const CStore& store, const char* revision = nullptr) {
  const CScene scene(durero_store_scene(store.get(), revision), durero_scene_free);
  REQUIRE(scene);
  return durero_scene_size(scene.get());
}

bool error_has(const std::string& text) { return std::string(durero_error()).find(text) != std::string::npos; }

std::string bytes_of_file(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

const char* const one = "Agregar_Esfera e?=a centro?=(0,0,5) radio?=1";
const char* const another = "Agregar_Esfera e?=b centro?=(0,0,5) radio?=1";
const char* const three =
    "Agregar_Esfera e?=a centro?=(0,0,5) radio?=1\n"
    "Agregar_Esfera e?=a centro?=(0,0,5) radio?=1\n"
    "Agregar_Esfera e?=b centro?=(0,0,5) radio?=1\n";

}  // namespace

TEST_CASE("C keeps a scene with its history, as the layer reads it") {
  const test::Folder folder;
  const std::string path = folder.file("room.store");
  const CStore store = created(path);
  CHECK(durero_store_head(store.get()) == 1);
  const durero_store_call call{by_ann, 0, 1};
  CHECK(durero_store_edit(store.get(), three, &call) == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "Agregar_Elemento.pre.1: e? ∉ elementos");
  CHECK(std::string(durero_store_answers(store.get())) ==
        "{\"line\":1,\"ok\":true,\"r\":\"esfera_agregada\"}\n"
        "{\"line\":2,\"ok\":false,\"r\":\"elemento_ya_existe\",\"violated\":\"Agregar_Elemento.pre.1\","
        "\"predicate\":\"e? ∉ elementos\"}\n"
        "{\"line\":3,\"ok\":true,\"r\":\"esfera_agregada\"}\n");
  CHECK(durero_store_head(store.get()) == 3);
  CHECK(size_at(store) == 2);
  CHECK(size_at(store, "HEAD~1") == 0);
  CHECK(size_at(store, "2") == 1);
  CHECK(durero_store_edit(store.get(), "Eliminar_Esfera e?=z\nAgregar_Esfera e?=a centro?=(0,0,5) radio?=1", nullptr) ==
        DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "Eliminar_Elemento.pre.1: e? ∈ elementos");
  CHECK(durero_store_scene(store.get(), "nowhere") == nullptr);
  CHECK(error_has("no revision"));

  store::Store read(path, store::StoreAccess::read);
  CHECK(read.event(3).by.author == "ann");
  CHECK(read.event(3).by.time == "2026-01-31T12:00:00Z");
  CHECK(read.event(3).by.comment == "a reason");
  CHECK(read.event(3).operation == another);
  CHECK(store::verify(read).is_whole());
}

TEST_CASE("C undoes and does again, by transactions") {
  const test::Folder folder;
  const CStore store = created(folder.file("room.store"));
  CHECK(durero_store_undo(store.get()) == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "Deshacer.pre.1: hechas ≠ ⟨⟩");
  CHECK(durero_store_edit(store.get(), three, nullptr) == DURERO_REFUSED);
  CHECK(durero_store_edit(store.get(), "Eliminar_Esfera e?=a", nullptr) == DURERO_DONE);
  CHECK(durero_store_undo(store.get()) == DURERO_DONE);
  CHECK(size_at(store) == 2);
  CHECK(durero_store_undo(store.get()) == DURERO_DONE);
  CHECK(size_at(store) == 0);
  CHECK(durero_store_redo(store.get()) == DURERO_DONE);
  CHECK(durero_store_redo(store.get()) == DURERO_DONE);
  CHECK(size_at(store) == 1);
  CHECK(durero_store_redo(store.get()) == DURERO_REFUSED);
  CHECK(std::string(durero_error()) == "Rehacer.pre.1: deshechas ≠ ⟨⟩");
}

TEST_CASE("an edit by C that fails or comes too late keeps nothing") {
  const test::Folder folder;
  const std::string path = folder.file("room.store");
  const CStore store = created(path);
  const durero_store_call whole{by_ann, 1, 0};
  CHECK(durero_store_edit(store.get(), three, &whole) == DURERO_REFUSED);
  CHECK(std::string(durero_store_answers(store.get())).find("elemento_ya_existe") != std::string::npos);
  CHECK(durero_store_head(store.get()) == 1);
  CHECK(durero_store_edit(store.get(), "Agregar_Esfera e?=", nullptr) == DURERO_FAILED);
  CHECK(std::string(durero_error()).starts_with("operations:1:"));
  CHECK(std::string(durero_store_answers(store.get())).empty());
  for (const durero_provenance& wrong :
       {durero_provenance{"a\nb", nullptr, nullptr}, durero_provenance{"a", "noon", nullptr}}) {
    const durero_store_call call{wrong, 0, 0};
    CHECK(durero_store_edit(store.get(), one, &call) == DURERO_FAILED);
    CHECK(error_has("expected"));
  }
  const CStore other = opened(path);
  CHECK(durero_store_edit(other.get(), one, nullptr) == DURERO_DONE);
  const durero_store_call stale{by_ann, 0, 1}, timely{by_ann, 0, 2}, none{by_ann, 0, -1};
  CHECK(durero_store_edit(store.get(), another, &stale) == DURERO_FAILED);
  CHECK(error_has("HEAD is at 2; expected 1"));
  CHECK(durero_store_edit(store.get(), another, &none) == DURERO_FAILED);
  CHECK(error_has("expected_head is -1"));
  CHECK(std::string(durero_store_answers(store.get())).empty());
  CHECK(durero_store_head(store.get()) == 2);
  CHECK(durero_store_edit(store.get(), another, &timely) == DURERO_DONE);
  CHECK(durero_store_head(store.get()) == 3);
}

TEST_CASE("handles of one file that edit at once lose nothing") {
  const test::Folder folder;
  const std::string path = folder.file("room.store");
  const CStore store = created(path);
  const auto edit = [&](const std::string& who) {
    const CStore own = opened(path);
    for (int i = 0; i < 20; ++i) {
      const std::string name = who + std::to_string(i);
      durero_store_edit(own.get(), ("Agregar_Esfera e?=" + name + " centro?=(0,0,5) radio?=1").c_str(), nullptr);
    }
  };
  std::thread first(edit, "x"), second(edit, "y");
  first.join();
  second.join();
  CHECK(size_at(store) == 40);
  CHECK(durero_store_head(store.get()) == 41);
}

TEST_CASE("a scene of C goes into a store and comes out, with its pictures") {
  const test::Folder folder;
  std::filesystem::create_directory(folder.file("one"));
  std::filesystem::copy_file(test::source_dir() + "/docs/mirrors.png", folder.file("one/wood.png"));
  std::ofstream(folder.file("one/scene.json"))
      << R"({"format":"durero-scene","version":1,"textures":{"wood":{"image":"wood.png"}},)"
         R"("elementos":[{"id":"a","tipo":"esfera","centro":[0,0,5],"radio":1}]})";
  const std::string path = folder.file("room.store"), out = folder.file("out.json");
  const CScene scene(durero_scene_read(folder.file("one/scene.json").c_str()), durero_scene_free);
  REQUIRE(scene);
  REQUIRE(durero_store_create(path.c_str(), scene.get(), nullptr) == DURERO_DONE);
  const CScene again(durero_store_scene(opened(path).get(), nullptr), durero_scene_free);
  REQUIRE(again);
  CHECK(durero_scene_size(again.get()) == 1);
  CHECK(durero_apply(again.get(), "Eliminar_Esfera e?=a") == DURERO_DONE);
  CHECK(size_at(opened(path)) == 1);
  REQUIRE(durero_scene_write(again.get(), out.c_str()) == DURERO_DONE);
  CHECK(bytes_of_file(out).find(R"("one/wood.png")") != std::string::npos);

  const CScene made(durero_scene_new(), durero_scene_free);
  REQUIRE(durero_apply(made.get(), one) == DURERO_DONE);
  REQUIRE(durero_store_create(folder.file("made.store").c_str(), made.get(), nullptr) == DURERO_DONE);
  CHECK(size_at(opened(folder.file("made.store"))) == 1);
  const std::string surfaces = test::source_dir() + "/demo/surfaces/torus";
  const CScene rings(durero_scene_read_with((surfaces + ".json").c_str(), (surfaces + ".tex").c_str()),
                     durero_scene_free);
  REQUIRE(rings);
  CHECK(durero_store_create(folder.file("rings.store").c_str(), rings.get(), nullptr) == DURERO_FAILED);
  CHECK(error_has("torus.tex"));
  CHECK_FALSE(std::filesystem::exists(folder.file("rings.store")));
}

TEST_CASE("a file that is no store, or a spoiled one, is told of and left as it is") {
  const test::Folder folder;
  const std::string path = folder.file("room.store");
  CHECK(durero_store_open(path.c_str()) == nullptr);
  CHECK(error_has("room.store: cannot be read"));
  CHECK(durero_store_edit(created(path).get(), one, nullptr) == DURERO_DONE);
  CHECK(durero_store_create(path.c_str(), nullptr, nullptr) == DURERO_FAILED);
  CHECK(error_has("is there already"));
  std::string spoiled = bytes_of_file(path);
  spoiled.replace(spoiled.find("Agregar_Esfera e?=a"), 19, "Agregar_Esfera e?=c");
  std::ofstream(path, std::ios::binary) << spoiled;
  {
    const CStore store = opened(path);
    CHECK(durero_store_scene(store.get(), nullptr) == nullptr);
    CHECK(error_has("event 2 is not as it was written"));
    CHECK(durero_store_edit(store.get(), another, nullptr) == DURERO_FAILED);
    CHECK(durero_store_head(store.get()) == 2);
  }
  CHECK(bytes_of_file(path) == spoiled);
  std::ofstream(path, std::ios::binary) << "mine";
  CHECK(durero_store_open(path.c_str()) == nullptr);
  CHECK(error_has("is no store"));
  durero_store_close(nullptr);
}
