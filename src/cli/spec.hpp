#pragma once
/// The subcommands of `durero spec`. Each returns the exit status.

#include <string>
#include <vector>

namespace durero::cli {

int spec_check(const std::vector<std::string>& files);
int spec_eval(const std::string& expression, const std::string& scene);
int spec_show(const std::string& name);
int spec_confirm(const std::string& scene, const std::string& rays, const std::string& hits);

}  // namespace durero::cli
