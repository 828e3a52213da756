#version 3.7;
torus { 1, 0.25 rotate <30, 0, 45> pigment { rgb 1 } }
union { torus { 0.5, 1 union } sphere { 0, 1 } translate 2*y }
quadric { <1, 1, -1>, <0, 0.5, 0>, <0, 0, 0>, -1 scale <1, 2, 3> }
cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,-1> sturm }
poly { 4, <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1,0,0,0,-1> }
difference { sphere { 0, 1 } torus { 1, 0.5 } }
