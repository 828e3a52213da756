#pragma once
/// A fragment shader draws a scene on a graphics processor, or by software that stands for one: GLSL ES 3.00, which
/// WebGL 2 and OpenGL ES 3 read.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"

namespace durero::shader {

/// The output of a shader for each pixel.
enum class ShaderOutput {
  color,   ///< the colour of Whitted's algorithm, on the curve of sRGB
  answer,  ///< four whole numbers: 0 for no element, or its place among all elements from 1; 1 where that is in doubt
  doubts   ///< the colour, and magenta where the element is in doubt
};
/// Their words in calls, in order.
inline constexpr std::array<std::string_view, 3> shader_outputs{"color", "answer", "doubts"};

/// The most elements of a scene that becomes a shader, which asks each of them for each ray.
inline constexpr std::size_t most_shader_elements = 256;
/// The greatest magnitude of a number of such a scene.
inline constexpr double greatest_shader_number = 0x1p24;
/// The most rays in a row that a shader follows, where the scene asks for more.
inline constexpr std::uint32_t greatest_shader_depth = 32;

/// The text of the shader. Its uniforms are the members of ShaderView by their names. Elements count in the order of
/// scene::Scene::for_each.
///
/// An element that is not in doubt is the first one that the pixel's ray meets, and the only one there, exactly: the
/// certificate bounds every rounding of binary32, that of the scene's numbers, of the camera's and of the direction
/// too (src/shader/parts/certificate.glsl). Colours have no certificate.
///
/// Throws std::domain_error, which names the element, material or light, for whatever a shader cannot hold: a scene
/// without a camera, or what render::still_camera refuses; more than most_shader_elements, or none; numbers beyond
/// greatest_shader_number; elements with a body, or with normals or coordinates of their vertices; images, relief and
/// gloss; surroundings that are pictures; more than 15 materials that let light through.
std::string fragment_shader(const scene::Scene& scene, ShaderOutput output);

/// The text of the vertex shader that goes with it: it draws one triangle, of three vertices without attributes, over
/// the whole picture.
std::string_view vertex_shader();

/// The uniforms of a shader: the rays of a camera, each number rounded once to binary32. The ray of the point that is x
/// pixels to the right of the middle of the picture and y above it starts at eye, in the direction
/// forward + x·step_x + y·step_y.
struct ShaderView {
  /// The view of these rays.
  explicit ShaderView(const scene::PrimaryRays& rays);

  std::array<float, 3> eye;      ///< where all rays start
  std::array<float, 3> forward;  ///< to the middle of the picture
  std::array<float, 3> step_x;   ///< from a pixel to its right neighbour
  std::array<float, 3> step_y;   ///< from a pixel to the one above
  std::array<float, 2> size;     ///< of the picture, in pixels
};

}  // namespace durero::shader
