// durero spec show NAME: a paragraph in Unicode, and for each label in it the clause, the tests and the theorems.
#include <string>

#include "durero/io/source.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/spec/label_index.hpp"
#include "durero/text/nearest.hpp"
#include "embedded.hpp"
#include "spec.hpp"

namespace durero::cli {

int spec_show(const std::string& name, const std::vector<std::string>& files) {
  const zed::Specification text = specification_of(files);
  // Labels of another text are carried out elsewhere.
  const spec::LabelIndex places(files.empty() ? embedded::labels().begin()->second : "");
  const std::string said = spec::shown(text, name, places);
  if (said.empty()) {
    const std::string word = spec::in_unicode(text, name);
    const auto meant = durero::text::nearest(word, spec::names_and_labels(text));
    throw io::InputError("NAME", {1, 1}, "the text declares no " + word,
                         "expected " + meant.value_or("a name that it declares, or a label, such as Escena.inv.1"));
  }
  io::print(said);
  return 0;
}

}  // namespace durero::cli
