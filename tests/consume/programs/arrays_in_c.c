/* Rays and answers in arrays of one's own, from C: a pencil of them from one point. */
#include <durero/c/durero.h>
#include <stdio.h>

#define COUNT 1000

int main(void) {
  static double zero[COUNT], one[COUNT], across[COUNT], z[COUNT];
  static uint32_t element[COUNT];
  for (int i = 0; i < COUNT; ++i) {
    one[i] = 1;
    across[i] = i / 1024.0;
  }
  durero_scene *scene = durero_scene_new();
  if (durero_apply(scene, "Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1") != DURERO_DONE) return 1;
  durero_engine *engine = durero_engine_new(scene, NULL);
  const durero_ray_arrays rays = {{zero, zero, zero}, {across, zero, one}, NULL};
  const durero_hit_arrays hits = {.element = element, .point = {NULL, NULL, z}};
  if (durero_first_hits_of_arrays(engine, &rays, COUNT, &hits) != DURERO_DONE) return 1;
  int hit = 0;
  while (hit < COUNT && element[hit] != DURERO_NO_ELEMENT) ++hit;
  printf("%d of %d rays hit %s, the last at z = %g\n", hit, COUNT, durero_element_name(engine, element[0]), z[hit - 1]);
  durero_engine_free(engine);
  durero_scene_free(scene);
  return 0;
}
