// Asks OpenSceneGraph by LineSegmentIntersector of one Geometry, of a segment that no point is beyond; the argument
// `tree` has a KdTree built.
#include "../ask.hpp"

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/KdTree>
#include <osg/Version>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

using namespace ask;

class Asked {
 public:
  Asked(const Scene& of, bool has_tree) : of_(&of), mesh_(mesh_of(of)) {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    for (const Vec& a : mesh_.points) points->push_back(osg::Vec3(float(a[0]), float(a[1]), float(a[2])));
    osg::ref_ptr<osg::DrawElementsUInt> faces = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (const auto& face : mesh_.faces)
      for (unsigned i : face) faces->push_back(i);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(points);
    geometry->addPrimitiveSet(faces);
    geode_->addDrawable(geometry);
    if (!has_tree) return;
    osg::ref_ptr<osg::KdTreeBuilder> builder = new osg::KdTreeBuilder;
    geode_->accept(*builder);
  }

  void ask(const Ray& ray) const {
    const double f = segment(mesh_, ray);
    const Vec end = ray.p + f * ray.v;
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line = new osgUtil::LineSegmentIntersector(
        osg::Vec3d(ray.p[0], ray.p[1], ray.p[2]), osg::Vec3d(end[0], end[1], end[2]));
    line->setIntersectionLimit(osgUtil::Intersector::LIMIT_NEAREST);
    osgUtil::IntersectionVisitor visitor(line);
    geode_->accept(visitor);
    if (!line->containsIntersections()) return miss();
    const auto& first = *line->getIntersections().begin();
    const osg::Vec3& n = first.localIntersectionNormal;
    hit(of_->elements[first.primitiveIndex].name, first.ratio * f, {n.x(), n.y(), n.z()});
  }

 private:
  const Scene* of_;
  Mesh mesh_;
  osg::ref_ptr<osg::Geode> geode_ = new osg::Geode;
};

int main(int count, char**) {
  return answer(std::string("OpenSceneGraph ") + osgGetVersion() + (count > 1 ? " tree" : ""),
                [&](const Scene& scene) { return Asked(scene, count > 1); });
}
