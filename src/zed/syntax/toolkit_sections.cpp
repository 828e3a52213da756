#include "durero/zed/syntax/toolkit_sections.hpp"

#include <algorithm>
#include <iterator>

namespace durero::zed {
namespace {

constexpr unsigned with(std::initializer_list<ToolkitSection> sections, unsigned ancestors = 1) {
  for (const ToolkitSection section : sections) ancestors |= 1U << static_cast<unsigned>(section);
  return ancestors;
}

// The parents are those of annex B: `sequence_toolkit` has function_toolkit and number_toolkit.
constexpr unsigned of_set = with({ToolkitSection::set}), of_relation = with({ToolkitSection::relation}, of_set),
                   of_function = with({ToolkitSection::function}, of_relation),
                   of_number = with({ToolkitSection::number}),
                   of_sequence = with({ToolkitSection::sequence}, of_function | of_number);

struct SectionOfToolkit {
  std::string_view name;
  unsigned gives;
};
constexpr SectionOfToolkit sections_of_toolkit[] = {  // in the order of ToolkitSection, and then that without names
    {"prelude", 1},
    {"set_toolkit", of_set},
    {"relation_toolkit", of_relation},
    {"function_toolkit", of_function},
    {"number_toolkit", of_number},
    {"sequence_toolkit", of_sequence},
    {"standard_toolkit", of_sequence}};

}  // namespace

std::string_view name_of(ToolkitSection section) { return sections_of_toolkit[static_cast<unsigned>(section)].name; }

std::optional<ToolkitSections> ToolkitSections::of(std::string_view name) {
  const auto* const at = std::ranges::find(sections_of_toolkit, name, &SectionOfToolkit::name);
  if (at == std::end(sections_of_toolkit)) return std::nullopt;
  return ToolkitSections(at->gives);
}

}  // namespace durero::zed
