#include "conform/ask/asker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "durero/conform/ask/question.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

/// The number of lines that a system may write before its name and version, as libraries do when they are loaded.
constexpr int preamble_lines = 100;
/// The time that a system has to end after its input was closed.
constexpr Seconds to_close{5};

/// The bytes of a line of a system that lists all hits.
constexpr std::size_t line_of_all_hits = 1 << 20;

/// The last line of a text that is not empty.
std::string last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \r\n") + 1;
  const std::size_t begin = text.substr(0, end).find_last_of('\n') + 1;
  return text::escaped(text.substr(begin, end - begin));
}

bool is_death(const Claim& claim) {
  return claim.outcome == Claim::Outcome::crashed || claim.outcome == Claim::Outcome::hung;
}

}  // namespace

bool Asker::ask(const SuiteCase& of, std::span<const std::size_t> rays, std::span<Claim> claims) {
  hung_of_scene_ = 0;
  if (says_.empty()) start();
  if (*stop_) return false;
  return rays.empty() || ask_rays(of, rays, claims);
}

void Asker::close() {
  if (!child_) return;
  const bool spoke = child_->close(to_close);
  end_child();
  if (spoke && !*stop_)
    throw ProtocolBreach(
        fmt::format("{}: lines after the last answer; expected one a ray, so none can be believed", system_->name));
}

void Asker::start() {
  const std::string folder = std::filesystem::exists(system_->setup) ? system_->setup : "";
  ChildLimits limits{.memory = options_.memory, .folder = folder};
  const auto& questions = system_->profile.questions;
  if (std::ranges::find(questions, QuestionKind::all) != questions.end()) limits.line = line_of_all_hits;
  child_ = std::make_unique<Child>(system_->ask, limits, *stop_);
  std::string line;
  bool is_late = false;
  for (int lines = 0; lines < preamble_lines; ++lines) {
    const Child::Event event = child_->next_line(options_.time_to_start, line);
    if (event == Child::Event::stopped) return;
    is_late = event == Child::Event::late;
    if (event != Child::Event::line) break;
    if (const auto says = read_system_line(line)) {
      says_ = *says;
      return;
    }
  }
  const std::string ended = child_->end();
  const std::string how = !is_late ? ended
                                   : fmt::format(
                                         "no such line in {} s, though one that was not flushed may wait in its "
                                         "buffer",
                                         options_.time_to_start.count());
  const std::string said = last_line(child_->last_words());
  child_.reset();
  throw std::runtime_error(fmt::format("{}: it does not start{}{}; expected a line: system NAME VERSION", system_->name,
                                       how.empty() ? "" : ", " + how, said.empty() ? "" : ", " + said));
}

void Asker::end_child() {
  if (!child_) return;
  child_->end();
  if (!child_->last_words().empty()) last_words_ = child_->last_words();
  child_.reset();
}

void Asker::require_silence() {
  if (!child_->has_more()) return;
  throw ProtocolBreach(fmt::format("{}: more lines than rays, {}; expected one a ray, so none can be believed",
                                   system_->name, last_scene_.empty() ? "before the first" : "up to " + last_scene_));
}

Asker::Attempt Asker::attempt(const SuiteCase& of, std::span<const std::size_t> rays, std::span<Claim> claims) {
  if (!child_) start();
  if (*stop_) return {0, Child::Event::stopped};
  require_silence();
  last_scene_ = of.name();
  child_->tell(question_text(of, system_->profile.caps, rays));
  std::string line;
  const Seconds to_build{0.01 * static_cast<double>(of.the_case.scene.size())};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Child::Event event = child_->next_line(i == 0 ? options_.time + to_build : options_.time, line);
    if (event == Child::Event::line) {
      claims[rays[i]] = read_answer(line, of, system_->profile.caps);
      continue;
    }
    const std::string how = child_->end();
    end_child();
    if (event != Child::Event::stopped) ++deaths_;
    return {i, event, how};
  }
  require_silence();
  return {rays.size(), Child::Event::line};
}

Claim Asker::death(const Attempt& attempt) {
  if (attempt.event == Child::Event::ended) return {.outcome = Claim::Outcome::crashed, .why = attempt.how};
  ++hung_of_scene_;
  return {.outcome = Claim::Outcome::hung, .why = fmt::format("no answer in {} s", options_.time.count())};
}

bool Asker::ask_rays(const SuiteCase& of, std::span<const std::size_t> rays, std::span<Claim> claims) {
  if (rays.empty()) return true;
  if (hung_of_scene_ >= options_.hung_of_scene) {
    for (const std::size_t ray : rays) claims[ray] = {.why = "not asked: other rays of the scene hung"};
    return true;
  }
  const Attempt all = attempt(of, rays, claims);
  if (all.event == Child::Event::line) return true;
  if (all.event == Child::Event::stopped) return false;
  if (rays.size() > 1) return ask_after_death(of, rays, all.answered, claims);
  claims[rays.front()] = death(all);
  return true;
}

bool Asker::ask_after_death(const SuiteCase& of, std::span<const std::size_t> rays, std::size_t suspect,
                            std::span<Claim> claims) {
  if (!ask_rays(of, rays.subspan(suspect, 1), claims)) return false;
  const bool was_it = is_death(claims[rays[suspect]]);
  const std::size_t middle = was_it ? suspect : rays.size() / 2;
  std::vector<std::size_t> others[2];
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (i != suspect) others[i < middle ? 0 : 1].push_back(rays[i]);
  }
  return ask_rays(of, others[0], claims) && ask_rays(of, others[1], claims);
}

}  // namespace durero::conform
