#version unofficial 3.6;
global_settings { assumed_gamma srgb assumed_gamma 2.2 }
camera { look_at <0.5, 0, 0> angle 42 up y*9 right -x*16 location <1, 2, -7> direction z*2 sky y }
background { rgb <0.2, 0.3, 0.5> }
light_source { <1, 2, 3>, rgb 0.5 parallel }
sphere { 0, 1 pigment { rgb <0.5, 0.25, 1> filter 0.5 } finish { ambient 0.5 phong 0.25 reflection <0.5, 0.25, 0> } }
