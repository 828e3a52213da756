#include "conform/judge/text_space.hpp"

#include <fstream>

#include "conform/mover.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/io/json/scene_file.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"
#include "support/shapes.hpp"
#include "support/tree.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

using Values = std::vector<io::WrittenValue>;
using Outcome = Claim::Outcome;

/// A text and an element of it, near the origin.
struct TextElement {
  std::string file, type;
  Values values;
  glm::dvec3 middle{0};
};

std::shared_ptr<const written::Text> text_of(const std::string& file) {
  static std::map<std::string, std::shared_ptr<const written::Text>> known;
  std::shared_ptr<const written::Text>& text = known[file];
  if (!text) text = std::make_shared<const written::Text>(test::source_dir() + "/demo/surfaces/" + file);
  return text;
}

using Named = std::map<std::string, io::WrittenValue>;

/// The element of these attributes, in the order of its type.
TextElement element(const std::string& file, const std::string& type, const Named& attributes) {
  TextElement of{file, type, {}};
  for (const io::WrittenType& known : text_of(file)->types()) {
    if (known.word != type) continue;
    for (const io::WrittenAttribute& attribute : known.attributes) of.values.push_back(attributes.at(attribute.word));
  }
  of.middle = std::get<glm::dvec3>(attributes.at("centro"));
  return of;
}

using V = glm::dvec3;

/// A quartic of POV-Ray's: the 35 coefficients of a torus with the radii 2 and 1/2.
TextElement quartic() {
  const V none(0);
  return element("algebraic.tex", "cuartica",
                 {{"centro", V(0.5, 0, 0.25)},
                  {"x", V(1, 0, 0.125)},
                  {"y", V(0, 1.5, 0)},
                  {"z", V(-0.25, 0, 1)},
                  {"xxxx", 1.0},
                  {"xxx", none},
                  {"xx_1", V(2, 0, 2)},
                  {"xx_2", V(0, 0, -8.5)},
                  {"x_1", none},
                  {"x_2", none},
                  {"x_3", none},
                  {"x_4", 0.0},
                  {"c_1", V(1, 0, 0)},
                  {"c_2", V(2, 0, 7.5)},
                  {"c_3", none},
                  {"c_4", V(0, 1, 0)},
                  {"c_5", V(-8.5, 0, 14.0625)}});
}

std::vector<TextElement> elements() {
  return {element("torus.tex", "toro", {{"centro", V(0.25, 0, -0.5)}, {"mayor", 2.0}, {"menor", 0.75}}),
          element("torus.tex", "toro", {{"centro", V(64, 128, -32)}, {"mayor", 2.0}, {"menor", 0.0625}}),
          element("ellipsoid.tex", "elipsoide",
                  {{"centro", V(-0.75, 0, 0)}, {"ancho", 2.0}, {"alto", 1.0}, {"hondo", 1.25}}),
          element("hyperboloid.tex", "hiperboloide",
                  {{"centro", V(0, 0.5, 0)}, {"cintura", 0.875}, {"pendiente", 0.75}, {"altura", 1.75}}),
          element("cubic.tex", "clebsch", {{"centro", V(0.125, 0, 0)}, {"radio", 2.0}}),
          element("instances.tex", "cono_oblicuo",
                  {{"centro", V(0, -1, 0)}, {"x", V(0.5, 0, 0.25)}, {"y", V(0.25, 0, -0.75)}, {"z", V(0.5, 2, 0)}}),
          element("algebraic.tex", "toro_oblicuo",
                  {{"centro", V(0, 0, 1)},
                   {"x", V(1, 0.25, 0)},
                   {"y", V(0, 1, 0)},
                   {"z", V(0.5, 0, 1)},
                   {"mayor", 1.5},
                   {"menor", 0.5}}),
          quartic()};
}

AskedSurface surface_of(const TextElement& of) {
  const auto text = text_of(of.file);
  return {text, of.type, of.values, text->surface(of.type, of.values)};
}

constexpr scene::ElementRef the_surface{scene::Sphere::tipo, 0};

