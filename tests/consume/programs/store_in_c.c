/* A scene that is kept with its history in one file, from C. */
#include <durero/c/durero.h>
#include <stdio.h>

int main(void) {
  if (durero_store_create("room.store", NULL, NULL) != DURERO_DONE) return 1;
  durero_store *store = durero_store_open("room.store");
  const durero_store_call call = {.by = {.author = "ann", .comment = "the first"}, .all_or_nothing = 1};
  if (durero_store_edit(store, "Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1", &call) != DURERO_DONE) return 1;
  printf("%s", durero_store_answers(store));
  durero_scene *scene = durero_store_scene(store, "HEAD");
  printf("event %d: %d element\n", (int)durero_store_head(store), (int)durero_scene_size(scene));
  durero_scene_free(scene);
  if (durero_store_undo(store) != DURERO_DONE) return 1;
  printf("event %d again\n", (int)durero_store_head(store));
  durero_store_close(store);
  return 0;
}
