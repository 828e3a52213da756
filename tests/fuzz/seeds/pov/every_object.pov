// povray +W640 +H480 -A
#version 3.7; /* a /* comment */ within another */
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 0 }
#declare Odd = function(A) { floor(A) - 2*floor(A/2) }
#declare White = color rgb <1, 1, 1>;
camera { location <0, 0, -4> direction <0, 0, 2> right <-4, 0, 0> up <0, 3, 0> }
background { rgb <0.1, 0.2, 0.3> }
light_source { <1, 2, 3>, rgb <0.5, 0.25, 1> }
light_source { <0, 8, 0>, color rgb 1 parallel point_at <0, 0, 0> }
sphere { <1, 2, 3>, 4 texture { pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse 0.5 } } }
union {
  object { cylinder { <0, 0, 0>, <0, 0, 3>, 2 open } pigment { rgb <0, 0, 0.5> } }
  union {
    cylinder { <0, 0, 0>, <0, 3, 0>, 2 }
    cone { <0, 6, 0>, 1 <0, 2, 0>, 2 }
    cone { <0, 4, 0>, 0, <0, 2, 0>, 2 hollow }
  }
  mesh {
    triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
    smooth_triangle { <0, 0, 0>, z, <1, 0, 0>, z, <0, 2, 0>, z }
    triangle { <0, 0, 0>, <1, 0, 0>, <2, 0, 0> }
  }
  pigment { rgb <1, 0.5, 0> }
  finish { ambient rgb <0, 0.5, 1> diffuse 0.25 phong 0.5 phong_size 20 reflection 0.125 }
}
plane { -y, 1 }
plane { <0, 0, 4>, 0 translate <1, 2, 3> }
disc { <0, 0, 9>, -z, 3 }
