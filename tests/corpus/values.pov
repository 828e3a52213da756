// Values: numbers, vectors, colours, texts, arrays, functions and a spline place four spheres.
#version 3.7;
#declare Sizes = array[3] { 1, 2, 3 };
#declare Double = function(a) { 2 * a };
#declare Way = spline { linear_spline 0, <0, 0, 0> 1, <8, 0, 0> };
#declare Name = concat("s", str(dimension_size(Sizes, 1), 0, 0));
#declare Colour = rgb <0.5, 0.25, 0.125>;
sphere { <Double(Sizes[1]), 0, 0>, Sizes[0] pigment { Colour } }
sphere { vrotate(x, 90 * z) * 5, vlength(<0, 3, 4>) / 5 pigment { color Colour * 2 } }
sphere { Way(0.5), strlen(Name) / 2 }
sphere { <mod(7, 4), div(7, 2), max(1, 2, 3)>, (1 < 2 ? 0.5 : 9) }
