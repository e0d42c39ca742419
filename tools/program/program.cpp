// The program of the site's first page, as its worker calls it: two files in memory make a step, which is queried at
// any length. Every function that may fail returns a sentence; an empty one means success.
#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <new>
#include <optional>

#include "files/error.hpp"
#include "files/mesh/mesh_file.hpp"
#include "files/output/json.hpp"
#include "files/scale_step.hpp"
#include "files/tally.hpp"
#include "files/view/quantised.hpp"
#include "files/view/scene_bytes.hpp"
#include "tamis/detector.hpp"

namespace tamis::program {
namespace {

/// The step that is open.
struct Opened {
  std::vector<std::string> names;
  std::vector<Point> start, end;
  std::vector<std::string> notes;
  Detector detector;
};

std::optional<Opened> opened;
std::string problem, facts, scene;

/// Runs a function; returns what it refuses, as a sentence.
template <class Function>
const char* sentence_of(const Function& function) {
  problem.clear();
  try {
    function();
  } catch (const std::bad_alloc&) {
    opened.reset();
    problem = "the browser gives no more memory: take a smaller mesh, or the command tamis, which has no such limit";
  } catch (const std::exception& error) {
    problem = error.what();
  }
  return problem.c_str();
}

void open(const std::string& start_name, std::string_view start, const std::string& end_name, std::string_view end) {
  opened.reset();
  io::MeshFile first = io::mesh_in(start, start_name);
  io::MeshFile second = io::mesh_in(end, end_name);
  io::require_same_mesh(first, start_name, second, end_name);
  std::vector<std::string> notes = first.notes;
  std::vector<Point> positions = first.positions;
  opened.emplace(Opened{{start_name, end_name},
                        std::move(positions),
                        std::move(second.positions),
                        std::move(notes),
                        Detector(io::mesh_of(std::move(first)))});
}

/// All contacts of the step, or the first one, for the viewer.
io::RecordedStep found_in(const Step& step, bool all) {
  io::RecordedStep found;
  if (all) {
    const auto contacts = opened->detector.contacts(step);
    found.contacts.assign(contacts.begin(), contacts.end());
  } else {
    const EarliestContact first = opened->detector.earliest(step);
    if (first.contact) {
      found.contacts.push_back(*first.contact);
      found.free_before = first.toi_lower;
    }
  }
  found.stages = opened->detector.statistics().stages;
  return found;
}

io::Json facts_of(const io::RecordedStep& found) {
  const Mesh& mesh = opened->detector.mesh();
  const io::Tally tally = io::tally_of(found.contacts);
  return {{"vertices", mesh.vertex_count()},
          {"triangles", mesh.faces().size()},
          {"contacts", tally.contacts()},
          {"seconds", opened->detector.statistics().seconds.total},
          {"first", found.free_before.value_or(tally.toi_lower)},
          {"notes", opened->notes}};
}

/// Leaves `facts` and `scene`.
void ask(double length, bool all) {
  if (!opened) throw Error("no step is open: choose one, or drop two files");
  std::vector<Point> end = opened->end;
  io::scale_step(opened->start, end, length);
  io::Recording recording{opened->detector.mesh(), opened->detector.options(),   length,
                          opened->names,           {opened->start, opened->end}, {found_in({opened->start, end}, all)}};
  const std::string_view why_not = io::why_not_quantised(recording);
  if (!why_not.empty()) throw Error(std::string(why_not));
  scene = io::scene_bytes(recording);
  facts = facts_of(recording.steps.front()).dump(-1, ' ', true, io::Json::error_handler_t::replace);
}

}  // namespace
}  // namespace tamis::program

/// Memory for a text or the bytes of a file; null if there is not as much. program_open frees all four.
extern "C" char* program_room(std::size_t bytes) { return new (std::nothrow) char[bytes]; }

/// Opens two files of one mesh.
extern "C" const char* program_open(char* start_name, char* start, std::size_t start_bytes, char* end_name, char* end,
                                    std::size_t end_bytes) {
  const std::unique_ptr<char[]> held[]{std::unique_ptr<char[]>(start_name), std::unique_ptr<char[]>(start),
                                       std::unique_ptr<char[]>(end_name), std::unique_ptr<char[]>(end)};
  return tamis::program::sentence_of([&] {
    tamis::program::open(start_name, {start, start_bytes}, end_name, {end, end_bytes});
  });
}

/// Queries start + length (end - start): for all contacts, or for the first.
extern "C" const char* program_ask(double length, int all) {
  return tamis::program::sentence_of([&] { tamis::program::ask(length, all != 0); });
}

/// What program_ask has found, as JSON.
extern "C" const char* program_facts() { return tamis::program::facts.c_str(); }

/// What program_ask has found, as the viewer reads it.
extern "C" const char* program_scene() { return tamis::program::scene.data(); }
extern "C" std::size_t program_scene_bytes() { return tamis::program::scene.size(); }
