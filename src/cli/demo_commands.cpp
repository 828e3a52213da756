// The demonstration's program: what demo/demo.sh calls, and no more, so that `./x demo` builds it soon.
#include "commands.hpp"

namespace durero::cli {

std::vector<CommandGroup> command_groups() {
  return {{"Scenes", {add_check, add_edit}}, {"Rays and pictures", {add_render, add_agree}}};
}

}  // namespace durero::cli
