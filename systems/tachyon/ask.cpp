// Asks Tachyon: it makes pictures and says nothing of distances, so each ray is a picture of one pixel. The frustum has
// no width, so that every ray of the camera is the view direction from its centre; each element has a colour of its
// own, which the low shader shows as it is.
#include "../ask.hpp"

#include <tachyon.h>

using namespace ask;

static apivector vector(Vec v) { return rt_vector(v[0], v[1], v[2]); }

// Two digits in base 64, of which 1/64 each is exact; black is the background.
static apicolor colour_of(std::size_t number) { return rt_color((number % 64) / 64., (number / 64) / 64., 0); }
static std::size_t number_of(const float* colour) {
  return static_cast<std::size_t>(std::lround(64 * colour[0]) + 64 * std::lround(64 * colour[1]));
}

static void add(SceneHandle scene, const Element& e, void* texture) {
  if (e.is("esfera")) {
    rt_sphere(scene, texture, vector(e.centro()), e.numbers[3]);
  } else if (e.is("cilindro")) {
    rt_fcylinder(scene, texture, vector(e.centro()), vector(e.altura() * e.vector()), e.numbers[6]);
  } else if (e.is("plano")) {
    rt_plane(scene, texture, vector(e.centro()), vector(e.vector()));
  } else if (e.is("disco")) {
    rt_ring(scene, texture, vector(e.centro()), vector(e.vector()), 0, e.numbers[6]);
  } else {
    rt_tri(scene, texture, vector(e.vec(0)), vector(e.vec(3)), vector(e.vec(6)));
  }
}

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of), scene_(rt_newscene()) {
    rt_verbose(scene_, 0);
    rt_set_numthreads(scene_, 1);
    rt_resolution(scene_, 1, 1);
    rt_aa_maxsamples(scene_, 0);
    rt_shadermode(scene_, RT_SHADER_LOW);
    rt_background(scene_, rt_color(0, 0, 0));
    rt_camera_projection(scene_, RT_PROJECTION_PERSPECTIVE);
    rt_rawimage_rgb96f(scene_, pixel_);
    for (std::size_t i = 0; i < of.elements.size(); ++i) {
      apitexture texture = {};
      texture.texturefunc = RT_TEXTURE_CONSTANT;
      texture.col = colour_of(i + 1);
      texture.ambient = texture.opacity = 1;
      add(scene_, of.elements[i], rt_texture(scene_, &texture));
    }
  }
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked() { rt_deletescene(scene_); }

  void ask(const Ray& ray) {
    rt_camera_position(scene_, vector(ray.p), vector(ray.v), vector(beside(unit(ray.v))[0]));
    rt_camera_frustum(scene_, 0, 0, 0, 0);
    rt_renderscene(scene_);
    const std::size_t number = number_of(pixel_);
    number == 0 ? miss() : (void)std::printf("hit %s -\n", of_->elements[number - 1].name.c_str());
  }

 private:
  const Scene* of_;
  SceneHandle scene_;
  float pixel_[3] = {};
};

static void ignore(int, char*) {}

int main(int count, char** words) {
  rt_initialize(&count, &words);
  rt_set_ui_message(ignore);
  return answer("Tachyon " TACHYON_VERSION_STRING, [](const Scene& scene) { return Asked(scene); });
}
