/** \file
 * Durero for C, and for every language that can call it: scenes, edits under contract, exact first hits.
 *
 * A handle is a pointer to what the library owns. A function that fails says so by its answer, and durero_error() then
 * has one line of text; no exception leaves the library. Handles of different threads are apart; one handle may be read
 * by several threads, but a scene must not be edited while anything else uses it or an engine of it.
 */
#ifndef DURERO_C_DURERO_H
#define DURERO_C_DURERO_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A scene: elements and their attributes, edited under contract. */
typedef struct durero_scene durero_scene;
/** What answers rays on one scene. */
typedef struct durero_engine durero_engine;

/** The ray of the points p + t·v with t > 0. */
typedef struct durero_ray {
  double p[3]; /**< its origin, which is no point of it */
  double v[3]; /**< not 0, and of any other length */
} durero_ray;

/** Whether some point of the ray is met, none is, or none of those that are met is the nearest. */
typedef enum durero_outcome { DURERO_HIT = 0, DURERO_MISS = 1, DURERO_NO_MINIMUM = 2 } durero_outcome;

/** Primera_Interseccion: t and each coordinate of the point are the exact numbers rounded once; 0 where none is hit. */
typedef struct durero_hit {
  durero_outcome outcome; /**< what the numbers below are of */
  uint32_t elements; /**< how many the point lies on; durero_elements() names them */
  double t;        /**< the parameter of the first point, in lengths of v */
  double point[3]; /**< the first point */
} durero_hit;

/** Refused: a precondition of the specification does not hold. Failed: the call itself is wrong. */
typedef enum durero_answer { DURERO_REFUSED = 0, DURERO_DONE = 1, DURERO_FAILED = -1 } durero_answer;

/** What the last failing call of this thread says, in one line; empty where none has failed. It is valid until the next
 * call of this thread. */
const char *durero_error(void);

/** The version of the library, such as "0.1.0". */
const char *durero_version(void);

/** A scene without elements; NULL where memory runs out. */
durero_scene *durero_scene_new(void);
/** Reads a scene file, with its groups; NULL where it is none, with its file, line and column. */
durero_scene *durero_scene_read(const char *path);
/** Reads a scene file by a Z text, another file, that says what the points of each element are, as `durero trace --with`
 * does. Edits of such a scene are those of `durero edit --with`. NULL where a file is wrong. */
durero_scene *durero_scene_read_with(const char *path, const char *text);
/** Writes a scene file, which appears whole or not at all. Pictures that the scene names stay where they are: in another
 * folder than it was read from the file names them from there. DURERO_FAILED where it cannot be written. */
durero_answer durero_scene_write(const durero_scene *scene, const char *path);
/** Nothing may use the scene any more, no engine either. NULL is permitted. */
void durero_scene_free(durero_scene *scene);
/** How many elements it has. */
size_t durero_scene_size(const durero_scene *scene);

/** Runs one operation, as `durero edit` reads it: "Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1", or an edit of the
 * scene's groups: "group g?=pair elementos?=s1,s2", "ungroup g?=pair". An element that is removed leaves its group, and one
 * that is added is in none, whatever its name: durero_left_group() names the group. DURERO_REFUSED where
 * a precondition does not hold: the scene is as it was, and durero_error() is "LABEL: PREDICATE", the clause of the
 * specification, or of a text that the scene was read by. DURERO_FAILED where the text is no operation. */
durero_answer durero_apply(durero_scene *scene, const char *operation);
/** Of the operation that the scene did last: where it was a removal, the group that the element left; where it was an
 * addition, the one that an element of its name left before, and that the new one is not in. "" where there is none.
 * Valid until the next operation. */
const char *durero_left_group(const durero_scene *scene);

/** Undoes what was done last, an operation or a whole transaction; the last 10,000 are kept. DURERO_REFUSED, and
 * durero_error() is "Deshacer.pre.1: …", where there is nothing. DURERO_FAILED where a transaction is open. */
durero_answer durero_undo(durero_scene *scene);
/** Does again what was undone last, unless something else was done since. DURERO_REFUSED, "Rehacer.pre.1: …", where there
 * is nothing. DURERO_FAILED where a transaction is open. */
durero_answer durero_redo(durero_scene *scene);
/** Opens a transaction: what is done until its end is undone together. DURERO_FAILED where one is open. */
durero_answer durero_begin(durero_scene *scene);
/** Ends a transaction, which is one step. DURERO_FAILED where none is open. */
durero_answer durero_commit(durero_scene *scene);
/** Ends a transaction, and undoes everything that was done in it. DURERO_FAILED where none is open. */
durero_answer durero_roll_back(durero_scene *scene);

