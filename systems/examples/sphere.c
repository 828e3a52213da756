#include <math.h>  // A system that knows spheres: it reads the rays of `durero conform run` and writes its hits.
#include <stdio.h>
#include <string.h>

int main(void) {
  static char word[256], name[256], names[1000][256];
  static double s[1000][4];
  int spheres = 0;
  puts("system example-c 1");
  while (fflush(stdout), scanf("%255s %255s", word, name) == 2) {
    if (!strcmp(word, "scene")) spheres = 0;
    if (!strcmp(word, "esfera")) strcpy(names[spheres], name), scanf("%lf %lf %lf %lf", s[spheres], s[spheres] + 1, s[spheres] + 2, s[spheres] + 3), ++spheres;
    int rays = 0;
    if (!strcmp(word, "rays")) sscanf(name, "%d", &rays);
    for (double p[6]; rays-- > 0;) {
      double nearest = INFINITY;
      int element = -1;
      for (int i = 0; i < 6; ++i) scanf("%lf", p + i);
      for (int e = 0; e < spheres; ++e) {
        double A = 0, B = 0, C = -s[e][3] * s[e][3];
        for (int i = 0; i < 3; ++i) A += p[3 + i] * p[3 + i], B += (p[i] - s[e][i]) * p[3 + i], C += (p[i] - s[e][i]) * (p[i] - s[e][i]);
        for (int side = -1; side <= 1; side += 2) {
          double t = (-B + side * sqrt(B * B - A * C)) / A;  // nan where there is no root
          if (t > 0 && t < nearest) nearest = t, element = e;
        }
      }
      element < 0 ? puts("miss") : printf("hit %s %.17g\n", names[element], nearest);
    }
  }
}
