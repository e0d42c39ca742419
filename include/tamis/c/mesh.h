/* Mesh: the topology of the moving objects, made once. */
#ifndef TAMIS_C_MESH_H
#define TAMIS_C_MESH_H
#include "tamis/c/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The topology of the moving objects. */
typedef struct tamis_mesh tamis_mesh;

/** What tamis_mesh_create makes a mesh of. */
typedef struct tamis_mesh_input {
  size_t size;                 /**< sizeof(tamis_mesh_input) */
  int32_t vertex_count;        /**< number of rows of the positions of every step, >= 0 */
  const int32_t* faces;        /**< face_count x 3 vertex indices, any winding */
  size_t face_count;           /**< may be 0 */
  const int32_t* loose_edges;  /**< loose_edge_count x 2: rods */
  size_t loose_edge_count;     /**< may be 0 */
  const int32_t* loose_points; /**< vertices of no face and no edge that still take part in contacts */
  size_t loose_point_count;    /**< may be 0 */
} tamis_mesh_input;

/** Makes a mesh.
 * Writes the handle, also if the call fails (tamis/tamis.h).
 * Returns TAMIS_INVALID_MESH if an index is outside [0, vertex_count), or if there is no feature at all. */
TAMIS_API tamis_status tamis_mesh_create(const tamis_mesh_input* input, tamis_mesh** mesh);
/** Frees the mesh. NULL: does nothing. */
TAMIS_API void tamis_mesh_free(tamis_mesh* mesh);
/** Returns the message of the last call with this mesh; "" after TAMIS_OK. */
TAMIS_API const char* tamis_mesh_message(const tamis_mesh* mesh);
/** Lists every edge of a triangle and every loose edge, once. Another library's list of the same edges need not have
 * this order: see tamis_mesh_find_edges().
 * Writes the number of edges.
 * Returns count x 2 indices, sorted; the vertices of an edge ascend. The array lives as long as the mesh. For a mesh
 * that could not be made: NULL, and count 0. */
TAMIS_API const int32_t* tamis_mesh_edges(const tamis_mesh* mesh, size_t* count);
/** Lists the vertices that take part in contacts.
 * Writes their number.
 * Returns their indices, ascending; otherwise as tamis_mesh_edges. */
TAMIS_API const int32_t* tamis_mesh_points(const tamis_mesh* mesh, size_t* count);
/** Finds both features of a contact or a near pair. For callers who keep data by feature.
 * Writes for a face its place among the faces that the mesh was made with, for an edge its place in tamis_mesh_edges(),
 * for a vertex its index.
 * Returns TAMIS_INVALID_ARGUMENT if there is no such kind. Returns TAMIS_INVALID_MESH if the mesh has no such vertex,
 * edge or face. A face with its vertices in another order is not found. */
TAMIS_API tamis_status tamis_mesh_features_of(tamis_mesh* mesh, int32_t kind, const int32_t* vertices, int32_t* first,
                                              int32_t* second);
/** Finds edges by their vertices: `edges` is count x 2, in either order. For data that follows another list of the same
 * edges.
 * Writes for each its place in tamis_mesh_edges(), or -1 if the mesh has no such edge. */
TAMIS_API tamis_status tamis_mesh_find_edges(tamis_mesh* mesh, const int32_t* edges, size_t count, int32_t* places);
/** Finds faces by their vertices: `faces` is count x 3, in the mesh's order.
 * Writes for each its place among the faces that the mesh was made with, or -1. */
TAMIS_API tamis_status tamis_mesh_find_faces(tamis_mesh* mesh, const int32_t* faces, size_t count, int32_t* places);

#ifdef __cplusplus
}
#endif
#endif
