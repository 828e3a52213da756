#pragma once
/// Camera, light and material as tables of fields: what a scene file holds of them, read and written, and what the
/// numbers must be, whatever file they come from.

#include <fmt/core.h>

#include "durero/model/distribuida.hpp"
#include "durero/scene/stage.hpp"
#include "extent_fields.hpp"
#include "field.hpp"

namespace durero::io {

inline bool is_direction(const glm::dvec3& v) { return v != glm::dvec3{}; }
inline bool is_view_angle(const double& angle) { return angle > 0 && angle < 180; }
inline bool is_color(const glm::dvec3& c) { return c.x >= 0 && c.y >= 0 && c.z >= 0; }
inline bool is_share_of_all(const double& k) { return k >= 0 && k <= 1; }
inline bool is_exponent(const double& e) { return e >= 0; }
inline bool is_inner_angle(const double& angle) { return angle >= 0 && angle <= 90; }
inline bool is_outer_angle(const double& angle) { return angle > 0 && angle <= 90; }
inline bool is_index(const double& index) { return index > 0; }
inline bool is_share(const glm::dvec3& c) { return is_color(c) && c.x <= 1 && c.y <= 1 && c.z <= 1; }

/// The most pixels of a side of a picture: their square is past every picture that fits in memory.
inline constexpr int most_pixels = 65535;

inline constexpr Rule<glm::dvec3> direction{is_direction, "the null vector", "a direction"};
template <class Value>
bool is_any(const Value&) {
  return true;
}
/// Of what is read whole, with its own errors.
template <class Value>
inline constexpr Rule<Value> as_read{is_any<Value>, "", ""};

inline constexpr Rule<double> view_angle{is_view_angle, "", "an angle in degrees, above 0 and below 180"};
inline constexpr Rule<double> inner_angle{is_inner_angle, "", "an angle in degrees, from 0 to 90"};
inline constexpr Rule<double> outer_angle{is_outer_angle, "", "an angle in degrees, above 0, up to 90"};
inline constexpr Rule<glm::dvec3> light_color{is_color, "negative", "red, green and blue, each from 0"};
inline constexpr Rule<glm::dvec3> share{is_share, "no share of light", "red, green and blue, each from 0 to 1"};
inline constexpr Rule<double> share_of_all{is_share_of_all, "", "a share of light, 0 to 1"};
inline constexpr Rule<double> exponent{is_exponent, "", "a number from 0"};
inline constexpr Rule<double> refractive_index{is_index, "", "a number above 0"};
inline constexpr Rule<double> from_zero = exponent, above_zero = refractive_index;

/// Fails at that byte where the light of a cone would end before it stops being full. `In` is what reads.
template <class In>
void check_cone(const In& in, std::size_t at, const scene::LightCone& cone) {
  if (cone.inner > cone.outer)
    in.fail(at, fmt::format("the light is full up to {} degrees and ends at {}", cone.inner, cone.outer),
            "expected an end no sooner (Cono_de_Luz.inv.2)", &model::Cono_de_Luz_inv_2);
}

/// Fails at that byte where the cone of a light leads to its own place.
template <class In>
void check_axis(const In& in, std::size_t at, const scene::Light& light) {
  if (light.cone && light.cone->towards == light.position)
    in.fail(at, "the cone of a light leads to its own place", "expected another place (Cono_de_Luz.inv.1)",
            &model::Cono_de_Luz_inv_1);
}

using scene::Camera;
using scene::DirectionalLight;
using scene::Light;
using scene::Material;
using scene::Stage;

inline constexpr std::tuple camera_fields = {
    Field<Camera, glm::dvec3>{"eye", &Camera::eye, any_triple},
    Field<Camera, glm::dvec3>{"look_at", &Camera::look_at, any_triple},
    Field<Camera, glm::dvec3>{"up", &Camera::up, direction},
    Field<Camera, double>{"fov_y", &Camera::fov_y, view_angle},
    Field<Camera, double>{"aperture", &Camera::aperture, from_zero, &model::Lente_inv_2},
    Field<Camera, double>{"focus", &Camera::focus, above_zero, &model::Lente_inv_3},
    Field<Camera, double>{"shutter", &Camera::shutter, from_zero},
    Field<Camera, glm::dvec3>{"motion", &Camera::motion, any_triple},
    Field<Camera, bool>{"mirrored", &Camera::mirrored, as_read<bool>}};
/// The first of them stand in every camera.
inline constexpr std::size_t required_of_camera = 4;

inline constexpr std::tuple light_fields = {
    Field<Light, glm::dvec3>{"position", &Light::position, any_triple},
    Field<Light, glm::dvec3>{"color", &Light::color, light_color, &model::Fuente_inv_1},
    Field<Light, scene::LightExtent>{"disc", &Light::extent, as_read<scene::LightExtent>},
    Field<Light, scene::LightExtent>{"sphere", &Light::extent, as_read<scene::LightExtent>},
    Field<Light, scene::LightExtent>{"triangle", &Light::extent, as_read<scene::LightExtent>},
    Field<Light, scene::LightExtent>{"rectangle", &Light::extent, as_read<scene::LightExtent>},
    Field<Light, std::optional<scene::LightCone>>{"spot", &Light::cone, as_read<std::optional<scene::LightCone>>}};
/// The first of them stand in every light, and one shape at most.
inline constexpr std::size_t required_of_light = 2;

inline constexpr std::tuple directional_light_fields = {
    Field<DirectionalLight, glm::dvec3>{"direction", &DirectionalLight::direction, direction},
    Field<DirectionalLight, glm::dvec3>{"color", &DirectionalLight::color, light_color, &model::Fuente_inv_1}};

/// Of a material but for its name, which is the key that it stands under.
inline constexpr std::tuple material_fields = {
    Field<Material, glm::dvec3>{"color", &Material::color, share, &model::Material_inv_6},
    Field<Material, double>{"k_a", &Material::k_a, share_of_all, &model::Material_inv_1},
    Field<Material, double>{"k_d", &Material::k_d, share_of_all, &model::Material_inv_2},
    Field<Material, double>{"k_s", &Material::k_s, share_of_all, &model::Material_inv_3},
    Field<Material, double>{"e", &Material::e, exponent, &model::Material_inv_11},
    Field<Material, double>{"k_ps", &Material::k_ps, share_of_all, &model::Material_inv_4},
    Field<Material, glm::dvec3>{"M_PS", &Material::M_PS, share, &model::Material_inv_7},
    Field<Material, double>{"gloss", &Material::gloss, from_zero},
    Field<Material, double>{"k_t", &Material::k_t, share_of_all, &model::Material_inv_5},
    Field<Material, glm::dvec3>{"M_T", &Material::M_T, share, &model::Material_inv_8},
    Field<Material, double>{"index", &Material::index, refractive_index, &model::Material_inv_12},
    Field<Material, glm::dvec3>{"emission", &Material::emission, light_color, &model::Material_inv_9},
    Field<Material, glm::dvec3>{"ambient", &Material::ambient, light_color, &model::Material_inv_10},
    Field<Material, scene::TextureUses>{"textures", &Material::textures, as_read<scene::TextureUses>},
    Field<Material, std::optional<scene::Bump>>{"bump", &Material::bump, as_read<std::optional<scene::Bump>>}};
/// The first of them stands in every material.
inline constexpr std::size_t required_of_material = 1;

/// NFF's view, but for what is no part of a camera.
inline constexpr std::tuple view_fields = {Field<Camera, glm::dvec3>{"from", &Camera::eye, any_triple},
                                           Field<Camera, glm::dvec3>{"at", &Camera::look_at, any_triple},
                                           Field<Camera, glm::dvec3>{"up", &Camera::up, direction},
                                           Field<Camera, double>{"angle", &Camera::fov_y, view_angle}};

}  // namespace durero::io
