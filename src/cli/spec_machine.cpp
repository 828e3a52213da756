#include "spec_machine.hpp"

#include "spec.hpp"
#include "spec_run_typed.hpp"

namespace durero::cli {

void refuse_as_said(const std::string& where, const std::string& said) {
  const std::size_t end = said.find("; expected");
  throw io::InputError(where, {1, 1}, said.substr(0, end),
                       end == said.npos ? "expected a text without errors" : said.substr(end + 2));
}

std::unique_ptr<spec::Machine> machine_of(const std::vector<std::string>& files, const std::vector<std::string>& given,
                                          spec::Setup setup) {
  for (const std::string& typed : given) add_typed_members(typed, setup);
  // The scene is the state of the program's own text, though a scene with meshes has a component more.
  if (files.empty() && setup.state.empty()) setup.state = "Escena";
  try {
    return with_constants([&] { return std::make_unique<spec::Machine>(specification_of(files), setup); });
  } catch (const spec::GivenSetError& error) {
    refuse_as_said("--given", error.what());
  } catch (const std::invalid_argument& error) {
    refuse_as_said(files.empty() ? "spec" : files.front(), error.what());
  }
}

}  // namespace durero::cli
