#pragma once
/// Ray files: text, `px py pz vx vy vz` a line, then `@name` for each element that the origin lies on; or .npy,
/// float64, shape (n, 6).

#include <exception>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/io/input.hpp"
#include "durero/io/rays/npy.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// A ray of the file, and the elements that its origin lies on: rayo? and en?.
using Ray = scene::Query;

/// Reads rays of a scene as they arrive. An input that starts as a .npy file does, or is named so, is read as one, the
/// others as text: numbers decimal or C's hexadecimal, `#` comments, blank lines. Throws FileError, and InputError on
/// v = 0, on what is no finite number and on a name that the scene has not; the place in a .npy file is the ray (from
/// 1) and its number.
class RayReader {
 public:
  /// Input and scene must outlive it.
  RayReader(Input& input, const scene::Scene& scene);

  /// Puts the next rays in place of these: those that are there whole, for which it waits; there may be none, as where
  /// lines are comments. False at the end. A bad ray is an error when those before it have been given.
  bool next(std::vector<Ray>& rays);

 private:
  bool next_lines(std::vector<Ray>& rays);
  bool next_rows(std::vector<Ray>& rays);

  Input& input_;
  const scene::Scene& scene_;
  std::optional<NpyReader> table_{};  // nothing: text
  std::vector<double> numbers_{};
  std::exception_ptr wrong_{};    // stands behind the rays that were given
  std::size_t done_ = 0;          // lines or rows
  bool is_after_return_ = false;  // "\n" would belong to the end of the line that "\r" has ended
};

/// Reads all rays of a text that is held whole.
std::vector<Ray> read_rays(const Source& source, const scene::Scene& scene);

/// Whether a text begins as files of rays do, and no scene does: as a .npy file, or with a number.
bool begins_as_rays(const Source& source);

/// The text of rays; reads back to the same rays.
std::string rays_text(std::span<const Ray> rays, const scene::Scene& scene);

/// The .npy file of rays; it has no place for the elements that an origin lies on.
std::string rays_npy(std::span<const Ray> rays);

}  // namespace durero::io
