#pragma once
/// The steps of a script that add elements with bodies: a copy needs an original, and a solid needs parts.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/scene/scene.hpp"
#include "element_steps.hpp"

namespace durero::io {

/// Adds one body after another. What a body is made of is an element that is there, or one that is made for it, serves
/// the bodies behind it too, and is removed at the end.
class BodySteps {
 public:
  /// `now` is the scene that add() edits, whose other elements stay, on the way between two scenes; no part has the
  /// name of an element of these. All must outlive it.
  BodySteps(const scene::Scene& now, const scene::Scene& from, const scene::Scene& to,
            std::function<void(AnyStep)> add);

  /// Adds an element with a body, whose maps have entries that are binary64.
  void add_body(const std::string& name, const scene::Body& body, std::optional<std::uint32_t> material);
  /// Removes what was made for them; the last call.
  void remove_parts();

 private:
  using Geometry = std::multimap<std::string, std::string>;  // from the text of a body to the names of elements

  void make(const std::string& name, const scene::Body& body, std::optional<std::uint32_t> material);
  std::string part_element(const scene::Body& part, const std::vector<std::string>& not_of);
  std::string free_name();

  const scene::Scene& now_;
  const scene::Scene& from_;
  const scene::Scene& to_;
  std::function<void(AnyStep)> add_;
  Geometry by_geometry_{};
  std::vector<std::string> made_{};  // the parts that are to be removed
  std::size_t last_part_ = 0;
};

}  // namespace durero::io