/// The answered case of one surface and one ray.
SuiteCase asked(const TextElement& of, const model::Rayo& rayo, QuestionKind question = QuestionKind::first,
                std::optional<AskedRange> range = {}) {
  scene::Scene scene;
  scene.add(model::Elemento("e0"), scene::Sphere{{0, 0, 0}, 1});

  SuiteCase result = own_case(std::move(scene), {{rayo, {}}});
  result.surfaces.push_back({the_surface, surface_of(of)});
  result.question = question;
  if (range) result.ranges.push_back(*range);
  answer(result);
  return result;
}

Profile profile_of(NumberFormat format) {
  return {.format = format,
          .surfaces = {"toro", "elipsoide", "hiperboloide", "clebsch", "cono_oblicuo", "toro_oblicuo", "cuartica"}};
}

Verdict verdict(const SuiteCase& of, const Claim& claim, NumberFormat format = NumberFormat::binary64) {
  return judge(of, 0, claim, profile_of(format)).verdict;
}
bool is_right(Verdict is) { return is == Verdict::exact || is == Verdict::right; }

Claim hit_at(double t) { return {.outcome = Outcome::hit, .element = the_surface, .t = t}; }
Claim miss() { return {.outcome = Outcome::miss}; }

/// The claim of a program that answers exactly, and rounds once to the format.
Claim exact_claim(const SuiteCase& of, NumberFormat format) {
  const ExactAnswer& truth = of.truths[0];
  const auto number = [&](double t) { return test::narrowed(t, format); };
  if (of.question == QuestionKind::count) return {.outcome = Outcome::hit, .count = truth.all.size()};
  if (of.question == QuestionKind::all) {
    if (truth.all.empty()) return miss();
    Claim first = hit_at(number(truth.all[0].t));
    for (std::size_t i = 1; i < truth.all.size(); ++i) first.behind.push_back(hit_at(number(truth.all[i].t)));
    return first;
  }
  return truth.hit.resultado == model::Resultado::miss ? miss() : hit_at(number(truth.hit.t));
}

/// Moves the numbers of an element and of a ray by what the allowance says of them. It uses nothing of the judge's.
class TextMover {
 public:
  TextMover(Random& random, NumberFormat format)
      : random_(&random), u_(format == NumberFormat::binary32 ? 0x1p-20 : 0x1p-49) {}

  TextElement moved(TextElement of) {
    for (io::WrittenValue& value : of.values) {
      if (auto* const x = std::get_if<double>(&value)) *x += part() * std::abs(*x);
      if (auto* const v = std::get_if<glm::dvec3>(&value)) *v = moved(*v);
    }
    return of;
  }
  model::Rayo moved(const model::Rayo& rayo) {
    return {model::Punto(moved(rayo.p().xyz())), model::Vector(moved(rayo.v().xyz()))};
  }

 private:
  glm::dvec3 moved(glm::dvec3 v) {
    const double most = test::longest(v);
    for (int i = 0; i < 3; ++i) v[i] += part() * most;
    return v;
  }
  double part() { return u_ * (random_->chance(1, 2) ? 0.9375 * random_->sign() : random_->uniform(-0.9375, 0.9375)); }

  Random* random_;
  double u_;
};

/// A ray from around an element towards it.
model::Rayo ray_towards(Random& random, const TextElement& of) {
  const glm::dvec3 p = of.middle + random.in_cube(5), at = of.middle + random.in_cube(2);
  return {model::Punto(p), model::Vector(at - p)};
}

constexpr QuestionKind asked_kinds[] = {QuestionKind::first, QuestionKind::shadow, QuestionKind::range,
                                        QuestionKind::all, QuestionKind::count};

/// The end of a ray, or both: near its first hit, where there is one.
std::optional<AskedRange> range_for(QuestionKind kind, const SuiteCase& of, Random& random) {
  if (!has_range(kind)) return std::nullopt;
  const double t = of.truths[0].hit.resultado == model::Resultado::hit ? of.truths[0].hit.t : 1;
  const double near = t * (1 + random.signed_power(-52, -1));
  if (kind == QuestionKind::shadow) return AskedRange{0, near};
  return random.chance(1, 2) ? AskedRange{near, 2 * near} : AskedRange{near / 4, near};
}

}  // namespace

