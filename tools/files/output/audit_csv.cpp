#include "files/output/audit_csv.hpp"

#include "files/output/csv_table.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

/// In quotes, as in RFC 4180.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string rings_of(const audit::Finding& pair) {
  return pair.rings == audit::kNotConnected ? std::string() : fmt::format("{}", pair.rings);
}

}  // namespace

void write_audit_pairs_csv(const std::filesystem::path& path, const audit::Report& report) {
  const ComputingState state;
  CsvTable table(path, "frame,kind,v0,v1,v2,v3,v4,toi_lower,toi_upper,object_a,object_b,rings,new");
  for (const audit::Finding& pair : report.pairs)
    table.row("{},{},{},{},{},{},{},{},{},{},{},{},{:d}\n", pair.frame, name_of(pair.kind), pair.vertices[0],
              pair.vertices[1], pair.vertices[2], pair.vertices[3], pair.vertices[4], pair.toi_lower, pair.toi_upper,
              quoted(report.object_name(pair, 0)), quoted(report.object_name(pair, 1)), rings_of(pair), pair.is_new);
  table.commit();
}

void write_audit_frames_csv(const std::filesystem::path& path, const audit::Report& report) {
  const ComputingState state;
  CsvTable table(path, "frame,name,usable,step,vf,ee,ve,vv,ef,neighbours,toi_lower,toi_upper,new");
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    const audit::FrameAnswer& frame = report.frames[i];
    table.row("{},{},{:d},{:d},{},{},{},{},{},{},{},{},{}\n", i, quoted(frame.name), frame.problem.empty(),
              frame.has_step, frame.counts[0], frame.counts[1], frame.counts[2], frame.counts[3], frame.counts[4],
              frame.neighbours, frame.toi_lower, frame.toi_upper, frame.fresh);
  }
  table.commit();
}

}  // namespace tamis::io
