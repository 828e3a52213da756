// Scripts of operations: each is answered, under every contract.
#include "durero/contract/contract.hpp"
#include "durero/io/operations_file.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  return test::fuzz([&] {
    scene::GroupedScene edited;
    edited.scene.stage().materials = {{"red", {1, 0, 0}}};
    for (const io::Step& step : io::read_script(test::as_source(data, size), edited.scene.stage())) {
      const std::size_t before = edited.scene.size();
      const auto* const edit = std::get_if<scene::Edit>(&step.edit);  // without types none is a WrittenEdit
      const io::EditAnswer answer = edit != nullptr
                                        ? io::edit_answer(edited.apply_total(*edit))
                                        : io::edit_answer(edited.apply_total(std::get<scene::GroupEdit>(step.edit)));
      test::must(answer.ok() || edited.scene.size() == before);
      test::must(!io::answer_text(step.line, answer).empty());
    }
  });
}
