/* A first hit, from C. */
#include <durero/c/durero.h>
#include <stdio.h>

int main(void) {
  durero_scene *scene = durero_scene_new();
  if (durero_apply(scene, "Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1") != DURERO_DONE) return 1;
  if (durero_apply(scene, "Agregar_Esfera e?=s1 centro?=(0,0,9) radio?=1") == DURERO_REFUSED)
    printf("refused: %s\n", durero_error());
  durero_engine *engine = durero_engine_new(scene, NULL);
  const durero_ray ray = {{0, 0, 0}, {0, 0, 2}};
  durero_hit hit;
  char name[129];
  if (durero_first_hits(engine, &ray, 1, &hit) != DURERO_DONE || durero_elements(engine, &ray, name, sizeof name) != 1)
    return 1;
  printf("%s at t = %g, z = %g\n", name, hit.t, hit.point[2]);
  durero_engine_free(engine);
  durero_scene_free(scene);
  return 0;
}