/** A mesh in plain arrays of the caller's, which are copied. */
typedef struct durero_mesh {
  const double *vertices; /**< x, y and z of each vertex */
  size_t vertex_count; /**< how many there are */
  const uint32_t *faces; /**< the numbers of the three vertices of each face, from 0 */
  size_t face_count; /**< how many there are */
} durero_mesh;

/** Adds a mesh of that name, all of its faces or none: Agregar_Malla of the specification. Face 17 of `hull` is the element
 * `hull:17`. DURERO_REFUSED as of durero_apply(), and of a face with the number of no vertex. DURERO_FAILED where m is no
 * name, or a number is not finite. */
durero_answer durero_add_mesh(durero_scene *scene, const char *m, const durero_mesh *mesh);
/** Puts another mesh, without a material, in the place of the one of that name: Reemplazar_Malla. Otherwise as
 * durero_add_mesh(). */
durero_answer durero_replace_mesh(durero_scene *scene, const char *m, const durero_mesh *mesh);

/** Makes the engine of that name ready for the scene (`durero engines` lists them; NULL is the usual one). The scene must
 * outlive it, unedited. NULL where there is no such engine. A scene that was read by a Z text has the text answer, and
 * takes no name but NULL. */
durero_engine *durero_engine_new(const durero_scene *scene, const char *name);
/** The same, its hierarchy that of the scene's groups. NULL also where the engine follows no groups, as all but "bvh",
 * and of a scene that was read by a Z text. name is not NULL. */
durero_engine *durero_engine_new_by_hand(const durero_scene *scene, const char *name);
/** NULL is permitted. The scene stays. */
void durero_engine_free(durero_engine *engine);

/** The first hits of count rays, in order, on every processor. DURERO_FAILED, and nothing written, where a number is not
 * finite or a v is 0. */
durero_answer durero_first_hits(const durero_engine *engine, const durero_ray *rays, size_t count, durero_hit *hits);

/** No element of a scene has this number. */
#define DURERO_NO_ELEMENT UINT32_MAX

/** Rays in plain arrays of the caller's: at one place of each what is of one ray. */
typedef struct durero_ray_arrays {
  const double *p[3]; /**< x, y and z of the origins */
  const double *v[3]; /**< of the directions, not 0, and of any other length */
  const uint32_t *start; /**< the element that each starts on, or DURERO_NO_ELEMENT; NULL where none starts on one */
} durero_ray_arrays;

/** Where answers go, each in the place of its ray. An array that is NULL is not written; where t and point are all NULL
 * they are not found out either, which takes less time. */
typedef struct durero_hit_arrays {
  uint8_t *outcome; /**< a durero_outcome */
  uint32_t *elements; /**< how many elements the first point lies on; 0 of a miss */
  uint32_t *element; /**< the least of them by number; DURERO_NO_ELEMENT of a miss */
  double *t; /**< the parameter of the first point, rounded once; 0 where none is hit */
  double *point[3]; /**< x, y and z of that point, each rounded once */
} durero_hit_arrays;

/** The first hits of count rays, in order, on every processor, in memory that does not grow with their number. The
 * start of a ray lies on the surface of its element exactly, however its numbers were rounded. DURERO_FAILED, and nothing
 * written, where a number is not finite, a v is 0 or a start is no element. */
durero_answer durero_first_hits_of_arrays(const durero_engine *engine, const durero_ray_arrays *rays, size_t count,
                                          const durero_hit_arrays *hits);

/** Whether something lies on each ray between its start and p + v: 1 where some element is met at 0 < t < 1, and 0 where
 * none is, in the place of the ray. Otherwise as durero_first_hits_of_arrays(). */
durero_answer durero_occluded_segments(const durero_engine *engine, const durero_ray_arrays *rays, size_t count,
                                       uint8_t *occluded);

/** The name of an element by its number, 0 to durero_scene_size() − 1; NULL where it is none. It is valid as long as the
 * engine is and the scene is not edited, and so is the number. */
const char *durero_element_name(const durero_engine *engine, uint32_t element);
/** The number of the element of a name; DURERO_NO_ELEMENT where there is none. */
uint32_t durero_element_number(const durero_engine *engine, const char *name);

/** The number of an element among the faces of its mesh; DURERO_NO_ELEMENT where it is a face of none. Where mesh is not
 * NULL, *mesh gets the mesh's name, valid as in durero_element_name(), or NULL. */
uint32_t durero_face_number(const durero_engine *engine, uint32_t element, const char **mesh);

