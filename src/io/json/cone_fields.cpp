#include "cone_fields.hpp"

#include "stage_fields.hpp"

namespace durero::io {
namespace {

using scene::LightCone;

constexpr std::tuple cone_fields = {
    Field<LightCone, glm::dvec3>{"towards", &LightCone::towards, any_triple},
    Field<LightCone, double>{"inner", &LightCone::inner, inner_angle, &model::Cono_de_Luz_inv_2},
    Field<LightCone, double>{"outer", &LightCone::outer, outer_angle, &model::Cono_de_Luz_inv_2},
    Field<LightCone, double>{"tightness", &LightCone::tightness, from_zero, &model::Cono_de_Luz_inv_3}};
/// The first of them stand in every cone.
constexpr std::size_t required_of_cone = 1;

}  // namespace

void read_json(json::Reader& in, std::string_view what, std::optional<LightCone>& cone) {
  const std::size_t at = in.offset();
  read_fields(in, what, cone_fields, cone.emplace(), required_of_cone);
  check_cone(in, at, *cone);
}

void write_member(json::Writer& out, std::string_view key, const std::optional<LightCone>& cone) {
  if (cone) write_fields(out.key(key), cone_fields, *cone, required_of_cone);
}

}  // namespace durero::io
