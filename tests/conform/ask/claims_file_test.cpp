#include "durero/conform/ask/claims_file.hpp"

#include <cmath>
#include <limits>

#include "durero/io/rays/npy.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SuiteCase small_case(const char* family, std::uint64_t number, std::size_t rays) {
  SuiteCase of;
  of.family = find_family(family);
  of.number = number;
  of.the_case = generate(*of.family, number, rays);
  return of;
}

/// Two cases, of 3 and 2 rays.
const std::vector<SuiteCase>& suite() {
  static const std::vector<SuiteCase> cases = {small_case("generic", 0, 3), small_case("tiny", 12, 2)};
  return cases;
}

std::vector<Claims> read(const std::string& name, const std::string& text) {
  return read_claims(io::Source(name, text), suite());
}

const auto as_json = [](const io::Source& source) { return read_claims(source, suite()); };
scene::ElementRef e0(std::size_t in_case) { return suite()[in_case].the_case.scene.find("e0").value(); }

std::string npy(const std::vector<double>& values, const char* shape) {
  std::string text = io::npy_head("'<f8'", shape);
  for (const double x : values) io::append_binary64(text, x);
  return text;
}

}  // namespace

TEST_CASE("claims are read from JSON lines in any order, and what has no line is unanswered") {
  const std::vector<Claims> claims = read("hits.jsonl", R"({"case":"tiny/0012","ray":1,"outcome":"miss"}

{"ray":0,"case":"generic/0000","outcome":"hit","element":"e0","t":"nan","point":[1,"inf",-2.5]}
{"case":"generic/0000","ray":2,"outcome":"hung"}
{"case":"tiny/0012","ray":0,"outcome":"crashed"}
)");
  REQUIRE(claims.size() == 2);
  REQUIRE(claims[0].size() == 3);
  CHECK(claims[0][0].outcome == Outcome::hit);
  CHECK(claims[0][0].element == e0(0));
  CHECK(std::isnan(claims[0][0].t.value()));
  CHECK(claims[0][0].punto == glm::dvec3(1, infinity, -2.5));
  CHECK(claims[0][1] == Claim{});
  CHECK(claims[0][2].outcome == Outcome::hung);
  CHECK(claims[1] == Claims{{Outcome::crashed}, {Outcome::miss}});
}

TEST_CASE("a claim reads back from its line") {
  const Claim whole{Outcome::hit, e0(1), 0.1, glm::dvec3(-0.0, 1e300, infinity)};
  Claim full = whole;
  full.normal = glm::dvec3(0, 0.1, -infinity);
  full.is_front = false;
  full.uv = glm::dvec2(0.1, -3);
  for (const Claim& claim : {whole, full, Claim{Outcome::hit, {}, 3.0, {}}, Claim{Outcome::miss},
                             Claim{.outcome = Outcome::hung, .why = "10 s"}}) {
    CHECK(read("f", claim_json(suite()[1], 1, claim))[1][1] == claim);
  }
  CHECK(claim_json(suite()[1], 1, whole) ==
        R"({"case":"tiny/0012","ray":1,"outcome":"hit","element":"e0","t":0.1,"point":[-0,1e+300,"inf"]})");
}

TEST_CASE("claims are read from CSV by the names of its columns") {
  const std::vector<Claims> claims = read("f.csv",
                                          "t,ray,case,element,x,y,z\r\n"
                                          "4, 0,generic/0000,e0,,,\r\n"
                                          ",1,generic/0000 ,,,,\r\n"
                                          "nan,2,generic/0000,,,,\n\n"
                                          ",1,tiny/0012,,1,2,3");
  CHECK(claims[0][0] == Claim{Outcome::hit, e0(0), 4.0, {}});
  CHECK(claims[0][1] == Claim{Outcome::miss});
  CHECK(std::isnan(claims[0][2].t.value()));
  CHECK(claims[1] == Claims{{}, {Outcome::hit, {}, {}, glm::dvec3(1, 2, 3)}});
  CHECK(read("f.csv", "case,ray,outcome,t\ntiny/0012,0,crashed,\n")[1][0] == Claim{Outcome::crashed});
}

TEST_CASE("a hit may name its element alone") {
  CHECK(read("f.csv", "case,ray,element\ngeneric/0000,0,e0\n")[0][0] == Claim{Outcome::hit, e0(0), {}, {}});
  CHECK(read("f.jsonl", R"({"case":"generic/0000","ray":0,"outcome":"hit","element":"e0"})")[0][0] ==
        Claim{Outcome::hit, e0(0), {}, {}});
}

TEST_CASE("claims are read from .npy in the order of the suite") {
  const std::vector<Claims> claims = read("f", npy({1, infinity, -2, 3, NAN}, "(5,)"));
  CHECK(claims[0] == Claims{{Outcome::hit, {}, 1.0, {}}, {Outcome::miss}, {Outcome::hit, {}, -2.0, {}}});
  CHECK(claims[1][0] == Claim{Outcome::hit, {}, 3.0, {}});
  CHECK(std::isnan(claims[1][1].t.value()));
  std::vector<double> with_points;
  for (int i = 0; i < 20; ++i) with_points.push_back(i);
  CHECK(read("f.npy", npy(with_points, "(5, 4)"))[1][0] == Claim{Outcome::hit, {}, 12.0, glm::dvec3(13, 14, 15)});
}

