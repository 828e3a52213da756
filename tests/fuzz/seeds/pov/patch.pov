// Groups of triangles: a mesh, a mesh2 with normals, a polygon with a hole, a prism and a bicubic patch.
#version 3.7;
mesh { triangle { 0, x, y } smooth_triangle { x, z, y, z, x + y, z } }
mesh2 { vertex_vectors { 4, 0, x, y, x + y } normal_vectors { 1, z } face_indices { 2, <0, 1, 2>, <1, 3, 2> }
  normal_indices { 2, <0, 0, 0>, <0, 0, 0> } translate 2 * z }
polygon { 10, <0, 0>, <4, 0>, <4, 4>, <0, 4>, <0, 0>, <1, 1>, <2, 1>, <2, 2>, <1, 2>, <1, 1> }
prism { linear_sweep linear_spline 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> translate 6 * x }
bicubic_patch { type 1 flatness 0 u_steps 1 v_steps 1 <0, 0, 0> <0, 0, 1> <0, 0, 2> <0, 0, 3> <1, 0, 0> <1, 1, 1> <1, 1, 2> <1, 0, 3> <2, 0, 0> <2, 1, 1> <2, 1, 2> <2, 0, 3> <3, 0, 0> <3, 0, 1> <3, 0, 2> <3, 0, 3> }
