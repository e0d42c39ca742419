#include "scenes/scene.hpp"

namespace tamis::scenes {

Index Scene::add_vertex(const Point& at_start, const Point& at_end, Index group) {
  start.push_back(at_start);
  end.push_back(at_end);
  group_of_vertex.push_back(group);
  return vertex_count() - 1;
}

}  // namespace tamis::scenes
