// Reads questions, as a system does.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "conform/ask/words.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/conform/families/asked_grid.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/number_text.hpp"
#include "durero/io/source.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/whole_number.hpp"

namespace durero::conform {
namespace {

/// A line of a question, which must outlive it, and its words.
struct QuestionLine {
  QuestionLine(std::size_t its_number, const std::string& its_text)
      : number(its_number), text(its_text), words(words_of(its_text)) {}

  std::size_t number;
  std::string_view text;
  std::vector<std::string_view> words;

  /// Throws io::InputError at the word of that number, or behind the last.
  [[noreturn]] void fail(std::size_t word, const std::string& wrong, const std::string& expected,
                         const contract::clause* broken = nullptr) const {
    const std::size_t at =
        word < words.size() ? static_cast<std::size_t>(words[word].data() - text.data()) : text.size();
    throw io::InputError("question", {number, at + 1}, wrong, expected, broken);
  }
  /// Throws io::InputError at a word that breaks a clause of the Z text.
  [[noreturn]] void fail(std::size_t word, const std::string& wrong, const contract::clause& broken) const {
    fail(word, wrong, fmt::format("expected {} ({})", broken.predicate, broken.label), &broken);
  }

  double number_at(std::size_t word) const {
    if (word >= words.size()) fail(word, "the line ends", "expected a number");
    const std::optional<double> value = io::read_finite(words[word]);
    if (!value) fail(word, text::shown(words[word]), "expected a finite number");
    return *value;
  }
};

/// A cursor over the numbers of a line.
class NumberReader {
 public:
  NumberReader(const QuestionLine& line, std::size_t first_word) : line_(&line), next_(first_word) {}

  void read(double& value) { value = line_->number_at(next_++); }
  void read(glm::dvec3& v) {
    for (int i = 0; i < 3; ++i) read(v[i]);
  }
  void read(scene::Corners& corners) {
    for (glm::dvec3& corner : corners) read(corner);
  }
  void end() const {
    if (next_ < line_->words.size())
      line_->fail(next_, text::shown(line_->words[next_]), "expected the end of the line");
  }

 private:
  const QuestionLine* line_;
  std::size_t next_;
};

model::Elemento name_of(const QuestionLine& line) {
  if (line.words.size() < 2 || !model::Elemento::is_name(line.words[1])) line.fail(1, "no name", "expected a name");
  return model::Elemento(std::string(line.words[1]));
}

void read_body(const QuestionLine& line, BodyKind kind, Question& question) {
  const model::Elemento name = name_of(line);
  AskedBody body{.kind = kind};
  NumberReader numbers(line, 2);
  numbers.read(body.centro);
  for (glm::dvec3& side : body.sides) numbers.read(side);
  constexpr std::size_t place_of_radius = 14;
  if (has_radius(kind)) numbers.read(body.radio);
  numbers.end();
  if (has_radius(kind) && !(body.radio > 0))
    line.fail(place_of_radius, text::shown(line.words[place_of_radius]), "expected a radius that is positive");
  if (!is_body(body)) line.fail(5, "the sides lie in a plane", "expected three that span space");
  if (!add_body(question.scene, name, body))
    line.fail(1, text::shown(name.name()), "expected a name that is no element's");
  question.bodies.push_back({question.scene.find(name.name()).value(), body});
}

/// A number of columns or rows of a grid, at that word of the line.
std::size_t read_size(const QuestionLine& line, std::size_t word) {
  const double size = line.number_at(word);
  constexpr double most = most_faces;
  if (!(size >= 2 && size <= most && size == std::floor(size)))
    line.fail(word, text::shown(line.words[word]), "expected a number of points along a side, 2 at least");
  return static_cast<std::size_t>(size);
}

/// The heights of the grid are as many as its line has, before room is made for them.
void read_grid(const QuestionLine& line, scene::Scene& scene) {
  constexpr std::size_t first_height = 8;
  AskedGrid grid{.name = std::string(name_of(line).name()), .columns = read_size(line, 2), .rows = read_size(line, 3)};
  const std::size_t heights = line.words.size() - std::min(line.words.size(), first_height);
  if (heights != grid.columns * grid.rows)
    line.fail(line.words.size(), fmt::format("{} heights", heights),
              fmt::format("expected {}", grid.columns * grid.rows));
  NumberReader numbers(line, 4);
  for (double* const number : {&grid.x, &grid.y, &grid.dx, &grid.dy}) numbers.read(*number);
  if (!(grid.dx > 0 && grid.dy > 0)) line.fail(6, "a way that is not positive", "expected DX and DY above 0");
  const auto last = [](double first, double way, std::size_t count) {
    return first + static_cast<double>(count) * way;
  };
  if (!std::isfinite(last(grid.x, grid.dx, grid.columns)) || !std::isfinite(last(grid.y, grid.dy, grid.rows)))
    line.fail(4, "points beyond all numbers", "expected a grid of finite coordinates");
  grid.heights.resize(heights);
  for (double& height : grid.heights) numbers.read(height);
  const model::Answer answer = scene.apply_total(scene::MeshAddition{mesh_of(grid)});
  if (!answer.ok()) line.fail(0, std::string(model::name(answer.r)), *answer.violated);
}

template <class Shape>
model::Answer add(const QuestionLine& line, scene::Scene& scene) {
  const model::Elemento name = name_of(line);
  Shape shape{};
  NumberReader numbers(line, 2);
  for (const bool are_lengths : {false, true}) {
    scene::for_each_attribute<Shape>([&]<class Row>(const Row& attribute) {
      if (std::is_same_v<typename Row::Stored, double> == are_lengths) numbers.read(shape.*attribute.field);
    });
  }
  numbers.end();
  return scene.add(name, shape);
}

void read_element(const QuestionLine& line, Question& question) {
  scene::Scene& scene = question.scene;
  const auto* const body = std::ranges::find(body_words, line.words.front());
  if (line.words.front() == word(BodyKind::campo)) return read_grid(line, scene);
  if (body != body_words.end()) return read_body(line, static_cast<BodyKind>(body - body_words.begin()), question);
  std::optional<model::Answer> answer;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    if (line.words.front() == Shape::word) answer = add<Shape>(line, scene);
  });
  if (!answer) line.fail(0, text::shown(line.words.front()), "expected an element, or rays and their number");
  if (!answer->ok()) line.fail(0, std::string(model::name(answer->r)), *answer->violated);
}

