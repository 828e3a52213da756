// Solids: four elements, each made of its parts, and what bounds nothing.
#version 3.7;
difference { box { -1, 1 } sphere { 0, 1.25 } }
intersection { sphere { 0, 1 } plane { y, 0 } translate 4 * x }
merge { sphere { 0, 1 } cylinder { 0, 2 * x, 0.5 } translate 8 * x }
difference { sphere { 0, 1 } box { 0, 2 inverse } translate 12 * x }
difference { sphere { 0, 1 } triangle { x, y, z } }