TEST_CASE("a line may list all hits, or give their number, and is written so") {
  const SuiteCase& of = suite()[0];
  const auto claim_in = [&](const std::string& line) { return read("f", line)[0][0]; };
  const std::string list =
      R"({"case":"generic/0000","ray":0,"outcome":"hit","hits":[{"element":"e0","t":4},{"point":[0,0,5],"face":"back"}]})";
  const Claim listed = claim_in(list);
  CHECK(listed.t == 4.0);
  REQUIRE(listed.behind.size() == 1);
  CHECK(listed.behind[0].punto == glm::dvec3(0, 0, 5));
  CHECK(listed.behind[0].is_front == false);
  CHECK(claim_json(of, 0, listed) == list);
  const std::string count = R"({"case":"generic/0000","ray":0,"outcome":"hit","count":2})";
  CHECK(claim_in(count).count == 2U);
  CHECK(claim_json(of, 0, claim_in(count)) == count);
}

TEST_CASE("what is no claim on a ray of the suite is refused at its place") {
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"hit","t":1,"hits":[{"t":2}]})", as_json) ==
        "f:1:61: hits beside the outcome hit and a hit; expected them with the outcome hit, one at least, in the place "
        "of element, t and point");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"hit","hits":[]})", as_json) ==
        "f:1:55: hits beside the outcome hit, and none of them; expected them with the outcome hit, one at least, in "
        "the place of element, t and point");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"miss","count":2})", as_json) ==
        "f:1:1: miss with count 2; expected a hit with a count from 1, or a miss with 0");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"hit","hits":[{"ray":1}]})", as_json)
            .starts_with("f:1:57: unknown key \"ray\" in a hit"));
  const std::string hit = R"({"case":"generic/0000","ray":0,"outcome":"hit","t":1})";
  CHECK(test::error_of(hit + "\n" + hit, as_json) == "f:2:30: ray 0 has a claim already; expected one a ray");
  CHECK(test::error_of(R"({"case":"none","ray":0,"outcome":"miss"})", as_json) ==
        "f:1:9: no case \"none\"; expected a case of the suite");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":3,"outcome":"miss"})", as_json) ==
        "f:1:30: ray 3 of 3; expected a ray of the case, from 0");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0.5,"outcome":"miss"})", as_json) ==
        "f:1:30: ray 0.5 of 3; expected a ray of the case, from 0");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"miss","t":1})", as_json) ==
        "f:1:1: miss with t or point; expected them of a hit alone");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"unanswered"})", as_json) ==
        "f:1:42: outcome is \"unanswered\"; expected hit, miss, crashed or hung");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"hit","element":"e99","t":1})", as_json) ==
        "f:1:58: no element \"e99\"; expected an element of the scene");
  CHECK(test::error_of(R"({"case":"generic/0000","ray":0,"outcome":"hit","t":"x"})", as_json) ==
        "f:1:52: t is \"x\"; expected a number, \"inf\" or \"-inf\"");
}

TEST_CASE("what is no CSV of claims is refused at its place") {
  CHECK_THROWS_WITH(read("f.csv", ""), "f.csv:1:1: the file is empty; expected a head that names the columns");
  CHECK_THROWS_WITH(read("f.csv", "case,ray,w"),
                    "f.csv:1:10: no column \"w\"; expected case, ray, outcome, element, t, x, y or z");
  CHECK_THROWS_WITH(read("f.csv", "case,ray,case"), "f.csv:1:10: a second column \"case\"; expected it once");
  CHECK_THROWS_WITH(read("f.csv", "case,t"), "f.csv:1:1: no column \"ray\"; expected case and ray");
  CHECK_THROWS_WITH(read("f.csv", "case,ray,t\ngeneric/0000,0"),
                    "f.csv:2:1: 2 fields; expected 3, as many as the head");
  CHECK_THROWS_WITH(read("f.csv", "case,ray,t\ngeneric/0000,0,1e"), "f.csv:2:16: \"1e\" in a claim; expected a number");
  CHECK_THROWS_WITH(read("f.csv", "case,ray,x,y,z\ngeneric/0000,0,1,,"),
                    "f.csv:2:18: \"\" in a claim; expected a number");
}

TEST_CASE("what is no .npy of claims is refused") {
  CHECK_THROWS_WITH(read("f.npy", npy({1, 2}, "(2,)")), "f.npy:1:1: 2 rows; expected 5, one a ray");
  CHECK_THROWS_WITH(read("f.npy", npy({1, 2}, "(1, 2)")),
                    "f.npy:1:1: 2 columns; expected t, or t and the point: (n,) or (n, 4)");
}
