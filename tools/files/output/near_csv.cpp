#include "files/output/near_csv.hpp"

#include "files/output/csv_table.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {

void write_near_csv(const std::filesystem::path& path, std::span<const NearPair> pairs) {
  const ComputingState state;
  CsvTable table(path, "kind,v0,v1,v2,v3,distance,u,v,dx,dy,dz");
  for (const NearPair& p : pairs)
    table.row("{},{},{},{},{},{},{},{},{},{},{}\n", name_of(p.kind), p.vertices[0], p.vertices[1], p.vertices[2],
              p.vertices[3], p.distance, p.u, p.v, p.direction[0], p.direction[1], p.direction[2]);
  table.commit();
}

void write_intersections_csv(const std::filesystem::path& path, std::span<const Intersection> intersections) {
  const ComputingState state;
  CsvTable table(path, "e0,e1,f0,f1,f2,s_lower,s_upper,u,v");
  for (const Intersection& i : intersections)
    table.row("{},{},{},{},{},{},{},{},{}\n", i.edge[0], i.edge[1], i.face[0], i.face[1], i.face[2], i.s_lower,
              i.s_upper, i.u, i.v);
  table.commit();
}

}  // namespace tamis::io
