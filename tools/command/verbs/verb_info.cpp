// tamis info: what a mesh is.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "command/command_line/arguments.hpp"
#include "command/command_line/verb.hpp"
#include "command/report.hpp"
#include "command/step_files.hpp"
#include "command/verbs/mesh_facts.hpp"
#include "files/mesh/mesh_formats.hpp"

namespace tamis::cli {
namespace {

class Info final : public Verb {
 public:
  const char* name() const override { return "info"; }
  const char* summary() const override { return "Facts about a mesh: counts, edges, degenerate faces, components"; }
  const char* examples() const override {
    return "  tamis info cloth.ply\n"
           "  tamis info cloth.obj --json";
  }
  void declare(OptionList& options) override {
    options.add_path("MESH", path_, io::mesh_format_names()).required();
    weld_.declare(options);
    declare_json(options, json_);
  }

  int run() override {
    io::MeshFile file = read_with_notes(path_);
    weld(file, {}, weld_.distance());
    const std::vector<std::string> notes = file.notes;
    const std::vector<Point> positions = file.positions;
    const Mesh mesh = io::mesh_of(std::move(file));
    const MeshFacts facts = facts_of(mesh, positions);
    if (json_)
      print_json(json_of_facts(mesh, facts, notes));
    else
      print(mesh, facts);
    return kSuccess;
  }

 private:
  static Json json_of_facts(const Mesh& mesh, const MeshFacts& facts, const std::vector<std::string>& notes) {
    return {{"vertices", mesh.vertex_count()},
            {"triangles", mesh.faces().size()},
            {"edges", mesh.edges().size()},
            {"loose_edges", facts.rods},
            {"loose_points", facts.loose_points},
            {"boundary_edges", facts.boundary_edges},
            {"non_manifold_edges", facts.non_manifold_edges},
            {"unused_vertices", facts.unused_vertices},
            {"not_finite_vertices", facts.not_finite_vertices},
            {"coincident_vertices", facts.coincident_vertices},
            {"degenerate_faces", facts.degenerate_faces},
            {"duplicate_faces", facts.duplicate_faces},
            {"flat_folds", facts.flat_folds},
            {"components", facts.components},
            {"bounds", {{"lowest", facts.box.lowest}, {"highest", facts.box.highest}}},
            {"notes", notes}};
  }

  static void print_count(const char* what, std::size_t count, const char* remark) {
    fmt::print("{:<19} {:>11}{}{}\n", what, grouped(count), *remark ? "   " : "", remark);
  }

  static void print(const Mesh& mesh, const MeshFacts& f) {
    print_count("vertices", static_cast<std::size_t>(mesh.vertex_count()), "");
    print_count("  loose", f.loose_points, f.loose_points ? "of no triangle and no edge: particles" : "");
    print_count("  unused", f.unused_vertices, f.unused_vertices ? "they take no part in contacts" : "");
    if (f.not_finite_vertices > 0) print_count("  not finite", f.not_finite_vertices, "unused, too");
    print_count("  coincident", f.coincident_vertices,
                f.coincident_vertices ? "each lies exactly on another one: --weld joins them" : "");
    print_count("triangles", mesh.faces().size(), "");
    print_count("  degenerate", f.degenerate_faces, f.degenerate_faces ? "of area exactly zero; legal" : "");
    print_count("  duplicate", f.duplicate_faces, f.duplicate_faces ? "the vertices of another triangle; legal" : "");
    print_count("edges", mesh.edges().size(), "");
    print_count("  boundary", f.boundary_edges, f.boundary_edges ? "of one triangle: the surface is open" : "");
    print_count("  non-manifold", f.non_manifold_edges,
                f.non_manifold_edges ? "of three triangles or more; legal" : "");
    print_count("  loose", f.rods, f.rods ? "of no triangle: rods" : "");
    print_count("  flat folds", f.flat_folds,
                f.flat_folds ? "two triangles of the edge lie on each other; no intersection" : "");
    print_count("components", f.components, "");
    fmt::print("{:<19} {}\n", "box", text_of(f.box));
  }

  std::filesystem::path path_;
  WeldArgument weld_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_info() { return std::make_unique<Info>(); }

}  // namespace tamis::cli
