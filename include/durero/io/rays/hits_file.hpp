#pragma once
/// Hit files. As JSON lines, in the order of the rays:
///
///   {"ray":0,"outcome":"hit","elementos":["a"],"t":4,"point":[0,0,4]}
///   {"ray":1,"outcome":"miss","elementos":[]}
///   {"ray":2,"outcome":"no_minimum","elementos":["c"]}
///
/// Only a hit has t and point. `elementos` ascends by the bytes of the names. A value whose rounding is infinite is the
/// string "inf" or "-inf".
///
/// As .npy, one record a ray: dtype [('outcome','S10'),('t','<f8'),('point','<f8',(3,)),('elementos','S…')]; without a
/// hit t and point are NaN; the names stand in `elementos` separated by commas.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/io/spool.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// The members of a hit, into an object: outcome, elementos, and of a hit t and point.
void write_hit(json::Writer& out, const scene::Hit& hit, const scene::Scene& scene);

/// One line of JSON, without line end.
std::string hit_text(std::size_t ray, const scene::Hit& hit, const scene::Scene& scene);

/// The .npy file of the hits of all rays.
std::string hits_npy(std::span<const scene::Hit> hits, const scene::Scene& scene);

/// Writes the hits of rays as they come: .npy where the name of the file ends so, else JSON lines (.jsonl, .ndjson,
/// .json, .txt, or no ending). Memory does not grow
/// with their number. The file appears at commit(); where JSON lines go to the standard output, a pipe or a device,
/// they are there at once. All members throw FileError.
class HitWriter {
 public:
  /// Finds out whether the file can be written, and whether its name is that of another format.
  explicit HitWriter(const std::string& path);

  /// The hits of the next rays of the scene.
  void write(std::span<const scene::Hit> hits, const scene::Scene& scene);
  /// Ends the file and puts it in place, on disk. Nothing may be written after it.
  void commit();

 private:
  void write_rows();

  OutputFile out_;
  std::optional<Spool> rows_{};  // of .npy: its head tells their number and the width of the longest names
  std::size_t rays_ = 0;
  std::size_t width_;
};

/// A hit, and the number of its ray in the ray file (from 0).
struct RayHit {
  std::size_t ray;     ///< whether there is such a ray, read_hits() does not ask
  std::size_t offset;  ///< where that number stands in the source
  scene::Hit hit;      ///< its t and point as the file has them: nothing is computed anew
};

/// Reads JSON lines. Throws InputError, also on an element that the scene has not.
std::vector<RayHit> read_hits(const Source& source, const scene::Scene& scene);

/// Reads JSON lines, in any order, as the hits of that many rays: one for each ray, nothing for a ray without a line.
/// Throws InputError, also at the number of a ray that is none of them or has a hit already.
std::vector<std::optional<scene::Hit>> read_hits_of_rays(const Source& source, const scene::Scene& scene,
                                                         std::size_t rays);

}  // namespace durero::io
