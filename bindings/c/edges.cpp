// Linkages, and questions to a world about edges between their configurations.
#include "c/motions.hpp"
#include "c/world.hpp"
#include "tamis/linkage.hpp"

struct tamis_linkage : tamis::c::Handle<std::optional<tamis::Linkage>> {};

namespace tamis::c {
namespace {

Joint joint_of(const tamis_joint& given) {
  if (given.joint_kind < TAMIS_FIXED || given.joint_kind > TAMIS_SLIDING)
    throw InvalidOptions("joint_kind is " + std::to_string(given.joint_kind) +
                         ": give TAMIS_FIXED, TAMIS_TURNING or TAMIS_SLIDING");
  return {given.parent,         pose_of(given.place), static_cast<JointKind>(given.joint_kind),
          point_of(given.axis), given.coordinate,     given.factor,
          given.offset};
}

/// What questions about edges have in common.
struct EdgeQuestion {
  World& world;
  const Linkage& linkage;
  EdgeOptions options;

  std::span<const double> configurations(const double* first, std::size_t count, const char* name) const {
    const std::size_t numbers = product(count, linkage.dimension(), "count");
    return {array(first, numbers, name), numbers};
  }
};

template <class Work>
tamis_status ask(tamis_world* handle, const tamis_linkage* linkage, const tamis_path_options* given,
                 int starts_are_free, const Work& work) noexcept {
  return with(handle, [&](tamis_world& h) {
    h.contacts.clear();
    const tamis_path_options options = read_options(given);
    if (options.at_start != TAMIS_REPORT)
      throw InvalidOptions("at_start is " + std::to_string(options.at_start) +
                           ": questions about edges report what touches at the start, leave it 0");
    const PathOptions read = path_options_of(options);
    work(EdgeQuestion{*h.object,
                      made<InvalidOptions>(linkage, "linkage"),
                      {read.min_separation, read.tolerance, starts_are_free != 0}});
  });
}

tamis_edge_answer edge_answer_of(const EdgeAnswer& answer) {
  tamis_edge_answer written{};
  written.fraction = answer.fraction;
  written.fraction_upper = answer.fraction_upper;
  written.overlaps_at_start = answer.overlaps_at_start ? 1 : 0;
  written.has_contact = answer.contact ? 1 : 0;
  std::ranges::copy(answer.bodies, written.bodies);
  std::ranges::copy(answer.point, written.point);
  if (answer.contact) written.contact = contact_of(*answer.contact);
  return written;
}

void write_flags(const std::vector<bool>& flags, uint8_t* to) { std::ranges::copy(flags, to); }

uint8_t* room(uint8_t* flags, std::size_t count, const char* name) {
  return count > 0 ? &required(flags, name) : flags;
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_linkage_create(const tamis_joint* joints, size_t joint_count, const tamis_carried_body* carried,
                                  size_t carried_count, tamis_linkage** linkage) {
  return make_handle(linkage, [&](tamis_linkage& handle) {
    check_count(joint_count, "joint_count");
    check_count(carried_count, "carried_count");
    std::vector<tamis::Joint> read;
    for (const tamis_joint& given : std::span(array(joints, joint_count, "joints"), joint_count))
      read.push_back(joint_of(given));
    std::vector<tamis::CarriedBody> bodies;
    for (const tamis_carried_body& given : std::span(array(carried, carried_count, "carried"), carried_count))
      bodies.push_back({given.body, given.joint, pose_of(given.place)});
    handle.object.emplace(std::move(read), std::move(bodies));
  });
}

void tamis_linkage_free(tamis_linkage* linkage) { delete linkage; }

const char* tamis_linkage_message(const tamis_linkage* linkage) { return message_of(linkage); }

size_t tamis_linkage_dimension(const tamis_linkage* linkage) {
  return linkage && linkage->object ? linkage->object->dimension() : 0;
}

tamis_status tamis_world_configurations_are_free(tamis_world* world, const tamis_linkage* linkage,
                                                 const double* configurations, size_t count,
                                                 const tamis_path_options* options, uint8_t* are_free) {
  return ask(world, linkage, options, 0, [&](const EdgeQuestion& q) {
    const auto given = q.configurations(configurations, count, "configurations");
    uint8_t* to = room(are_free, count, "are_free");
    write_flags(q.world.configurations_are_free(q.linkage, given, q.options), to);
  });
}

tamis_status tamis_world_edges_are_free(tamis_world* world, const tamis_linkage* linkage, const double* starts,
                                        const double* ends, size_t count, int starts_are_free,
                                        const tamis_path_options* options, uint8_t* are_free) {
  return ask(world, linkage, options, starts_are_free, [&](const EdgeQuestion& q) {
    const auto from = q.configurations(starts, count, "starts"), to = q.configurations(ends, count, "ends");
    uint8_t* flags = room(are_free, count, "are_free");
    write_flags(q.world.edges_are_free(q.linkage, from, to, q.options), flags);
  });
}

tamis_status tamis_world_last_valid(tamis_world* world, const tamis_linkage* linkage, const double* starts,
                                    const double* ends, size_t count, int starts_are_free,
                                    const tamis_path_options* options, tamis_edge_answer* answers, size_t answer_size) {
  return ask(world, linkage, options, starts_are_free, [&](const EdgeQuestion& q) {
    const auto from = q.configurations(starts, count, "starts"), to = q.configurations(ends, count, "ends");
    check_size(answer_size, sizeof(int32_t), "answer");
    if (count > 0) required(answers, "answers");
    const auto found = q.world.last_valid(q.linkage, from, to, q.options);
    for (std::size_t i = 0; i < found.size(); ++i) write_element(edge_answer_of(found[i]), answers, i, answer_size);
  });
}

tamis_status tamis_world_first_bad_edge(tamis_world* world, const tamis_linkage* linkage, const double* waypoints,
                                        size_t waypoint_count, int starts_are_free, const tamis_path_options* options,
                                        size_t* edge, tamis_edge_answer* answers, size_t answer_size) {
  return ask(world, linkage, options, starts_are_free, [&](const EdgeQuestion& q) {
    const auto given = q.configurations(waypoints, waypoint_count, "waypoints");
    check_size(answer_size, sizeof(int32_t), "answer");
    required(edge, "edge");
    required(answers, "answers");
    const tamis::FirstBadEdge found = q.world.first_bad_edge(q.linkage, given, q.options);
    *edge = found.edge.value_or(waypoint_count - 1);
    write_element(edge_answer_of(found.answer), answers, 0, answer_size);
  });
}

tamis_status tamis_world_roadmap(tamis_world* world, const tamis_linkage* linkage, const double* configurations,
                                 size_t count, const int32_t* edge_ends, size_t edge_count,
                                 const tamis_path_options* options, uint8_t* configurations_are_free,
                                 uint8_t* edges_are_free) {
  return ask(world, linkage, options, 0, [&](const EdgeQuestion& q) {
    const auto given = q.configurations(configurations, count, "configurations");
    const int32_t* pairs = array(edge_ends, product(edge_count, 2, "edge_count"), "edge_ends");
    uint8_t* to = room(configurations_are_free, count, "configurations_are_free");
    uint8_t* to_edges = room(edges_are_free, edge_count, "edges_are_free");
    const auto* first = reinterpret_cast<const std::array<tamis::Index, 2>*>(pairs);
    const tamis::FreeRoadmap found = q.world.roadmap(q.linkage, given, {first, edge_count}, q.options);
    write_flags(found.configurations, to);
    write_flags(found.edges, to_edges);
  });
}