/** The names of the elements that the first point of a ray lies on, each ended by a 0, in order, in a buffer of size
 * bytes; a name that has no room is left out. The number of elements, or -1 where the ray is none. */
int durero_elements(const durero_engine *engine, const durero_ray *ray, char *names, size_t size);

/** How many points of a scene are nearest to a point. */
typedef enum durero_count {
  DURERO_NONE = 0, /**< the scene has no element */
  DURERO_ONE = 1, /**< one */
  DURERO_MANY = 2 /**< several, or a whole ring or sphere of them */
} durero_count;

/** What is nearest to a point, rounded once from its exact value. Of an empty scene all but count and element is 0. */
typedef struct durero_proximity {
  durero_count count; /**< how many points are nearest */
  uint32_t elements; /**< how many elements have the distance */
  uint32_t element; /**< the least of them by number; DURERO_NO_ELEMENT of an empty scene */
  double distance; /**< how far the nearest point is */
  double point[3]; /**< the nearest point, of many the first by x, then y, then z */
} durero_proximity;

/** How far count points are from the scene, in order, on every processor; xyz has three numbers a point. DURERO_FAILED, and
 * nothing written, where a number is not finite, and of a scene that was read by a Z text. */
durero_answer durero_distances(const durero_scene *scene, const double *xyz, size_t count, durero_proximity *answers);

/** A scene that is kept with its whole history in one file, open: the file that `durero store` uses. A handle is used by one
 * thread at a time. Programs and threads that edit one file by handles of their own wait for each other, 120 s at most; a
 * process that is forked opens the file anew. */
typedef struct durero_store durero_store;

/** Who does something, when and why: UTF-8 on one line each. */
typedef struct durero_provenance {
  const char *author; /**< a name; NULL is the first of DURERO_AUTHOR, LOGNAME and USER that the environment has */
  const char *time; /**< of UTC, as 2026-01-31T12:00:00Z; NULL is now */
  const char *comment; /**< the reason; NULL is none */
} durero_provenance;

/** How a script is carried out. {0} is the usual way. */
typedef struct durero_store_call {
  durero_provenance by; /**< of what is kept */
  int all_or_nothing; /**< whether the first refusal ends it, and nothing of it is kept; 0 is no */
  int64_t expected_head; /**< the event where HEAD must be; 0 is any */
} durero_store_call;

/** Makes a new store with a scene, or of NULL with the empty one. It appears whole or not at all. The path may be the URI
 * of a PostgreSQL server, here and below. Pictures that the scene names are named from the store's folder then. by may be
 * NULL. DURERO_FAILED where there is a file of that path, and of a scene that was read by a Z text. */
durero_answer durero_store_create(const char *path, const durero_scene *scene, const durero_provenance *by);
/** Opens a store that is there; NULL where the file is none, is missing or cannot be written. */
durero_store *durero_store_open(const char *path);
/** NULL is permitted. Scenes that the store gave stay. */
void durero_store_close(durero_store *store);

/** Carries the operations of a script, one a line, out where HEAD is, as one transaction and one step of undo, and returns
 * when those that were accepted are on disk; durero_store_answers() has an answer for each. call may be NULL.
 * DURERO_REFUSED where some were refused: these change nothing, and durero_error() is that of durero_apply() for the first.
 * DURERO_FAILED, and nothing kept, where a line is no operation, HEAD is not at expected_head, or the file cannot be used. */
durero_answer durero_store_edit(durero_store *store, const char *script, const durero_store_call *call);
/** What `durero store edit` would have printed of the last durero_store_edit(): a line of JSON for each operation. It is
 * empty where that failed, and valid until the next. */
const char *durero_store_answers(const durero_store *store);
/** Goes back before the last transaction; nothing is deleted. DURERO_REFUSED, "Deshacer.pre.1: …", where there is none. */
durero_answer durero_store_undo(durero_store *store);
/** Goes on to where the last undo left from. DURERO_REFUSED, "Rehacer.pre.1: …", where there is no such. */
durero_answer durero_store_redo(durero_store *store);
/** The scene of a revision, a branch, a tag, the number of an event or HEAD, perhaps with ~N behind it for the N-th
 * transaction before; NULL is HEAD. It is a copy of the caller's. NULL where there is no such revision, or the file is
 * spoiled. */
durero_scene *durero_store_scene(durero_store *store, const char *revision);
/** The number of the event where HEAD is, from 1; -1 where the file cannot be used. */
int64_t durero_store_head(durero_store *store);

#ifdef __cplusplus
}
#endif

#endif
