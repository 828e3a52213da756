#include "lsp/text_group.hpp"

#include "support/catch.hpp"

using namespace durero::lsp;

namespace {

std::string section(const std::string& name, const std::string& parents) {
  return "\\begin{zsection}\n\\SECTION " + name + (parents.empty() ? "" : " \\parents " + parents) +
         "\n\\end{zsection}\n";
}

std::string names_of_group(const std::string& path, const FolderTexts& folder) {
  std::string names;
  for (const auto& [each, text] : group_of(path, folder.at(path), folder)) names += each + " ";
  return names;
}

}  // namespace

TEST_CASE("a text is read with its parents and children, and theirs") {
  const FolderTexts folder = {{"a", section("a", "")},        {"b", section("b", "a, standard\\_toolkit")},
                              {"c", section("c", "b")},       {"d", section("d", "standard\\_toolkit")},
                              {"e", section("e", "nowhere")}, {"n", "\\begin{zed}\n[X]\n\\end{zed}\n"}};
  CHECK(names_of_group("a", folder) == "a b c ");
  CHECK(names_of_group("c", folder) == "a b c ");
  CHECK(names_of_group("d", folder) == "d ");
  CHECK(names_of_group("e", folder) == "e ");
  CHECK(names_of_group("n", folder) == "n ");
}

TEST_CASE("of two texts with one section, one is read: the text itself, if it is of them") {
  const FolderTexts folder = {{"a", section("a", "")}, {"b", section("a", "")}, {"c", section("c", "a")}};
  CHECK(names_of_group("c", folder) == "a c ");
  CHECK(names_of_group("b", folder) == "b c ");
}
