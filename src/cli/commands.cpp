#include "commands.hpp"

namespace durero::cli {

std::vector<CommandGroup> command_groups() {
  return {{"Scenes",
           {add_check, add_edit, add_watch, add_diff, add_merge, add_store, add_serve, add_import, add_export,
            add_convert}},
          {"Rays and pictures",
           {add_trace, add_distance, add_render, add_view, add_environment, add_raster, add_shader, add_fractal,
            add_engines, add_stats, add_voxelise, add_agree}},
          {"Other programs, and the specification", {add_conform, add_spec}},
          {"This program", {add_help, add_version, add_man, add_completion}}};
}

}  // namespace durero::cli
