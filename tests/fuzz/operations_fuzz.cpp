// Scripts of operations: each is answered, under every contract.
#include "durero/contract/contract.hpp"
#include "durero/io/operations_file.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  return test::fuzz([&] {
    scene::Scene scene;
    scene.stage().materials = {{"red", {1, 0, 0}}};
    for (const auto& [line, edit] : io::read_operations(test::as_source(data, size), scene.stage())) {
      const std::size_t before = scene.size();
      const model::Answer answer = scene.apply_total(edit);
      test::must(answer.ok() || scene.size() == before);
      test::must(!io::answer_text(line, answer).empty());
    }
  });
}
