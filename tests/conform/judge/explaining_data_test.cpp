#include "durero/conform/judge/explaining_data.hpp"

#include <cmath>

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

const Profile all = test::profile_of_all();

/// The data of a failure, of which the claim is right; they are no nearer than is proved.
ExplainingData explained(const Finding& finding, const Profile& profile) {
  const auto data = explaining_data(finding, profile);
  REQUIRE(data);
  REQUIRE(data->nearest);
  const Verdict verdict = judge(data->nearest->of, 0, finding.claim, profile).verdict;
  CHECK((verdict == Verdict::exact || verdict == Verdict::right));
  CHECK(data->nearest->off > std::ldexp(1, data->excluded.value_or(0)) - 16);
  return *data;
}

}  // namespace

TEST_CASE("a misplaced hit is explained by a radius, or by another place") {
  const auto data = explained(test::finding_of(test::sphere_case({0, 0, 0}, {0, 0, 1}), test::hit_at(3.25), all), all);
  CHECK(data.epsilon == 0x1p-53);
  CHECK(data.M == 4);
  CHECK(data.nearest->off == 0.25 / (4 * 0x1p-53));
  CHECK(data.nearest->of.truths[0].hit.t == 3.25);
  REQUIRE(data.excluded);
  CHECK(*data.excluded >= 45);  // 0.25 = 2^49 ε·M, of which a sphere and a ray share some seven
  CHECK(*data.excluded < 49);
  const std::string text = explaining_text(data, all);
  CHECK(text.find("ε = 2^-53, M = 4\n") != text.npos);
  CHECK(text.find("are off by 2^49.0 ε·M, 0.25:\nscene generic/0000\nesfera e0 0 0 4 0.75\n") != text.npos);
}

TEST_CASE("a hit that is off by little is explained by little") {
  const double t = 3 + 0x1p-40;
  const auto data = explained(test::finding_of(test::sphere_case({0, 0, 0}, {0, 0, 1}), test::hit_at(t), all), all);
  CHECK(std::log2(data.nearest->off) < 12);
  CHECK(data.excluded.value_or(0) < 12);
}

TEST_CASE("a missed sphere is explained by one that the ray does not meet, and no nearer one") {
  const SuiteCase of = test::sphere_case({0.5, 0, 0}, {0, 0, 1});
  const auto data = explained(test::finding_of(of, test::miss(), all), all);
  CHECK(data.nearest->of.truths[0].hit.resultado == model::Resultado::miss);
  const double moved = data.nearest->off * data.epsilon * data.M;
  CHECK(moved >= 0.49);  // the ray is half the radius inside
  CHECK(moved <= 1);
}

TEST_CASE("of a phantom, a wrong element and every kind of element the data found have the claim as their answer") {
  const auto claim = test::hit_at(3);
  explained(test::finding_of(test::sphere_case({1.5, 0, 0}, {0, 0, 1}), claim, all), all);
  const glm::dvec3 c(0, 0, 4), x(1, 0, 0), z(0, 0, 1), p(0.25, 0.125, 0);
  const scene::Corners corners = {glm::dvec3(-4, -4, 4), {4, -4, 4}, {0, 4, 4}};
  const std::vector<AskedShape> shapes = {
      scene::Cylinder{.centro = c - 4.0 * x, .radio = 1.5, .vector = x, .altura = 8},
      scene::Cone{.centro = c, .proporcion = 0.5, .vector = -z, .altura = 3},
      scene::TruncatedCone{.centro = c, .radio = 0.25, .proporcion = 0.5, .vector = -z, .altura = 3},
      scene::Plane{c, z},
      scene::Disc{.centro = c, .radio = 2, .vector = z},
      scene::Triangle{corners}};
  for (const AskedShape& shape : shapes) {
    const SuiteCase of = test::drafted({{"e0", shape}}, p, z);
    const Finding finding = test::finding_of(of, test::hit_at(of.truths[0].hit.t + 0.25), all);
    REQUIRE(is_failure(finding.judgement.verdict));
    explained(finding, all);
  }
}

TEST_CASE("a length and a point are understood as the profile says, and a thickness counts") {
  Profile length = all;
  length.measure = Measure::length;
  length.format = NumberFormat::binary32;
  const auto data =
      explained(test::finding_of(test::sphere_case({0, 0, 0}, {0, 0, 2}), test::hit_at(3.5), length), length);
  CHECK(data.epsilon == 0x1p-24);
  CHECK(data.nearest->of.truths[0].hit.t == 1.75);
  Claim of_point{Claim::Outcome::hit, {}, {}, glm::dvec3(0, 0, 3.5)};
  Profile point = all;
  point.measure = Measure::point;
  CHECK(explained(test::finding_of(test::sphere_case({0, 0, 0}, {0, 0, 2}), of_point, point), point).M == 4);
}

TEST_CASE("what no data can explain has none") {
  const SuiteCase of = test::sphere_case({0, 0, 0}, {0, 0, 1});
  CHECK(!explaining_data(test::finding_of(of, {Claim::Outcome::crashed}, all), all));
  CHECK(!explaining_data(test::finding_of(of, test::hit_at(NAN), all), all));
  CHECK(!explaining_data(test::finding_of(of, test::hit_at(3), all), all));  // it is right
  const auto far = explaining_data(test::finding_of(of, test::hit_at(-1e6), all), all);
  REQUIRE(far);
  CHECK(!far->nearest);
  CHECK(explaining_text(*far, all).find("and none were found") != std::string::npos);
}
