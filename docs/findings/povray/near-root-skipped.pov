// POV-Ray 3.7.0.10.unofficial: far root
// Expected e0 at t = 1.1462976173626219e-06, point (0.6434606313705444, -0.6015777587890625, 0.9466814031695507); got e0 at (0.6434606313705444, -0.6015777587890625, -0.9466814031695507).
// A near root is skipped and the far one reported: the ray goes through the wall.
// the exact answer: e0 at t = 1.1462976173626219e-06
// e0:
//   t = 0.000001146297617362621848641540756315987883131
//     = 248167/131072 − 4·√(63064868163655/281474976710656)
// e0:
//   t = 3.786726758975820137378151358459243684012
//     = 248167/131072 + 4·√(63064868163655/281474976710656)
// the first point:
//   x = 0.64346063137054443359375
//   y = -0.6015777587890625
//   z = 0.9466814031695506936890756792296218420061
//
// povray near-root-skipped.pov +W1 +H1 -D -F && cat answer
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 }

#declare P = <0.6434606313705444, -0.6015777587890625, 0.9466819763183594>;
#declare V = <0.0, 0.0, -0.5>;
#declare Found = 0;
#declare Nearest = 0;
#declare Got = "miss";
#macro Ask(Name, Object)
  #local Normal = <0, 0, 0>;
  #local Point = trace(Object, P, V, Normal);
  #if (vlength(Normal) != 0)
    #if (Found = 0 | vlength(Point - P) < Nearest)
      #declare Found = 1;
      #declare Nearest = vlength(Point - P);
      #declare Got = concat("hit ", Name, " - ", vstr(3, Point, " ", 0, 25));
    #end
  #end
#end

Ask("e0", object { sphere { <0.0, 0.0, 0.0>, 1.2931137084960938 } })

#fopen Answer "answer" write
#write (Answer, "got: ", Got, "\nexpected: hit e0 - 0.6434606313705444 -0.6015777587890625 0.9466814031695507\n")
#fclose Answer
