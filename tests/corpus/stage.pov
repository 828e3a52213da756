// A stage: a camera with its words in another order, lights of each kind, a background and a gamma.
#version 3.6;
global_settings { assumed_gamma 2.2 }
camera { look_at <0, 1, 0> angle 40 right x * 4 / 3 up y location <0, 2, -9> }
light_source { <5, 9, -5>, rgb 1 }
light_source { <5, 9, -5>, rgb 0.5 spotlight point_at 0 radius 20 falloff 30 }
light_source { <5, 9, -5>, rgb 0.5 parallel point_at 0 }
light_source { <5, 9, -5>, rgb 0.5 area_light x, z, 3, 3 }
background { rgb <0.2, 0.3, 0.5> }
sphere { 0, 1 pigment { rgb <0.5, 0.1, 0.1> } finish { phong 0.5 reflection 0.1 } }
