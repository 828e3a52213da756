#include "durero/conform/ask/ranges_file.hpp"

#include <fmt/format.h>

#include "conform/ask/words.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

/// An end of a range, which stands in the text of the source.
double end_of(const io::Source& source, std::string_view word) {
  const std::optional<double> end = io::read_finite(word);
  if (!end || *end < 0)
    source.fail(static_cast<std::size_t>(word.data() - source.text().data()), text::shown(word),
                "expected a number that is not negative");
  return *end;
}

/// The radius of a ball, likewise.
double radius_of(const io::Source& source, std::string_view word) {
  const std::optional<double> radius = io::read_finite(word);
  if (!radius || !(*radius > 0))
    source.fail(static_cast<std::size_t>(word.data() - source.text().data()), text::shown(word),
                "expected a radius that is positive");
  return *radius;
}

/// The words that a line of the file has.
std::string_view expected_line(QuestionKind question) {
  if (question == QuestionKind::range) return "expected T0 T1, the ends of a ray";
  return question == QuestionKind::cast ? "expected R, the radius of a ball" : "expected T, the end of a ray";
}

}  // namespace

std::vector<AskedRange> read_ranges(const io::Source& source, QuestionKind question, std::size_t rays) {
  const std::size_t ends = question == QuestionKind::range ? 2 : 1;
  const std::string_view text = source.text();
  std::vector<AskedRange> all;
  io::Lines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view whole = text.substr(line->begin, line->end - line->begin);
    const std::vector<std::string_view> words = words_of(whole.substr(0, whole.find('#')));
    if (words.empty()) continue;
    if (words.size() != ends)
      source.fail(line->begin, fmt::format("{} numbers", words.size()), std::string(expected_line(question)));
    if (question == QuestionKind::cast)
      all.push_back({.radio = radius_of(source, words[0])});
    else
      all.push_back({ends == 2 ? end_of(source, words[0]) : 0, end_of(source, words.back())});
  }
  if (all.size() != rays)
    source.fail(text.size(), fmt::format("{} ranges", all.size()), fmt::format("expected {}, one a ray", rays));
  return all;
}

std::string ranges_text(QuestionKind question, std::span<const AskedRange> ranges) {
  std::string text;
  for (const auto& [begin, end, radio] : ranges) {
    if (question == QuestionKind::range) text += io::number_text(begin) + ' ';
    text += io::number_text(question == QuestionKind::cast ? radio : end) + '\n';
  }
  return text;
}

}  // namespace durero::conform
