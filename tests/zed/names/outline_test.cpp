#include "durero/zed/names/outline.hpp"

#include "support/catch.hpp"
#include "zed/lines.hpp"
#include "zed/names/marked.hpp"

using namespace durero::zed;
using namespace durero::zed::test;

namespace {

/// An outline in one line: NAME{entries}, with the text that the name takes.
std::string written(const std::vector<OutlineEntry>& entries, const std::string& text) {
  std::string all;
  for (const OutlineEntry& each : entries) {
    all += (all.empty() ? "" : " ") + each.name;
    if (!each.entries.empty()) all += "{" + written(each.entries, text) + "}";
    CHECK(each.from <= each.name_from);
    CHECK(each.name_from <= each.name_to);
    CHECK(each.name_to <= each.to);
    CHECK(each.to <= text.size());
  }
  return all;
}

std::string outlined(const std::string& text) {
  const CheckedTexts of = checked({{"m.tex", text}});
  return written(outline(of, "m.tex"), text);
}

}  // namespace

TEST_CASE("an outline lists what paragraphs declare") {
  CHECK(outlined("─\n[A, B]\nT ::= leaf | node⟪T⟫\nN == ℕ\n└\n╷\nf, g : ℕ\n└\n┌ S\nx, y? : ℕ\n└\n─\n⊢? ∀ n : ℕ • n = "
                 "n\n└\n") == "A B T{leaf node} N f g S{x y?} ⊢?");
  CHECK(outlined("\\begin{zsection}\n\\SECTION mine\n\\end{zsection}\n\\begin{schema}{S}\nx : A\n\\end{schema}\n") ==
        "mine{S{x}}");
  CHECK(
      outlined("\\begin{zsection}\n\\SECTION mine \\parents standard\\_toolkit\n\\end{zsection}\n"
               "\\begin{schema}{S}\nx : \\nat\n\\end{schema}\n\\begin{zed}\n\\vdash? 1 = 1 % S.conj.1\n\\end{zed}\n") ==
      "mine{S{x} S.conj.1}");
}

TEST_CASE("an entry takes its paragraph, and names stand among its bytes") {
  const std::string text = "─\nA == 1\nB == 2\n└\n";
  const CheckedTexts of = checked({{"m", text}});
  const std::vector<OutlineEntry> entries = outline(of, "m");
  REQUIRE(entries.size() == 2);
  CHECK(text.substr(entries[0].from, entries[0].to - entries[0].from) == "A == 1");
  CHECK(text.substr(entries[1].name_from, entries[1].name_to - entries[1].name_from) == "B");
  CHECK(entries[1].detail == "𝔸");
}

TEST_CASE("each Z text at hand has an outline with its places in order") {
  for (const char* folder : {"tests/zed/corpus/right", "tests/zed/corpus/wrong", "spec", "demo"})
    for (const std::string& file : files_in(folder)) {
      const std::string text = contents(file);
      INFO(file);
      const CheckedTexts of = checked({{file, text}});
      written(outline(of, file), text);
    }
}
