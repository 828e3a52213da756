#include "polygon_soup.hpp"

#define CGAL_DEBUG  // an assertion of the library throws, in every build
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>

#include <istream>
#include <streambuf>

#include "durero/io/lines.hpp"

namespace durero::io {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

/// A text as a stream reads it, and how far it has.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string_view text) {
    char* const begin = const_cast<char*>(text.data());  // it is only read
    setg(begin, begin, begin + text.size());
  }
  std::size_t passed() const { return static_cast<std::size_t>(gptr() - eback()); }
};

/// The faces as the library adds them: once it has read them, or the line that they stand on.
class Faces : public std::vector<Face> {
 public:
  Faces(const TextBuffer& bytes, std::vector<std::size_t>& ends) : bytes_(&bytes), ends_(&ends) {}
  void emplace_back() {
    std::vector<Face>::emplace_back();
    ends_->push_back(bytes_->passed());
  }

 private:
  const TextBuffer* bytes_;
  std::vector<std::size_t>* ends_;
};

/// read(stream, points, faces) by the library.
template <class Read>
PolygonSoup soup_of(std::string_view text, Read&& read) {
  PolygonSoup soup;
  TextBuffer bytes(text);
  std::istream in(&bytes);
  std::vector<Point> points;
  Faces faces(bytes, soup.face_ends);
  try {
    soup.whole = read(in, points, faces);
  } catch (const CGAL::Failure_exception&) {  // it cannot go on
  }
  soup.end = bytes.passed();
  soup.vertices.reserve(points.size());
  for (const Point& p : points) soup.vertices.emplace_back(p.x(), p.y(), p.z());
  soup.faces = std::move(faces);
  return soup;
}

}  // namespace

void append_plain(std::string& out, std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool blank = std::string_view(" \t\v\f\r\n").find(text[i]) != std::string_view::npos;
    out += ends_line(text, i) ? '\n' : blank ? ' ' : text[i];
  }
}

PolygonSoup obj_soup(std::string_view text) {
  return soup_of(text, [](auto& in, auto& points, auto& faces) { return CGAL::IO::read_OBJ(in, points, faces); });
}

PolygonSoup ply_soup(std::string_view text) {
  return soup_of(text, [](auto& in, auto& points, auto& faces) {
    return CGAL::IO::read_PLY(in, points, faces, CGAL::parameters::verbose(false));
  });
}

}  // namespace durero::io
