/* A mesh in arrays of one's own, from C: two triangles of a square, and the face that a ray meets first. */
#include <durero/c/durero.h>
#include <stdio.h>

int main(void) {
  const double vertices[][3] = {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}};
  const uint32_t faces[][3] = {{0, 1, 2}, {0, 2, 3}};
  const durero_mesh square = {&vertices[0][0], 4, &faces[0][0], 2};
  durero_scene *scene = durero_scene_new();
  if (durero_add_mesh(scene, "square", &square) != DURERO_DONE) return 1;
  if (durero_add_mesh(scene, "square", &square) == DURERO_REFUSED) printf("refused: %s\n", durero_error());
  durero_engine *engine = durero_engine_new(scene, NULL);
  const double x = 0.5, y = 1.5, zero = 0, one = 1;
  const durero_ray_arrays ray = {{&x, &y, &zero}, {&zero, &zero, &one}, NULL};
  uint32_t element;
  double t;
  const durero_hit_arrays hit = {.element = &element, .t = &t};
  if (durero_first_hits_of_arrays(engine, &ray, 1, &hit) != DURERO_DONE) return 1;
  printf("face %u at t = %g\n", (unsigned)durero_face_number(engine, element, NULL), t);
  durero_engine_free(engine);
  durero_scene_free(scene);
  return 0;
}
