// durero spec show NAME: a paragraph in Unicode, and for each label in it the clause, the tests and the theorems.
#include <string>

#include "durero/io/source.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/oracle/spec_index.hpp"
#include "durero/text/nearest.hpp"
#include "embedded.hpp"
#include "spec.hpp"

namespace durero::cli {

int spec_show(const std::string& name) {
  const std::string said = oracle::spec::shown(name, oracle::spec::LabelIndex(embedded::labels().begin()->second));
  if (said.empty()) {
    const std::string word = oracle::spec::in_unicode(name);
    const auto meant = text::nearest(word, oracle::spec::names_and_labels());
    throw io::InputError(
        "NAME", {1, 1}, "the text declares no " + word,
        "expected " + meant.value_or("a name of spec/, such as Escena, or a label, such as Escena.inv.1"));
  }
  io::print(said);
  return 0;
}

}  // namespace durero::cli
