#pragma once
/// The audit of a mesh, `durero check --mesh FILE`. The demonstration's program reads no other program's format, and
/// refuses it (demo_commands.cpp).

#include <cstddef>
#include <string>

namespace durero::cli {

/// The options of an audit.
struct AuditCall {
  std::string scene;            ///< the file: a scene, or a mesh by its name
  std::string format = "text";  ///< of the answer: `text`, `json` or `sarif`
  std::string point;            ///< of which the side is told: X,Y,Z, or empty
  std::string picture;          ///< the file that is drawn, or empty
  std::size_t most = 0;         ///< so many findings of each kind, and pieces, are listed; 0 for all
  bool quiet = false;           ///< without progress
};

/// Audits the triangles of a file as one mesh and prints the answer; returns the exit status. Throws io::InputError and
/// io::FileError where a file is bad.
int audit_mesh(const AuditCall& call);

}  // namespace durero::cli
