#include "terminal_view.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/number/decimal.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/camera.hpp"
#include "durero/surface/exact.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/utf8.hpp"
#include "orbit.hpp"
#include "scene_tracer.hpp"
#include "terminal.hpp"

namespace durero::cli {
namespace {

constexpr std::string_view keys_help =
    "arrows turn  + - distance  w a s d move  click picks  c centres  0 resets  q ends";
constexpr double turn = 5;           // degrees of an arrow
constexpr double step = 0.05;        // of the distance, sideways
constexpr double nearer = 0.9;       // of the distance, ahead
constexpr unsigned status_rows = 2;  // below the picture
constexpr int stillness = 150;       // milliseconds without input, after which the picture becomes finer
constexpr std::uint32_t fine = 9;    // rays of a pixel then
constexpr int digits = 40;           // of an exact t

/// Whether the terminal says that it has colours of 24 bits.
bool has_all_colours() {
  const char* const colours = std::getenv("COLORTERM");
  return colours != nullptr && (std::string_view(colours) == "truecolor" || std::string_view(colours) == "24bit");
}

class TerminalView {
 public:
  TerminalView(const ViewOptions& options, FileWatch* watch) : options_(options), watch_(watch) { read(); }

  /// Shows the scene until the person ends it. The last camera.
  scene::Camera run() {
    Terminal terminal(watch_ == nullptr ? Terminal::no_descriptor : watch_->descriptor());
    for (bool goes_on = true; goes_on;) {
      if (!terminal.has_next()) draw(1);
      if (!terminal.has_next(stillness)) draw_finely(terminal);
      goes_on = answer(terminal.next());
    }
    return camera();
  }

 private:
  /// Reads the file, and takes nothing of it where it is wrong.
  void read() {
    auto tracer =
        std::make_unique<SceneTracer>(options_.text ? *options_.text : io::read_source(options_.scene), options_.engine,
                                      options_.hierarchy, options_.with, std::nullopt, Pictures::read);
    tracer->require_origins("shadow rays start on elements");
    scene::Scene shown = tracer->scene();
    scene::Stage& stage = shown.stage();
    if (!stage.camera) stage.camera = camera_of_whole(shown);
    stage.camera->shutter = 0;
    (void)scene::PrimaryRays(*stage.camera, scene::default_resolution);  // throws where the camera is wrong
    has_lights_ = !stage.lights.empty() || !stage.directional_lights.empty();
    if (!has_lights_ && !stage.background) stage.background = glm::dvec3(0.02, 0.02, 0.03);
    first_ = *stage.camera;
    tracer_ = std::move(tracer);
    shown_ = std::move(shown);
  }

  /// Shows the file as it was saved, by the camera as it stands.
  void read_again() {
    if (!watch_->was_saved()) return;
    try {
      (void)watch_->whole_file();
      const scene::Camera now = camera();
      read();
      camera() = now;
      picked_.reset();
      lines_ = {fmt::format("{}: {} elementos", text::escaped(options_.scene), shown_.size()), std::string(keys_help)};
    } catch (const std::exception& error) {
      lines_ = {error.what(), "the last picture stays"};
    }
  }

  scene::Camera& camera() { return *shown_.stage().camera; }

  /// The pixels of the picture: two in each character above the status.
  static scene::Resolution picture_size() {
    const TerminalSize size = Terminal::size();
    return {size.columns, 2 * (size.rows > status_rows ? size.rows - status_rows : 1)};
  }

  /// The end of a picture that nobody waits for any more.
  struct Superseded {};

  /// Draws the finer picture, unless something is typed before it is done.
  void draw_finely(Terminal& terminal) {
    try {
      draw(fine, [&](double) {
        if (terminal.has_next()) throw Superseded();
      });
    } catch (const Superseded&) {
    }
  }

  void draw(std::uint32_t samples, const render::Progress& progress = {}) {
    if (!has_lights_) shown_.stage().directional_lights = {{camera().look_at - camera().eye, glm::dvec3(1)}};
    const render::Picture picture =
        render::render(shown_, tracer_->engine(), progress, {.size = picture_size(), .samples = {.most = samples}});
    io::print(in_half_blocks(render::toned(picture, render::Tone::clamp), all_colours_) + status());
  }

  /// The two lines below the picture, cut to the terminal.
  std::string status() const {
    const std::size_t columns = Terminal::size().columns;
    std::string text;
    for (const std::string& line : lines_)
      text += fmt::format("\033[K{}{}", text::head(line, columns), &line == &lines_.back() ? "" : "\n");
    return text;
  }

