// Scripts of operations: each is answered, under every contract.
#include "durero/contract/contract.hpp"
#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/model/operaciones.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  return test::fuzz([&] {
    io::EditedScene edited;
    edited.stage().materials = {{"red", {1, 0, 0}}};
    for (const io::ScriptStep& step : io::read_script(test::as_source(data, size), edited.stage())) {
      const std::size_t before = edited.of().scene.size();
      const io::EditAnswer answer = edited.apply_total(step);
      test::must(answer.ok() || edited.of().scene.size() == before);
      test::must(!io::answer_text(step.line, answer).empty());
    }
  });
}
