// Tori, a saddle and a rounded cube, which come in by demo/surfaces/algebraic.tex.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, 0.6, 0> angle 45 }
light_source { <8, 14, -10>, rgb 0.9 }
light_source { <-9, 6, -6>, rgb 0.3 }
background { rgb <0.02, 0.03, 0.06> }
#declare Gold = texture { pigment { rgb <0.8, 0.6, 0.2> } finish { ambient 0.1 diffuse 0.6 phong 0.5 phong_size 40 } };
#declare Slate = texture { pigment { rgb <0.3, 0.4, 0.55> } finish { ambient 0.1 diffuse 0.7 } };
#declare Chalk = texture { pigment { rgb <0.75, 0.72, 0.68> } finish { ambient 0.15 diffuse 0.7 } };
// A chain of five links, each across the one before.
#for (I, 0, 4)
  torus { 0.9, 0.22 scale <1.3, 1, 1> rotate 90 * mod(I, 2) * x translate <2.05 * (I - 2), 0.9 + 0.15 * I, 1.5> texture { Gold } }
#end
// x⁴ + y⁴ + z⁴ = 1, with a bite taken out of it by no one.
quartic {
  <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1>
  scale 0.8 rotate <20, 30, 0> translate <-2.4, 0.3, -2> texture { Slate }
}
torus { 0.8, 0.35 rotate <0, 0, 60> translate <2.3, 0.4, -2> texture { Slate } }
sphere { <0, 0.1, -1.6>, 0.8 texture { Chalk } }
box { <-6, -0.9, -5>, <6, -0.7, 5> texture { Chalk } }
