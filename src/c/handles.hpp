#pragma once
/// What the handles of durero.h own, and how a call ends.

#include <cstdint>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "durero/c/durero.h"
#include "durero/contract/contract.hpp"
#include "durero/engine/engine.hpp"
#include "durero/io/json/edit_history.hpp"
#include "durero/model/resultado.hpp"
#include "durero/scene/scene.hpp"
#include "durero/written/edited.hpp"

struct durero_scene {
  durero::written::Edited value;
  std::string file{};        // that it was read from, from the root; empty where there was none
  std::string left_group{};  // by the last operation
  durero::io::EditHistory history{most_steps};

  static constexpr std::size_t most_steps = 10'000;
};

struct durero_engine {
  const durero::scene::Scene* scene;
  std::shared_ptr<const durero::engine::Engine> value;
  mutable std::mutex names_in_use{};
  mutable std::map<std::uint32_t, std::string> names{};  // of elements, by number: those that were asked for
};

namespace durero::c {

/// durero_error() of this thread.
inline thread_local std::string last_error;

/// What `call` answers, or `failed` where it throws: no exception leaves the library.
template <class Result, class Call>
Result guarded(Result failed, Call call) noexcept {
  try {
    return call();
  } catch (const std::exception& error) {
    try {
      last_error = error.what();
    } catch (...) {
      last_error.clear();  // there is no memory for it
    }
  } catch (...) {
    last_error.clear();
  }
  return failed;
}

/// The path of a file from the root.
inline std::string from_root(const char* path) { return std::filesystem::absolute(path).string(); }

/// As C has it.
inline durero_outcome outcome(model::Resultado resultado) {
  switch (resultado) {
    case model::Resultado::hit:
      return DURERO_HIT;
    case model::Resultado::miss:
      return DURERO_MISS;
    case model::Resultado::no_minimum:
      return DURERO_NO_MINIMUM;
  }
  contract::unreachable();
}

}  // namespace durero::c
