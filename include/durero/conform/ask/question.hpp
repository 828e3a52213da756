#pragma once
/// A question is text that asks a system about a scene and rays, in lines that some twenty lines of any language read
/// and answer.
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
/// An element is its word in files, its name, its points and vectors, then its lengths. A number is the shortest
/// decimal that reads back. A system whose profile claims the question `shadow` may be asked `shadows N` for `rays N`,
/// with a number T behind each ray: whether anything is hit at t ≤ T. It answers `miss` or `hit`, and what it may say
/// of the hit besides is not judged. One that claims `range` may be asked `ranges N`, with two numbers T0 T1 behind
/// each ray: the first hit at T0 ≤ t ≤ T1, with t > 0 and nothing where T0 > T1. One that claims `all` may be asked
/// `crossings N`: every hit at t > 0, in the order of t. One that claims `count` may be asked `counts N`: how many
/// these are. One that claims `closest` may be asked `points N`, with PX PY PZ alone for each: the nearest point of the
/// scene, answered as a hit whose T is its distance. One that claims `cast` may be asked `casts N`, with a number R > 0
/// behind each ray: the first t ≥ 0 at which some point of an element is within R of p + t·v, answered as a hit whose
/// point is the place of contact. The system writes `system NAME VERSION`, then a line for each ray,
/// in order:
///
///   miss
///   hit ELEMENT T               - for an ELEMENT or a T that it cannot give, or both; a T may be nan, inf or -inf
///   hit ELEMENT T X Y Z
///   hit … normal NX NY NZ front uv U V
///                               what the system says of the hit besides, each part where it can; back for front
///   hit                         to a shadow ray alone
///   hit ELEMENT T ; hit ELEMENT T
///                               to `crossings` alone, each hit as above
///   count N                     to `counts` alone
///   refused WHY
///
/// Words besides are judged where the profile claims them.
///
/// The system flushes its lines at least after each scene. A question to a system of solids leaves out the discs that
/// close an element: the element is understood as a solid.

#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/families/suite.hpp"

namespace durero::conform {

/// The question about these rays of the case, given by their numbers.
std::string question_text(const SuiteCase& of, Caps caps, std::span<const std::size_t> rays);

/// The name and version in a line `system NAME VERSION`, or nothing where the line is malformed.
std::optional<std::string> read_system_line(std::string_view line);

/// The claim in a line of a system without its end. A malformed line, or an answer about an element that the question
/// does not name, gives an unanswered claim; Claim::why says what is wrong.
Claim read_answer(std::string_view line, const SuiteCase& of, Caps caps);

/// The line that gives this claim, without its end. Outcomes that no system writes (crashed, hung, not asked) have
/// lines of their own, which read_claim reads.
std::string claim_text(const Claim& claim, const scene::Scene& scene);
/// The claim that claim_text() wrote. Throws std::invalid_argument on any other text.
Claim read_claim(std::string_view text, const scene::Scene& scene);

/// A question as a system reads it.
struct Question {
  std::string scene_name;            ///< such as generic/0003
  scene::Scene scene;                ///< the elements, in the order of their lines
  std::vector<scene::Query> rays{};  ///< in order; they start on no elements; a point that is asked is an origin
  QuestionKind kind{};               ///< what is asked
  std::vector<AskedRange> ranges{};  ///< where has_numbers(kind); otherwise none
  std::vector<NamedBody> bodies{};   ///< the elements that are bodies
};

/// A reader of questions, one by one.
class QuestionReader {
 public:
  /// A reader of the file. Preconditions: it is open for reading and outlives the reader.
  explicit QuestionReader(std::FILE& from) : from_(&from) {}

  /// The next question; nothing at the end. Throws io::InputError, whose place counts lines from the first question.
  std::optional<Question> next();

 private:
  std::optional<std::string> next_line();
  std::string required_line(std::string_view what);
  struct Rays {
    std::size_t count;
    QuestionKind kind;
  };
  Rays read_elements(Question& question);  // the rays that follow them

  std::FILE* from_;
  std::size_t lines_ = 0;
};

}  // namespace durero::conform