TEST_CASE("an exact program whose data are off within the allowance is right about surfaces of a text") {
  Random random(20261129);
  for (const NumberFormat format : {NumberFormat::binary32, NumberFormat::binary64}) {
    TextMover mover(random, format);
    for (const TextElement& element : elements()) {
      for (int i = 0; i < 30; ++i) {
        const model::Rayo rayo = ray_towards(random, element);
        const SuiteCase first = asked(element, rayo);
        const QuestionKind kind = asked_kinds[i % 5];
        const auto range = range_for(kind, first, random);
        const SuiteCase given = asked(element, rayo, kind, range);
        const SuiteCase moved = asked(mover.moved(element), mover.moved(rayo), kind, range);
        Claim claim = exact_claim(moved, format);
        if (kind == QuestionKind::shadow)
          claim = {.outcome = claim.outcome == Outcome::hit && *claim.t <= range->end ? Outcome::hit : Outcome::miss};
        INFO(element.type << " ray " << i << " question " << word(kind));
        CHECK(is_right(verdict(given, claim, format)));
      }
    }
  }
}

namespace {

/// A fault of a program: what it claims where the exact answers are these, if the fault shows there.
struct TextFault {
  std::string_view name;
  QuestionKind question;
  std::optional<Claim> (*claim)(const std::vector<double>& ts);
};

Claim hits_at(const std::vector<double>& ts) {
  if (ts.empty()) return miss();
  Claim first = hit_at(ts[0]);
  for (std::size_t i = 1; i < ts.size(); ++i) first.behind.push_back(hit_at(ts[i]));
  return first;
}
Claim count_of(std::size_t count) { return {.outcome = Outcome::hit, .count = count}; }

using Ts = std::vector<double>;
using Faulty = std::optional<Claim>;

constexpr TextFault text_faults[] = {
    {"first crossing lost", QuestionKind::first,
     [](const Ts& ts) { return ts.size() > 1 ? Faulty(hit_at(ts[1])) : std::nullopt; }},
    {"hit lost", QuestionKind::first, [](const Ts& ts) { return ts.empty() ? std::nullopt : Faulty(miss()); }},
    {"hit where there is none", QuestionKind::first,
     [](const Ts& ts) { return ts.empty() ? Faulty(hit_at(1)) : std::nullopt; }},
    {"t a little too large", QuestionKind::first,
     [](const Ts& ts) { return ts.empty() ? std::nullopt : Faulty(hit_at(ts[0] * (1 + 0x1p-36))); }},
    {"t a little too small", QuestionKind::first,
     [](const Ts& ts) { return ts.empty() ? std::nullopt : Faulty(hit_at(ts[0] * (1 - 0x1p-36))); }},
    {"crossing behind the origin", QuestionKind::first,
     [](const Ts& ts) { return ts.empty() ? std::nullopt : Faulty(hit_at(-ts[0])); }},
    {"shadow lost", QuestionKind::shadow, [](const Ts& ts) { return ts.empty() ? std::nullopt : Faulty(miss()); }},
    {"shadow where there is none", QuestionKind::shadow,
     [](const Ts& ts) { return ts.empty() ? Faulty(Claim{.outcome = Outcome::hit}) : std::nullopt; }},
    {"begin of a range forgotten", QuestionKind::range,
     [](const Ts& ts) { return ts.size() > 1 ? Faulty(hit_at(ts[0])) : std::nullopt; }},
    {"last crossing lost", QuestionKind::all,
     [](const Ts& ts) {
       return ts.empty() ? std::nullopt : Faulty(hits_at({ts.begin(), ts.end() - 1}));
     }},
    {"crossing twice", QuestionKind::all,
     [](const Ts& ts) {
       Ts twice(ts);
       if (!ts.empty()) twice.insert(twice.begin(), ts[0]);
       return ts.empty() ? std::nullopt : Faulty(hits_at(twice));
     }},
    {"crossings in the other order", QuestionKind::all,
     [](const Ts& ts) {
       return ts.size() > 1 ? Faulty(hits_at({ts.rbegin(), ts.rend()})) : std::nullopt;
     }},
    {"one too few", QuestionKind::count,
     [](const Ts& ts) { return ts.empty() ? std::nullopt : Faulty(count_of(ts.size() - 1)); }},
    {"one too many", QuestionKind::count, [](const Ts& ts) { return Faulty(count_of(ts.size() + 1)); }}};

/// The range that a fault is asked about: of a shadow ray, far behind the first crossing; otherwise from between the
/// first two.
std::optional<AskedRange> range_of(QuestionKind kind, const Ts& ts) {
  if (kind == QuestionKind::shadow) return AskedRange{0, ts.empty() ? 1e6 : 2 * ts[0]};
  if (kind == QuestionKind::range && ts.size() > 1) return AskedRange{(ts[0] + ts[1]) / 2, 1e6};
  return kind == QuestionKind::range ? std::optional(AskedRange{}) : std::nullopt;
}

Ts crossings_of(const TextElement& element, const model::Rayo& rayo) {
  Ts all;
  const SuiteCase of = asked(element, rayo, QuestionKind::all);
  for (const scene::Hit& hit : of.truths[0].all) all.push_back(hit.t);
  return all;
}

}  // namespace

