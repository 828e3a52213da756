// The demonstration's program: what demo/demo.sh calls, and no more, so that `./x demo` builds it soon. It reads
// neither Z texts nor the formats of other programs.
#include <stdexcept>
#include <string>

#include "by_text.hpp"
#include "commands.hpp"
#include "edit_interactive.hpp"
#include "mesh_audit.hpp"

namespace durero::cli {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("the demonstration's program " + what +
                              "; expected the whole program, which ./x build makes");
}
[[noreturn]] void refuse_text() { refuse("reads no Z text"); }

}  // namespace

std::vector<CommandGroup> command_groups() {
  return {{"Scenes", {add_check, add_edit}}, {"Rays and pictures", {add_render, add_agree}}};
}

written::Written read_by_text(const io::Source&, const std::string&) { refuse_text(); }
written::Written read_shapes_by_text(const io::Source&, const std::string&) { refuse_text(); }
io::SceneCheck check_by_text(const io::Source&, const std::string&) { refuse_text(); }
std::unique_ptr<io::EditedScene> edited_by_text(const io::Source&, const std::string&) { refuse_text(); }
Editor editor_by_spec() { refuse_text(); }
ClauseFinder clauses_by_spec() { refuse_text(); }
std::vector<std::string> elements_of_set(const scene::Scene&, const std::string&) { refuse_text(); }
int edit_interactively(SessionCall) { refuse("has no session"); }
int audit_mesh(const AuditCall&) { refuse("audits no mesh"); }

}  // namespace durero::cli
