#pragma once
/// A recipe of a family of meshes makes its mesh, of about so many faces, or a ray for it.

#include "conform/families/drawn_mesh.hpp"

namespace durero::conform::recipes {

// Closed meshes (recipes_mesh_closed.cpp).
DrawnMesh mesh_solid(Draws& random, int log2_distance, std::size_t faces);
DrawnRay mesh_solid(Draws& random, int log2_distance, const DrawnMesh& mesh);
DrawnMesh mesh_inside(Draws& random, int log2_scale, std::size_t faces);
DrawnRay mesh_inside(Draws& random, int log2_scale, const DrawnMesh& mesh);
DrawnMesh mesh_surface(Draws& random, int minus_log2_step, std::size_t faces);
DrawnRay mesh_surface(Draws& random, int minus_log2_step, const DrawnMesh& mesh);
DrawnMesh needles(Draws& random, int log2_ratio, std::size_t faces);
DrawnRay needles(Draws& random, int log2_ratio, const DrawnMesh& mesh);

// Open meshes (recipes_mesh_open.cpp).
DrawnMesh terrain(Draws& random, int log2_height, std::size_t faces);
DrawnRay terrain(Draws& random, int log2_height, const DrawnMesh& mesh);
DrawnMesh scan(Draws& random, int minus_log2_noise, std::size_t faces);
DrawnRay scan(Draws& random, int minus_log2_noise, const DrawnMesh& mesh);
DrawnMesh seams(Draws& random, int log2_pieces, std::size_t faces);
DrawnRay seams(Draws& random, int log2_pieces, const DrawnMesh& mesh);

// Triangles whose boxes are hard on a tree (recipes_tree.cpp).
DrawnMesh box_faces(Draws& random, int log2_distance, std::size_t faces);
DrawnRay box_faces(Draws& random, int log2_distance, const DrawnMesh& mesh);
DrawnMesh nested(Draws& random, int log2_ratio, std::size_t faces);
DrawnRay nested(Draws& random, int log2_ratio, const DrawnMesh& mesh);
DrawnMesh long_boxes(Draws& random, int minus_log2_width, std::size_t faces);
DrawnRay long_boxes(Draws& random, int minus_log2_width, const DrawnMesh& mesh);
DrawnMesh stack(Draws& random, int minus_log2_spacing, std::size_t faces);
DrawnRay stack(Draws& random, int minus_log2_spacing, const DrawnMesh& mesh);

}  // namespace durero::conform::recipes
