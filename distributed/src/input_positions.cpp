#include "distributed/src/input_positions.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "distributed/src/agreement.hpp"
#include "distributed/src/sparse_exchange.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

constexpr const char* kStart = "the start of the step";
constexpr const char* kEnd = "the end of the step";

void validate(const Positions& positions, Index rows, const char* what) {
  if (positions.count() != rows)
    throw InvalidStep(std::string(what) + " has " + std::to_string(positions.count()) +
                      " positions, this rank's part of the mesh " + std::to_string(rows) +
                      " vertices: give one row a vertex");
  if (rows > 0 && (positions.data() == nullptr || positions.stride() < 3))
    throw InvalidStep(
        std::string(what) +
        " is not an n x 3 array of doubles, row by row: give three columns next to each other and a stride "
        "of at least 3");
}

Point point_at(const Positions& positions, Index row) {
  Point point;
  std::copy_n(positions[row], 3, point.begin());
  return point;
}

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// Two points that are not finite count as the same: whether that matters depends on which rank uses them.
bool are_same(const Point& a, const Point& b) { return a == b || (!is_finite(a) && !is_finite(b)); }

void read_rows(const Step& step, InputPart& part) {
  validate(step.start, part.row_count, kStart);
  validate(step.end, part.row_count, kEnd);
  part.elements.motions.resize(part.elements.vertices.size());
  for (std::size_t v = 0; v < part.row_of_vertex.size(); ++v)
    if (const Index row = part.row_of_vertex[v]; row >= 0)
      part.elements.motions[v] = {point_at(step.start, row), point_at(step.end, row)};
}

std::vector<Message> lent_motions(const InputPart& part) {
  std::vector<Message> messages;
  for (const SharedVertices& shared : part.lent) {
    Packer packer;
    for (const std::size_t v : shared.places) packer.put(part.elements.motions[v]);
    messages.push_back({shared.rank, packer.take()});
  }
  return messages;
}

void check_given(const Motion& mine, const Motion& theirs, Index number, int home) {
  const auto check = [&](const Point& a, const Point& b, const char* what) {
    if (!are_same(a, b))
      throw InvalidStep("vertex " + std::to_string(number) + " in " + what + " is elsewhere than rank " +
                        std::to_string(home) + " has it: give it the same position everywhere");
  };
  check(mine.start, theirs.start, kStart);
  check(mine.end, theirs.end, kEnd);
}

void take_borrowed(const SharedVertices& shared, const Bytes& bytes, InputPart& part) {
  Unpacker unpacker(bytes);
  for (const std::size_t v : shared.places) {
    const auto motion = unpacker.get<Motion>();
    if (part.row_of_vertex[v] >= 0)
      check_given(part.elements.motions[v], motion, part.elements.vertices[v].number, shared.rank);
    part.elements.motions[v] = motion;
  }
}

void check_finite(const InputPart& part) {
  for (std::size_t v = 0; v < part.is_used.size(); ++v) {
    const Motion& motion = part.elements.motions[v];
    if (!part.is_used[v] || (is_finite(motion.start) && is_finite(motion.end))) continue;
    throw InvalidStep("vertex " + std::to_string(part.elements.vertices[v].number) + " in " +
                      (is_finite(motion.start) ? kEnd : kStart) +
                      " has a coordinate that is not finite: give finite positions");
  }
}

}  // namespace

void take_positions(Communicator& communicator, const Step& step, InputPart& part) {
  std::vector<Message> lent;
  together(communicator, [&] {
    read_rows(step, part);
    lent = lent_motions(part);
  });
  const std::vector<Message> messages = exchange(communicator, std::move(lent));
  together(communicator, [&] {
    // Messages and part.borrowed are both sorted by rank: every lender sends one message.
    for (std::size_t i = 0; i < messages.size(); ++i) take_borrowed(part.borrowed[i], messages[i].bytes, part);
    check_finite(part);
  });
}

}  // namespace tamis::distributed