TEST_CASE("faults about surfaces of a text are seen") {
  for (const TextFault& fault : text_faults) {
    Random random(7);
    std::size_t shown = 0, seen = 0;
    for (const TextElement& element : elements()) {
      for (int i = 0; i < 12; ++i) {
        const model::Rayo rayo = ray_towards(random, element);
        const Ts ts = crossings_of(element, rayo);
        const std::optional<Claim> claim = fault.claim(ts);
        if (!claim) continue;
        ++shown;
        if (!is_right(verdict(asked(element, rayo, fault.question, range_of(fault.question, ts)), *claim))) ++seen;
      }
    }
    INFO(fault.name << ": " << seen << " of " << shown);
    CHECK(shown > 15);
    CHECK(seen * 10 >= shown * 9);
  }
}

TEST_CASE("data that are off by 64 times the allowance give answers that are off") {
  Random random(11);
  std::size_t shown = 0, seen = 0;
  for (const TextElement& element : elements()) {
    for (int i = 0; i < 12; ++i) {
      const model::Rayo rayo = ray_towards(random, element);
      TextElement larger = element;
      for (io::WrittenValue& value : larger.values) {
        if (auto* const x = std::get_if<double>(&value)) *x *= 1 + 0x1p-43;
      }
      const SuiteCase moved = asked(larger, rayo);
      if (larger.values == element.values || moved.truths[0].hit.resultado != model::Resultado::hit) continue;
      ++shown;
      if (verdict(asked(element, rayo), exact_claim(moved, NumberFormat::binary64)) == Verdict::off) ++seen;
    }
  }
  INFO(seen << " of " << shown);
  CHECK(shown > 30);
  CHECK(seen * 2 > shown);
}

TEST_CASE("a surface of a text is outside a profile that does not name its type, and has no inside") {
  const TextElement torus = elements()[0];
  const SuiteCase of = asked(torus, test::ray(glm::dvec3(0.25, 0, -2.5), glm::dvec3(1, 0, 0)));
  const Profile without{.format = NumberFormat::binary64, .tipos = {model::Tipo::soy_esfera}};
  const ClaimJudgement is = judge(of, 0, miss(), without);
  CHECK(is.verdict == Verdict::skipped);
  CHECK(is.clause == "no toro");
  Profile of_solids = profile_of(NumberFormat::binary64);
  of_solids.inside = Inside::nothing;
  CHECK(judge(of, 0, miss(), of_solids).verdict == Verdict::missed);
  of_solids.inside = Inside::undefined;
  CHECK(judge(of, 0, exact_claim(of, NumberFormat::binary64), of_solids).verdict == Verdict::exact);
}
