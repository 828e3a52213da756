#pragma once
/// The audit of a mesh as lines, as JSON and as SARIF.

#include <string>

#include "durero/io/json/format_version.hpp"
#include "durero/io/mesh/mesh_check.hpp"

namespace durero::io {

/// The name and version that the text of mesh_check_json() begins with.
inline constexpr json::FormatVersion mesh_check_format{"durero-mesh-check", 1};

/// A line for the mesh, one for the point that was asked about, and one for each finding.
std::string mesh_check_text(const MeshCheck& check);
/// One JSON object that says the same. Ends its line.
std::string mesh_check_json(const MeshCheck& check);
/// A log of SARIF 2.1.0, a result a finding. It has no place for the counts, the volume and the point.
std::string mesh_check_sarif(const MeshCheck& check);

}  // namespace durero::io