  /// False where it is the end.
  bool answer(const TerminalInput& input) {
    using Kind = TerminalInput::Kind;
    switch (input.kind) {
      case Kind::character:
        return answer_key(input.character);
      case Kind::left:
        camera() = turned(camera(), -turn, 0);
        return true;
      case Kind::right:
        camera() = turned(camera(), turn, 0);
        return true;
      case Kind::up:
        camera() = turned(camera(), 0, turn);
        return true;
      case Kind::down:
        camera() = turned(camera(), 0, -turn);
        return true;
      case Kind::click:
        pick(input.column, 2 * input.row);
        return true;
      case Kind::nearer:
        return answer_key('+');
      case Kind::farther:
        return answer_key('-');
      case Kind::resized:
        return true;
      case Kind::told:
        read_again();
        return true;
      case Kind::end:
        return false;
    }
    return false;
  }

  bool answer_key(char key) {
    switch (key) {
      case '+':
      case '=':
        camera() = at_times_the_distance(camera(), nearer);
        return true;
      case '-':
        camera() = at_times_the_distance(camera(), 1 / nearer);
        return true;
      case 'w':
        camera() = moved(camera(), 0, step);
        return true;
      case 's':
        camera() = moved(camera(), 0, -step);
        return true;
      case 'a':
        camera() = moved(camera(), -step, 0);
        return true;
      case 'd':
        camera() = moved(camera(), step, 0);
        return true;
      case '\r':
      case '\n': {
        const scene::Resolution size = picture_size();
        pick(size.width / 2, size.height / 2);
        return true;
      }
      case 'c':
        if (picked_) camera() = looking_at(camera(), *picked_);
        return true;
      case '0':
        camera() = first_;
        return true;
      case 'q':
      case '\033':
      case '\004':  // Ctrl-D
        return false;
      default:
        return true;
    }
  }

  /// The first hit of the ray between two pixels that stand in one character.
  void pick(std::uint32_t x, std::uint32_t y) {
    if (y >= picture_size().height) return;
    const model::Rayo ray = scene::PrimaryRays(camera(), picture_size()).ray_at(x, y + 0.5);
    const scene::Hit hit = engine::first_hit(tracer_->engine(), {ray, {}});
    picked_.reset();
    lines_ = {"nothing is met there", std::string(keys_help)};
    if (hit.resultado != model::Resultado::hit) return;
    picked_ = hit.punto;
    std::string names;
    for (const scene::ElementRef element : hit.elementos)
      names += (names.empty() ? "" : ", ") + text::escaped(tracer_->scene().name(element).name());
    lines_ = {fmt::format("{}  t = {}", names, exact_t(ray, hit)),
              fmt::format("({}, {}, {})", hit.punto.x, hit.punto.y, hit.punto.z)};
  }

  /// In decimal digits, rounded once; of a surface that no table holds as many as a binary64 has.
  std::string exact_t(const model::Rayo& ray, const scene::Hit& hit) const {
    for (const scene::ElementRef element : hit.elementos)
      if (tracer_->is_by_text() || tracer_->scene().body(element) != nullptr) return fmt::format("{}", hit.t);
    const surface::exact::Reach reach = surface::exact::reach(tracer_->scene(), hit.elementos.front(), ray);
    return number::decimal_text(number::Surd(reach.first()), digits);
  }

  const ViewOptions& options_;
  FileWatch* const watch_;
  std::unique_ptr<const SceneTracer> tracer_{};
  scene::Scene shown_{};  // with the camera of the view
  scene::Camera first_{};
  bool has_lights_ = false;
  const bool all_colours_ = has_all_colours();
  std::optional<glm::dvec3> picked_{};
  std::vector<std::string> lines_{std::string(keys_help), ""};
};

}  // namespace

std::string_view view_keys() { return keys_help; }

scene::Camera show_in_terminal(const ViewOptions& options, FileWatch* watch) {
  return TerminalView(options, watch).run();
}

std::string camera_line(const scene::Camera& camera) {
  scene::Scene scene;
  scene.stage().camera = camera;
  const std::string text = io::scene_text(scene);
  const std::size_t begin = text.find("\"camera\"");
  return text.substr(begin, text.find('\n', begin) + 1 - begin);
}

}  // namespace durero::cli
