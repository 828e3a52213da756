#pragma once
/// How a system is asked: lines of text that some twenty lines of any language read and answer.
///
///   scene generic/0003
///   esfera e0 CX CY CZ R
///   cilindro e1 CX CY CZ DX DY DZ R H
///   cono e2 CX CY CZ DX DY DZ K H
///   tronco e3 CX CY CZ DX DY DZ R K H
///   plano e4 CX CY CZ DX DY DZ
///   disco e5 CX CY CZ DX DY DZ R
///   triangulo e6 AX AY AZ BX BY BZ CX CY CZ
///   rays 64
///   PX PY PZ VX VY VZ           for each ray
///
/// So an element is its word in files, its name, its points and vectors, then its lengths. A number is the shortest
/// decimal that reads back. The system writes `system NAME VERSION`, then a line for each ray, in order:
///
///   miss
///   hit ELEMENT T               - for an ELEMENT or a T that it cannot give, or both; a T may be nan, inf or -inf
///   hit ELEMENT T X Y Z
///   refused WHY
///
/// and flushes them at least after each scene. Of a system of solids the discs that close an element are left out: the
/// element is understood as a solid.

#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/conform/claim.hpp"
#include "durero/conform/suite.hpp"

namespace durero::conform {

/// The question of these rays of the case, by their numbers.
std::string question_text(const SuiteCase& of, Caps caps, std::span<const std::size_t> rays);

/// The line `system NAME VERSION`: what follows the word, or nothing where the line is none such.
std::optional<std::string> read_system_line(std::string_view line);

/// What a system answers, by a line of it without its end. Nothing of a malformed line is believed: it is unanswered,
/// and Claim::why says what is wrong with it; so is an answer that names an element that the question does not.
Claim read_answer(std::string_view line, const SuiteCase& of, Caps caps);

/// The line that answers so, without its end. Outcomes that no system writes (crashed, hung, not asked) have lines of
/// their own, which read_claim reads.
std::string claim_text(const Claim& claim, const scene::Scene& scene);
/// The claim of which that is the text. Throws std::invalid_argument where it is of none.
Claim read_claim(std::string_view text, const scene::Scene& scene);

/// A question as a system reads it.
struct Question {
  std::string scene_name;            ///< such as generic/0003
  scene::Scene scene;                ///< the elements, in the order of their lines
  std::vector<scene::Query> rays{};  ///< in order; they start on no elements
};

/// Reads questions one by one.
class QuestionReader {
 public:
  /// The file is open for reading, and must outlive it.
  explicit QuestionReader(std::FILE& from) : from_(&from) {}

  /// The next question; nothing at the end. Throws io::InputError, whose place counts lines from the first question.
  std::optional<Question> next();

 private:
  std::optional<std::string> next_line();
  std::string required_line(std::string_view what);
  std::size_t read_elements(scene::Scene& scene);  // the number of rays that follows them

  std::FILE* from_;
  std::size_t lines_ = 0;
};

}  // namespace durero::conform
