// The answers of CGAL about triangles (OFF) that are a mesh to it, with no multiple edge and of one mind about their
// outside: whether two have more in common than they share, and the volume where they are closed. mesh_audit.py
// compiles and asks it; it is no part of the program.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int, char** arguments) {
  std::ifstream file(arguments[1]);
  std::string word;
  std::size_t points, faces, none;
  file >> word >> points >> faces >> none;
  std::vector<Kernel::Point_3> point(points);
  std::vector<std::array<std::size_t, 3>> face(faces);
  for (auto& p : point) file >> p;
  for (auto& f : face) file >> none >> f[0] >> f[1] >> f[2];
  std::cout.precision(17);
  std::cout << "{";
  if (PMP::is_polygon_soup_a_polygon_mesh(face)) {
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    PMP::polygon_soup_to_polygon_mesh(point, face, mesh);
    std::cout << "\"crossing\": " << (PMP::does_self_intersect(mesh) ? "true" : "false");
    if (CGAL::is_closed(mesh)) std::cout << ", \"volume\": " << PMP::volume(mesh);
  }
  std::cout << "}\n";
}
