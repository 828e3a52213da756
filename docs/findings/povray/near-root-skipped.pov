// POV-Ray 3.7.0.10.unofficial: far root
// Expected e2 at t = 6.98791196585703e-05, point (2.794921875, -0.8126220703125, -0.19098784786965858); got e2 at (2.794921875, -0.8126220703125, -0.87742781667383).
// A near root is skipped and the far one reported: the ray goes through the wall.
// the exact answer: e2 at t = 6.98791196585703e-05
// e2:
//   t = 0.00006987911965857030109953168729131714353083
//     = 3417722754509337711573264353425901/9955792808583322549000896884375552 − 79228162514264337593543950336/75956671208063679115302252841·√(147372771332742233370298796558900982591/1361129467683753853853498429727072845824)
// e2:
//   t = 0.6865098479238311425751329435448111515113
//     = 3417722754509337711573264353425901/9955792808583322549000896884375552 + 79228162514264337593543950336/75956671208063679115302252841·√(147372771332742233370298796558900982591/1361129467683753853853498429727072845824)
// the first point:
//   x = 2.794921875
//   y = -0.8126220703125
//   z = -0.1909878478696585703010995316872913171435
//
// povray near-root-skipped.pov +W1 +H1 -D -F && cat answer
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 }

#declare P = <2.794921875, -0.8126220703125, -0.19091796875>;
#declare V = <0.0, 0.0, -1.0>;
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

Ask("e2", object { cylinder { <0.0, 0.0, 0.0>, <3.836338520050049, 0.7885647416114807, -0.8128175735473633>, 1.399658203125 open } })

#fopen Answer "answer" write
#write (Answer, "got: ", Got, "\nexpected: hit e2 - 2.794921875 -0.8126220703125 -0.19098784786965858\n")
#fclose Answer
