// Directives: six spheres, of radius 1 to 6, and none of what is passed over.
#version 3.7;
#declare Count = 0;
#macro Ball(R) sphere { <R, 0, 0>, R } #declare Count = Count + 1; #end
#if (Count = 0) Ball(1) #else Ball(100) #end
#ifdef (Count) Ball(2) #end
#ifndef (Count) Ball(100) #elseif (Count = 2) Ball(3) #end
#switch (Count) #case (1) Ball(100) #break #range (2, 4) Ball(4) #break #else Ball(100) #end
#while (Count < 5) Ball(Count + 1) #end
#for (I, 1, 9) #if (Count = 6) #break #end Ball(6) #end
#undef Count
#ifdef (Count) Ball(100) #end
