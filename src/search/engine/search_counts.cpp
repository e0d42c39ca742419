#include "search/engine/search_counts.hpp"

namespace tamis {

SearchCounts& SearchCounts::operator+=(const SearchCounts& other) {
  for (const auto stage : {&SearchCounts::boxes, &SearchCounts::slab, &SearchCounts::apart, &SearchCounts::near,
                           &SearchCounts::dnf, &SearchCounts::ncf, &SearchCounts::solve})
    add(this->*stage, other.*stage);
  decided_by += other.decided_by;
  nodes_visited += other.nodes_visited;
  traverse += other.traverse;
  filter += other.filter;
  solving += other.solving;
  return *this;
}

void SearchCounts::add_to(Statistics& statistics, double wall,
                          std::initializer_list<StageCount SearchCounts::*> stages) const {
  statistics.stages.reserve(statistics.stages.size() + stages.size());
  for (const auto stage : stages) add(statistics.stages, this->*stage);
  statistics.decided_by += decided_by;
  statistics.nodes_visited += nodes_visited;
  const double sum = traverse + filter + solving, share = sum > 0 ? wall / sum : 0;
  statistics.seconds.traverse += share * traverse;
  statistics.seconds.filter += share * filter;
  statistics.seconds.solve += share * solving;
}

}  // namespace tamis