/// An end of a range, at that word of the line.
double read_end(const QuestionLine& line, std::size_t word) {
  const double end = line.number_at(word);
  if (end < 0) line.fail(word, text::shown(line.words[word]), "expected a number that is not negative");
  return end;
}

/// The radius of a ball, at that word of the line.
double read_radius(const QuestionLine& line, std::size_t word) {
  const double radius = line.number_at(word);
  if (!(radius > 0)) line.fail(word, text::shown(line.words[word]), "expected a radius that is positive");
  return radius;
}

/// Reads a ray, and its range where the question has some.
scene::Query read_ray(const QuestionLine& line, QuestionKind kind, std::vector<AskedRange>& ranges) {
  glm::dvec3 p, v(0, 0, 1);
  NumberReader numbers(line, 0);
  numbers.read(p);
  std::size_t next = 3;
  if (kind != QuestionKind::closest) {
    numbers.read(v);
    next = 6;
  }
  AskedRange range;
  if (kind == QuestionKind::range) range.begin = read_end(line, next++);
  if (has_range(kind)) range.end = read_end(line, next++);
  if (kind == QuestionKind::cast) range.radio = read_radius(line, next++);
  if (has_numbers(kind)) ranges.push_back(range);
  NumberReader(line, next).end();
  if (v == glm::dvec3(0)) line.fail(3, "v is (0, 0, 0)", model::Rayo_inv_1);
  return {{model::Punto(p), model::Vector(v)}};
}

std::size_t read_count(const QuestionLine& line) {
  const auto count = text::whole_number(line.words.size() == 2 ? line.words[1] : "");
  if (!count) line.fail(1, "rays without their number", "expected rays N");
  return *count;
}

/// A ball is cast at the types of the model alone, and of a torus no nearest point is known.
void require_answerable(const QuestionLine& line, QuestionKind kind, const Question& question) {
  const bool has_torus =
      std::ranges::any_of(question.bodies, [](const NamedBody& named) { return named.body.kind == BodyKind::toro; });
  const bool is_refused =
      kind == QuestionKind::cast ? !question.bodies.empty() : kind == QuestionKind::closest && has_torus;
  if (is_refused)
    line.fail(0, text::shown(line.words.front()),
              kind == QuestionKind::cast ? "expected no bodies beside balls" : "expected no torus beside points");
}

}  // namespace

std::optional<std::string> QuestionReader::next_line() {
  std::string line;
  int c = std::getc(from_);
  if (c == EOF) return std::nullopt;
  for (; c != EOF && c != '\n'; c = std::getc(from_)) {
    line += static_cast<char>(c);
    if (line.size() > io::longest_line) io::refuse_long_line({"question", std::move(line), lines_}, 0);
  }
  ++lines_;
  return line;
}

std::optional<Question> QuestionReader::next() {
  const std::optional<std::string> head = next_line();
  if (!head) return std::nullopt;
  const QuestionLine first(lines_, *head);
  if (first.words.size() != 2 || first.words[0] != "scene")
    first.fail(0, text::shown(*head), "expected scene and its name");
  Question question{std::string(first.words[1]), {}, {}};
  const auto [count, kind] = read_elements(question);
  question.kind = kind;
  for (std::size_t left = count; left > 0; --left) {
    const std::string text = required_line("a ray");
    question.rays.push_back(read_ray({lines_, text}, kind, question.ranges));
  }
  return question;
}

std::string QuestionReader::required_line(std::string_view what) {
  std::optional<std::string> line = next_line();
  if (!line) throw io::InputError("question", {lines_ + 1, 1}, "the question ends", fmt::format("expected {}", what));
  return *line;
}

QuestionReader::Rays QuestionReader::read_elements(Question& question) {
  for (;;) {
    const std::string text = required_line("an element, or rays and their number");
    const QuestionLine line(lines_, text);
    if (line.words.empty()) line.fail(0, "the line is empty", "expected an element, or rays and their number");
    const auto* const asked = std::ranges::find(heads_of_rays, line.words.front());
    if (asked != heads_of_rays.end()) {
      const auto kind = static_cast<QuestionKind>(asked - heads_of_rays.begin());
      require_answerable(line, kind, question);
      return {read_count(line), kind};
    }
    read_element(line, question);
  }
}

}  // namespace durero::conform
