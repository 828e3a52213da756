// durero spec eval EXPR [--scene SCENE]: the value of an expression, or whether a predicate holds.
#include "durero/io/output_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/oracle/calculator.hpp"
#include "durero/scene/retrieve.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

constexpr const char* file_name = "EXPR";

oracle::spec::Calculator calculator(const std::string& scene) {
  if (scene.empty()) return {};
  return oracle::spec::Calculator(scene::retrieve(io::read_scene(io::read_source(scene))));
}

}  // namespace

int spec_eval(const std::string& expression, const std::string& scene) {
  try {
    const auto result = calculator(scene).evaluate(expression);
    io::write_file("-", result.text + "\n");
    return result.yes ? 0 : 1;
  } catch (const zed::ZError& error) {
    throw io::InputError(file_name, {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  } catch (const zed::EvaluationError& error) {
    throw io::InputError(file_name, {1, 1}, std::string("this is not decided: ") + error.what(),
                         "expected finite sets, or equations, for what is quantified");
  }
}

}  // namespace durero::cli
